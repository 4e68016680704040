//! `octoscope export`.

use crate::desk::{desk_with_scenario, text};
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
fn what_a_figure_has_no_room_for_is_told() {
    let desk = desk_with_scenario();
    let output = desk.run("export a.octo --view table --step last -o a.svg");
    assert_eq!(output.status.code(), Some(0));
    let told = text(&output.stderr);
    assert_eq!(told, "octoscope: the table shows the last 24 of 30 steps\n");
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
        "a.octo --view table --step 20",
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
fn a_table_of_all_steps_is_the_one_of_trace() {
    let desk = desk_with_scenario();
    for (format, ending) in [("markdown", "md"), ("csv", "csv"), ("latex", "tex")] {
        let traced = desk.prints(&format!("trace a.octo --format {format} --lang de"));
        let table = format!("export a.octo --view table --format {format} --lang de");
        desk.prints(&format!("{table} -o a.{ending}"));
        let exported = fs::read_to_string(desk.0.path().join(format!("a.{ending}"))).unwrap();
        assert!(exported == traced && traced.lines().count() > 20, "{format}");
        assert!(desk.refuses(&format!("{table} --step 3")).contains("leave --step out"));
    }
    let message = desk.refuses("export a.octo --format csv");
    assert!(message.contains("--view table"), "{message}");
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
        ("a.octo --view worksheet --seed=-1", "whole number from 0"),
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

#[test]
fn an_exported_figure_opens_again_from_wherever_it_was_written() {
    let desk = desk_with_scenario();
    fs::create_dir(desk.0.path().join("out")).unwrap();
    desk.put("points.csv", "0.1,0.2\n0.15,0.25\n0.8,0.9\n0.4,0.45\n");
    for file in ["a.octo", "points.csv", "scene:figure-7 --ray gallery:corner"] {
        for ending in ["svg", "pdf", "png", "tex"] {
            desk.prints(&format!("export {file} --step 4 -o out/a.{ending}"));
            let checked = desk.prints(&format!("check out/a.{ending}"));
            assert!(!checked.is_empty(), "{file} {ending}");
            // What comes out of it is what went in.
            desk.prints(&format!("export out/a.{ending} -o out/again.{ending}"));
            let [a, b] = ["a", "again"]
                .map(|name| fs::read(desk.0.path().join(format!("out/{name}.{ending}"))).unwrap());
            assert!(a == b, "{file} {ending}");
        }
    }
}

#[test]
fn a_figure_without_a_scenario_is_refused() {
    let desk = desk_with_scenario();
    desk.put("plain.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    desk.put("plain.pdf", "%PDF-1.7\n");
    for name in ["plain.svg", "plain.pdf"] {
        let message = desk.refuses(&format!("trace {name}"));
        assert!(
            message.contains("no scenario inside") && message.trim_end().ends_with(name),
            "{message}"
        );
    }
}

#[test]
fn several_steps_are_pages_pictures_frames_or_files() {
    let desk = desk_with_scenario();
    let read = |name: &str| fs::read(desk.0.path().join(name)).unwrap();
    for format in ["svg", "png"] {
        desk.prints(&format!("export a.octo --step 2-4 -o b.{format}"));
        let sizes: Vec<_> = (2..=4).map(|n| read(&format!("b-00{n}.{format}")).len()).collect();
        assert!(sizes.iter().all(|size| *size > 500), "{sizes:?}");
        assert!(!desk.0.path().join(format!("b.{format}")).exists());
    }
    desk.prints("export a.octo --step 2-4 -o b.tex");
    let text = String::from_utf8(read("b.tex")).unwrap();
    assert_eq!(text.matches("\\begin{tikzpicture}").count(), 3);
    desk.prints("export a.octo --step 2-4 --beamer --snippet -o b.tex");
    let text = String::from_utf8(read("b.tex")).unwrap();
    // A picture and a caption a slide.
    let says = |n: usize| text.contains(&format!("\\only<{n}>{{%\n"));
    assert!((1..=3).all(says) && !says(4));
    let sentences = desk.prints("trace a.octo");
    let captions = text.lines().filter(|line| line.starts_with("\\only<") && !line.ends_with("{%"));
    let plain = |caption: &str| {
        let commands =
            ["\\textcolor{octo-axis-x}", "\\textcolor{octo-axis-y}", "\\textbf", "\\textsubscript"];
        let text = commands.iter().fold(caption.to_owned(), |text, sign| text.replace(sign, ""));
        text.replace(['{', '}', '$'], "")
    };
    let captions: Vec<String> = captions.map(plain).collect();
    for (slide, step) in (2..=4).enumerate() {
        let sentence = sentences.lines().nth(step).unwrap().replace('_', "");
        let sentence = sentence.trim_start_matches([' ', '2', '3', '4']);
        assert_eq!(captions[slide], format!("\\only<{}>{sentence}%", slide + 1));
    }
    assert_eq!(captions.len(), 3);
    desk.prints("export a.octo --step 2-4 -o b.pdf");
    let text = String::from_utf8_lossy(&read("b.pdf")).into_owned();
    assert!(text.contains("/Count 3"));
    // What moves shows all steps.
    let n_steps = desk.prints("trace a.octo").lines().count();
    desk.prints("export a.octo --size 80x60 -o b.gif");
    assert!(read("b.gif").starts_with(b"GIF89a"));
    desk.prints("export a.octo --size 80x60 --format apng -o b.png");
    let file = read("b.png");
    let control = file.windows(4).position(|name| name == b"acTL").unwrap();
    let n_frames = u32::from_be_bytes(*file[control + 4..].first_chunk().unwrap());
    assert_eq!(n_frames as usize, n_steps);
    // As far as there is something to show.
    desk.prints("export a.octo --view t-rail --size 80x60 -o c.gif");
    assert!(read("c.gif").starts_with(b"GIF89a"));
    let message = desk.refuses("export a.octo --step all --format svg");
    assert!(message.contains("-o"), "{message}");
}

#[test]
fn a_size_on_paper_is_kept_in_every_format() {
    let desk = desk_with_scenario();
    let text = |name: &str| {
        String::from_utf8_lossy(&fs::read(desk.0.path().join(name)).unwrap()).into_owned()
    };
    desk.prints("export a.octo --size 127x101.6mm -o a.svg");
    assert!(text("a.svg").contains("width=\"127mm\" height=\"101.6mm\""));
    desk.prints("export a.octo --size 127x101.6mm --type-scale 2 -o a.svg");
    assert!(text("a.svg").contains("width=\"127mm\" height=\"101.6mm\" viewBox=\"0 0 240 192\""));
    desk.prints("export a.octo --size 127x101.6mm -o a.pdf");
    assert!(text("a.pdf").contains("[0 0 360 288]"));
    desk.prints("export a.octo --size 127x101.6mm -o a.tex");
    assert!(text("a.tex").contains("(0,0) rectangle (480,384)"));
}

#[test]
fn axes_of_a_plane_have_their_names_where_there_is_room() {
    let desk = desk_with_scenario();
    let names = |arguments: &str| {
        desk.prints(&format!("export a.octo {arguments} -o a.svg"));
        let svg = fs::read_to_string(desk.0.path().join("a.svg")).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        ["x", "y"].map(|name| {
            let of_axis = |node: &roxmltree::Node| {
                node.attribute("class") == Some(&format!("axis-{name}"))
                    && node.text() == Some(name)
            };
            document.descendants().filter(of_axis).count()
        })
    };
    assert_eq!(names("--step last"), [1, 1]);
    assert_eq!(names("--step last --size 90x80mm"), [1, 1]);
    assert_eq!(names("--step last --size 150x120"), [0, 0]);
}

#[test]
fn what_is_shown_can_be_chosen() {
    let desk = desk_with_scenario();
    let n_texts = |shown: &str| {
        desk.prints(&format!("export a.octo --step last --show {shown} -o a.svg"));
        let svg = fs::read_to_string(desk.0.path().join("a.svg")).unwrap();
        svg.matches("class=\"order-number\"").count()
    };
    assert!(n_texts("order-numbers,content") > 0);
    assert_eq!(n_texts("none"), 0);
    assert!(desk.refuses("export a.octo --show numbers -o b.svg").contains("order-numbers"));
}
