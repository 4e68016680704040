//! What was measured.

use super::{Counted, Disagreement, Way};
use crate::trace::Counter;

/// Costs of algorithms in several scenes at several depths, all from one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    /// Seed of the rays.
    pub seed: u64,
    /// Every scene at every depth.
    pub sites: Vec<Site>,
    /// Those whose tree could not be built.
    pub left_out: Vec<LeftOut>,
}

/// A scene at a depth at which nothing could be measured.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// Name of the scene.
    pub scene: String,
    /// Levels below the root.
    pub depth: u8,
    /// Why, for people.
    pub why: String,
}

/// A scene at a depth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Site {
    /// Name of the scene.
    pub scene: String,
    /// Levels below the root.
    pub depth: u8,
    /// Leaves of the tree.
    pub n_leaves: usize,
    /// Number of rays.
    pub n_rays: usize,
    /// What each way has cost.
    pub rows: Vec<Row>,
    /// Where two of them have found other leaves, by more than slivers.
    pub disagreement: Option<Disagreement>,
}

/// What a way to find the leaves has cost at a site.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The way.
    pub way: Way,
    /// Nanoseconds a ray in every repetition, the shortest first; whoever times some of
    /// the rays at once sums up the shortest times of all, the second shortest and so on.
    pub times: Vec<f64>,
    /// What it did.
    pub counted: Counted,
}

/// A number of a row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Nanoseconds a ray, the median.
    #[default]
    Time,
    /// Nanoseconds a visited leaf.
    TimePerLeaf,
    /// Steps a ray.
    Steps,
    /// Nodes that are reached, a ray.
    NodeTouches,
    /// Comparisons of coordinates and parameters, a ray.
    Comparisons,
    /// Lines of memory that a ray reads.
    Lines,
    /// Reads a ray that a cache of 32 KiB does not have.
    CacheMisses,
    /// Comparisons a ray that are predicted wrongly.
    BranchMisses,
    /// Smallest cells along an axis: 2 to the power of the depth.
    Cells,
    /// Leaves of the tree.
    TreeLeaves,
    /// Leaves that a ray visits.
    RayLeaves,
}

impl Quantity {
    /// What can grow.
    pub const COSTS: [Self; 8] = [
        Self::Time,
        Self::TimePerLeaf,
        Self::Steps,
        Self::NodeTouches,
        Self::Comparisons,
        Self::Lines,
        Self::CacheMisses,
        Self::BranchMisses,
    ];

    /// With what it can grow.
    pub const SIZES: [Self; 3] = [Self::Cells, Self::TreeLeaves, Self::RayLeaves];

    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::TimePerLeaf => "time-per-leaf",
            Self::Steps => "steps",
            Self::NodeTouches => "node-touches",
            Self::Comparisons => "comparisons",
            Self::Lines => "lines",
            Self::CacheMisses => "cache-misses",
            Self::BranchMisses => "branch-misses",
            Self::Cells => "cells",
            Self::TreeLeaves => "tree-leaves",
            Self::RayLeaves => "ray-leaves",
        }
    }

    /// Whether only the steps of an algorithm tell it.
    fn is_of_steps(self) -> bool {
        match self {
            Self::Steps
            | Self::NodeTouches
            | Self::Comparisons
            | Self::Lines
            | Self::CacheMisses
            | Self::BranchMisses => true,
            Self::Time | Self::TimePerLeaf | Self::Cells | Self::TreeLeaves | Self::RayLeaves => {
                false
            }
        }
    }

    /// The number; NaN where it was not measured.
    pub fn of(self, site: &Site, row: &Row) -> f64 {
        if self.is_of_steps() && row.way.method().is_none() {
            return f64::NAN;
        }
        let per_ray = |count: u64| count as f64 / site.n_rays.max(1) as f64;
        match self {
            Self::Time => row.median(),
            Self::TimePerLeaf => {
                row.median() * site.n_rays as f64 / row.counted.tally.leaves as f64
            }
            Self::Steps => per_ray(row.counted.n_steps),
            Self::NodeTouches => per_ray(row.counted.counters.get(Counter::NodeTouches)),
            Self::Comparisons => per_ray(row.counted.counters.comparisons()),
            Self::Lines => per_ray(row.counted.lines[1]),
            Self::CacheMisses => per_ray(row.counted.lines[2]),
            Self::BranchMisses => per_ray(row.counted.branches[1]),
            Self::Cells => f64::from(site.depth).exp2(),
            Self::TreeLeaves => site.n_leaves as f64,
            Self::RayLeaves => per_ray(row.counted.tally.leaves),
        }
    }
}

impl Results {
    /// Names of the scenes, in their order.
    pub fn scenes(&self) -> Vec<&str> {
        let mut scenes: Vec<&str> = self.sites.iter().map(|site| site.scene.as_str()).collect();
        scenes.dedup();
        scenes
    }

    /// The ways, in their order.
    pub fn ways(&self) -> Vec<Way> {
        let first = self.sites.first();
        first.map(|site| site.rows.iter().map(|row| row.way).collect()).unwrap_or_default()
    }

    /// The depths, from the least.
    pub fn depths(&self) -> Vec<u8> {
        let mut depths: Vec<u8> = self.sites.iter().map(|site| site.depth).collect();
        depths.sort_unstable();
        depths.dedup();
        depths
    }
}

impl Site {
    /// The row of a way.
    pub fn row(&self, way: Way) -> Option<&Row> {
        self.rows.iter().find(|row| row.way == way)
    }

    /// The least of a quantity.
    pub fn least(&self, quantity: Quantity) -> Option<f64> {
        let all = self.rows.iter().map(|row| quantity.of(self, row));
        all.filter(|x| x.is_finite() && *x > 0.0).min_by(f64::total_cmp)
    }
}

impl Row {
    /// Median time of the repetitions, in nanoseconds a ray; NaN without any.
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }

    /// How far the middle half of the repetitions lies around the median, as a share of
    /// it: half the distance of the quartiles. A single repetition has none.
    pub fn spread(&self) -> Option<f64> {
        let half = 0.5 * (self.quantile(0.75) - self.quantile(0.25));
        (self.times.len() > 1).then(|| half / self.median())
    }

    /// Time below which this share of the repetitions lies.
    fn quantile(&self, share: f64) -> f64 {
        let Some(last) = self.times.len().checked_sub(1) else { return f64::NAN };
        let place = share * last as f64;
        let [below, above] = [place.floor(), place.ceil()].map(|n| self.times[n as usize]);
        below + (place - place.floor()) * (above - below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_does_not_mind_one_slow_repetition() {
        let row = Row { times: vec![100.0, 101.0, 103.0, 104.0, 900.0], ..Row::default() };
        assert_eq!(row.median(), 103.0);
        assert!((row.spread().unwrap() - 1.5 / 103.0).abs() < 1e-12);
        assert_eq!(Row { times: vec![100.0], ..Row::default() }.spread(), None);
        let two = Row { times: vec![1.0, 2.0], ..Row::default() };
        assert_eq!(two.median(), 1.5);
        assert!(Row::default().median().is_nan());
    }

    #[test]
    fn numbers_are_means_of_a_ray() {
        let counted = Counted { n_steps: 30, lines: [50, 20, 5], ..Counted::default() };
        let row = Row { times: vec![7.0], counted, ..Row::default() };
        let site = Site { depth: 6, n_rays: 10, rows: vec![row], ..Site::default() };
        let of = |quantity: Quantity| quantity.of(&site, &site.rows[0]);
        assert_eq!(
            [of(Quantity::Steps), of(Quantity::Lines), of(Quantity::Cells)],
            [3.0, 2.0, 64.0]
        );
        assert_eq!(site.least(Quantity::Time), Some(7.0));
        // The kernel for many rays makes no steps that could be counted.
        let batch = Row { way: Way::KERNELS[0], ..site.rows[0].clone() };
        assert!(Quantity::Steps.of(&site, &batch).is_nan());
        assert_eq!(Quantity::Time.of(&site, &batch), 7.0);
        // Nothing was visited: there is no time a leaf.
        assert_eq!(site.least(Quantity::TimePerLeaf), None);
    }
}
