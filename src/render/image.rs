//! Pictures without a window.

use super::Picture;
use super::pipelines::FORMAT;
use super::renderer::{Frame, Renderer};
use eframe::egui::{Color32, ColorImage, Id};
use eframe::wgpu;
use std::sync::mpsc;
use thiserror::Error;

/// A GPU, or a driver that does its work, for pictures without a window.
#[derive(Debug)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pub(super) renderer: Renderer,
}

/// Why there is no picture.
#[derive(Debug, Error)]
pub enum ImageError {
    /// No driver that wgpu can use.
    #[error("no graphics driver was found; install one, for example mesa-vulkan-drivers")]
    NoAdapter(#[from] wgpu::RequestAdapterError),
    /// The driver gives no access.
    #[error("the graphics driver gave no device")]
    NoDevice(#[from] wgpu::RequestDeviceError),
    /// A side is 0 or larger than the device can draw.
    #[error("a picture of {0} by {1} pixels cannot be drawn; the sides may be 1 to {2}")]
    Size(u32, u32, u32),
    /// The device was lost.
    #[error("the graphics device did not finish the picture")]
    Lost,
}

impl Gpu {
    /// The first device at hand; `WGPU_BACKEND` chooses among several kinds.
    ///
    /// # Errors
    /// Fails where there is no driver.
    pub fn new() -> Result<Self, ImageError> {
        let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
        let instance = wgpu::Instance::new(descriptor);
        let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
        let (device, queue) =
            pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
                required_limits:
                    wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
                ..Default::default()
            }))?;
        let renderer = Renderer::new(&device, FORMAT, 4);
        Ok(Self { device, queue, renderer })
    }
}

/// Draws a picture of `size` pixels, four samples a pixel.
///
/// # Errors
/// Refuses sizes that the device cannot draw; fails if it is lost.
pub fn render_to_image(
    gpu: &mut Gpu,
    picture: &Picture,
    size: [u32; 2],
    pixels_per_point: f32,
) -> Result<ColorImage, ImageError> {
    let [width, height] = size;
    let largest = gpu.device.limits().max_texture_dimension_2d;
    if !size.iter().all(|side| (1..=largest).contains(side)) {
        return Err(ImageError::Size(width, height, largest));
    }
    let id = Id::unique("image");
    let frame = Frame {
        view: picture.view,
        slice: picture.slice,
        layers: picture.layers.clone(),
        background: picture.background,
        size,
        pixels_per_point,
    };
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    gpu.renderer.prepare(&gpu.device, &mut encoder, id, &frame);
    let texture = gpu.renderer.texture(id).expect("the picture was just drawn");

    // Rows in the buffer are padded.
    let row = width * 4;
    let padded = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("picture"),
        size: u64::from(padded) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(padded),
        rows_per_image: None,
    };
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
        texture.size(),
    );
    gpu.queue.submit([encoder.finish()]);

    let (sender, receiver) = mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // The receiver waits below.
        let _ = sender.send(result);
    });
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|_| ImageError::Lost)?;
    receiver.recv().map_err(|_| ImageError::Lost)?.map_err(|_| ImageError::Lost)?;
    let bytes = buffer.get_mapped_range(..).map_err(|_| ImageError::Lost)?;
    let pixels = bytes
        .chunks_exact(padded as usize)
        .flat_map(|line| line[..row as usize].chunks_exact(4))
        .map(|p| Color32::from_rgba_premultiplied(p[0], p[1], p[2], p[3]))
        .collect();
    Ok(ColorImage::new([width as usize, height as usize], pixels))
}
