//! What is wrong with the text of a scenario, as its author knows it.

use super::place::{Spot, line_and_column, spot_before, spot_of};
use super::{BUILT_IN, Fault, ScenarioError};
use crate::text::{Argument, Language, Message};
use serde_json::error::Category;

/// Explains an error of the reader in `text`; `dimension` is that of the
/// scenario, if it is known already.
pub(super) fn explained(
    error: &serde_json::Error,
    text: &str,
    dimension: Option<usize>,
) -> ScenarioError {
    let message = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&place).unwrap_or(&message);
    let line_start = text.split_inclusive('\n').take(error.line().saturating_sub(1));
    let offset = line_start.map(str::len).sum::<usize>() + error.column();
    let (offset, told) = match error.classify() {
        Category::Syntax | Category::Eof | Category::Io => of_syntax(message, text, offset),
        Category::Data => of_data(message, text, &spot_before(text, offset), dimension),
    };
    let [line, column] = line_and_column(text, offset);
    ScenarioError { line, column, fault: Fault::Field(told) }
}

/// What breaks the rules of JSON, and where.
fn of_syntax(message: &str, text: &str, offset: usize) -> (usize, Message) {
    let last = text.floor_char_boundary(offset.saturating_sub(1));
    let end = text.trim_end().len();
    let of_word = |key, start| (start, Message::new(key).with("word", word_at(text, start)));
    let plain = |key, start| (start, Message::new(key));
    match message {
        "EOF while parsing a value" if end == 0 => {
            (0, Message::new("field-empty").with("least", LEAST))
        }
        "EOF while parsing a value" => plain("field-no-value", end),
        "EOF while parsing a string" => plain("field-open-text", end),
        "EOF while parsing an object" => plain("field-open-object", end),
        "EOF while parsing a list" => plain("field-open-list", end),
        "expected `:`" => of_word("field-colon", last),
        "expected `,` or `}`" => of_word("field-comma-in-object", last),
        "expected `,` or `]`" => of_word("field-comma-in-list", last),
        "trailing comma" => plain("field-comma-too-many", last),
        "key must be a string" => of_word("field-no-name", last),
        "number out of range" | "invalid number" => {
            of_word("field-no-number", spot_before(text, offset).start)
        }
        "expected value" | "expected ident" => {
            let spot = spot_before(text, offset);
            of_word("field-strange-value", if spot.end > last { spot.start } else { last })
        }
        "trailing characters" => of_word("field-behind-the-end", last),
        "recursion limit exceeded" => plain("field-too-deep", last),
        other if other.starts_with("control character") => plain("field-control", last),
        "invalid escape" => of_word("field-escape", last),
        other => (last, Message::new("field-json").with("details", other)),
    }
}

/// What is no scenario, though it is JSON, and where.
fn of_data(message: &str, text: &str, spot: &Spot, dimension: Option<usize>) -> (usize, Message) {
    let names: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    let name = names.first().copied().unwrap_or_default();
    let known = names.get(1..).unwrap_or_default();
    let there_are = || {
        let listed = |key| Message::new(key).with("known", known.join(", "));
        match nearest(name, known) {
            Some(near) => listed("field-one-of").with("near", near),
            None => listed("field-there-are"),
        }
    };
    let value = || word_at(text, spot.start);
    let is = |kind: &str| message.starts_with(kind);
    let is_name = text[spot.end..].trim_start().starts_with(':');
    let told = if is("unknown field `") || is("unknown variant `") && is_name {
        Message::new("field-unknown").with("name", name).with("due", there_are())
    } else if is("unknown variant `") {
        let told = Message::new("field-value").with("path", of_path(&spot.path));
        told.with("value", value()).with("due", there_are())
    } else if is("missing field `") {
        let path = if spot.path.is_empty() { name } else { &format!("{}.{name}", spot.path) };
        Message::new("field-missing").with("name", name).with("due", due(path, dimension, text))
    } else if is("duplicate field `") {
        Message::new("field-twice").with("name", name)
    } else if is("invalid ") {
        let key = if is_name { "field-otherwise" } else { "field-value" };
        let told = Message::new(key).with("path", of_path(&spot.path)).with("value", value());
        told.with("due", due(&spot.path, dimension, text))
    } else {
        // What the fields say themselves.
        Message::new("field-said").with("details", message)
    };
    (spot.start, told)
}

fn of_path(path: &str) -> Message {
    match path {
        "" => Message::new("field-whole"),
        path => Message::new("field-path").with("path", path),
    }
}

/// The beginning of what stands at `start`.
fn word_at(text: &str, start: usize) -> Argument {
    const MOST: usize = 24;
    let rest = text.get(start..).unwrap_or_default();
    let Some(first) = rest.chars().next() else { return Message::new("field-end").into() };
    let length = match first {
        '"' => rest[1..].find('"').map_or(rest.len(), |end| end + 2),
        '{' | '[' => rest.find('\n').unwrap_or(rest.len()),
        c if "}]:,".contains(c) => 1,
        _ => {
            let is_end = |c: char| c.is_whitespace() || "{}[]:,\"".contains(c);
            rest.find(is_end).unwrap_or(rest.len()).max(first.len_utf8())
        }
    };
    let word = rest[..length].trim_end();
    let mut short: String = word.chars().take(MOST).collect();
    if word.chars().count() > MOST {
        short.push('…');
    }
    short.into()
}

/// The least that a scenario is.
pub const LEAST: &str = r#"{"octoscope": 1, "scene": {"built-in": "cloud"}}"#;

/// Key of what is right at a path, without the indices of lists.
const DUE: [(&str, &str); 45] = [
    ("octoscope", "due-octoscope"),
    ("dimension", "due-dimension"),
    ("domain", "due-domain"),
    ("domain.min", "due-vector"),
    ("domain.side", "due-domain-side"),
    ("scene", "due-scene"),
    ("scene.built-in", "due-scene-built-in"),
    ("scene.parameters", "due-scene-parameters"),
    ("scene.parameters.seed", "due-whole"),
    ("scene.parameters.n", "due-range"),
    ("scene.points", "due-scene-points"),
    ("scene.cells", "due-scene-cells"),
    ("scene.image", "due-scene-image"),
    ("scene.image.width", "due-pixels"),
    ("scene.image.height", "due-pixels"),
    ("scene.image.rows", "due-scene-image-rows"),
    ("scene.spheres", "due-scene-spheres"),
    ("scene.spheres.centre", "due-vector"),
    ("scene.spheres.radius", "due-domain-side"),
    ("scene.boxes", "due-scene-boxes"),
    ("scene.boxes.min", "due-vector"),
    ("scene.boxes.max", "due-vector"),
    ("scene.triangles", "due-scene-triangles"),
    ("scene.file", "due-scene-file"),
    ("scene.hash", "due-scene-hash"),
    ("build", "due-build"),
    ("build.depth", "due-depth"),
    ("build.capacity", "due-build-capacity"),
    ("build.threshold", "due-build-threshold"),
    ("ray", "due-ray"),
    ("ray.origin", "due-vector"),
    ("ray.direction", "due-ray-direction"),
    ("query", "due-query"),
    ("query.ray", "due-query-ray"),
    ("query.point", "due-query-point"),
    ("query.point.at", "due-vector"),
    ("query.region", "due-query-region"),
    ("query.region.min", "due-vector"),
    ("query.region.max", "due-vector"),
    ("query.neighbour", "due-query-neighbour"),
    ("query.neighbour.level", "due-depth"),
    ("query.neighbour.code", "due-query-neighbour-code"),
    ("query.neighbour.direction", "due-query-neighbour-direction"),
    ("step", "due-step"),
    ("view", "due-view"),
];

/// What would be right at `path` of `text`.
fn due(path: &str, dimension: Option<usize>, text: &str) -> Message {
    let mut plain = String::new();
    let mut depth = 0;
    for c in path.chars() {
        match c {
            '[' => depth += 1,
            ']' => depth -= 1,
            c if depth == 0 => plain.push(c),
            _ => {}
        }
    }
    let n: Argument = match dimension {
        Some(dimension) => dimension.to_string().into(),
        None => Message::new("due-two-or-three").into(),
    };
    match DUE.iter().find(|(path, _)| *path == plain) {
        Some((_, "due-range")) => match most_of_scene(text) {
            Some(most) => Message::new("due-range-to").with("most", most.to_string()),
            None => Message::new("due-range"),
        },
        Some((_, right)) => Message::new(right).with("n", n),
        None if path.is_empty() => Message::new("due-scenario").with("least", LEAST),
        None => Message::new("due-text"),
    }
}

/// How far the parameter of the built-in scene that `text` names goes, if it has one.
fn most_of_scene(text: &str) -> Option<u32> {
    let spot = spot_of(text, "scene.built-in");
    let name = text[spot.start..spot.end].trim_matches('"');
    let known = BUILT_IN.iter().find(|entry| entry.id == name);
    known.and_then(|entry| entry.n).map(|[_, most]| most)
}

/// Source of the texts of what is wrong with the fields of a scenario, in `language`.
pub fn scenario_texts(language: Language) -> &'static str {
    match language {
        Language::English => include_str!("../../../../assets/texts/en/scenarios.ftl"),
        Language::German => include_str!("../../../../assets/texts/de/scenarios.ftl"),
    }
}

/// The known name that differs least from `name`, unless all differ much.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let near = |other: &&&str| {
        2 * distance(name, other) <= name.chars().count().max(other.chars().count())
    };
    known.iter().filter(near).min_by_key(|other| distance(name, other)).copied()
}

/// Fewest letters to add, take away or change [Levenshtein 1966]. O(n·m).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, c) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, d) in b.iter().enumerate() {
            let changed = diagonal + usize::from(c.to_lowercase().ne(d.to_lowercase()));
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Texts;

    #[test]
    fn the_nearest_name_is_one_that_could_be_meant() {
        let known = ["ray", "query", "depth", "neighbour"];
        assert_eq!(nearest("raay", &known), Some("ray"));
        assert_eq!(nearest("Depht", &known), Some("depth"));
        assert_eq!(nearest("neighbor", &known), Some("neighbour"));
        assert_eq!(nearest("colour", &known), None);
        assert_eq!(nearest("x", &known), None);
    }

    #[test]
    fn every_text_is_there_in_every_language_and_none_is_for_nothing() {
        let source = include_str!("fault.rs").split("mod tests").next().unwrap();
        for language in Language::ALL {
            let texts = Texts::new(language, &[scenario_texts(language)]);
            let named = source.split('"').filter(|word| {
                !word.contains(' ') && (word.starts_with("due-") || word.starts_with("field-"))
            });
            assert!(named.clone().count() > 60);
            named.for_each(|key| assert!(texts.has(key), "{key} in {language:?}"));
            let lines = scenario_texts(language).lines().filter(|line| !line.starts_with('#'));
            for (key, _) in lines.filter_map(|line| line.split_once(" = ")) {
                assert!(source.contains(&format!("\"{key}\"")), "{key} in {language:?}");
            }
        }
    }

    #[test]
    fn what_is_right_is_known_of_every_field_of_the_schema() {
        let schema = include_str!("../../../../assets/schemas/octo.schema.json");
        let schema: serde_json::Value = serde_json::from_str(schema).unwrap();
        let mut wanted = vec![(String::new(), &schema)];
        let mut n_fields = 0;
        while let Some((path, part)) = wanted.pop() {
            for (name, field) in part["properties"].as_object().into_iter().flatten() {
                let path = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
                // Names from a list are told with that list.
                let listed = field["enum"][0].is_string() || path.starts_with("options");
                assert!(listed || DUE.iter().any(|(known, _)| *known == path), "{path}");
                n_fields += 1;
                wanted.push((path.clone(), field));
                wanted.push((path, &field["items"]));
            }
        }
        assert!(n_fields > 30, "{n_fields}");
    }
}
