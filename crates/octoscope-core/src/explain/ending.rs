//! Tells in a sentence what is found, and how an algorithm ends.

use super::teller::Teller;
use crate::event::End;
use crate::tree::NodeId;

impl<const D: usize> Teller<'_, D> {
    /// How the algorithm ends.
    pub(super) fn end(&self, end: End) -> String {
        let words = self.words;
        match end {
            End::Missed => words.texts.get("end-missed"),
            End::LeftRoot => {
                let n = self.before.leaves.len() as u64;
                // A rule as printed may end without the ray having been in the root.
                let key =
                    if self.trace.query.is_misprinted() { "end-printed" } else { "end-left-root" };
                words.texts.format(key, &[("n", n.into())])
            }
            End::FirstFull => words.texts.get("end-first-full"),
            End::SegmentEnd => {
                let n = self.before.leaves.len() as u64;
                words.texts.format("end-segment", &[("n", n.into())])
            }
            End::Looped => words.texts.get("end-looped"),
            End::Cut => {
                let n = self.before.step as u64;
                words.texts.format("end-cut", &[("n", n.into())])
            }
            End::Found => {
                // A search that ends so has found a node before.
                let node = self.before.found.unwrap_or(words.tree.root().id);
                self.found("end-found", node)
            }
            End::Outside => match self.before.target.and_then(|target| target.outside) {
                Some(axes) => words.say("end-outside-axes", &[("axes", words.axes(axes))]),
                None => words.texts.get("end-outside"),
            },
        }
    }

    /// The sentence of `key` about a node that is found.
    pub(super) fn found(&self, key: &str, node: NodeId) -> String {
        let is_leaf = self.words.tree.node(node).is_leaf();
        let key = format!("{key}-{}", if is_leaf { "leaf" } else { "node" });
        self.words.say(&key, &[("node", self.words.node(node))])
    }
}
