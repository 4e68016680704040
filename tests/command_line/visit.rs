//! `octoscope visit`.

use crate::desk::{Desk, LINES, VISIT, text};
use octoscope_core::traverse::Algorithm;
use std::fs;
use std::process::Stdio;

#[test]
fn visit_prints_one_line_a_ray() {
    let desk = Desk::new();
    assert_eq!(desk.prints(VISIT), LINES);
    for algorithm in ["parametric", "parametric-table", "codes", "exhaustive", "all", "batch"] {
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
fn the_batch_kernel_prints_what_the_algorithms_find() {
    let desk = Desk::new();
    let rays: String = (0..3000)
        .map(|n: i32| format!("{} {} {} {}\n", n % 7 - 3, n % 11, n % 5 - 2, n % 3 + 1))
        .collect();
    desk.put("a.rays", &rays);
    for more in ["", "--first", "--keep-cells"] {
        let expected = desk.prints(&format!("{VISIT} --exact {more}"));
        for threads in ["", "--threads 3"] {
            let arguments = format!("{VISIT} --algorithm batch {more} {threads}");
            assert_eq!(desk.prints(&arguments), expected, "{arguments}");
        }
        let row = |algorithm: &str| {
            let arguments = format!("{VISIT} --exact --algorithm {algorithm} --summary {more}");
            let table = desk.prints(&arguments);
            let row = table.lines().nth(1).unwrap();
            row.split_whitespace().map(str::to_owned).skip(1).take(4).collect::<Vec<_>>()
        };
        assert_eq!(row("batch"), row("parametric"));
    }
}

#[test]
fn the_batch_kernel_refuses_what_it_does_not_do() {
    let desk = Desk::new();
    for option in ["--touches", "--end 1"] {
        let message = desk.refuses(&format!("{VISIT} --algorithm batch {option}"));
        assert!(message.contains("choose an algorithm"), "{message}");
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
    let message = desk.refuses(&format!("{VISIT} --algorithm parametric@B-2"));
    assert!(message.contains("‘B-2’ is a rule for octrees alone"), "{message}");
    let message = desk.refuses(&format!("{VISIT} --algorithm all@B-1"));
    assert!(message.contains("‘all’ runs without variants"), "{message}");
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
fn a_file_without_a_line_is_accepted_with_a_note() {
    let desk = Desk::new();
    desk.put("empty", "");
    desk.put("comment", "# nothing\n");
    for empty in ["empty", "comment"] {
        let output = desk.run(&VISIT.replace("a.cells", empty));
        assert_eq!(text(&output.stdout), "1 2:0,0\n1 2:0,0\n0\n");
        let note = format!("octoscope: there is no cell, so the tree is one empty leaf: {empty}\n");
        assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), note));
        let output = desk.run(&VISIT.replace("a.rays", empty));
        assert_eq!(text(&output.stdout), "");
        let note = format!("octoscope: there is no ray, so nothing is visited: {empty}\n");
        assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), note));
    }
}
