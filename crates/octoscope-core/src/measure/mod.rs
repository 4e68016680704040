//! What algorithms cost on many rays, and what of it does not depend on the machine.
//!
//! [`count`] runs a query on all rays and counts; [`Memory`] and [`Branches`] watch
//! what a processor has to fetch and to predict. Times are taken by whoever has a
//! clock, and kept beside the counts in [`Results`], from which [`growth`] fits
//! exponents and [`judged`] tells what of the published comparison holds.

mod branches;
mod cache;
mod checksum;
mod count;
mod disagreement;
mod fit;
mod memory;
mod predictor;
mod published;
mod rays;
mod results;
mod watch;
mod way;

pub use branches::{Branch, BranchKind, Branches};
pub use cache::{Cache, LINE};
pub use checksum::{FNV_BASIS, fnv_1a};
pub use count::{Counted, Tally, count, count_batch};
pub use disagreement::{Disagreement, disagreement};
pub use fit::{PowerLaw, growth};
pub use memory::{Memory, Read};
pub use predictor::TwoBit;
pub use published::{CLAIMS, Claim, Judged, Published, Verdict, judged};
pub use rays::rays_from_outside;
pub use results::{LeftOut, Quantity, Results, Row, Site};
pub use watch::{Watched, watch};
pub use way::Way;

/// The scenes of the published comparison, by their names among the built-in ones.
pub const SCENES: [&str; 6] =
    ["cloud", "cylinders", "objects", "spheres-512", "spheres-4096", "spheres-32768"];
