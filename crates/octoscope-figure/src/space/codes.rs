//! Codes of cells: in the colours of the axes, on ground of their own, and off the ray.

use super::labels::rectangle;
use super::{Canvas, above_space};
use crate::figure::text_reach;
use crate::{Anchor, Form, Mark, Part};
use octoscope_core::explain::{RichText, Span};
use octoscope_core::geometry::Aabb;

/// Between a code and the rim of its ground.
const PADDING: [f64; 2] = [2.0, 1.0];
/// Between that and the sides of its cell.
const INSET: f64 = 1.0;
/// What parts the codes of two axes.
pub(crate) const BETWEEN: &str = ", ";

impl<const D: usize> Canvas<'_, D> {
    /// Writes the code of a cell into it, if there is room for it off the ray; that of
    /// the current node may lie on it.
    pub(super) fn write_code(&mut self, mark: &Mark<D>, bounds: &Aabb<D>, text: &str) {
        let [wide, high] = text_reach(mark.role, text);
        let reach = [wide + PADDING[0], high + PADDING[1]];
        let extent = self.extent(bounds);
        let off: [f64; 2] = std::array::from_fn(|e| 0.5 * extent[e] - reach[e] - INSET);
        let centre = self.camera.project(self.page, bounds.centre());
        let Some(centre) = centre.filter(|_| off.iter().all(|off| *off >= 0.0)) else { return };
        // The extent of a box in space is larger than the box.
        let share = if D == 2 { 1.0 } else { 0.4 };
        // First where most is left of the cell for its order number.
        let places = [1.0, -1.0, 0.0].into_iter().flat_map(|down| {
            [0.0, -1.0, 1.0].map(|across| {
                [centre.at[0] + share * across * off[0], centre.at[1] + share * down * off[1]]
            })
        });
        let places: Vec<[f64; 2]> = places.collect();
        let is_chosen = mark.node.is_some_and(|node| self.chosen.contains(&node));
        let clear = places.iter().copied().filter(|at| !self.strikes(*at, reach));
        let clear: Vec<_> = clear.collect();
        let mut at = self.clearest(clear, reach);
        if at.is_none() && is_chosen {
            at = self.clearest(places, reach);
        }
        let Some(at) = at else { return };
        self.push_at(above_space(mark.role), mark, Part::Whole, rectangle(at, reach));
        let text = by_axis(text);
        let form = Form::Text { at, anchor: Anchor::Middle, text };
        self.push_at(above_space(mark.role), mark, Part::Whole, form);
    }
}

/// The codes of the axes, each in the colour of its axis.
fn by_axis(text: &str) -> RichText {
    let codes = text.split(BETWEEN).enumerate().flat_map(|(axis, code)| {
        let between = (axis > 0).then(|| Span { text: BETWEEN.to_owned(), ..Span::default() });
        let code = Span { text: code.to_owned(), axis: Some(axis), ..Span::default() };
        between.into_iter().chain([code])
    });
    RichText(codes.collect())
}
