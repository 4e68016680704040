//! The columns that tables of bits at one moment share.

use super::{bits, codes, neighbour, region};
use octoscope_core::text::Texts;
use octoscope_core::trace::Moment;
use octoscope_core::tree::Tree;

/// Room for the names and the notes of all tables of bits at a moment, so that bit n of
/// one stands below bit n of another, whichever of them are shown.
pub(super) fn columns<const D: usize>(
    texts: &Texts,
    tree: &Tree<D>,
    moment: &Moment<D>,
) -> bits::Beside {
    let codes = codes::bits_of(tree, moment);
    let computed = neighbour::bits_of(texts, tree, moment);
    let region = region::bits_of(tree, moment);
    bits::room_of([&codes].into_iter().chain(&computed).chain(&region))
}
