//! What the picture shows, and where from, as a scenario keeps it in its field `view`: as
//! `"show": "order-numbers,children,slice=x:0.5"` and `"camera": "-30,20,1.5"`, in the words
//! of `octoscope export --show` and `--camera`.

use crate::eye::{Eye, EyeError};
use crate::shown::{ShownError, parse_shown, print_shown};
use octoscope_core::scenario::{AnyScenario, View};
use octoscope_figure::Show;
use serde_json::Value;
use thiserror::Error;

const SHOW: &str = "show";
const CAMERA: &str = "camera";

/// What a scenario keeps of how it is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptView {
    /// What the picture shows.
    pub show: Show,
    /// Where from; without it, everything is seen from the usual side.
    pub eye: Option<Eye>,
}

impl KeptView {
    /// Keeps it in a scenario.
    pub fn keep_in(&self, scenario: &mut AnyScenario) {
        keep_show(scenario, &self.show);
        keep_eye(scenario, self.eye.as_ref());
    }
}

/// What is wrong with what a scenario keeps of how it is seen.
#[derive(Debug, Error)]
#[error("the field “{field}” of the scenario's “view” cannot be read: {fault}")]
pub struct KeptError {
    /// The field of its `view`.
    pub field: &'static str,
    /// What is wrong there.
    pub fault: KeptFault,
}

/// What is wrong with a field of a scenario's `view`.
#[derive(Debug, Error)]
pub enum KeptFault {
    /// What is shown is told by no text.
    #[error("it is no text; write names between commas")]
    NoNames,
    /// What is shown.
    #[error(transparent)]
    Shown(#[from] ShownError),
    /// Where from is told by no text.
    #[error("it is no text; write “-30,20,1.5”")]
    NoNumbers,
    /// Where from.
    #[error(transparent)]
    Eye(#[from] EyeError),
    /// The point in the middle has another dimension than the scene.
    #[error("its middle has {n} numbers; give {dimension}, or none")]
    Middle {
        /// Its numbers.
        n: usize,
        /// As many as would be right.
        dimension: usize,
    },
}

/// What the field `view` of a scenario says of what is shown, if anything.
///
/// # Errors
/// Says what is wrong with it.
pub fn kept_show(view: &View) -> Result<Option<Show>, KeptError> {
    let read = |kept: &Value| -> Result<Show, KeptFault> {
        Ok(parse_shown(kept.as_str().ok_or(KeptFault::NoNames)?)?)
    };
    let show = view.get(SHOW).map(read).transpose();
    show.map_err(|fault| KeptError { field: SHOW, fault })
}

/// Keeps in a scenario what the picture shows; nothing, if that is what it shows at first.
pub fn keep_show(scenario: &mut AnyScenario, show: &Show) {
    let (view, at_first) = match scenario {
        AnyScenario::Quadtree(scenario) => (&mut scenario.view, Show::at_first::<2>()),
        AnyScenario::Octree(scenario) => (&mut scenario.view, Show::at_first::<3>()),
    };
    if *show == at_first {
        view.remove(SHOW);
    } else {
        view.insert(SHOW.to_owned(), print_shown(show).into());
    }
}

/// What the field `view` of a scenario of dimension D says of where it is looked at from,
/// if anything.
///
/// # Errors
/// Says what is wrong with it.
pub fn kept_eye<const D: usize>(view: &View) -> Result<Option<Eye>, KeptError> {
    let read = |kept: &Value| -> Result<Eye, KeptFault> {
        let eye: Eye = kept.as_str().ok_or(KeptFault::NoNumbers)?.parse()?;
        match eye.middle.len() {
            0 => Ok(eye),
            n if n == D => Ok(eye),
            n => Err(KeptFault::Middle { n, dimension: D }),
        }
    };
    view.get(CAMERA).map(read).transpose().map_err(|fault| KeptError { field: CAMERA, fault })
}

/// Keeps in a scenario where it is looked at from; nothing without an eye.
pub fn keep_eye(scenario: &mut AnyScenario, eye: Option<&Eye>) {
    let view = match scenario {
        AnyScenario::Quadtree(scenario) => &mut scenario.view,
        AnyScenario::Octree(scenario) => &mut scenario.view,
    };
    match eye {
        None => drop(view.remove(CAMERA)),
        Some(eye) => drop(view.insert(CAMERA.to_owned(), eye.to_string().into())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::open::open_built_in;
    use octoscope_core::progress::Progress;

    #[test]
    fn what_is_kept_is_shown_again() {
        let document = open_built_in("quadtree-82", &Progress::default()).unwrap();
        let mut scenario = document.scenario_at(0);
        let plain = scenario.print();
        let kept = |scenario: &AnyScenario| match AnyScenario::parse(&scenario.print()).unwrap() {
            AnyScenario::Quadtree(scenario) => kept_show(&scenario.view).unwrap(),
            AnyScenario::Octree(scenario) => kept_show(&scenario.view).unwrap(),
        };
        let show = Show { codes: true, explosion: 0.5, ..Show::at_first::<2>() };
        keep_show(&mut scenario, &show);
        assert_eq!(kept(&scenario), Some(show));
        keep_show(&mut scenario, &Show::at_first::<2>());
        assert_eq!((kept(&scenario), scenario.print()), (None, plain));
        let AnyScenario::Quadtree(mut scenario) = scenario else { panic!("not a quadtree") };
        scenario.view.insert("show".to_owned(), 3.into());
        assert!(kept_show(&scenario.view).is_err());
    }

    #[test]
    fn where_it_is_looked_at_from_is_kept_and_checked() {
        let document = open_built_in("points-3d", &Progress::default()).unwrap();
        let mut scenario = document.scenario_at(0);
        let plain = scenario.print();
        let eye: Eye = "298,24,1.5,0.5,0.25,1,parallel".parse().unwrap();
        keep_eye(&mut scenario, Some(&eye));
        let Ok(AnyScenario::Octree(again)) = AnyScenario::parse(&scenario.print()) else {
            panic!("not an octree")
        };
        assert_eq!(kept_eye::<3>(&again.view).unwrap(), Some(eye));
        assert!(kept_eye::<2>(&again.view).unwrap_err().to_string().contains("give 2"));
        keep_eye(&mut scenario, None);
        assert_eq!(scenario.print(), plain);
        let AnyScenario::Octree(mut scenario) = scenario else { panic!("not an octree") };
        scenario.view.insert("camera".to_owned(), "from above".into());
        assert!(kept_eye::<3>(&scenario.view).is_err());
    }
}
