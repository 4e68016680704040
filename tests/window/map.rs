//! The map of rays: its rays are taken by mouse and keyboard.

use crate::desk::{Desk, spoken};
use crate::drawn::{asked, plane};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, Shape, Vec2};
use egui_kittest::kittest::Queryable;
use octoscope::document::AnyDocument;
use octoscope::map::Colouring;
use octoscope::theme;
use octoscope::view::{Preset, RaysOf};
use octoscope_core::geometry::Ray;
use octoscope_core::query::Query;
use octoscope_core::scenario::built_in;
use octoscope_core::traverse::{Algorithm, Options, Variant};

impl Desk {
    /// Adds the map to the panels and waits until it is made.
    pub fn with_map(mut self) -> Self {
        self.state_mut().view.preset = Preset::Map;
        self.finish_maps();
        self
    }

    fn map(&self) -> Rect {
        let is_map = |name: &str| name.starts_with("Map of rays:");
        let nodes = self.nodes();
        let map = nodes.iter().find(|node| is_map(&spoken(node))).expect("the map is shown");
        map.rect()
    }
}

#[test]
fn a_press_in_the_map_takes_its_ray() {
    let mut desk = Desk::new().with_map();
    let before = desk.plane().scenario.ray;
    let map = desk.map();
    // A quarter to the right is 90°, the middle the line through the centre.
    desk.click_at(map.min + map.size() * Vec2::new(0.25, 0.5), 1);
    let ray = desk.plane().scenario.ray;
    assert_ne!(ray, before);
    let [x, y] = ray.direction();
    assert!(x.abs() < 0.02 * y, "it goes up: {ray:?}");
    desk.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.plane().scenario.ray, before);
}

#[test]
fn arrow_keys_go_to_the_rays_beside_it() {
    let mut desk = Desk::new().with_map();
    let map = desk.map();
    desk.click_at(map.center(), 1);
    let (before, step) = (desk.plane().scenario.ray, desk.step_number());
    // The mouse leaves the arrows to the steps.
    desk.tap(Key::ArrowRight);
    assert_eq!((desk.plane().scenario.ray, desk.step_number()), (before, step + 1));
    desk.tap(Key::ArrowLeft);
    desk.get_by_label_contains("Map of rays:").focus();
    desk.run();
    desk.tap(Key::ArrowRight);
    let after = desk.plane().scenario.ray;
    assert_ne!(after, before);
    assert_eq!(desk.step_number(), step, "the playhead stays");
    desk.tap(Key::ArrowLeft);
    assert_eq!(desk.plane().scenario.ray, before);
}

#[test]
fn a_printed_rule_goes_wrong_on_many_rays() {
    let mut desk = Desk::new();
    let options = Options { variants: [Variant::B3].into_iter().collect(), ..Options::default() };
    let (algorithm, arithmetic) = (Algorithm::Parametric, Default::default());
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.query = Query::Ray { algorithm, options, arithmetic };
    desk.state_mut().view.map.colouring = Colouring::Differences;
    let desk = desk.with_map();
    let told = desk.texts().into_iter().find(|text| text.contains("rays go wrong"));
    let n_wrong: u32 = told.unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!(n_wrong > 100, "{n_wrong}");
    assert!(desk.says("The algorithm that is shown, compared with an exact search"));
}

/// The map of lines of sight in space.
fn sights() -> Desk {
    let mut desk = Desk::new();
    desk.open_scenario(&built_in("points-3d").unwrap());
    desk.state_mut().view.map.rays = RaysOf::Picture;
    desk.with_map()
}

#[test]
fn a_press_in_the_picture_takes_its_line_of_sight() {
    let mut desk = sights();
    let map = desk.map();
    desk.click_at(map.center(), 1);
    let domain = *desk.space().tree.domain();
    let centre: [f64; 3] = std::array::from_fn(|e| domain.min()[e] + 0.5 * domain.side());
    let ray = desk.space().scenario.ray;
    let to_centre: [f64; 3] = std::array::from_fn(|e| centre[e] - ray.at(1.0)[e]);
    let apart = to_centre.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(apart < 0.02 * domain.side(), "{ray:?}");
    assert!(desk.says("The lines of sight"));
    assert!(
        marks(&desk, desk.map()) > 0
            && desk.says("The present ray")
            && !desk.says("no line of sight")
    );
}

/// Shapes in the colour of the ray that are painted in a part of the window.
fn marks(desk: &Desk, within: Rect) -> usize {
    let view = &desk.state().view;
    let ray = theme::look(view.language, view.theme).palette.ray;
    let is_mark = |shape: &Shape| match shape {
        Shape::Circle(circle) => circle.stroke.color == ray || circle.fill == ray,
        Shape::LineSegment { stroke, .. } => stroke.color == ray,
        _ => false,
    };
    let shapes = desk.output().shapes.iter().map(|clipped| &clipped.shape);
    shapes
        .filter(|shape| is_mark(shape) && within.contains_rect(shape.visual_bounding_rect()))
        .count()
}

#[test]
fn a_ray_that_is_no_line_of_sight_is_seen_in_the_map_and_told_from_one() {
    let mut desk = sights();
    assert!(marks(&desk, desk.map()) > 0);
    assert!(desk.says("it is no line of sight"));
    // Far from all that is seen.
    let AnyDocument::Space(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.ray = Ray::new([50.0; 3], [1.0, 0.0, 0.0]).unwrap();
    desk.state_mut().view.eye = Some("-30,20,1,0.5,0.5,0.5".parse().unwrap());
    desk.run();
    desk.finish_maps();
    assert_eq!(marks(&desk, desk.map()), 0);
    assert!(desk.says("The present ray lies beyond the sides of the map"));
}

#[test]
fn where_no_ray_is_followed_it_is_said_why_there_is_no_map() {
    let mut desk = Desk::new();
    for (button, why) in [
        ("Point", "but a point is located. Esc"),
        ("Region", "but a region is located. Esc"),
        ("Neighbour", "but a neighbour is looked for. Esc"),
    ] {
        desk.click(Role::Button, button);
        desk.state_mut().view.preset = Preset::Map;
        desk.run();
        assert!(desk.says(why), "{:?}", desk.texts());
        desk.state_mut().view.preset = Preset::Rail;
        desk.run();
    }
}

#[test]
fn what_would_hold_up_the_window_is_not_counted_under_the_pointer() {
    let mut desk = Desk::new().with_map();
    assert!(!desk.says("too long to be counted here"));
    let grid = plane("quadtree-82", |scenario| {
        scenario.recipe.depth = 16;
        scenario.query = asked(Algorithm::Dda);
    });
    desk.open_scenario(&grid);
    desk.state_mut().view.preset = Preset::Map;
    desk.finish_maps();
    assert!(desk.says("too long to be counted here"));
}
