//! The bench lab, as its users meet it.

use crate::desk::Desk;
use crate::states::show_lab;
use eframe::egui::{Id, Key, Modifiers, Shape, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::lab::{Choice, Tab};
use octoscope::text::texts;
use octoscope::view::Dialog;
use octoscope_core::measure::Quantity;
use octoscope_core::text::Language;

/// The lab, about to measure a little.
fn lab() -> Desk {
    let mut desk = Desk::new();
    desk.press_with(Modifiers::COMMAND, Key::B);
    assert_eq!(desk.state().view.dialog, Some(Dialog::Lab));
    let choice = &mut desk.state_mut().view.lab;
    (choice.depths, choice.n_rays, choice.n_repeats) = ([3, 4], 20, 2);
    desk.run();
    desk
}

fn measure(desk: &mut Desk) {
    desk.get_by_role_and_label(Role::Button, "Measure").click();
    desk.step();
    desk.state_mut().finish_measuring();
    desk.run();
}

/// What a reader that cannot see the chart is told.
fn told(desk: &Desk) -> String {
    desk.get_by_role(Role::Image).accesskit_node().label().unwrap_or_default()
}

#[test]
fn in_a_small_window_nothing_of_the_lab_lies_beyond_it() {
    for language in Language::ALL {
        let mut desk = Desk::of(Harness::builder(), [500.0, 400.0]);
        desk.state_mut().view.language = language;
        for tab in Tab::ALL {
            show_lab(&mut desk, tab, Quantity::Comparisons);
            let window = desk.ctx.content_rect();
            let shown = desk.ctx.memory(|memory| memory.area_rect(Id::unique("lab")));
            assert!(window.contains_rect(shown.unwrap()), "{language:?} {tab:?}: {shown:?}");
            for key in ["dialog-close", "lab-run"] {
                let name = texts(language).get(key);
                let button = desk.get_by_role_and_label(Role::Button, &name).rect();
                assert!(window.contains_rect(button), "{language:?} {tab:?} {name}: {button}");
            }
            // What goes on beyond is scrolled to.
            let n_cut = desk.output().shapes.iter().filter(|of| {
                let seen = of.clip_rect.intersect(of.shape.visual_bounding_rect());
                matches!(of.shape, Shape::Text(_))
                    && seen.is_positive()
                    && !window.contains_rect(seen)
            });
            assert_eq!(n_cut.count(), 0, "{language:?} {tab:?}");
        }
    }
}

#[test]
fn a_field_says_which_numbers_it_takes() {
    let mut desk = Desk::new();
    desk.state_mut().view.dialog = Some(Dialog::Lab);
    desk.run();
    let rays = desk.state().view.lab.n_rays;
    for typed in ["many", "0", "12.5", "99999999999"] {
        desk.type_into("Rays", typed);
        let said = format!("“{typed}” is no whole number from 1 to");
        assert!(desk.says(&said), "{typed}: {:?}", desk.texts());
        assert_eq!(desk.state().view.lab.n_rays, rays, "{typed}");
        desk.press(Key::Escape);
        assert_eq!(desk.state().view.dialog, Some(Dialog::Lab), "the field is given up alone");
    }
    desk.type_into("Rays", "12");
    assert_eq!(desk.state().view.lab.n_rays, 12);
}

#[test]
fn algorithms_are_measured_and_shown_as_bars_lines_and_numbers() {
    let mut desk = lab();
    assert_eq!(told(&desk), "Nothing is measured yet: choose at the left, and press Measure.");
    measure(&mut desk);
    let bars = told(&desk);
    for part in
        ["Time a ray", "Cloud of 1890 spheres", "512 spheres", "SametNet (reconstructed)", "1.00"]
    {
        assert!(bars.contains(part), "{part}: {bars}");
    }
    desk.click(Role::Button, "Growth");
    assert!(told(&desk).contains("leaves of the tree"));
    desk.click(Role::Button, "Published");
    assert!(told(&desk).contains("published statements were measured"), "{}", told(&desk));
    desk.click(Role::Button, "Table");
    for part in ["µs/ray", "± %", "divisions", "Samet: neighbour tables"] {
        assert!(told(&desk).contains(part), "{part}: {}", told(&desk));
    }
    desk.click(Role::Button, "Memory and predictions");
    assert!(told(&desk).contains("predicted wrongly"));
}

#[test]
fn what_was_measured_stays_when_the_lab_is_closed() {
    let mut desk = lab();
    measure(&mut desk);
    let before = told(&desk);
    desk.press(Key::Escape);
    assert_eq!(desk.state().view.dialog, None);
    desk.press_with(Modifiers::COMMAND, Key::B);
    assert_eq!(told(&desk), before);
    desk.click(Role::Button, "Close");
    assert_eq!(desk.state().view.dialog, None);
}

#[test]
fn measuring_can_be_stopped() {
    let mut desk = lab();
    measure(&mut desk);
    let before = told(&desk);
    desk.state_mut().view.lab = Choice { n_rays: 100_000, ..Choice::default() };
    desk.get_by_role_and_label(Role::Button, "Measure").click();
    desk.step();
    desk.step();
    desk.get_by_role_and_label(Role::Button, "Stop").click();
    desk.step();
    desk.step();
    desk.state_mut().finish_measuring();
    desk.run();
    assert!(desk.query_by_role_and_label(Role::Button, "Measure").is_some());
    assert_eq!(told(&desk), before, "nothing came of it, and what was there is kept");
}

#[test]
fn without_a_scene_or_an_algorithm_there_is_nothing_to_measure() {
    let mut desk = lab();
    desk.click(Role::Button, "none");
    assert!(desk.query_by_label_contains("Choose a scene").is_some());
    // Nor to save or to watch.
    desk.click(Role::Button, "Table as CSV");
    assert_eq!(desk.state().view.dialog, Some(Dialog::Lab));
    desk.click(Role::Button, "Memory and predictions");
    assert!(told(&desk).ends_with("Choose an algorithm to watch it on the ray."));
    desk.click(Role::Button, "Chart as SVG");
    assert_eq!(desk.state().view.dialog, Some(Dialog::Lab));
    desk.click(Role::Button, "Scenes");
    desk.get_by_role_and_label(Role::Button, "Measure").click();
    desk.run();
    assert_eq!(told(&desk), "Nothing is measured yet: choose at the left, and press Measure.");
    desk.click(Role::Button, "those of the paper");
    measure(&mut desk);
    assert_ne!(told(&desk), "Nothing is measured yet: choose at the left, and press Measure.");
}

#[test]
fn charts_and_tables_are_saved() {
    let folder = tempfile::tempdir().unwrap();
    let mut desk = lab();
    measure(&mut desk);
    for (name, ending, start) in [
        ("Chart as SVG", "svg", "<svg"),
        ("Chart as TikZ", "tex", "tikzpicture"),
        ("Table as CSV", "csv", "scene,depth"),
        ("Table as Markdown", "md", "| cloud | 3 |"),
    ] {
        desk.click(Role::Button, name);
        // Without a file dialog the path is typed.
        let path = folder.path().join(format!("a.{ending}"));
        let Some(Dialog::Path(typed)) = &mut desk.state_mut().view.dialog else {
            panic!("no path is asked for")
        };
        typed.path = path.to_string_lossy().into_owned();
        desk.run_steps(3);
        desk.get_by_role_and_label(Role::Button, "Export").click();
        desk.run_steps(3);
        let context = desk.ctx.clone();
        desk.state_mut().finish_export(&context);
        assert_eq!(desk.state().view.dialog, Some(Dialog::Lab));
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(start), "{ending}: {text}");
    }
}

#[test]
fn the_lab_speaks_german() {
    let mut desk = lab();
    desk.state_mut().view.language = Language::German;
    desk.state_mut().view.lab.tab = Tab::Processor;
    desk.run();
    assert!(desk.query_by_label("Messlabor").is_some());
    assert!(told(&desk).contains("falsch vorhergesagt"));
}
