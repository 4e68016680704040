//! The variables of an algorithm, as its listing names them.

use super::rich::{RichText, on_axis, strong};
use super::words::{approx, binary, distinct, signs, t, tuple};
use crate::explain::number::with_minus;
use crate::geometry::{AXIS_NAMES, Axes};
use crate::query::Query;
use crate::trace::{Cuts, Moment};
use crate::traverse::Algorithm;
use crate::tree::{Code, NodeId, Part, Tree};

/// Variable of an algorithm at some moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name.
    pub name: RichText,
    /// Its value.
    pub value: RichText,
    /// The node that it is, if it is one.
    pub node: Option<NodeId>,
}

/// The variables of `query` that have a value at `moment`, by the names of its
/// listing: first where the algorithm is,
/// then parameters, then codes, then the result. What changed is what differs
/// from the variable of the same name a moment earlier.
pub fn variables<const D: usize>(
    tree: &Tree<D>,
    query: &Query<D>,
    moment: &Moment<D>,
) -> Vec<Variable> {
    let mut list = List(Vec::new());
    let levels = tree.domain().root_level();
    let in_binary = |code: Code<D>| tuple(code.map(|c| binary(c, levels)));

    // Where it is.
    // The node of the parameters, and where the algorithm is if that is another one.
    let frame = moment.frame().map(|frame| frame.node);
    let runs = |algorithm| matches!(query, Query::Ray { algorithm: a, .. } if *a == algorithm);
    let node = if runs(Algorithm::Exhaustive) { "leaf" } else { "node" };
    if let Some(id) = frame.or(moment.current) {
        list.node(node, tree, id);
        let node = id;
        list.push("level", &tree.level(node).to_string());
    }
    if let Some(current) = moment.current.filter(|&current| frame.is_some_and(|f| f != current)) {
        list.node("at", tree, current);
    }

    // Parameters, the state and the mirror mask.
    if let Some(frame) = moment.frame() {
        if let Some([near, _]) = frame.planes() {
            list.parameters("0", near);
        }
        if let Some(mid) = frame.mid {
            list.parameters("m", mid);
        }
        match frame.planes() {
            Some([_, far]) => {
                list.parameters("1", far);
                if let Some(entry) = frame.entry {
                    list.push("entry", &approx(entry));
                }
            }
            None => list.interval([frame.enter(), frame.exit()]),
        }
        if let Some(Cuts { order, inside }) = frame.cuts {
            let axes = order.map(usize::from).into_iter().filter(|&axis| inside.contains(axis));
            let names: Vec<String> = axes.map(|axis| t(axis, "m")).collect();
            list.push("cuts", &if names.is_empty() { "–".to_owned() } else { names.join(", ") });
        }
        if let Some(state) = frame.child_state {
            list.push("i", &bits::<D>(state.0));
        }
        if let Some(child) = frame.child {
            list.push("child", &bits::<D>(child.0));
        }
    } else if let Some(part) = moment.part {
        list.push("part", &halves(tree, part));
        if let Some([lo, hi]) = moment.part_interval {
            list.push("lo", &approx(lo));
            list.push("hi", &approx(hi));
        }
        if let Some(plane) = moment.halving {
            list.push(&t(plane.axis, "m"), &approx(plane.at));
        }
        list.push("stack", &moment.pending.len().to_string());
    } else if let Some(grid) = moment.grid {
        if let Some(cell) = grid.cell {
            list.push("cell", &tuple(cell.map(|c| c.to_string())));
        }
        list.parameters("Max", grid.next);
    } else if let Some(exits) = moment.exits {
        list.parameters("1", exits.exits);
    } else if let Some(interval) = moment.tested {
        list.interval(interval);
    } else if let Some(clip) = moment.clip
        && moment.current.is_none()
        && !keeps_entry(query)
    {
        list.parameters("0", clip.near);
        list.parameters("1", clip.far);
    }
    if let Some(clip) = moment.clip.filter(|_| moment.leaves.is_empty() && keeps_entry(query)) {
        let enter = clip.near.into_iter().fold(0.0, f64::max);
        list.push("enter", &approx(enter));
    }
    if let Some(clip) = moment.clip {
        list.push("a", &bits::<D>(clip.mirror.0));
    }

    // The way to a neighbour.
    if let Some(towards) = moment.towards {
        list.push("s", &signs(towards.direction));
        list.push("child", &bits::<D>(towards.child.0));
    } else if let Some(exits) = moment.exits.filter(|_| runs(Algorithm::Samet)) {
        let lower = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
        let sign = |e| match (exits.axes.contains(e), lower.contains(e)) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => -1,
        };
        list.push("s", &signs::<D>(std::array::from_fn(sign)));
    }

    // Codes.
    if let Some([from, to]) = moment.corners {
        list.push("from", &in_binary(from));
        list.push("to", &in_binary(to));
    }
    if let Some(codes) = moment.codes {
        list.push("code", &in_binary(codes.code));
        if let Some(bit) = codes.bit {
            list.push("bit", &bit.to_string());
        }
    }
    if let Some(target) = moment.target {
        list.push("from", &in_binary(target.from));
        let last = i64::from(tree.domain().grid_size());
        let code = |c: i64| match u32::try_from(c) {
            Ok(inside) if c < last => binary(inside, levels),
            Ok(_) | Err(_) => with_minus(c),
        };
        list.push("to", &tuple(target.to.map(code)));
    }
    if let Some(difference) = moment.difference {
        list.push("diff", &in_binary(difference.xor));
        list.push("common", &difference.level.to_string());
    }

    // The result.
    if runs(Algorithm::Exhaustive) {
        list.push("met", &moment.n_met.to_string());
    }
    if !moment.leaves.is_empty() {
        list.push("leaves", &moment.leaves.len().to_string());
    }
    if let Some(found) = moment.found {
        list.node("found", tree, found);
    }
    list.0
}

/// Whether an algorithm keeps of the root only where the ray comes in.
fn keeps_entry<const D: usize>(query: &Query<D>) -> bool {
    match query {
        Query::Ray { algorithm, .. } => match algorithm {
            Algorithm::Codes
            | Algorithm::Glassner
            | Algorithm::Samet
            | Algorithm::SametCorner
            | Algorithm::SametNet
            | Algorithm::Dda
            | Algorithm::DdaOctree => true,
            Algorithm::Parametric
            | Algorithm::ParametricTable
            | Algorithm::Esvo
            | Algorithm::AllChildren
            | Algorithm::Hero
            | Algorithm::Gargantini
            | Algorithm::Bsp
            | Algorithm::Exhaustive => false,
        },
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => false,
    }
}

/// State or mask in decimal, and its bits in the colours of the axes.
fn bits<const D: usize>(set: u8) -> String {
    let bit = |e: usize| on_axis(e, if set >> (D - 1 - e) & 1 == 1 { "1" } else { "0" });
    let bits: String = (0..D).map(bit).collect();
    format!("{} ({bits})", strong(&set.to_string()))
}

/// A part by the codes of its node, and the halves of it: x− the lower, x+ the upper.
fn halves<const D: usize>(tree: &Tree<D>, part: Part<D>) -> String {
    let sign = |e: usize| if part.upper.contains(e) { "+" } else { "−" };
    let halves = part.halved.iter().map(|e| on_axis(e, &format!("{}{}", AXIS_NAMES[e], sign(e))));
    let codes = tuple(tree.code(part.node).map(|c| c.to_string()));
    [codes].into_iter().chain(halves).collect::<Vec<_>>().join(" ")
}

struct List(Vec<Variable>);

impl List {
    fn push(&mut self, name: &str, value: &str) {
        let (name, value) = (RichText::parse(name), RichText::parse(value));
        self.0.push(Variable { name, value, node: None });
    }

    /// A node, by its codes.
    fn node<const D: usize>(&mut self, name: &str, tree: &Tree<D>, node: NodeId) {
        self.push(name, &tuple(tree.code(node).map(|c| c.to_string())));
        if let Some(variable) = self.0.last_mut() {
            variable.node = Some(node);
        }
    }

    /// Where the ray is in a node.
    fn interval(&mut self, [enter, exit]: [f64; 2]) {
        self.push("enter", &approx(enter));
        self.push("exit", &approx(exit));
    }

    /// One parameter an axis.
    fn parameters<const D: usize>(&mut self, plane: &str, values: [f64; D]) {
        let texts = distinct(&values);
        for (axis, text) in texts.iter().enumerate() {
            debug_assert!(axis < AXIS_NAMES.len());
            self.push(&t(axis, plane), text);
        }
    }
}
