//! What the window can look like, state by state, for tests and pictures that go
//! through all of them.

use crate::desk::{Desk, sample, spoken};
use crate::drawn::At;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, pos2};
use egui_kittest::Node;
use egui_kittest::kittest::Queryable as _;
use octoscope::bench::run;
use octoscope::document::Document;
use octoscope::files::Purpose;
use octoscope::lab::{Choice, Tab};
use octoscope::map::Colouring;
use octoscope::view::{Dialog, MapView, PanelKind, Preset, RaysOf, Search, Typed};
use octoscope::with_document;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::measure::{Quantity, Results};
use octoscope_core::paper::counterexample;
use octoscope_core::progress::Progress;
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::scenario::built_in;
use octoscope_core::traverse::{Algorithm, Variant, Variants};
use octoscope_figure::Slice;
use octoscope_figure::views::FigureView;
use std::sync::OnceLock;

/// A state of the window.
pub struct State {
    /// Its name, words with hyphens.
    pub name: String,
    reach: Box<dyn Fn(&mut Desk)>,
}

impl State {
    fn new(name: impl Into<String>, reach: impl Fn(&mut Desk) + 'static) -> Self {
        Self { name: name.into(), reach: Box::new(reach) }
    }

    /// Brings a window at its first scene to this state; theme, language and size stay.
    pub fn reach(&self, desk: &mut Desk) {
        (self.reach)(desk);
    }
}

/// Something that can be asked of a tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Question {
    /// Which leaves a ray meets.
    Ray(Algorithm),
    /// Where a point lies.
    Point(PointMethod),
    /// Which node encloses a box.
    Region,
    /// What lies beside a node.
    Neighbour(NeighbourMethod),
}

impl Question {
    /// Everything that can be asked.
    pub fn all() -> Vec<Self> {
        let rays = Algorithm::ALL.map(Self::Ray);
        let points = [PointMethod::Codes, PointMethod::Comparison].map(Self::Point);
        let neighbours = [NeighbourMethod::Codes, NeighbourMethod::Tables].map(Self::Neighbour);
        rays.into_iter().chain(points).chain([Self::Region]).chain(neighbours).collect()
    }

    /// Name of it, words with hyphens.
    pub fn name(self) -> String {
        match self {
            Self::Ray(algorithm) => algorithm.id().to_owned(),
            Self::Point(PointMethod::Codes) => "point-codes".to_owned(),
            Self::Point(PointMethod::Comparison) => "point-comparison".to_owned(),
            Self::Region => "region".to_owned(),
            Self::Neighbour(NeighbourMethod::Codes) => "neighbour-codes".to_owned(),
            Self::Neighbour(NeighbourMethod::Tables) => "neighbour-tables".to_owned(),
        }
    }

    /// Asks it of what is open.
    pub fn ask(self, desk: &mut Desk) {
        with_document!(desk.state_mut().document_mut(), document => {
            document.scenario.query = self.query(document);
        });
        desk.run();
    }

    fn query<const D: usize>(self, document: &Document<D>) -> Query<D> {
        let variants = Variants::NONE;
        let part = |share: f64| std::array::from_fn(|e| share + 0.03125 * e as f64);
        match self {
            Self::Ray(algorithm) => crate::drawn::asked(algorithm),
            Self::Point(method) => Query::Point { at: part(0.546_875), method, variants },
            Self::Region => Query::Region { min: part(0.3125), max: part(0.40625), variants },
            Self::Neighbour(method) => {
                let (leaf, _) = document.trace.leaves().nth(1).expect("the ray meets leaves");
                Query::Neighbour {
                    level: document.tree.level(leaf),
                    code: document.tree.code(leaf),
                    direction: Direction::new(std::array::from_fn(|e| i8::from(e < 2))).unwrap(),
                    reach: Reach::Leaf,
                    method,
                    variants,
                }
            }
        }
    }
}

/// The scenes of the plane and of space in which everything is shown.
pub const SCENES: [(&str, &str); 2] = [("2d", "quadtree-82"), ("3d", "points-3d")];

/// All states.
pub fn all() -> Vec<State> {
    let mut states = presets();
    states.extend(questions());
    states.extend(pictures());
    states.extend(over_the_window());
    states.extend(answers());
    states
}

fn open(desk: &mut Desk, scene: &str, preset: Preset) {
    desk.open_scenario(&built_in(scene).unwrap());
    desk.state_mut().view.preset = preset;
    desk.run();
}

fn presets() -> Vec<State> {
    let all = Preset::ALL.into_iter().flat_map(|preset| SCENES.map(|scene| (preset, scene)));
    let state = |(preset, (dimension, scene)): (Preset, (&str, &'static str))| {
        let name = format!("preset-{preset:?}-{dimension}").to_lowercase();
        State::new(name, move |desk| {
            open(desk, scene, preset);
            desk.go_to(&At::Share(0.46));
            if preset == Preset::Map {
                desk.finish_maps();
            }
        })
    };
    let large = SCENES.map(|(dimension, scene)| {
        State::new(format!("lecture-largest-{dimension}"), move |desk| {
            open(desk, scene, Preset::Lecture);
            desk.go_to(&At::Share(0.46));
            (0..5).for_each(|_| desk.press(Key::Plus));
            // What is said of that in the place of the sentence.
            desk.press(Key::Escape);
            desk.run();
        })
    });
    all.map(state).chain(large).collect()
}

/// Every question in the usual preset, in that of bits and in a lecture.
fn questions() -> Vec<State> {
    let mut states = Vec::new();
    for question in Question::all() {
        for (dimension, scene) in SCENES {
            for (word, preset) in
                [("rail", Preset::Rail), ("bits", Preset::Bits), ("lecture", Preset::Lecture)]
            {
                let name = format!("question-{}-{word}-{dimension}", question.name());
                states.push(State::new(name, move |desk| {
                    open(desk, scene, preset);
                    question.ask(desk);
                    desk.go_to(&At::Share(0.6));
                }));
            }
        }
    }
    states
}

/// What the picture can show beside the run.
fn pictures() -> Vec<State> {
    let shown = |name: &str, scene: &'static str, change: fn(&mut Desk)| {
        State::new(name, move |desk| {
            open(desk, scene, Preset::Rail);
            desk.go_to(&At::Share(0.46));
            change(desk);
            desk.run();
            desk.state_mut().finish_work();
            desk.run();
        })
    };
    vec![
        shown("picture-begin", "quadtree-82", |desk| desk.go_to(&At::Share(0.0))),
        shown("picture-end", "quadtree-82", |desk| desk.go_to(&At::Share(1.0))),
        shown("picture-end-3d", "points-3d", |desk| desk.go_to(&At::Share(1.0))),
        shown("picture-codes", "quadtree-82", |desk| desk.state_mut().view.plane_show.codes = true),
        shown("picture-mirrored", "quadtree-82", |desk| {
            desk.press(Key::R);
            desk.go_to(&At::Share(0.46));
            desk.state_mut().view.plane_show.mirrored_ray = true;
        }),
        shown("picture-mirrored-3d", "points-3d", |desk| {
            desk.press(Key::R);
            desk.go_to(&At::Share(0.46));
            desk.state_mut().view.space_show.mirrored_ray = true;
        }),
        shown("picture-sides", "quadtree-82", |desk| {
            desk.state_mut().view.plane_show.half_open_sides = true;
        }),
        shown("picture-apart", "quadtree-82", |desk| {
            desk.state_mut().view.plane_show.explosion = 0.5;
        }),
        shown("picture-apart-3d", "points-3d", |desk| {
            desk.state_mut().view.space_show.explosion = 0.5;
        }),
        shown("picture-slice-3d", "sphere-grid", |desk| {
            desk.state_mut().view.space_show.slice = Some(Slice { axis: 0, at: 0.5 });
        }),
        shown("picture-spheres-3d", "sphere-grid", |_| ()),
        shown("picture-cloud-3d", "cloud", |_| ()),
        shown("picture-hover", "quadtree-82", |desk| desk.point_at(desk.place([0.756, 0.4]))),
        shown("picture-notice", "quadtree-82", |desk| desk.press(Key::G)),
        shown("picture-spotlight", "quadtree-82", |desk| {
            desk.tap(Key::S);
            desk.point_at(pos2(500.0, 330.0));
        }),
        State::new("picture-mesh-3d", |desk| {
            desk.open(sample("knot.octo"));
            desk.go_to(&At::Share(0.5));
            desk.state_mut().finish_work();
            desk.run();
        }),
        State::new("map-picture-3d", |desk| {
            open(desk, "sphere-grid", Preset::Map);
            desk.state_mut().view.map =
                MapView { rays: RaysOf::Picture, colouring: Colouring::Comparisons };
            desk.finish_maps();
        }),
        State::new("map-wrong-2d", |desk| {
            desk.open_scenario(&counterexample(Variant::B3));
            desk.state_mut().view.preset = Preset::Map;
            desk.state_mut().view.map.colouring = Colouring::Differences;
            desk.finish_maps();
            // Below the paper lab.
            desk.state_mut().view.sought = Some(PanelKind::Map);
            desk.run();
        }),
    ]
}

/// Where an export goes, wherever the program is started.
pub const FIGURE: &str = "/home/ada/figure.svg";

/// After so many steps a dialog is there, not half transparent as it comes.
const FADED_IN: usize = 10;

/// Dialogs, labs and notes.
fn over_the_window() -> Vec<State> {
    let dialog = |name: &str, dialog: Dialog| {
        State::new(format!("dialog-{name}"), move |desk| {
            desk.state_mut().view.dialog = Some(dialog.clone());
            // A caret blinks: it never settles.
            desk.run_steps(FADED_IN);
        })
    };
    let export = |name, view, file: &'static str| {
        State::new(name, move |desk| {
            desk.go_to(&At::Share(0.46));
            desk.state_mut().view.export.view = view;
            desk.state_mut().view.export.file = file.to_owned();
            desk.state_mut().view.dialog = Some(Dialog::Export);
            desk.run_steps(FADED_IN);
            let context = desk.ctx.clone();
            desk.state_mut().finish_preview(&context);
            desk.run_steps(FADED_IN);
        })
    };
    let mut states = vec![
        dialog("keys", Dialog::Keys),
        dialog("about", Dialog::About),
        State::new("dialog-error", |desk| {
            desk.open("/no/such/folder/lecture.csv");
            desk.run_steps(FADED_IN);
        }),
        dialog("find", Dialog::Find(Search { wanted: "eb".to_owned(), chosen: 1 })),
        dialog("find-everything", Dialog::Find(Search::default())),
        dialog("path", Dialog::Path(typed())),
        State::new("dialog-path-refused", |desk| {
            let typed = Typed::new(Purpose::Save, "/no/such/folder/trees.octo".to_owned());
            desk.state_mut().view.dialog = Some(Dialog::Path(typed));
            desk.run_steps(2);
            desk.press(Key::Enter);
            desk.state_mut().finish_work();
            desk.run_steps(FADED_IN);
        }),
        export("dialog-export", FigureView::Space, FIGURE),
        export("dialog-export-folder", FigureView::Space, "/"),
        export("dialog-export-table", FigureView::Table, FIGURE),
        State::new("notes", |desk| {
            desk.go_to(&At::Share(0.46));
            desk.tap(Key::P);
            desk.run_steps(FADED_IN);
        }),
        State::new("blank", |desk| desk.tap(Key::B)),
    ];
    for variant in [Variant::B2, Variant::B3, Variant::B7, Variant::B10] {
        states.push(State::new(format!("paper-{}", variant.id()), move |desk| {
            desk.open_scenario(&counterexample(variant));
            desk.press(Key::End);
        }));
    }
    for variant in [Variant::B3, Variant::B7, Variant::B9, Variant::B24a] {
        states.push(State::new(format!("paper-{}-lecture", variant.id()), move |desk| {
            desk.open_scenario(&counterexample(variant));
            desk.state_mut().view.preset = Preset::Lecture;
            desk.run();
            desk.go_to(&At::Share(0.5));
        }));
    }
    for tab in Tab::ALL {
        let name = format!("lab-{tab:?}").to_lowercase();
        states.push(State::new(name, move |desk| show_lab(desk, tab, Quantity::Comparisons)));
    }
    states
}

fn typed() -> Typed {
    let path = "lectures/trees.octo".to_owned();
    Typed { replaces: true, ..Typed::new(Purpose::Save, path) }
}

/// The lab on one of its pages, with a small measurement.
pub fn show_lab(desk: &mut Desk, tab: Tab, cost: Quantity) {
    let is_cost = |one: &Quantity| *one == cost;
    let choice = Choice {
        depths: [4, 6],
        n_rays: 60,
        n_repeats: 1,
        tab,
        cost: Quantity::COSTS.iter().position(is_cost).unwrap(),
        algorithms: Algorithm::ALL.map(|one| one != Algorithm::Exhaustive),
        ..Choice::default()
    };
    // Only counts are shown: they are the same on every machine.
    if tab != Tab::Processor {
        static RESULTS: OnceLock<Results> = OnceLock::new();
        let measured = || run(&choice.plan().unwrap(), &Progress::default()).unwrap();
        desk.state_mut().take_results(RESULTS.get_or_init(measured).clone());
    }
    desk.state_mut().view.lab = choice;
    desk.state_mut().view.dialog = Some(Dialog::Lab);
    desk.run();
}

/// What the window answers where something cannot be done.
fn answers() -> Vec<State> {
    vec![
        State::new("answer-no-number", |desk| {
            // The first number of the ray, in any language.
            let fields: Vec<_> = desk.get_all_by_role(Role::SpinButton).collect();
            let is_of_ray = |node: &&Node<'_>| spoken(node).ends_with(" x");
            fields.iter().find(is_of_ray).unwrap().click();
            drop(fields);
            desk.run();
            desk.event(Event::Text("abc".to_owned()));
            desk.press(Key::Enter);
        }),
        State::new("answer-no-ray", |desk| {
            open(desk, "quadtree-82", Preset::Rail);
            Question::Point(PointMethod::Codes).ask(desk);
            desk.press(Key::G);
        }),
        State::new("answer-errata", |desk| {
            desk.open_scenario(&counterexample(Variant::B3));
            desk.press(Key::End);
            let named = |node: &Node<'_>| spoken(node).contains("Ray Tracing mit");
            desk.nodes().into_iter().find(named).unwrap().click();
            desk.run();
        }),
    ]
}
