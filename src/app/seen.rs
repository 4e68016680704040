//! How what is open is seen: what the picture shows, where from, and at which step.

use super::{App, shown_in};
use crate::complaint;
use crate::document::{AnyDocument, Document};
use crate::eye::Eye;
use crate::kept_view::{KeptError, KeptView, kept_eye, kept_show};
use crate::view::View;
use crate::with_document;
use octoscope_core::scenario::StepAt;
use octoscope_figure::{Page, Show};

impl App {
    /// What the picture shows of what is open.
    pub(super) fn show_of_document(&self) -> &Show {
        with_document!(&self.document, d => shown_in(&self.view, d))
    }

    /// The same, to be changed.
    pub(super) fn show_of_document_mut(&mut self) -> &mut Show {
        match self.document {
            AnyDocument::Plane(_) => self.view.show_mut::<2>(),
            AnyDocument::Space(_) => self.view.show_mut::<3>(),
        }
    }

    /// Shows what the scenario wants to be shown; without a wish what was shown before, but
    /// whole.
    fn show_as_kept(&mut self) {
        match with_document!(&self.document, d => kept_show(&d.opened().view)) {
            Ok(Some(show)) => *self.show_of_document_mut() = show,
            Ok(None) => {
                let show = self.show_of_document_mut();
                *show = show.whole();
            }
            Err(error) => self.notice.say(complaint::told(&self.look.texts, &error.into())),
        }
    }

    /// Looks at the scenario from where it wants, or from the usual side.
    fn stand_as_kept(&mut self) {
        fn kept<const D: usize>(document: &Document<D>) -> Result<Option<Eye>, KeptError> {
            kept_eye::<D>(&document.opened().view)
        }
        self.view.forget_cameras();
        match with_document!(&self.document, d => kept(d)) {
            Ok(Some(eye)) => {
                if self.dimension() == 3 {
                    self.view.lens = eye.lens;
                }
                self.view.eye = Some(eye);
            }
            Ok(None) => {}
            Err(error) => self.notice.say(complaint::told(&self.look.texts, &error.into())),
        }
    }

    /// How the scenario is seen, as it is kept with it.
    pub(super) fn kept_view(&self) -> KeptView {
        fn eye<const D: usize>(document: &Document<D>, view: &View) -> Option<Eye> {
            let (camera, room) = (view.camera::<D>()?, view.space?);
            let page = Page { width: room.width().into(), height: room.height().into() };
            let framed = Eye::of(&document.framed(page), document, page);
            Some(Eye::of(&camera, document, page)).filter(|eye| *eye != framed)
        }
        let eye = self
            .view
            .eye
            .clone()
            .or_else(|| with_document!(&self.document, d => eye(d, &self.view)));
        KeptView { show: *self.show_of_document(), eye }
    }

    /// Moves the playhead to where the scenario wants it.
    pub(super) fn go_to_start(&mut self) {
        self.show_as_kept();
        self.stand_as_kept();
        let length = self.document.n_events();
        let step: StepAt = with_document!(&self.document, document => document.opened().step);
        self.view.playback.playing = false;
        self.view.playback.go_to(step.position(length), length);
    }
}
