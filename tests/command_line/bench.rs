//! `octoscope bench`.

use crate::desk::{Desk, text};
use std::fs;
use std::time::{Duration, Instant};

const QUICK: &str = "bench --scene spheres-512 --depth 3-4 --rays 20 --repeat 2";

#[test]
fn bench_prints_a_line_for_every_scene_depth_and_algorithm() {
    let desk = Desk::new();
    let csv = desk.prints(&format!("{QUICK} --scene figure-7 --csv"));
    let lines: Vec<&str> = csv.lines().collect();
    // All algorithms but the oracle, and both kernels for many rays.
    assert_eq!(lines.len(), 1 + 2 * 2 * (14 + 2));
    let head: Vec<&str> = lines[0].split(',').collect();
    let column = |name: &str| head.iter().position(|&head| head == name).unwrap();
    let (checksum, depth) = (column("checksum"), column("depth"));
    let fields: Vec<Vec<&str>> = lines[1..].iter().map(|line| line.split(',').collect()).collect();
    for pair in fields.windows(2) {
        if pair[0][..=depth] == pair[1][..=depth] {
            assert_eq!(pair[0][checksum], pair[1][checksum]);
        }
    }
    assert!(fields.iter().all(|row| row[column("us/ray")].parse::<f64>().unwrap() > 0.0));
}

#[test]
fn bench_tells_times_counts_and_growth() {
    let desk = Desk::new();
    let text = desk.prints(&format!("{QUICK} --algorithm parametric --algorithm bsp"));
    for part in [
        "spheres-512, depth 3: ",
        "spheres-512, depth 4: ",
        "us/ray",
        "divisions",
        "exponent",
        "published",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert_eq!(text.matches("\nbsp ").count(), 2 * 2 + 2);
}

#[test]
fn an_algorithm_that_finds_other_leaves_is_named() {
    let desk = Desk::new();
    let algorithms = "--algorithm parametric --algorithm parametric-table@B-2";
    let output = desk.run(&format!("{QUICK} {algorithms} -o out.txt"));
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert!(
        message.contains("parametric-table@B-2 finds other leaves than parametric"),
        "{message}"
    );
    assert!(desk.0.path().join("out.txt").exists(), "what was measured is told all the same");
}

#[test]
fn bench_refuses_what_it_cannot_measure() {
    let desk = Desk::new();
    for (arguments, told) in [
        ("bench --scene fog", "spheres-4096"),
        ("bench --depth 8-5", "as in 5-8"),
        ("bench --depth 40", "from 1 to 12"),
        ("bench --rays 0", "from 1 to 1000000"),
        ("bench --algorithm fast", "parametric-table"),
        ("bench -o nowhere/out.csv", "nowhere"),
    ] {
        let message = desk.refuses(arguments);
        assert!(message.contains(told), "{arguments}: {message}");
    }
}

/// Broken off from the keyboard, the program leaves neither a file nor a part of one.
#[cfg(unix)]
#[test]
fn a_bench_that_is_broken_off_leaves_nothing() {
    let desk = Desk::new();
    let changed_at = || fs::metadata(desk.0.path()).unwrap().modified().unwrap();
    let n_files = || fs::read_dir(desk.0.path()).unwrap().count();
    let before = (changed_at(), n_files());
    let mut bench = desk.command("bench --depth 8 --rays 100000 -o out.csv --csv").spawn().unwrap();
    // It has tried whether it may write there, and measures.
    while changed_at() == before.0 || n_files() != before.1 {
        assert!(bench.try_wait().unwrap().is_none());
        std::thread::yield_now();
    }
    let interrupt =
        std::process::Command::new("kill").args(["-INT", &bench.id().to_string()]).status();
    assert!(interrupt.unwrap().success());
    let start = Instant::now();
    assert!(!bench.wait().unwrap().success());
    assert!(start.elapsed() < Duration::from_secs(20));
    assert_eq!(n_files(), before.1);
}
