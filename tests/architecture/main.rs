//! The arrows between the parts of the program, read from its sources.
//!
//! Every rule is a row of [`RULES`]; `names` turns a source into the paths that it
//! mentions, so that comments and strings never count.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod circles;
mod sources;

use sources::{names, root, sources};
use std::fs;

/// Paths that the files of one place must not name.
struct Rule {
    /// Beginning of the paths of the files, relative to the workspace.
    place: &'static str,
    /// Beginnings of the paths of files that are exempt.
    except: &'static [&'static str],
    /// Names of modules and crates that may not occur in any path.
    forbidden: &'static [&'static str],
}

const CORE: &str = "crates/octoscope-core/src/";
const RULES: &[Rule] = &[
    Rule {
        place: CORE,
        except: &[],
        forbidden: &[
            "std::fs",
            "std::env",
            "std::time",
            "egui",
            "wgpu",
            "eframe",
            "octoscope_figure",
            "octoscope_import",
            "clap",
            "anyhow",
        ],
    },
    Rule {
        place: CORE,
        except: &["crates/octoscope-core/src/threads.rs"],
        forbidden: &["std::thread"],
    },
    Rule {
        place: "crates/octoscope-core/src/geometry/",
        except: &[],
        forbidden: &[
            "tree", "event", "locate", "traverse", "query", "trace", "explain", "scene",
            "scenario", "measure",
        ],
    },
    Rule {
        place: "crates/octoscope-core/src/tree/",
        except: &[],
        forbidden: &[
            "event", "locate", "traverse", "query", "trace", "explain", "scenario", "measure",
        ],
    },
    Rule {
        place: "crates/octoscope-core/src/traverse/",
        except: &[],
        forbidden: &["query", "trace", "explain", "gallery", "paper", "scenario", "measure"],
    },
    Rule {
        place: "crates/octoscope-core/src/event/",
        except: &[],
        forbidden: &[
            "locate", "traverse", "query", "trace", "explain", "gallery", "paper", "scenario",
        ],
    },
    Rule {
        place: "crates/octoscope-core/src/trace/",
        except: &[],
        forbidden: &["explain", "gallery", "paper", "scenario", "measure"],
    },
    Rule {
        place: "crates/octoscope-core/src/gallery/",
        except: &[],
        forbidden: &["explain", "paper"],
    },
    Rule {
        place: "crates/octoscope-core/src/locate/",
        except: &[],
        forbidden: &["traverse", "trace", "explain", "scenario", "measure"],
    },
    Rule {
        place: "crates/octoscope-figure/src/",
        except: &[],
        forbidden: &["octoscope_import", "egui", "eframe", "wgpu", "std::fs", "std::env"],
    },
    Rule {
        place: "crates/octoscope-import/src/",
        except: &[],
        forbidden: &["octoscope_figure", "egui", "eframe", "wgpu", "std::fs", "std::env"],
    },
    Rule { place: "src/", except: &["src/render"], forbidden: &["wgpu", "egui_wgpu"] },
    Rule {
        place: "src/",
        except: &["src/files"],
        forbidden: &["rfd", "std::fs", "fs", "tempfile"],
    },
    Rule {
        place: "src/cli/",
        except: &[],
        forbidden: &["egui", "eframe", "app", "panels", "render"],
    },
];

/// Crates that another must not depend on.
const DEPENDENCIES: &[(&str, &[&str])] = &[
    (
        "crates/octoscope-core/Cargo.toml",
        &["octoscope-figure", "octoscope-import", "egui", "eframe", "wgpu", "image", "clap", "rfd"],
    ),
    (
        "crates/octoscope-figure/Cargo.toml",
        &["octoscope-import", "octoscope", "egui", "eframe", "wgpu", "clap", "rfd"],
    ),
    (
        "crates/octoscope-import/Cargo.toml",
        &["octoscope-figure", "octoscope", "egui", "eframe", "wgpu", "clap", "rfd"],
    ),
];

const MOST_LINES: usize = 420;

#[test]
fn sources_name_nothing_from_above() {
    let complaints: Vec<String> = sources(&["rs"])
        .into_iter()
        .flat_map(|(path, text)| [broken_rules(&path, &text), named_panels(&path, &text)].concat())
        .collect();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn crates_depend_on_nothing_above() {
    for (path, forbidden) in DEPENDENCIES {
        let text = fs::read_to_string(root().join(path)).unwrap();
        let found = dependencies(&text);
        assert!(!found.is_empty(), "no dependencies found in {path}");
        for name in found {
            assert!(!forbidden.contains(&name.as_str()), "{path} depends on {name}");
        }
    }
}

#[test]
fn nothing_refers_to_a_folder_outside_the_project() {
    let outside = [concat!("../", "shared"), concat!("/", "work/")];
    for (path, text) in sources(&["rs", "toml", "md", "ftl", "json", "wgsl", "txt"]) {
        for folder in outside {
            assert!(!text.contains(folder), "{path} refers to {folder}");
        }
    }
}

#[test]
fn no_source_is_too_long_to_read() {
    for (path, text) in sources(&["rs"]) {
        let lines = text.lines().count();
        assert!(lines < MOST_LINES, "{path} has {lines} lines; split it by meaning");
    }
}

#[test]
fn no_comment_is_wider_than_code() {
    const MOST_COLUMNS: usize = 100;
    for (path, text) in sources(&["rs"]) {
        let comments =
            text.lines().zip(1..).filter(|(line, _)| line.trim_start().starts_with("//"));
        for (line, number) in comments {
            let columns = line.chars().count();
            assert!(columns <= MOST_COLUMNS, "{path}:{number} has {columns} columns; break it");
        }
    }
}

#[test]
fn ids_that_are_made_by_hand_have_a_name() {
    // A number alone is that of a hint of the same control.
    const WAYS: [&str; 5] = [".id.with(", "_id.with(", ".id().with(", "_id().with(", "Id::unique("];
    let mut n_ids = 0;
    for (path, text) in sources(&["rs"]).into_iter().filter(|(path, _)| path.starts_with("src/")) {
        // A chain may be broken anywhere.
        let text: String = text.split_whitespace().collect();
        for of in WAYS {
            for made in text.split(of).skip(1) {
                let name = made.trim_start_matches('(');
                let is_named = name.starts_with(|c: char| c == '"' || c.is_ascii_uppercase());
                let told: String = made.chars().take(40).collect();
                assert!(is_named, "{path} makes an id of {of}{told}");
                n_ids += 1;
            }
        }
    }
    assert!(n_ids > 20, "{n_ids}");
}

#[test]
fn every_place_of_a_rule_exists() {
    let paths: Vec<String> = sources(&["rs"]).into_iter().map(|(path, _)| path).collect();
    for rule in RULES {
        assert!(paths.iter().any(|path| path.starts_with(rule.place)), "no file in {}", rule.place);
    }
}

/// Rules that a source breaks, as sentences.
fn broken_rules(path: &str, text: &str) -> Vec<String> {
    let names = names(text);
    let mut complaints = Vec::new();
    for rule in RULES {
        let applies =
            path.starts_with(rule.place) && !rule.except.iter().any(|e| path.starts_with(e));
        if !applies {
            continue;
        }
        for forbidden in rule.forbidden {
            let wanted: Vec<&str> = forbidden.split("::").collect();
            let names_it =
                |name: &&Vec<String>| name.windows(wanted.len()).any(|part| part == wanted);
            if let Some(name) = names.iter().find(names_it) {
                complaints.push(format!("{path} names {}: {forbidden}", name.join("::")));
            }
        }
    }
    complaints
}

/// Other panels that a panel names, as sentences.
fn named_panels(path: &str, text: &str) -> Vec<String> {
    let Some(own) = path.strip_prefix("src/panels/").filter(|own| *own != "mod.rs") else {
        return Vec::new();
    };
    let own = own.split(['/', '.']).next().unwrap_or_default();
    names(text)
        .into_iter()
        .filter(|name| match &name.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            ["crate", "panels", other, ..] => *other != own,
            ["super", other, ..] => {
                path.matches('/').count() == 2 && *other != own && *other != "super"
            }
            _ => false,
        })
        .map(|name| format!("{path} names another panel: {}", name.join("::")))
        .collect()
}

/// Names of the dependencies of a manifest, those of tests left out.
fn dependencies(manifest: &str) -> Vec<String> {
    let mut in_dependencies = false;
    let mut found = Vec::new();
    for line in manifest.lines().map(str::trim) {
        if line.starts_with('[') {
            in_dependencies = line.ends_with("dependencies]") && !line.contains("dev-");
        } else if in_dependencies && let Some((name, _)) = line.split_once(['.', '=', ' ']) {
            found.push(name.trim().to_owned());
        }
    }
    found
}

mod checker {
    use super::*;

    /// Whether a line in this file would be refused.
    fn refuses(path: &str, line: &str) -> bool {
        !broken_rules(path, line).is_empty() || !named_panels(path, line).is_empty()
    }

    #[test]
    fn refuses_every_forbidden_arrow() {
        for (path, line) in [
            ("crates/octoscope-core/src/query.rs", "use std::fs;"),
            ("crates/octoscope-core/src/query.rs", "use std::{fmt, time::Instant};"),
            ("crates/octoscope-core/src/query.rs", "let n = std::env::var(\"N\");"),
            ("crates/octoscope-core/src/query.rs", "std::thread::spawn(f);"),
            ("crates/octoscope-core/src/query.rs", "use eframe::egui::Ui;"),
            ("crates/octoscope-core/src/query.rs", "use octoscope_figure::svg;"),
            ("crates/octoscope-core/src/geometry/ray.rs", "use crate::tree::Tree;"),
            ("crates/octoscope-core/src/geometry/ray.rs", "use crate::{tree::{Code, Tree}};"),
            ("crates/octoscope-core/src/tree/grow.rs", "use crate::{\n    traverse::clip,\n};"),
            ("crates/octoscope-core/src/tree/grow.rs", "use crate::trace::Trace;"),
            ("crates/octoscope-core/src/traverse/codes.rs", "use crate::{event, trace::record};"),
            ("crates/octoscope-core/src/locate/point.rs", "crate::trace::record(tree)"),
            ("crates/octoscope-figure/src/svg.rs", "use octoscope_import::import;"),
            ("crates/octoscope-import/src/lib.rs", "use octoscope_figure::Mark;"),
            ("crates/octoscope-import/src/lib.rs", "egui::Color32::RED"),
            ("src/panels/codes.rs", "use eframe::wgpu::Device;"),
            ("src/app.rs", "rfd::AsyncFileDialog::new()"),
            ("src/cli/visit.rs", "use std::fs::read;"),
            ("src/cli/visit.rs", "use crate::app::run;"),
            ("src/panels/codes.rs", "use crate::panels::region;"),
            ("src/panels/codes.rs", "use super::region::ui;"),
        ] {
            assert!(refuses(path, line), "{path}: {line}");
        }
    }

    #[test]
    fn allows_what_points_down() {
        for (path, line) in [
            ("crates/octoscope-core/src/query.rs", "use crate::tree::Tree;"),
            ("crates/octoscope-core/src/query.rs", "// std::fs is for others"),
            ("crates/octoscope-core/src/query.rs", "let s = \"std::fs::read\";"),
            ("crates/octoscope-core/src/threads.rs", "use std::thread;"),
            (
                "crates/octoscope-core/src/query.rs",
                "use std::fmt;\n#[cfg(test)]\nmod tests { use std::fs; }",
            ),
            ("crates/octoscope-core/src/geometry/ray.rs", "let tree = 1; trace(tree)"),
            ("crates/octoscope-core/src/trace/record.rs", "use crate::traverse::Algorithm;"),
            ("src/render/boxes.rs", "use eframe::wgpu;"),
            ("src/files.rs", "std::fs::read(path)"),
            ("src/panels/codes.rs", "use crate::view::View; crate::panels::codes::ui()"),
            ("src/panels/mod.rs", "super::panels::codes::ui()"),
        ] {
            assert!(!refuses(path, line), "{path}: {line}");
        }
    }

    #[test]
    fn reads_dependencies_but_not_those_of_tests() {
        let manifest = "[package]\nname = \"x\"\n[dependencies]\neframe = { version = \"1\" }\n\
                        serde.workspace = true\n[dev-dependencies]\nimage = \"1\"\n";
        assert_eq!(dependencies(manifest), ["eframe", "serde"]);
    }
}
