//! Exact comparisons at the price of doubles.
//!
//! A ray is followed in doubles, of which every comparison is certain by their error
//! bound, or the walk is given up at the first that is not. Then it is walked once more
//! by parameters that keep their operands, from the event on at which it was given up:
//! up to there both are the same, to the last bit.

use super::algorithm::{Algorithm, Options};
use crate::event::{Event, Observer, Outcome};
use crate::geometry::{Exact, Guarded, Ray, doubt, trust};
use crate::tree::{Domain, Tree};

impl Algorithm {
    /// The leaves of `tree` along `ray`, told to `observe`, as exact comparisons decide;
    /// the same events as [`Algorithm::run`] has with [`Exact`].
    pub fn run_exactly<const D: usize>(
        self,
        tree: &Tree<D>,
        ray: &Ray<D>,
        options: Options,
        observe: &mut impl Observer<D>,
    ) -> Outcome {
        if !self.compares_planes_once() || !is_finite(tree.domain(), ray) {
            return self.run::<D, Exact>(tree, ray, options, observe);
        }
        trust();
        let mut trusted = Trusted { observe, n_told: 0 };
        let outcome = self.run::<D, Guarded>(tree, ray, options, &mut trusted);
        if !doubt() {
            return outcome;
        }
        let Trusted { observe, n_told } = trusted;
        let mut rest = Rest { observe, n_known: n_told };
        self.run::<D, Exact>(tree, ray, options, &mut rest)
    }

    /// Whether the algorithm compares parameters of different planes only, and none just
    /// to tell of it: else it would seem in doubt on every ray, or pay for it.
    fn compares_planes_once(self) -> bool {
        match self {
            Self::Parametric
            | Self::ParametricTable
            | Self::Esvo
            | Self::AllChildren
            | Self::Hero
            | Self::Gargantini => true,
            Self::Codes
            | Self::Glassner
            | Self::Samet
            | Self::SametCorner
            | Self::SametNet
            | Self::Bsp
            | Self::Dda
            | Self::DdaOctree
            | Self::Exhaustive => false,
        }
    }
}

/// Whether the parameters of all planes are finite along axes with motion, as they are
/// if those of the root are.
fn is_finite<const D: usize>(domain: &Domain<D>, ray: &Ray<D>) -> bool {
    let (origin, direction) = (ray.origin(), ray.direction());
    (0..D).all(|e| {
        let ends = [0, domain.grid_size()].map(|index| domain.plane(e, index));
        direction[e] == 0.0 || ends.iter().all(|x| ((x - origin[e]) / direction[e]).is_finite())
    })
}

/// Tells events as long as there is no doubt, and counts them.
struct Trusted<'a, O> {
    observe: &'a mut O,
    n_told: u64,
}

impl<const D: usize, O: Observer<D>> Observer<D> for Trusted<'_, O> {
    const LOOKS: bool = O::LOOKS;

    #[inline(always)]
    fn observe(&mut self, event: Event<D>) {
        if O::LOOKS && !doubt() {
            self.n_told += 1;
            self.observe.observe(event);
        }
    }

    #[inline(always)]
    fn wants_more(&self) -> bool {
        !doubt() && self.observe.wants_more()
    }
}

/// Tells all events but the first ones, which are known.
struct Rest<'a, O> {
    observe: &'a mut O,
    n_known: u64,
}

impl<const D: usize, O: Observer<D>> Observer<D> for Rest<'_, O> {
    const LOOKS: bool = O::LOOKS;

    #[inline(always)]
    fn observe(&mut self, event: Event<D>) {
        if self.n_known > 0 {
            self.n_known -= 1;
        } else {
            self.observe.observe(event);
        }
    }

    /// What is known is passed over, also by an observer that has had enough of it.
    #[inline(always)]
    fn wants_more(&self) -> bool {
        self.n_known > 0 || self.observe.wants_more()
    }
}
