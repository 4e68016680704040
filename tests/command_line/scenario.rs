//! `octoscope trace` and `octoscope check`.

use crate::desk::{desk_with_scenario, text};
use std::fs;
use std::process::Stdio;

#[test]
fn check_tells_what_files_hold() {
    let desk = desk_with_scenario();
    let report = desk.prints("check a.octo a.xyz scene:figure-7");
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines.len(), 3, "{report}");
    assert!(lines[0].starts_with("a.octo: ok, quadtree, 3 points, "), "{report}");
    assert!(lines[1].starts_with("a.xyz: ok, octree, 2 points, "), "{report}");
    assert!(
        lines[2].starts_with("scene:figure-7: ok, octree, 1 cell, 8 leaves, 1 occupied, depth 1"),
        "{report}"
    );
}

#[test]
fn check_does_not_count_the_steps_of_a_long_run_but_says_so() {
    let desk = desk_with_scenario();
    desk.put(
        "deep.octo",
        r#"{"octoscope":1,"dimension":2,"domain":{"min":[0,0],"side":1},
        "scene":{"points":[[0.3,0.3],[0.3000001,0.3000001]]},"build":{"depth":20,"capacity":1},
        "ray":{"origin":[-0.16,0.13],"direction":[1,0.62]},"query":"ray","algorithm":"dda"}"#,
    );
    let report = desk.prints("check deep.octo");
    assert!(report.ends_with("depth 20, more than 100000 steps\n"), "{report}");
}

#[test]
fn check_tells_which_step_is_taken_where_there_are_fewer() {
    let desk = desk_with_scenario();
    let with_step = |step: &str| {
        let text = fs::read_to_string(desk.0.path().join("a.octo")).unwrap();
        let mut scenario: serde_json::Value = serde_json::from_str(&text).unwrap();
        scenario["step"] = serde_json::from_str(step).unwrap();
        desk.put("step.octo", &scenario.to_string());
        desk.prints("check step.octo")
    };
    let told = " steps (\"step\" is 9999: the last is taken)\n";
    assert!(with_step("9999").ends_with(told), "{}", with_step("9999"));
    assert!(with_step("3").ends_with(" steps\n") && with_step("\"last\"").ends_with(" steps\n"));
}

#[test]
fn the_first_item_outside_is_told_by_its_line() {
    let desk = desk_with_scenario();
    for items in ["\"points\": [[0.5, 0.5],\n[1.5, 0]]", "\"cells\": [[1, 1],\n[16, 0]]"] {
        let scenario = format!(
            "{{\"octoscope\": 1, \"dimension\": 2, \"domain\": {{\"min\": [0, 0], \"side\": 1}},\n\
             \"scene\": {{{items}}}, \"build\": {{\"depth\": 4}}}}"
        );
        desk.put("out.octo", &scenario);
        let message = desk.refuses("trace out.octo");
        let expected = "octoscope: line 3, column 1: this item lies outside the domain, ";
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn lists_of_cells_and_rays_are_no_scenarios_and_it_is_told_what_to_do() {
    let desk = desk_with_scenario();
    for (file, parts) in [
        ("a.cells", ["has no depth", "visit --cells FILE --depth N"]),
        ("a.rays", ["has no tree", "\"ray\""]),
    ] {
        let message = desk.refuses(&format!("trace {file}"));
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
        assert!(message.ends_with(&format!(": {file}\n")), "{message}");
    }
}

#[test]
fn check_tells_what_lists_of_cells_and_rays_hold() {
    let desk = desk_with_scenario();
    desk.put("b.cells", "# none\n");
    desk.put("b.rays", "0 0 0 1 0 0 # one\n");
    let report = desk.prints("check a.cells b.cells a.rays b.rays");
    let lines = [
        "a.cells: ok, quadtree, 1 cell, depth 2 or more",
        "b.cells: ok, octree, 0 cells, depth 0 or more",
        "a.rays: ok, 3 rays in the plane",
        "b.rays: ok, 1 ray in space",
    ];
    assert_eq!(report, lines.join("\n") + "\n");
    desk.put("c.rays", "0 0 1 0\n0 0 0 0\n");
    let report = desk.run("check c.rays");
    assert_eq!(report.status.code(), Some(1));
    assert!(text(&report.stdout).starts_with("c.rays: bad, line 2, column 5: the direction"));
}

#[test]
fn check_and_scenes_are_quiet_when_nobody_reads_on() {
    let desk = desk_with_scenario();
    for arguments in ["scenes", "scenes --json", "check a.octo a.xyz", "trace a.octo", "--help"] {
        let mut command = desk.command(arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), String::new()));
    }
}

#[test]
fn check_answers_no_where_a_file_is_bad() {
    let desk = desk_with_scenario();
    let output = desk.run("check a.octo cut.octo none.octo scene:none");
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("3 of 4 files are bad"));
    let report = text(&output.stdout);
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines.len(), 4, "{report}");
    assert!(lines[0].starts_with("a.octo: ok, "), "{report}");
    assert!(lines[1].starts_with("cut.octo: bad, ") && lines[1].contains("line "), "{report}");
    assert_eq!(lines[2], "none.octo: bad, there is no such file or folder");
    assert!(lines[3].starts_with("scene:none: bad, ") && lines[3].contains("cloud"), "{report}");
    desk.refuses("check");
}

#[test]
fn trace_tells_every_step() {
    let desk = desk_with_scenario();
    let english = desk.prints("trace a.octo");
    let german = desk.prints("trace a.octo --lang de");
    assert_eq!(english.lines().count(), german.lines().count());
    assert_ne!(english, german);
    let lines = desk.prints("trace a.octo --format jsonl");
    // The header for step 0.
    assert_eq!(lines.lines().count(), english.lines().count());
    let objects: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(objects[0]["octoscope-trace"], 1);
    assert_eq!(objects[0]["query"], "ray");
    assert!(objects[1..].iter().all(|object| object["event"].is_string()));
    let table = desk.prints("trace a.octo --format csv");
    assert_eq!(table.lines().count(), lines.lines().count());
    assert_eq!(desk.prints("trace a.octo --format csv -o a.csv"), "");
    assert_eq!(fs::read_to_string(desk.0.path().join("a.csv")).unwrap(), table);
}

#[test]
fn the_header_of_a_trace_tells_what_is_asked_and_by_which_rules() {
    let desk = desk_with_scenario();
    let header = |arguments: &str| -> serde_json::Value {
        let lines = desk.prints(&format!("trace {arguments} --format jsonl"));
        serde_json::from_str(lines.lines().next().unwrap()).unwrap()
    };
    let misprinted = header("scene:figure-7 --algorithm parametric@B-2,B-7");
    assert_eq!(misprinted["algorithm"], "parametric");
    assert_eq!(misprinted["variants"], serde_json::json!(["B-2", "B-7"]));
    let point = header("scene:figure-1");
    assert_eq!(point["query"], "point");
    assert_eq!(point["algorithm"], serde_json::Value::Null);
}

#[test]
fn trace_takes_another_ray_and_another_algorithm() {
    let desk = desk_with_scenario();
    let leaves = |arguments: &str| {
        let lines = desk.prints(&format!("trace {arguments} --format jsonl"));
        let objects: Vec<serde_json::Value> =
            lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let leaves = objects.iter().filter(|object| object["event"] == "leaf");
        leaves.map(|leaf| leaf["node"].to_string()).collect::<Vec<_>>()
    };
    let ray = "scene:figure-7 --ray -1,0.25,0.25,0x1p0,0,0";
    assert_eq!(leaves(ray), ["[0,0,0,0]", "[0,1,0,0]"]);
    assert_eq!(leaves(&format!("{ray} --algorithm exhaustive")), leaves(ray));
    assert_eq!(leaves("a.octo --algorithm codes"), leaves("a.octo --algorithm parametric"));
    // This scene asks for a point.
    assert!(!leaves("scene:figure-1 --algorithm codes").is_empty());
    assert_eq!(leaves("a.xyz"), leaves("a.xyz --algorithm exhaustive"));
}

#[test]
fn trace_refuses_bad_input_with_what_would_be_right() {
    let desk = desk_with_scenario();
    for (arguments, known) in [
        ("a.octo --ray 1,2,3", "takes 4: ox,oy,dx,dy"),
        ("a.xyz --ray 1,2,3,4", "takes 6"),
        ("a.octo --ray 0,0,0,0", "--ray"),
        ("a.octo --ray 0,0,x,1", "‘x’ is no finite number"),
        ("a.octo --algorithm fastest", "parametric-table"),
        ("a.octo --format xml", "jsonl"),
        ("a.octo --lang fr", "en and de"),
        ("none.octo", "no such file"),
        ("cut.octo", "line "),
        ("a.rays", "has no tree"),
    ] {
        let message = desk.refuses(&format!("trace {arguments}"));
        assert!(message.contains(known), "{arguments}: {message}");
    }
    desk.refuses("trace");
}

#[test]
fn rays_of_the_gallery_are_made_for_the_tree() {
    let desk = desk_with_scenario();
    let text = desk.prints("trace a.octo --ray gallery:leaving");
    assert!(text.contains("misses"), "{text}");
    let text = desk.prints("trace scene:figure-7 --ray gallery:edge --exact");
    assert!(text.contains("along (1, 0, 0)"), "{text}");
    let message = desk.refuses("trace a.octo --ray gallery:edge");
    assert!(message.contains("through octrees only"), "{message}");
    let message = desk.refuses("trace a.octo --ray gallery:none");
    assert!(message.contains("axis-parallel, face-plane"), "{message}");
    let figure = |ray: &str| desk.prints(&format!("export a.octo --format svg --ray {ray}"));
    assert_ne!(figure("gallery:corner"), figure("gallery:centre"));
}
