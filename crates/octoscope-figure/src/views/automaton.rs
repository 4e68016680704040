//! The automaton that leads from child to child.

use super::sheet::Sheet;
use super::subject::Subject;
use super::table::{Entry, Setting, Table, Tone};
use super::words::{joined, on_axis, parameter};
use crate::{Anchor, Figure, Role, Style, Theme};
use octoscope_core::event::Event;
use octoscope_core::explain::sentence;
use octoscope_core::geometry::{AXIS_NAMES, Axes};
use octoscope_core::query::Query;
use octoscope_core::text::Texts;
use octoscope_core::trace::Moment;
use octoscope_core::traverse::{Algorithm, Variant, Variants, entry_axes, transition};
use octoscope_core::tree::Child;

/// State of the automaton at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Automaton<const D: usize> {
    /// The mirror mask.
    mask: Axes<D>,
    /// Rules in another form than the right one.
    variants: Variants,
    /// Whether a mid plane that is met just when the node is entered is not passed yet.
    is_strict: bool,
    /// The state that it is in, or leaves.
    pub state: Option<Child<D>>,
    /// The planes through which it leaves its state and the next one, if this is
    /// what has just happened.
    step: Option<(Axes<D>, Option<Child<D>>)>,
    /// The plane of entry that has just been used.
    entered: Option<usize>,
}

impl<const D: usize> Automaton<D> {
    /// State after `event`, the last one before `moment`, of `query`.
    pub fn of(moment: &Moment<D>, event: Option<&Event<D>>, query: &Query<D>) -> Self {
        let variants = query.variants_at_work();
        let is_strict = variants.has(Variant::OneByOne)
            || matches!(query, Query::Ray { algorithm: Algorithm::ParametricTable, .. });
        let mask = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
        let (state, step) = if let Some(&Event::Step { state, axes, next, .. }) = event {
            (Some(state), Some((axes, next)))
        } else {
            // At the end it is in none.
            let frames =
                moment.stack.iter().rev().filter(|_| !matches!(event, Some(Event::End(_))));
            (frames.into_iter().find_map(|frame| frame.child_state), None)
        };
        let entered = match event {
            Some(Event::First { entry_axis, .. }) => *entry_axis,
            Some(_) | None => None,
        };
        Self { mask, variants, is_strict, state, step, entered }
    }

    /// What the mirror mask means, and how states are read.
    pub fn note(&self, texts: &Texts) -> String {
        let morton = D == 3 && self.variants.has(Variant::B2Morton);
        let key = if morton { "automaton-morton" } else { "automaton-mask" };
        texts.format(key, &[("mask", self.mask.0.into())])
    }

    /// The child of the tree that a state means.
    fn child_of(&self, state: Child<D>) -> Child<D> {
        self.variants.child_of_state(state, self.mask)
    }

    /// States as corners of a square or cube in a square of this side, with the
    /// transitions between them and the lit one.
    pub fn diagram(&self, side: f64) -> Figure {
        let mut sheet = Sheet::default();
        // Above and at the right there is room for an arrow out of the diagram.
        let reach = 0.5 * (side - NEAR - EXIT);
        let place = |state: Child<D>| {
            let halves = self.variants.child_of_state(state, Axes::NONE);
            corner(halves, [NEAR + reach, EXIT + reach], reach)
        };
        self.draw_transitions(&mut sheet, &place);
        self.draw_states(&mut sheet, [side; 2], &place);
        sheet.figure([side; 2])
    }

    /// Table 3, or what it is in the plane: next state by state and exit plane.
    pub fn exit_table(&self, texts: &Texts) -> Table {
        let axes = (0..D).map(|axis| on_axis(axis, AXIS_NAMES[axis]));
        let row = |state: Child<D>| {
            let in_row = self.state == Some(state);
            let number = Entry::new(state.0.to_string(), tone(in_row, in_row));
            let next = (0..D).map(|axis| {
                let used = in_row && self.step.is_some_and(|(axes, _)| axes.contains(axis));
                let tone = tone(in_row, used);
                match transition(state, axis) {
                    Some(next) => Entry::new(next.0.to_string(), tone),
                    None => Entry::words(texts.get("automaton-end"), tone),
                }
            });
            std::iter::once(number).chain(next).collect()
        };
        Table {
            columns: vec![Anchor::Middle; D + 1],
            head: std::iter::once(texts.get("automaton-state-column").into()).chain(axes).collect(),
            rows: Child::all().map(row).collect(),
        }
    }

    /// Table 2: which mid planes decide, by the plane of entry, and the bits that they
    /// set, as printed if this is asked; in space.
    pub fn entry_table(&self) -> Table {
        let printed = self.variants.has(Variant::B2) || self.variants.has(Variant::B2Morton);
        let row = |axis: usize| {
            let plane: String =
                (0..D).filter(|&e| e != axis).map(|e| AXIS_NAMES[e].to_uppercase()).collect();
            let used = self.entered == Some(axis);
            let plane = Entry::words(plane, tone(used, used));
            let rules = entry_axes::<D>(axis).iter().map(|other| {
                let bit = if printed { 1 << other } else { Axes::<D>::one(other).0 };
                let rule = joined([
                    parameter(other, "m"),
                    if self.is_strict { " < " } else { " ≤ " }.into(),
                    parameter(axis, "0"),
                    format!(" → {bit}").into(),
                ]);
                Entry::new(rule, tone(used, false))
            });
            std::iter::once(plane).chain(rules).collect()
        };
        Table { columns: vec![Anchor::Start; D], head: Vec::new(), rows: (0..D).map(row).collect() }
    }

    fn draw_transitions(&self, sheet: &mut Sheet, place: &impl Fn(Child<D>) -> [f64; 2]) {
        let is_taken = |from: Child<D>, axis: usize| {
            self.step.is_some_and(|(axes, _)| axes == Axes::one(axis)) && self.state == Some(from)
        };
        let edges: Vec<_> = Child::<D>::all()
            .flat_map(|from| (0..D).map(move |axis| (from, axis)))
            .filter_map(|(from, axis)| Some((from, axis, transition(from, axis)?)))
            .collect();
        // The one that is taken lies above the others.
        for taken in [false, true] {
            for &(from, axis, to) in edges.iter().filter(|edge| is_taken(edge.0, edge.1) == taken) {
                let role = if taken { Role::TransitionTaken(axis) } else { Role::Transition(axis) };
                arrow(sheet, role, [place(from), place(to)]);
            }
        }
        // Through an edge or a corner of the cell: several planes at once.
        if let (Some(from), Some((axes, Some(to)))) = (self.state, self.step)
            && axes.count() > 1
        {
            arrow(sheet, Role::TransitionTogether, [place(from), place(to)]);
        }
        // Out of the node, through the planes that have nothing behind them in it.
        if let (Some(from), Some((axes, None))) = (self.state, self.step) {
            let halves = self.variants.child_of_state(from, Axes::NONE);
            for axis in axes.iter().filter(|&axis| halves.is_upper(axis)) {
                let ([x, y], [along, up]) = (place(from), outwards::<D>(axis));
                // From the rim on, as there is nothing to end at.
                let length = EXIT + RIM;
                let to = [x + length * along, y + length * up];
                arrow(sheet, Role::TransitionTaken(axis), [[x, y], to]);
            }
        }
    }

    fn draw_states(
        &self,
        sheet: &mut Sheet,
        page: [f64; 2],
        place: &impl Fn(Child<D>) -> [f64; 2],
    ) {
        let next = self.step.and_then(|(_, next)| next);
        for child in Child::<D>::all() {
            let at = place(child);
            let role = if self.state == Some(child) {
                Role::StateNow
            } else if next == Some(child) {
                Role::StateNext
            } else {
                Role::State
            };
            sheet.disc(role, at);
            sheet.text(role, at, Anchor::Middle, child.0.to_string());
            if Child::all().any(|state| self.child_of(state) != state) {
                let text = format!("→{}", self.child_of(child).0);
                let x = (at[0] + 16.0).min(page[0] - 10.0);
                sheet.text(Role::Note, [x, at[1] + 16.0], Anchor::Middle, text);
            }
        }
    }
}

/// The diagram with its tables, as a figure of this width.
pub(super) fn view<const D: usize>(subject: &Subject<D>, width: f64) -> Figure {
    const GAP: f64 = 20.0;
    let texts = subject.texts;
    let automaton = Automaton::of(subject.moment, subject.event(), subject.query());
    let setting = Setting { least: 20.0, ..Setting::default() };
    let exits = automaton.exit_table(texts);
    let [table_width, table_height] = exits.size(setting);
    let side = if D == 2 { 132.0 } else { 196.0 };
    let mut sheet = Sheet::default();
    sheet.text(Role::Note, [0.0, 8.0], Anchor::Start, automaton.note(texts));
    let top = 24.0;
    sheet.place(automaton.diagram(side).drawn, [0.0, top]);

    // The tables beside the diagram where there is room, or below it.
    let title = |sheet: &mut Sheet, key: &str, [x, y]: [f64; 2]| {
        sheet.text(Role::Note, [x, y + 8.0], Anchor::Start, texts.get(key));
        [x, y + 20.0]
    };
    let is_beside = side + GAP + table_width <= width;
    let at = if is_beside { [side + GAP, top] } else { [0.0, top + side + 12.0] };
    let key = if D == 2 { "automaton-table-in-plane" } else { "automaton-table-3" };
    let at = title(&mut sheet, key, at);
    exits.draw(&mut sheet, at, setting);
    let mut bottom = (at[1] + table_height).max(top + side);
    if D == 3 {
        let entries = automaton.entry_table();
        let at = title(&mut sheet, "automaton-table-2", [0.0, bottom + 14.0]);
        entries.draw(&mut sheet, at, setting);
        bottom = at[1] + entries.size(setting)[1];
    }
    if matches!(subject.event(), Some(Event::First { .. } | Event::Step { .. })) {
        let said = sentence(
            subject.tree,
            subject.ray,
            subject.trace,
            subject.moment.step,
            subject.language(),
        );
        bottom += 12.0;
        bottom += sheet.paragraph(Role::Words, [0.0, bottom], width, &said);
    }
    sheet.figure([width, bottom])
}

/// From the middle of the diagram half along an axis, as space is seen at first: x to the
/// right; in the plane y up; in space z up and y back, towards the upper right.
fn half_along<const D: usize>(axis: usize) -> [f64; 2] {
    match (axis, D) {
        (0, 2) => [1.0, 0.0],
        (1, 2) => [0.0, -1.0],
        (0, _) => [0.68, 0.0],
        (1, _) => [0.32, -0.27],
        (_, _) => [0.0, -0.68],
    }
}

/// Place of a state.
fn corner<const D: usize>(state: Child<D>, centre: [f64; 2], reach: f64) -> [f64; 2] {
    let bit = |axis: usize| if state.is_upper(axis) { 1.0 } else { -1.0 };
    std::array::from_fn(|e| {
        let off: f64 = (0..D).map(|axis| bit(axis) * half_along::<D>(axis)[e]).sum();
        centre[e] + reach * off
    })
}

/// Where a state's arrow along an axis points, of length 1.
fn outwards<const D: usize>(axis: usize) -> [f64; 2] {
    let [x, y] = half_along::<D>(axis);
    [x, y].map(|along| along / x.hypot(y))
}

/// Room beside the states: at the left and below, and for arrows at the right and above.
const NEAR: f64 = 20.0;
const EXIT: f64 = 32.0;
/// From the middle of a state to its rim.
const RIM: f64 = 13.0;

/// Arrow between two states, up to their rims.
fn arrow(sheet: &mut Sheet, role: Role, [from, to]: [[f64; 2]; 2]) {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let along: [f64; 2] = std::array::from_fn(|e| (to[e] - from[e]) / length);
    let off = |point: [f64; 2], by: f64| std::array::from_fn(|e| point[e] + by * along[e]);
    let head = 1.6 * (4.0 + Style::of(Theme::Light, role).width);
    sheet.arrow(role, [off(from, 15.0), off(to, -15.0)], head);
}

fn tone(in_row: bool, used: bool) -> Tone {
    match (in_row, used) {
        (_, true) => Tone::Used,
        (true, false) => Tone::Line,
        (false, false) => Tone::Plain,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, Form, Page, Part};
    use octoscope_core::geometry::Aabb;

    /// Heads of the lit arrows when a state is left through a plane.
    fn lit<const D: usize>(state: u8, axis: usize) -> Vec<Role> {
        let state = Child::<D>(state);
        let (axes, next) = (Axes::one(axis), transition(state, axis));
        let event = Event::Step { state, exits: [0.0; D], axes, next };
        let automaton = Automaton::of(&Moment::default(), Some(&event), &Query::default());
        let figure = automaton.diagram(120.0);
        let extent = figure.extent().unwrap();
        assert!(extent.min[0] >= 0.0 && extent.min[1] >= 0.0, "{extent:?}");
        assert!(extent.max[0] <= 120.0 && extent.max[1] <= 120.0, "{extent:?}");
        let heads = figure
            .drawn
            .iter()
            .filter(|drawn| drawn.part == Part::Head && matches!(drawn.form, Form::Polygon(_)));
        let lit = heads.filter(|drawn| matches!(drawn.role, Role::TransitionTaken(_)));
        lit.map(|drawn| drawn.role).collect()
    }

    /// Checks that pairs of axes turn in the diagram as they do where space is seen first.
    fn check_turns<const D: usize>() {
        let page = Page { width: 400.0, height: 400.0 };
        let camera = Camera::framing(&Aabb { min: [0.0; D], max: [1.0; D] }, page);
        let seen = |axis: usize| {
            let ends = [0.0, 1.0].map(|end| std::array::from_fn(|e| end * f64::from(e == axis)));
            let [from, to] = ends.map(|end| camera.project(page, end).unwrap().at);
            [to[0] - from[0], to[1] - from[1]]
        };
        let turn = |a: [f64; 2], b: [f64; 2]| (a[0] * b[1] - a[1] * b[0]).signum();
        for (a, b) in (0..D).flat_map(|a| (a + 1..D).map(move |b| (a, b))) {
            let here = turn(half_along::<D>(a), half_along::<D>(b));
            assert_eq!(here, turn(seen(a), seen(b)), "{a} {b}");
        }
        assert!(half_along::<D>(0)[0] > 0.0 && half_along::<D>(D - 1)[1] < 0.0);
    }

    #[test]
    fn states_lie_as_the_children_do_in_the_first_view_of_space() {
        check_turns::<2>();
        check_turns::<3>();
    }

    #[test]
    fn the_entry_table_compares_as_the_algorithm_does() {
        let rule = |algorithm| {
            let query = Query::<3>::default().with_algorithm(algorithm);
            let automaton = Automaton::of(&Moment::default(), None, &query);
            automaton.entry_table().rows[0][1].text.plain()
        };
        assert_eq!(rule(Algorithm::Parametric), "t_ym ≤ t_x0 → 2");
        assert_eq!(rule(Algorithm::ParametricTable), "t_ym < t_x0 → 2");
    }

    #[test]
    fn at_the_end_no_state_is_lit() {
        use octoscope_core::scenario::{AnyScenario, built_in};
        use octoscope_core::trace::record;
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let trace = record(&tree, &scenario.ray, &scenario.query);
        let state = |step: usize| {
            let moment = Moment::after(&tree, &trace, step);
            Automaton::of(&moment, trace.events.get(step - 1), &scenario.query).state
        };
        let end = trace.events.len();
        assert!(matches!(trace.events[end - 1], Event::End(_)));
        assert_eq!((state(end), state(end - 1).is_some()), (None, true));
    }

    #[test]
    fn an_arrow_is_lit_when_a_child_is_left_also_out_of_the_node() {
        assert_eq!(lit::<2>(0, 0), [Role::TransitionTaken(0)]);
        assert_eq!(lit::<2>(2, 0), [Role::TransitionTaken(0)], "the end");
        for axis in 0..3 {
            assert_eq!(lit::<3>(7, axis), [Role::TransitionTaken(axis)], "the end");
        }
    }
}
