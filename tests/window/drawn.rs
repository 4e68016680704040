//! The real window, drawn by the software driver and compared with its picture.

use crate::desk::Desk;
use eframe::egui_wgpu::WgpuSetup;
use eframe::wgpu::{Backends, DeviceType};
use egui_kittest::wgpu::default_wgpu_setup;
use egui_kittest::{Harness, SnapshotOptions};
use octoscope::with_document;
use octoscope_core::event::Event;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::traverse::Algorithm;
use std::io::Write;
use std::sync::OnceLock;

/// Where the playhead is.
pub enum At {
    /// Just after the n-th event of a kind, given by its Debug name.
    Nth(usize, &'static str),
    /// After this share of the events.
    Share(f64),
}

pub fn compare(name: &str, show: impl FnOnce(&mut Desk)) {
    compare_sized(name, [1280.0, 800.0], show);
}

/// Compares the window, in the state that `show` brings it to, with its picture.
pub fn compare_sized(name: &str, size: [f32; 2], show: impl FnOnce(&mut Desk)) {
    let Some(mut desk) = drawn_desk(size) else { return };
    show(&mut desk);
    // A picture at rest, with all that is made on other threads.
    desk.state_mut().draw_whole();
    desk.state_mut().finish_work();
    desk.step();
    desk.state_mut().finish_work();
    desk.step();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/screenshots");
    desk.snapshot_options(name, &SnapshotOptions::new().output_path(folder));
}

/// The window of this size, drawn by the software driver; `None` without it.
pub fn drawn_desk(size: [f32; 2]) -> Option<Desk> {
    if !has_driver() {
        return None;
    }
    let builder = Harness::builder().with_render_cursor(false).wgpu_setup(software_setup());
    let desk = Desk::of(builder, size);
    desk.remove_cursor();
    Some(desk)
}

/// The software driver alone: others draw lines and letters a little differently.
pub fn software_setup() -> WgpuSetup {
    let mut setup = default_wgpu_setup();
    if let WgpuSetup::CreateNew(new) = &mut setup {
        new.instance_descriptor.backends = Backends::VULKAN;
    }
    setup
}

pub fn has_driver() -> bool {
    static FOUND: OnceLock<bool> = OnceLock::new();
    *FOUND.get_or_init(|| {
        let instance = pollster::block_on(software_setup().new_instance());
        let adapters = pollster::block_on(instance.enumerate_adapters(Backends::VULKAN));
        let found = adapters.iter().any(|a| a.get_info().device_type == DeviceType::Cpu);
        let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
        let required = is_set("CI") || is_set("TEST_GPU");
        assert!(found || !required, "there is no software driver for Vulkan");
        if !found {
            // Written to the stream itself: what a test that passes prints is not shown.
            let mut stream = std::io::stderr().lock();
            let fact = "NOT RUN: pictures of the window; there is no software driver for Vulkan";
            writeln!(stream, "{fact}; apt-get install mesa-vulkan-drivers").unwrap();
        }
        found
    })
}

/// A built-in scene of the plane, changed by `change`.
pub fn plane(id: &str, change: impl FnOnce(&mut Scenario<2>)) -> AnyScenario {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in(id) else { panic!("{id}") };
    change(&mut scenario);
    AnyScenario::Quadtree(scenario)
}

pub fn asked<const D: usize>(algorithm: Algorithm) -> Query<D> {
    let Query::Ray { options, arithmetic, .. } = Query::<2>::default() else {
        panic!("the first query is about a ray")
    };
    Query::Ray { algorithm, options, arithmetic }
}

impl Desk {
    /// Opens a scenario from a file, as a user would.
    pub fn go_to(&mut self, at: &At) {
        let document = self.state().document().clone();
        let length = document.n_events();
        let step = match at {
            At::Share(share) => (length as f64 * share).round() as usize,
            At::Nth(n, kind) => with_document!(&document, d => nth(&d.trace.events, *n, kind)),
        };
        self.state_mut().view.playback.go_to(step, length);
        self.run();
    }
}

/// Number of events up to the n-th of a kind, itself included.
pub fn nth<const D: usize>(events: &[Event<D>], n: usize, kind: &str) -> usize {
    let is_kind = |event: &Event<D>| format!("{event:?}").starts_with(kind);
    let mut found = events.iter().enumerate().filter(|(_, event)| is_kind(event));
    let (index, _) = found.nth(n - 1).unwrap();
    index + 1
}
