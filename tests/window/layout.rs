//! Everything has its room, and keeps it from step to step.

use crate::desk::{Desk, sample, spoken};
use eframe::egui::{Key, Rect, Shape, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::text::texts;
use octoscope::view::{PanelKind, Preset, View};
use octoscope::with_document;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;

/// Higher than anything that is shown, so that nothing scrolls.
const TALL: f32 = 3000.0;
const SCENES: [&str; 2] = ["scene:quadtree-82", "scene:points-3d"];

fn desk(size: [f32; 2], scene: &str, language: Language, preset: Preset) -> Desk {
    let mut desk = Desk::of(Harness::builder(), size);
    desk.open(scene);
    let view = &mut desk.state_mut().view;
    (view.language, view.preset) = (language, preset);
    // Formulas take from the picture alone: what stands beside it goes on below.
    view.formulas = false;
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
    check_that_nothing_scrolls([1280.0, 800.0], 1.0);
}

#[test]
fn at_1920_by_1080_nothing_scrolls() {
    // A high window has larger type than a low one of this width.
    check_that_nothing_scrolls([1920.0, 1080.0], 0.9);
}

/// Checks the panels of a window of this size; `scale` gives a high one of its width the
/// same type.
fn check_that_nothing_scrolls(size: [f32; 2], scale: f32) {
    let presets = [
        Preset::Bits,
        Preset::Rail,
        Preset::Automaton,
        Preset::Debug,
        Preset::Compare,
        Preset::Tree,
        Preset::Map,
    ];
    for (scene, language) in
        SCENES.into_iter().flat_map(|scene| Language::ALL.map(|language| (scene, language)))
    {
        let low = desk(size, scene, language, Preset::Bits);
        let (room, width) = (low.space_view().bottom() - 8.0, low.ctx.content_rect().width());
        let mut desk = desk([size[0], TALL], scene, language, Preset::Bits);
        desk.state_mut().view.scale = scale;
        desk.run();
        assert!((desk.ctx.content_rect().width() - width).abs() < 1.0);
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

/// Whether what stands to the right of the picture is covered at its lower edge.
fn goes_on_below(desk: &Desk) -> bool {
    let space = desk.space_view();
    let is_cover = |shape: &Shape| {
        let Shape::Mesh(mesh) = shape else { return false };
        let Some((first, last)) = mesh.vertices.first().zip(mesh.vertices.last()) else {
            return false;
        };
        first.color.a() == 0
            && last.color.a() == 255
            && first.pos.x >= space.right()
            && (last.pos.y - space.bottom()).abs() < 16.0
    };
    desk.output().shapes.iter().any(|clipped| is_cover(&clipped.shape))
}

#[test]
fn a_column_that_goes_on_below_says_so() {
    let mut desk = desk([1280.0, 800.0], SCENES[0], Language::English, Preset::Rail);
    assert!(!goes_on_below(&desk));
    for panel in [PanelKind::Listing, PanelKind::Stack] {
        desk.state_mut().view.arrangement().add(panel);
    }
    desk.run();
    assert!(goes_on_below(&desk));
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

impl Desk {
    /// What is cut off beside the picture, and what lies on another text.
    fn faults(&self) -> Vec<String> {
        let [window, space] = [self.ctx.content_rect(), self.space_view()];
        let beside = self.beside();
        let is_inside = |rect: &Rect| {
            (rect.left() >= space.right() && rect.right() <= window.right())
                || (rect.left() >= window.left() && rect.right() <= space.left())
        };
        let cut = beside.iter().filter(|(_, _, rect)| !is_inside(rect));
        let mut faults: Vec<_> = cut.map(|(name, _, rect)| format!("{name} {rect:?}")).collect();
        let labels: Vec<_> = beside.iter().filter(|(_, role, _)| *role == Role::Label).collect();
        assert!(!labels.is_empty());
        for (n, (name, _, rect)) in labels.iter().enumerate() {
            for (other, _, place) in &labels[n + 1..] {
                let both = rect.intersect(*place);
                if both.width() >= 1.0 && both.height() >= 1.0 {
                    faults.push(format!("{name} on {other}"));
                }
            }
        }
        faults
    }

    fn ask(&mut self, algorithm: Algorithm) {
        with_document!(self.state_mut().document_mut(), document => {
            if let Query::Ray { algorithm: asked, .. } = &mut document.scenario.query {
                *asked = algorithm;
            }
        });
        self.run();
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
            assert!(desk.ctx.content_rect().width() < 650.0);
            assert_eq!(desk.faults(), [""; 0], "{scene} {language:?} {preset:?}");
        }
    }
}

/// Checks the panels of every algorithm in German, whose words are the longer ones.
fn check_every_algorithm(size: [f32; 2], scale: f32) {
    let mut all = Vec::new();
    for scene in SCENES {
        let mut desk = desk(size, scene, Language::German, Preset::Bits);
        desk.state_mut().view.scale = scale;
        for algorithm in Algorithm::ALL {
            desk.ask(algorithm);
            // The presets that give the algorithm's own panel its different widths.
            for preset in [Preset::Rail, Preset::Debug, Preset::Lecture] {
                desk.state_mut().view.preset = preset;
                for share in [0.3, 0.8] {
                    desk.go_to_share(share);
                    let faults = desk.faults().into_iter();
                    let place = format!("{scene} {algorithm:?} {preset:?} {share}");
                    all.extend(faults.map(|fault| format!("{place}: {fault}")));
                }
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn the_panels_of_every_algorithm_fit_into_1280_points() {
    check_every_algorithm([1280.0, TALL], 1.0);
}

#[test]
fn the_panels_of_every_algorithm_fit_into_1024_points_with_large_type() {
    check_every_algorithm([1024.0, TALL], 1.6);
}

#[test]
fn the_question_is_at_hand_in_every_preset_and_size() {
    for (size, scale) in [([1280.0, 800.0], 1.0), ([1024.0, 768.0], 2.5)] {
        for preset in Preset::ALL {
            let mut desk = desk(size, SCENES[0], Language::English, preset);
            desk.state_mut().view.scale = scale;
            desk.run();
            let is_seen = |desk: &Desk| {
                let window = desk.ctx.content_rect();
                let scene = desk.query_by_role_and_label(Role::SpinButton, "origin x");
                scene.is_some_and(|field| field.rect().bottom() < window.bottom() - 150.0)
            };
            if !is_seen(&desk) {
                desk.press(Key::Q);
            }
            assert!(is_seen(&desk), "{size:?} {preset:?}");
            desk.press(Key::Q);
            assert!(!is_seen(&desk), "{size:?} {preset:?}");
        }
    }
}

#[test]
fn the_picture_keeps_its_room_when_the_window_gets_smaller() {
    let mut desk = desk([1280.0, 800.0], SCENES[0], Language::English, Preset::Debug);
    desk.set_size(eframe::egui::vec2(1024.0, 768.0));
    desk.run();
    let space = desk.space_view();
    assert!(space.width() > 360.0, "{space:?}");
}

#[test]
fn all_columns_of_the_comparison_are_seen_in_both_languages() {
    for (scene, language) in
        SCENES.into_iter().flat_map(|scene| Language::ALL.map(|language| (scene, language)))
    {
        let mut desk = desk([1280.0, 800.0], scene, language, Preset::Compare);
        if scene == SCENES[1] {
            // Its exhaustive run has numbers of six digits.
            desk.open(sample("knot.octo"));
            desk.state_mut().finish_work();
            desk.run();
        }
        let end = desk.ctx.content_rect().right() - 8.0;
        let texts = texts(language);
        for key in ["compare-leaves", "compare-tests", "compare-quotients"] {
            let name = texts.format("compare-sort", &[("column", texts.get(key).into())]);
            let head = desk.get_by_role_and_label(Role::Button, &name).rect();
            assert!(head.right() <= end, "{scene} {language:?} {key}: {head:?}");
        }
        let name = texts.format("panel-menu", &[("title", texts.get("panel-compare").into())]);
        assert!(desk.get_by_role_and_label(Role::Button, &name).rect().right() <= end);
    }
}

#[test]
fn menus_are_not_covered_in_a_tiny_window() {
    let desk = desk([320.0, 240.0], SCENES[0], Language::English, Preset::Bits);
    let help = desk.get_by_role_and_label(Role::Button, "Help").rect();
    let covered = desk.query_by_role_and_label(Role::Button, "EN");
    assert!(covered.is_none_or(|label| label.rect().left() >= help.right()));
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
