//! Which panels stand beside the space view.

use super::PanelKind;
use octoscope_core::locate::NeighbourMethod;
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::traverse::Algorithm;
use serde::{Deserialize, Serialize};

/// Selection of panels beside the space view.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub enum Preset {
    /// Codes of nodes and points, bit by bit.
    Bits,
    /// Parameters on their common axis.
    #[default]
    Rail,
    /// States and tables.
    Automaton,
    /// Listing, variables, stack, counters.
    Debug,
    /// All algorithms on the same ray.
    Compare,
    /// Large picture, large sentence, one panel.
    Lecture,
    /// The tree as a diagram, and what rules children out.
    Tree,
    /// Many rays at once.
    Map,
}

impl Preset {
    /// All presets, in the order of their keys.
    pub const ALL: [Self; 8] = [
        Self::Bits,
        Self::Rail,
        Self::Automaton,
        Self::Debug,
        Self::Compare,
        Self::Lecture,
        Self::Tree,
        Self::Map,
    ];

    /// The panels from top to bottom, for a query: those that have nothing to
    /// say about it give way to the one that explains it.
    pub fn panels<const D: usize>(self, query: &Query<D>) -> Vec<PanelKind> {
        let own = own_panel(query);
        let about_rays = matches!(query, Query::Ray { .. });
        let chosen = self.chosen(query).iter().copied();
        let mut panels: Vec<_> = chosen.filter(|&kind| self.says_something(kind, query)).collect();
        let has_room = match self {
            Self::Debug | Self::Tree | Self::Map => false,
            Self::Lecture => panels.is_empty(),
            Self::Bits | Self::Rail | Self::Automaton | Self::Compare => true,
        };
        if let Some(own) = own.filter(|own| has_room && !panels.contains(own)) {
            panels.insert(usize::from(about_rays).min(panels.len()), own);
            // What waits on the stack is half of what its panel shows.
            if own == PanelKind::Halves && self != Self::Lecture {
                panels.insert(2.min(panels.len()), PanelKind::Stack);
            }
        }
        if query.is_misprinted() {
            if self == Self::Lecture {
                panels.clear();
            }
            panels.insert(self.place_of_lab(&panels), PanelKind::Paper);
        }
        panels
    }

    /// Where among `panels` the paper lab opens: above them, but for the map of where the
    /// rule fails.
    pub fn place_of_lab(self, panels: &[PanelKind]) -> usize {
        usize::from(self == Self::Map && panels.first() == Some(&PanelKind::Map))
    }

    /// The panels of which it shows only the heading at first.
    pub fn folded<const D: usize>(self) -> &'static [PanelKind] {
        // In space, rail and automaton fill a side each.
        if self == Self::Rail && D == 3 { &[PanelKind::Automaton] } else { &[] }
    }

    /// The panels that the preset is made of, where all of them say something.
    fn chosen<const D: usize>(self, query: &Query<D>) -> &'static [PanelKind] {
        use PanelKind::{
            Automaton, Codes, Compare, Counters, Listing, Map, MidPlanes, Neighbour, Rail, Stack,
            Tree, Variables, WhyNot,
        };
        let own = own_panel(query);
        let about_rays = matches!(query, Query::Ray { .. });
        match self {
            // The path through the tree is what the codes say, bit by bit.
            Self::Bits if matches!(own, None | Some(Codes | MidPlanes)) => &[Codes, Tree, Counters],
            Self::Bits => &[Codes, Neighbour, Counters],
            Self::Rail if D == 2 => &[Rail, Automaton, Codes, Counters],
            // Its sums need all the room.
            Self::Rail if own == Some(Neighbour) && about_rays => &[Rail],
            Self::Rail if own.is_none() || own == Some(Neighbour) => {
                &[Rail, Automaton, Codes, Counters]
            }
            // What is peculiar to the algorithm takes the place of the codes.
            Self::Rail => &[Rail, Counters],
            Self::Automaton if D == 2 => &[Automaton, Rail, Counters],
            Self::Automaton => &[Automaton, Rail],
            Self::Debug => &[Listing, Variables, Stack, Counters],
            Self::Compare if about_rays => &[Compare],
            Self::Compare => &[Counters],
            // Most steps are about these.
            Self::Lecture if is_by_codes(query) => &[Codes],
            // The algorithm's own panel, if it has one.
            Self::Lecture if own.is_some() => &[],
            Self::Lecture => &[Rail],
            Self::Tree => &[Tree, WhyNot],
            Self::Map => &[Map, Counters],
        }
    }

    /// Whether a panel of the preset has something to say about a query.
    fn says_something<const D: usize>(self, kind: PanelKind, query: &Query<D>) -> bool {
        use PanelKind::{
            Automaton, Children, Codes, Compare, Counters, Cuts, Grid, Halves, Links, Listing, Map,
            MidPlanes, Neighbour, Paper, Rail, Region, Stack, Tables, Tree, Variables, WayDown,
            WhyNot,
        };
        let own = own_panel(query);
        let algorithm = match query {
            Query::Ray { algorithm, .. } => Some(*algorithm),
            Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => None,
        };
        match kind {
            Rail | Compare => algorithm.is_some(),
            // Where it is what is wanted, it says why there is none.
            Map => algorithm.is_some() || self == Self::Map,
            Automaton => {
                matches!(algorithm, Some(Algorithm::Parametric | Algorithm::ParametricTable))
            }
            Stack => algorithm.is_some_and(is_top_down),
            Region | Neighbour | Tables | Cuts | Children | WayDown | Links | Halves
            | MidPlanes | Grid => own == Some(kind),
            // Where nothing is found by them, they are another answer.
            Codes if own == Some(MidPlanes) => false,
            // Beside these there is no room for them.
            Codes => self != Self::Rail || !matches!(own, Some(Tables | Halves)),
            WhyNot => matches!(query, Query::Ray { .. } | Query::Point { .. }),
            Listing | Variables | Counters | Paper | Tree => true,
        }
    }

    /// Least height of type, in points of the window: in a lecture, of the 20 points
    /// that are read from the back row what its scale leaves; else 0.
    pub fn least_type(self) -> f32 {
        if self == Self::Lecture { 20.0 / self.scale() } else { 0.0 }
    }

    /// Factor of type and lines.
    pub fn scale(self) -> f32 {
        match self {
            Self::Lecture => 1.6,
            Self::Bits
            | Self::Rail
            | Self::Automaton
            | Self::Debug
            | Self::Compare
            | Self::Tree
            | Self::Map => 1.0,
        }
    }
}

/// The panel that shows what is peculiar to a query and its algorithm.
fn own_panel<const D: usize>(query: &Query<D>) -> Option<PanelKind> {
    match query {
        Query::Ray { algorithm, .. } => match algorithm {
            Algorithm::Parametric
            | Algorithm::ParametricTable
            | Algorithm::Esvo
            | Algorithm::Exhaustive => None,
            Algorithm::AllChildren => Some(PanelKind::Children),
            Algorithm::Hero | Algorithm::Gargantini => Some(PanelKind::Cuts),
            Algorithm::Codes => Some(PanelKind::Neighbour),
            Algorithm::Glassner => Some(PanelKind::WayDown),
            Algorithm::Samet | Algorithm::SametCorner => Some(PanelKind::Tables),
            Algorithm::SametNet => Some(PanelKind::Links),
            Algorithm::Bsp => Some(PanelKind::Halves),
            Algorithm::Dda | Algorithm::DdaOctree => Some(PanelKind::Grid),
        },
        Query::Point { method, .. } => Some(match method {
            PointMethod::Codes => PanelKind::Codes,
            PointMethod::Comparison => PanelKind::MidPlanes,
        }),
        Query::Region { .. } => Some(PanelKind::Region),
        Query::Neighbour { method, .. } => Some(match method {
            NeighbourMethod::Codes => PanelKind::Neighbour,
            NeighbourMethod::Tables => PanelKind::Tables,
        }),
    }
}

/// Whether what follows from the codes is said by no panel but that of codes: the node
/// after one that is left, or the node of a cell, bit by bit.
fn is_by_codes<const D: usize>(query: &Query<D>) -> bool {
    matches!(query, Query::Ray { algorithm: Algorithm::Esvo | Algorithm::DdaOctree, .. })
}

/// Whether an algorithm keeps a stack of nodes.
fn is_top_down(algorithm: Algorithm) -> bool {
    match algorithm {
        Algorithm::Parametric
        | Algorithm::ParametricTable
        | Algorithm::Esvo
        | Algorithm::AllChildren
        | Algorithm::Hero
        | Algorithm::Gargantini
        | Algorithm::Bsp => true,
        Algorithm::Codes
        | Algorithm::Glassner
        | Algorithm::Samet
        | Algorithm::SametCorner
        | Algorithm::SametNet
        | Algorithm::Dda
        | Algorithm::DdaOctree
        | Algorithm::Exhaustive => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::event::Event;

    use octoscope_core::query::Arithmetic;
    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::trace::record;
    use octoscope_core::traverse::Options;

    use std::mem::discriminant;

    #[test]
    fn a_lecture_shows_bits_where_its_steps_read_them_more_often_than_they_do_anything_else() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let mut n_by_bits = 0;
        for algorithm in Algorithm::ALL {
            let options = Options::default();
            let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles };
            let [panel] = Preset::Lecture.panels(&query)[..] else { panic!("{algorithm:?}") };
            let events = record(&tree, &scenario.ray, &query).events;
            let n_like = |event: &Event<2>| {
                let is_alike = |other: &&Event<2>| discriminant(*other) == discriminant(event);
                events.iter().filter(is_alike).count()
            };
            let most = events.iter().max_by_key(|event| n_like(event));
            if matches!(most, Some(Event::Follow { .. })) {
                let has_bits = [PanelKind::Codes, PanelKind::Neighbour, PanelKind::WayDown];
                assert!(has_bits.contains(&panel), "{algorithm:?} shows {panel:?}");
                n_by_bits += 1;
            }
        }
        assert!(n_by_bits > 1, "{n_by_bits}");
    }
}
