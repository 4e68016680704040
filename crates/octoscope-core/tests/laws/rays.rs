//! Random rays, the awkward ones above all.

use octoscope_core::geometry::Ray;
use octoscope_core::random::Random;
use octoscope_core::tree::{Domain, Tree};

/// Kind of ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    Random,
    Lattice,
    Corner,
    Diagonal,
    AxisParallel,
    InPlane,
    Inside,
    OnPlane,
    Behind,
    Missing,
    NegativeZero,
    Thirds,
    Tiny,
    Far,
    FarThirds,
    Extreme,
}

impl Class {
    pub const ALL: [Self; 16] = [
        Self::Random,
        Self::Lattice,
        Self::Corner,
        Self::Diagonal,
        Self::AxisParallel,
        Self::InPlane,
        Self::Inside,
        Self::OnPlane,
        Self::Behind,
        Self::Missing,
        Self::NegativeZero,
        Self::Thirds,
        Self::Tiny,
        Self::Far,
        Self::FarThirds,
        Self::Extreme,
    ];
}

/// Random ray of this class at `tree`.
pub fn random_ray<const D: usize>(tree: &Tree<D>, class: Class, random: &mut Random) -> Ray<D> {
    loop {
        let (origin, direction) = numbers(tree, class, random);
        if let Ok(ray) = Ray::new(origin, direction) {
            return ray;
        }
    }
}

fn numbers<const D: usize>(
    tree: &Tree<D>,
    class: Class,
    random: &mut Random,
) -> ([f64; D], [f64; D]) {
    let domain = tree.domain();
    let side = domain.side();
    match class {
        Class::Random => {
            let p = around(domain, random);
            (p, to(p, inside(domain, random)))
        }
        Class::Lattice => {
            let step = side / 8.0;
            (lattice(domain, random), integers(random).map(|n| n * step))
        }
        Class::Corner => {
            let p = lattice(domain, random);
            (p, to(p, corner(tree, random)))
        }
        Class::Diagonal => {
            let (signs, q) = (signs(random), corner(tree, random));
            let back = domain.cell_side(0) * random.below(u64::from(domain.grid_size())) as f64;
            (axes(|e| q[e] - back * signs[e]), signs)
        }
        Class::AxisParallel => axis_parallel(inside(domain, random), domain, random),
        Class::InPlane => {
            let (p, mut d) = axis_parallel(corner(tree, random), domain, random);
            // In space also rays that are in one plane only.
            let e = random.below(D as u64) as usize;
            if D == 3 && random.below(2) == 0 && d[e] == 0.0 {
                d[e] = side * random.between(-1.0, 1.0);
            }
            (p, d)
        }
        Class::Inside => {
            let p = inside(domain, random);
            (p, axes(|_| random.between(-1.0, 1.0)))
        }
        Class::OnPlane => {
            let (free, q) = (inside(domain, random), corner(tree, random));
            let p = axes(|e| if random.below(3) == 0 { free[e] } else { q[e] });
            (p, if random.below(2) == 0 { integers(random) } else { signs(random) })
        }
        Class::Behind => {
            let (p, q) = (around(domain, random), inside(domain, random));
            (p, to(q, p))
        }
        Class::Missing => {
            let p = around(domain, random);
            (p, axes(|_| random.between(-1.0, 1.0)))
        }
        Class::NegativeZero => {
            let at =
                if random.below(2) == 0 { inside(domain, random) } else { corner(tree, random) };
            let (p, d) = axis_parallel(at, domain, random);
            (p.map(negative_zero), d.map(negative_zero))
        }
        Class::Thirds => {
            let (p, q) = (lattice(domain, random), lattice(domain, random));
            (p, to(p, q).map(|x| x / 3.0))
        }
        Class::Tiny => {
            let main = random.below(D as u64) as usize;
            let p =
                if random.below(2) == 0 { inside(domain, random) } else { corner(tree, random) };
            let d = axes(|e| {
                let sign = signs::<D>(random)[0];
                if e == main { sign } else { 1e-7 * random.between(-1.0, 1.0) }
            });
            (p, d)
        }
        Class::Far => {
            let p = far(domain, random);
            (p, to(p, inside(domain, random)))
        }
        Class::FarThirds => {
            let p = far(domain, random);
            (p, to(p, corner(tree, random)).map(|x| x / 3.0))
        }
        Class::Extreme => extreme(domain, random),
    }
}

/// Ray along one axis through `q`, from inside, before or beyond.
fn axis_parallel<const D: usize>(
    q: [f64; D],
    domain: &Domain<D>,
    random: &mut Random,
) -> ([f64; D], [f64; D]) {
    let main = random.below(D as u64) as usize;
    let elsewhere = around(domain, random);
    let p = axes(|e| if e == main { elsewhere[e] } else { q[e] });
    let sign = signs::<D>(random)[0];
    (p, axes(|e| if e == main { sign * domain.side() } else { 0.0 }))
}

/// Ray with numbers near the end of the range of doubles.
fn extreme<const D: usize>(domain: &Domain<D>, random: &mut Random) -> ([f64; D], [f64; D]) {
    let mut p = around(domain, random);
    let mut d = to(p, inside(domain, random));
    let e = random.below(D as u64) as usize;
    match random.below(7) {
        0 => d = d.map(|x| x * 1e300),
        1 => d = d.map(|x| x * 1e-300),
        2 => d[e] *= 1e-300,
        3 => d[e] *= 1e300,
        4 => {
            // From the end of the world, along an axis.
            p = inside(domain, random);
            d = [0.0; D];
            let sign = signs::<D>(random)[0];
            (p[e], d[e]) = (-sign * 1e300, sign * [1e-300, 1.0, 1e300][random.below(3) as usize]);
        }
        5 => d = d.map(|x| x * 2f64.powi(-1060)),
        _ => p[e] *= 1e300,
    }
    (p, d)
}

fn negative_zero(x: f64) -> f64 {
    if x == 0.0 { -0.0 } else { x }
}

fn axes<const D: usize>(mut f: impl FnMut(usize) -> f64) -> [f64; D] {
    std::array::from_fn(&mut f)
}

fn to<const D: usize>(p: [f64; D], q: [f64; D]) -> [f64; D] {
    axes(|e| q[e] - p[e])
}

fn inside<const D: usize>(domain: &Domain<D>, random: &mut Random) -> [f64; D] {
    axes(|e| domain.min()[e] + domain.side() * random.unit())
}

fn around<const D: usize>(domain: &Domain<D>, random: &mut Random) -> [f64; D] {
    axes(|e| domain.min()[e] + domain.side() * random.between(-1.0, 2.0))
}

fn far<const D: usize>(domain: &Domain<D>, random: &mut Random) -> [f64; D] {
    axes(|e| domain.min()[e] + domain.side() * (1e6 * random.between(-1.0, 1.0)).round())
}

/// Point of a lattice that goes on beyond the root.
fn lattice<const D: usize>(domain: &Domain<D>, random: &mut Random) -> [f64; D] {
    let size = u64::from(domain.grid_size().min(16));
    let step = domain.side() / size as f64;
    axes(|e| domain.min()[e] + step * (random.below(3 * size + 1) as f64 - size as f64))
}

/// Corner of some node.
fn corner<const D: usize>(tree: &Tree<D>, random: &mut Random) -> [f64; D] {
    let nodes = tree.n_nodes() as u64;
    let bounds = tree.node_box(octoscope_core::tree::NodeId(random.below(nodes) as u32));
    axes(|e| [bounds.min[e], bounds.max[e]][random.below(2) as usize])
}

fn integers<const D: usize>(random: &mut Random) -> [f64; D] {
    axes(|_| random.below(7) as f64 - 3.0)
}

fn signs<const D: usize>(random: &mut Random) -> [f64; D] {
    axes(|_| [1.0, -1.0][random.below(2) as usize])
}
