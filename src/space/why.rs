//! Why the cell under the pointer is not visited, in words.

use octoscope_core::explain::{Naming, RichText, fate_sentence};
use octoscope_core::text::Language;
use octoscope_core::trace::{Fate, deciding_fate};
use octoscope_core::tree::NodeId;
use octoscope_figure::DiagramOf;

/// What rules out a node, or a node that it lies in; none where nothing does.
pub fn why<const D: usize>(
    of: &DiagramOf<D>,
    node: NodeId,
    language: Language,
) -> Option<RichText> {
    let DiagramOf { tree, ray, query, moment, .. } = *of;
    let (decided, fate) = deciding_fate(tree, ray, query, moment, node)?;
    match fate {
        Fate::RuledOut(_) | Fate::Strayed(_) | Fate::PassedBy(_) => {}
        Fate::Visited(_) | Fate::Entered(_) | Fate::Ahead(_) => return None,
    }
    let parent = tree.parent(decided).filter(|_| moment.current.is_some() && moment.end.is_none());
    let is_in_question = parent.is_some() && parent == moment.at_work(tree);
    let naming = if is_in_question { Naming::ByIndex } else { Naming::ByCode };
    Some(fate_sentence(tree, decided, fate, naming, language))
}
