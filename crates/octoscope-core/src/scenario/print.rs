//! Writing scenario files.

use super::{AnyScenario, Scenario, Source, StepAt, default_ray, read::VERSION};
use crate::query::Query;
use crate::scene::{Content, Cube, Image};
use crate::traverse::Variants;
use crate::tree::Recipe;
use serde::Serialize;
use std::fmt::Display;

impl AnyScenario {
    /// The scenario as the JSON of an `.octo` file, which
    /// [`AnyScenario::parse`] reads back equal if its numbers are finite.
    pub fn print(&self) -> String {
        match self {
            Self::Quadtree(scenario) => print(scenario),
            Self::Octree(scenario) => print(scenario),
        }
    }
}

fn print<const D: usize>(scenario: &Scenario<D>) -> String {
    let Scenario { domain, source, recipe, ray, query, step, view } = scenario;
    let mut fields = vec![("octoscope", VERSION.to_string()), ("dimension", D.to_string())];
    let open = matches!(source, Source::File { fit: true, .. });
    if !open {
        let (min, side) = (vector(domain.min), number(domain.side));
        fields.push(("domain", object(&[("min", min), ("side", side)])));
    }
    fields.push(("scene", scene(source)));
    fields.push(("build", build(recipe)));
    if !open || *ray != default_ray(&Cube::UNIT) {
        let [origin, direction] = [ray.origin(), ray.direction()].map(vector);
        fields.push(("ray", object(&[("origin", origin), ("direction", direction)])));
    }
    match query {
        Query::Ray { algorithm, options, arithmetic } => {
            fields.push(("query", word(&"ray")));
            fields.push(("algorithm", word(algorithm)));
            fields.push(("options", word(options)));
            fields.push(("arithmetic", word(arithmetic)));
        }
        Query::Point { at, method, variants } => {
            let point = vec![("at", vector(*at)), ("method", word(method))];
            fields.push(("query", asked("point", point, *variants)));
        }
        Query::Region { min, max, variants } => {
            let region = vec![("min", vector(*min)), ("max", vector(*max))];
            fields.push(("query", asked("region", region, *variants)));
        }
        Query::Neighbour { level, code, direction, reach, method, variants } => {
            let neighbour = vec![
                ("level", level.to_string()),
                ("code", list(code)),
                ("direction", list(&direction.components())),
                ("reach", word(reach)),
                ("method", word(method)),
            ];
            fields.push(("query", asked("neighbour", neighbour, *variants)));
        }
    }
    let step = match step {
        StepAt::First => word(&"first"),
        StepAt::Last => word(&"last"),
        StepAt::At(step) => step.to_string(),
    };
    fields.push(("step", step));
    fields.push(("view", word(view)));
    let lines: Vec<String> =
        fields.iter().map(|(name, value)| format!("  \"{name}\": {value}")).collect();
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

/// A query that is no ray, with its variants if there are any.
fn asked(kind: &str, mut fields: Vec<(&str, String)>, variants: Variants) -> String {
    if !variants.is_empty() {
        fields.push(("variants", word(&variants)));
    }
    object(&[(kind, object(&fields))])
}

fn build(recipe: &Recipe) -> String {
    let Recipe { depth, capacity, merge, threshold, fill } = recipe;
    object(&[
        ("depth", depth.to_string()),
        ("capacity", capacity.to_string()),
        ("merge", word(merge)),
        ("threshold", threshold.to_string()),
        ("fill", word(fill)),
    ])
}

fn scene<const D: usize>(source: &Source<D>) -> String {
    match source {
        Source::BuiltIn { name, parameters } => {
            object(&[("built-in", word(name)), ("parameters", word(parameters))])
        }
        Source::File { path, hash, fit: _ } => {
            object(&[("file", word(path)), ("hash", word(hash))])
        }
        Source::Inline(Content::Points(points)) => {
            object(&[("points", items(points.iter().map(|p| vector(*p))))])
        }
        Source::Inline(Content::Cells(cells)) => {
            object(&[("cells", items(cells.iter().map(|c| list(c))))])
        }
        Source::Inline(Content::Image(image)) => object(&[("image", picture(image))]),
        Source::Inline(Content::Spheres(spheres)) => {
            let sphere = spheres
                .iter()
                .map(|s| object(&[("centre", vector(s.centre)), ("radius", number(s.radius))]));
            object(&[("spheres", items(sphere))])
        }
        Source::Inline(Content::Boxes(boxes)) => {
            let corners =
                boxes.iter().map(|b| object(&[("min", vector(b.min)), ("max", vector(b.max))]));
            object(&[("boxes", items(corners))])
        }
        Source::Inline(Content::Triangles(triangles)) => {
            object(&[("triangles", items(triangles.iter().map(|t| list(&t.map(vector)))))])
        }
    }
}

fn picture(image: &Image) -> String {
    let pixel = |&[r, g, b]: &[u8; 3]| match r == g && g == b {
        true => format!("{r:02x}"),
        false => format!("{r:02x}{g:02x}{b:02x}"),
    };
    let width = image.width as usize;
    let row = |row: usize| {
        let pixels = &image.pixels[row * width..(row + 1) * width];
        word(&pixels.iter().map(pixel).collect::<Vec<_>>().join(" "))
    };
    object(&[
        ("width", image.width.to_string()),
        ("height", image.height.to_string()),
        ("rows", items((0..image.height as usize).map(row))),
    ])
}

/// As short as it reads back, without a fraction where there is none.
fn number(x: f64) -> String {
    let text = format!("{x:?}");
    match text.strip_suffix(".0") {
        Some(integer) if integer != "-0" => integer.to_owned(),
        _ => text,
    }
}

fn vector<const D: usize>(numbers: [f64; D]) -> String {
    list(&numbers.map(number))
}

fn list(values: &[impl Display]) -> String {
    let values: Vec<String> = values.iter().map(ToString::to_string).collect();
    format!("[{}]", values.join(", "))
}

/// One item a line.
fn items(values: impl Iterator<Item = String>) -> String {
    let lines: Vec<String> = values.map(|value| format!("    {value}")).collect();
    if lines.is_empty() { "[]".to_owned() } else { format!("[\n{}\n  ]", lines.join(",\n")) }
}

fn object(fields: &[(&str, String)]) -> String {
    let fields: Vec<String> =
        fields.iter().map(|(name, value)| format!("\"{name}\": {value}")).collect();
    format!("{{{}}}", fields.join(", "))
}

/// A value as JSON on one line.
fn word(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("texts and names always have a JSON form")
}
