//! What went wrong, in the language of the window.

mod scenario;
mod view;

use crate::export::{MOST_STEPS, StepsError};
use crate::files::{FileError, FileFault};
use crate::open::{AtPath, OpenFault};
use octoscope_core::scenario::ScenarioError;
use octoscope_core::text::Texts;
use octoscope_core::tree::{BuildError, DomainError, MAX_NODES};
use octoscope_import::{ImportError, PictureFault, Place};
use scenario::of_fault;

/// The whole error: the fact first, then what to do, the path last. What only a
/// program says stays in its words.
pub fn told(texts: &Texts, error: &anyhow::Error) -> String {
    if let Some(AtPath { error, path }) = error.downcast_ref() {
        return format!("{}: {}", told(texts, error), path.display());
    }
    let fact = if let Some(FileError { fault, path }) = error.downcast_ref() {
        format!("{}: {}", of_file(texts, fault), path.display())
    } else if let Some(fault) = error.downcast_ref() {
        of_file(texts, fault)
    } else if let Some(error) = error.downcast_ref() {
        of_import(texts, error)
    } else if let Some(error) = error.downcast_ref() {
        of_scenario(texts, error)
    } else if let Some(error) = error.downcast_ref() {
        of_building(texts, error)
    } else if let Some(error) = error.downcast_ref() {
        of_steps(texts, *error)
    } else if let Some(error) = error.downcast_ref() {
        view::of_figure(texts, error)
    } else if let Some(error) = error.downcast_ref() {
        view::of_exercise(texts, *error)
    } else if let Some(error) = error.downcast_ref() {
        view::of_kept(texts, error)
    } else {
        match error.downcast_ref::<OpenFault>() {
            Some(OpenFault::DataFile) | None => return format!("{error:#}"),
            Some(fault) => return of_opening(texts, fault),
        }
    };
    match error.downcast_ref::<OpenFault>() {
        Some(fault) => format!("{}: {fact}", of_opening(texts, fault)),
        None => fact,
    }
}

fn of_file(texts: &Texts, fault: &FileFault) -> String {
    match fault {
        FileFault::NotFound => texts.get("error-not-found"),
        FileFault::Denied => texts.get("error-denied"),
        FileFault::Full => texts.get("error-full"),
        FileFault::Folder => texts.get("error-folder"),
        FileFault::FolderAsFile => texts.get("error-folder-as-file"),
        FileFault::FileAsFolder => texts.get("error-file-as-folder"),
        FileFault::NoFolder => texts.get("error-no-folder"),
        FileFault::NoFileHere => texts.get("error-no-file-here"),
        FileFault::ReadOnly => texts.get("error-read-only"),
        FileFault::NameTooLong => texts.get("error-name-too-long"),
        FileFault::TooLong { kind, limit } => {
            let arguments =
                [("kind", kind.to_string().into()), ("limit", limit.to_string().into())];
            texts.format("error-too-long", &arguments)
        }
        FileFault::NoMemory => texts.get("error-no-memory"),
        FileFault::NobodyWrites => texts.get("error-nobody-writes"),
        FileFault::NoText(byte) => texts.format("error-no-text", &[("byte", (*byte).into())]),
        FileFault::Utf16 => texts.get("error-utf-16"),
        FileFault::System(told) => told.clone(),
    }
}

fn of_import(texts: &Texts, error: &ImportError) -> String {
    match error {
        ImportError::Empty => texts.get("error-empty"),
        ImportError::UnknownKind => texts.get("error-unknown-kind"),
        ImportError::WrongContent { expected, found } => {
            let arguments = [("expected", kind(expected)), ("found", kind(found))]
                .map(|(name, kind)| (name, kind.to_owned().into()));
            texts.format("error-wrong-content", &arguments)
        }
        ImportError::Utf16 => texts.get("error-utf-16"),
        ImportError::Malformed { place, told } => {
            let place = match place {
                Place::Line { line, column } => {
                    line_and_column(texts, "error-line", [*line, *column])
                }
                Place::Byte(byte) => texts.format("error-byte", &[("byte", (*byte).into())]),
            };
            let arguments = [("place", place.into()), ("details", told.told(texts).into())];
            texts.format("error-malformed", &arguments)
        }
        ImportError::Picture(PictureFault::EndsEarly) => texts.get("error-picture-ends"),
        ImportError::Picture(PictureFault::GivenUp) => texts.get("error-picture-given-up"),
        // Decoders speak English.
        ImportError::Picture(PictureFault::Decoder(reason)) => {
            texts.format("error-picture", &[("reason", reason.clone().into())])
        }
        ImportError::TooLarge { what, found, limit } => {
            let [found, limit] = [found, limit].map(ToString::to_string);
            let what = texts.get(&format!("error-{what}"));
            let arguments =
                [("what", what.into()), ("found", found.into()), ("limit", limit.into())];
            texts.format("error-too-large", &arguments)
        }
        ImportError::NoPoints => texts.get("error-no-points"),
        ImportError::Cancelled(cancelled) => cancelled.to_string(),
    }
}

/// What a kind of file is called in every language: `PNG` of `a PNG picture`.
fn kind(noun: &str) -> &str {
    let is_name = |word: &&str| word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase());
    noun.split(' ').find(is_name).unwrap_or(noun)
}

fn of_scenario(texts: &Texts, error: &ScenarioError) -> String {
    let place = line_and_column(texts, "error-line", [error.line, error.column]);
    format!("{place}: {}", of_fault(texts, &error.fault))
}

fn of_building(texts: &Texts, error: &BuildError) -> String {
    match error {
        BuildError::TooManyNodes => {
            texts.format("error-too-many-nodes", &[("most", MAX_NODES.to_string().into())])
        }
        BuildError::Outside { count, first } => outside(texts, *count, *first),
        BuildError::Domain(DomainError::TooFine) => texts.get("error-too-fine"),
        BuildError::Unusable(item) => texts.format("error-unusable", &[("item", (*item).into())]),
        BuildError::ImageInSpace => texts.get("error-image-in-space"),
        // What was read has none of these.
        BuildError::Domain(DomainError::NotABox | DomainError::TooDeep(_))
        | BuildError::DepthsDiffer { .. }
        | BuildError::NoCapacity
        | BuildError::PixelCount { .. }
        | BuildError::Cancelled(_) => {
            texts.format("error-building", &[("details", error.to_string().into())])
        }
    }
}

fn outside(texts: &Texts, count: usize, first: usize) -> String {
    texts.format("error-outside", &[("count", count.into()), ("first", first.into())])
}

fn of_steps(texts: &Texts, error: StepsError) -> String {
    let numbers = |key: &str, named: &[(&str, usize)]| {
        let named: Vec<_> = named.iter().map(|(name, n)| (*name, (*n).into())).collect();
        texts.format(key, &named)
    };
    match error {
        StepsError::Missing { step, last } => {
            numbers("error-no-step", &[("step", step), ("last", last)])
        }
        StepsError::Backwards { first, last } => {
            numbers("error-steps-backwards", &[("first", first), ("last", last)])
        }
        StepsError::TooMany { first, n } => {
            let last = first + MOST_STEPS - 1;
            let named = [("n", n), ("most", MOST_STEPS), ("first", first), ("last", last)];
            numbers("error-too-many-steps", &named)
        }
    }
}

fn of_opening(texts: &Texts, fault: &OpenFault) -> String {
    match fault {
        OpenFault::TooLarge => texts.get("error-scenario-too-large"),
        OpenFault::UnknownKind => texts.get("error-unknown-kind"),
        OpenFault::Cells => texts.get("error-list-of-cells"),
        OpenFault::Rays => texts.get("error-list-of-rays"),
        OpenFault::NoScenario => texts.get("error-no-scenario"),
        OpenFault::DataFile => texts.get("error-data-file"),
        OpenFault::OtherData => texts.get("error-other-data"),
        OpenFault::OtherDimension => texts.get("error-other-dimension"),
    }
}

fn line_and_column(texts: &Texts, key: &str, [line, column]: [usize; 2]) -> String {
    texts.format(key, &[("line", line.into()), ("column", column.into())])
}
