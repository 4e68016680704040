//! What the rail shows: the parameters that the algorithm knows at a moment.

use octoscope_core::explain::distinct;
use octoscope_core::geometry::Ray;
use octoscope_core::text::Texts;
use octoscope_core::trace::{HalvingPlane, Moment};
use octoscope_core::traverse::slabs;
use octoscope_core::tree::{Code, NodeId, Tree};

/// What the rail tells of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RailOf<const D: usize> {
    /// A node.
    Node(NodeId),
    /// The leaf that was reported last, while the algorithm is elsewhere.
    LastLeaf(NodeId),
    /// A cell of the finest grid.
    Cell(Code<D>),
}

impl<const D: usize> RailOf<D> {
    /// Level and codes.
    pub fn place(self, tree: &Tree<D>) -> (u8, Code<D>) {
        match self {
            Self::Node(node) | Self::LastLeaf(node) => (tree.level(node), tree.code(node)),
            Self::Cell(code) => (0, code),
        }
    }

    /// What it is in words, by its level and codes.
    pub fn note(self, texts: &Texts, tree: &Tree<D>) -> String {
        let place = super::place_note(texts, self.place(tree));
        match self {
            Self::Node(_) => place,
            Self::LastLeaf(_) => texts.format("t-rail-last-leaf", &[("place", place.into())]),
            Self::Cell(_) => texts.format("t-rail-cell", &[("place", place.into())]),
        }
    }
}

/// Parameters t of one node. What the algorithm has not computed is not there, unless it
/// has told nothing but an interval, and perhaps the plane that halves it: then the planes
/// of the node are, which are its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rail<const D: usize> {
    /// The node, or the cell.
    pub of: RailOf<D>,
    /// Where the ray enters and leaves it, as far as is known; `None` if it was found to
    /// miss it.
    pub interval: Option<[f64; 2]>,
    near: Option<[f64; D]>,
    mid: Option<[f64; D]>,
    /// The one mid plane that is known where planes are met one by one.
    halving: Option<HalvingPlane>,
    far: Option<[f64; D]>,
    /// How the far planes are called.
    far_name: &'static str,
    /// Parameters of the far planes of the cell that is left in this step.
    left: Option<[f64; D]>,
}

/// Where the ray begins is shown up to so many lengths of what is shown before it.
const NEAR: f64 = 3.0;
/// Planes outside an interval are shown in their place while it keeps this share of what is
/// shown: enough to tell its ends apart.
const LEAST_SHARE: f64 = 0.08;

impl<const D: usize> Rail<D> {
    /// Of the node that was just tested or halved, the leaf that was just reported, the node
    /// on top of the stack, the leaf that is left, or the root; `None` as long as no parameter is
    /// known.
    pub fn of(moment: &Moment<D>) -> Option<Self> {
        let leaf = moment.leaves.last().copied();
        if let Some(tested) = Self::of_tested(moment) {
            return Some(tested);
        }
        if let Some(frame) = moment.frame() {
            // A leaf has no frame of its own where the stack holds parents only.
            let is_of_parent = leaf.is_some_and(|leaf| moment.current == Some(leaf.node))
                && moment.current != Some(frame.node);
            if !is_of_parent {
                let interval = [frame.enter(), frame.exit()];
                let [near, far] = frame.planes().map_or([None; 2], |planes| planes.map(Some));
                return Some(Self {
                    near,
                    mid: frame.mid,
                    far,
                    ..Self::of_node(frame.node, Some(interval))
                });
            }
        }
        if let (Some(part), Some(interval)) = (moment.part, moment.part_interval) {
            // In the step that halves, the plane is one of the node that is halved.
            let node = moment.halving.map_or(part.node, |plane| plane.node);
            return Some(Self { halving: moment.halving, ..Self::of_node(node, Some(interval)) });
        }
        if let Some((grid, cell)) = moment.grid.and_then(|grid| Some((grid, grid.cell?))) {
            let exit = grid.next.into_iter().fold(f64::INFINITY, f64::min);
            let rail = Self::of_node(NodeId::ROOT, Some([grid.enter, exit]));
            let (far, left) = (Some(grid.next), grid.left);
            return Some(Self { of: RailOf::Cell(cell), far, far_name: "Max", left, ..rail });
        }
        if let Some(leaf) = leaf {
            let rail = Self::of_node(leaf.node, Some([leaf.enter, leaf.exit]));
            let is_here = moment.current == Some(leaf.node);
            let of = if is_here { rail.of } else { RailOf::LastLeaf(leaf.node) };
            return Some(Self { of, far: moment.exits.map(|exits| exits.exits), ..rail });
        }
        let clip = moment.clip?;
        let root = Self::of_node(NodeId::ROOT, Some(clip.interval));
        Some(Self { near: Some(clip.near), far: Some(clip.far), ..root })
    }

    /// Of the node that was tested by itself in the last step, if that was a test.
    fn of_tested(moment: &Moment<D>) -> Option<Self> {
        let node = moment.current?;
        // Once a node is entered, it is no longer its test that is told.
        if moment.frame().is_some_and(|frame| frame.node == node) {
            return None;
        }
        let is_tested = moment.tested.is_some() || moment.missed.last() == Some(&node);
        is_tested.then(|| Self::of_node(node, moment.tested))
    }

    /// The same, with the planes of the node along `ray` if there would be none at all.
    pub fn with_planes(self, tree: &Tree<D>, ray: &Ray<D>) -> Self {
        let (RailOf::Node(node) | RailOf::LastLeaf(node)) = self.of else { return self };
        if self.near.or(self.mid).or(self.far).is_some() {
            return self;
        }
        let (near, far) = slabs(tree.domain(), ray, tree.level(node), tree.code(node));
        Self { near: Some(near), far: Some(far), ..self }
    }

    /// The latest entry and the earliest exit: where the ray is in the node, if it is.
    pub fn limits(&self) -> [f64; 2] {
        let latest = |near: [f64; D]| near.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let earliest = |far: [f64; D]| far.into_iter().fold(f64::INFINITY, f64::min);
        self.interval.unwrap_or_else(|| {
            [self.near.map_or(f64::NEG_INFINITY, latest), self.far.map_or(f64::INFINITY, earliest)]
        })
    }

    /// Of a node of which nothing is known but the interval in which the ray is in it.
    fn of_node(node: NodeId, interval: Option<[f64; 2]>) -> Self {
        Self {
            of: RailOf::Node(node),
            interval,
            near: None,
            mid: None,
            halving: None,
            far: None,
            far_name: "1",
            left: None,
        }
    }

    /// Parameters between which the ray is between both planes of an axis, the first
    /// that of the node where the near plane is not known; `None` without planes.
    pub fn bar(&self, axis: usize) -> Option<[f64; 2]> {
        let far = self.far?[axis];
        Some([self.near.map_or(self.limits()[0], |near| near[axis]), far])
    }

    /// Whether the bars begin where the ray is between both planes of their axis: of a node
    /// of which no near plane is known, they begin where the ray enters it.
    pub fn begins_at_planes(&self) -> bool {
        self.near.is_some()
    }

    /// The parameters of an axis with the names of their planes.
    pub fn stops(&self, axis: usize) -> Vec<(f64, &'static str)> {
        let known = [(self.near, "0"), (self.mid, "m"), (self.far, self.far_name)];
        let all = known.into_iter().filter_map(|(t, name)| Some((t?[axis], name)));
        let halving = self.halving.filter(|plane| plane.axis == axis);
        all.chain(halving.map(|plane| (plane.at, "m"))).collect()
    }

    /// The value of a plane of an axis; in the step that crosses it, the one before too.
    pub fn value(&self, axis: usize, t: f64) -> String {
        match (self.of, self.far) {
            (RailOf::Cell(_), Some(next)) => planes_ahead(self.left, next)[axis].clone(),
            (RailOf::Cell(_) | RailOf::Node(_) | RailOf::LastLeaf(_), _) => self.told(t),
        }
    }

    /// A parameter in as few digits as tell it from those next to it.
    pub fn told(&self, t: f64) -> String {
        let stops = (0..D).flat_map(|axis| self.stops(axis)).map(|(t, _)| t);
        let [mut below, mut above] = [f64::NEG_INFINITY, f64::INFINITY];
        for other in stops.chain(self.limits()) {
            if other < t {
                below = below.max(other);
            } else if other > t {
                above = above.min(other);
            }
        }
        distinct(&[below, t, above]).swap_remove(1)
    }

    /// Range of t that is shown: all finite parameters, with a margin, and 0 where all
    /// lie not far behind it. Where all begins at once, in an interval, planes so far
    /// outside that they would leave no room for it are left out, and lie beyond the ends.
    pub fn range(&self) -> [f64; 2] {
        let [enter, exit] = self.limits();
        let length = exit - enter;
        let planes = [self.near, self.mid, self.far].into_iter().flatten().flatten();
        let all = planes.chain(self.halving.map(|plane| plane.at)).chain([enter, exit]);
        let mut finite: Vec<f64> = all.filter(|t| t.is_finite()).collect();
        if self.near.is_none() && length > 0.0 && length.is_finite() {
            // The nearest first.
            let outside = |t: &f64| (enter - t).max(t - exit).max(0.0);
            finite.sort_by(|a, b| outside(a).total_cmp(&outside(b)));
            let [mut low, mut high] = [enter, exit];
            let n_shown = finite.iter().take_while(|&&t| {
                (low, high) = (low.min(t), high.max(t));
                length >= LEAST_SHARE * (high - low)
            });
            let n_shown = n_shown.count();
            finite.truncate(n_shown);
        }
        let low = finite.iter().copied().fold(f64::INFINITY, f64::min);
        let high = finite.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low > high {
            return [0.0, 1.0];
        }
        // Where the ray begins is in sight of what lies behind it and is near.
        let is_behind = high < 0.0 && -high <= NEAR * (high - low);
        let high = if is_behind { 0.0 } else { high };
        // Term by term, as the whole length may be larger than any number.
        let margin = (high * 0.08 - low * 0.08).max(f64::EPSILON * high.abs().max(1.0) * 16.0);
        [(low - margin).max(f64::MIN), (high + margin).min(f64::MAX)]
    }
}

/// When the planes ahead of a cell are met, axis by axis, in as few digits as tell them
/// apart; of those that this step crosses, the parameter before it too, which `left` has.
pub fn planes_ahead<const D: usize>(left: Option<[f64; D]>, next: [f64; D]) -> [String; D] {
    let told = distinct(&[next, left.unwrap_or(next)].concat());
    std::array::from_fn(|axis| match left {
        Some(left) if left[axis] != next[axis] => {
            format!("{} → {}", told[D + axis], told[axis])
        }
        Some(_) | None => told[axis].clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::geometry::Axes;

    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::trace::GridCell;

    fn slab(near: f64, far: f64) -> Rail<2> {
        let rail = Rail::of_node(NodeId::ROOT, Some([near, far]));
        Rail { near: Some([near; 2]), far: Some([far; 2]), ..rail }
    }

    #[test]
    fn the_rail_shows_something_on_both_sides_of_a_single_parameter() {
        for t in [0.0, 1.0, -7e200] {
            let range = slab(t, t).range();
            assert!(range[0] < t && t < range[1], "{range:?}");
        }
        assert_eq!(slab(f64::NEG_INFINITY, f64::INFINITY).range(), [0.0, 1.0]);
        assert!(slab(-1.25, -0.25).range()[1] > 0.0, "the beginning of the ray is in sight");
        for reach in [1e308, f64::MAX] {
            assert!(slab(-reach, reach).range().iter().all(|t| t.is_finite()));
        }
    }

    #[test]
    fn parameters_that_are_almost_the_same_do_not_look_the_same() {
        let rail = slab(0.9999997, 1.000001);
        assert_eq!([rail.told(0.9999997), rail.told(1.000001)], ["0.9999997", "1.000001"]);
        let rail = Rail { mid: Some([1.0 / 3.0, f64::INFINITY]), ..slab(0.0, 1.0) };
        assert_eq!(rail.told(1.0 / 3.0), "0.3333");
        assert_eq!([rail.told(f64::INFINITY), rail.told(f64::NAN)], ["∞", "NaN"]);
    }

    #[test]
    fn planes_far_outside_leave_room_for_the_interval() {
        let interval = Rail::<2>::of_node(NodeId::ROOT, Some([1.0, 2.0]));
        let [low, high] = Rail { mid: Some([1.5, 4.5]), ..interval }.range();
        assert!(low < 1.0 && 4.5 < high && high < 5.0, "{low} {high}");
        let next = Rail { far: Some([2.0, 11.0]), ..interval };
        assert!(next.range()[1] > 11.0, "the interval has a ninth of the rail");
        let [low, high] = Rail { mid: Some([-50.0, 1e9]), ..interval }.range();
        assert!(0.9 < low && low < 1.0 && 2.0 < high && high < 2.1, "{low} {high}");
    }

    #[test]
    fn in_the_grid_the_rail_is_that_of_the_cell() {
        let (cell, next, crossed) = (Some([4, 10]), [0.5, 0.75], Axes::NONE);
        let grid = Some(GridCell { enter: 0.25, cell, next, crossed, left: None });
        let rail = Rail::<2>::of(&Moment { grid, ..Moment::default() }).unwrap();
        assert_eq!((rail.of, rail.interval), (RailOf::Cell([4, 10]), Some([0.25, 0.5])));
        assert_eq!(rail.stops(1), [(0.75, "Max")]);
    }

    #[test]
    fn a_step_across_a_plane_tells_its_parameter_before_and_after() {
        let (cell, next, crossed) = (Some([17, 18]), [0.7855, 0.7984], Axes::one(1));
        let grid = GridCell { enter: 0.748, cell, next, crossed, left: Some([0.7855, 0.748]) };
        let at = |grid| Rail::<2>::of(&Moment { grid: Some(grid), ..Moment::default() }).unwrap();
        let rail = at(grid);
        let values = [0, 1].map(|axis| rail.value(axis, next[axis]));
        assert_eq!(values, ["0.7855", "0.748 → 0.7984"]);
        assert_eq!(at(GridCell { left: None, ..grid }).value(1, next[1]), "0.7984");
    }

    #[test]
    fn a_missed_leaf_is_left_before_it_is_entered() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let ray = Ray::new([-1.0, 3.0], [2.0, -1.0]).unwrap();
        let node = NodeId::ROOT;
        let moment = Moment { current: Some(node), missed: vec![node], ..Moment::default() };
        let rail = Rail::<2>::of(&moment).unwrap().with_planes(&tree, &ray);
        let told = (rail.of, rail.interval, rail.limits());
        assert_eq!(told, (RailOf::Node(node), None, [2.0, 1.0]));
    }

    #[test]
    fn the_rail_of_the_last_leaf_says_that_the_search_is_elsewhere() {
        use octoscope_core::trace::LeafOnRay;
        let leaf = NodeId::ROOT;
        let leaves = vec![LeafOnRay { node: leaf, enter: 0.0, exit: 1.0 }];
        let at = |current| {
            let moment = Moment::<2> { leaves: leaves.clone(), current, ..Moment::default() };
            Rail::of(&moment).unwrap().of
        };
        assert_eq!([at(Some(leaf)), at(None)], [RailOf::Node(leaf), RailOf::LastLeaf(leaf)]);
    }

    #[test]
    fn of_a_part_the_plane_that_halved_it_is_shown() {
        let part = Rail::<2>::of_node(NodeId::ROOT, Some([1.0, 2.0]));
        let rail =
            Rail { halving: Some(HalvingPlane { node: NodeId::ROOT, axis: 1, at: 3.0 }), ..part };
        assert_eq!((rail.stops(0), rail.stops(1)), (vec![], vec![(3.0, "m")]));
        assert!(rail.range()[1] > 3.0);
    }

    #[test]
    fn where_nothing_but_the_interval_is_told_the_planes_are_those_of_the_node() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let ray = Ray::new([-1.0, 3.0], [2.0, -2.0]).unwrap();
        let interval = Rail::<2>::of_node(NodeId::ROOT, Some([1.0, 1.0]));
        let rail = interval.with_planes(&tree, &ray);
        assert_eq!((rail.near, rail.far), (Some([0.5, 1.0]), Some([1.0, 1.5])));
        let told = Rail { mid: Some([0.0; 2]), ..interval };
        assert_eq!(told.with_planes(&tree, &ray), told);
        // A cell owns its lower side, not its upper one.
        for (x, far) in [(0.5, f64::INFINITY), (0.0, f64::INFINITY), (1.0, f64::NEG_INFINITY)] {
            let parallel = Ray::new([x, -1.0], [0.0, 1.0]).unwrap();
            let rail = interval.with_planes(&tree, &parallel);
            assert_eq!(rail.bar(0), Some([f64::NEG_INFINITY, far]), "{x}");
        }
    }

    #[test]
    fn what_is_not_known_is_not_shown() {
        let interval = Rail::<2>::of_node(NodeId::ROOT, Some([1.0, 2.0]));
        assert_eq!((interval.bar(0), interval.stops(0)), (None, vec![]));
        let left = Rail { far: Some([2.0, f64::INFINITY]), ..interval };
        assert_eq!((left.bar(0), left.stops(0)), (Some([1.0, 2.0]), vec![(2.0, "1")]));
    }
}
