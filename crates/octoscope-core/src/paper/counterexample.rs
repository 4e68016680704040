//! The smallest scenarios in which variants go wrong.

use crate::geometry::Ray;
use crate::locate::{Direction, NeighbourMethod, Reach};
use crate::query::{Arithmetic, PointMethod, Query};
use crate::scenario::{AnyScenario, Scenario, Source, StepAt, View};
use crate::scene::{Content, Cube};
use crate::traverse::{Algorithm, Options, Variant, Variants};
use crate::tree::{Code, Fill, Merge, Recipe};

/// Scenario that runs `variant` on its smallest counterexample. Only
/// [`Variant::B9`], [`Variant::OneByOne`] and [`Variant::Averaged`] come to the
/// right leaves all the same, the first two on a longer way.
pub fn counterexample(variant: Variant) -> AnyScenario {
    use AnyScenario::{Octree, Quadtree};
    let along = |algorithm| (algorithm, variant);
    let table = Algorithm::ParametricTable;
    let variants = Variants::NONE.with(variant);
    match variant {
        Variant::OneByOne => Octree(rays([-1.0; 3], [1.0; 3], along(Algorithm::Parametric))),
        Variant::Averaged => Quadtree(rays([-1.0, 0.1], [1.0, 0.3], along(Algorithm::Parametric))),
        Variant::Push => Quadtree(Scenario {
            recipe: Recipe { depth: 3, ..KEPT },
            source: cells(vec![[2, 2]]),
            ..rays([1.875, 1.627], [-1.375, -1.127], along(Algorithm::Glassner))
        }),
        Variant::Gem => Octree(rays([0.0, 0.0, 0.5], [1.0, 0.0, -0.5], along(Algorithm::Bsp))),
        Variant::B1 => Quadtree(rays([-2.0, 0.0], [1.0, 1.0], along(table))),
        Variant::B2 | Variant::B2Morton => {
            Octree(rays([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0], along(table)))
        }
        Variant::B3 | Variant::B4 => Quadtree(rays([-1.0, 0.1], [1.0, 0.1], along(table))),
        Variant::B5 => Octree(rays([1.0, 0.25, -1.0], [0.0, 0.0, 1.0], along(table))),
        Variant::B6 => Octree(rays([0.75, 0.75, -1.0], [0.0, 0.0, 1.0], along(table))),
        Variant::B7 => Quadtree(Scenario {
            domain: Cube { min: [1.0; 2], side: 2.0 },
            ..rays([4.0, 1.25], [-1.0, 0.5], along(table))
        }),
        Variant::B9 => Octree(rays([0.625, 0.75, 0.875], [1.0; 3], along(Algorithm::Parametric))),
        Variant::B10 => Octree(rays([1.25; 3], [1.0; 3], along(table))),
        Variant::B11 => Quadtree(rays([-0.5, 0.5], [1.0; 2], along(table))),
        Variant::B18 | Variant::B19 => Quadtree(asked(2, [1, 1], point([0.375; 2], variants))),
        Variant::B21 => Quadtree(asked(1, [1, 1], point([1.0, 0.25], variants))),
        Variant::B24a | Variant::B24c => {
            Quadtree(asked(4, [5, 9], region([[5.5, 9.5], [6.5, 10.5]], variants)))
        }
        // The corners differ along x alone.
        Variant::B24b => Quadtree(asked(4, [5, 9], region([[5.5, 9.25], [6.5, 9.75]], variants))),
        Variant::B25Leftmost | Variant::B25Rightmost => {
            Quadtree(asked(2, [1, 1], neighbour([0, 0], [1, 0], variants)))
        }
        // To the left of the cell lie smaller ones.
        Variant::B28 => Quadtree(asked(2, [1, 1], neighbour([2, 0], [-1, 0], variants))),
    }
}

/// Occupied cells stay leaves of level 0, so that one cell divides the root.
const KEPT: Recipe =
    Recipe { depth: 1, capacity: 4, merge: Merge::Kept, threshold: 24, fill: Fill::Surface };

fn cells<const D: usize>(codes: Vec<Code<D>>) -> Source<D> {
    Source::Inline(Content::Cells(codes))
}

/// A ray through a root with one level of children; the last of them is full.
fn rays<const D: usize>(
    origin: [f64; D],
    direction: [f64; D],
    (algorithm, variant): (Algorithm, Variant),
) -> Scenario<D> {
    let options = Options { variants: [variant].into_iter().collect(), ..Options::default() };
    let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles };
    Scenario {
        domain: Cube::UNIT,
        source: cells(vec![[1; D]]),
        recipe: KEPT,
        ray: Ray::new(origin, direction).expect("the numbers make a ray"),
        query,
        step: StepAt::First,
        view: View::new(),
    }
}

/// A query in a tree that is divided around one smallest cell.
fn asked(depth: u8, cell: Code<2>, query: Query<2>) -> Scenario<2> {
    Scenario {
        source: cells(vec![cell]),
        recipe: Recipe { depth, ..KEPT },
        query,
        ..rays([-0.25, 0.25], [1.0, 0.25], (Algorithm::Parametric, Variant::Averaged))
    }
}

fn point(at: [f64; 2], variants: Variants) -> Query<2> {
    Query::Point { at, method: PointMethod::Codes, variants }
}

/// Region between two corners in sixteenths.
fn region(corners: [[f64; 2]; 2], variants: Variants) -> Query<2> {
    let [min, max] = corners.map(|corner| corner.map(|x| x / 16.0));
    Query::Region { min, max, variants }
}

/// The leaf beside a cell of level 1.
fn neighbour(code: Code<2>, direction: [i8; 2], variants: Variants) -> Query<2> {
    let direction = Direction::new(direction).expect("one step along x");
    let (reach, method) = (Reach::Leaf, NeighbourMethod::Codes);
    Query::Neighbour { level: 1, code, direction, reach, method, variants }
}

#[cfg(test)]
mod tests {
    use super::super::verdict;
    use super::*;

    use crate::trace::record;

    fn agrees<const D: usize>(scenario: &Scenario<D>) -> [bool; 2] {
        let tree = scenario.tree().unwrap();
        let check = |query| {
            let trace = record(&tree, &scenario.ray, &query);
            let verdict = verdict(&tree, &scenario.ray, &trace);
            assert!(
                verdict
                    .first_wrong_step
                    .is_none_or(|step| (1..=trace.events.len()).contains(&step))
            );
            verdict.agrees()
        };
        [scenario.query, scenario.query.corrected()].map(check)
    }

    #[test]
    fn variants_go_wrong_where_the_right_rules_do_not() {
        for variant in Variant::ALL {
            let scenario = counterexample(variant);
            let results = match &scenario {
                AnyScenario::Quadtree(scenario) => agrees(scenario),
                AnyScenario::Octree(scenario) => agrees(scenario),
            };
            let longer = matches!(variant, Variant::B9 | Variant::OneByOne | Variant::Averaged);
            assert_eq!(results, [longer, true], "{variant:?}");
        }
    }

    #[test]
    fn counterexamples_read_back() {
        for variant in Variant::ALL {
            let scenario = counterexample(variant);
            assert_eq!(AnyScenario::parse(&scenario.print()), Ok(scenario), "{variant:?}");
        }
    }
}
