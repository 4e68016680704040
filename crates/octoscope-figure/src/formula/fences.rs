//! Brackets around parts of formulas.

use super::{Piece, SetFormula, plain};
use octoscope_core::explain::Fence;

impl SetFormula {
    /// Between brackets that are as high as what is between them.
    pub(super) fn fenced(fence: Fence, body: Self, em: f64, step: u8) -> Self {
        let is_low = body.above + body.below < 1.25 * em;
        if fence == Fence::Round && is_low {
            let mut set = Self::letters(plain("("), step);
            set.width += 0.03 * em;
            set.append(body, 0.0);
            set.width += 0.03 * em;
            set.append(Self::letters(plain(")"), step), 0.0);
            return set;
        }
        let pad = 0.06 * em;
        let (top, bottom) = (-body.above - 0.02 * em, body.below + 0.02 * em);
        let (side, lead) = (0.3 * em, 0.08 * em);
        let width = body.width + 2.0 * (side + pad);
        let foot = 0.17 * em;
        let turned = |points: &[[f64; 2]]| points.iter().map(|[x, y]| [width - x, *y]).collect();
        let left: Vec<[f64; 2]> = match fence {
            Fence::Round => {
                let middle = 0.5 * (top + bottom);
                let half = 0.5 * (bottom - top);
                let bend = 0.2 * em;
                (-6..=6)
                    .map(|n| {
                        let share = f64::from(n) / 6.0;
                        [lead + bend * share * share, middle + half * share]
                    })
                    .collect()
            }
            Fence::Floor => vec![[lead, top], [lead, bottom], [lead + foot, bottom]],
            Fence::Ceiling => vec![[lead + foot, top], [lead, top], [lead, bottom]],
            Fence::Absolute => vec![[lead, top], [lead, bottom]],
        };
        let pieces = vec![Piece::Line(turned(&left)), Piece::Line(left)];
        let mut set = Self { width, above: -top, below: bottom, pieces };
        set.place(body, [side + pad, 0.0]);
        set
    }
}
