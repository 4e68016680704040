//! What is chosen in the lab.

use crate::bench::{MOST_DEPTH, MOST_RAYS, MOST_REPEATS, Plan};
use octoscope_core::measure::{Quantity, Results, SCENES, Way};
use octoscope_core::traverse::Algorithm;
use serde::{Deserialize, Serialize};

/// What is chosen in the lab: what to measure, and what of it to show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Choice {
    /// Which of [`SCENES`]; not remembered, as there may be others another time.
    #[serde(skip)]
    pub scenes: [bool; SCENES.len()],
    /// Which of [`Algorithm::ALL`]; not remembered either.
    #[serde(skip)]
    pub algorithms: [bool; Algorithm::ALL.len()],
    /// Which of [`Way::KERNELS`]; nor these.
    #[serde(skip)]
    pub kernels: [bool; Way::KERNELS.len()],
    /// Least and greatest depth.
    pub depths: [u8; 2],
    /// Number of rays.
    pub n_rays: usize,
    /// Number of repetitions.
    pub n_repeats: usize,
    /// Seed of the rays.
    pub seed: u64,
    /// What is shown.
    pub tab: Tab,
    /// What of the costs, by its number in [`Quantity::COSTS`].
    pub cost: usize,
    /// What they grow with, by its number in [`Quantity::SIZES`].
    pub size: usize,
    /// Depth of the scenes that are shown.
    pub depth: u8,
    /// Number of the scene whose growth is shown, among those measured.
    pub scene: usize,
}

/// What the lab shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Tab {
    /// Bars for every scene.
    #[default]
    Scenes,
    /// Lines against a size.
    Growth,
    /// What was published.
    Published,
    /// All numbers.
    Table,
    /// Memory and branches of the present ray.
    Processor,
}

impl Tab {
    /// All of them, in their order.
    pub const ALL: [Self; 5] =
        [Self::Scenes, Self::Growth, Self::Published, Self::Table, Self::Processor];

    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::Scenes => "lab-tab-scenes",
            Self::Growth => "lab-tab-growth",
            Self::Published => "lab-tab-published",
            Self::Table => "lab-tab-table",
            Self::Processor => "lab-tab-processor",
        }
    }
}

impl Default for Choice {
    fn default() -> Self {
        Self {
            scenes: SCENES.map(|scene| matches!(scene, "cloud" | "spheres-512")),
            algorithms: Self::OF_THE_PAPER,
            kernels: [false; Way::KERNELS.len()],
            depths: [5, 7],
            n_rays: 500,
            n_repeats: 9,
            seed: 0x5EED,
            tab: Tab::Scenes,
            cost: 0,
            size: 1,
            depth: 6,
            scene: 0,
        }
    }
}

impl Choice {
    /// Those that the published comparison is about.
    pub const OF_THE_PAPER: [bool; Algorithm::ALL.len()] = {
        let mut chosen = [false; Algorithm::ALL.len()];
        let mut n = 0;
        while n < Algorithm::ALL.len() {
            chosen[n] = matches!(
                Algorithm::ALL[n],
                Algorithm::Parametric
                    | Algorithm::Gargantini
                    | Algorithm::Samet
                    | Algorithm::SametCorner
                    | Algorithm::SametNet
                    | Algorithm::Bsp
            );
            n += 1;
        }
        chosen
    };

    /// What is to be measured; `None` without a scene or an algorithm.
    pub fn plan(&self) -> Option<Plan> {
        let chosen = SCENES.into_iter().zip(self.scenes);
        let scenes: Vec<_> = chosen.filter(|(_, is_chosen)| *is_chosen).map(|(s, _)| s).collect();
        let kernels = Way::KERNELS.into_iter().zip(self.kernels);
        let kernels = kernels.filter(|(_, is_chosen)| *is_chosen).map(|(kernel, _)| kernel);
        let algorithms = self.chosen_algorithms().into_iter().map(Way::from);
        let ways: Vec<Way> = algorithms.chain(kernels).collect();
        // What is remembered may come from elsewhere.
        let [least, most] = self.depths.map(|depth| depth.clamp(1, MOST_DEPTH));
        let is_something = !scenes.is_empty() && !ways.is_empty();
        is_something.then(|| Plan {
            scenes,
            ways,
            depths: least.min(most)..=least.max(most),
            n_rays: self.n_rays.clamp(1, MOST_RAYS),
            seed: self.seed,
            n_repeats: self.n_repeats.clamp(1, MOST_REPEATS),
        })
    }

    /// The algorithms that are chosen.
    pub fn chosen_algorithms(&self) -> Vec<Algorithm> {
        let all = Algorithm::ALL.into_iter().zip(self.algorithms);
        all.filter(|(_, is_chosen)| *is_chosen).map(|(algorithm, _)| algorithm).collect()
    }

    /// What of the costs is shown.
    pub fn cost(&self) -> Quantity {
        Quantity::COSTS.get(self.cost).copied().unwrap_or_default()
    }

    /// What they grow with.
    pub fn size(&self) -> Quantity {
        Quantity::SIZES.get(self.size).copied().unwrap_or(Quantity::Cells)
    }

    /// The depth that is shown, of those that were measured.
    pub fn depth_in(&self, results: &Results) -> u8 {
        let depths = results.depths();
        let is_measured = depths.contains(&self.depth);
        if is_measured { self.depth } else { depths.last().copied().unwrap_or(self.depth) }
    }

    /// The scene whose growth is shown, of those that were measured.
    pub fn scene_in<'a>(&self, results: &'a Results) -> &'a str {
        let scenes = results.scenes();
        scenes.get(self.scene).or(scenes.first()).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whatever_is_remembered_makes_a_plan_that_can_be_measured() {
        let odd = Choice {
            depths: [40, 0],
            n_rays: 0,
            n_repeats: 0,
            cost: 99,
            size: 99,
            scene: 99,
            ..Choice::default()
        };
        let plan = odd.plan().unwrap();
        assert_eq!((plan.depths, plan.n_rays, plan.n_repeats), (1..=MOST_DEPTH, 1, 1));
        assert_eq!((odd.cost(), odd.size()), (Quantity::Time, Quantity::Cells));
        assert_eq!(odd.scene_in(&Results::default()), "");
        assert_eq!(odd.depth_in(&Results::default()), 6);
    }

    #[test]
    fn scenes_and_algorithms_begin_as_usual_the_rest_is_remembered() {
        let chosen = Choice {
            scenes: [true; SCENES.len()],
            algorithms: [true; Algorithm::ALL.len()],
            n_rays: 77,
            tab: Tab::Growth,
            ..Choice::default()
        };
        let json = serde_json::to_string(&chosen).unwrap();
        let read: Choice = serde_json::from_str(&json).unwrap();
        assert_eq!(read, Choice { n_rays: 77, tab: Tab::Growth, ..Choice::default() });
    }

    #[test]
    fn nothing_chosen_is_no_plan() {
        let none = Choice { scenes: [false; SCENES.len()], ..Choice::default() };
        assert_eq!(none.plan(), None);
        let algorithms = [false; Algorithm::ALL.len()];
        let no_algorithm = Choice { algorithms, ..Choice::default() };
        assert_eq!(no_algorithm.plan(), None);
        let kernels = Choice { kernels: [false, true], ..no_algorithm };
        assert_eq!(kernels.plan().unwrap().ways, [Way::KERNELS[1]]);
        assert_eq!(Choice::default().plan().unwrap().ways.len(), 6);
    }
}
