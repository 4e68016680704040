//! Changes of what the picture shows, by menu, key and name.

use octoscope_core::tree::Domain;
use octoscope_figure::{Levels, Rest, Show, Slice};

/// A change of what the picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShowChange {
    /// Show something, or no longer.
    Part(ShownPart),
    /// Cells off the path plain, faint, hidden in turn.
    NextRest,
    /// Fewer levels of cells, from the smallest on.
    FewerSmall,
    /// One more level of small cells.
    MoreSmall,
    /// Fewer levels of cells, from the largest on.
    FewerLarge,
    /// One more level of large cells.
    MoreLarge,
    /// All levels again.
    AllLevels,
    /// No slice, across x, y, z in turn.
    NextSlice,
    /// The slice towards the lower end of its axis.
    SliceDown,
    /// The slice towards the upper end.
    SliceUp,
    /// Move the children of the current node apart, or back together.
    Apart,
}

/// What is shown or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShownPart {
    /// Numbers of the visited leaves.
    OrderNumbers,
    /// The contents of the tree.
    Content,
    /// Leaves without contents.
    EmptyLeaves,
    /// Inner nodes off the path.
    InnerNodes,
    /// Nodes above the current one.
    Ancestors,
    /// Children of the current one.
    Children,
    /// The mirrored ray and its path.
    MirroredRay,
    /// Which sides a cell owns.
    HalfOpenSides,
    /// Codes on cells.
    Codes,
}

impl ShownPart {
    /// All parts.
    pub const ALL: [Self; 9] = [
        Self::OrderNumbers,
        Self::Content,
        Self::EmptyLeaves,
        Self::InnerNodes,
        Self::MirroredRay,
        Self::Ancestors,
        Self::HalfOpenSides,
        Self::Children,
        Self::Codes,
    ];

    /// Key of its name in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::OrderNumbers => "show-order-numbers",
            Self::Content => "show-content",
            Self::EmptyLeaves => "show-empty-leaves",
            Self::InnerNodes => "show-inner-nodes",
            Self::Ancestors => "show-ancestors",
            Self::Children => "show-children",
            Self::MirroredRay => "show-mirrored-ray",
            Self::HalfOpenSides => "show-half-open-sides",
            Self::Codes => "show-codes",
        }
    }

    /// Its name in arguments and files.
    pub fn name(self) -> &'static str {
        self.id().trim_start_matches("show-")
    }

    /// Whether it is shown.
    pub fn of(self, show: &mut Show) -> &mut bool {
        match self {
            Self::OrderNumbers => &mut show.order_numbers,
            Self::Content => &mut show.content,
            Self::EmptyLeaves => &mut show.empty_leaves,
            Self::InnerNodes => &mut show.inner_nodes,
            Self::Ancestors => &mut show.ancestors,
            Self::Children => &mut show.children,
            Self::MirroredRay => &mut show.mirrored_ray,
            Self::HalfOpenSides => &mut show.half_open_sides,
            Self::Codes => &mut show.codes,
        }
    }
}

/// How far a key moves a slice, as a share of the root's side.
const SLICE_STEP: f64 = 1.0 / 64.0;

impl ShowChange {
    /// Whether it means something for a tree of this dimension.
    pub fn is_possible(self, show: &Show, dimension: usize) -> bool {
        match self {
            Self::NextSlice => dimension == 3,
            Self::SliceDown | Self::SliceUp => dimension == 3 && show.slice.is_some(),
            Self::Part(_)
            | Self::NextRest
            | Self::FewerSmall
            | Self::MoreSmall
            | Self::FewerLarge
            | Self::MoreLarge
            | Self::AllLevels
            | Self::Apart => true,
        }
    }

    /// Whether it is on, if it is switched on and off.
    pub fn is_on(self, show: &Show) -> Option<bool> {
        match self {
            Self::Part(part) => Some(*part.of(&mut show.clone())),
            Self::Apart => Some(show.explosion > 0.0),
            Self::NextRest
            | Self::FewerSmall
            | Self::MoreSmall
            | Self::FewerLarge
            | Self::MoreLarge
            | Self::AllLevels
            | Self::NextSlice
            | Self::SliceDown
            | Self::SliceUp => None,
        }
    }

    /// Makes the change for a tree over `domain`.
    pub fn make<const D: usize>(self, show: &mut Show, domain: &Domain<D>) {
        match self {
            Self::Part(part) => {
                let on = part.of(show);
                *on = !*on;
            }
            Self::NextRest => {
                let index = Rest::ALL.iter().position(|rest| *rest == show.rest).unwrap_or(0);
                show.rest = Rest::ALL[(index + 1) % Rest::ALL.len()];
            }
            Self::FewerSmall => change_levels(show, domain.root_level(), [1, 0]),
            Self::MoreSmall => change_levels(show, domain.root_level(), [-1, 0]),
            Self::FewerLarge => change_levels(show, domain.root_level(), [0, -1]),
            Self::MoreLarge => change_levels(show, domain.root_level(), [0, 1]),
            Self::AllLevels => show.levels = Levels::ALL,
            Self::NextSlice => {
                show.slice = match show.slice {
                    None => Some(Slice { axis: 0, ..Slice::MIDDLE }),
                    Some(Slice { axis, at }) => {
                        Some(Slice { axis: axis + 1, at }).filter(|s| usize::from(s.axis) < D)
                    }
                };
            }
            Self::SliceDown => move_slice(show, -SLICE_STEP),
            Self::SliceUp => move_slice(show, SLICE_STEP),
            Self::Apart => {
                show.explosion = if show.explosion > 0.0 { 0.0 } else { Show::APART };
            }
        }
    }
}

/// Takes levels away at an end, or adds some; one at least stays.
fn change_levels(show: &mut Show, root_level: u8, by: [i8; 2]) {
    let Levels { least, most } = show.levels.up_to(root_level);
    let least = least.saturating_add_signed(by[0]);
    let most = most.saturating_add_signed(by[1]).min(root_level);
    set_levels(show, root_level, [least.min(most), most.max(least.min(most))]);
}

/// Sets the levels; where they are all that the tree has, all of every tree.
pub fn set_levels(show: &mut Show, root_level: u8, [least, most]: [u8; 2]) {
    let most = if most >= root_level { u8::MAX } else { most };
    show.levels = Levels { least, most };
}

fn move_slice(show: &mut Show, by: f64) {
    if let Some(slice) = &mut show.slice {
        slice.at = (slice.at + by).clamp(0.0, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_at_least_is_left() {
        let domain = Domain::<3>::unit(3);
        let mut show = Show::default();
        for _ in 0..9 {
            ShowChange::FewerSmall.make(&mut show, &domain);
        }
        assert_eq!(show.levels.up_to(3), Levels { least: 3, most: 3 });
        for _ in 0..9 {
            ShowChange::FewerLarge.make(&mut show, &domain);
            assert!(show.levels.least <= show.levels.most);
        }
        for _ in 0..9 {
            ShowChange::MoreLarge.make(&mut show, &domain);
            ShowChange::MoreSmall.make(&mut show, &domain);
        }
        assert_eq!(show.levels, Levels::ALL);
    }

    #[test]
    fn what_was_stored_is_within_bounds() {
        let read = |text: &str| serde_json::from_str::<Show>(text);
        let slice = Some(Slice { axis: 2, at: 1.0 });
        let stored = r#"{"slice": {"axis": 2, "at": 1.0}, "explosion": 2.0}"#;
        assert_eq!(read(stored).unwrap(), Show { slice, explosion: 2.0, ..Show::default() });
        assert_eq!(read(r#"{"codes": false}"#).unwrap(), Show::default());
        for bad in [
            r#"{"slice": {"axis": 3, "at": 0.5}}"#,
            r#"{"slice": {"axis": 255, "at": 0.5}}"#,
            r#"{"slice": {"axis": 0, "at": -0.5}}"#,
            r#"{"slice": {"axis": 0, "at": 1e300}}"#,
            r#"{"explosion": 1e300}"#,
            r#"{"explosion": -1}"#,
        ] {
            assert!(read(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn slices_go_round_the_axes() {
        let domain = Domain::<3>::unit(3);
        let mut show = Show::default();
        let axes = [0; 4].map(|_| {
            ShowChange::NextSlice.make(&mut show, &domain);
            show.slice.map(|slice| slice.axis)
        });
        assert_eq!(axes, [Some(0), Some(1), Some(2), None]);
        ShowChange::SliceUp.make(&mut show, &domain);
        assert_eq!(show.slice, None);
        assert!(!ShowChange::SliceUp.is_possible(&show, 3));
        assert!(!ShowChange::NextSlice.is_possible(&show, 2));
    }
}
