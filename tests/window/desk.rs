//! The program with a user before it.

use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, accesskit::Role, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use egui_kittest::{Harness, HarnessBuilder, Node};
use octoscope::app::App;
use octoscope::document::{AnyDocument, Document};
use octoscope::text::texts;
use octoscope::widgets::PageInWindow;
use octoscope_core::scenario::AnyScenario;
use octoscope_figure::{Camera, Page, far_end, last_point};
use std::collections::HashMap;
use std::ops::{Deref, DerefMut};
use std::path::{Path, PathBuf};

/// The window in a test; it has all that [`Harness`] has.
pub struct Desk(Harness<'static, App>);

impl Deref for Desk {
    type Target = Harness<'static, App>;

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl DerefMut for Desk {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

impl Desk {
    /// The window on the first scene, without a graphics adapter.
    pub fn new() -> Self {
        Self::of(Harness::builder(), [1280.0, 800.0])
    }

    /// The window on the first scene, as `builder` wants it, of `size` points.
    pub fn of(builder: HarnessBuilder<App>, size: [f32; 2]) -> Self {
        let builder = builder.with_size(size).with_step_dt(1.0 / 60.0).with_max_steps(60);
        let mut desk = Self(builder.build_eframe(|creation| App::first(creation)));
        // A large window has larger type; the harness has set its size once more since then.
        let zoom = desk.ctx.zoom_factor();
        desk.set_size(vec2(size[0], size[1]) / zoom);
        desk.run();
        desk
    }

    /// Shows one frame in which all of these events come.
    pub fn frame_with(&mut self, events: &[Event]) {
        self.input_mut().events.extend_from_slice(events);
        self.step();
    }

    /// The window on a file.
    pub fn with_file(path: impl AsRef<Path>) -> Self {
        let mut desk = Self::new();
        desk.open(path);
        desk
    }

    /// The window as it starts with what an earlier one has left in `storage`;
    /// what was open last need not be there yet.
    pub fn starting(storage: &Storage) -> Self {
        Self::starting_with(storage, |_| ())
    }

    /// What is left by a window that is closed before its first frame.
    pub fn left_at_once(storage: &Storage) -> Storage {
        let mut left = Storage::default();
        Self::starting_with(storage, |app| eframe::App::save(app, &mut left));
        left
    }

    /// The window as it starts, after `meet` and then a few frames.
    pub fn starting_with(storage: &Storage, meet: impl FnOnce(&mut App)) -> Self {
        Self::starting_on(storage, None, meet)
    }

    /// The window as it is started with a file, once that is there or refused.
    pub fn started_on(storage: &Storage, path: &str) -> Self {
        let mut desk = Self::starting_on(storage, Some(path.into()), |_| ());
        desk.state_mut().finish_work();
        desk.run();
        desk
    }

    fn starting_on(storage: &Storage, path: Option<PathBuf>, meet: impl FnOnce(&mut App)) -> Self {
        let storage: &'static Storage = Box::leak(Box::new(storage.clone()));
        let builder = Harness::builder().with_size([1280.0, 800.0]).with_step_dt(1.0 / 60.0);
        Self(builder.with_max_steps(60).build_eframe(|creation| {
            creation.storage = Some(storage);
            let mut app = App::new(creation, path);
            meet(&mut app);
            app
        }))
    }

    /// The same once what was open last is there, or is known not to open.
    pub fn started(storage: &Storage) -> Self {
        let mut desk = Self::starting(storage);
        desk.state_mut().finish_work();
        desk.run();
        desk
    }

    /// What is left for the next start.
    pub fn left(&mut self) -> Storage {
        let mut storage = Storage::default();
        eframe::App::save(self.state_mut(), &mut storage);
        storage
    }

    /// Opens a file and waits until it is there, or refused.
    pub fn open(&mut self, path: impl AsRef<Path>) {
        let context = self.ctx.clone();
        self.state_mut().open(&context, path.as_ref().to_owned());
        self.state_mut().finish_work();
        self.run();
    }

    /// Opens a scenario, as from a file.
    pub fn open_scenario(&mut self, scenario: &AnyScenario) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.octo");
        std::fs::write(&path, scenario.print()).unwrap();
        self.open(&path);
        assert_eq!(self.state().view.dialog, None);
    }

    /// Waits for the map of rays.
    pub fn finish_maps(&mut self) {
        // The coarse one, and the whole one after it.
        for _ in 0..2 {
            self.state_mut().finish_work();
            self.run();
        }
    }

    /// Presses and releases a key.
    pub fn press(&mut self, key: Key) {
        self.key_press(key);
        self.run();
    }

    /// Presses and releases a key in two frames, settled or not.
    pub fn tap(&mut self, key: Key) {
        self.key_press(key);
        self.step();
    }

    /// Shows frames until nothing changes any more, however long other threads take for what
    /// is waited for.
    pub fn run(&mut self) {
        const MOST: usize = 100;
        let is_settled = (0..MOST).any(|_| self.try_run().is_ok());
        assert!(is_settled, "the window never comes to rest");
    }

    /// Opens the export dialog, which does not settle before its picture is there.
    pub fn open_export(&mut self) {
        self.key_press_modifiers(Modifiers::COMMAND, Key::E);
        self.step();
        self.step();
        let context = self.ctx.clone();
        self.state_mut().finish_preview(&context);
        self.run();
    }

    /// Presses and releases a key in one frame, settled or not.
    pub fn strike(&mut self, key: Key) {
        let modifiers = Modifiers::NONE;
        let event =
            |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        self.input_mut().events.extend([event(true), event(false)]);
        self.step();
    }

    /// Presses and releases a key together with others.
    pub fn press_with(&mut self, modifiers: Modifiers, key: Key) {
        self.key_press_modifiers(modifiers, key);
        self.run();
    }

    /// Clicks the only control of this role and name.
    pub fn click(&mut self, role: Role, name: &str) {
        self.get_by_role_and_label(role, name).click();
        self.run();
    }

    /// Types into the field of this name and confirms.
    pub fn type_into(&mut self, name: &str, text: &str) {
        self.click(Role::SpinButton, name);
        self.event(Event::Text(text.to_owned()));
        self.press(Key::Enter);
    }

    /// Drags from one place to the other, with `modifiers` held.
    pub fn drag(&mut self, [from, to]: [Pos2; 2], modifiers: Modifiers) {
        let path = [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| from + (to - from) * share);
        self.drag_along(&path, modifiers);
    }

    /// Drags from place to place.
    pub fn drag_along(&mut self, path: &[Pos2], modifiers: Modifiers) {
        let [from, .., to] = path else { panic!("a drag has two ends") };
        self.event(Event::ModifiersChanged(modifiers));
        self.hover_at(*from);
        self.button(*from, modifiers, Button::Down);
        path[1..].iter().for_each(|place| self.hover_at(*place));
        self.button(*to, modifiers, Button::Up);
        self.event(Event::ModifiersChanged(Modifiers::NONE));
        self.run();
    }

    /// Moves the pointer to a place, as a hand does: not in one jump.
    pub fn point_at(&mut self, place: Pos2) {
        self.hover_at(place + vec2(3.0, 3.0));
        self.step();
        self.hover_at(place);
        self.run();
    }

    /// Clicks a place once or several times.
    pub fn click_at(&mut self, place: Pos2, times: usize) {
        self.hover_at(place);
        for _ in 0..times {
            self.button(place, Modifiers::NONE, Button::Down);
            self.button(place, Modifiers::NONE, Button::Up);
        }
        self.run();
    }

    fn button(&self, pos: Pos2, modifiers: Modifiers, button: Button) {
        let pressed = matches!(button, Button::Down);
        self.event(Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers,
        });
    }

    /// Place in the window of a point of the open quadtree.
    pub fn place(&self, point: [f64; 2]) -> Pos2 {
        let (view, camera) = self.plane_view();
        view.place(&camera, point).unwrap()
    }

    /// Place in the window of the handle on the ray's tip in the open quadtree.
    pub fn tip_handle(&self) -> Pos2 {
        let (view, camera) = self.plane_view();
        let ray = self.plane().scenario.ray;
        view.on_screen(camera.tip_handle(view.page, [ray.origin(), ray.at(1.0)]).unwrap())
    }

    /// Place in the window of the head of the ray in the open quadtree.
    pub fn head_of_ray(&self) -> Pos2 {
        let (view, camera) = self.plane_view();
        let Document { tree, scenario, .. } = self.plane();
        let ends = [scenario.ray.origin(), far_end(tree, &scenario.ray)];
        let root = tree.domain().root_box();
        let last = last_point([ends[0], scenario.ray.at(1.0)], Some(&root));
        view.on_screen(camera.ray_arrow(view.page, ends, last).unwrap().on_page[1])
    }

    fn plane_view(&self) -> (PageInWindow, Camera<2>) {
        let name = texts(self.state().view.language).get("space-name");
        let rect = self.get_by_role_and_label(Role::Canvas, &name).rect();
        let page = Page { width: f64::from(rect.width()), height: f64::from(rect.height()) };
        let camera = self.state().view.plane_camera;
        let camera = camera.unwrap_or_else(|| self.plane().framed(page));
        (PageInWindow { page, corner: rect.min, scale: 1.0 }, camera)
    }

    /// The open document, which is a quadtree.
    #[track_caller]
    pub fn plane(&self) -> &Document<2> {
        match self.state().document() {
            AnyDocument::Plane(document) => document,
            AnyDocument::Space(_) => panic!("an octree is open"),
        }
    }

    /// The open document, which is an octree.
    #[track_caller]
    pub fn space(&self) -> &Document<3> {
        match self.state().document() {
            AnyDocument::Space(document) => document,
            AnyDocument::Plane(_) => panic!("a quadtree is open"),
        }
    }

    /// Number of events before the playhead.
    pub fn step_number(&self) -> usize {
        self.state().view.playback.step
    }

    /// The sentence of the step.
    pub fn sentence(&self) -> String {
        let is_sentence = |node: &Node<'_>| node.accesskit_node().author_id() == Some("sentence");
        let node = self.nodes().into_iter().find(is_sentence).unwrap();
        spoken(&node)
    }

    /// All nodes of the accessibility tree.
    pub fn nodes(&self) -> Vec<Node<'_>> {
        self.root().children_recursive().collect()
    }

    /// All texts on the screen, as a screen reader says them.
    pub fn texts(&self) -> Vec<String> {
        self.nodes().iter().map(spoken).filter(|text| !text.is_empty()).collect()
    }

    /// Whether this text is on the screen.
    pub fn says(&self, text: &str) -> bool {
        self.texts().iter().any(|other| other.contains(text))
    }
}

/// Keeps texts from one start of the window to the next.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Storage(HashMap<String, String>);

impl eframe::Storage for Storage {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

enum Button {
    Down,
    Up,
}

/// What a screen reader says of a node: its name, else its value.
pub fn spoken(node: &Node<'_>) -> String {
    let node = node.accesskit_node();
    node.label().or_else(|| node.value()).unwrap_or_default()
}

/// A sample file of the program.
pub fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes").join(name)
}
