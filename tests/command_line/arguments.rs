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
