//! Random trees.

use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_core::tree::{Child, Domain, Split, Tree, grow};

/// Domains of one depth: the unit cube, one with exact planes elsewhere, and
/// ones whose planes are rounded.
pub fn domain<const D: usize>(depth: u8, kind: u64) -> Domain<D> {
    match kind % 4 {
        0 => Domain::new([0.0; D], 1.0, depth),
        1 => Domain::new([1.0; D], 2.0, depth),
        2 => Domain::new(std::array::from_fn(|e| [-0.3, 0.1, -7.7][e]), 0.7, depth),
        _ => Domain::new(std::array::from_fn(|e| [-1e3, 5.0, 123.456][e]), 333.3, depth),
    }
    .expect("the numbers make a domain")
}

/// Tree with one path down to level 0 and `n_inner` inner nodes at most.
pub fn random_tree<const D: usize>(
    domain: Domain<D>,
    n_inner: usize,
    random: &mut Random,
) -> Tree<D> {
    let mut left = n_inner.saturating_sub(usize::from(domain.root_level()));
    grow(domain, true, &Progress::default(), |cell, on_path| {
        let by_chance = cell.level > 0 && left > 0 && random.below(1 << D) < 2;
        if by_chance && !on_path {
            left -= 1;
        }
        if cell.level > 0 && (on_path || by_chance) {
            let chosen = random.below(1 << D) as usize;
            let children = 0..Child::<D>::COUNT;
            return Split::Inner(children.map(|child| on_path && child == chosen).collect());
        }
        if random.below(2) == 0 { Split::Empty } else { Split::Full(vec![]) }
    })
    .expect("nobody cancels")
}
