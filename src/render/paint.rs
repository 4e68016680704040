//! Pictures in the window.

use super::renderer::{Frame, Renderer, Stats};
use super::{Layer, View};
use eframe::egui::emath::GuiRounding as _;
use eframe::egui::{Color32, Id, PaintCallbackInfo, Rect, Ui};
use eframe::egui_wgpu::{self, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};
use eframe::wgpu;

/// A view of layers on a background.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// From where the layers are seen.
    pub view: View,
    /// Nothing but marks is drawn where the dot product of this with (x, y, z, 1) is
    /// above 0; all 0 for everything. In space only.
    pub slice: [f32; 4],
    /// The layers; those for the other kind of view are left out.
    pub layers: Vec<Layer>,
    /// Colour behind everything; may be transparent.
    pub background: Color32,
}

/// Makes the window's renderer ready; without it, [`paint`] shows nothing.
/// Software renderers get one sample a pixel, GPUs four.
pub fn install(state: &RenderState) {
    let cpu = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
    let renderer = Renderer::new(&state.device, state.target_format, if cpu { 1 } else { 4 });
    state.renderer.write().callback_resources.insert(renderer);
}

/// Work done so far in the window; `None` if nothing was installed.
pub fn stats(state: &RenderState) -> Option<Stats> {
    state.renderer.read().callback_resources.get::<Renderer>().map(|renderer| renderer.stats)
}

/// Shows a picture in `rect`, in points. `id` names the place: a picture there
/// that did not change is not drawn again.
pub fn paint(ui: &Ui, rect: Rect, id: Id, picture: &Picture) {
    let pixels_per_point = ui.ctx().pixels_per_point();
    let rect = rect.round_to_pixels(pixels_per_point);
    let size = [rect.width(), rect.height()].map(|side| (side * pixels_per_point).round());
    if !size.iter().all(|&side| side >= 1.0) {
        return;
    }
    let frame = Frame {
        view: picture.view,
        slice: picture.slice,
        layers: picture.layers.clone(),
        background: picture.background,
        size: size.map(|side| side as u32),
        pixels_per_point,
    };
    let callback = egui_wgpu::Callback::new_paint_callback(rect, Callback { id, frame });
    ui.painter().add(callback);
}

struct Callback {
    id: Id,
    frame: Frame,
}

impl CallbackTrait for Callback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        _queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(renderer) = resources.get_mut::<Renderer>() {
            renderer.prepare(device, encoder, self.id, &self.frame);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(renderer) = resources.get::<Renderer>() {
            renderer.show(pass, self.id);
        }
    }
}
