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
    for figure in ["a.octo --step last", "scene:figure-7 --camera -30,20,1.2 --theme dark"] {
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
fn an_exported_png_has_the_size_asked_for() {
    let desk = desk_with_scenario();
    for (arguments, size) in [
        ("a.octo --size 320x200", [320, 200]),
        ("a.octo --size 320x200 --scale 2", [640, 400]),
        ("scene:figure-7 --size 101x333 --theme print", [101, 333]),
    ] {
        desk.prints(&format!("export {arguments} --step last -o a.png"));
        let png = fs::read(desk.0.path().join("a.png")).unwrap();
        assert!(png.starts_with(b"\x89PNG"));
        let length = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!([length(16), length(20)], size, "{arguments}");
    }
}

#[test]
fn export_refuses_what_it_cannot_draw_with_what_it_can() {
    let desk = desk_with_scenario();
    for (arguments, known) in [
        ("a.octo --view automaton", "space"),
        ("a.octo --format jpeg", "svg, pdf, png, tikz, gif, apng"),
        ("a.octo --step none", "first, last, a range"),
        ("a.octo --step 3-2", "backwards"),
        ("a.octo --step 3-99999", "from 0 to "),
        ("a.octo --beamer", "--format tikz"),
        ("a.octo --snippet", "--format tikz"),
        ("a.octo --size 320x200cm", "120x80mm"),
        ("a.octo --size 20000x200", "16384"),
        ("a.octo --pause 0", "seconds"),
        ("a.octo --type-scale 0", "factor"),
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
