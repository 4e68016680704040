//! `cargo xtask bench`.

use crate::cargo::{cargo, target_folder};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::process::Command;

/// What is measured: the name of the bench and the title of its part.
const BENCHES: [(&str, &str); 4] = [
    ("kernels", "Traversals"),
    ("threads", "Several threads"),
    ("building", "Building"),
    ("exactness", "Exact comparisons against doubles"),
];

/// A library in C++ that is measured where it is installed.
struct Library {
    /// As its makers write it.
    name: &'static str,
    /// Its package for `pkg-config`.
    package: &'static str,
    /// Our program for it, in `benches/peers`.
    program: &'static str,
}

/// On Debian and Ubuntu their files are in `liboctomap-dev` and `libpcl-dev`.
const LIBRARIES: [Library; 2] = [
    Library { name: "OctoMap", package: "octomap", program: "octomap" },
    Library { name: "Point Cloud Library", package: "pcl_octree", program: "pcl" },
];

/// What the numbers mean and which goals they meet; stays as it is.
const TEXT: &str = include_str!("bench.md");

/// Runs all benches and writes `BENCHMARKS.md`: the text, the machine and the tables.
///
/// # Errors
/// Says which bench has failed, or that the file cannot be written.
pub fn bench() -> Result<(), String> {
    let mut page = TEXT.to_owned();
    let _ = writeln!(page, "\n## The machine\n\n{}", machine());
    for (bench, title) in BENCHES {
        eprintln!("{title} …");
        let mut measure = cargo();
        measure.args(["bench", "--quiet", "--package", "octoscope-core", "--bench", bench]);
        write_part(&mut page, title, &printed(&mut measure)?);
    }
    eprintln!("Other systems …");
    write_part(&mut page, "Other systems", &peers()?);
    for library in &LIBRARIES {
        eprintln!("{} …", library.name);
        match of_library(library) {
            Ok(table) => write_part(&mut page, library.name, &table),
            Err(reason) => eprintln!("{} was not measured: {reason}", library.name),
        }
    }
    fs::write("BENCHMARKS.md", page)
        .map_err(|error| format!("BENCHMARKS.md cannot be written: {error}"))
}

fn write_part(page: &mut String, title: &str, table: &str) {
    let _ = writeln!(page, "\n## {title}\n\n```text\n{}\n```", table.trim_matches('\n'));
}

/// What a command prints.
fn printed(command: &mut Command) -> Result<String, String> {
    let output = command.output();
    let output = output.map_err(|error| format!("{command:?} could not be started: {error}"))?;
    if !output.status.success() {
        let reason = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{command:?} has failed\n{reason}"));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Hierarchies from the package registry, beside our own traversals.
fn peers() -> Result<String, String> {
    let mut run = cargo();
    run.args(["run", "--quiet", "--release", "--manifest-path", "benches/peers/Cargo.toml"]);
    run.arg("--target-dir").arg(target_folder()?.join("peers"));
    printed(&mut run)
}

/// A library in C++ on our workload, if a compiler and its files are there.
fn of_library(library: &Library) -> Result<String, String> {
    let folder = target_folder()?.join("workload");
    let program = folder.join(library.program);
    let mut write = cargo();
    write.args(["run", "--quiet", "--release", "--package", "octoscope-core"]);
    write.args(["--example", "workload"]).arg(&folder);
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let source = format!("benches/peers/{}.cpp", library.program);
    let flags = printed(Command::new("pkg-config").args(["--cflags", "--libs", library.package]))?;
    let mut compile = Command::new("g++");
    compile.args(["-O3", "-march=native", &source]);
    printed(compile.args(flags.split_whitespace()).arg("-o").arg(&program))?;
    printed(&mut write)?;
    let mut table = format!("{:<40} {:>9} {:>9}\n", "", "Mrays/s", "best");
    for (tree, depth) in [("S3-d6", "6"), ("cloud-d8", "8"), ("S5-d8", "8")] {
        let [cells, rays] =
            [format!("{tree}.cells"), "ext100k.rays".to_owned()].map(|name| folder.join(name));
        let mut run = Command::new(&program);
        table += &printed(run.args([tree, depth]).arg(cells).arg(rays))?;
    }
    Ok(table)
}

/// Processor and system, without names that somebody has given.
fn machine() -> String {
    let system = format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH);
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    processor(&text).map_or(system.clone(), |processor| format!("{processor}; {system}"))
}

/// Model and number of the processors that `/proc/cpuinfo` lists, and their vectors.
fn processor(cpuinfo: &str) -> Option<String> {
    let fields: BTreeMap<&str, &str> = cpuinfo
        .lines()
        .filter_map(|line| line.split_once(':'))
        .map(|(name, value)| (name.trim(), value.trim()))
        .collect();
    let count = cpuinfo.lines().filter(|line| line.starts_with("processor")).count();
    let flags = fields.get("flags")?;
    let has = |flag: &str| flags.split_whitespace().any(|word| word == flag);
    let vectors = ["avx512f", "avx2", "sse2"].into_iter().find(|flag| has(flag))?;
    let [model, cache] = ["model name", "cache size"].map(|name| fields.get(name));
    Some(format!("{count} × {}, {} of cache, vectors: {vectors}", model?, cache?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_told_in_one_line() {
        let one = "processor : 0\nmodel name : Fast 7\ncache size : 1024 KB\nflags : sse2 avx2\n";
        let told = processor(&[one, one].concat());
        assert_eq!(told.as_deref(), Some("2 × Fast 7, 1024 KB of cache, vectors: avx2"));
        assert_eq!(processor(""), None);
    }
}
