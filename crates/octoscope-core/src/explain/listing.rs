//! Pseudocode of the algorithms.

use crate::event::{End, Event, Halves};
use crate::locate::NeighbourMethod;
use crate::query::{PointMethod, Query};
use crate::text::Language;
use crate::traverse::{Algorithm, Variant};
use crate::tree::NodeId;

/// Pseudocode of one algorithm.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// The lines, in order.
    pub lines: Vec<Line>,
}

/// Line of a [`Listing`].
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    /// Which events are at work in it, by [`label`]; empty if none is.
    pub label: &'static str,
    /// The only one of their branches in which it is reached, by [`branch`]; empty
    /// if it is reached in all of them.
    pub branch: &'static str,
    /// Depth of indentation.
    pub indent: u8,
    /// The code.
    pub code: &'static str,
    /// What it means; may be empty.
    pub comment: String,
}

impl Listing {
    /// For each line whether the last one of the events so far was at work in it.
    pub fn lit<const D: usize>(&self, past: &[Event<D>]) -> Vec<bool> {
        let at_work = past.last().map(label);
        let taken = branch(past);
        let is_lit = |line: &Line| {
            Some(line.label) == at_work && (line.branch.is_empty() || line.branch == taken)
        };
        self.lines.iter().map(is_lit).collect()
    }
}

/// Listing of what `query` runs, with its rules as it follows them.
pub fn listing<const D: usize>(query: &Query<D>, language: Language) -> Listing {
    let source = match query {
        Query::Ray { algorithm: Algorithm::Parametric, .. } => {
            include_str!("../../../../assets/listings/parametric.txt")
        }
        Query::Ray { algorithm: Algorithm::ParametricTable, .. } => {
            include_str!("../../../../assets/listings/parametric-table.txt")
        }
        Query::Ray { algorithm: Algorithm::Codes, .. } => {
            include_str!("../../../../assets/listings/codes.txt")
        }
        Query::Ray { algorithm: Algorithm::Esvo, .. } => {
            include_str!("../../../../assets/listings/esvo.txt")
        }
        Query::Ray { algorithm: Algorithm::AllChildren, .. } => {
            include_str!("../../../../assets/listings/all-children.txt")
        }
        Query::Ray { algorithm: Algorithm::Hero, .. } => {
            include_str!("../../../../assets/listings/hero.txt")
        }
        Query::Ray { algorithm: Algorithm::Gargantini, .. } => {
            include_str!("../../../../assets/listings/gargantini.txt")
        }
        Query::Ray { algorithm: Algorithm::Glassner, .. } => {
            include_str!("../../../../assets/listings/glassner.txt")
        }
        Query::Ray { algorithm: Algorithm::Samet, .. } => {
            include_str!("../../../../assets/listings/samet.txt")
        }
        Query::Ray { algorithm: Algorithm::SametCorner, .. } => {
            include_str!("../../../../assets/listings/samet-corner.txt")
        }
        Query::Ray { algorithm: Algorithm::SametNet, .. } => {
            include_str!("../../../../assets/listings/samet-net.txt")
        }
        Query::Ray { algorithm: Algorithm::Bsp, .. } => {
            include_str!("../../../../assets/listings/bsp.txt")
        }
        Query::Ray { algorithm: Algorithm::Dda, .. } => {
            include_str!("../../../../assets/listings/dda.txt")
        }
        Query::Ray { algorithm: Algorithm::DdaOctree, .. } => {
            include_str!("../../../../assets/listings/dda-octree.txt")
        }
        Query::Ray { algorithm: Algorithm::Exhaustive, .. } => {
            include_str!("../../../../assets/listings/exhaustive.txt")
        }
        Query::Point { method: PointMethod::Codes, .. } => {
            include_str!("../../../../assets/listings/point-codes.txt")
        }
        Query::Point { method: PointMethod::Comparison, .. } => {
            include_str!("../../../../assets/listings/point-comparison.txt")
        }
        Query::Region { .. } => include_str!("../../../../assets/listings/region.txt"),
        Query::Neighbour { method: NeighbourMethod::Codes, .. } => {
            include_str!("../../../../assets/listings/neighbour.txt")
        }
        Query::Neighbour { method: NeighbourMethod::Tables, .. } => {
            include_str!("../../../../assets/listings/neighbour-tables.txt")
        }
    };
    let mut lines: Vec<Line> = source.lines().map(|line| read(line, language)).collect();
    for variant in query.variants_at_work().iter() {
        for (right, other, comment) in other_lines(variant, language) {
            if let Some(line) = lines.iter_mut().find(|line| line.code == right) {
                line.code = other;
                comment.clone_into(&mut line.comment);
            }
        }
    }
    Listing { lines }
}

/// Lines of all listings in which a rule is another one: the right code, the other, and
/// what it means.
fn other_lines(
    variant: Variant,
    language: Language,
) -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let source = include_str!("../../../../assets/listings/printed.txt");
    source.lines().filter_map(move |line| {
        let mut fields = line.split('|').map(str::trim);
        let mut field = || fields.next().unwrap_or("");
        let (id, right, other, english, german) = (field(), field(), field(), field(), field());
        let comment = match language {
            Language::English => english,
            Language::German => german,
        };
        (id == variant.id()).then_some((right, other, comment))
    })
}

/// Label of the lines of a listing that an event belongs to.
pub fn label<const D: usize>(event: &Event<D>) -> &'static str {
    match event {
        Event::Clip { .. } => "clip",
        Event::Test { .. } => "test",
        Event::Sort { .. } => "sort",
        Event::Visit { .. } => "visit",
        Event::Skip { .. } => "skip",
        Event::Halve { .. } => "halve",
        Event::First { .. } => "first",
        Event::Step { .. } => "step",
        Event::Up { .. } => "up",
        Event::Enter { .. } => "enter",
        Event::Cuts { .. } => "cuts",
        Event::Classify { .. } => "classify",
        Event::Flip { .. } => "flip",
        Event::Split { .. } => "split",
        Event::Pop { .. } => "pop",
        Event::Grid { .. } => "grid",
        Event::Cross { .. } => "cross",
        Event::Parent { .. } => "parent",
        Event::Mirror { .. } => "mirror",
        Event::Facing { .. } => "facing",
        Event::Rope { .. } => "rope",
        Event::Push { .. } => "push",
        Event::Begin { .. } => "begin",
        Event::Encode { .. } => "encode",
        Event::Compare { .. } => "compare",
        Event::Follow { .. } => "follow",
        Event::Exits { .. } => "exits",
        Event::Target { .. } => "target",
        Event::Border { .. } => "border",
        Event::Difference { .. } => "difference",
        Event::Leave { .. } => "leave",
        Event::Resume { .. } => "resume",
        Event::Climb { .. } => "climb",
        Event::Corners { .. } => "corners",
        Event::Leaf { .. } => "leaf",
        Event::Touch { .. } => "touch",
        Event::Found { .. } => "found",
        Event::End(End::Missed) => "missed",
        Event::End(End::LeftRoot) => "end",
        Event::End(End::FirstFull) => "stop",
        Event::End(End::SegmentEnd) => "segment-end",
        Event::End(End::Looped) => "looped",
        // No line of the algorithm's own.
        Event::End(End::Cut) => "cut",
        Event::End(End::Found) => "done",
        Event::End(End::Outside) => "outside",
    }
}

/// Branch that the last one of the events so far has taken; empty if there is
/// only one.
pub fn branch<const D: usize>(past: &[Event<D>]) -> &'static str {
    let [before @ .., event] = past else {
        return "";
    };
    let follows = |is_it: fn(&Event<D>) -> bool| before.last().is_some_and(is_it);
    if let Event::Visit { state, .. } = event {
        return if state.is_some() { "child" } else { "root" };
    }
    if let Event::Enter { node, .. } = event {
        return if follows(|event| matches!(event, Event::Resume { .. })) {
            "resumed"
        } else if *node == NodeId::ROOT {
            "root"
        } else {
            "child"
        };
    }
    if let Event::Step { next, .. } = event {
        return if next.is_some() { "on" } else { "leave" };
    }
    if let Event::Split { halves, .. } = event {
        return match halves {
            Halves::Near => "near",
            Halves::Far => "far",
            Halves::Both => "both",
        };
    }
    if let Event::Encode { .. } = event {
        return if follows(|event| matches!(event, Event::Clip { .. })) {
            "first"
        } else if follows(|event| matches!(event, Event::Push { .. })) {
            "pushed"
        } else {
            "next"
        };
    }
    if let Event::Cross { outside, .. } = event {
        return if outside.is_empty() { "inside" } else { "outside" };
    }
    ""
}

/// Reads `label/branch | code | English comment | German comment`; the branch may
/// be missing.
fn read(line: &'static str, language: Language) -> Line {
    let mut fields = line.split('|');
    let mut field = || fields.next().unwrap_or("");
    let (label, code, english, german) = (field().trim(), field(), field(), field());
    let (label, branch) = label.split_once('/').unwrap_or((label, ""));
    let code = code.strip_prefix(' ').unwrap_or(code);
    let indent = (code.len() - code.trim_start().len()) / 2;
    let comment = match language {
        Language::English => english,
        Language::German => german,
    };
    Line {
        label,
        branch,
        indent: indent as u8,
        code: code.trim(),
        comment: comment.trim().to_owned(),
    }
}
