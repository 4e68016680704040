//! The pictures in `screenshots/`: the real window, drawn by the software
//! driver and compared pixel by pixel. `UPDATE_SNAPSHOTS=1` draws them anew.
//! Without the driver (`mesa-vulkan-drivers`) nothing is compared, which is a failure
//! where `CI` is set, or `TEST_GPU`.

use crate::desk::sample;
use crate::drawn::{At, asked, compare, compare_sized, drawn_desk, plane};
use crate::states::{FIGURE, show_lab};
use eframe::egui::{Event as Input, Key, Modifiers, accesskit::Role, pos2, vec2};
use egui_kittest::kittest::Queryable;
use octoscope::lab::Tab;
use octoscope::map::Colouring;
use octoscope::view::{Dialog, MapView, Preset, RaysOf, Search, View};
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::measure::Quantity;
use octoscope_core::paper::counterexample;
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, built_in};
use octoscope_core::text::Language;
use octoscope_core::traverse::{Algorithm, Variant, Variants};
use octoscope_figure::Theme;

#[test]
fn the_lab_with_bars() {
    compare("lab-scenes", |desk| show_lab(desk, Tab::Scenes, Quantity::NodeTouches));
}

#[test]
fn the_lab_with_growth_in_dark_german() {
    compare("lab-growth", |desk| {
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.language = Language::German;
        desk.run();
        show_lab(desk, Tab::Growth, Quantity::Comparisons);
    });
}

#[test]
fn the_lab_with_a_ray_for_the_processor() {
    compare("lab-processor", |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        show_lab(desk, Tab::Processor, Quantity::Time);
    });
}

#[test]
fn the_plane_in_light_colours() {
    compare("window-plane-light", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.go_to(&At::Nth(6, "First"));
    });
}

#[test]
fn another_theme_and_language_come_with_one_whole_frame() {
    let Some(mut desk) = drawn_desk([1280.0, 800.0]) else { return };
    let mut frames = vec![desk.render().unwrap()];
    for key in [Key::T, Key::L] {
        desk.key_press(key);
        for _ in 0..4 {
            desk.step();
            frames.push(desk.render().unwrap());
        }
    }
    frames.dedup();
    assert_eq!(frames.len(), 3, "light, dark, and dark in German");
}

#[test]
fn the_plane_in_dark_colours() {
    compare("window-plane-dark", |desk| {
        desk.open(sample("lecture.octo"));
        desk.state_mut().view.theme = Theme::Dark;
        desk.go_to(&At::Nth(50, "First"));
    });
}

#[test]
fn the_search_in_german() {
    compare("search-german", |desk| {
        desk.state_mut().view.language = Language::German;
        let wanted = "eb".to_owned();
        desk.state_mut().view.dialog = Some(Dialog::Find(Search { wanted, chosen: 1 }));
        // The caret blinks: it never settles.
        desk.run_steps(4);
    });
}

#[test]
fn a_light_at_the_pointer() {
    compare("spotlight", |desk| {
        desk.go_to(&At::Nth(6, "First"));
        desk.tap(Key::S);
        desk.event(Input::PointerMoved(pos2(560.0, 330.0)));
        desk.run();
    });
}

#[test]
fn space_in_light_colours() {
    compare("window-space-light", |desk| {
        desk.open(sample("knot.octo"));
        desk.go_to(&At::Nth(16, "First"));
    });
}

#[test]
fn space_in_dark_colours() {
    compare("window-space-dark", |desk| {
        desk.open_scenario(&built_in("sphere-grid").unwrap());
        desk.state_mut().view.theme = Theme::Dark;
        desk.go_to(&At::Share(0.55));
    });
}

#[test]
fn the_export_of_a_figure() {
    compare("export", |desk| {
        desk.go_to(&At::Nth(12, "First"));
        desk.state_mut().view.export.file = FIGURE.to_owned();
        desk.press_with(Modifiers::COMMAND, Key::E);
        let context = desk.ctx.clone();
        desk.state_mut().finish_preview(&context);
        desk.run();
    });
}

#[test]
fn the_lecture() {
    compare("window-lecture", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Lecture;
        desk.go_to(&At::Nth(7, "First"));
    });
}

#[test]
fn the_preset_of_bits() {
    compare("preset-bits", |desk| {
        desk.open_scenario(&plane("quadtree-82", |scenario| {
            scenario.query = asked(Algorithm::Codes);
        }));
        desk.state_mut().view.preset = Preset::Bits;
        desk.go_to(&At::Nth(5, "Target"));
    });
}

#[test]
fn the_preset_of_the_t_rail() {
    compare("preset-rail", |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.go_to(&At::Nth(4, "First"));
    });
}

#[test]
fn the_preset_of_the_automaton() {
    compare("preset-automaton", |desk| {
        desk.open_scenario(&built_in("figure-7").unwrap());
        desk.state_mut().view.preset = Preset::Automaton;
        desk.go_to(&At::Nth(1, "Step"));
    });
}

#[test]
fn the_preset_for_debugging() {
    compare("preset-debug", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Debug;
        desk.go_to(&At::Nth(5, "Step"));
    });
}

#[test]
fn the_preset_to_compare() {
    compare("preset-compare", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Compare;
        desk.press(Key::End);
    });
}

#[test]
fn a_region_and_its_bits() {
    compare("panel-region", |desk| {
        desk.open_scenario(&plane("quadtree-82", |scenario| {
            scenario.query =
                Query::Region { min: [0.52, 0.66], max: [0.68, 0.72], variants: Variants::NONE };
        }));
        desk.state_mut().view.preset = Preset::Bits;
        desk.press(Key::End);
    });
}

#[test]
fn a_neighbour_and_its_bits() {
    compare("panel-neighbour", |desk| {
        desk.open_scenario(&plane("quadtree-82", |scenario| {
            let direction = Direction::new([1, 0]).unwrap();
            let (level, code) = (1, [14, 22]);
            scenario.query = Query::Neighbour {
                level,
                code,
                direction,
                reach: Reach::Leaf,
                method: NeighbourMethod::Codes,
                variants: Variants::NONE,
            };
        }));
        desk.state_mut().view.preset = Preset::Bits;
        desk.press(Key::End);
    });
}

#[test]
fn a_side_that_is_pointed_at() {
    compare("hover-side", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.press(Key::End);
        desk.point_at(desk.place([0.756, 0.4]));
    });
}

#[test]
fn the_window_in_german() {
    compare("german", |desk| {
        desk.open_scenario(&plane("rings", |_| ()));
        desk.state_mut().view.language = Language::German;
        desk.go_to(&At::Share(0.5));
    });
}

#[test]
fn a_small_window_with_the_largest_type() {
    compare_sized("small-large-type", [1024.0, 768.0], |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.scale = View::SCALES[1];
        desk.go_to(&At::Nth(6, "First"));
    });
}

#[test]
fn a_small_window_with_the_largest_type_in_german_and_dark() {
    compare_sized("small-large-type-german", [1024.0, 768.0], |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.state_mut().view.scale = View::SCALES[1];
        desk.state_mut().view.language = Language::German;
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.preset = Preset::Automaton;
        desk.go_to(&At::Nth(4, "First"));
    });
}

#[test]
fn debugging_in_german_and_dark() {
    compare("debug-german-dark", |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.state_mut().view.language = Language::German;
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.preset = Preset::Debug;
        desk.go_to(&At::Nth(9, "Step"));
    });
}

#[test]
fn a_lecture_in_space() {
    compare("lecture-space-dark", |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.preset = Preset::Lecture;
        desk.go_to(&At::Nth(4, "First"));
    });
}

#[test]
fn the_paper_lab() {
    compare("paper-lab", |desk| {
        desk.open_scenario(&counterexample(Variant::B3));
        desk.press(Key::End);
    });
}

#[test]
fn the_menu_of_algorithms() {
    compare("algorithm-menu", |desk| {
        desk.open_scenario(&plane("quadtree-82", |scenario| {
            scenario.query = asked(Algorithm::Bsp);
        }));
        desk.press(Key::Home);
        let menu = desk.get_all_by_role(Role::ComboBox).last().unwrap();
        menu.click();
        desk.run();
    });
}

#[test]
fn the_tables_of_all_directions() {
    compare("algorithm-tables", |desk| {
        let mut scenario = built_in("points-3d").unwrap();
        if let AnyScenario::Octree(scenario) = &mut scenario {
            scenario.query = asked(Algorithm::Samet);
        }
        desk.open_scenario(&scenario);
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.preset = Preset::Automaton;
        desk.state_mut().view.language = Language::German;
        desk.go_to(&At::Nth(4, "Parent"));
        desk.get_by_label("Alle Richtungen").click();
        desk.run();
    });
}

#[test]
fn the_preset_of_the_tree() {
    compare("preset-tree", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Tree;
        desk.go_to(&At::Nth(5, "Step"));
    });
}

#[test]
fn the_tree_in_space_in_dark_colours_and_german() {
    compare("tree-space-german-dark", |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.state_mut().view.theme = Theme::Dark;
        desk.state_mut().view.language = Language::German;
        desk.state_mut().view.preset = Preset::Tree;
        desk.go_to(&At::Nth(9, "Step"));
    });
}

#[test]
fn a_child_that_is_ruled_out_tells_why() {
    compare("hover-why-not", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Tree;
        desk.go_to(&At::Nth(17, "First"));
        let place = desk.place([0.8, 0.55]);
        desk.hover_at(place - vec2(3.0, 3.0));
        desk.step();
        desk.hover_at(place);
        desk.run();
    });
}

#[test]
fn the_tree_in_a_small_window_with_the_largest_type() {
    compare_sized("small-large-type-tree", [1024.0, 768.0], |desk| {
        desk.open_scenario(&built_in("points-3d").unwrap());
        desk.state_mut().view.scale = View::SCALES[1];
        desk.state_mut().view.preset = Preset::Tree;
        desk.go_to(&At::Nth(9, "Step"));
    });
}

#[test]
fn a_map_of_all_lines_of_the_plane() {
    compare("panel-map", |desk| {
        desk.open_scenario(&plane("quadtree-82", |_| ()));
        desk.state_mut().view.preset = Preset::Map;
        desk.finish_maps();
    });
}

#[test]
fn a_picture_of_costs_in_dark_colours_and_german() {
    compare("panel-map-space-german-dark", |desk| {
        desk.open_scenario(&built_in("sphere-grid").unwrap());
        let view = &mut desk.state_mut().view;
        view.map = MapView { rays: RaysOf::Picture, colouring: Colouring::Comparisons };
        view.preset = Preset::Map;
        (view.theme, view.language) = (Theme::Dark, Language::German);
        desk.finish_maps();
    });
}
