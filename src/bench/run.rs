//! A plan → what it costs.

use super::Plan;
use anyhow::{Context, anyhow};
use octoscope_core::geometry::Ray;
use octoscope_core::measure::{
    Disagreement, LeftOut, Results, Row, Site, Tally, Way, count, count_batch, disagreement,
    rays_from_outside,
};
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, Scenario, built_in};
use octoscope_core::traverse::{Algorithm, Kernel, StopAt, visit_many};
use octoscope_core::tree::{Merge, Recipe, Tree, build};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Rays that are timed together: so few that hardly any such piece is disturbed by
/// another program, and so many that reading the clock is nothing beside them.
const RAYS_AT_ONCE: usize = 16;

/// The same for the kernel for many rays, which has to be kept busy.
const RAYS_IN_FLIGHT: usize = 512;

/// Most pieces into which all rays are cut.
const MOST_PIECES: usize = 4096;

/// Measures everything that is planned; what was measured before it is cancelled is
/// kept, scene by scene and depth by depth, and so is everything beside a tree that
/// cannot be built.
///
/// # Errors
/// Says which tree cannot be built, if none can.
pub fn run(plan: &Plan, progress: &Progress) -> anyhow::Result<Results> {
    let mut results = Results { seed: plan.seed, ..Results::default() };
    let mut first_fault = None;
    // Building and linking a tree, and measuring.
    let n_stages = 2 * plan.n_sites() as u64;
    for &scene in &plan.scenes {
        for depth in plan.depths.clone() {
            let n_done = results.sites.len() + results.left_out.len();
            let stages = [2 * n_done as u64, n_stages];
            match site(plan, scene, depth, stages, progress) {
                Ok(site) => results.sites.push(site),
                Err(error) if error.root_cause().is::<Cancelled>() => return Ok(results),
                // Cancelled while the tree was built.
                Err(_) if progress.check().is_err() => return Ok(results),
                Err(error) => {
                    let why = format!("{error:#}");
                    results.left_out.push(LeftOut { scene: scene.to_owned(), depth, why });
                    first_fault.get_or_insert(error);
                }
            }
        }
    }
    match first_fault.filter(|_| results.sites.is_empty()) {
        Some(error) => Err(error),
        None => Ok(results),
    }
}

fn site(
    plan: &Plan,
    scene: &str,
    depth: u8,
    stages: [u64; 2],
    progress: &Progress,
) -> anyhow::Result<Site> {
    let scenario = built_in(scene).ok_or_else(|| {
        let known = BUILT_IN.map(|scene| scene.id).join(", ");
        anyhow!("there is no built-in scene ‘{scene}’; there are {known}")
    })?;
    let site = match scenario {
        AnyScenario::Quadtree(scenario) => site_in(plan, &scenario, depth, stages, progress),
        AnyScenario::Octree(scenario) => site_in(plan, &scenario, depth, stages, progress),
    };
    let site = site.with_context(|| format!("{scene} at depth {depth}"))?;
    Ok(Site { scene: scene.to_owned(), depth, ..site })
}

fn site_in<const D: usize>(
    plan: &Plan,
    scenario: &Scenario<D>,
    depth: u8,
    [stage, n_stages]: [u64; 2],
    progress: &Progress,
) -> anyhow::Result<Site> {
    progress.enter_stage(stage, n_stages);
    // Every occupied cell is a leaf of its own: where spheres are so small that each
    // cell has a part of one, the tree would be a single full leaf.
    let recipe = Recipe { depth, merge: Merge::Kept, ..scenario.recipe };
    let domain = scenario.domain.cut(depth)?;
    let tree = build(&scenario.source.content()?, domain, &recipe, progress)?;
    let is_linked = |way: &Way| way.method().is_some_and(|m| m.algorithm == Algorithm::SametNet);
    if plan.ways.iter().any(is_linked) {
        // Made once for all rays: its time is not that of a ray.
        tree.link(progress)?;
    }
    let rays = rays_from_outside(tree.domain(), plan.seed, plan.n_rays);

    progress.enter_stage(stage + 1, n_stages);
    // Counted, timed and, all but the first, compared with it.
    let n_passes = plan.ways.len() * (plan.n_repeats + 2);
    progress.start((rays.len() * n_passes.saturating_sub(1)) as u64);
    let mut rows = Vec::new();
    for &way in &plan.ways {
        let counted = match way {
            Way::Traced(method) => {
                count(&tree, &rays, &Query::default().along_the_ray_by(method), progress)?
            }
            Way::Batch(kernel) => count_batch(&tree, &rays, kernel, progress)?,
        };
        rows.push(Row { way, times: Vec::new(), counted });
    }
    // Round after round all take their turn, so that all meet the same weather.
    let mut passes: Vec<Vec<Vec<Duration>>> = vec![Vec::new(); rows.len()];
    for _ in 0..plan.n_repeats {
        for (row, passes) in rows.iter().zip(&mut passes) {
            passes.push(pass(&tree, &rays, row.way, progress)?);
        }
    }
    for (row, passes) in rows.iter_mut().zip(passes) {
        row.times =
            ranked(passes).into_iter().map(|time| time / rays.len().max(1) as f64).collect();
    }
    let disagreement = first_disagreement(&tree, &rays, &rows, progress)?;
    let (n_leaves, n_rays) = (tree.n_leaves(), rays.len());
    Ok(Site { n_leaves, n_rays, rows, disagreement, ..Site::default() })
}

/// Where an algorithm finds other leaves than the first: looked for where the checksums
/// differ.
fn first_disagreement<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    rows: &[Row],
    progress: &Progress,
) -> Result<Option<Disagreement>, Cancelled> {
    let Some((first, others)) = rows.split_first() else { return Ok(None) };
    for row in others {
        if row.counted.checksum == first.counted.checksum {
            progress.advance(rays.len() as u64)?;
            continue;
        }
        let found = disagreement(tree, rays, [first.way, row.way], progress)?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// Nanoseconds of all pieces together: in the fastest repetition of each, in the second
/// fastest and so on. One that another program has disturbed comes late in the order of
/// its own piece, and leaves the others alone.
fn ranked(passes: Vec<Vec<Duration>>) -> Vec<f64> {
    let n_pieces = passes.first().map_or(0, Vec::len);
    let mut ranked = vec![0.0; passes.len()];
    for piece in 0..n_pieces {
        let mut times: Vec<Duration> = passes.iter().map(|pass| pass[piece]).collect();
        times.sort_unstable();
        for (sum, time) in ranked.iter_mut().zip(times) {
            *sum += time.as_nanos() as f64;
        }
    }
    ranked
}

/// Times of a way to find the leaves on all rays, piece by piece.
fn pass<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    way: Way,
    progress: &Progress,
) -> Result<Vec<Duration>, Cancelled> {
    let size = match way {
        Way::Traced(_) => RAYS_AT_ONCE,
        Way::Batch(_) => RAYS_IN_FLIGHT,
    };
    let size = size.max(rays.len().div_ceil(MOST_PIECES));
    let mut times = Vec::with_capacity(rays.len().div_ceil(size));
    for some in rays.chunks(size) {
        let start = Instant::now();
        black_box(match way {
            Way::Traced(method) => walk(tree, some, &Query::default().along_the_ray_by(method)),
            Way::Batch(kernel) => fly(tree, some, kernel),
        });
        times.push(start.elapsed());
        progress.advance(some.len() as u64)?;
    }
    Ok(times)
}

/// Ray by ray.
fn walk<const D: usize>(tree: &Tree<D>, rays: &[Ray<D>], query: &Query<D>) -> Tally {
    let mut tally = Tally::default();
    for ray in rays {
        black_box(query.run(tree, ray, &mut tally));
    }
    tally
}

/// Many rays at once.
fn fly<const D: usize>(tree: &Tree<D>, rays: &[Ray<D>], kernel: Kernel) -> Tally {
    let mut tally = Tally::default();
    visit_many(tree, rays, StopAt::End, kernel, |_, leaves| {
        tally.leaves += leaves.len() as u64;
        tally.occupied += leaves.iter().map(|leaf| u64::from(leaf.is_full())).sum::<u64>();
    });
    tally
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::measure::Quantity;

    fn small() -> Plan {
        Plan {
            scenes: vec!["spheres-512", "quadtree-82"],
            depths: 3..=4,
            n_rays: 40,
            n_repeats: 3,
            ..Plan::default()
        }
    }

    #[test]
    fn everything_planned_is_measured_and_all_find_the_same() {
        let progress = Progress::default();
        let results = run(&small(), &progress).unwrap();
        let sites: Vec<_> = results.sites.iter().map(|s| (s.scene.as_str(), s.depth)).collect();
        let expected =
            [("spheres-512", 3), ("spheres-512", 4), ("quadtree-82", 3), ("quadtree-82", 4)];
        assert_eq!(sites, expected);
        for site in &results.sites {
            assert_eq!((site.rows.len(), site.n_rays), (16, 40));
            assert_eq!(site.disagreement, None);
            for row in &site.rows {
                assert_eq!(row.times.len(), 3);
                assert!(row.times.is_sorted() && Quantity::Time.of(site, row) > 0.0);
                assert_eq!(row.counted.checksum, site.rows[0].counted.checksum);
            }
        }
        assert_eq!(progress.fraction(), Some(1.0));
    }

    #[test]
    fn a_disturbed_piece_does_not_spoil_the_median() {
        // Three repetitions of three pieces, each disturbed in another one.
        let passes = [[10, 20, 900], [900, 20, 30], [10, 900, 30]];
        let passes = passes.map(|pass| pass.map(Duration::from_nanos).to_vec()).to_vec();
        assert_eq!(ranked(passes), [60.0, 60.0, 2700.0]);
        assert_eq!(ranked(Vec::new()), [0.0; 0]);
    }

    #[test]
    fn what_does_not_depend_on_the_machine_is_the_same_again() {
        let [first, second] = [(), ()].map(|()| run(&small(), &Progress::default()).unwrap());
        for (a, b) in first.sites.iter().zip(&second.sites) {
            assert!(a.rows.iter().zip(&b.rows).all(|(a, b)| a.counted == b.counted));
        }
    }

    #[test]
    fn a_misprint_is_told_with_its_ray() {
        let ways = ["parametric", "parametric-table@B-2"].map(|text| text.parse().unwrap());
        let plan = Plan { scenes: vec!["figure-7"], depths: 1..=1, ways: ways.to_vec(), ..small() };
        let results = run(&plan, &Progress::default()).unwrap();
        let disagreement = results.sites[0].disagreement.unwrap();
        assert_eq!([disagreement.reference, disagreement.way], ways);
    }

    #[test]
    fn what_is_cancelled_keeps_what_was_measured() {
        let progress = Progress::default();
        progress.cancel();
        assert_eq!(run(&small(), &progress).unwrap().sites, []);
    }

    #[test]
    fn a_tree_that_cannot_be_built_leaves_the_others() {
        // Deeper than codes reach.
        let ways = vec!["parametric".parse().unwrap()];
        let plan = Plan { scenes: vec!["quadtree-82"], depths: 20..=21, ways, ..small() };
        let results = run(&plan, &Progress::default()).unwrap();
        assert_eq!((results.sites.len(), results.sites[0].depth), (1, 20));
        let [LeftOut { depth: 21, why, .. }] = &results.left_out[..] else { panic!() };
        assert!(why.starts_with("quadtree-82 at depth 21: "), "{why}");
    }

    #[test]
    fn a_tree_that_cannot_be_built_is_named() {
        let plan = Plan { scenes: vec!["rings"], depths: 21..=21, ..small() };
        let error = format!("{:#}", run(&plan, &Progress::default()).unwrap_err());
        assert!(error.starts_with("rings at depth 21: "), "{error}");
    }
}
