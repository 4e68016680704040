//! Traces as files: text to read, JSON lines and CSV to work with.

use super::sentence::sentences;
use crate::event::{End, Event, Halves, Lookup};
use crate::geometry::{Axes, Ray};
use crate::query::Query;
use crate::text::Language;
use crate::trace::{Moment, Trace};
use crate::tree::{Part, Tree};
use serde_json::{Map, Value, json};

/// The steps of `trace` as numbered sentences, a line each; step 0 says what is
/// asked.
pub fn trace_text<const D: usize>(
    tree: &Tree<D>,
    ray: &Ray<D>,
    trace: &Trace<D>,
    language: Language,
) -> String {
    let width = trace.events.len().to_string().len();
    let sentences = sentences(tree, ray, trace, language);
    let line =
        |(step, text): (usize, super::RichText)| format!("{step:width$}  {}\n", text.plain());
    sentences.enumerate().map(line).collect()
}

/// `trace` as JSON lines: a header, then one object a step.
///
/// The header has `octoscope-trace` (version 1), `dimension`, `domain` (`min`,
/// `side`), `root_level`, `ray` (`origin`, `direction`), `child_numbering`
/// (`x-most-significant`) and what is asked: `query` (`ray`, `point`, `region` or
/// `neighbour`), of a ray by which `algorithm`, and the `variants` of its rules that are
/// followed, such as `B-2`. A step has:
/// * `event`: its name, the same as in the listing; `end` for the last one;
/// * `node`: `[level, x, y]` or `[level, x, y, z]`, the node at which the
///   algorithm is after the step, if at any; codes are those of its minimum
///   corner;
/// * `t`: `[enter, exit]`, where the step is about an interval of the ray;
/// * `state`: the child index in the mirrored numbering, where there is one;
/// * `vars`: the numbers of the event, by name; sets of axes and `mirror` are
///   numbers with x as the most significant bit.
///
/// Numbers read back exactly; those that JSON lacks are the strings `inf`,
/// `-inf` and `nan`.
pub fn trace_jsonl<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, trace: &Trace<D>) -> String {
    let (domain, query) = (tree.domain(), &trace.query);
    let mut header = json!({
        "octoscope-trace": 1,
        "dimension": D,
        "domain": { "min": numbers(domain.min()), "side": number(domain.side()) },
        "root_level": domain.root_level(),
        "ray": { "origin": numbers(ray.origin()), "direction": numbers(ray.direction()) },
        "child_numbering": "x-most-significant",
        "query": kind_of(query),
        "variants": query.variants_at_work(),
    });
    if let Query::Ray { algorithm, .. } = query {
        header["algorithm"] = json!(algorithm);
    }
    let mut lines = format!("{header}\n");
    for step in steps(tree, trace) {
        let mut object = Map::new();
        object.insert("event".to_owned(), step.event.into());
        if let Some(node) = step.node {
            object.insert("node".to_owned(), node.into());
        }
        if let Some(interval) = step.interval {
            object.insert("t".to_owned(), numbers(interval));
        }
        if let Some(state) = step.state {
            object.insert("state".to_owned(), state.into());
        }
        object.insert("vars".to_owned(), step.vars);
        lines += &format!("{}\n", Value::Object(object));
    }
    lines
}

/// What is asked for, by the name that scenarios have for it.
fn kind_of<const D: usize>(query: &Query<D>) -> &'static str {
    match query {
        Query::Ray { .. } => "ray",
        Query::Point { .. } => "point",
        Query::Region { .. } => "region",
        Query::Neighbour { .. } => "neighbour",
    }
}

/// `trace` as comma-separated values, with a line of names: the number of the
/// step from 1, then what [`trace_jsonl`] has, an empty field where it has
/// nothing; `vars` is JSON in quotes.
pub fn trace_csv<const D: usize>(tree: &Tree<D>, trace: &Trace<D>) -> String {
    let axes = &crate::geometry::AXIS_NAMES[..D];
    let mut lines = format!("step,event,level,{},enter,exit,state,vars\n", axes.join(","));
    for (index, step) in steps(tree, trace).into_iter().enumerate() {
        let node = step
            .node
            .map_or(vec![String::new(); D + 1], |node| node.iter().map(u32::to_string).collect());
        let interval = step.interval.map_or([String::new(), String::new()], |t| {
            t.map(|t| number(t).to_string().replace('"', ""))
        });
        let state = step.state.map_or(String::new(), |state| state.to_string());
        let vars = step.vars.to_string().replace('"', "\"\"");
        let [node, interval] = [node.join(","), interval.join(",")];
        lines += &format!("{},{},{node},{interval},{state},\"{vars}\"\n", index + 1, step.event);
    }
    lines
}

/// What a file tells of one step.
#[derive(Default)]
pub(super) struct Step {
    pub(super) event: &'static str,
    pub(super) node: Option<Vec<u32>>,
    pub(super) interval: Option<[f64; 2]>,
    state: Option<u8>,
    vars: Value,
}

pub(super) fn steps<const D: usize>(tree: &Tree<D>, trace: &Trace<D>) -> Vec<Step> {
    let mut moment = Moment::default();
    let step = |event: &Event<D>| {
        moment.apply(tree, event);
        let place = |id| [&[u32::from(tree.level(id))][..], &tree.code(id)].concat();
        let (interval, state) = interval_and_state(event);
        let node = moment.current.map(place);
        let event_name = match event {
            Event::End(_) => "end",
            other => super::label(other),
        };
        Step { event: event_name, node, interval, state, vars: vars(event) }
    };
    trace.events.iter().map(step).collect()
}

fn interval_and_state<const D: usize>(event: &Event<D>) -> (Option<[f64; 2]>, Option<u8>) {
    match *event {
        Event::Clip { enter, exit, .. } | Event::Leaf { enter, exit, .. } => {
            (Some([enter, exit]), None)
        }
        Event::Test { interval, .. } => (interval, None),
        Event::Enter { interval, .. }
        | Event::Split { interval, .. }
        | Event::Pop { interval, .. } => (Some(interval), None),
        Event::Touch { at, .. } => (Some([at, at]), None),
        Event::Visit { state, .. } => (None, state.map(|state| state.0)),
        Event::First { state, .. } | Event::Step { state, .. } => (None, Some(state.0)),
        Event::Sort { .. }
        | Event::Skip { .. }
        | Event::Halve { .. }
        | Event::Up { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Mirror { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Push { .. }
        | Event::Begin { .. }
        | Event::Encode { .. }
        | Event::Compare { .. }
        | Event::Follow { .. }
        | Event::Exits { .. }
        | Event::Target { .. }
        | Event::Border { .. }
        | Event::Difference { .. }
        | Event::Climb { .. }
        | Event::Leave { .. }
        | Event::Resume { .. }
        | Event::Corners { .. }
        | Event::Found { .. }
        | Event::End(_) => (None, None),
    }
}

/// The numbers of an event that are not told elsewhere.
fn vars<const D: usize>(event: &Event<D>) -> Value {
    let codes = |code: [u32; D]| Value::from(code.to_vec());
    let set = |axes: Axes<D>| Value::from(axes.0);
    match *event {
        Event::Clip { near, far, hit, mirror, .. } => {
            json!({ "t0": numbers(near), "t1": numbers(far), "hit": hit, "mirror": set(mirror) })
        }
        Event::Test { interval, touch, .. } => {
            json!({ "hit": interval.is_some(), "touch": touch })
        }
        Event::Sort { n_leaves } => json!({ "n_leaves": n_leaves }),
        Event::Visit { near, far, .. } => json!({ "t0": numbers(near), "t1": numbers(far) }),
        Event::Skip { exit, behind } => json!({ "exit": number(exit), "behind": behind }),
        Event::Halve { mid, .. } => json!({ "tm": numbers(mid) }),
        Event::First { entry, entry_axis, compared, .. } => json!({
            "entry": number(entry), "entry_axis": entry_axis, "compared": set(compared),
        }),
        Event::Step { exits, axes, next, .. } => json!({
            "t1": numbers(exits), "axes": set(axes), "next": next.map(|next| next.0),
        }),
        Event::Encode { point, code, after, .. } => json!({
            "point": numbers(point), "code": codes(code), "after": after.map(number),
        }),
        Event::Compare { mid, point, child, .. } => {
            json!({ "mid": numbers(mid), "point": numbers(point), "child": child.0 })
        }
        Event::Follow { level, code, child, .. } => {
            json!({ "bit": level - 1, "code": codes(code), "child": child.0 })
        }
        Event::Exits { planes, exits, axes } => {
            json!({ "planes": numbers(planes), "t1": numbers(exits), "axes": set(axes) })
        }
        Event::Resume { popped, .. } => json!({ "popped": popped }),
        Event::Leave { exits, axes } => json!({ "t1": numbers(exits), "axes": set(axes) }),
        Event::Target { from, to, axes, .. } => {
            json!({ "from": codes(from), "to": to.to_vec(), "axes": set(axes) })
        }
        Event::Border { outside, .. } => json!({ "outside": set(outside) }),
        Event::Difference { from, to, xor, level } => json!({
            "from": codes(from), "to": codes(to), "diff": codes(xor), "level": level,
        }),
        Event::Corners { min, max, from, to } => json!({
            "min": numbers(min), "max": numbers(max), "from": codes(from), "to": codes(to),
        }),
        Event::Leaf { full, .. } => json!({ "full": full }),
        Event::End(end) => json!({ "reason": reason(end) }),
        Event::Cuts { order, inside, .. } => {
            json!({ "order": order.to_vec(), "inside": set(inside) })
        }
        Event::Classify { at, child, .. } => json!({ "at": number(at), "child": child.0 }),
        Event::Flip { at, axes, child } => {
            json!({ "at": number(at), "axes": set(axes), "child": child.0 })
        }
        Event::Split { axis, plane, at, halves, taken, kept, .. } => json!({
            "axis": axis,
            "plane": number(plane),
            "at": number(at),
            "halves": match halves {
                Halves::Near => "near",
                Halves::Far => "far",
                Halves::Both => "both",
            },
            "taken": part(taken),
            "kept": kept.map(part),
        }),
        Event::Pop { part: popped, .. } => json!({ "part": part(popped) }),
        Event::Grid { cell, next, .. } => json!({ "cell": codes(cell), "next": numbers(next) }),
        Event::Cross { next, axes, cell, ahead, .. } => json!({
            "next": numbers(next),
            "axes": set(axes),
            "cell": cell.to_vec(),
            "ahead": numbers(ahead),
        }),
        Event::Parent { child, direction, common, lookup, .. } => json!({
            "child": child.0,
            "direction": direction.to_vec(),
            "common": common.to_vec(),
            "lookup": match lookup {
                Lookup::Tables => "tables",
                Lookup::Bits => "bits",
            },
        }),
        Event::Mirror { child, mirrored, .. } => {
            json!({ "child": child.0, "mirrored": mirrored.0 })
        }
        Event::Facing { child, .. } => json!({ "child": child.0 }),
        Event::Rope { axis, node } => json!({ "axis": axis, "border": node.is_none() }),
        Event::Push { from, to, axis } => {
            json!({ "from": numbers(from), "to": numbers(to), "axis": axis })
        }
        Event::Up { .. }
        | Event::Enter { .. }
        | Event::Begin { .. }
        | Event::Climb { .. }
        | Event::Touch { .. }
        | Event::Found { .. } => json!({}),
    }
}

/// Which axes of its node a part halves, and along which it is the upper half.
fn part<const D: usize>(part: Part<D>) -> Value {
    json!({ "halved": part.halved.0, "upper": part.upper.0 })
}

fn reason(end: End) -> &'static str {
    match end {
        End::Missed => "missed",
        End::LeftRoot => "left-root",
        End::FirstFull => "first-full",
        End::SegmentEnd => "segment-end",
        End::Looped => "looped",
        End::Cut => "cut",
        End::Found => "found",
        End::Outside => "outside",
    }
}

fn numbers<const N: usize>(numbers: [f64; N]) -> Value {
    numbers.map(number).to_vec().into()
}

/// A number, or its name if JSON has none.
fn number(x: f64) -> Value {
    if x.is_finite() {
        return x.into();
    }
    let name = if x.is_nan() {
        "nan"
    } else if x > 0.0 {
        "inf"
    } else {
        "-inf"
    };
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::query::Query;
    use crate::trace::record;
    use crate::tree::{Cell, Domain, Split, grow};

    /// One leaf and a ray through it, along x.
    fn run() -> (Tree<2>, Ray<2>, Trace<2>) {
        let split = |_: Cell<2>, ()| Split::Full(Vec::new());
        let tree = grow(Domain::unit(0), (), &Progress::default(), split).unwrap();
        let ray = Ray::new([-0.1, 0.5], [1.0, 0.0]).unwrap();
        let trace = record(&tree, &ray, &Query::default());
        (tree, ray, trace)
    }

    #[test]
    fn json_lines_read_back() {
        let (tree, ray, trace) = run();
        let text = trace_jsonl(&tree, &ray, &trace);
        let lines: Vec<Value> =
            text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(lines.len(), trace.events.len() + 1);
        assert_eq!(lines[0]["ray"]["origin"], json!([-0.1, 0.5]));
        assert_eq!(lines[1]["vars"]["t0"], json!([0.1, "-inf"]));
        assert_eq!(lines[3]["event"], "leaf");
        assert_eq!(lines[3]["node"], json!([0, 0, 0]));
        assert_eq!(lines[3]["t"], json!([0.1, 1.1]));
        assert_eq!(lines[4]["vars"]["reason"], "left-root");
    }

    #[test]
    fn csv_has_a_line_a_step() {
        let (tree, _, trace) = run();
        let text = trace_csv(&tree, &trace);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "step,event,level,x,y,enter,exit,state,vars");
        assert_eq!(lines[3], r#"3,leaf,0,0,0,0.1,1.1,,"{""full"":true}""#);
        assert_eq!(lines.len(), trace.events.len() + 1);
    }

    #[test]
    fn text_numbers_the_sentences() {
        let (tree, ray, trace) = run();
        let text = trace_text(&tree, &ray, &trace, Language::English);
        assert_eq!(
            text.lines().nth(3),
            Some(
                "3  Leaf (0, 0) of level 0 is on the ray from t = 0.1 to t = 1.1, and it is occupied."
            )
        );
    }
}
