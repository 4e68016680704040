//! Pictures in the window.

use super::renderer::{Frame, Renderer, Stats};
use super::{Layer, View};
use eframe::egui::emath::GuiRounding as _;
use eframe::egui::{Color32, Context, Id, PaintCallbackInfo, Rect, Ui};
use eframe::egui_wgpu::{self, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};
use eframe::wgpu;

/// A view of layers on a background.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// From where the layers are seen.
    pub view: View,
    /// Nothing but marks is drawn where the dot product of this with (x, y, z, 1) is
    /// above 0; all 0 for everything. In space only.
    pub slice: [f64; 4],
    /// The layers; those for the other kind of view are left out.
    pub layers: Vec<Layer>,
    /// Colour behind everything; may be transparent.
    pub background: Color32,
}

/// What can be drawn in a small part of a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Speed {
    /// Vertices that a frame may cost while the view moves.
    pub vertices: u32,
}

impl Speed {
    /// Of a driver that lets the processor draw: a tenth of a second is for the panels
    /// as well.
    const SOFTWARE: Self = Self { vertices: 150_000 };
    /// Of a small GPU.
    const GPU: Self = Self { vertices: 6_000_000 };

    /// Vertices that a picture which is drawn bit by bit costs in a frame.
    fn of_a_step(self, pace: Pace) -> u64 {
        let vertices = u64::from(self.vertices);
        match pace {
            Pace::Rest => 2 * vertices,
            Pace::Busy => vertices / 2,
        }
    }
}

/// Whether anybody waits for the next frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Nothing happens in the window.
    Rest,
    /// Something is moved or pointed at, or played.
    Busy,
}

/// Makes the window's renderer ready; without it, [`paint`] shows nothing.
/// Software renderers get one sample a pixel, GPUs four.
pub fn install(state: &RenderState) -> Speed {
    let cpu = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
    let renderer = Renderer::new(&state.device, state.target_format, if cpu { 1 } else { 4 });
    state.renderer.write().callback_resources.insert(renderer);
    if cpu { Speed::SOFTWARE } else { Speed::GPU }
}

/// Work done so far in the window; `None` if nothing was installed.
pub fn stats(state: &RenderState) -> Option<Stats> {
    state.renderer.read().callback_resources.get::<Renderer>().map(|renderer| renderer.stats)
}

/// Shows a picture in `rect`, in points. `id` names the place: a picture there
/// that did not change is not drawn again.
pub fn paint(ui: &Ui, rect: Rect, id: Id, picture: &Picture) {
    let (rect, frame) = framed(ui, rect, picture);
    if let Some(frame) = frame {
        add(ui, rect, Callback { id, frame, steps: None });
    }
}

/// The same for a picture that may take long: while it changes from frame to frame,
/// only a coarse one is shown, of the same view with other layers. Once it rests, it is
/// drawn bit by bit and shown when it is finished: larger bits while nobody waits.
pub fn paint_in_steps(
    ui: &Ui,
    rect: Rect,
    id: Id,
    [coarse, whole]: [&Picture; 2],
    (speed, pace): (Speed, Pace),
) {
    let (rect, frame) = framed(ui, rect, whole);
    if let (Some(frame), (_, Some(coarse))) = (frame, framed(ui, rect, coarse)) {
        let steps = Steps { coarse, speed, pace, context: ui.ctx().clone() };
        add(ui, rect, Callback { id, frame, steps: Some(steps) });
    }
}

/// The pixels of a place, and what is seen there, if it has any.
fn framed(ui: &Ui, rect: Rect, picture: &Picture) -> (Rect, Option<Frame>) {
    let pixels_per_point = ui.ctx().pixels_per_point();
    let rect = rect.round_to_pixels(pixels_per_point);
    let size = [rect.width(), rect.height()].map(|side| (side * pixels_per_point).round());
    let is_seen = size.iter().all(|&side| side >= 1.0);
    let frame = is_seen.then(|| Frame {
        view: picture.view,
        slice: picture.slice,
        layers: picture.layers.clone(),
        background: picture.background,
        size: size.map(|side| side as u32),
        pixels_per_point,
    });
    (rect, frame)
}

fn add(ui: &Ui, rect: Rect, callback: Callback) {
    ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, callback));
}

struct Callback {
    id: Id,
    frame: Frame,
    steps: Option<Steps>,
}

struct Steps {
    coarse: Frame,
    speed: Speed,
    pace: Pace,
    context: Context,
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
        let Some(renderer) = resources.get_mut::<Renderer>() else { return Vec::new() };
        match &self.steps {
            None => renderer.prepare(device, encoder, self.id, &self.frame),
            Some(Steps { coarse, speed, pace, context }) => {
                let both = [coarse, &self.frame];
                let most = [u64::from(speed.vertices), speed.of_a_step(*pace)];
                if !renderer.prepare_in_steps(device, encoder, self.id, both, most) {
                    context.request_repaint();
                }
            }
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
