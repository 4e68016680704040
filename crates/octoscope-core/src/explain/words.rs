//! Pieces of sentences, marked up.

use super::names::step_texts;
use super::number::{self, shown_number, signed_number, with_minus};
use super::rich::{on_axis, shortened, strong, with_sub};
use crate::geometry::{AXIS_NAMES, Axes};
use crate::text::{Language, Texts};
use crate::tree::{Child, Code, NodeId, Tree};

/// Pieces of sentences on a tree, in a language.
pub(super) struct Words<'a, const D: usize> {
    pub tree: &'a Tree<D>,
    pub texts: &'static Texts,
}

impl<'a, const D: usize> Words<'a, D> {
    pub fn new(tree: &'a Tree<D>, language: Language) -> Self {
        Self { tree, texts: step_texts(language) }
    }

    /// The text of `key` with marked-up arguments.
    pub fn say(&self, key: &str, arguments: &[(&str, String)]) -> String {
        let values: Vec<_> =
            arguments.iter().map(|(name, text)| (*name, text.as_str().into())).collect();
        self.texts.format(key, &values)
    }

    /// "a, b and c".
    pub fn list(&self, parts: impl IntoIterator<Item = String>) -> String {
        let mut parts: Vec<String> = parts.into_iter().collect();
        let Some(last) = parts.pop() else {
            return String::new();
        };
        let joined = parts
            .into_iter()
            .reduce(|first, last| self.say("comma", &[("first", first), ("last", last)]));
        match joined {
            Some(first) => self.say("and", &[("first", first), ("last", last)]),
            None => last,
        }
    }

    /// Names of axes, in their colours.
    pub fn axes(&self, axes: Axes<D>) -> String {
        self.list(axes.iter().map(|e| on_axis(e, AXIS_NAMES[e])))
    }

    /// "0 in x and 1 in y": the bits that select a child.
    pub fn bits(&self, child: Child<D>) -> String {
        self.list((0..D).map(|e| {
            let value = strong(if child.is_upper(e) { "1" } else { "0" });
            let axis = on_axis(e, AXIS_NAMES[e]);
            self.say("bit-of", &[("value", value), ("axis", axis)])
        }))
    }

    /// An inner node in the middle of a sentence, or any.
    pub fn node(&self, id: NodeId) -> String {
        self.named("the-node", id)
    }

    /// A leaf at the head of a sentence.
    pub fn leaf(&self, id: NodeId) -> String {
        self.named("the-leaf", id)
    }

    /// A node with children at the head of a sentence.
    pub fn node_first(&self, id: NodeId) -> String {
        self.named("the-node-first", id)
    }

    /// A node of this level and code in the middle of a sentence, in the tree or not.
    pub fn node_at(&self, level: u8, code: Code<D>) -> String {
        self.called("the-node", level, code)
    }

    fn named(&self, key: &str, id: NodeId) -> String {
        self.called(key, self.tree.level(id), self.tree.code(id))
    }

    fn called(&self, key: &str, level: u8, code: Code<D>) -> String {
        let code = tuple(code.map(|c| c.to_string()));
        self.say(key, &[("code", code), ("level", level.to_string())])
    }

    /// Codes in binary, as many digits as the root has levels.
    pub fn binary(&self, code: Code<D>) -> String {
        tuple(code.map(|c| binary(c, self.tree.domain().root_level())))
    }

    /// A code in binary with the bit of the root's level, which is 0 in the domain.
    pub fn whole_binary(&self, code: Code<D>) -> String {
        tuple(code.map(|c| binary(c, self.tree.domain().root_level() + 1)))
    }
}

/// A tuple in the colours of the axes.
pub(super) fn tuple<const D: usize>(parts: [String; D]) -> String {
    let parts: Vec<String> = parts.iter().enumerate().map(|(e, part)| on_axis(e, part)).collect();
    format!("({})", parts.join(", "))
}

/// Codes of a place that may lie outside the domain, where one may be −1.
pub(super) fn grid_place<const D: usize>(codes: [i64; D]) -> String {
    tuple(codes.map(with_minus))
}

/// A direction to a neighbour, with its signs: (+1, 0, −1).
pub(super) fn signs<const D: usize>(direction: [i8; D]) -> String {
    tuple(direction.map(|s| match s {
        0 => "0".to_owned(),
        s if s > 0 => format!("+{s}"),
        s => format!("−{}", s.unsigned_abs()),
    }))
}

/// A point in the colours of the axes.
pub(super) fn point<const D: usize>(x: [f64; D]) -> String {
    tuple(x.map(coordinate))
}

/// The direction of a ray, in the colours of the axes. The sign of a zero is told: that
/// it makes no difference is what a student tries out.
pub(super) fn direction<const D: usize>(d: [f64; D]) -> String {
    let told = |x: f64| if x == 0.0 { with_minus(signed_number(x)) } else { coordinate(x) };
    tuple(d.map(told))
}

/// Coordinates of at most so many characters are told whole, as those of planes of
/// the grid are.
const SHORT_COORDINATE: usize = 9;

/// A coordinate with all its digits, if these are few, or in short.
pub(super) fn coordinate(x: f64) -> String {
    let whole = shown_number(x);
    if whole.chars().count() <= SHORT_COORDINATE { whole } else { approx(x) }
}

/// `x` in short, with all its digits behind it.
pub(super) fn approx(x: f64) -> String {
    with_digits(number::approx(x), x)
}

/// Numbers as short as they can be told apart, with all their digits behind them.
pub(super) fn distinct(numbers: &[f64]) -> Vec<String> {
    let texts = number::distinct(numbers).into_iter();
    texts.zip(numbers).map(|(text, &x)| with_digits(text, x)).collect()
}

fn with_digits(text: String, x: f64) -> String {
    let whole = shown_number(x);
    if text == whole { text } else { shortened(&text, &whole) }
}

/// `code` in binary, `width` digits at least.
pub(super) fn binary(code: u32, width: u8) -> String {
    format!("{code:0width$b}", width = usize::from(width.max(1)))
}

/// Name of the parameter at a plane: `plane` is 0, m or 1.
pub(super) fn t(axis: usize, plane: &str) -> String {
    with_sub(axis, "t", &format!("{}{plane}", AXIS_NAMES[axis]))
}

/// Names of the far planes of a child, which are planes of its parent: the mid one below
/// it, and its own far one above.
pub(super) fn far_planes<const D: usize>(child: Child<D>) -> [&'static str; D] {
    std::array::from_fn(|e| if child.is_upper(e) { "1" } else { "m" })
}

/// "t_x1 = 0.5": a parameter with its value.
pub(super) fn equation(name: &str, value: &str) -> String {
    format!("{name} = {}", strong(value))
}

/// How `a` compares to `b`: <, = or >; ≠ where one is no number.
pub(super) fn relation(a: f64, b: f64) -> &'static str {
    if a < b {
        "<"
    } else if a > b {
        ">"
    } else if a == b {
        "="
    } else {
        "≠"
    }
}

/// How comparisons were decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Decided {
    /// By the doubles that are told.
    InDoubles,
    /// By exact numbers, which may differ where the doubles are the same.
    Exactly,
    /// The same, but of equal planes only one is taken, and comparisons are strict.
    ExactlyOneByOne,
}

/// "t_x1 = 0.2 < t_ym = 0.5": parameters at planes of all axes, called as `planes` says,
/// in order, those of `first` in front of equal ones.
pub(super) fn chain<const D: usize>(
    values: [f64; D],
    planes: [&str; D],
    first: Axes<D>,
    decided: Decided,
) -> String {
    let mut order: Vec<usize> = (0..D).collect();
    order.sort_by(|&a, &b| {
        values[a].total_cmp(&values[b]).then(first.contains(b).cmp(&first.contains(a)))
    });
    // Exact arithmetic may tell apart what rounds to equal doubles: the planes
    // that were found first lead in any case.
    order.sort_by_key(|&e| !first.contains(e));
    let texts = distinct(&values);
    let mut chain = String::new();
    for (i, &e) in order.iter().enumerate() {
        if i > 0 {
            let before = order[i - 1];
            // Only what is met first at once was found to be equal.
            let leads = first.contains(before) && !first.contains(e);
            let sign = match decided {
                Decided::Exactly if leads => "<",
                // What is taken alone need not be the smaller one.
                Decided::ExactlyOneByOne if leads && values[before] > values[e] => "≤",
                Decided::Exactly | Decided::ExactlyOneByOne | Decided::InDoubles => {
                    relation(values[before], values[e])
                }
            };
            chain.push_str(&format!(" {sign} "));
        }
        chain.push_str(&equation(&t(e, planes[e]), &texts[e]));
    }
    chain
}
