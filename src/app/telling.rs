//! What is said of errors, and of what is open.

use super::App;
use crate::complaint;
use crate::look::Look;
use crate::view::Dialog;
use octoscope_core::explain::algorithm_name;
use octoscope_core::locate::NeighbourMethod;
use octoscope_core::paper::erratum_of;
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::traverse::Variant;
use std::path::Path;

impl App {
    /// Shows an error, below one that is still to be read.
    pub(super) fn tell_error(&mut self, error: String) {
        match &mut self.view.dialog {
            Some(Dialog::Error(before)) => {
                before.push_str("\n\n");
                before.push_str(&error);
            }
            other => *other = Some(Dialog::Error(error)),
        }
    }

    /// Shows what went wrong.
    pub(super) fn complain(&mut self, error: &anyhow::Error) {
        self.tell_error(complaint::told(&self.look.texts, error));
    }

    /// Takes the notice away once what it was about has changed.
    pub(super) fn outdate_notice(&mut self) {
        if self.notice.is_empty() {
            self.noticed = None;
            return;
        }
        let number = self.notice.number();
        match &self.noticed {
            Some((noticed, about)) if *noticed == number => {
                if !about.is_same_state(&self.document) {
                    self.notice.clear();
                }
            }
            Some(_) | None => self.noticed = Some((number, self.document.clone())),
        }
    }
}

/// The algorithm that is at work.
pub(super) fn method_told<const D: usize>(query: &Query<D>, look: &Look) -> String {
    match *query {
        Query::Ray { algorithm, .. } => algorithm_name(algorithm, look.texts.language()),
        Query::Point { method, .. } => {
            let method = match method {
                PointMethod::Codes => "point-codes",
                PointMethod::Comparison => "point-comparison",
            };
            format!("{} {}", look.text("query-point"), look.text(method))
        }
        Query::Region { .. } => look.text("query-region"),
        Query::Neighbour { method, .. } => {
            let method = match method {
                NeighbourMethod::Codes => "neighbour-codes",
                NeighbourMethod::Tables => "neighbour-tables",
            };
            format!("{} {}", look.text("query-neighbour"), look.text(method))
        }
    }
}

/// Which algorithm is at work, which of its rules in another form than the right one, and
/// what goes back to the algorithm that was at work before, if that is another one.
pub(super) fn rules_told<const D: usize>(query: &Query<D>, before: &str, look: &Look) -> String {
    let rule = |variant: Variant| match erratum_of(variant) {
        Some(_) => look.texts.format("status-rule-printed", &[("rule", variant.id().into())]),
        None => look.text(&format!("variant-{}", variant.id())),
    };
    let rules: Vec<String> = query.variants_at_work().iter().map(rule).collect();
    let method = method_told(query, look);
    let is_same = method == before;
    let arguments = [("algorithm", method.into()), ("rules", rules.join(", ").into())];
    let told = look.texts.format("status-rules", &arguments);
    if is_same {
        return told;
    }
    let back = look.texts.format("status-back", &[("before", before.to_owned().into())]);
    format!("{told}. {back}")
}

/// The last part of a path, for a message.
pub(super) fn file_name(path: &Path) -> String {
    path.file_name()
        .map_or_else(|| path.display().to_string(), |n| n.to_string_lossy().into_owned())
}
