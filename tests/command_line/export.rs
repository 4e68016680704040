//! `octoscope export`.

use crate::desk::desk_with_scenario;
use octoscope_core::scenario::AnyScenario;
use std::fs;

#[test]
fn an_exported_svg_is_well_formed_and_opens_as_the_scenario_again() {
    let desk = desk_with_scenario();
    for (step, position) in [("", 3), ("--step first", 0), ("--step 7", 7)] {
        desk.prints(&format!("export a.octo --view space --format svg -o a.svg {step}"));
        let svg = fs::read_to_string(desk.0.path().join("a.svg")).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let inside = document.descendants().find(|node| node.has_tag_name("metadata")).unwrap();
        let scenario = AnyScenario::parse(inside.text().unwrap()).unwrap();
        let AnyScenario::Quadtree(scenario) = scenario else { panic!("not a quadtree") };
        assert_eq!(scenario.step.position(1000), position, "{step}");
        assert_eq!(scenario.recipe.depth, 4);
    }
}

#[test]
fn equal_exports_have_equal_bytes() {
    let desk = desk_with_scenario();
    for figure in [
        "a.octo --step last",
        "a.octo --view tree --step last",
        "scene:figure-7 --camera -30,20,1.2 --theme dark",
    ] {
        for format in ["svg", "png"] {
            let [a, b] = ["a", "b"].map(|name| {
                desk.prints(&format!("export {figure} --format {format} -o {name}"));
                fs::read(desk.0.path().join(name)).unwrap()
            });
            assert!(a == b && a.len() > 1000, "{figure} {format}");
        }
    }
}

#[test]
fn the_tree_is_exported_as_a_diagram_with_its_text_as_text() {
    let desk = desk_with_scenario();
    desk.prints("export scene:points-3d --view tree --step 46 -o tree.svg");
    let svg = fs::read_to_string(desk.0.path().join("tree.svg")).unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let of_class = |class: &str| -> Vec<String> {
        let shapes = document.descendants().filter(|node| node.attribute("class") == Some(class));
        shapes.map(|node| node.text().unwrap_or_default().to_owned()).collect()
    };
    let levels: Vec<String> = of_class("level").into_iter().filter(|n| !n.is_empty()).collect();
    assert_eq!(levels, ["5", "4", "3", "2"]);
    let numbers = of_class("order-number");
    assert!((1..=6).all(|n| numbers.contains(&n.to_string())), "{numbers:?}");
    assert_eq!(of_class("current").len(), 1);
    assert_eq!(of_class("rejected edge").len(), 7);
}

#[test]
fn an_exported_png_has_the_size_asked_for() {
    let desk = desk_with_scenario();
    for (arguments, size) in [
        ("a.octo --size 320x200", [320, 200]),
        ("a.octo --size 320x200 --scale 2", [640, 400]),
        ("scene:figure-7 --size 101x333 --theme print", [101, 333]),
        ("a.octo --view tree --size 200x150", [200, 150]),
    ] {
        desk.prints(&format!("export {arguments} --step last -o a.png"));
        let png = fs::read(desk.0.path().join("a.png")).unwrap();
        assert!(png.starts_with(b"\x89PNG"));
        let length = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!([length(16), length(20)], size, "{arguments}");
    }
}

#[test]
fn every_view_is_a_well_formed_svg_with_the_scenario_inside() {
    let desk = desk_with_scenario();
    for arguments in [
        "a.octo --view t-rail --step 3",
        "a.octo --view automaton --step 7",
        "a.octo --view codes --step 5 --lang de",
        "a.octo --view neighbour --algorithm codes --step last",
        "a.octo --view listing --step 5",
        "a.octo --view table --step last",
        "a.octo --view chart --step last --size 300x300",
        "a.octo --view storyboard --steps leaves:3",
        "scene:figure-7 --view storyboard --steps 1,5,9,13 --lang de",
        "scene:figure-7 --view automaton --step 7",
        "scene:figure-1 --view worksheet --seed 4",
    ] {
        desk.prints(&format!("export {arguments} -o a.svg"));
        let svg = fs::read_to_string(desk.0.path().join("a.svg")).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let n_texts = document.descendants().filter(|node| node.has_tag_name("text")).count();
        assert!(n_texts > 4, "{arguments}: {n_texts} texts");
        let inside = document.descendants().find(|node| node.has_tag_name("metadata")).unwrap();
        AnyScenario::parse(inside.text().unwrap()).unwrap();
    }
}

#[test]
fn every_exercise_has_another_ray_and_its_own_solution() {
    let desk = desk_with_scenario();
    let sheet = |arguments: &str| {
        desk.prints(&format!("export scene:figure-1 --view worksheet {arguments} -o a.svg"));
        fs::read_to_string(desk.0.path().join("a.svg")).unwrap()
    };
    assert_eq!(sheet("--seed 4"), sheet("--seed 4"));
    assert_ne!(sheet("--seed 4"), sheet("--seed 5"));
    let solution = sheet("--seed 4 --solution");
    assert!(solution.len() > sheet("--seed 4").len() + 1000);
    assert!(solution.contains("Solution 4") && sheet("--seed 4 --lang de").contains("Aufgabe 4"));
}

#[test]
fn export_refuses_what_it_cannot_draw_with_what_it_can() {
    let desk = desk_with_scenario();
    for (arguments, known) in [
        ("a.octo --view nothing", "automaton"),
        ("a.octo --view region", "query is ‘region’"),
        ("a.octo --view neighbour", "--algorithm codes"),
        ("a.octo --view t-rail --step 0", "it has after step 1"),
        ("a.octo --view storyboard --steps even", "even:N"),
        ("a.octo --view storyboard --steps 3,99999", "there is no step 99999"),
        ("a.octo --format pdf", "svg and png"),
        ("a.octo --step all", "first or last"),
        ("a.octo --step 99999", "from 0 to "),
        ("a.octo --size 320", "1280x720"),
        ("a.octo --size 0x20", "1280x720"),
        ("a.octo --scale 0", "factor"),
        ("a.octo --theme red", "projector"),
        ("a.octo --camera 1,2", "yaw and pitch"),
        ("a.octo --lang fr", "en and de"),
        ("none.octo", "no such file"),
        ("cut.octo", "line "),
        ("scene:none", "quadtree-82"),
    ] {
        let message = desk.refuses(&format!("export {arguments} -o out.svg"));
        assert!(message.contains(known), "{arguments}: {message}");
        assert!(!desk.0.path().join("out.svg").exists(), "{arguments}");
    }
    assert!(desk.refuses("export a.octo -o out").contains("--format"));
}
