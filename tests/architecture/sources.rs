//! The sources of the workspace, and the paths that they name.

use std::fs;
use std::path::{Path, PathBuf};

/// Text files of the workspace with one of the `endings`, by their path with
/// slashes, relative to the workspace.
pub fn sources(endings: &[&str]) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders: Vec<PathBuf> = ["src", "crates", "tests", "xtask", "assets", ".cargo"]
        .map(|name| root().join(name))
        .into();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
                found.push(path);
            }
        }
    }
    let top = ["README.md", "ARCHITECTURE.md", "Cargo.toml"].map(|name| root().join(name));
    let top = top.into_iter().filter(|path| path.is_file());
    found.extend(top.filter(|path| endings.iter().any(|e| path.extension().unwrap() == *e)));
    found
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(root()).unwrap().to_str().unwrap().replace('\\', "/");
            (name, fs::read_to_string(&path).unwrap())
        })
        .collect()
}

/// Folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Paths of more than one name in a source, without its comments, strings and
/// tests; `use a::{b, c}` counts as `a::b` and `a::c`.
pub fn names(text: &str) -> Vec<Vec<String>> {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let code = without_comments_and_strings(code);
    let mut names = Vec::new();
    let mut prefixes: Vec<Vec<String>> = Vec::new();
    let mut path: Vec<String> = Vec::new();
    let mut word = String::new();
    let mut characters = code.chars().filter(|c| !matches!(c, '\n' | '\r')).peekable();
    while let Some(c) = characters.next() {
        if c.is_alphanumeric() || c == '_' {
            word.push(c);
            continue;
        }
        let joins = c == ':' && characters.peek() == Some(&':');
        if !word.is_empty() {
            path.push(std::mem::take(&mut word));
        }
        if joins {
            characters.next();
            if characters.peek() == Some(&'{') {
                characters.next();
                let outer = prefixes.last().cloned().unwrap_or_default();
                prefixes.push([outer, std::mem::take(&mut path)].concat());
            }
            continue;
        }
        if !path.is_empty() {
            let prefix = prefixes.last().cloned().unwrap_or_default();
            names.push([prefix, std::mem::take(&mut path)].concat());
        }
        if c == '}' {
            prefixes.pop();
        }
    }
    names.retain(|name| name.len() > 1);
    names
}

/// Source without the text of comments and of string literals.
fn without_comments_and_strings(text: &str) -> String {
    let mut code = String::new();
    for line in text.lines() {
        let mut in_string = false;
        let mut previous = ' ';
        let mut characters = line.chars().peekable();
        while let Some(c) = characters.next() {
            if !in_string && c == '/' && characters.peek() == Some(&'/') {
                break;
            }
            if c == '"' && previous != '\\' && previous != '\'' {
                in_string = !in_string;
            } else if !in_string {
                code.push(c);
            }
            previous = if previous == '\\' { ' ' } else { c };
        }
        code.push(' ');
    }
    code
}
