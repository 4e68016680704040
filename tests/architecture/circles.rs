//! The top modules of the program: none names, by way of others, what names it.

use crate::sources::{names, sources};
use std::collections::{BTreeMap, BTreeSet};

/// Every module with the modules that it names, each with a file that does so.
type Arrows = BTreeMap<String, BTreeMap<String, String>>;

#[test]
fn no_modules_of_the_program_name_each_other_in_a_circle() {
    let arrows = arrows(&sources(&["rs"]));
    assert!(arrows["window"].contains_key("app"), "{arrows:?}");
    let circle = circle(&arrows);
    assert!(
        circle.is_empty(),
        "modules of src name each other in a circle; move what is named to where it belongs:\n{}",
        told(&arrows, &circle)
    );
}

/// What the sources of the program name of it, by paths and texts; tests apart.
fn arrows(sources: &[(String, String)]) -> Arrows {
    let own = sources.iter().filter_map(|(path, text)| Some((path, module_of(path)?, text)));
    let own: Vec<_> = own.filter(|(path, ..)| !path.ends_with("/tests.rs")).collect();
    let modules: BTreeSet<&str> = own.iter().map(|(_, module, _)| *module).collect();
    let mut arrows: Arrows =
        modules.iter().map(|module| ((*module).to_owned(), BTreeMap::new())).collect();
    for (path, module, text) in own {
        for name in names(text) {
            let Some(named) = named(path, &name) else { continue };
            if named != module && modules.contains(named) {
                let from = arrows.entry(module.to_owned()).or_default();
                from.entry(named.to_owned()).or_insert_with(|| path.clone());
            }
        }
    }
    arrows
}

/// The top module to which a file belongs; `None` for the roots of the program.
fn module_of(path: &str) -> Option<&str> {
    let module = path.strip_prefix("src/")?.split(['/', '.']).next()?;
    Some(module).filter(|module| !matches!(*module, "main" | "lib"))
}

/// What a path in a file names below the root of the program.
fn named<'a>(path: &str, name: &'a [String]) -> Option<&'a str> {
    let depth = path.strip_suffix("/mod.rs").unwrap_or(path).matches('/').count();
    let n_up = name.iter().take_while(|part| *part == "super").count();
    let below = match name {
        [first, below @ ..] if first == "crate" => below,
        _ if n_up == depth => &name[n_up..],
        _ => return None,
    };
    below.first().map(String::as_str)
}

/// Modules of which each names the next, and the last one the first; none, if none do.
fn circle(arrows: &Arrows) -> Vec<&str> {
    let mut left: BTreeSet<&str> = arrows.keys().map(String::as_str).collect();
    let next = |module: &str, left: &BTreeSet<&str>| -> Option<&str> {
        arrows[module].keys().map(String::as_str).find(|named| left.contains(named))
    };
    // What names nothing that is left is in no circle.
    while let Some(end) = left.iter().copied().find(|module| next(module, &left).is_none()) {
        left.remove(end);
    }
    // Whoever goes on and on among the others comes back.
    let mut way: Vec<&str> = left.first().copied().into_iter().collect();
    while let Some(named) = way.last().and_then(|module| next(module, &left)) {
        if let Some(start) = way.iter().position(|module| *module == named) {
            return way.split_off(start);
        }
        way.push(named);
    }
    way
}

/// A circle, arrow by arrow, each with the file that makes it.
fn told(arrows: &Arrows, circle: &[&str]) -> String {
    let next = circle.iter().cycle().skip(1);
    let arrow = |(from, to): (&&str, &&str)| format!("{from} names {to} in {}", arrows[*from][*to]);
    circle.iter().zip(next).map(arrow).collect::<Vec<_>>().join("\n")
}

mod checker {
    use super::*;

    fn check(files: &[(&str, &str)], expected: &str) {
        let sources: Vec<_> =
            files.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect();
        let arrows = arrows(&sources);
        assert_eq!(told(&arrows, &circle(&arrows)), expected);
    }

    #[test]
    fn a_circle_is_told_arrow_by_arrow() {
        check(
            &[
                ("src/lib.rs", "pub mod a;\npub mod b;"),
                ("src/a.rs", "use crate::b::B;"),
                ("src/b/mod.rs", "mod part;"),
                ("src/b/part.rs", "use super::super::d;\nuse super::super::{d::D, e};"),
                ("src/c.rs", "use crate::{a::A, e};"),
                ("src/d.rs", "fn f() { crate::a::f() }"),
                ("src/e.rs", ""),
            ],
            "a names b in src/a.rs\nb names d in src/b/part.rs\nd names a in src/d.rs",
        );
        check(
            &[("src/a.rs", "use super::b;"), ("src/b.rs", "use super::a::A;")],
            "a names b in src/a.rs\nb names a in src/b.rs",
        );
    }

    #[test]
    fn what_points_down_is_no_circle_nor_is_what_a_test_names() {
        check(
            &[
                ("src/a.rs", "use crate::b::B; use crate::c::C;\nmod part;"),
                ("src/a/part.rs", "use super::b; use crate::a::A;"),
                ("src/b.rs", "use crate::c::C;\n#[cfg(test)]\nmod tests { use crate::a::A; }"),
                ("src/c.rs", "// crate::a::A\nlet s = \"crate::a::A\";"),
                ("src/c/tests.rs", "use crate::a::A;"),
                ("crates/x/src/c.rs", "use crate::a::A;"),
            ],
            "",
        );
    }
}
