//! Degenerate rays: those on which traversals go wrong.
//!
//! Each is made for the tree at hand, so that it meets the very corner, plane or
//! tie that it is about, exactly in doubles.

mod rays;
mod snap;

pub use snap::{Snap, Snapped, snap};

use crate::geometry::Ray;
use crate::text::{Bilingual, Language, Texts};
use crate::tree::Tree;
use thiserror::Error;

/// A degenerate ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Degenerate {
    /// Along one axis, beside all planes.
    AxisParallel,
    /// In a mid plane, along faces of the smallest leaves, with its axis at rest.
    FacePlane,
    /// Along an edge of cells, where two mid planes meet.
    Edge,
    /// Through a corner of the smallest cells.
    Corner,
    /// Through the centre of the root, with equal components.
    Centre,
    /// Down the main diagonal of the root: through its centre, with equal components
    /// below 0.
    Diagonal,
    /// In a mid plane, along faces of the smallest leaves, where its component is −0.0.
    NegativeZero,
    /// From a mid plane, down across it.
    OnFace,
    /// From a corner of cells.
    OnCorner,
    /// From the inside of the root.
    Inside,
    /// Away from the root.
    Behind,
    /// From a face of the root, out of it.
    Leaving,
    /// Past the root, which it touches in one point.
    Grazing,
    /// In the lower face of the root.
    LowerFace,
    /// In the upper face of the root.
    UpperFace,
    /// Nearly along an axis, from a mid plane, and not far from it past faces of the
    /// smallest leaves: another component is 10⁻⁷ of it.
    Tiny,
    /// From a million sides away.
    Far,
    /// Past the root.
    Miss,
    /// From one lattice point to another, with a tie of two axes.
    Lattice,
    /// From one lattice point to another, with a tie of three axes.
    LatticeSpace,
    /// From one lattice point towards another in thirds, which doubles round, so that
    /// they decide otherwise.
    Thirds,
    /// So slow that t is of the order 10³⁰⁰.
    Slow,
}

/// No degenerate ray has this name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("there is no ray ‘{0}’ in the gallery; there are {list}", list = all_ids())]
pub struct UnknownDegenerate(pub String);

fn all_ids() -> String {
    Degenerate::ALL.map(Degenerate::id).join(", ")
}

impl Degenerate {
    /// The whole gallery.
    pub const ALL: [Self; 22] = [
        Self::AxisParallel,
        Self::FacePlane,
        Self::LowerFace,
        Self::UpperFace,
        Self::Edge,
        Self::Corner,
        Self::Centre,
        Self::Diagonal,
        Self::NegativeZero,
        Self::Tiny,
        Self::OnFace,
        Self::OnCorner,
        Self::Inside,
        Self::Behind,
        Self::Leaving,
        Self::Grazing,
        Self::Miss,
        Self::Lattice,
        Self::LatticeSpace,
        Self::Thirds,
        Self::Far,
        Self::Slow,
    ];

    /// Name on the command line.
    pub fn id(self) -> &'static str {
        match self {
            Self::AxisParallel => "axis-parallel",
            Self::FacePlane => "face-plane",
            Self::Edge => "edge",
            Self::Corner => "corner",
            Self::Centre => "centre",
            Self::Diagonal => "diagonal",
            Self::NegativeZero => "negative-zero",
            Self::OnFace => "on-face",
            Self::OnCorner => "on-corner",
            Self::Inside => "inside",
            Self::Behind => "behind",
            Self::Leaving => "leaving",
            Self::Grazing => "grazing",
            Self::LowerFace => "lower-face",
            Self::UpperFace => "upper-face",
            Self::Tiny => "tiny",
            Self::Far => "far",
            Self::Miss => "miss",
            Self::Lattice => "lattice",
            Self::LatticeSpace => "lattice-space",
            Self::Thirds => "thirds",
            Self::Slow => "slow",
        }
    }

    /// Whether the ray is one of space alone.
    pub fn is_of_space(self) -> bool {
        matches!(self, Self::Edge | Self::LatticeSpace)
    }

    /// Whether there may be such a ray in `tree`: in the plane an edge is a face, and
    /// three axes do not tie; and a root that is not divided has no mid planes.
    pub fn exists_in<const D: usize>(self, tree: &Tree<D>) -> bool {
        let divided = !tree.root().is_leaf();
        match self {
            Self::AxisParallel
            | Self::LowerFace
            | Self::UpperFace
            | Self::Diagonal
            | Self::Inside
            | Self::Behind
            | Self::Leaving
            | Self::Grazing
            | Self::Miss
            | Self::Far
            | Self::Slow => true,
            Self::FacePlane
            | Self::Corner
            | Self::Centre
            | Self::NegativeZero
            | Self::Tiny
            | Self::OnFace
            | Self::OnCorner
            | Self::Lattice
            | Self::Thirds => divided,
            Self::Edge | Self::LatticeSpace => divided && D == 3,
        }
    }

    /// The ray for `tree`, or `None` if it has none, as [`Degenerate::exists_in`]
    /// says or since doubles cannot hold its numbers. O(leaves).
    pub fn ray<const D: usize>(self, tree: &Tree<D>) -> Option<Ray<D>> {
        rays::ray(self, tree)
    }

    /// The next one that `tree` has after this one, or after none, round and round.
    pub fn following<const D: usize>(last: Option<Self>, tree: &Tree<D>) -> Self {
        let place = last.and_then(|last| Self::ALL.into_iter().position(|ray| ray == last));
        let (before, after) = Self::ALL.split_at(place.map_or(0, |place| place + 1));
        let mut all = after.iter().chain(before).copied();
        all.find(|ray| ray.ray(tree).is_some()).expect("every tree has a ray along an axis")
    }

    /// Name, in a few words.
    pub fn name(self, language: Language) -> String {
        texts(language).get(&format!("gallery-{}", self.id()))
    }

    /// What is to be watched on the ray, in one sentence.
    pub fn watch(self, language: Language) -> String {
        texts(language).get(&format!("watch-{}", self.id()))
    }
}

/// What is said where a tree has no ray of a kind that it might have.
pub fn no_such_ray(language: Language) -> String {
    texts(language).get("gallery-none")
}

impl std::str::FromStr for Degenerate {
    type Err = UnknownDegenerate;

    fn from_str(id: &str) -> Result<Self, UnknownDegenerate> {
        let found = Self::ALL.into_iter().find(|ray| ray.id() == id);
        found.ok_or_else(|| UnknownDegenerate(id.to_owned()))
    }
}

const ENGLISH: &str = include_str!("../../../../assets/texts/en/gallery.ftl");
const GERMAN: &str = include_str!("../../../../assets/texts/de/gallery.ftl");

fn texts(language: Language) -> &'static Texts {
    static TEXTS: Bilingual = Bilingual::new(ENGLISH, GERMAN);
    TEXTS.texts(language)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::tree::{Domain, Split, grow};

    #[test]
    fn every_ray_and_every_snap_is_told_in_both_languages() {
        for language in Language::ALL {
            assert!(no_such_ray(language).ends_with('.'));
            for ray in Degenerate::ALL {
                assert_eq!(ray.id().parse(), Ok(ray));
                let (name, watch) = (ray.name(language), ray.watch(language));
                assert!(!name.contains("gallery-") && !name.ends_with('.'), "{name}");
                assert!(watch.ends_with('.') && !watch.contains("watch-"), "{watch}");
            }
            for snap in Snap::ALL {
                let told = snap.told(language);
                assert!(told.ends_with('.') && !told.contains("snap-"), "{told}");
            }
        }
        let keys = |source: &str| source.lines().filter(|line| line.contains(" = ")).count();
        let n_keys = 2 * Degenerate::ALL.len() + Snap::ALL.len() + 1;
        assert_eq!((keys(ENGLISH), keys(GERMAN)), (n_keys, n_keys));
    }

    fn goes_round<const D: usize>(root_level: u8, n_expected: usize) {
        let grown = grow(Domain::<D>::unit(root_level), (), &Progress::default(), |cell, ()| {
            if cell.level > 0 { Split::Inner(vec![(); 1 << D]) } else { Split::Empty }
        });
        let tree = grown.unwrap();
        let mut seen = vec![];
        while seen.len() <= n_expected {
            seen.push(Degenerate::following(seen.last().copied(), &tree));
        }
        assert_eq!((seen[0], seen.pop()), (Degenerate::ALL[0], Some(Degenerate::ALL[0])));
        let exist = Degenerate::ALL.into_iter().filter(|ray| ray.exists_in(&tree));
        assert!(exist.eq(seen));
    }

    #[test]
    fn the_gallery_goes_round() {
        goes_round::<2>(2, 20);
        goes_round::<3>(2, 22);
        goes_round::<2>(0, 11);
        goes_round::<3>(0, 11);
        assert!("fast".parse::<Degenerate>().unwrap_err().to_string().contains("lattice-space"));
    }
}
