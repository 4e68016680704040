//! What the window remembers that is not part of the scenario.

mod arrangement;
mod dialog;
mod flight;
mod hover;
mod map;
mod panel;
mod preset;
mod standpoint;

use crate::export::Choice;
use crate::eye::Eye;
use crate::lab;
use crate::playback::Playback;
use crate::tree_view::TreeView;
use eframe::egui::{Rect, Vec2};
use octoscope_core::explain::Notation;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::tree::NodeId;
use octoscope_figure::{Camera, Lens, Show, Theme};
use serde::{Deserialize, Serialize};
use std::any::Any;
use std::collections::BTreeMap;

pub use arrangement::{Arrangement, PanelChange};
pub use dialog::{Dialog, Search, Typed};
pub use flight::Flight;
pub use hover::Hover;
pub use map::{MapView, RaysOf};
pub use panel::PanelKind;
pub use preset::Preset;
pub use standpoint::Standpoint;

/// State of the window: neither undone nor saved with the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct View {
    /// Colours.
    pub theme: Theme,
    /// Language of all texts.
    pub language: Language,
    /// Panels on the right.
    pub preset: Preset,
    /// What the user has changed about the panels of presets.
    pub arrangements: BTreeMap<Preset, Arrangement>,
    /// Factor of type and lines, beside the preset's own.
    pub scale: f32,
    /// What the space view shows of quadtrees.
    pub plane_show: Show,
    /// What it shows of octrees.
    pub space_show: Show,
    /// What the map of rays shows.
    pub map: MapView,
    /// Whether the formula of the step is shown.
    pub formulas: bool,
    /// How formulas are written.
    pub notation: Notation,
    /// What was chosen for the last export.
    pub export: Choice,
    /// What was chosen in the bench lab.
    pub lab: lab::Choice,
    /// The playhead.
    pub playback: Playback,
    /// Camera of quadtrees; `None` fits everything.
    #[serde(skip)]
    pub plane_camera: Option<Camera<2>>,
    /// Camera of octrees; `None` fits everything.
    #[serde(skip)]
    pub orbit_camera: Option<Camera<3>>,
    /// Where the scenario wants to be looked at from, until the space view stands there.
    #[serde(skip)]
    pub eye: Option<Eye>,
    /// Whether the question, scene to options, is shown beside the picture; `None`
    /// leaves that to the preset and the size of the window.
    #[serde(skip)]
    pub question: Option<bool>,
    /// Whether it was at hand in the last frame.
    #[serde(skip)]
    pub question_shown: bool,
    /// Whether the kept camera shows everything, and goes on doing so when the
    /// space view gets another size.
    #[serde(skip)]
    pub fitted: bool,
    /// The step at which the pointer was moved last: hints beside it are for
    /// whoever points, not for whoever steps.
    #[serde(skip)]
    pub pointed: Option<usize>,
    /// Where the space view was in the last frame.
    #[serde(skip)]
    pub space: Option<Rect>,
    /// How the camera gets to where it is to be.
    #[serde(skip)]
    pub flight: Option<Flight>,
    /// Whether nothing is animated.
    pub reduced_motion: bool,
    /// How depth looks in octrees.
    pub lens: Lens,
    /// Whether the camera goes with the current node.
    pub follow: bool,
    /// The node that the camera went to last.
    #[serde(skip)]
    pub followed: Option<NodeId>,
    /// Where the camera is to go.
    #[serde(skip)]
    pub standpoint: Option<Standpoint>,
    /// The node under the pointer.
    #[serde(skip)]
    pub hover: Hover,
    /// What is unfolded in the diagram of the tree, and how it is looked at.
    #[serde(skip)]
    pub tree: TreeView,
    /// The panel that is to be seen from its top in the next frame.
    #[serde(skip)]
    pub sought: Option<PanelKind>,
    /// Whether the window is blank.
    #[serde(skip)]
    pub blank: bool,
    /// Whether everything but the surroundings of the pointer is dimmed.
    #[serde(skip)]
    pub spotlight: bool,
    /// When the clock of the notes was started, in seconds since the program was;
    /// `None` without notes.
    #[serde(skip)]
    pub notes_since: Option<f64>,
    /// The window that lies over everything else.
    #[serde(skip)]
    pub dialog: Option<Dialog>,
    /// What went wrong while the window was closing, for the next start to tell.
    pub untold: Option<String>,
}

impl View {
    /// Smallest and largest factor of type and lines.
    pub const SCALES: [f32; 2] = [0.7, 2.5];
    /// Type is not made so large that the window holds less than so many points.
    const SMALLEST_ROOM: Vec2 = Vec2::new(600.0, 440.0);
    /// What the coarsest projector shows, in points.
    const PROJECTOR: Vec2 = Vec2::new(1024.0, 768.0);
    /// What the panels of a preset fill, in points; in more, type and lines are larger.
    const COMPOSED: Vec2 = Vec2::new(1280.0, 800.0);
    /// How much larger at most: whoever sits at a large screen wants to see more, too.
    const MOST_LARGER: f32 = 1.5;

    /// Larger or smaller type and lines in a window that would be of `room` points if the
    /// factor were 1; whether the limits leave room for that.
    pub fn change_scale(&mut self, factor: f32, room: Vec2) -> bool {
        let (scale, before) = (self.scale, self.zoom(room));
        let within = |scale: f32| scale.clamp(Self::SCALES[0], Self::SCALES[1]);
        // What lies beyond what the window allows is passed over.
        let next = |scale: &f32| Some(within(scale * factor)).filter(|next| next != scale);
        for scale in std::iter::successors(next(&scale), next) {
            self.scale = scale;
            if self.zoom(room) != before {
                return true;
            }
        }
        self.scale = scale;
        false
    }

    /// What the space view shows of trees of dimension D.
    pub fn show<const D: usize>(&self) -> &Show {
        if D == 2 { &self.plane_show } else { &self.space_show }
    }

    /// The same, to be changed.
    pub fn show_mut<const D: usize>(&mut self) -> &mut Show {
        if D == 2 { &mut self.plane_show } else { &mut self.space_show }
    }

    /// The panels to be shown, from top to bottom.
    pub fn panels<const D: usize>(&self, query: &Query<D>) -> Vec<PanelKind> {
        let mut automatic = self.preset.panels(query);
        let Some(arrangement) = self.arrangements.get(&self.preset) else { return automatic };
        // While it is open the lab stays where it is, with a misprint or without.
        if arrangement.is_added(PanelKind::Paper) && !automatic.contains(&PanelKind::Paper) {
            automatic.insert(self.preset.place_of_lab(&automatic), PanelKind::Paper);
        }
        arrangement.shown(&automatic)
    }

    /// What the user has changed about the panels of the present preset.
    pub fn arrangement(&mut self) -> &mut Arrangement {
        self.arrangements.entry(self.preset).or_default()
    }

    /// The camera that is kept for trees of dimension D; `None` fits everything.
    pub fn camera<const D: usize>(&self) -> Option<Camera<D>> {
        let any: &dyn Any = if D == 2 { &self.plane_camera } else { &self.orbit_camera };
        any.downcast_ref::<Option<Camera<D>>>().copied().flatten()
    }

    /// Keeps the camera for trees of its dimension.
    pub fn set_camera<const D: usize>(&mut self, camera: Camera<D>) {
        let any: &mut dyn Any =
            if D == 2 { &mut self.plane_camera } else { &mut self.orbit_camera };
        if let Some(slot) = any.downcast_mut::<Option<Camera<D>>>() {
            *slot = Some(camera);
        }
    }

    /// Forgets where the camera is: everything is seen from the usual side.
    pub fn forget_cameras(&mut self) {
        (self.plane_camera, self.orbit_camera, self.eye) = (None, None, None);
        (self.standpoint, self.flight) = (None, None);
    }

    /// Shows everything, octrees from the side from which they are seen now.
    pub fn show_everything(&mut self) {
        let is_kept = self.plane_camera.is_some() || self.orbit_camera.is_some();
        self.standpoint = is_kept.then_some(Standpoint::Everything);
    }

    /// Factor of type and lines, the preset's included, in a window that would
    /// be of `room` points if it were 1.
    pub fn zoom(&self, room: Vec2) -> f32 {
        let largest = (room / Self::SMALLEST_ROOM).min_elem();
        // A finer projector throws no larger picture: a lecture fills it the same way.
        let share = if self.preset == Preset::Lecture {
            (room / Self::PROJECTOR).min_elem().max(1.0)
        } else {
            // In steps, so that it is not set anew at every size that a window passes.
            let share = (room / Self::COMPOSED).min_elem().clamp(1.0, Self::MOST_LARGER);
            (share * 20.0 + 0.01).floor() / 20.0
        };
        (self.scale * self.preset.scale() * share).min(largest.max(1.0))
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            theme: Theme::Light,
            language: Language::English,
            preset: Preset::default(),
            arrangements: BTreeMap::new(),
            scale: 1.0,
            plane_show: Show::at_first::<2>(),
            space_show: Show::at_first::<3>(),
            map: MapView::default(),
            formulas: true,
            notation: Notation::default(),
            export: Choice::default(),
            lab: lab::Choice::default(),
            playback: Playback::default(),
            plane_camera: None,
            orbit_camera: None,
            eye: None,
            question: None,
            question_shown: true,
            fitted: false,
            pointed: None,
            space: None,
            flight: None,
            reduced_motion: false,
            lens: Lens::default(),
            follow: false,
            followed: None,
            standpoint: None,
            hover: Hover::default(),
            tree: TreeView::default(),
            sought: None,
            blank: false,
            spotlight: false,
            notes_since: None,
            dialog: None,
            untold: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::query::PointMethod;
    use octoscope_core::traverse::{Variant, Variants};

    #[test]
    fn what_an_earlier_version_remembered_still_opens() {
        let json = r#"{"theme":"dark","preset":"Debug","scale":1.21,"playback":{"step":7}}"#;
        let view: View = serde_json::from_str(json).unwrap();
        assert_eq!((view.theme, view.preset, view.scale), (Theme::Dark, Preset::Debug, 1.21));
        assert_eq!(view.arrangements, BTreeMap::new());
    }

    #[test]
    fn arrangements_are_remembered_preset_by_preset() {
        let query = Query::<2>::default();
        let mut view = View { preset: Preset::Debug, ..View::default() };
        let shown = view.panels(&query);
        view.arrangement().change(PanelKind::Stack, PanelChange::Close, &shown);
        view.arrangement().add(PanelKind::Codes);
        let json = serde_json::to_string(&view).unwrap();
        let mut again: View = serde_json::from_str(&json).unwrap();
        assert_eq!(again.panels(&query), view.panels(&query));
        assert!(!again.panels(&query).contains(&PanelKind::Stack));
        again.preset = Preset::Bits;
        assert_eq!(again.panels(&query), Preset::Bits.panels(&query));
    }

    #[test]
    fn the_lab_stays_first_while_it_is_open_but_below_the_map() {
        let with = |variants| Query::<2>::default().with_variants(variants);
        let [printed, right] = [Variants::NONE.with(Variant::B3), Variants::NONE].map(with);
        for preset in Preset::ALL {
            let mut view = View { preset, ..View::default() };
            let place = |view: &View, query| {
                view.panels(query).iter().position(|panel| *panel == PanelKind::Paper)
            };
            let first = Some(usize::from(preset == Preset::Map));
            assert_eq!([&printed, &right].map(|query| place(&view, query)), [first, None]);
            view.arrangement().add(PanelKind::Paper);
            assert_eq!([&printed, &right].map(|query| place(&view, query)), [first; 2]);
        }
    }

    #[test]
    fn a_point_is_sought_in_its_codes_and_in_the_tree() {
        let (method, variants) = (PointMethod::default(), Variants::NONE);
        let query = Query::<2>::Point { at: [0.5; 2], method, variants };
        let expected = [PanelKind::Codes, PanelKind::Tree, PanelKind::Counters];
        assert_eq!(Preset::Bits.panels(&query), expected);
    }

    #[test]
    fn every_panel_is_in_the_list_once() {
        let mut ids: Vec<_> = PanelKind::ALL.map(PanelKind::id).to_vec();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), PanelKind::ALL.len());
    }

    #[test]
    fn type_grows_until_the_window_is_full() {
        let mut view = View { scale: 2.5, ..View::default() };
        assert_eq!(view.zoom(Vec2::new(1200.0, 4400.0)), 2.0);
        assert_eq!(view.zoom(Vec2::new(400.0, 300.0)), 1.0);
        view.scale = 0.7;
        assert_eq!(view.zoom(Vec2::new(400.0, 300.0)), 0.7);
    }

    #[test]
    fn type_is_changed_as_far_as_the_window_allows_and_at_once_back() {
        let room = Vec2::new(1024.0, 768.0);
        let mut view = View { preset: Preset::Lecture, scale: 2.5, ..View::default() };
        let largest = view.zoom(room);
        assert!(!view.change_scale(1.1, room));
        assert_eq!(view.scale, 2.5);
        assert!(view.change_scale(1.0 / 1.1, room));
        assert!(view.zoom(room) < largest);
        assert!(view.change_scale(1.1, room));
        assert_eq!(view.zoom(room), largest);
        while view.change_scale(1.0 / 1.1, room) {}
        assert_eq!(view.scale, View::SCALES[0]);
    }

    #[test]
    fn a_large_window_has_larger_type_and_the_user_the_last_word() {
        let mut view = View::default();
        let mut check = |scale, size: [f32; 2], zoom: f32| {
            view.scale = scale;
            let found = view.zoom(Vec2::from(size));
            assert!((found - zoom).abs() < 1e-6, "{size:?} {scale}: {found}");
        };
        check(1.0, [1280.0, 800.0], 1.0);
        check(1.0, [1280.0, 3000.0], 1.0);
        check(1.0, [1440.0, 900.0], 1.1);
        check(1.0, [1920.0, 1080.0], 1.35);
        check(1.0, [3840.0, 2160.0], 1.5);
        check(0.8, [1920.0, 1080.0], 1.08);
    }

    #[test]
    fn a_lecture_has_the_same_room_on_every_projector() {
        let view = View { preset: Preset::Lecture, ..View::default() };
        for size in [[1024.0, 768.0], [1400.0, 1050.0], [2048.0, 1536.0]].map(Vec2::from) {
            let room = size / view.zoom(size);
            assert!((room - Vec2::new(640.0, 480.0)).length() < 1e-3, "{room:?}");
        }
    }
}
