//! Our own traversals.

use crate::{NOTHING, Row};
use octoscope_core::event::{Event, Observer};
use octoscope_core::geometry::Ray;
use octoscope_core::traverse::{Algorithm, Kernel, Leaf, Options, StopAt, visit_many};
use octoscope_core::tree::Tree;

/// Two algorithms, ray by ray in doubles, and both kernels for many rays.
pub fn rows<'a>(tree: &'a Tree<3>, rays: &'a [Ray<3>], stop_at: StopAt) -> Vec<Row<'a>> {
    let single = |name, algorithm: Algorithm| Row {
        name,
        run: Box::new(move |answers| {
            let options = Options { stop_at, ..Options::default() };
            for (ray, answer) in rays.iter().zip(answers) {
                let mut full = Full(0);
                let outcome = algorithm.run::<3, f64>(tree, ray, options, &mut full);
                let nearest = outcome.node.map_or(NOTHING, |node| node.0);
                *answer = if stop_at == StopAt::End { full.0 } else { nearest };
            }
        }),
        is_ours: true,
    };
    let many = |name, kernel| Row {
        name,
        run: Box::new(move |answers| {
            visit_many(tree, rays, stop_at, kernel, |ray, leaves| {
                let full = || leaves.iter().filter(|leaf| leaf.is_full());
                let nearest = |leaf: &Leaf| leaf.node().0;
                answers[ray] = match stop_at {
                    StopAt::End => full().count() as u32,
                    StopAt::FirstFull => full().next().map_or(NOTHING, nearest),
                };
            });
        }),
        is_ours: true,
    };
    vec![
        single("parametric", Algorithm::Parametric),
        single("esvo", Algorithm::Esvo),
        many("batch, plain", Kernel::Plain),
        many("batch, vectors", Kernel::Vector),
    ]
}

/// Counts the occupied leaves.
struct Full(u32);

impl Observer<3> for Full {
    #[inline]
    fn observe(&mut self, event: Event<3>) {
        if let Event::Leaf { full, .. } = event {
            self.0 += u32::from(full);
        }
    }
}
