//! The layers of the tree that is open, made on another thread if it is large.

use super::tree_layers::{self, Appearance};
use crate::document::Document;
use crate::job::{Job, Poll, Title};
use crate::render::{Layer, Speed};
use eframe::egui::Context;
use octoscope_core::progress::{Cancelled, Progress};
use octoscope_figure::{Levels, Rest, Show, Theme};
use std::any::Any;
use std::sync::Arc;

/// Trees of no more nodes than this take a small part of a frame.
const QUICK_NODES: usize = 20_000;

/// What the layers of a tree depend on.
#[derive(Clone, Debug)]
pub struct TreeKey {
    /// The tree, which nobody changes.
    tree: Arc<dyn Any + Send + Sync>,
    shown: Shown,
}

/// What of a tree is shown, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shown {
    content: bool,
    empty_leaves: bool,
    inner_nodes: bool,
    levels: Levels,
    rest: Rest,
    theme: Theme,
}

impl PartialEq for TreeKey {
    fn eq(&self, other: &Self) -> bool {
        self.is_of_tree(other) && self.shown == other.shown
    }
}

impl TreeKey {
    /// Key of a document's tree.
    pub fn of<const D: usize>(document: &Document<D>, appearance: Appearance<'_>) -> Self {
        let Appearance { show, theme } = appearance;
        let Show { content, empty_leaves, inner_nodes, levels, rest, .. } = *show;
        let shown = Shown { content, empty_leaves, inner_nodes, levels, rest, theme };
        Self { tree: Arc::clone(&document.tree) as Arc<dyn Any + Send + Sync>, shown }
    }

    fn is_of_tree(&self, other: &Self) -> bool {
        std::ptr::addr_eq(Arc::as_ptr(&self.tree), Arc::as_ptr(&other.tree))
    }
}

/// Layers of one tree.
#[derive(Clone, Debug)]
pub struct TreeLayers {
    /// Of which tree, and what of it.
    pub key: TreeKey,
    /// Dimension of the tree.
    dimension: usize,
    /// Everything.
    pub whole: Vec<Layer>,
    /// So much that it can be drawn while it moves.
    pub coarse: Vec<Layer>,
}

/// The layers of the tree that is open, as long as what they show stays the same.
#[derive(Default)]
pub struct Leaves {
    layers: Option<TreeLayers>,
    /// Those that are being made, and of what.
    making: Option<(Job<Result<TreeLayers, Cancelled>>, TreeKey)>,
}

impl Leaves {
    /// The layers of the document's tree. While those of a large one are being made, the
    /// last ones there are of its dimension.
    pub fn of<const D: usize>(
        &mut self,
        context: &Context,
        document: &Document<D>,
        appearance: Appearance<'_>,
        speed: Speed,
    ) -> Option<&TreeLayers> {
        let key = TreeKey::of(document, appearance);
        self.poll();
        let is_known = self.layers.as_ref().is_some_and(|layers| layers.key == key);
        // What is being made of this tree is finished first, so that there is something
        // to be seen however quickly it is changed.
        let is_coming = self.making.as_ref().is_some_and(|(_, making)| making.is_of_tree(&key));
        if is_known {
            self.making = None;
        } else if !is_coming {
            let (tree, content) = (Arc::clone(&document.tree), Arc::clone(&document.content));
            let Appearance { show, theme } = appearance;
            let show = *show;
            let is_quick = tree.n_nodes() <= QUICK_NODES;
            let key_of_job = key.clone();
            let work = move |progress: &Progress| {
                let appearance = Appearance { show: &show, theme };
                let layers = tree_layers::layers(&tree, &content, appearance, speed, progress)?;
                let [whole, coarse] = layers;
                Ok(TreeLayers { key: key_of_job, dimension: D, whole, coarse })
            };
            if is_quick {
                self.making = None;
                self.layers = work(&Progress::default()).ok();
            } else {
                // A job of another tree is cancelled.
                self.making = Some((Job::start(Title::Silent, context, work), key));
                self.poll();
            }
        }
        self.layers.as_ref().filter(|layers| layers.dimension == D)
    }

    fn poll(&mut self) {
        if let Some((job, _)) = &self.making {
            self.conclude(job.poll());
        }
    }

    /// Waits for the layers that are being made.
    pub fn finish(&mut self) {
        if let Some((job, _)) = &self.making {
            self.conclude(job.wait());
        }
    }

    fn conclude(&mut self, poll: Poll<Result<TreeLayers, Cancelled>>) {
        match poll {
            Poll::Running => return,
            Poll::Done(Ok(layers)) => self.layers = Some(layers),
            // Without a tree the picture is still of use.
            Poll::Done(Err(Cancelled)) | Poll::Broken => {
                self.layers = self.making.take().map(|(_, key)| TreeLayers {
                    key,
                    dimension: 0,
                    whole: Vec::new(),
                    coarse: Vec::new(),
                });
            }
        }
        self.making = None;
    }
}
