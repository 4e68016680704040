//! The command line as its users meet it: the real program, its output, its
//! messages and its exit status.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::scenario::AnyScenario;
use octoscope_core::traverse::Algorithm;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// A folder with files, and the program run in it.
struct Desk(TempDir);

impl Desk {
    /// Folder with one occupied cell of a 4×4 grid and three rays.
    fn new() -> Self {
        let desk = Self(tempfile::tempdir().unwrap());
        desk.put("a.cells", "# corner\n3 0\n");
        desk.put("a.rays", "-1 0.125 1 0\n0.5 0.5 0x1p-1 0x1p-1\n5 5 1 1 # misses\n");
        desk
    }

    fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().unwrap()
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_octoscope"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path());
        for display in ["DISPLAY", "WAYLAND_DISPLAY"] {
            command.env_remove(display);
        }
        command
    }

    /// Standard output of a run that succeeds without a message.
    #[track_caller]
    fn prints(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert_eq!(text(&output.stderr), "", "{arguments}");
        assert_eq!(output.status.code(), Some(0), "{arguments}");
        text(&output.stdout)
    }

    /// The message of a run that ends with status 2 and prints nothing.
    #[track_caller]
    fn refuses(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert_eq!(text(&output.stdout), "", "{arguments}");
        text(&output.stderr)
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

const VISIT: &str = "visit --cells a.cells --depth 2 --rays a.rays --dim 2";
const LINES: &str = "3 1:0,0 0:2,0 0:3,0*\n1 1:2,2\n0\n";

#[test]
fn visit_prints_one_line_a_ray() {
    let desk = Desk::new();
    assert_eq!(desk.prints(VISIT), LINES);
    for algorithm in ["parametric", "parametric-table", "codes", "exhaustive", "all"] {
        for more in ["", "--exact", "--threads 3", "--exact --threads 2"] {
            let arguments = format!("{VISIT} --algorithm {algorithm} {more}");
            assert_eq!(desk.prints(&arguments), LINES, "{arguments}");
        }
    }
}

#[test]
fn visit_takes_octrees_by_default() {
    let desk = Desk::new();
    desk.put("b.cells", "1 1 1\n");
    desk.put("b.rays", "0.75 0.75 -1 0 0 1\n");
    let lines = desk.prints("visit --cells b.cells --depth 1 --rays b.rays");
    assert_eq!(lines, "2 0:1,1,0 0:1,1,1*\n");
}

#[test]
fn visit_stops_at_the_first_full_leaf() {
    let desk = Desk::new();
    desk.put("a.cells", "0 0\n");
    assert_eq!(desk.prints(&format!("{VISIT} --first")), "1 0:0,0*\n1 1:2,2\n0\n");
}

#[test]
fn touches_are_listed_on_request_and_do_not_count() {
    let desk = Desk::new();
    desk.put("a.cells", "0 0\n");
    desk.put("a.rays", "0 1 1 -1\n");
    let oracle = desk.prints(&format!("{VISIT} --touches --algorithm exhaustive"));
    assert!(oracle.starts_with("2 "), "{oracle}");
    assert!(oracle.contains('~'), "{oracle}");
    let without = desk.prints(&format!("{VISIT} --algorithm exhaustive"));
    assert_eq!(without, "2 1:0,2 1:2,0\n");
}

#[test]
fn full_nodes_merge_unless_cells_are_kept() {
    let desk = Desk::new();
    desk.put("a.cells", "0 0\n0 1\n1 0\n1 1\n");
    desk.put("a.rays", "-1 0.125 1 0\n");
    assert_eq!(desk.prints(VISIT), "2 1:0,0* 1:2,0\n");
    assert_eq!(desk.prints(&format!("{VISIT} --keep-cells")), "3 0:0,0* 0:1,0* 1:2,0\n");
}

#[test]
fn the_summary_tells_the_checksum_of_what_would_be_printed() {
    let desk = Desk::new();
    let summary = desk.prints(&format!("{VISIT} --algorithm all --summary --repeat 3"));
    let hash = LINES.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    assert_eq!(summary.lines().count(), 1 + Algorithm::ALL.len(), "{summary}");
    for line in summary.lines().skip(1) {
        let cells: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(cells[1..5], ["3", "4", "1", &format!("{hash:016x}")], "{summary}");
        assert_eq!(cells.len(), 9, "{summary}");
    }
}

#[test]
fn results_go_to_a_file_that_appears_whole() {
    let desk = Desk::new();
    assert_eq!(desk.prints(&format!("{VISIT} -o out.txt")), "");
    assert_eq!(fs::read_to_string(desk.0.path().join("out.txt")).unwrap(), LINES);
}

#[test]
fn a_failed_run_leaves_the_old_file_and_no_other() {
    let desk = Desk::new();
    desk.put("out.txt", "old");
    desk.put("a.rays", "0 0 1 1\n0 0 0 0\n");
    desk.refuses(&format!("{VISIT} -o out.txt"));
    assert_eq!(fs::read_to_string(desk.0.path().join("out.txt")).unwrap(), "old");
    assert_eq!(fs::read_dir(desk.0.path()).unwrap().count(), 3);
}

#[test]
fn bad_input_is_refused_with_what_where_and_what_would_be_right() {
    let desk = Desk::new();
    desk.put("bad.cells", "0 0\n0 4\n");
    desk.put("bad.rays", "0 0 1 0\n0 0 x 0\n");
    let message = desk.refuses(&VISIT.replace("a.cells", "bad.cells"));
    assert!(message.contains("line 2, column 3") && message.contains("0 … 3"), "{message}");
    assert!(message.trim_end().ends_with("bad.cells"), "{message}");
    let message = desk.refuses(&VISIT.replace("a.rays", "bad.rays"));
    assert!(message.contains("line 2, column 5"), "{message}");
    let message = desk.refuses(&VISIT.replace("a.rays", "no.rays"));
    assert!(message.contains("no such file") && message.contains("no.rays"), "{message}");
    let message = desk.refuses(&format!("{VISIT} -o no/folder/out.txt"));
    assert!(message.contains("no/folder/out.txt"), "{message}");
}

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
fn a_broken_pipe_ends_quietly() {
    let desk = Desk::new();
    desk.put("a.rays", &"-1 0.125 1 0\n".repeat(50_000));
    let mut child =
        desk.command(VISIT).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(text(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

#[test]
fn scenes_lists_scenes_and_algorithms() {
    let desk = Desk::new();
    let list = desk.prints("scenes");
    assert!(list.contains("scene:quadtree-82") && list.contains("parametric-table"), "{list}");
    let json: serde_json::Value = serde_json::from_str(&desk.prints("scenes --json")).unwrap();
    assert_eq!(json["scenes"][0]["id"], "scene:quadtree-82");
}

const SCENARIO: &str = r#"{
  "octoscope": 1,
  "dimension": 2,
  "scene": {"points": [[0.1, 0.2], [0.15, 0.25], [0.8, 0.9]]},
  "build": {"depth": 4, "capacity": 1},
  "ray": {"origin": [-0.25, 0.1], "direction": [1, 0.5]},
  "step": 3
}"#;

/// A folder with a scenario and a file that ends too early.
fn desk_with_scenario() -> Desk {
    let desk = Desk::new();
    desk.put("a.octo", SCENARIO);
    desk.put("cut.octo", &SCENARIO[..SCENARIO.len() / 2]);
    desk.put("a.xyz", "0 0 0\n1 1 1\n");
    desk
}

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
    assert!(objects[1..].iter().all(|object| object["event"].is_string()));
    let table = desk.prints("trace a.octo --format csv");
    assert_eq!(table.lines().count(), lines.lines().count());
    assert_eq!(desk.prints("trace a.octo --format csv -o a.csv"), "");
    assert_eq!(fs::read_to_string(desk.0.path().join("a.csv")).unwrap(), table);
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
        ("a.rays", "cannot be read"),
    ] {
        let message = desk.refuses(&format!("trace {arguments}"));
        assert!(message.contains(known), "{arguments}: {message}");
    }
    desk.refuses("trace");
}

#[test]
fn help_shows_examples() {
    let desk = Desk::new();
    for command in ["--help", "visit --help", "trace --help", "export --help", "check --help"] {
        assert!(desk.prints(command).contains("Examples:"), "{command}");
    }
}
