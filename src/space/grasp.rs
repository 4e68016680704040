//! What the mouse can take hold of.

use crate::document::Document;
use crate::widgets::PageInWindow;
use octoscope_figure::Camera;

/// The picture, and what it is of.
pub(super) struct Grasp<'a, const D: usize> {
    /// Where the picture lies in the window.
    pub frame: PageInWindow,
    /// From where it is seen.
    pub camera: &'a mut Camera<D>,
    /// Whose ray and query it shows.
    pub document: &'a mut Document<D>,
}
