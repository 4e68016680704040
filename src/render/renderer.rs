//! What lives on the GPU: pipelines, layers, and a target for each picture.

use super::camera::{self, View};
use super::draw::{self, Call, Kind, Uniform};
use super::layer::{Data, Layer};
use super::pipelines::{self, DEPTH, FORMAT, Pipelines};
use super::{mark, mesh};
use eframe::egui::{Color32, Id};
use eframe::wgpu::{self, util::DeviceExt};
use std::collections::HashMap;
use std::mem::size_of;
use std::ops::Range;

/// Room for a uniform: the largest alignment a device may ask for.
const STRIDE: u64 = 256;

/// A sphere has 8 · 4³ triangles.
const SPHERE_ROUNDS: u32 = 3;

/// How much work was done so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Pictures drawn; one shown again unchanged does not count.
    pub frames: u64,
    /// Bytes sent to the GPU.
    pub uploaded_bytes: u64,
}

/// Everything a picture depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    pub view: View,
    pub slice: [f32; 4],
    pub layers: Vec<Layer>,
    pub background: Color32,
    pub size: [u32; 2],
    pub pixels_per_point: f32,
}

/// The renderer's state on one device.
#[derive(Debug)]
pub(super) struct Renderer {
    pub stats: Stats,
    /// Largest buffer that the device makes.
    pub(super) most_bytes: u64,
    samples: u32,
    pipelines: Pipelines,
    blit: wgpu::RenderPipeline,
    sphere: wgpu::Buffer,
    sphere_corners: u32,
    layers: HashMap<u64, Buffers>,
    targets: HashMap<Id, Target>,
}

/// Buffers of a layer: `codes` and `colours`, `faces` and `edges`, or one; each in
/// parts that the device can make. Parts of codes and of their colours match.
#[derive(Debug)]
struct Buffers {
    first: Vec<Part>,
    second: Vec<Part>,
}

/// Some of the instances or triangles of a layer.
#[derive(Debug)]
struct Part {
    buffer: wgpu::Buffer,
    /// Which of them, of all.
    range: Range<u32>,
}

#[derive(Debug)]
struct Target {
    frame: Frame,
    colour: wgpu::Texture,
    samples: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
    blit: wgpu::BindGroup,
}

impl Renderer {
    /// Renderer with 1 or 4 samples a pixel that shows pictures on `format`.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, samples: u32) -> Self {
        let sphere = mesh::sphere(SPHERE_ROUNDS);
        Self {
            stats: Stats::default(),
            most_bytes: device.limits().max_buffer_size,
            samples,
            pipelines: Pipelines::new(device, samples),
            blit: pipelines::blit(device, format),
            sphere_corners: sphere.len() as u32,
            sphere: vertices(device, bytemuck::cast_slice(&sphere)),
            layers: HashMap::new(),
            targets: HashMap::new(),
        }
    }

    /// Draws the picture `id` unless it is there already.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        id: Id,
        frame: &Frame,
    ) {
        if self.targets.get(&id).is_some_and(|target| target.frame == *frame) {
            return;
        }
        match self.targets.get_mut(&id) {
            Some(target) if target.frame.size == frame.size => target.frame = frame.clone(),
            Some(_) | None => {
                let target = self.target(device, frame);
                self.targets.insert(id, target);
            }
        }
        self.forget_unused_layers();
        self.upload(device, frame);
        self.draw(device, encoder, id, frame);
        self.stats.frames += 1;
    }

    /// Copies the picture `id` into a running pass.
    pub fn show(&self, pass: &mut wgpu::RenderPass<'static>, id: Id) {
        let Some(target) = self.targets.get(&id) else { return };
        pass.set_pipeline(&self.blit);
        pass.set_bind_group(0, &target.blit, &[]);
        pass.draw(0..3, 0..1);
    }

    /// The picture `id` as drawn.
    pub fn texture(&self, id: Id) -> Option<&wgpu::Texture> {
        self.targets.get(&id).map(|target| &target.colour)
    }

    fn target(&self, device: &wgpu::Device, frame: &Frame) -> Target {
        let [width, height] = frame.size;
        let texture = |format, sample_count, usage| {
            device.create_texture(&wgpu::TextureDescriptor {
                label: Some("picture"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        };
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let read = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let colour = texture(FORMAT, 1, drawn | read);
        let view = |texture: wgpu::Texture| texture.create_view(&Default::default());
        let samples = (self.samples > 1).then(|| view(texture(FORMAT, self.samples, drawn)));
        let blit = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("blit"),
            layout: &self.blit.get_bind_group_layout(0),
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&view(colour.clone())),
            }],
        });
        let depth = view(texture(DEPTH, self.samples, drawn));
        Target { frame: frame.clone(), colour, samples, depth, blit }
    }

    fn forget_unused_layers(&mut self) {
        let targets = &self.targets;
        let used = |id| {
            targets.values().any(|target| target.frame.layers.iter().any(|layer| layer.id() == id))
        };
        self.layers.retain(|&id, _| used(id));
    }

    fn upload(&mut self, device: &wgpu::Device, frame: &Frame) {
        for layer in &frame.layers {
            if self.layers.contains_key(&layer.id()) {
                continue;
            }
            // Bytes, and bytes of an instance or triangle.
            type List<'a> = (&'a [u8], usize);
            const NONE: List<'static> = (&[], 1);
            let (first, second): (List<'_>, List<'_>) = match layer.data() {
                Data::Boxes { edges, faces, .. } => (list(&faces.packed), list(&edges.packed)),
                Data::Cells { cells, colours, .. } => (list(&cells.packed), list(colours)),
                Data::Points { points, .. } => (list(points), NONE),
                Data::Triangles { corners, .. } => {
                    ((bytemuck::cast_slice(corners), TRIANGLE), NONE)
                }
                Data::Spheres { spheres, .. } => (list(spheres), NONE),
                // Sorted anew for every view.
                Data::Marks(_) => (NONE, NONE),
            };
            self.stats.uploaded_bytes += (first.0.len() + second.0.len()) as u64;
            let largest = first.1.max(second.1) as u64;
            let most = (self.most_bytes / largest).max(1) as usize;
            let parts = |list| parts(device, list, most);
            let buffers = Buffers { first: parts(first), second: parts(second) };
            self.layers.insert(layer.id(), buffers);
        }
    }

    fn draw(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        id: Id,
        frame: &Frame,
    ) {
        let calls = draw::calls(
            &frame.view,
            frame.slice,
            &frame.layers,
            frame.size,
            frame.pixels_per_point,
        );
        let uniforms = self.uniforms(device, &calls);
        let marks: Vec<_> = calls.iter().map(|call| self.marks(device, frame, call)).collect();

        let target = &self.targets[&id];
        let colour = target.colour.create_view(&Default::default());
        let (view, resolve_target) = match &target.samples {
            Some(samples) => (samples, Some(&colour)),
            None => (&colour, None),
        };
        let [r, g, b, a] = frame.background.to_array().map(|byte| f64::from(byte) / 255.0);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &target.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        for (number, (call, marks)) in calls.iter().zip(&marks).enumerate() {
            let buffers = &self.layers[&frame.layers[call.layer].id()];
            pass.set_pipeline(self.pipelines.of(call.kind));
            pass.set_bind_group(0, &uniforms, &[(number as u64 * STRIDE) as u32]);
            let mut draw = |slots: [Option<&wgpu::Buffer>; 2], n_vertices, instances| {
                for (slot, buffer) in (0..).zip(slots.into_iter().flatten()) {
                    pass.set_vertex_buffer(slot, buffer.slice(..));
                }
                pass.draw(0..n_vertices, instances);
            };
            let parts = match call.kind {
                Kind::Edges => &buffers.second,
                Kind::Cells
                | Kind::OpaqueFaces
                | Kind::ClearFaces
                | Kind::Points
                | Kind::Triangles
                | Kind::Spheres => &buffers.first,
                Kind::Marks => {
                    if let Some((buffer, n)) = marks {
                        draw([Some(buffer), None], 6, 0..*n);
                    }
                    continue;
                }
            };
            for (index, Part { buffer, range }) in parts.iter().enumerate() {
                let begin = call.instances.start.max(range.start);
                let end = call.instances.end.min(range.end);
                if begin >= end && call.kind != Kind::Triangles {
                    continue;
                }
                let instances = begin - range.start..end.saturating_sub(range.start);
                match call.kind {
                    // All of them, which are vertices.
                    Kind::Triangles => draw([Some(buffer), None], 3 * range.len() as u32, 0..1),
                    Kind::Cells => {
                        let colours = buffers.second.get(index).map(|part| &part.buffer);
                        draw([Some(buffer), colours], 6, instances);
                    }
                    Kind::OpaqueFaces | Kind::ClearFaces => {
                        draw([Some(buffer), None], 18, instances);
                    }
                    Kind::Edges | Kind::Points => draw([Some(buffer), None], 6, instances),
                    Kind::Spheres => {
                        draw([Some(&self.sphere), Some(buffer)], self.sphere_corners, instances);
                    }
                    Kind::Marks => {}
                }
            }
        }
    }

    fn uniforms(&mut self, device: &wgpu::Device, calls: &[Call]) -> wgpu::BindGroup {
        let mut bytes = vec![0; calls.len().max(1) * STRIDE as usize];
        for (room, call) in bytes.chunks_exact_mut(STRIDE as usize).zip(calls) {
            room[..size_of::<Uniform>()].copy_from_slice(bytemuck::bytes_of(&call.uniform));
        }
        self.stats.uploaded_bytes += bytes.len() as u64;
        let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("uniforms"),
            contents: &bytes,
            usage: wgpu::BufferUsages::UNIFORM,
        });
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("uniforms"),
            layout: &self.pipelines.layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer: &buffer,
                    offset: 0,
                    size: wgpu::BufferSize::new(size_of::<Uniform>() as u64),
                }),
            }],
        })
    }

    /// Sorted instances of a call for marks, and their number.
    fn marks(
        &mut self,
        device: &wgpu::Device,
        frame: &Frame,
        call: &Call,
    ) -> Option<(wgpu::Buffer, u32)> {
        let (View::Space(clip_from_world), Data::Marks(marks)) =
            (&frame.view, frame.layers[call.layer].data())
        else {
            return None;
        };
        let items = mark::sorted(marks, camera::eye(*clip_from_world), frame.pixels_per_point);
        let bytes: &[u8] = bytemuck::cast_slice(&items);
        self.stats.uploaded_bytes += bytes.len() as u64;
        (!items.is_empty()).then(|| (vertices(device, bytes), items.len() as u32))
    }
}

/// Bytes of a triangle's three corners.
const TRIANGLE: usize = 3 * size_of::<mesh::Corner>();

/// Bytes of `items`, and of one of them.
fn list<T: bytemuck::NoUninit>(items: &[T]) -> (&[u8], usize) {
    (bytemuck::cast_slice(items), size_of::<T>())
}

/// Buffers of a list, at most `most` of its items in each.
fn parts(device: &wgpu::Device, (bytes, item): (&[u8], usize), most: usize) -> Vec<Part> {
    let mut start = 0;
    let mut part = |bytes: &[u8]| {
        let range = start..start + (bytes.len() / item) as u32;
        start = range.end;
        Part { buffer: vertices(device, bytes), range }
    };
    bytes.chunks(most * item).map(&mut part).collect()
}

fn vertices(device: &wgpu::Device, contents: &[u8]) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("vertices"),
        contents,
        usage: wgpu::BufferUsages::VERTEX,
    })
}
