//! Sentences on steps that follow a misprinted rule.

use super::rich::strong;
use super::words::{Words, approx, equation, grid_place, point, t};
use crate::event::Event;
use crate::geometry::Axes;
use crate::query::Query;
use crate::trace::{Extent, Moment, Trace};
use crate::traverse::{Algorithm, selection};
use crate::tree::{Child, Code, NodeId, joined};
use crate::variant::Variant::{
    self, B1, B2, B2Morton, B3, B4, B5, B6, B7, B9, B10, B11, B18, B19, B21, B24a, B24b, B24c,
    B25Leftmost, B25Rightmost, B28,
};
use crate::variant::Variants;

/// The sentence on a step of `trace`, known what was before: what `tell` says, unless
/// the step follows a misprinted rule. Then the rule is named, and stands in place of
/// reasons that would not be true.
pub(super) fn with_printed_rules<const D: usize>(
    words: &Words<D>,
    trace: &Trace<D>,
    event: &Event<D>,
    before: &Moment<D>,
    tell: impl FnOnce() -> String,
) -> String {
    let query = &trace.query;
    let variants = query.variants_at_work();
    if variants.is_empty() {
        return tell();
    }
    match (Printed { words, query, variants, before }).told(event) {
        Some(Told::Instead(sentence)) => sentence,
        Some(Told::After(addition)) => tell() + &addition,
        None => tell(),
    }
}

/// What is said of a printed rule.
enum Told {
    /// In place of the sentence on the step.
    Instead(String),
    /// Behind it, as its reasons are true.
    After(String),
}

/// Printed rules at work in a step.
struct Printed<'a, const D: usize> {
    words: &'a Words<'a, D>,
    query: &'a Query<D>,
    variants: Variants,
    before: &'a Moment<D>,
}

impl<const D: usize> Printed<'_, D> {
    /// What is said of the rules that an event follows, if it follows one.
    fn told(&self, event: &Event<D>) -> Option<Told> {
        match *event {
            Event::Clip { near, far, enter, exit, hit, mirror } => {
                let unknown = || self.no_number(near, far, mirror);
                let of_mirror = || self.after(&[mirrored(mirror)]);
                self.clip(enter, exit, hit).or_else(unknown).or_else(of_mirror)
            }
            Event::Halve { mid, .. } => self
                .unselected(mid)
                .or_else(|| self.after(&[&[B4], without_number(&mid, &[B5, B6]), self.mirrored()])),
            Event::First { entry, state, .. } => self.first(entry, state).or_else(|| {
                let mid = self.before.frame().and_then(|frame| frame.mid);
                let unknown = mid.map_or(&[][..], |mid| without_number(&mid, &[B5, B6]));
                self.after(&[unknown, self.mirrored()])
            }),
            // Table 3 counts in another order than the state is read.
            Event::Step { exits, .. } => {
                self.after(&[&[B2Morton], without_number(&exits, &[B5, B6]), self.mirrored()])
            }
            Event::Leaf { node, enter, exit, .. } => self.leaf(node, enter, exit),
            Event::Touch { node, at } => self.touch(node, at),
            Event::Difference { xor, level, .. } => self
                .difference(xor, level)
                .or_else(|| self.after(&[&[B24a, B24b, B25Leftmost, B25Rightmost]])),
            Event::Follow { level, child, node, .. } => self.follow(level, child, node),
            // Only the code of an upper face is one by the printed rule.
            Event::Encode { point, code, .. } => {
                let grid_size = self.words.tree.domain().grid_size();
                if code.contains(&grid_size) {
                    return self.encoded(point, code, B21);
                }
                [B18, B19].into_iter().find_map(|rule| self.encoded(point, code, rule))
            }
            Event::Target { to, axes, .. } => self.target(to, axes),
            Event::Test { .. }
            | Event::Sort { .. }
            | Event::Visit { .. }
            | Event::Skip { .. }
            | Event::Up { .. }
            | Event::Enter { .. }
            | Event::Cuts { .. }
            | Event::Classify { .. }
            | Event::Flip { .. }
            | Event::Split { .. }
            | Event::Pop { .. }
            | Event::Grid { .. }
            | Event::Cross { .. }
            | Event::Parent { .. }
            | Event::Mirror { .. }
            | Event::Facing { .. }
            | Event::Rope { .. }
            | Event::Push { .. }
            | Event::Begin { .. }
            | Event::Compare { .. }
            | Event::Exits { .. }
            | Event::Border { .. }
            | Event::Leave { .. }
            | Event::Resume { .. }
            | Event::Climb { .. }
            | Event::Corners { .. }
            | Event::Found { .. }
            | Event::End(_) => None,
        }
    }

    /// Names of those of `candidates` that are at work, if any is.
    fn at_work(&self, candidates: &[Variant]) -> Option<Vec<String>> {
        let used = candidates.iter().filter(|&&variant| self.variants.has(variant));
        let names: Vec<String> = used.map(|variant| variant.id().to_owned()).collect();
        (!names.is_empty()).then_some(names)
    }

    /// "By the printed rule, B-5,".
    fn by(&self, rules: Vec<String>) -> String {
        let key = if rules.len() == 1 { "by-printed-one" } else { "by-printed-many" };
        self.words.say(key, &[("rules", self.words.list(rules))])
    }

    /// " So says the printed rule, B-5."
    fn so_say(&self, rules: Vec<String>) -> String {
        let key = if rules.len() == 1 { "as-printed-one" } else { "as-printed-many" };
        self.words.say(key, &[("rules", self.words.list(rules))])
    }

    fn instead(&self, key: &str, arguments: &[(&str, String)]) -> Option<Told> {
        Some(Told::Instead(self.words.say(key, arguments)))
    }

    /// Rules that an event may follow without making its reasons untrue.
    fn after(&self, candidates: &[&[Variant]]) -> Option<Told> {
        let rules = self.at_work(&candidates.concat())?;
        Some(Told::After(self.so_say(rules)))
    }

    /// Along mirrored axes all parameters are those of the mirrored origin.
    fn mirrored(&self) -> &'static [Variant] {
        mirrored(self.before.clip.map_or(Axes::NONE, |clip| clip.mirror))
    }

    fn clip(&self, enter: f64, exit: f64, hit: bool) -> Option<Told> {
        // Of a miss only B-1 takes other planes than those that are told.
        let rules = self.at_work(if hit { &[B1, B10, B11] } else { &[B1] })?;
        let key = if hit { "clip-printed" } else { "clip-printed-miss" };
        let interval = [("enter", approx(enter)), ("exit", approx(exit))];
        self.instead(key, &[&interval[..], &[("by", self.by(rules))]].concat())
    }

    /// Planes whose parameters are no numbers are left out of all comparisons.
    fn no_number(&self, near: [f64; D], far: [f64; D], mirror: Axes<D>) -> Option<Told> {
        self.at_work(&[B5])?;
        let rules = self.at_work(&[&[B5], mirrored(mirror)].concat())?;
        let planes = (0..D).flat_map(|e| [(e, "0", near[e]), (e, "1", far[e])]);
        let unknown = planes.filter(|(.., t)| t.is_nan());
        let unknown: Vec<String> =
            unknown.map(|(e, plane, at)| equation(&t(e, plane), &approx(at))).collect();
        if unknown.is_empty() {
            return None;
        }
        let key = if unknown.len() == 1 { "clip-no-number" } else { "clip-no-numbers" };
        let told = self.words.say(key, &[("parameters", self.words.list(unknown))]);
        Some(Told::After(told + &self.so_say(rules)))
    }

    /// The codes of a point with all bits that the rule reads.
    fn encoded(&self, at: [f64; D], code: Code<D>, rule: Variant) -> Option<Told> {
        let rules = self.at_work(&[rule])?;
        let arguments = [("point", point(at)), ("codes", self.words.whole_binary(code))];
        let told = self.words.say("encode", &arguments);
        // The other rules read the codes, they do not make them.
        let source = (rule == B21).then(|| self.so_say(rules));
        Some(Told::Instead(told + &source.unwrap_or_default()))
    }

    fn first(&self, entry: f64, state: Child<D>) -> Option<Told> {
        let of_children: &[Variant] = if D == 2 { &[B3] } else { &[B2, B2Morton] };
        // The tables begin at the near planes in any case; by the one rule it makes a
        // difference where these lie behind the origin.
        let clamps = matches!(self.query, Query::Ray { algorithm: Algorithm::Parametric, .. });
        let of_entry: &[Variant] = if clamps && entry < 0.0 { &[B9, B10] } else { &[] };
        let by = self.by(self.at_work(&[of_children, of_entry].concat())?);
        if let Some(states) = self.selected() {
            return self.instead("selection-printed", &[("states", states), ("by", by)]);
        }
        let state = strong(&state.0.to_string());
        self.instead("first-printed", &[("state", state), ("by", by)])
    }

    /// "states 0, 1 and 3": what the selection of the plane comes to as it is printed, if
    /// it is at work.
    fn selected(&self) -> Option<String> {
        let frame = self.before.frame().filter(|_| D == 2 && self.variants.has(B3))?;
        let Extent::Planes { near, far } = frame.extent else { return None };
        let states = selection(near, frame.mid?, far);
        let key = if states.len() == 1 { "states-one" } else { "states-many" };
        let states = self.words.list(states.iter().map(|state| strong(&state.0.to_string())));
        Some(self.words.say(key, &[("states", states)]))
    }

    /// No branch of the selection as printed is for equal parameters.
    fn unselected(&self, mid: [f64; D]) -> Option<Told> {
        let is_equal = D == 2 && mid[0] == mid[1] && self.variants.has(B3);
        let rule = ("rule", B3.id().to_owned());
        is_equal.then(|| Told::After(self.words.say("halve-unselected", &[rule])))
    }

    /// What a misprint reports need not be on the ray.
    fn leaf(&self, node: NodeId, enter: f64, exit: f64) -> Option<Told> {
        let by = self.by(self.misprints()?);
        let interval = [("enter", approx(enter)), ("exit", approx(exit))];
        let of_node = [("node", self.words.node(node)), ("by", by)];
        self.instead("leaf-printed", &[&interval[..], &of_node].concat())
    }

    /// Nor need what it comes to without a length be touched.
    fn touch(&self, node: NodeId, at: f64) -> Option<Told> {
        let by = self.by(self.misprints()?);
        let arguments = [("node", self.words.node(node)), ("at", approx(at)), ("by", by)];
        self.instead("touch-printed", &arguments)
    }

    /// Names of all misprints at work that can make the result wrong. B-9 only makes
    /// the way longer.
    fn misprints(&self) -> Option<Vec<String>> {
        let spoils = |&variant: &Variant| variant.is_misprint() && variant != B9;
        let misprints = self.variants.iter().filter(spoils);
        self.at_work(&misprints.collect::<Vec<_>>())
    }

    fn difference(&self, xor: Code<D>, level: u8) -> Option<Told> {
        let rules = self.at_work(&[B24a, B24b, B25Leftmost, B25Rightmost])?;
        let highest = joined(xor).checked_ilog2();
        let bit = highest.filter(|bit| bit + 1 != u32::from(level))?;
        let [right, bit, level] =
            [bit + 1, bit, level.into()].map(|number: u32| strong(&number.to_string()));
        let arguments = [("bit", bit), ("level", level), ("right", right), ("by", self.by(rules))];
        self.instead("difference-printed", &arguments)
    }

    fn target(&self, to: [i64; D], axes: Axes<D>) -> Option<Told> {
        let by = self.by(self.at_work(&[B28])?);
        let arguments = [("axes", self.words.axes(axes)), ("to", grid_place(to)), ("by", by)];
        self.instead("target-printed", &arguments)
    }

    fn follow(&self, level: u8, child: Child<D>, node: NodeId) -> Option<Told> {
        let (key, rules, bit) = if let Some(rules) = self.at_work(&[B18, B19]) {
            // The bit of the codes as they are told: from the other end, one further on.
            let above = level - 1 + u8::from(self.variants.has(B19));
            let root_level = self.words.tree.domain().root_level();
            let bit = if self.variants.has(B18) { root_level - above } else { above };
            ("follow-printed", rules, bit)
        } else {
            ("follow-difference", self.at_work(&[B24c])?, level - 1)
        };
        let arguments = [
            ("by", self.by(rules)),
            ("bits", self.words.bits(child)),
            ("child", strong(&child.0.to_string())),
            ("node", self.words.node(node)),
            ("bit", bit.to_string()),
        ];
        self.instead(key, &arguments)
    }
}

/// `rules`, if one of the parameters is no number.
fn without_number<'a>(parameters: &[f64], rules: &'a [Variant]) -> &'a [Variant] {
    if parameters.iter().any(|t| t.is_nan()) { rules } else { &[] }
}

/// The rule on mirrored rays, if one is.
fn mirrored<const D: usize>(mirror: Axes<D>) -> &'static [Variant] {
    if mirror.is_empty() { &[] } else { &[B7] }
}
