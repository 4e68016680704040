//! Which tables of neighbours the steps of a way have used.

use octoscope_core::event::{Event, Lookup};
use octoscope_core::tree::{Child, NodeId};

/// One of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NeighbourTable {
    Adjacent,
    Common,
    Reflect,
}

impl NeighbourTable {
    pub(super) const ALL: [Self; 3] = [Self::Adjacent, Self::Common, Self::Reflect];

    /// Its name in the literature, which has no translation.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Adjacent => "ADJ",
            Self::Common => "COMMON",
            Self::Reflect => "REFLECT",
        }
    }

    /// Key of the rule that all its entries follow.
    pub(super) fn why(self) -> &'static str {
        match self {
            Self::Adjacent => "tables-adjacent-why",
            Self::Common => "tables-common-why",
            Self::Reflect => "tables-reflect-why",
        }
    }
}

/// What a step has reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A parent.
    Up,
    /// The mirrored child.
    Mirrored,
    /// A child on the side that faces where the way came from.
    Facing,
}

impl Kind {
    /// The tables in which is looked up how it is reached.
    fn tables(self) -> &'static [NeighbourTable] {
        match self {
            Self::Up => &[NeighbourTable::Adjacent, NeighbourTable::Common],
            Self::Mirrored => &[NeighbourTable::Reflect],
            // Its bits are opposite to the signs of the direction.
            Self::Facing => &[],
        }
    }
}

/// The entries that tell of a step, whether it has looked them up or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Used<const D: usize> {
    pub(super) direction: [i8; D],
    pub(super) child: Child<D>,
    pub(super) kind: Kind,
    lookup: Lookup,
}

impl<const D: usize> Used<D> {
    /// The tables that the step has looked into.
    pub(super) fn tables(&self) -> &'static [NeighbourTable] {
        match self.lookup {
            Lookup::Tables => self.kind.tables(),
            Lookup::Bits => &[],
        }
    }
}

/// A step of the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step<const D: usize> {
    /// The node that was reached.
    pub(super) node: NodeId,
    pub(super) used: Used<D>,
}

/// Steps of the last way to a neighbour.
pub(super) struct Way<const D: usize> {
    pub(super) up: Vec<Step<D>>,
    pub(super) down: Vec<Step<D>>,
    /// Whether a leaf was reached or left since then: it is told, but quietly.
    pub(super) is_over: bool,
}

impl<const D: usize> Way<D> {
    pub(super) fn of(past: &[Event<D>]) -> Self {
        let starts = |event: &Event<D>| matches!(event, Event::Leaf { .. } | Event::Begin { .. });
        let goes_up = |event: &Event<D>| matches!(event, Event::Parent { .. });
        let Some(last) = past.iter().rposition(goes_up) else {
            return Self { up: Vec::new(), down: Vec::new(), is_over: false };
        };
        let start = past[..last].iter().rposition(starts).unwrap_or(0);
        let length = past[last..].iter().position(starts);
        let end = length.map_or(past.len(), |length| last + length);
        let mut way = Self { up: Vec::new(), down: Vec::new(), is_over: length.is_some() };
        for event in &past[start..end] {
            if let &Event::Facing { child, node } = event
                && let Some(Step { used, .. }) = way.up.first()
            {
                // It faces where the way came from.
                let direction = used.direction.map(|sign| -sign);
                way.down.push(Step {
                    node,
                    used: Used { direction, child, kind: Kind::Facing, ..*used },
                });
            }
            if let &Event::Parent { node, child, direction, lookup, .. } = event {
                way.up.push(Step { node, used: Used { direction, child, kind: Kind::Up, lookup } });
            }
            if let &Event::Mirror { child, node, .. } = event {
                // The last parent's child is mirrored first.
                let parent = way.up.len().checked_sub(way.down.len() + 1);
                if let Some(Step { used, .. }) = parent.and_then(|index| way.up.get(index)) {
                    way.down
                        .push(Step { node, used: Used { child, kind: Kind::Mirrored, ..*used } });
                }
            }
        }
        way
    }

    pub(super) fn last(&self) -> Option<Used<D>> {
        self.down.last().or(self.up.last()).map(|step| step.used)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::locate::adjacent;

    #[test]
    fn children_are_mirrored_in_the_opposite_order_of_their_parents() {
        let parent = |child: u8, direction: [i8; 2]| Event::<2>::Parent {
            node: NodeId::ROOT,
            child: Child(child),
            direction,
            common: [0; 2],
            lookup: Lookup::Tables,
        };
        let mirror = |child: u8| Event::<2>::Mirror {
            child: Child(child),
            mirrored: Child(0),
            node: NodeId::ROOT,
        };
        let way = Way::of(&[parent(3, [1, 1]), parent(2, [1, 0]), mirror(2), mirror(3)]);
        let told: Vec<_> =
            way.down.iter().map(|step| (step.used.child.0, step.used.direction)).collect();
        assert_eq!(told, [(2, [1, 0]), (3, [1, 1])]);
        assert_eq!(way.last().map(|used| used.kind), Some(Kind::Mirrored));
    }

    fn up(child: u8, direction: [i8; 2]) -> Event<2> {
        let (node, common, lookup) = (NodeId::ROOT, [0; 2], Lookup::Tables);
        Event::Parent { node, child: Child(child), direction, common, lookup }
    }

    #[test]
    fn a_child_that_faces_the_way_lies_on_its_side_and_is_looked_up_nowhere() {
        let facing = Event::<2>::Facing { child: Child(0), node: NodeId::ROOT };
        let used = Way::of(&[up(1, [1, 0]), facing]).last().unwrap();
        assert_eq!((used.child, used.direction), (Child(0), [-1, 0]));
        assert_eq!(used.tables(), []);
        assert!(adjacent(used.direction, used.child));
    }

    #[test]
    fn the_last_look_up_stays_in_sight_when_a_leaf_is_reached() {
        let leaf = Event::<2>::Leaf { node: NodeId::ROOT, enter: 0.0, exit: 1.0, full: false };
        let check = |past: &[Event<2>], used: Option<u8>, is_over: bool| {
            let way = Way::of(past);
            assert_eq!(way.last().map(|used| used.child.0), used);
            assert_eq!(way.is_over, is_over);
        };
        check(&[leaf], None, false);
        check(&[leaf, up(3, [1, 0])], Some(3), false);
        check(&[leaf, up(3, [1, 0]), leaf], Some(3), true);
        check(&[leaf, up(3, [1, 0]), leaf, up(1, [1, 0])], Some(1), false);
    }
}
