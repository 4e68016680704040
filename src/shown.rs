//! What a figure shows beside the algorithm's state, by name.

use crate::show_change::ShownPart;
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_figure::{Levels, Rest, Show, Slice};
use thiserror::Error;

/// Why names do not say what is shown.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ShownError {
    /// Nothing that is shown or not has this name.
    #[error("there is no ‘{0}’ to show; there are {known}, and none", known = parts())]
    Part(String),
    /// Nothing that has a value has this name.
    #[error("there is no ‘{0}’ to set; there are levels, rest, slice and apart")]
    Setting(String),
    /// These are no levels.
    #[error("there are no levels ‘{0}’; give two as in levels=2-5")]
    Levels(String),
    /// The rest cannot look so.
    #[error("the rest cannot be ‘{0}’; it can be {known}", known = rests())]
    Rest(String),
    /// No slice is there.
    #[error("there is no slice at ‘{0}’; give axis and share, as in slice=x:0.5")]
    Slice(String),
    /// Children cannot be moved so far.
    #[error("children cannot be apart by ‘{0}’; give sides from 0 to {most}", most = Show::MOST_APART)]
    Apart(String),
}

/// The names of all that is shown or not.
pub fn parts() -> String {
    ShownPart::ALL.map(ShownPart::name).join(", ")
}

/// The names of the looks of the rest.
pub fn rests() -> String {
    Rest::ALL.map(Rest::id).join(", ")
}

/// What shows nothing but the algorithm's state.
fn nothing() -> Show {
    let mut show = Show::default();
    ShownPart::ALL.into_iter().for_each(|part| *part.of(&mut show) = false);
    show
}

/// What these names between commas stand for; `none` for nothing. Beside the names:
/// `levels=2-5`, `rest=faint`, `slice=x:0.5`, `apart=0.7`.
///
/// # Errors
/// Lists the names there are.
pub fn parse_shown(text: &str) -> Result<Show, ShownError> {
    let mut show = nothing();
    for name in text.split(',').map(str::trim).filter(|name| *name != "none") {
        if let Some((name, value)) = name.split_once('=') {
            set(&mut show, name, value)?;
            continue;
        }
        let part = ShownPart::ALL.into_iter().find(|part| part.name() == name);
        *part.ok_or_else(|| ShownError::Part(name.to_owned()))?.of(&mut show) = true;
    }
    Ok(show)
}

/// Sets what has a value.
fn set(show: &mut Show, name: &str, value: &str) -> Result<(), ShownError> {
    let within = |x: &f64, most: f64| (0.0..=most).contains(x);
    let fault = |fault: fn(String) -> ShownError| move || fault(value.to_owned());
    match name {
        "levels" => {
            let (least, most) = value.split_once('-').unwrap_or((value, value));
            let levels = least.parse().ok().zip(most.parse().ok());
            let levels = levels.filter(|(least, most)| least <= most);
            let (least, most) = levels.ok_or_else(fault(ShownError::Levels))?;
            show.levels = Levels { least, most };
        }
        "rest" => {
            let rest = Rest::ALL.into_iter().find(|rest| rest.id() == value);
            show.rest = rest.ok_or_else(fault(ShownError::Rest))?;
        }
        "slice" => {
            let parsed = value.split_once(':').and_then(|(axis, at)| {
                let axis = AXIS_NAMES.iter().position(|name| *name == axis)?;
                let at = at.parse().ok().filter(|at| within(at, 1.0))?;
                Some(Slice { axis: axis as u8, at })
            });
            show.slice = Some(parsed.ok_or_else(fault(ShownError::Slice))?);
        }
        "apart" => {
            let share = value.parse().ok().filter(|share| within(share, Show::MOST_APART));
            show.explosion = share.ok_or_else(fault(ShownError::Apart))?;
        }
        _ => return Err(ShownError::Setting(name.to_owned())),
    }
    Ok(())
}

/// The names, as [`parse_shown`] reads them.
pub fn print_shown(show: &Show) -> String {
    let is_shown = |part: &ShownPart| *part.of(&mut show.clone());
    let names = ShownPart::ALL.into_iter().filter(is_shown);
    let mut names: Vec<String> = names.map(|part| part.name().to_owned()).collect();
    if names.is_empty() {
        names.push("none".to_owned());
    }
    let Levels { least, most } = show.levels;
    if show.levels != Levels::ALL {
        names.push(format!("levels={least}-{most}"));
    }
    if show.rest != Rest::Plain {
        names.push(format!("rest={}", show.rest.id()));
    }
    if let Some(Slice { axis, at }) = show.slice {
        names.push(format!("slice={}:{at}", AXIS_NAMES[usize::from(axis)]));
    }
    if show.explosion != 0.0 {
        names.push(format!("apart={}", show.explosion));
    }
    names.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_is_shown() {
        for show in [nothing(), Show::default(), Show::at_first::<3>()] {
            assert_eq!(parse_shown(&print_shown(&show)), Ok(show));
        }
        assert_eq!(parse_shown("codes"), Ok(Show { codes: true, ..nothing() }));
        let set = Show {
            levels: Levels { least: 2, most: 5 },
            rest: Rest::Faint,
            slice: Some(Slice { axis: 2, at: 0.375 }),
            explosion: 0.7,
            ..nothing()
        };
        assert_eq!(print_shown(&set), "none,levels=2-5,rest=faint,slice=z:0.375,apart=0.7");
        assert_eq!(parse_shown(&print_shown(&set)), Ok(set));
        for bad in
            ["levels=5-2", "levels=x", "rest=no", "slice=w:0", "slice=x:2", "apart=-1", "a=b"]
        {
            assert!(parse_shown(bad).is_err(), "{bad}");
        }
        assert!(parse_shown("codes,all").unwrap_err().to_string().contains("‘all’"));
    }
}
