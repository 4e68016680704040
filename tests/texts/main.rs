//! What the texts of both languages say, read from the language files and the listings.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::{Path, PathBuf};

/// The same thing said in both languages.
struct Said {
    key: String,
    english: String,
    german: String,
}

fn folder(name: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name);
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|at| at.unwrap().path()).collect();
    files.sort();
    files
}

/// Keys of a language file with their texts, without what is filled in.
fn messages(source: &str) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    for line in source.lines().filter(|line| !line.starts_with('#')) {
        let begins = line.split_once(" =").filter(|_| line.starts_with(|c: char| c.is_lowercase()));
        if let Some((key, text)) = begins {
            found.push((key.to_owned(), text.to_owned()));
        } else if let Some((_, text)) = found.last_mut() {
            text.push_str(line);
        }
    }
    for (_, text) in &mut found {
        let parts = text.split('{').map(|part| part.split_once('}').map_or(part, |(_, rest)| rest));
        *text = parts.collect::<Vec<_>>().join("");
    }
    found
}

/// Everything that is said in both languages.
fn said() -> Vec<Said> {
    let mut all = Vec::new();
    for english in folder("texts/en") {
        let german =
            folder("texts/de").into_iter().find(|de| de.file_name() == english.file_name());
        let [english, german] =
            [english, german.unwrap()].map(|path| messages(&fs::read_to_string(path).unwrap()));
        assert_eq!(english.len(), german.len());
        for ((key, english), (same, german)) in english.into_iter().zip(german) {
            assert_eq!(key, same);
            all.push(Said { key, english, german });
        }
    }
    for listing in folder("listings") {
        for line in fs::read_to_string(&listing).unwrap().lines() {
            let mut columns = line.split('|').map(str::trim).rev();
            if let (Some(german), Some(english)) = (columns.next(), columns.next()) {
                let key = format!("{}: {line}", listing.display());
                all.push(Said { key, english: english.to_owned(), german: german.to_owned() });
            }
        }
    }
    assert!(all.len() > 700, "{}", all.len());
    all
}

#[test]
fn german_calls_a_level_stufe_and_a_plane_ebene() {
    for Said { key, english, german } in said() {
        let english = english.to_lowercase();
        if german.contains("Ebene") {
            assert!(english.contains("plane"), "{key}: {german}");
        }
        if german.contains("Stufe") {
            assert!(english.contains("level"), "{key}: {german}");
        }
    }
}
