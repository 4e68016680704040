//! What the diagram of a tree costs, a step at a time, for trees of ever more
//! leaves. Median over the steps of a run; `cargo bench -p octoscope-figure`.

use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::Query;
use octoscope_core::trace::{Moment, record};
use octoscope_core::tree::{Domain, Split, Tree, grow};
use octoscope_figure::{DiagramLens, DiagramOf, Page, tree_diagram};
use std::hint::black_box;
use std::time::Instant;

const PAGE: Page = Page { width: 360.0, height: 290.0 };

fn main() {
    println!("{:<12} {:>9} {:>8} {:>8} {:>10}", "tree", "leaves", "steps", "shapes", "median µs");
    for depth in [5, 8, 10] {
        measure("quadtree", &full::<2>(depth));
    }
    for depth in [3, 5, 7] {
        measure("octree", &full::<3>(depth));
    }
}

fn full<const D: usize>(depth: u8) -> Tree<D> {
    grow(Domain::unit(depth), (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 1 << D]),
    })
    .expect("nobody cancels")
}

fn measure<const D: usize>(name: &str, tree: &Tree<D>) {
    let direction = std::array::from_fn(|e| 1.5 - 0.25 * e as f64);
    let ray = &Ray::new([-0.25; D], direction).expect("the direction is not zero");
    let query = &Query::default();
    let trace = record(tree, ray, query);
    let (mut times, mut shapes) = (Vec::new(), 0);
    for step in 0..=trace.events.len() {
        let moment = &Moment::after(tree, &trace, step);
        let event = step.checked_sub(1).and_then(|index| trace.events.get(index));
        let start = Instant::now();
        let of = DiagramOf { tree, ray, query, moment, event, strayed: &[] };
        let diagram = black_box(tree_diagram(&of, &[], None, PAGE, DiagramLens::default()));
        times.push(start.elapsed().as_secs_f64() * 1e6);
        shapes = shapes.max(diagram.figure.drawn.len());
    }
    times.sort_by(f64::total_cmp);
    let (leaves, steps, median) = (tree.n_leaves(), times.len(), times[times.len() / 2]);
    println!("{name:<12} {leaves:>9} {steps:>8} {shapes:>8} {median:>10.1}");
}
