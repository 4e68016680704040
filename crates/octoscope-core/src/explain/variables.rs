//! The variables of an algorithm, as its listing names them.

use super::number::distinct;
use super::rich::{RichText, on_axis, strong};
use super::words::{binary, t, tuple, typographic};
use crate::geometry::{AXIS_NAMES, Axes};
use crate::trace::{Cuts, Moment};
use crate::tree::{Code, NodeId, Tree};

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

/// The variables that have a value at `moment`: first where the algorithm is,
/// then parameters, then codes, then the result. What changed is what differs
/// from the variable of the same name a moment earlier.
pub fn variables<const D: usize>(tree: &Tree<D>, moment: &Moment<D>) -> Vec<Variable> {
    let mut list = List(Vec::new());
    let levels = tree.domain().root_level();
    let in_binary = |code: Code<D>| tuple(code.map(|c| binary(c, levels)));

    // Where it is.
    // The node of the parameters, and where the algorithm is if that is another one.
    let frame = moment.frame().map(|frame| frame.node);
    if let Some(node) = frame.or(moment.current) {
        list.node("node", tree, node);
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
                    list.push("entry", &typographic(entry));
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
            list.push("s", &bits::<D>(state.0));
        }
        if let Some(child) = frame.child {
            list.push("child", &bits::<D>(child.0));
        }
    } else if let Some(part) = moment.part {
        list.push("halved", &axis_names(part.halved));
        list.push("upper", &axis_names(part.upper));
        list.push("stack", &moment.pending.len().to_string());
    } else if let Some(grid) = moment.grid {
        if let Some(cell) = grid.cell {
            list.push("cell", &tuple(cell.map(|c| c.to_string())));
        }
        list.parameters("Max", grid.next);
    } else if let Some(exits) = moment.exits {
        list.parameters("1", exits.exits);
    } else if let Some(clip) = moment.clip
        && moment.current.is_none()
    {
        list.parameters("0", clip.near);
        list.parameters("1", clip.far);
    }
    if let Some(clip) = moment.clip {
        list.push("a", &bits::<D>(clip.mirror.0));
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
            Ok(_) | Err(_) => c.to_string().replace('-', "−"),
        };
        list.push("to", &tuple(target.to.map(code)));
    }
    if let Some(difference) = moment.difference {
        list.push("diff", &in_binary(difference.xor));
        list.push("common", &difference.level.to_string());
    }

    // The result.
    if !moment.leaves.is_empty() {
        list.push("leaves", &moment.leaves.len().to_string());
    }
    if let Some(found) = moment.found {
        list.node("found", tree, found);
    }
    list.0
}

/// State or mask in decimal, and its bits in the colours of the axes.
fn bits<const D: usize>(set: u8) -> String {
    let bit = |e: usize| on_axis(e, if set >> (D - 1 - e) & 1 == 1 { "1" } else { "0" });
    let bits: String = (0..D).map(bit).collect();
    format!("{} ({bits})", strong(&set.to_string()))
}

/// The axes of a set, in their colours.
fn axis_names<const D: usize>(axes: Axes<D>) -> String {
    let names: Vec<String> = axes.iter().map(|e| on_axis(e, AXIS_NAMES[e])).collect();
    if names.is_empty() { "–".to_owned() } else { names.join(", ") }
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
        self.push("enter", &typographic(enter));
        self.push("exit", &typographic(exit));
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
