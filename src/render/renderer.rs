//! What lives on the GPU: pipelines, layers, and a target for each picture.

use super::buffers::{self, Buffers, Part};
use super::camera::View;
use super::draw::{self, Call, Kind, Uniform};
use super::layer::{Data, Layer};
use super::mark;
use super::pipelines::{self, DEPTH, FORMAT, Pipelines};
use super::steps::{self, Cursor};
use eframe::egui::{Color32, Id};
use eframe::wgpu::{self, util::DeviceExt};
use std::collections::HashMap;
use std::mem::size_of;
use std::ops::Range;

/// Room for a uniform: the largest alignment a device may ask for.
const STRIDE: u64 = 256;

/// How much work was done so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Pictures drawn to their end; one shown again unchanged does not count.
    pub frames: u64,
    /// Bytes sent to the GPU.
    pub uploaded_bytes: u64,
    /// Whether what was shown last was coarse, see [`super::paint_in_steps`].
    pub is_coarse: bool,
}

/// Everything a picture depends on.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    pub view: View,
    pub slice: [f64; 4],
    pub layers: Vec<Layer>,
    pub background: Color32,
    pub size: [u32; 2],
    pub pixels_per_point: f32,
}

impl Frame {
    fn calls(&self) -> Vec<Call> {
        draw::calls(&self.view, self.slice, &self.layers, self.size, self.pixels_per_point)
    }
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
    layers: HashMap<u64, Buffers>,
    targets: HashMap<Id, Target>,
    /// Pictures that are drawn in steps: what was asked for last, and the target that
    /// shows it.
    in_steps: HashMap<Id, (Frame, Id)>,
}

#[derive(Debug)]
struct Target {
    frame: Frame,
    /// Where drawing goes on; `None` once all is drawn.
    next: Option<Cursor>,
    colour: wgpu::Texture,
    samples: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
    blit: wgpu::BindGroup,
}

impl Renderer {
    /// Renderer with 1 or 4 samples a pixel that shows pictures on `format`.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, samples: u32) -> Self {
        Self {
            stats: Stats::default(),
            most_bytes: device.limits().max_buffer_size,
            samples,
            pipelines: Pipelines::new(device, samples),
            blit: pipelines::blit(device, format),
            layers: HashMap::new(),
            targets: HashMap::new(),
            in_steps: HashMap::new(),
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
        self.advance(device, encoder, id, frame, u64::MAX);
    }

    /// Draws the picture `id` unless it is there already. If `whole` takes more than
    /// `most_vertices`, `coarse` is drawn as long as it changes from call to call; once
    /// it does not, `whole` is drawn, `of_a_step` vertices in each call, and shown when
    /// it is finished. Returns whether it is.
    pub fn prepare_in_steps(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        id: Id,
        [coarse, whole]: [&Frame; 2],
        [most_vertices, of_a_step]: [u64; 2],
    ) -> bool {
        let of_whole = id.with("whole");
        let is_little =
            coarse.layers == whole.layers || draw::n_vertices(&whole.calls()) <= most_vertices;
        let rests = self.in_steps.get(&id).is_some_and(|(asked, _)| asked == whole);
        let is_finished = if is_little {
            self.targets.remove(&id);
            self.advance(device, encoder, of_whole, whole, u64::MAX)
        } else if rests || self.is_there(of_whole, whole) {
            self.advance(device, encoder, of_whole, whole, of_a_step)
        } else {
            false
        };
        if !is_finished {
            self.advance(device, encoder, id, coarse, u64::MAX);
        }
        let shown = if is_finished { of_whole } else { id };
        self.in_steps.insert(id, (whole.clone(), shown));
        self.stats.is_coarse = !is_finished;
        is_finished
    }

    /// Copies the picture `id` into a running pass.
    pub fn show(&self, pass: &mut wgpu::RenderPass<'static>, id: Id) {
        let id = self.in_steps.get(&id).map_or(id, |(_, shown)| *shown);
        let Some(target) = self.targets.get(&id) else { return };
        pass.set_pipeline(&self.blit);
        pass.set_bind_group(0, &target.blit, &[]);
        pass.draw(0..3, 0..1);
    }

    /// The picture `id` as drawn.
    pub fn texture(&self, id: Id) -> Option<&wgpu::Texture> {
        self.targets.get(&id).map(|target| &target.colour)
    }

    /// Whether the picture `id` is `frame`, drawn to its end.
    fn is_there(&self, id: Id, frame: &Frame) -> bool {
        let target = self.targets.get(&id);
        target.is_some_and(|target| target.next.is_none() && target.frame == *frame)
    }

    /// Draws at most so many vertices more of the picture `id`. Returns whether it is
    /// finished.
    fn advance(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        id: Id,
        frame: &Frame,
        most_vertices: u64,
    ) -> bool {
        let cursor = match self.targets.get_mut(&id) {
            Some(target) if target.frame == *frame => match target.next {
                Some(next) => next,
                None => return true,
            },
            Some(target) if target.frame.size == frame.size => {
                target.frame = frame.clone();
                Cursor::default()
            }
            Some(_) | None => {
                let target = self.target(device, frame);
                self.targets.insert(id, target);
                Cursor::default()
            }
        };
        self.forget_unused_layers();
        self.upload(device, frame);
        let next = self.draw(device, encoder, id, frame, cursor, most_vertices);
        if let Some(target) = self.targets.get_mut(&id) {
            target.next = next;
        }
        self.stats.frames += u64::from(next.is_none());
        next.is_none()
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
        let next = Some(Cursor::default());
        Target { frame: frame.clone(), next, colour, samples, depth, blit }
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
            if !self.layers.contains_key(&layer.id()) {
                let buffers = Buffers::of(device, layer.data(), self.most_bytes);
                self.stats.uploaded_bytes += buffers.n_bytes;
                self.layers.insert(layer.id(), buffers);
            }
        }
    }

    /// Draws from `cursor` on; returns where to go on.
    fn draw(
        &mut self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        id: Id,
        frame: &Frame,
        cursor: Cursor,
        most_vertices: u64,
    ) -> Option<Cursor> {
        let calls = frame.calls();
        let (shares, next) = steps::share(&calls, cursor, most_vertices);
        let uniforms = self.uniforms(device, &calls);
        let marks: Vec<_> =
            shares.iter().map(|&(number, _)| self.marks(device, frame, &calls[number])).collect();

        let target = &self.targets[&id];
        let colour = target.colour.create_view(&Default::default());
        let (view, resolve_target) = match &target.samples {
            Some(samples) => (samples, Some(&colour)),
            None => (&colour, None),
        };
        let is_start = cursor.is_start();
        let [r, g, b, a] = frame.background.to_array().map(|byte| f64::from(byte) / 255.0);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: match is_start {
                        true => wgpu::LoadOp::Clear(wgpu::Color { r, g, b, a }),
                        false => wgpu::LoadOp::Load,
                    },
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &target.depth,
                depth_ops: Some(wgpu::Operations {
                    load: match is_start {
                        true => wgpu::LoadOp::Clear(1.0),
                        false => wgpu::LoadOp::Load,
                    },
                    store: match next {
                        Some(_) => wgpu::StoreOp::Store,
                        None => wgpu::StoreOp::Discard,
                    },
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        for ((number, instances), marks) in shares.iter().zip(&marks) {
            let call = &calls[*number];
            let buffers = &self.layers[&frame.layers[call.layer].id()];
            pass.set_pipeline(self.pipelines.of(call.kind));
            pass.set_bind_group(0, &uniforms, &[(*number as u64 * STRIDE) as u32]);
            let mut draw = |slots: [Option<&wgpu::Buffer>; 2], vertices, instances| {
                for (slot, buffer) in (0..).zip(slots.into_iter().flatten()) {
                    pass.set_vertex_buffer(slot, buffer.slice(..));
                }
                pass.draw(vertices, instances);
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
                        draw([Some(buffer), None], 0..call.vertices(), 0..*n);
                    }
                    continue;
                }
            };
            for (index, Part { buffer, range }) in parts.iter().enumerate() {
                let begin = instances.start.max(range.start);
                let end = instances.end.min(range.end);
                if begin >= end {
                    continue;
                }
                let items: Range<u32> = begin - range.start..end - range.start;
                let vertices = call.vertices();
                match call.kind {
                    Kind::Triangles => {
                        let corners = vertices * items.start..vertices * items.end;
                        draw([Some(buffer), None], corners, 0..1);
                    }
                    Kind::Cells => {
                        let colours = buffers.second.get(index).map(|part| &part.buffer);
                        draw([Some(buffer), colours], 0..vertices, items);
                    }
                    Kind::OpaqueFaces
                    | Kind::ClearFaces
                    | Kind::Edges
                    | Kind::Points
                    | Kind::Spheres => draw([Some(buffer), None], 0..vertices, items),
                    Kind::Marks => {}
                }
            }
        }
        next
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
        let (View::Space(space), Data::Marks(marks)) =
            (&frame.view, frame.layers[call.layer].data())
        else {
            return None;
        };
        let items = mark::sorted(marks, space, frame.pixels_per_point);
        let bytes: &[u8] = bytemuck::cast_slice(&items);
        self.stats.uploaded_bytes += bytes.len() as u64;
        (!items.is_empty()).then(|| (buffers::vertices(device, bytes), items.len() as u32))
    }
}
