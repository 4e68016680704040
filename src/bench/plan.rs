//! What is measured.

use octoscope_core::measure::{SCENES, Way};
use octoscope_core::traverse::Algorithm;
use std::ops::RangeInclusive;

/// The most levels below the root. Large scenes have too many nodes before: these are
/// left out, and named.
pub const MOST_DEPTH: u8 = 12;
/// The most rays.
pub const MOST_RAYS: usize = 1_000_000;
/// The most repetitions.
pub const MOST_REPEATS: usize = 1000;

/// What is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Names of built-in scenes.
    pub scenes: Vec<&'static str>,
    /// Levels below the root.
    pub depths: RangeInclusive<u8>,
    /// The algorithms and kernels.
    pub ways: Vec<Way>,
    /// Number of rays.
    pub n_rays: usize,
    /// Seed of the rays.
    pub seed: u64,
    /// How often each of them runs through all rays.
    pub n_repeats: usize,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            scenes: SCENES.to_vec(),
            depths: 5..=8,
            ways: Self::all_but_the_oracle(),
            n_rays: 1000,
            seed: 0x5EED,
            n_repeats: 9,
        }
    }
}

impl Plan {
    /// All whose time does not grow with the tree beside the ray.
    pub fn all_but_the_oracle() -> Vec<Way> {
        let oracle = Way::from(Algorithm::Exhaustive);
        Way::all().into_iter().filter(|&way| way != oracle).collect()
    }

    /// Number of scenes and depths.
    pub fn n_sites(&self) -> usize {
        self.scenes.len() * self.depths.clone().count()
    }
}
