//! What the view shows in a frame, and from where.

use super::run::run_marks;
use super::tree_layers::{self, Appearance};
use crate::document::Document;
use crate::widgets::PageInWindow;
use octoscope_core::trace::Moment;
use octoscope_core::tree::NodeId;
use octoscope_figure::{Camera, Cut, Mark, Role, axes, axis_names, cells, content, node_mark};

/// More leaves, or parts of the content, than this are not painted one by one.
const MOST_PAINTED: usize = 20_000;

/// A document at a moment, as it is seen.
#[derive(Clone, Copy)]
pub(super) struct Scene<'a, const D: usize> {
    /// The tree, what is asked of it, and its content.
    pub document: &'a Document<D>,
    /// State of the algorithm.
    pub moment: &'a Moment<D>,
    /// What is shown, and in which colours.
    pub appearance: Appearance<'a>,
    /// From where it is seen.
    pub camera: &'a Camera<D>,
    /// Where in the window.
    pub frame: PageInWindow,
}

impl<const D: usize> Scene<'_, D> {
    /// Marks of the run and of what lies around it, but for the cells of the tree.
    pub fn marks(&self, has_layers: bool) -> Vec<Mark<D>> {
        let (document, show) = (self.document, self.appearance.show);
        let mut marks = axes(document.tree.domain(), show, self.camera);
        marks.extend(axis_names(document.tree.domain(), self.camera, self.frame.page));
        marks.extend(self.cut().and_then(|cut| cut.outline(document.tree.domain())));
        let is_painted = document.content.len() <= MOST_PAINTED
            && (!has_layers || !tree_layers::is_cloud(&document.content));
        if D == 2 && show.content && is_painted {
            marks.extend(content(&document.content, None));
        }
        marks.extend(run_marks(document, self.moment, show));
        let expected = |&node: &NodeId| node_mark(&document.tree, node, Role::Expected);
        marks.extend(document.right_nodes().iter().map(expected));
        marks
    }

    /// The cells of the tree, where nothing else draws them and they are not too many.
    pub fn cells(&self) -> Vec<Mark<D>> {
        let (tree, show) = (&self.document.tree, self.appearance.show);
        if tree.n_leaves() > MOST_PAINTED {
            return Vec::new();
        }
        cells(tree, show, self.cut().as_ref())
    }

    /// Where the tree is cut open.
    pub fn cut(&self) -> Option<Cut> {
        let slice = self.appearance.show.slice?;
        slice.cut(self.document.tree.domain(), self.camera)
    }
}
