//! Which tables of neighbours the steps of a way have used.

use octoscope_core::event::{Event, Lookup};
use octoscope_core::tree::{Child, NodeId};

/// One of the tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Table {
    Adjacent,
    Common,
    Reflect,
}

impl Table {
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
    /// The tables that tell how it is reached.
    pub(super) fn tables(self, lookup: Lookup) -> &'static [Table] {
        match (self, lookup) {
            (Self::Facing, Lookup::Tables | Lookup::Bits) => &[Table::Adjacent],
            (Self::Up | Self::Mirrored, Lookup::Bits) => &[Table::Common],
            (Self::Up, Lookup::Tables) => &[Table::Adjacent, Table::Common],
            (Self::Mirrored, Lookup::Tables) => &[Table::Reflect],
        }
    }
}

/// Which entries a step has used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Used<const D: usize> {
    pub(super) direction: [i8; D],
    pub(super) child: Child<D>,
    pub(super) kind: Kind,
    pub(super) lookup: Lookup,
}

/// A step of the way: the node that was reached, and the entries used.
pub(super) type Step<const D: usize> = (NodeId, Used<D>);

/// Steps of the last way to a neighbour.
pub(super) struct Way<const D: usize> {
    pub(super) up: Vec<Step<D>>,
    pub(super) down: Vec<Step<D>>,
    /// Whether a leaf was reached since then: it is told, but quietly.
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
                && let Some((_, used)) = way.up.first()
            {
                // It faces where the way came from.
                let direction = used.direction.map(|sign| -sign);
                let lookup = Lookup::Bits;
                let kind = Kind::Facing;
                way.down.push((node, Used { direction, child, kind, lookup }));
            }
            if let &Event::Parent { node, child, direction, lookup, .. } = event {
                way.up.push((node, Used { direction, child, kind: Kind::Up, lookup }));
            }
            if let &Event::Mirror { child, node, .. } = event {
                // The last parent's child is mirrored first.
                let parent = way.up.len().checked_sub(way.down.len() + 1);
                if let Some((_, used)) = parent.and_then(|index| way.up.get(index)) {
                    way.down.push((node, Used { child, kind: Kind::Mirrored, ..*used }));
                }
            }
        }
        way
    }

    pub(super) fn last(&self) -> Option<Used<D>> {
        self.down.last().or(self.up.last()).map(|(_, used)| *used)
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
            way.down.iter().map(|(_, used)| (used.child.0, used.direction)).collect();
        assert_eq!(told, [(2, [1, 0]), (3, [1, 1])]);
        assert_eq!(way.last().map(|used| used.kind), Some(Kind::Mirrored));
    }

    fn up(child: u8, direction: [i8; 2]) -> Event<2> {
        let (node, common, lookup) = (NodeId::ROOT, [0; 2], Lookup::Tables);
        Event::Parent { node, child: Child(child), direction, common, lookup }
    }

    #[test]
    fn a_child_that_faces_the_way_lies_on_the_lit_side() {
        let facing = Event::<2>::Facing { child: Child(0), node: NodeId::ROOT };
        let used = Way::of(&[up(1, [1, 0]), facing]).last().unwrap();
        assert_eq!((used.child, used.direction), (Child(0), [-1, 0]));
        assert_eq!(used.kind.tables(used.lookup), [Table::Adjacent]);
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
