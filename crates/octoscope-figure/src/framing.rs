//! What a picture of a question frames: the root, and what tells where its ray comes from.

use crate::camera::{MARGIN, corners};
use crate::marks::{STRETCH, interval, mirrored_origins, nearest, stretch};
use crate::{Camera, Page};
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::query::Query;
use octoscope_core::tree::Domain;

/// Largest factor by which the root may shrink: it keeps about two thirds of its size.
const MOST: f64 = 1.55;
/// The same where nothing of the ray would be seen otherwise: it keeps half its size.
const MOST_OF_ALL: f64 = 2.0;

/// The same where the mirrored ray is what is asked about.
const MOST_MIRRORED: f64 = 3.4;
/// Length of the head of an arrow, in sides of the root, at least.
const HEAD_SHARE: f64 = 0.1;

impl<const D: usize> Camera<D> {
    /// Moves to where the whole root is seen on `page`, with a margin, and as much as can
    /// be of what is asked: of a ray its origin if that is near enough, else the stretch
    /// before the root, or the nearest where it misses the root; then its tip. The root
    /// keeps about two thirds of the size that it has alone, or half of it where the ray
    /// would not be seen otherwise. Keeps the side from which it is seen.
    pub fn frame_question(&mut self, root: &Aabb<D>, ray: &Ray<D>, query: &Query<D>, page: Page) {
        self.frame_wishes(root, wishes(root, ray, query), page);
    }

    /// The same, and before all else where the mirrored ray begins, if one of its rules is
    /// not right: as printed and corrected, or corrected alone.
    pub fn frame_mirrored(
        &mut self,
        domain: &Domain<D>,
        ray: &Ray<D>,
        query: &Query<D>,
        page: Page,
    ) {
        let root = domain.root_box();
        let mirrored = mirrored_origins(domain, ray, query).map(|[right, wrong]| Wish {
            most: MOST_MIRRORED,
            choices: vec![vec![right, wrong, ray.origin()], vec![right, wrong], vec![right]],
        });
        let wishes = mirrored.into_iter().chain(wishes(&root, ray, query)).collect();
        self.frame_wishes(&root, wishes, page);
    }

    fn frame_wishes(&mut self, root: &Aabb<D>, wishes: Vec<Wish<D>>, page: Page) {
        let mut seen: Vec<[f64; D]> = corners(root).collect();
        self.frame_points(&seen, page);
        let alone = self.height;
        if D == 2 {
            // The numbers of the upright axis are wider than the margin.
            const NUMBERS: f64 = 18.0;
            let mut beside = root.min;
            beside[0] -= NUMBERS * self.unit(page);
            seen.push(beside);
            self.frame_points(&seen, page);
        }
        for Wish { most, choices } in wishes {
            for choice in choices {
                let more: Vec<_> = seen.iter().copied().chain(choice).collect();
                let mut trial = *self;
                trial.frame_points(&more, page);
                if trial.height <= most * alone {
                    (*self, seen) = (trial, more);
                    break;
                }
            }
        }
    }

    /// Moves to where all of `points` are seen on `page`, in its middle, with a margin.
    fn frame_points(&mut self, points: &[[f64; D]], page: Page) {
        let Some(bounds) = Aabb::around(points.iter().copied()) else { return };
        self.frame(&bounds, page);
        if D == 2 {
            return;
        }
        // A box around them would be larger than what is seen of them.
        for _ in 0..16 {
            let places = points.iter().map(|&point| Some(self.project(page, point)?.at));
            let Some(places) = places.collect::<Option<Vec<[f64; 2]>>>() else {
                self.height *= 2.0;
                continue;
            };
            let reach = |e: usize, farther: fn(f64, f64) -> f64| {
                places.iter().map(|place| place[e]).reduce(farther).unwrap_or(0.0)
            };
            let [min, max] = [f64::min, f64::max].map(|farther| [0, 1].map(|e| reach(e, farther)));
            let [across, along] = [0, 1].map(|e| 0.5 * (min[e] + max[e]));
            self.pan(page, 0.5 * page.width - across, 0.5 * page.height - along);
            let share = ((max[0] - min[0]) / page.width).max((max[1] - min[1]) / page.height);
            self.height *= share * MARGIN;
        }
    }
}

/// What is wished to be seen beside the root.
struct Wish<const D: usize> {
    /// How much larger the root alone may be.
    most: f64,
    /// The points of each choice, the best first; the first that there is room for is taken.
    choices: Vec<Vec<[f64; D]>>,
}

/// All wishes, one after the other.
fn wishes<const D: usize>(root: &Aabb<D>, ray: &Ray<D>, query: &Query<D>) -> Vec<Wish<D>> {
    let wish = |points: Vec<[f64; D]>| Wish { most: MOST, choices: vec![points] };
    match *query {
        Query::Ray { .. } => {
            let mut all = beginnings(root, ray);
            // With the head of its arrow.
            let head = stretch(HEAD_SHARE, root, ray);
            all.push(wish(vec![ray.at((1.0 + head).min(f64::MAX))]));
            all
        }
        Query::Point { at, .. } => vec![wish(vec![at])],
        Query::Region { min, max, .. } => vec![wish(vec![min, max])],
        Query::Neighbour { .. } => Vec::new(),
    }
}

/// Stretches of the ray that tell where it comes from.
fn beginnings<const D: usize>(root: &Aabb<D>, ray: &Ray<D>) -> Vec<Wish<D>> {
    let stretch = stretch(STRETCH, root, ray);
    let at = |t: f64| ray.at(t.clamp(0.0, f64::MAX));
    match interval(ray, root) {
        Some([enter, exit]) if exit >= 0.0 => {
            let choices = vec![vec![ray.origin()], vec![at(enter - stretch)]];
            vec![Wish { most: MOST, choices }]
        }
        Some(_) | None => {
            let near = nearest(root.centre(), ray);
            let [before, behind] = [near - stretch, near + stretch].map(at);
            let (origin, near) = (ray.origin(), at(near));
            let choices = vec![
                vec![origin, behind],
                vec![before, behind],
                vec![before, near],
                vec![near, behind],
            ];
            let last = Wish { most: MOST_OF_ALL, choices: vec![vec![near]] };
            vec![Wish { most: MOST, choices }, last]
        }
    }
}
