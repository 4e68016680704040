//! An observer that does nothing costs nothing: the algorithms need as many
//! instructions as if their text told no events at all.
//!
//! The version without events is no second text: the sources are copied, and of the
//! copy every call of `observe` is put behind an `if false`, where it keeps the types
//! together and no compiler keeps it. Both versions are built in release, and
//! valgrind counts what a processor would carry out.

use octoscope_core::traverse::Algorithm;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Instructions in units of those without events: at most 1 % more, and not so many
/// fewer that something else were counted.
const ABOUT_ONE: std::ops::RangeInclusive<f64> = 0.97..=1.01;

#[test]
fn as_many_instructions_are_needed_as_without_events() {
    if Command::new("valgrind").arg("--version").output().is_err() {
        assert!(
            std::env::var_os("CI").is_none(),
            "valgrind is missing: on Debian and Ubuntu `apt-get install valgrind`"
        );
        eprintln!("NOT RUN: instructions are counted by valgrind, which is missing");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("events");
    let [told, untold] = [("told", Events::Told), ("untold", Events::TakenOut)]
        .map(|(name, events)| program(&folder, name, events));
    let mut report = String::new();
    let mut all_agree = true;
    for algorithm in Algorithm::ALL {
        let [with, without] = [&told, &untold].map(|program| count(program, algorithm));
        assert_eq!(with.ends, without.ends, "{algorithm:?} walks otherwise without events");
        let ratio = with.instructions as f64 / without.instructions as f64;
        let agrees = ABOUT_ONE.contains(&ratio);
        all_agree &= agrees;
        report += &format!(
            "{:<16} {:>12} {:>12} {ratio:>7.4}{}\n",
            algorithm.id(),
            with.instructions,
            without.instructions,
            if agrees { "" } else { "  !" }
        );
    }
    println!("instructions      with events      without   ratio\n{report}");
    assert!(all_agree, "with and without events:\n{report}");
}

/// What a version does with the events.
#[derive(Clone, Copy, PartialEq)]
enum Events {
    Told,
    TakenOut,
}

/// Builds `examples/walks.rs` in a copy of the sources.
fn program(folder: &Path, name: &str, events: Events) -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let workspace = package.ancestors().nth(2).expect("the package lies in crates/");
    let root = folder.join(name);
    let copy = root.join("crates/octoscope-core");
    put(&root.join("Cargo.toml"), &manifest(&read(&workspace.join("Cargo.toml"))));
    put(&root.join("Cargo.lock"), &read(&workspace.join("Cargo.lock")));
    put(&copy.join("Cargo.toml"), &package_manifest(&read(&package.join("Cargo.toml"))));
    put(&copy.join("examples/walks.rs"), &read(&package.join("examples/walks.rs")));
    let mut n_taken_out = 0;
    for file in files_below(&package.join("src")) {
        let mut text = read(&file);
        let is_traversal = file.starts_with(package.join("src/traverse"));
        if events == Events::TakenOut && is_traversal {
            let (without, n_calls) = without_events(&text);
            (text, n_taken_out) = (without, n_taken_out + n_calls);
        }
        put(&copy.join(file.strip_prefix(package).expect("it lies below")), &text);
    }
    for file in files_below(&workspace.join("assets/texts"))
        .into_iter()
        .chain(files_below(&workspace.join("assets/listings")))
    {
        put(&root.join(file.strip_prefix(workspace).expect("it lies below")), &read(&file));
    }
    assert_eq!(n_taken_out > 50, events == Events::TakenOut, "{n_taken_out} events taken out");

    let target = folder.join("target");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--release", "--offline", "--example", "walks"])
        .arg("--target-dir")
        .arg(&target)
        .current_dir(&root)
        // What is left of an event that nobody is told is no fault here.
        .env("RUSTFLAGS", "--cap-lints=allow")
        .env("CARGO_PROFILE_RELEASE_STRIP", "none")
        // In several units it is more by chance what is inlined into what.
        .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "1")
        .output()
        .expect("cargo runs this test");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let program = root.join("walks");
    fs::copy(target.join("release/examples/walks"), &program).expect("it was built");
    program
}

/// What valgrind has counted.
#[derive(Debug, PartialEq)]
struct Counted {
    instructions: u64,
    /// What the program prints.
    ends: Vec<u8>,
}

fn count(program: &Path, algorithm: Algorithm) -> Counted {
    let Output { status, stdout, stderr } = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg("--toggle-collect=*walk_the_rays*")
        .arg(program)
        .arg(algorithm.id())
        .output()
        .expect("valgrind is there");
    let stderr = String::from_utf8_lossy(&stderr);
    assert!(status.success(), "{stderr}");
    let collected = stderr.lines().find_map(|line| line.split_once("Collected :"));
    let (_, number) = collected.unwrap_or_else(|| panic!("no number in {stderr}"));
    let instructions = number.trim().parse().expect("a number of instructions");
    assert!(instructions > 10_000, "{algorithm:?} was not counted");
    Counted { instructions, ends: stdout }
}

/// The manifest of a workspace that has one package only.
fn manifest(text: &str) -> String {
    let (shared, _) = text.split_once("\n[package]").expect("a package follows the workspace");
    let lines = shared.lines().filter(|line| !line.starts_with("default-members"));
    let lines = lines.map(|line| {
        let is_members = line.starts_with("members");
        if is_members { "members = [\"crates/octoscope-core\"]" } else { line }
    });
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

/// The manifest without the benches, whose sources are not copied.
fn package_manifest(text: &str) -> String {
    text.replace("[[bench]]", "[[package.metadata.bench]]")
}

/// Source text in which no call of `observe` is ever reached, and their number.
fn without_events(text: &str) -> (String, usize) {
    let mut rest = text;
    let (mut result, mut n_calls) = (String::new(), 0);
    while let Some(at) = rest.find(".observe(") {
        let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let receiver = rest[..at].rfind(|c| !is_path(c)).map_or(0, |before| before + 1);
        let arguments = at + ".observe".len();
        let mut depth = 0;
        let length = rest[arguments..].find(|c| {
            depth += match c {
                '(' => 1,
                ')' => -1,
                _ => 0,
            };
            depth == 0
        });
        let end = arguments + length.expect("what is opened is closed") + 1;
        result.push_str(&rest[..receiver]);
        result.push_str(&format!("if false {{ {} }}", &rest[receiver..end]));
        rest = &rest[end..];
        n_calls += 1;
    }
    (result + rest, n_calls)
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut files = Vec::new();
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() { files.extend(files_below(&path)) } else { files.push(path) }
    }
    files
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Writes what is not there yet: what stays the same is not built again.
fn put(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return;
    }
    fs::create_dir_all(path.parent().expect("a file lies in a folder")).expect("room on the disk");
    fs::write(path, text).expect("room on the disk");
}

#[test]
fn calls_are_taken_out_whole() {
    let text = "a(); self.observe.observe(Event::End(f(1)));\nx => observe.observe(e),";
    assert_eq!(without_events(text), (
            "a(); if false { self.observe.observe(Event::End(f(1))) };\nx => if false { observe.observe(e) },"
                .to_owned(),
            2
        ));
    assert_eq!(
        without_events("fn observe(&mut self) {}"),
        ("fn observe(&mut self) {}".to_owned(), 0)
    );
}
