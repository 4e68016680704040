//! What the picture shows, as a scenario keeps it: in its field `view`, as
//! `"show": "order-numbers,children,slice=x:0.5"`, the words of `octoscope export --show`.

use crate::export::{parse_shown, print_shown};
use anyhow::{Context, anyhow};
use octoscope_core::scenario::{AnyScenario, View};
use octoscope_figure::Show;

const KEY: &str = "show";

/// What the field `view` of a scenario says of it, if anything.
///
/// # Errors
/// Says what is wrong with it.
pub fn kept_show(view: &View) -> anyhow::Result<Option<Show>> {
    let Some(kept) = view.get(KEY) else { return Ok(None) };
    let text = kept.as_str().ok_or_else(|| anyhow!("it is no text; write names between commas"));
    let show = text.and_then(|text| parse_shown(text).map_err(|error| anyhow!(error)));
    show.map(Some).context("the field “show” of the scenario's “view” cannot be read")
}

/// Keeps in a scenario what the picture shows; nothing, if that is what it shows at first.
pub fn keep_show(scenario: &mut AnyScenario, show: &Show) {
    let (view, at_first) = match scenario {
        AnyScenario::Quadtree(scenario) => (&mut scenario.view, Show::at_first::<2>()),
        AnyScenario::Octree(scenario) => (&mut scenario.view, Show::at_first::<3>()),
    };
    if *show == at_first {
        view.remove(KEY);
    } else {
        view.insert(KEY.to_owned(), print_shown(show).into());
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
}
