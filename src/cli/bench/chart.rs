//! `--chart`: pictures of what was measured.

use crate::lab::{self, Choice, ENDINGS, Tab};
use octoscope_core::measure::{Quantity, Results};
use octoscope_core::progress::Progress;
use octoscope_core::text::Texts;
use octoscope_figure::Theme;
use std::path::PathBuf;
use std::str::FromStr;

/// A chart and the file to which it goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chart {
    tab: Tab,
    /// The file; its ending tells the format.
    pub path: PathBuf,
}

/// The charts by name.
const TABS: [(&str, Tab); 3] =
    [("scenes", Tab::Scenes), ("growth", Tab::Growth), ("published", Tab::Published)];

impl FromStr for Chart {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let such_as = "give scenes, growth or published and a file, as in growth=growth.svg";
        let (name, path) = text.split_once('=').ok_or(such_as)?;
        let (_, tab) = TABS
            .into_iter()
            .find(|(id, _)| *id == name)
            .ok_or_else(|| format!("there is no chart ‘{name}’; {such_as}"))?;
        let path = PathBuf::from(path);
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let charts = || ENDINGS.into_iter().filter(|ending| !matches!(*ending, "csv" | "md"));
        if !charts().any(|one| one == ending) {
            let known = charts().map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(", ");
            return Err(format!("the ending of the file tells the format: give one of {known}"));
        }
        Ok(Self { tab, path })
    }
}

/// The cost of this name.
///
/// # Errors
/// Lists the costs there are.
pub fn cost(id: &str) -> Result<Quantity, String> {
    of_name(id, &Quantity::COSTS)
}

/// The size of this name.
///
/// # Errors
/// Lists the sizes there are.
pub fn size(id: &str) -> Result<Quantity, String> {
    of_name(id, &Quantity::SIZES)
}

fn of_name(id: &str, all: &[Quantity]) -> Result<Quantity, String> {
    all.iter().copied().find(|quantity| quantity.id() == id).ok_or_else(|| {
        let known: Vec<_> = all.iter().map(|quantity| quantity.id()).collect();
        format!("there is no such quantity; there are {}", known.join(", "))
    })
}

impl Chart {
    /// Draws the chart and writes it: costs against sizes, the scenes at their greatest
    /// depth, the growth in the first scene.
    ///
    /// # Errors
    /// Says what cannot be drawn or written.
    pub fn write(
        &self,
        results: &Results,
        [cost, size]: [Quantity; 2],
        texts: &Texts,
        theme: Theme,
    ) -> anyhow::Result<()> {
        let number = |of: Quantity, all: &[Quantity]| all.iter().position(|&one| one == of);
        let choice = Choice {
            tab: self.tab,
            cost: number(cost, &Quantity::COSTS).unwrap_or(0),
            size: number(size, &Quantity::SIZES).unwrap_or(0),
            depth: results.depths().last().copied().unwrap_or_default(),
            scene: 0,
            ..Choice::default()
        };
        let figure = lab::figure(&choice, results, &[], texts, lab::SIZE_OF_FILES);
        let title = format!("{}: {}", texts.get("lab-title"), texts.get(self.tab.id()));
        lab::write(results, &figure, (theme, &title), &self.path, &Progress::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_is_told_with_its_file() {
        let chart: Chart = "growth=a b=c.SVG".parse().unwrap();
        assert_eq!(chart, Chart { tab: Tab::Growth, path: PathBuf::from("a b=c.SVG") });
    }

    #[test]
    fn what_is_no_chart_is_told_with_what_there_is() {
        for (text, told) in [
            ("growth", "give scenes, growth or published and a file"),
            ("pie=a.svg", "there is no chart ‘pie’; give scenes"),
            ("growth=a.csv", "the ending of the file tells the format: give one of .svg, .pdf"),
            ("growth=a", "the ending of the file tells"),
        ] {
            let error = text.parse::<Chart>().unwrap_err();
            assert!(error.starts_with(told), "{error}");
        }
        assert!(cost("speed").unwrap_err().contains("time, time-per-leaf"));
        assert_eq!(size("cells"), Ok(Quantity::Cells));
    }
}
