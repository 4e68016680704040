//! Everything has its room, and keeps it from step to step.

use crate::desk::{Desk, spoken};
use eframe::egui::{Key, Rect, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::text::texts;
use octoscope::view::{Preset, View};
use octoscope_core::text::Language;

/// Higher than anything that is shown, so that nothing scrolls.
const TALL: f32 = 3000.0;
const SCENES: [&str; 2] = ["scene:quadtree-82", "scene:points-3d"];

fn desk(size: [f32; 2], scene: &str, language: Language, preset: Preset) -> Desk {
    let mut desk = Desk::of(Harness::builder(), size);
    desk.open(scene);
    let view = &mut desk.state_mut().view;
    (view.language, view.preset) = (language, preset);
    desk.run();
    desk
}

impl Desk {
    fn space_view(&self) -> Rect {
        let name = texts(self.state().view.language).get("space-name");
        self.get_by_role_and_label(Role::Canvas, &name).rect()
    }

    fn go_to_share(&mut self, share: f64) {
        let length = self.state().document().n_events();
        let step = (length as f64 * share).round() as usize;
        self.state_mut().view.playback.go_to(step, length);
        self.run();
    }

    /// What is said beside the space view, and where.
    fn beside(&self) -> Vec<(String, Role, Rect)> {
        let space = self.space_view();
        let is_beside = |rect: Rect| {
            rect.top() >= space.top()
                && rect.bottom() <= space.bottom()
                && (rect.right() <= space.left() || rect.left() >= space.right())
        };
        let nodes = self.nodes();
        let placed = nodes.iter().filter(|n| n.accesskit_node().bounding_box().is_some());
        let said = placed.map(|n| (spoken(n), n.accesskit_node().role(), n.rect()));
        said.filter(|(name, _, rect)| !name.is_empty() && is_beside(*rect)).collect()
    }
}

/// Height of the room beside the space view of a window of 1280 by 800 points.
fn room(scene: &str, language: Language) -> f32 {
    desk([1280.0, 800.0], scene, language, Preset::Bits).space_view().bottom() - 8.0
}

#[test]
fn at_1280_by_800_nothing_scrolls() {
    let presets = [
        Preset::Bits,
        Preset::Rail,
        Preset::Automaton,
        Preset::Debug,
        Preset::Compare,
        Preset::Tree,
    ];
    for (scene, language) in
        SCENES.into_iter().flat_map(|scene| Language::ALL.map(|language| (scene, language)))
    {
        let room = room(scene, language);
        let mut desk = desk([1280.0, TALL], scene, language, Preset::Bits);
        for preset in presets {
            desk.state_mut().view.preset = preset;
            for share in [0.3, 0.6, 1.0] {
                desk.go_to_share(share);
                let beside = desk.beside();
                assert!(beside.len() > 20, "{}", beside.len());
                let end = beside.iter().map(|(_, _, rect)| rect.bottom()).fold(0.0, f32::max);
                assert!(end <= room, "{scene} {language:?} {preset:?}: {end} of {room}");
            }
        }
    }
}

#[test]
fn every_question_fits_beside_the_picture_at_1280_by_800() {
    for (scene, language) in
        SCENES.into_iter().flat_map(|scene| Language::ALL.map(|language| (scene, language)))
    {
        let room = room(scene, language);
        let mut desk = desk([1280.0, TALL], scene, language, Preset::Bits);
        for key in ["query-point", "query-region", "query-neighbour"] {
            desk.click(Role::Button, &texts(language).get(key));
            let left = desk.space_view().left();
            let beside = desk.beside().into_iter();
            let ends = beside.filter(|(_, _, rect)| rect.right() <= left);
            let end = ends.map(|(_, _, rect)| rect.bottom()).fold(0.0, f32::max);
            assert!(end <= room, "{scene} {language:?} {key}: {end} of {room}");
        }
    }
}

#[test]
fn the_picture_keeps_its_width_from_step_to_step() {
    for scene in SCENES {
        for preset in [Preset::Automaton, Preset::Debug] {
            let mut desk = desk([1280.0, 800.0], scene, Language::English, preset);
            desk.press(Key::Home);
            let width = desk.space_view().width();
            // The first leaves, with all kinds of steps, and the end.
            for key in [Key::ArrowRight; 30].into_iter().chain([Key::End]) {
                desk.tap(key);
                assert_eq!(desk.space_view().width(), width, "{scene} {preset:?}");
            }
        }
    }
}

#[test]
fn the_largest_type_in_a_small_window_cuts_nothing_off_and_overlaps_nothing() {
    for (scene, language) in
        SCENES.into_iter().flat_map(|scene| Language::ALL.map(|language| (scene, language)))
    {
        // As wide as in a window of 768 points of height, but nothing is hidden.
        let mut desk = desk([1024.0, TALL], scene, language, Preset::Bits);
        desk.state_mut().view.scale = View::SCALES[1];
        for preset in Preset::ALL {
            desk.state_mut().view.preset = preset;
            desk.go_to_share(0.4);
            let [window, space] = [desk.ctx.content_rect(), desk.space_view()];
            assert!(window.width() < 650.0, "{window:?}");
            let beside = desk.beside();
            for (name, _, rect) in &beside {
                let inside = rect.left() >= space.right() && rect.right() <= window.right();
                assert!(inside, "{scene} {language:?} {preset:?}: {name} {rect:?} in {window:?}");
            }
            let labels: Vec<_> =
                beside.iter().filter(|(_, role, _)| *role == Role::Label).collect();
            assert!(!labels.is_empty());
            for (n, (name, _, rect)) in labels.iter().enumerate() {
                for (other, _, place) in &labels[n + 1..] {
                    let both = rect.intersect(*place);
                    let apart = both.width() < 1.0 || both.height() < 1.0;
                    assert!(apart, "{scene} {language:?} {preset:?}: {name} on {other}");
                }
            }
        }
    }
}

#[test]
fn type_is_not_larger_than_a_small_window_can_hold() {
    let mut desk = Desk::of(Harness::builder(), [1024.0, 768.0]);
    for _ in 0..20 {
        desk.press(Key::Plus);
    }
    let room = desk.ctx.content_rect();
    assert!(room.width() >= 599.0 && room.height() >= 439.0, "{room:?}");
    let shown = |key: &str| desk.says(&texts(Language::English).get(key));
    assert!(shown("panel-t-rail") && shown("panel-scene"));
}

#[test]
fn the_longest_sentence_leaves_room_for_the_timeline() {
    for (scale, language) in
        [1.0, 1.4, View::SCALES[1]].into_iter().flat_map(|scale| Language::ALL.map(|l| (scale, l)))
    {
        let mut desk = desk([1024.0, 768.0], SCENES[1], language, Preset::Rail);
        desk.state_mut().view.scale = scale;
        // The first sentence names the ray and the algorithm.
        desk.go_to_share(0.0);
        let name = texts(language).get("timeline-name");
        let ruler = desk.get_by_role_and_label(Role::Slider, &name).rect();
        let window = desk.ctx.content_rect();
        assert!(ruler.bottom() <= window.bottom(), "{scale} {language:?}: {ruler:?} in {window:?}");
        let hint = texts(language).get("t-rail-none");
        let hint = desk.get_by_label(&hint).rect();
        assert!(hint.left() >= desk.space_view().right() && hint.right() <= window.right());
    }
}
