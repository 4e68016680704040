//! Many rays at once: the walk of `esvo` for several independent rays side by side.
//!
//! A step of a single ray waits: for the comparison before it, for the row of the
//! tree, for the jump that nobody can predict. Here a number of rays are in flight,
//! one a *lane*, and every lane makes one step in turn; a lane whose ray has ended
//! takes the next ray. Going down and going on are one formula, so that no lane jumps:
//! planes lie one cell ahead of the lane (in a leaf) or half a cell (in an inner
//! node), and all that are not after the exit (the entry) are passed.
//!
//! The answer is the exact one on every ray. Parameters are computed in doubles, with
//! a bound of their error; where that does not tell two apart, the comparison is made
//! exactly (`settle`), for that lane and that step alone. Rays for which doubles do
//! not suffice at all are left to the exact walk of a single ray.
//!
//! Nothing is observed here: the walk that is explained is `esvo`, whose result this
//! one must equal, ray for ray.

mod lanes;
mod prepare;
mod settle;

use super::algorithm::{Algorithm, Options, StopAt};
use crate::event::{Event, Observer};
use crate::geometry::{Exact, Ray};
use crate::tree::{MAX_NODES, NodeId, Tree};
use lanes::Lanes;

/// A visited leaf, in 32 bits: its number less 1 (so that children of a row are an
/// even block), and on top whether it is full.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Leaf(u32);

/// Nodes are few enough for that.
const _: () = assert!(MAX_NODES < 1 << 31);

impl Leaf {
    const FULL: u32 = 1 << 31;

    fn new(node: NodeId, full: bool) -> Self {
        let mark = if full { Self::FULL } else { 0 };
        Self(node.0.wrapping_sub(1) & !Self::FULL | mark)
    }

    /// Number of the node.
    #[inline]
    pub fn node(self) -> NodeId {
        NodeId(self.0.wrapping_add(1) & !Self::FULL)
    }

    /// Whether something is in it.
    #[inline]
    pub fn is_full(self) -> bool {
        self.0 & Self::FULL != 0
    }
}

/// How the lanes are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kernel {
    /// With whatever every processor of the kind can do.
    Plain,
    /// With the vectors that this processor has, which is found out when it runs.
    #[default]
    Vector,
}

/// Finds the visited leaves on each of `rays`, exactly, up to `stop_at`, and hands
/// them to `take` with the number of the ray. Rays end in any order.
pub fn visit_many<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    stop_at: StopAt,
    kernel: Kernel,
    mut take: impl FnMut(usize, &[Leaf]),
) {
    match kernel {
        Kernel::Plain => Lanes::<D, 8>::new(tree, rays, stop_at).run(&mut take),
        Kernel::Vector => pulp::Arch::new().dispatch(Vectors { tree, rays, stop_at, take }),
    }
}

/// The kernel with its inputs, as it is handed to the processor's own version.
struct Vectors<'a, const D: usize, F> {
    tree: &'a Tree<D>,
    rays: &'a [Ray<D>],
    stop_at: StopAt,
    take: F,
}

impl<const D: usize, F: FnMut(usize, &[Leaf])> pulp::NullaryFnOnce for Vectors<'_, D, F> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        Lanes::<D, 16>::new(self.tree, self.rays, self.stop_at).run(&mut self.take);
    }
}

/// Leaves on a single ray by the exact walk, appended to `found`.
#[cold]
fn visit_one<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, stop_at: StopAt, found: &mut Vec<Leaf>) {
    let options = Options { stop_at, ..Options::default() };
    Algorithm::Esvo.run::<D, Exact>(tree, ray, options, &mut List(found));
}

struct List<'a>(&'a mut Vec<Leaf>);

impl<const D: usize> Observer<D> for List<'_> {
    fn observe(&mut self, event: Event<D>) {
        if let Event::Leaf { node, full, .. } = event {
            self.0.push(Leaf::new(node, full));
        }
    }
}
