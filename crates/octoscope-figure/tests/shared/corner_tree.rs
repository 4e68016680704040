//! A small tree.

use octoscope_core::progress::Progress;
use octoscope_core::tree::{Cell, Domain, Split, Tree, grow};

/// Tree of so many levels that is divided towards the origin, its smallest cells full.
pub fn corner_tree<const D: usize>(root_level: u8) -> Tree<D> {
    grow(Domain::unit(root_level), (), &Progress::default(), |cell, ()| match cell {
        Cell { level: 0, .. } => Split::Full(Vec::new()),
        Cell { code, .. } if code == [0; D] => Split::Inner(vec![(); 1 << D]),
        _ => Split::Empty,
    })
    .expect("nobody cancels")
}
