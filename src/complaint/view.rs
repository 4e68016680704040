//! Why there is nothing to see, in the language of the window.

use crate::eye::EyeError;
use crate::kept_view::{KeptError, KeptFault};
use crate::shown::{ShownError, parts, rests};
use octoscope_core::text::{Texts, Value};
use octoscope_figure::Show;
use octoscope_figure::views::{ExerciseError, FigureView, ViewError};

/// Why a view shows nothing.
pub(super) fn of_figure(texts: &Texts, error: &ViewError) -> String {
    let name = |view: FigureView| Value::from(texts.get(&format!("figure-{}", view.id())));
    match *error {
        ViewError::Query { view, .. } => texts.format("error-view-query", &[("view", name(view))]),
        ViewError::Step { view, step, first } => {
            let steps = [("step", step.into()), ("first", first.into())];
            texts.format("error-view-step", &[&[("view", name(view))], &steps[..]].concat())
        }
        ViewError::Never { view } => texts.format("error-view-never", &[("view", name(view))]),
    }
}

/// Why a ray is no exercise.
pub(super) fn of_exercise(texts: &Texts, error: ExerciseError) -> String {
    match error {
        ExerciseError::Missed => texts.get("error-exercise-missed"),
        ExerciseError::TooLong(n) => texts.format("error-exercise-long", &[("n", n.into())]),
        ExerciseError::NoRay => texts.get("error-exercise-none"),
    }
}

/// What is wrong with what a scenario keeps of how it is seen.
pub(super) fn of_kept(texts: &Texts, KeptError { field, fault }: &KeptError) -> String {
    let details = match fault {
        KeptFault::NoNames => texts.get("error-kept-no-names"),
        KeptFault::Shown(error) => of_shown(texts, error),
        KeptFault::NoNumbers => texts.get("error-kept-no-numbers"),
        KeptFault::Eye(error) => of_eye(texts, error),
        KeptFault::Middle { n, dimension } => {
            let numbers = [("n", (*n).into()), ("dimension", (*dimension).into())];
            texts.format("error-kept-middle", &numbers)
        }
    };
    texts.format("error-kept", &[("field", (*field).into()), ("details", details.into())])
}

fn of_shown(texts: &Texts, error: &ShownError) -> String {
    let given = |key: &str, text: &str| texts.format(key, &[("given", text.to_owned().into())]);
    let known = |key: &str, text: &str, known: String| {
        texts.format(key, &[("given", text.to_owned().into()), ("known", known.into())])
    };
    match error {
        ShownError::Part(name) => known("error-shown-part", name, parts()),
        ShownError::Setting(name) => given("error-shown-setting", name),
        ShownError::Levels(value) => given("error-shown-levels", value),
        ShownError::Rest(value) => known("error-shown-rest", value, rests()),
        ShownError::Slice(value) => given("error-shown-slice", value),
        ShownError::Apart(value) => known("error-shown-apart", value, Show::MOST_APART.to_string()),
    }
}

fn of_eye(texts: &Texts, error: &EyeError) -> String {
    let given = |key: &str, given: f64| texts.format(key, &[("given", given.to_string().into())]);
    match *error {
        EyeError::NoNumbers => texts.get("error-eye-no-numbers"),
        EyeError::Count(n) => texts.format("error-eye-count", &[("n", n.into())]),
        EyeError::Pitch(pitch) => given("error-eye-pitch", pitch),
        EyeError::Zoom(zoom) => given("error-eye-zoom", zoom),
    }
}
