//! The kinds of questions that are asked of a tree.

use crate::document::Document;
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::traverse::Variants;
use octoscope_core::tree::Code;

/// What is asked for, whatever about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QueryKind {
    /// The leaves along the ray.
    Ray,
    /// The leaf that holds a point.
    Point,
    /// The smallest node that holds a box.
    Region,
    /// The neighbours of a cell.
    Neighbour,
}

impl QueryKind {
    /// All kinds, in the order of the panel.
    pub const ALL: [Self; 4] = [Self::Ray, Self::Point, Self::Region, Self::Neighbour];

    /// That of a query.
    pub fn of<const D: usize>(query: &Query<D>) -> Self {
        match query {
            Query::Ray { .. } => Self::Ray,
            Query::Point { .. } => Self::Point,
            Query::Region { .. } => Self::Region,
            Query::Neighbour { .. } => Self::Neighbour,
        }
    }

    /// Key of its name.
    pub fn key(self) -> &'static str {
        match self {
            Self::Ray => "query-ray",
            Self::Point => "query-point",
            Self::Region => "query-region",
            Self::Neighbour => "query-neighbour",
        }
    }

    /// Asks for it in `document`: about what is on the screen, from the first step on; for
    /// the ray, where it was left.
    pub fn ask<const D: usize>(self, document: &mut Document<D>) {
        let domain = document.tree.domain();
        let part = |share: f64| {
            std::array::from_fn(|e| domain.min()[e] + domain.side() * (share + 0.03125 * e as f64))
        };
        let variants = Variants::NONE;
        document.ask(match self {
            Self::Ray => return document.back_to_ray(),
            Self::Point => {
                Query::Point { at: part(0.546_875), method: PointMethod::default(), variants }
            }
            Self::Region => Query::Region { min: part(0.3125), max: part(0.40625), variants },
            Self::Neighbour => {
                let leaf = document.trace.leaves().next().map(|(leaf, _)| leaf);
                let (level, code): (u8, Code<D>) = match leaf {
                    Some(leaf) => (document.tree.level(leaf), document.tree.code(leaf)),
                    None => (0, [0; D]),
                };
                let right = std::array::from_fn(|e| i8::from(e == 0));
                let direction = Direction::new(right).expect("one step along x");
                let (reach, method) = (Reach::default(), NeighbourMethod::default());
                Query::Neighbour { level, code, direction, reach, method, variants }
            }
        });
    }
}
