//! Every sign of every text is in the typefaces.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_figure::fonts;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use ttf_parser::Face;

/// Files below the workspace's folder of this name with one of these endings.
fn files(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, endings, found);
        } else if path.extension().is_some_and(|end| endings.iter().any(|e| end == *e)) {
            found.push(path);
        }
    }
}

/// What of a source is no comment, line by line, and no test.
fn code(source: &str) -> String {
    let source = source.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = source.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn every_sign_of_every_text_is_in_the_typefaces() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    for (folder, endings) in [
        ("assets/texts", &["ftl"][..]),
        ("assets/listings", &["txt"]),
        ("src", &["rs"]),
        ("crates/octoscope-core/src", &["rs"]),
        ("crates/octoscope-figure/src", &["rs"]),
    ] {
        files(&root.join(folder), endings, &mut found);
    }
    assert!(found.len() > 100, "{}", found.len());
    // Each of the families ends with both of these.
    let [sans, _, mono, _] = fonts::ALL.map(|font| Face::parse(font, 0).unwrap());
    let mut missing: BTreeMap<char, PathBuf> = BTreeMap::new();
    for path in found {
        let text = fs::read_to_string(&path).unwrap();
        let is_source = path.extension().is_some_and(|end| end == "rs");
        let text = if is_source { code(&text) } else { text };
        for sign in text.chars().filter(|sign| !sign.is_control()) {
            if sans.glyph_index(sign).is_none() && mono.glyph_index(sign).is_none() {
                missing.insert(sign, path.clone());
            }
        }
    }
    assert!(missing.is_empty(), "{missing:?}");
}
