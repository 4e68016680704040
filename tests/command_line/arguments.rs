//! Arguments, help and lists.

use crate::desk::{Desk, VISIT};

#[test]
fn bad_arguments_are_refused_with_what_there_is() {
    let desk = Desk::new();
    let message = desk.refuses(&format!("{VISIT} --algorithm fastest"));
    assert!(message.contains("fastest") && message.contains("parametric-table"), "{message}");
    desk.refuses("visit");
    desk.refuses("--no-such");
    desk.refuses(&VISIT.replace("--depth 2", "--depth 21"));
    desk.refuses(&VISIT.replace("--dim 2", "--dim 4"));
    desk.refuses(&format!("{VISIT} --threads 0"));
}

#[test]
fn scenes_lists_scenes_and_algorithms() {
    let desk = Desk::new();
    let list = desk.prints("scenes");
    assert!(list.contains("scene:quadtree-82") && list.contains("parametric-table"), "{list}");
    let json: serde_json::Value = serde_json::from_str(&desk.prints("scenes --json")).unwrap();
    assert_eq!(json["scenes"][0]["id"], "scene:quadtree-82");
}

#[test]
fn help_shows_examples() {
    let desk = Desk::new();
    for command in ["--help", "visit --help", "trace --help", "export --help", "check --help"] {
        assert!(desk.prints(command).contains("Examples:"), "{command}");
    }
}

/// Runs with these arguments are refused with a message that has all `parts`.
#[track_caller]
fn refused(arguments: &str, parts: &[&str]) {
    let message = Desk::new().refuses(arguments);
    for part in parts {
        assert!(message.contains(part), "‘{part}’ is not in: {message}");
    }
    for jargon in ["..=", "digit found", "non-zero", "unexpected argument"] {
        assert!(!message.contains(jargon), "{message}");
    }
}

#[test]
fn numbers_out_of_range_are_refused_with_the_range_and_its_reason() {
    for depth in ["25", "x", "-1", "2.5"] {
        let arguments = VISIT.replace("--depth 2", &format!("--depth {depth}"));
        refused(&arguments, &[depth, "--depth", "from 0 to 20", "20 bits"]);
    }
    for dim in ["4", "x", "-2"] {
        let arguments = VISIT.replace("--dim 2", &format!("--dim {dim}"));
        refused(&arguments, &[dim, "--dim", "2 for a quadtree or 3 for an octree"]);
    }
    for count in ["0", "x", "-1", "1.5"] {
        refused(&format!("{VISIT} --threads {count}"), &["--threads", "from 1 to 1024"]);
        refused(&format!("{VISIT} --summary --repeat {count}"), &["--repeat", "from 1 to "]);
    }
    for (option, bad) in [
        ("step", "-1"),
        ("steps", "-1,3"),
        ("scale", "-2"),
        ("type-scale", "-2x"),
        ("pause", "-1s"),
        ("size", "-5"),
        ("size", "-5mm"),
    ] {
        refused(&format!("export scene:figure-1 --{option} {bad}"), &[option, bad, "give "]);
    }
    refused("bench --depth -1-5", &["--depth", "-1-5"]);
}

#[test]
fn a_misspelt_command_is_told_with_the_commands() {
    for arguments in ["chek", "chek a.octo", "chek --depth 3"] {
        refused(arguments, &["‘chek’", "check", "visit"]);
    }
}

#[test]
fn a_missing_folder_is_named_instead_of_the_file() {
    for command in [VISIT, "trace scene:figure-1", "export scene:figure-1 --format svg"] {
        let message = Desk::new().refuses(&format!("{command} -o no/folder/out"));
        assert!(message.contains("no such folder") && message.contains("create it"), "{message}");
        assert!(message.trim_end().ends_with(": no/folder"), "{message}");
    }
    let message = Desk::new().refuses(&format!("{VISIT} -o a.cells/out"));
    assert!(message.contains("this is a file") && message.contains(": a.cells"), "{message}");
}

#[test]
fn options_of_other_views_and_formats_are_refused() {
    for (options, parts) in [
        ("--seed 3", ["--seed", "‘worksheet’"]),
        ("--solution", ["--solution", "--view worksheet"]),
        ("--steps even:3", ["--steps", "‘storyboard’"]),
        ("--notation seed", ["--notation", "--view formula"]),
        ("--view tree --camera 0,0,1", ["--camera", "‘space’, ‘storyboard’, ‘worksheet’"]),
        ("--view tree --show none", ["--show", "--view space"]),
        ("--view storyboard --step 1-3", ["--step", "‘storyboard’"]),
        ("--pause 1", ["--pause", "GIF and APNG"]),
        ("--beamer", ["--beamer", "TikZ"]),
        ("--view table --format csv --theme print", ["--theme", "CSV"]),
        ("--view table --format latex --size 80mm", ["--size", "LaTeX"]),
    ] {
        let format = if options.contains("--format") { "" } else { "--format svg" };
        let message = format!("export scene:figure-1 {options} {format}");
        refused(&message, &parts);
        refused(&message, &["leave it out"]);
    }
}

#[test]
fn a_name_that_ends_as_another_format_is_refused() {
    refused("export scene:figure-1 --format svg -o a.pdf", &["SVG", "‘.pdf’", "PDF", ".svg"]);
    refused("export scene:figure-1 --format tikz -o a.csv", &["TikZ", "‘.csv’", ".tex"]);
    for arguments in
        ["--format apng -o a.png --step 0-1", "--format tikz -o a.tikz", "--format svg -o a"]
    {
        Desk::new().prints(&format!("export scene:figure-1 {arguments}"));
    }
}

#[test]
fn an_unknown_ending_of_a_figure_is_told() {
    refused("export scene:figure-1 -o a.jpeg", &["‘.jpeg’", "svg, pdf, png", "--format"]);
}
