//! What is wrong with the text of a scenario, as its author knows it.

use super::place::{Spot, line_and_column, spot_before, spot_of};
use super::{BUILT_IN, Fault, ScenarioError};
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
    let (offset, message) = match error.classify() {
        Category::Syntax | Category::Eof | Category::Io => of_syntax(message, text, offset),
        Category::Data => of_data(message, text, &spot_before(text, offset), dimension),
    };
    let [line, column] = line_and_column(text, offset);
    ScenarioError { line, column, fault: Fault::Field(message) }
}

/// What breaks the rules of JSON, and where.
fn of_syntax(message: &str, text: &str, offset: usize) -> (usize, String) {
    let last = text.floor_char_boundary(offset.saturating_sub(1));
    let word = word_at(text, last);
    let end = text.trim_end().len();
    let (place, message) = match message {
        "EOF while parsing a value" if end == 0 => {
            (0, format!("the text is empty; write {LEAST} at least"))
        }
        "EOF while parsing a value" => {
            (end, "the text ends where a value is due; write what is missing".to_owned())
        }
        "EOF while parsing a string" => {
            (end, "the text ends within quotation marks; close them".to_owned())
        }
        "EOF while parsing an object" => {
            (end, "the text ends within an object; close it with }".to_owned())
        }
        "EOF while parsing a list" => {
            (end, "the text ends within a list; close it with ]".to_owned())
        }
        "expected `:`" => {
            (last, format!("a colon is missing before {word}; write \"name\": value"))
        }
        "expected `,` or `}`" => {
            (last, format!("a comma is missing before {word}, or a }}; write what is due"))
        }
        "expected `,` or `]`" => {
            (last, format!("a comma is missing before {word}, or a ]; write what is due"))
        }
        "trailing comma" => {
            (last, "a comma stands before the closing bracket; take it away".to_owned())
        }
        "key must be a string" => {
            (last, format!("{word} is no name of a field; write the name in quotation marks"))
        }
        "number out of range" | "invalid number" => {
            let spot = spot_before(text, offset);
            let word = word_at(text, spot.start);
            (spot.start, format!("{word} is no number; write one below 1e308, such as -0.25"))
        }
        "expected value" | "expected ident" => {
            let spot = spot_before(text, offset);
            let start = if spot.end > last { spot.start } else { last };
            let word = word_at(text, start);
            (start, format!("{word} is no value; write a finite number or a text in quotes"))
        }
        "trailing characters" => {
            (last, format!("{word} follows the end of the scenario; take it away"))
        }
        "recursion limit exceeded" => {
            (last, "lists and objects are nested more than 127 deep; nest them less".to_owned())
        }
        other if other.starts_with("control character") => (
            last,
            "a text in quotes holds a line end or another control character; write \\n".to_owned(),
        ),
        "invalid escape" => {
            (last, format!("\\ does not go with {word}; write \\\\ for a backslash"))
        }
        other => (last, format!("{other}; write it as JSON asks")),
    };
    (place, message)
}

/// What is no scenario, though it is JSON, and where.
fn of_data(message: &str, text: &str, spot: &Spot, dimension: Option<usize>) -> (usize, String) {
    let names: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    let name = names.first().copied().unwrap_or_default();
    let known = names.get(1..).unwrap_or_default();
    let there_are = || match nearest(name, known) {
        Some(near) => format!("write ‘{near}’, or one of {}", known.join(", ")),
        None => format!("there are {}", known.join(", ")),
    };
    let value = || word_at(text, spot.start);
    let is = |kind: &str| message.starts_with(kind);
    let is_name = text[spot.end..].trim_start().starts_with(':');
    let told = if is("unknown field `") || is("unknown variant `") && is_name {
        format!("there is no field ‘{name}’ here; {}", there_are())
    } else if is("unknown variant `") {
        format!("{} is {}; {}", of_path(&spot.path), value(), there_are())
    } else if is("missing field `") {
        let path = if spot.path.is_empty() { name } else { &format!("{}.{name}", spot.path) };
        format!("the field ‘{name}’ is missing; {}", due(path, dimension, text))
    } else if is("duplicate field `") {
        format!("the field ‘{name}’ is there twice; take one away")
    } else if is("invalid ") && is_name {
        format!("{} is not written so; {}", of_path(&spot.path), due(&spot.path, dimension, text))
    } else if is("invalid ") {
        format!("{} is {}; {}", of_path(&spot.path), value(), due(&spot.path, dimension, text))
    } else {
        // What the fields say themselves.
        message.to_owned()
    };
    (spot.start, told)
}

fn of_path(path: &str) -> String {
    if path.is_empty() { "the whole".to_owned() } else { format!("‘{path}’") }
}

/// The beginning of what stands at `start`.
fn word_at(text: &str, start: usize) -> String {
    const MOST: usize = 24;
    let rest = text.get(start..).unwrap_or_default();
    let Some(first) = rest.chars().next() else { return "the end".to_owned() };
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
    short
}

/// The least that a scenario is.
pub const LEAST: &str = r#"{"octoscope": 1, "scene": {"built-in": "cloud"}}"#;

/// What is right at a path, without the indices of lists; # is the dimension, ~ the end of
/// the range that the built-in scene gives.
const DUE: [(&str, &str); 45] = [
    ("octoscope", "write 1, the version of the format"),
    ("dimension", "write 2 for a quadtree or 3 for an octree"),
    ("domain", r#"write an object with "min" and "side""#),
    ("domain.min", "write # numbers in brackets, one for each axis"),
    ("domain.side", "write a number above 0"),
    ("scene", r#"write an object such as {"built-in": "cloud"}"#),
    ("scene.built-in", r#"write the name of a scene in quotes, such as "cloud""#),
    ("scene.parameters", r#"write an object with "seed" or "n""#),
    ("scene.parameters.seed", "write a whole number from 0"),
    ("scene.parameters.n", "write a whole number from 1~, in digits alone"),
    ("scene.points", "write a list of points of # numbers each"),
    ("scene.cells", "write a list of cells of # whole numbers from 0 each"),
    ("scene.image", r#"write an object with "width", "height" and "rows""#),
    ("scene.image.width", "write a whole number of pixels"),
    ("scene.image.height", "write a whole number of pixels"),
    ("scene.image.rows", r#"write a list of rows such as "00 7f ff""#),
    ("scene.spheres", r#"write a list of objects with "centre" and "radius""#),
    ("scene.spheres.centre", "write # numbers in brackets, one for each axis"),
    ("scene.spheres.radius", "write a number above 0"),
    ("scene.boxes", r#"write a list of objects with "min" and "max""#),
    ("scene.boxes.min", "write # numbers in brackets, one for each axis"),
    ("scene.boxes.max", "write # numbers in brackets, one for each axis"),
    ("scene.triangles", "write a list of triangles of 3 points of # numbers each"),
    ("scene.file", "write a path in quotes, relative to this file"),
    ("scene.hash", r#"write a text in quotes such as "sha256:…", or leave it out"#),
    ("build", r#"write an object such as {"depth": 6}"#),
    ("build.depth", "write a whole number from 0 to 20"),
    ("build.capacity", "write a whole number from 1"),
    ("build.threshold", "write a whole number from 0 to 255"),
    ("ray", r#"write an object with "origin" and "direction""#),
    ("ray.origin", "write # numbers in brackets, one for each axis"),
    ("ray.direction", "write # numbers in brackets, one for each axis, not all of them 0"),
    ("query", r#"write "ray", or an object with "point", "region" or "neighbour""#),
    ("query.ray", r#"write "query": "ray"; its numbers go into the field "ray" beside it"#),
    ("query.point", r#"write an object with "at""#),
    ("query.point.at", "write # numbers in brackets, one for each axis"),
    ("query.region", r#"write an object with "min" and "max""#),
    ("query.region.min", "write # numbers in brackets, one for each axis"),
    ("query.region.max", "write # numbers in brackets, one for each axis"),
    ("query.neighbour", r#"write an object with "level", "code" and "direction""#),
    ("query.neighbour.level", "write a whole number from 0 to 20"),
    ("query.neighbour.code", "write # whole numbers from 0 in brackets, one for each axis"),
    ("query.neighbour.direction", "write # of the numbers -1, 0 and 1 in brackets"),
    ("step", r#"write "first", "last" or a whole number from 0"#),
    ("view", "write an object, or leave it out"),
];

/// What would be right at `path` of `text`.
fn due(path: &str, dimension: Option<usize>, text: &str) -> String {
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
    let number = dimension.map_or("2 or 3".to_owned(), |d| d.to_string());
    match DUE.iter().find(|(path, _)| *path == plain) {
        Some((_, right)) if right.contains('~') => right.replace('~', &most_of_scene(text)),
        Some((_, right)) => right.replace('#', &number),
        None if path.is_empty() => format!("write an object such as {LEAST}"),
        None => "write a text in quotes".to_owned(),
    }
}

/// How far the parameter of the built-in scene that `text` names goes; empty without one.
fn most_of_scene(text: &str) -> String {
    let spot = spot_of(text, "scene.built-in");
    let name = text[spot.start..spot.end].trim_matches('"');
    let known = BUILT_IN.iter().find(|entry| entry.id == name);
    let range = known.and_then(|entry| entry.n);
    range.map_or(String::new(), |[_, most]| format!(" to {most}"))
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
