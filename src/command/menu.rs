//! The menus of the window.

/// Menu of the menu bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Menu {
    /// Files.
    File,
    /// Undo and redo.
    Edit,
    /// Presets, themes, sizes.
    View,
    /// All panels; inside the menu before it.
    Panels,
    /// What the picture shows; inside the same menu.
    Show,
    /// The ray.
    Ray,
    /// Degenerate rays, inside the menu of the ray.
    Gallery,
    /// The playhead.
    Step,
    /// Help.
    Help,
}

impl Menu {
    /// The menus of the menu bar from left to right.
    pub const ALL: [Self; 6] =
        [Self::File, Self::Edit, Self::View, Self::Ray, Self::Step, Self::Help];

    /// Key of the menu's title in the language files.
    pub fn id(self) -> &'static str {
        match self {
            Self::File => "menu-file",
            Self::Edit => "menu-edit",
            Self::View => "menu-view",
            Self::Panels => "menu-panels",
            Self::Show => "menu-show",
            Self::Ray => "menu-ray",
            Self::Gallery => "menu-gallery",
            Self::Step => "menu-step",
            Self::Help => "menu-help",
        }
    }

    /// The menus that open at the head of this one.
    pub fn inner(self) -> &'static [Self] {
        match self {
            Self::View => &[Self::Panels, Self::Show],
            Self::Ray => &[Self::Gallery],
            Self::File
            | Self::Edit
            | Self::Panels
            | Self::Show
            | Self::Gallery
            | Self::Step
            | Self::Help => &[],
        }
    }
}
