//! The formulas of a figure.

use super::{SetFormula, ShownNumber};
use crate::{Drawn, Figure, Form};
use std::borrow::Cow;

impl Figure {
    /// The same with letters and lines in the place of formulas.
    pub fn spelled_out(&self) -> Cow<'_, Self> {
        let is_formula = |drawn: &Drawn| matches!(drawn.form, Form::Formula { .. });
        if !self.drawn.iter().any(is_formula) {
            return Cow::Borrowed(self);
        }
        let spell = |drawn: &Drawn| match &drawn.form {
            Form::Formula { at, of, formula } => SetFormula::of(formula, *of).drawn(*at),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Text { .. } => {
                vec![drawn.clone()]
            }
        };
        let drawn = self.drawn.iter().flat_map(spell).collect();
        Cow::Owned(Self { page: self.page, drawn })
    }

    /// The numbers in its formulas.
    pub fn numbers(&self) -> Vec<ShownNumber> {
        let numbers = self.drawn.iter().flat_map(|drawn| match &drawn.form {
            Form::Formula { at, of, formula } => SetFormula::of(formula, *of).numbers(*at),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Text { .. } => {
                Vec::new()
            }
        });
        numbers.collect()
    }
}
