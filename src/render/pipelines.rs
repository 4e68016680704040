//! Shaders and how they are run.

use super::draw::{Kind, Uniform};
use super::mark::Item;
use eframe::wgpu;
use std::mem::size_of;

/// Format of the pictures: gamma-encoded, premultiplied.
pub(super) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Format of the depth buffers.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

const DRAW: &str = include_str!("draw.wgsl");
const BLIT: &str = include_str!("blit.wgsl");

/// All pipelines for one number of samples a pixel.
#[derive(Debug)]
pub(super) struct Pipelines {
    pub layout: wgpu::BindGroupLayout,
    by_kind: [wgpu::RenderPipeline; 8],
}

const KINDS: [Kind; 8] = [
    Kind::Cells,
    Kind::OpaqueFaces,
    Kind::ClearFaces,
    Kind::Edges,
    Kind::Points,
    Kind::Triangles,
    Kind::Spheres,
    Kind::Marks,
];

impl Pipelines {
    pub fn new(device: &wgpu::Device, samples: u32) -> Self {
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("draw"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: true,
                    min_binding_size: wgpu::BufferSize::new(size_of::<Uniform>() as u64),
                },
                count: None,
            }],
        });
        let by_kind = KINDS.map(|kind| pipeline(device, &layout, kind, samples));
        Self { layout, by_kind }
    }

    pub fn of(&self, kind: Kind) -> &wgpu::RenderPipeline {
        &self.by_kind[kind as usize]
    }
}

/// Shader source, vertex and fragment entry of a kind.
fn shader(kind: Kind) -> (&'static str, &'static str, &'static str) {
    let content = include_str!("content.wgsl");
    match kind {
        Kind::Cells => (include_str!("cells.wgsl"), "cell_vertex", "cell_fragment"),
        Kind::OpaqueFaces | Kind::ClearFaces => {
            (include_str!("faces.wgsl"), "face_vertex", "face_fragment")
        }
        Kind::Edges => (include_str!("edges.wgsl"), "edge_vertex", "edge_fragment"),
        Kind::Points => (content, "point_vertex", "point_fragment"),
        Kind::Triangles => (content, "triangle_vertex", "surface_fragment"),
        Kind::Spheres => (content, "sphere_vertex", "sphere_fragment"),
        Kind::Marks => (include_str!("marks.wgsl"), "mark_vertex", "mark_fragment"),
    }
}

fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    kind: Kind,
    samples: u32,
) -> wgpu::RenderPipeline {
    let (source, vertex, fragment) = shader(kind);
    let module = module(device, &format!("{DRAW}\n{source}"));
    let instance = wgpu::VertexStepMode::Instance;
    let code = wgpu::vertex_attr_array![0 => Uint32x2];
    let colour = wgpu::vertex_attr_array![1 => Unorm8x4];
    let point = wgpu::vertex_attr_array![0 => Float32x3];
    let corner = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
    let sphere = wgpu::vertex_attr_array![0 => Float32x4];
    let item = wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4, 3 => Uint32, 4 => Float32x3
    ];
    let buffers = match kind {
        Kind::Cells => vec![buffer(8, instance, &code), buffer(4, instance, &colour)],
        Kind::OpaqueFaces | Kind::ClearFaces | Kind::Edges => vec![buffer(8, instance, &code)],
        Kind::Points => vec![buffer(12, instance, &point)],
        Kind::Triangles => vec![buffer(24, wgpu::VertexStepMode::Vertex, &corner)],
        Kind::Spheres => vec![buffer(16, instance, &sphere)],
        Kind::Marks => vec![buffer(size_of::<Item>() as u64, instance, &item)],
    };
    let hides = match kind {
        Kind::OpaqueFaces | Kind::Points | Kind::Triangles | Kind::Spheres => true,
        Kind::Cells | Kind::ClearFaces | Kind::Edges | Kind::Marks => false,
    };
    let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("draw"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(vertex),
        layout: Some(&pipeline_layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(hides),
            depth_compare: Some(match kind {
                // The path shines through whatever lies before it.
                Kind::Marks => wgpu::CompareFunction::Always,
                Kind::Cells
                | Kind::OpaqueFaces
                | Kind::ClearFaces
                | Kind::Edges
                | Kind::Points
                | Kind::Triangles
                | Kind::Spheres => wgpu::CompareFunction::LessEqual,
            }),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: wgpu::MultisampleState { count: samples, ..Default::default() },
        fragment: Some(target(&module, fragment, &[Some(blended(FORMAT))])),
        multiview_mask: None,
        cache: None,
    })
}

/// Copies a picture to the window's format.
pub(super) fn blit(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::RenderPipeline {
    let module = module(device, BLIT);
    let fragment = if format.is_srgb() { "blit_linear" } else { "blit_gamma" };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("blit"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("blit_vertex"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(target(&module, fragment, &[Some(blended(format))])),
        multiview_mask: None,
        cache: None,
    })
}

fn module(device: &wgpu::Device, source: &str) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(source.into()),
    })
}

fn buffer(
    array_stride: u64,
    step_mode: wgpu::VertexStepMode,
    attributes: &[wgpu::VertexAttribute],
) -> Option<wgpu::VertexBufferLayout<'_>> {
    Some(wgpu::VertexBufferLayout { array_stride, step_mode, attributes })
}

fn target<'a>(
    module: &'a wgpu::ShaderModule,
    entry_point: &'a str,
    targets: &'a [Option<wgpu::ColorTargetState>],
) -> wgpu::FragmentState<'a> {
    let entry_point = Some(entry_point);
    wgpu::FragmentState { module, entry_point, compilation_options: Default::default(), targets }
}

fn blended(format: wgpu::TextureFormat) -> wgpu::ColorTargetState {
    wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::wgpu::naga;

    fn check(source: &str) {
        let module = naga::front::wgsl::parse_str(source).expect(source);
        let flags = naga::valid::ValidationFlags::all();
        let mut validator = naga::valid::Validator::new(flags, naga::valid::Capabilities::empty());
        validator.validate(&module).unwrap_or_else(|error| panic!("{error:?}"));
    }

    #[test]
    fn all_shaders_are_valid() {
        check(BLIT);
        for kind in KINDS {
            check(&format!("{DRAW}\n{}", shader(kind).0));
        }
    }

    #[test]
    fn kinds_are_numbered_in_order() {
        assert!(KINDS.iter().enumerate().all(|(index, &kind)| kind as usize == index));
    }
}
