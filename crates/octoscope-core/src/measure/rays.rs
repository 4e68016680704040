//! Rays to measure with.

use crate::geometry::Ray;
use crate::random::Random;
use crate::tree::Domain;

/// 2^-20: in the unit cube all numbers are multiples of it, exact in single precision
/// as well.
const UNIT: f64 = 1.0 / (1 << 20) as f64;

/// `n` rays from outside a domain through uniform points of it, in uniform directions;
/// each begins two sides before its point.
pub fn rays_from_outside<const D: usize>(domain: &Domain<D>, seed: u64, n: usize) -> Vec<Ray<D>> {
    let mut random = Random::new(seed);
    let (min, side) = (domain.min(), domain.side());
    let mut ray = || {
        let target: [f64; D] = std::array::from_fn(|_| random.below(1 << 20) as f64 * UNIT);
        let way = direction(&mut random);
        let origin = std::array::from_fn(|e| min[e] + side * (target[e] - 2.0 * way[e]));
        Ray::new(origin, way.map(|x| side * x))
    };
    // In a domain that is hardly finite a ray may not be: another one takes its place.
    let mut rays = Vec::with_capacity(n);
    for _ in 0..2 * n {
        if rays.len() < n
            && let Ok(ray) = ray()
        {
            rays.push(ray);
        }
    }
    rays
}

/// Uniform on the unit sphere, rounded: a point of the ball, brought to length 1.
fn direction<const D: usize>(random: &mut Random) -> [f64; D] {
    loop {
        let way: [f64; D] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let squared = way.iter().map(|x| x * x).sum::<f64>();
        if (0.01..=1.0).contains(&squared) {
            let length = squared.sqrt();
            return way.map(|x| (x / length / UNIT).round() * UNIT);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::query::Query;
    use crate::trace::record;
    use crate::tree::{Split, grow};

    #[test]
    fn rays_come_from_outside_and_cross_the_domain() {
        let domain = Domain::<3>::new([1.0, -2.0, 0.5], 4.0, 3).unwrap();
        let rays = rays_from_outside(&domain, 7, 200);
        assert_eq!(rays.len(), 200);
        for ray in &rays {
            let inside = (0..3).all(|e| {
                let x = ray.origin()[e] - domain.min()[e];
                (0.0..domain.side()).contains(&x)
            });
            assert!(!inside, "{ray:?}");
            let tree = grow(domain, (), &Progress::default(), |_, ()| Split::Empty).unwrap();
            assert!(record(&tree, ray, &Query::default()).events.len() > 2, "{ray:?}");
        }
    }

    #[test]
    fn the_same_seed_gives_the_same_rays_on_the_grid() {
        let domain = Domain::<2>::unit(3);
        let rays = rays_from_outside(&domain, 1, 20);
        assert_eq!(rays, rays_from_outside(&domain, 1, 20));
        assert_ne!(rays, rays_from_outside(&domain, 2, 20));
        let numbers = rays.iter().flat_map(|ray| [ray.origin(), ray.direction()]).flatten();
        assert!(numbers.into_iter().all(|x| (x / UNIT).fract() == 0.0));
    }
}
