//! What undo and redo bring back.

use super::jobs::Task;
use super::{App, Shown};
use crate::history::History;
use eframe::egui::{Context, Memory};

impl App {
    /// Ends the editing of a field where a gesture begins beside it, as a click does: what
    /// was typed is a step of its own.
    pub(super) fn leave_field(&self, context: &Context) {
        let pressed = context.input(|input| {
            let pointer = &input.pointer;
            pointer.any_pressed().then(|| pointer.interact_pos()).flatten()
        });
        let field = context.memory(Memory::focused).filter(|_| context.text_edit_focused());
        let Some((pressed, field)) = pressed.zip(field).filter(|_| self.view.dialog.is_none())
        else {
            return;
        };
        if context.read_response(field).is_some_and(|field| !field.rect.contains(pressed)) {
            context.memory_mut(|memory| memory.surrender_focus(field));
        }
    }

    /// Remembers the state for undo once no gesture is going on and no field is edited.
    pub(super) fn settle(&mut self, context: &Context) {
        let edited = context.memory(Memory::focused).filter(|_| context.text_edit_focused());
        let before = std::mem::replace(&mut self.edited, edited);
        let is_left = before.is_some() && before != edited;
        let is_quiet = edited.is_none() && !context.input(|input| input.pointer.any_down());
        if self.job.is_none() && (is_left || is_quiet) {
            self.settle_now();
        }
    }

    pub(super) fn settle_now(&mut self) {
        let is_same = self.document.is_same_state(&self.settled.document)
            && self.settled.show == *self.show_of_document();
        if is_same {
            // Stepping is not undone, but where it led to is part of the state.
            self.settled.step = self.view.playback.step;
        } else {
            let shown = self.shown();
            self.history.record(std::mem::replace(&mut self.settled, shown));
        }
    }

    pub(super) fn shown(&self) -> Shown {
        Shown {
            document: self.document.clone(),
            step: self.view.playback.step,
            show: *self.show_of_document(),
        }
    }

    /// Undoes or redoes. The playhead goes back to where it was in that state.
    pub(super) fn travel(
        &mut self,
        direction: impl FnOnce(&mut History<Shown>, Shown) -> Option<Shown>,
    ) {
        // What is being changed right now is a state of its own, and a tree that is
        // being built for it, or a question sought, belongs to no other document.
        self.settle_now();
        self.job.take_if(|(_, task)| matches!(task, Task::Rebuild | Task::Aim));
        let present = self.shown();
        if let Some(shown) = direction(&mut self.history, present) {
            if !shown.document.is_same_place(&self.document) {
                self.view.forget_cameras();
            }
            self.judging = None;
            let mut document = shown.document;
            document.keep_file(&self.document);
            self.document = document;
            *self.show_of_document_mut() = shown.show;
            self.tracing = None;
            self.go_to(shown.step);
            self.settled = self.shown();
        }
    }
}
