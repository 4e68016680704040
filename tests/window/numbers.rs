//! Numbers that are typed into fields.

use crate::desk::Desk;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use octoscope::document::AnyDocument;
use octoscope::text::texts;
use octoscope_core::geometry::Ray;
use octoscope_core::text::Language;

#[test]
fn numbers_are_typed_as_decimals_fractions_and_hexadecimal_floats() {
    let mut desk = Desk::new();
    for (text, value) in [("0.25", 0.25), ("3/8", 0.375), ("0x1.8p-1", 0.75)] {
        desk.type_into("origin y", text);
        assert_eq!(desk.plane().scenario.ray.origin()[1], value, "{text}");
    }
    desk.type_into("origin y", "nonsense");
    assert_eq!(desk.plane().scenario.ray.origin()[1], 0.75);
}

#[test]
fn what_is_no_number_is_refused_with_what_would_be_one() {
    let mut desk = Desk::new();
    for (typed, said) in [
        ("nonsense", "“nonsense” is no number"),
        ("inf", "“inf” is no number"),
        ("1/0", "“1/0” is no number"),
        (" ", "A number is missing"),
    ] {
        let ray = desk.plane().scenario.ray;
        desk.type_into("origin y", typed);
        assert!(desk.says(said), "{typed}: {:?}", desk.texts());
        assert!(desk.says("3/4"), "{typed}");
        assert_eq!(desk.plane().scenario.ray, ray);
        desk.type_into("origin y", "0.5");
        assert!(!desk.says(said), "{typed} is not the last word");
        desk.type_into("origin y", "0.25");
    }
}

#[test]
fn what_is_no_number_stays_in_its_field_until_it_is_mended_given_up_or_left() {
    let mut desk = Desk::new();
    let before = desk.plane().scenario.ray.origin();
    let shown = |desk: &Desk| {
        let field = desk.get_by_role_and_label(Role::SpinButton, "origin y");
        field.accesskit_node().value().unwrap_or_default()
    };
    let said = |desk: &Desk| {
        let is_whole = |text: &String| text.starts_with("“0.5x”") && text.ends_with("back.");
        desk.texts().iter().any(is_whole)
    };
    desk.type_into("origin y", "0.5x");
    assert_eq!(desk.plane().scenario.ray.origin(), before);
    assert_eq!(shown(&desk), "0.5x");
    assert!(said(&desk), "{:?}", desk.texts());
    // Confirmed by Enter it is edited on.
    desk.press(Key::Backspace);
    assert_eq!((desk.plane().scenario.ray.origin()[1], said(&desk)), (0.5, false));
    desk.press(Key::Enter);

    desk.type_into("origin y", "up");
    desk.press(Key::Tab);
    assert_eq!(shown(&desk), "0.5", "left by Tab");
    assert!(desk.says("“up” is no number") && desk.says("0.5 holds again"), "{:?}", desk.texts());
    desk.type_into("origin y", "up");
    assert_eq!(shown(&desk), "up");
    desk.click(Role::SpinButton, "origin x");
    assert_eq!(shown(&desk), "0.5", "left by a click");
    desk.type_into("origin y", "up");
    desk.press(Key::Escape);
    assert_eq!((shown(&desk).as_str(), desk.plane().scenario.ray.origin()[1]), ("0.5", 0.5));

    desk.type_into("origin y", "up");
    // What has changed otherwise is shown.
    let AnyDocument::Plane(document) = desk.state_mut().document_mut() else { panic!() };
    document.scenario.ray = Ray::new(before, [1.0, 0.5]).unwrap();
    desk.run();
    assert_eq!(shown(&desk), octoscope_core::explain::number(before[1]));
}

#[test]
fn what_is_refused_or_given_up_gives_back_the_number_that_was_there_before() {
    for end in [Key::Tab, Key::Escape] {
        let mut desk = Desk::new();
        let before = desk.plane().scenario.ray;
        desk.click(Role::SpinButton, "origin y");
        for typed in "1e400".chars() {
            desk.event(eframe::egui::Event::Text(typed.to_string()));
            desk.run();
        }
        // Everything follows what is typed as long as it is a number.
        assert_eq!(desk.plane().scenario.ray.origin()[1], 1e40);
        desk.press(end);
        assert_eq!(desk.plane().scenario.ray, before, "{end:?}");
        let holds = octoscope_core::explain::number(before.origin()[1]);
        let is_said = desk.says(&format!("{holds} holds again"));
        assert_eq!(is_said, end == Key::Tab, "{:?}", desk.texts());
    }
}

#[test]
fn what_is_wrong_in_a_field_covers_neither_a_field_nor_the_picture() {
    let mut desk = Desk::new();
    let picture = texts(Language::English).get("space-name");
    let picture = desk.get_by_role_and_label(Role::Canvas, &picture).rect();
    for name in ["origin x", "direction y", "depth"] {
        desk.type_into(name, "up");
        let said = desk.get_by_label_contains("“up” is no").rect();
        assert!(!picture.intersects(said), "{name}: {said} over the picture");
        for field in desk.get_all_by_role(Role::SpinButton) {
            assert!(!field.rect().intersects(said), "{name}: {said} over {}", field.rect());
        }
        desk.press(Key::Escape);
    }
}

#[test]
fn the_numbers_of_the_ray_have_fields_of_one_width() {
    for (language, size) in
        [Language::English, Language::German].into_iter().zip([[1280.0, 800.0], [1024.0, 768.0]])
    {
        let mut desk = Desk::of(Harness::builder(), size);
        desk.state_mut().view.language = language;
        desk.run();
        let of_ray = ["ray-origin", "ray-direction"].map(|key| texts(language).get(key));
        let widths = of_ray.map(|name| {
            desk.get_by_role_and_label(Role::SpinButton, &format!("{name} x")).rect().width()
        });
        assert!((widths[0] - widths[1]).abs() < 1.0, "{language:?}: {widths:?}");
    }
}

#[test]
fn fields_keep_their_width_whatever_number_is_typed() {
    let mut desk = Desk::new();
    let rects = |desk: &Desk| {
        ["origin x", "origin y", "direction x", "direction y"]
            .map(|name| desk.get_by_role_and_label(Role::SpinButton, name).rect())
            .map(|rect| [rect.left(), rect.right(), rect.top().round()])
    };
    let before = rects(&desk);
    for typed in ["1/3", "-1e-300", "123456789012345", "-1.2345678901234567e-300"] {
        desk.click(Role::SpinButton, "origin x");
        desk.event(eframe::egui::Event::Text(typed.to_owned()));
        desk.run();
        assert_eq!(rects(&desk), before, "{typed} while it is typed");
        desk.press(Key::Enter);
        assert_eq!(rects(&desk), before, "{typed}");
    }
    assert_eq!(desk.plane().scenario.ray.origin()[0], -1.234_567_890_123_456_7e-300);
}
