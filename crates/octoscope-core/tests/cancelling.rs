//! Building trees that nobody wants any more.

use octoscope_core::geometry::Aabb;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::scene::{Content, Sphere, made};
use octoscope_core::tree::{BuildError, Domain, Merge, Recipe, build_on};
use std::num::NonZeroUsize;
use std::thread;

/// Each of these trees would take minutes, and then have too many nodes.
#[test]
fn building_can_be_cancelled_while_it_is_under_way() {
    let corner = |s: &Sphere<3>, sign: f64| s.centre.map(|c| c + sign * s.radius);
    let spheres = made::cloud::<3>(1, 40);
    let Content::Spheres(list) = &spheres else { panic!("spheres") };
    let boxes = list.iter().map(|s| Aabb { min: corner(s, -1.0), max: corner(s, 1.0) }).collect();
    let recipe = Recipe { depth: 16, merge: Merge::Kept, ..Recipe::default() };
    let domain = Domain::unit(recipe.depth);
    for content in [Content::Boxes(boxes), made::cylinders_and_spheres(1, 10), spheres] {
        for threads in [1, 3] {
            let threads = NonZeroUsize::new(threads).unwrap();
            let progress = Progress::default();
            let tree = thread::scope(|scope| {
                let worker =
                    scope.spawn(|| build_on(threads, &content, domain, &recipe, &progress));
                while !worker.is_finished() && progress.fraction().is_none_or(|part| part == 0.0) {
                    thread::yield_now();
                }
                progress.cancel();
                worker.join().unwrap()
            });
            assert_eq!(tree, Err(BuildError::Cancelled(Cancelled)));
        }
    }
}
