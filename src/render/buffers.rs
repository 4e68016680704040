//! Layers on the GPU.

use super::layer::Data;
use super::mesh;
use eframe::wgpu::{self, util::DeviceExt};
use std::mem::size_of;
use std::ops::Range;

/// Buffers of a layer: `codes` and `colours`, `faces` and `edges`, or one; each in
/// parts that the device can make. Parts of codes and of their colours match.
#[derive(Debug)]
pub(super) struct Buffers {
    pub first: Vec<Part>,
    pub second: Vec<Part>,
    /// Bytes of all.
    pub n_bytes: u64,
}

/// Some of the instances or triangles of a layer.
#[derive(Debug)]
pub(super) struct Part {
    pub buffer: wgpu::Buffer,
    /// Which of them, of all.
    pub range: Range<u32>,
}

impl Buffers {
    /// Uploads a layer in buffers of at most `most_bytes`, or of one item.
    pub fn of(device: &wgpu::Device, data: &Data, most_bytes: u64) -> Self {
        // Bytes, and bytes of an instance or triangle.
        type List<'a> = (&'a [u8], usize);
        const NONE: List<'static> = (&[], 1);
        let (first, second): (List<'_>, List<'_>) = match data {
            Data::Boxes { edges, faces, .. } => (list(&faces.packed), list(&edges.packed)),
            Data::Cells { cells, colours, .. } => (list(&cells.packed), list(colours)),
            Data::Points { points, .. } => (list(points), NONE),
            Data::Triangles { corners, .. } => ((bytemuck::cast_slice(corners), TRIANGLE), NONE),
            Data::Spheres { spheres, .. } => (list(spheres), NONE),
            // Sorted anew for every view.
            Data::Marks(_) => (NONE, NONE),
        };
        let largest = first.1.max(second.1) as u64;
        let most = (most_bytes / largest).max(1) as usize;
        let parts = |list| parts(device, list, most);
        let n_bytes = (first.0.len() + second.0.len()) as u64;
        Self { first: parts(first), second: parts(second), n_bytes }
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

/// A buffer of vertices or instances.
pub(super) fn vertices(device: &wgpu::Device, contents: &[u8]) -> wgpu::Buffer {
    device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("vertices"),
        contents,
        usage: wgpu::BufferUsages::VERTEX,
    })
}
