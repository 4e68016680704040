//! Errors, in the language of the window.

use crate::desk::Desk;
use eframe::egui::Key;
use octoscope::complaint::told;
use octoscope::kept_view::{kept_eye, kept_show};
use octoscope::open::open;
use octoscope::text::texts;
use octoscope_core::progress::Progress;
use octoscope_core::scenario::{AnyScenario, View, built_in};
use octoscope_core::text::Language;
use octoscope_figure::views::{ExerciseError, FigureView, ViewError};
use octoscope_import::import;
use serde_json::json;
use std::fs;

#[test]
fn errors_of_files_are_told_in_both_languages_with_the_path_at_their_end() {
    let folder = tempfile::tempdir().unwrap();
    let picture = include_bytes!("../../assets/scenes/landscape.png");
    let photograph = include_bytes!("../../assets/scenes/spheres.jpg");
    let data = br#"{"octoscope": 1, "dimension": 2, "scene": {"file": "missing.png"}}"#;
    let cases: [(&str, &[u8], &str, &str); 10] = [
        ("empty.png", b"", "is empty", "ist leer"),
        ("some.kind", b"?", ".svg, .pdf, .png or .tex", ".svg, .pdf, .png oder .tex"),
        ("other.svg", b"<svg/>", "no scenario inside", "kein Szenario"),
        ("mesh.png", b"v 0 0 0\nv 1 0 0\n", "holds", "darin ist"),
        ("cut.png", &picture[..999], "damaged", "beschädigt"),
        ("hole.obj", b"v 0 0 0\nf 1 2 3\n", "line 2", "Zeile 2"),
        ("cut.jpg", &photograph[..9999], "ends too early", "endet zu früh"),
        ("bad.octo", b"{", "line 1", "Zeile 1"),
        ("new.octo", br#"{"octoscope": 9}"#, "version 9", "Fassung 9"),
        ("data.octo", data, "data file", "Datendatei"),
    ];
    for (name, bytes, english, german) in cases {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        let error = open(&path, &Progress::default()).unwrap_err();
        for (language, fact) in [(Language::English, english), (Language::German, german)] {
            let told = told(&texts(language), &error);
            assert!(told.contains(fact), "{name}: {told}");
            let last = if name == "data.octo" { "missing.png" } else { name };
            assert!(told.contains(&format!(": {}", folder.path().display())), "{told}");
            assert!(told.contains(last), "{told}");
        }
    }
    let missing = open(&folder.path().join("none"), &Progress::default()).unwrap_err();
    let german = told(&texts(Language::German), &missing);
    assert!(german.starts_with("Es gibt keine solche Datei"), "{german}");
}

#[test]
fn what_is_wrong_with_a_scenario_is_told_in_german_too() {
    let scene = |fields: &str| format!(r#"{{"octoscope": 1, "dimension": 2, "scene": {fields}}}"#);
    let built_in =
        |fields: &str| format!(r#"{{"octoscope": 1, "scene": {{"built-in": "rings"}}, {fields}}}"#);
    let cases = [
        ("[1]".to_owned(), "kein Szenario"),
        (r#"{"octoscope": 0}"#.to_owned(), "Fassung 0"),
        (r#"{"octoscope": 1, "dimension": 4, "scene": {"points": []}}"#.to_owned(), "ist 4"),
        (r#"{"octoscope": 1, "scene": {"points": []}}"#.to_owned(), "„dimension“ fehlt"),
        (scene("{}"), "0 Arten von Inhalt"),
        (scene(r#"{"points": [], "hash": ""}"#), "nur zu „file“"),
        (scene(r#"{"image": {"width": 2, "height": 1, "rows": ["0"]}}"#), "Zeile 1 des Bilds"),
        (scene(r#"{"image": {"width": 0, "height": 1, "rows": [""]}}"#), "keine Pixel"),
        (scene(r#"{"spheres": [{"centre": [0, 0], "radius": -1}]}"#), "negative Größe"),
        (scene(r#"{"built-in": "fog"}"#), "„fog“ gibt es nicht"),
        (scene(r#"{"built-in": "rings", "parameters": {"seed": 1}}"#), "Parameter „seed“"),
        (scene(r#"{"built-in": "rings", "parameters": {"n": 0}}"#), "von 1 bis 4096"),
        (scene(r#"{"built-in": "cloud"}"#), "hat 3 Dimensionen"),
        (built_in(r#""build": {"depth": 21}"#), "von 0 bis 20"),
        (built_in(r#""build": {"capacity": 0}"#), "Kapazität"),
        (built_in(r#""ray": {"origin": [0, 0], "direction": [0, 0]}"#), "ist null"),
        (built_in(r#""domain": {"min": [0, 0], "side": 0}"#), "endliche Ecken"),
        (built_in(r#""raay": 1"#), "Ein Feld „raay“ gibt es hier nicht; schreiben Sie „ray“ oder"),
        (
            built_in(r#""build": {"depth": "x"}"#),
            "„build.depth“ ist \"x\"; schreiben Sie eine ganze",
        ),
        (built_in(r#""ray": {"origin": [0, 0]}"#), "„direction“ fehlt; schreiben Sie 2 Zahlen"),
        (built_in(r#""query": "tree""#), "„query“ ist \"tree\"; es gibt ray"),
        ("{\"octoscope\": 1".to_owned(), "endet innerhalb eines Objekts; schließen Sie es mit }"),
        ("{\"octoscope\": 1,}".to_owned(), "Vor der schließenden Klammer steht ein Komma"),
        (scene("{\"points\": [[0, 0] [1, 1]]}"), "Vor [1, 1]]}} fehlt ein Komma oder eine ]"),
        (scene("{\"points\": [[0, nan]]}"), "nan ist kein Wert; schreiben Sie eine endliche Zahl"),
    ];
    let texts = texts(Language::German);
    for (text, fact) in cases {
        let error = AnyScenario::parse(&text).expect_err(&text).into();
        let told = told(&texts, &error);
        assert!(told.starts_with("Zeile 1, Spalte ") && told.contains(fact), "{text}: {told}");
        assert!(!told.contains("Englisch"), "{told}");
    }
}

#[test]
fn what_is_wrong_inside_an_imported_file_is_told_in_german_too() {
    let ply = |lines: &str| format!("ply\nformat ascii 1.0\n{lines}\nend_header\n");
    let cases = [
        ("a.xyz", "1\n".to_owned(), "Zeile 1, Spalte 2: Die Zeile hat eine Spalte"),
        ("a.xyz", "1 2 3\n1 2 x\n".to_owned(), "Spalte 5: „x“ ist keine Zahl"),
        ("a.csv", "x,y\n1,2,3\n".to_owned(), "Die Zeile hat 3 Spalten, die erste hat 2"),
        ("a.obj", "v 0 0 0\nf 1 2 3\n".to_owned(), "Die Ecke 2 steht nicht darüber"),
        ("a.obj", "v 0 0\n".to_owned(), "Die Ecke hat zu wenige Koordinaten"),
        ("a.stl", "solid a\nvertexx\n".to_owned(), "„vertexx“ ist kein Wort von STL"),
        ("a.ply", ply("element vertex x"), "„x“ ist keine Anzahl von Zeilen"),
        ("a.ply", ply("element vertex 1"), "Ein Element mit Zeilen hat keine Eigenschaften"),
    ];
    let texts = texts(Language::German);
    for (name, text, fact) in cases {
        let error = import(name, text.as_bytes(), &Progress::default()).unwrap_err();
        let told = told(&texts, &error.into());
        assert!(told.contains(fact) && !told.contains("Englisch"), "{name} {text}: {told}");
    }
}

#[test]
fn the_command_line_tells_errors_as_before() {
    let missing = open(std::path::Path::new("no/such.file"), &Progress::default());
    let message = format!("{:#}", missing.unwrap_err());
    assert_eq!(message, "there is no such file or folder: no/such.file");
}

#[test]
fn why_there_is_nothing_to_see_is_told_in_german_too() {
    let texts = texts(Language::German);
    let of_view = |name: &str, value: serde_json::Value| {
        let mut view = View::new();
        view.insert(name.to_owned(), value);
        let error = kept_show(&view).err().or_else(|| kept_eye::<3>(&view).err());
        told(&texts, &error.expect(name).into())
    };
    for (field, value, fact) in [
        (
            "show",
            json!(3),
            "Feld „show“ in „view“ des Szenarios lässt sich nicht lesen: es ist kein",
        ),
        ("show", json!("fog"), "„fog“ gibt es nicht zu zeigen; es gibt order-numbers, "),
        ("show", json!("fog=1"), "„fog“ gibt es nicht einzustellen"),
        ("show", json!("levels=5-2"), "Stufen „5-2“ gibt es nicht"),
        ("show", json!("rest=no"), "der Rest kann nicht „no“ sein; er kann "),
        ("show", json!("slice=w:0"), "einen Schnitt bei „w:0“ gibt es nicht"),
        ("show", json!("apart=-1"), "nicht um „-1“ auseinander sein; geben Sie 0 bis "),
        (
            "camera",
            json!(3),
            "Feld „camera“ in „view“ des Szenarios lässt sich nicht lesen: es ist",
        ),
        ("camera", json!("above"), "schreiben Sie Zahlen wie -30,20,1.5"),
        ("camera", json!("1,2"), "es sind 2 Zahlen; geben Sie drei an"),
        ("camera", json!("1,99,1"), "die Höhe ist 99; geben"),
        ("camera", json!("1,2,0"), "die Vergrößerung ist 0; geben"),
        ("camera", json!("1,2,1,0,0"), "seine Mitte hat 2 Zahlen; geben Sie 3 an"),
    ] {
        let told = of_view(field, value);
        assert!(told.contains(fact), "{told}");
    }
    let view = FigureView::Automaton;
    let (shows, asked, remedy) = ("", String::new(), "");
    for (error, fact) in [
        (ViewError::Query { view, shows, asked, remedy }, "„Automat“ hat zu dieser Frage nichts"),
        (
            ViewError::Step { view, step: 0, first: 3 },
            "nach Schritt 0 nichts zu zeigen, aber nach Schritt 3",
        ),
        (ViewError::Never { view }, "in keinem Schritt dieses Laufs"),
    ] {
        let told = told(&texts, &error.into());
        assert!(told.contains(fact), "{told}");
    }
    for (error, fact) in [
        (ExerciseError::Missed, "verfehlt den Baum"),
        (ExerciseError::TooLong(20), "betritt 20 innere Knoten"),
        (ExerciseError::NoRay, "Keinem Strahl"),
    ] {
        let told = told(&texts, &error.into());
        assert!(told.contains(fact), "{told}");
    }
}

#[test]
fn the_dialog_of_exports_says_in_german_why_a_view_is_empty() {
    let mut desk = Desk::new();
    desk.state_mut().view.language = Language::German;
    desk.state_mut().view.export.set_view(FigureView::TRail);
    desk.press(Key::Home);
    desk.open_export();
    let told = "Die Ansicht „t-Leiste“ hat nach Schritt 0 nichts zu zeigen";
    assert!(desk.says(told), "{:?}", desk.texts());
}

#[test]
fn what_a_scenario_shows_by_a_wrong_name_is_complained_about_in_german() {
    let mut desk = Desk::new();
    desk.state_mut().view.language = Language::German;
    desk.run();
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("quadtree-82") else { panic!() };
    scenario.view.insert("show".to_owned(), "fog".into());
    desk.open_scenario(&AnyScenario::Quadtree(scenario));
    assert!(desk.says("„fog“ gibt es nicht zu zeigen"), "{:?}", desk.texts());
}
