//! Several moments on one page, each with its sentence.

use super::legend::legend;
use super::sheet::{Sheet, line_height};
use super::words::{joined, strong};
use crate::{Extent, Figure, Role, metrics};
use octoscope_core::explain::RichText;
use octoscope_core::text::Texts;

/// One moment of a storyboard.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Number of events that have happened.
    pub step: usize,
    /// The picture.
    pub picture: Figure,
    /// What is written below it.
    pub caption: RichText,
}

/// How panels are laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Panels side by side.
    pub n_columns: usize,
    /// Width of each.
    pub column: f64,
}

/// Room between columns and between rows.
const GAP: [f64; 2] = [14.0, 16.0];

impl Layout {
    /// Layout of so many panels on a page of this width.
    pub fn of(n_panels: usize, width: f64) -> Self {
        /// Narrower ones have no room for a picture and its sentence.
        const NARROWEST: f64 = 140.0;
        let most = ((width + GAP[0]) / (NARROWEST + GAP[0])).floor().max(1.0) as usize;
        let n_columns = match n_panels {
            0 | 1 => 1,
            2 | 4 => most.min(2),
            _ => most.min(3),
        };
        let n = n_columns as f64;
        Self { n_columns, column: (width - (n - 1.0) * GAP[0]) / n }
    }
}

/// The panels from left to right and from top to bottom, all in the same scale, and
/// a legend of what is seen in them; on a page of this width.
pub fn storyboard(panels: Vec<Panel>, layout: Layout, texts: &Texts, width: f64) -> Figure {
    let legend = legend(panels.iter().map(|panel| &panel.picture), texts, width);
    let panels = in_one_scale(panels);
    let mut sheet = Sheet::default();
    let mut top = 0.0;
    let line = line_height(Role::Note);
    for row in panels.chunks(layout.n_columns) {
        let height = row.iter().map(|panel| panel.picture.page.height).fold(0.0, f64::max);
        let mut bottom = top;
        for (n, panel) in row.iter().enumerate() {
            let left = n as f64 * (layout.column + GAP[0]);
            let inset = 0.5 * (layout.column - panel.picture.page.width).max(0.0);
            sheet.place(panel.picture.drawn.iter().cloned(), [left + inset, top]);
            let number = strong(format!("{}  ", panel.step));
            let indent = metrics::width(Role::Note, &number);
            let at = [left, top + height + 5.0];
            let whole = joined([number, panel.caption.clone()]);
            debug_assert!(indent < layout.column);
            let said = sheet.paragraph(Role::Note, at, layout.column, &whole);
            bottom = f64::max(bottom, at[1] + said.max(line));
        }
        top = bottom + GAP[1];
    }
    let height = legend.page.height;
    sheet.place(legend.drawn, [0.0, top]);
    sheet.figure([width, top + height])
}

/// The pictures with the same part of their page left, as much as any of them uses.
fn in_one_scale(panels: Vec<Panel>) -> Vec<Panel> {
    let Some(extent) = common_extent(panels.iter().map(|panel| &panel.picture)) else {
        return panels;
    };
    let on = |panel: Panel| Panel { picture: panel.picture.on(extent), ..panel };
    panels.into_iter().map(on).collect()
}

/// What any of these figures covers.
pub fn common_extent<'a>(figures: impl IntoIterator<Item = &'a Figure>) -> Option<Extent> {
    figures.into_iter().filter_map(Figure::extent).reduce(Extent::and)
}
