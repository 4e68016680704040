//! What the lab shows of results.

use super::{Choice, Tab};
use crate::bench;
use octoscope_core::measure::{Results, Watched};
use octoscope_core::text::Texts;
use octoscope_figure::Figure;
use octoscope_figure::views::lab::{
    Growth, growth_chart, processor_chart, published_chart, scene_name, scenes_chart,
};

/// Size of charts in files.
pub const SIZE_OF_FILES: [f64; 2] = [860.0, 520.0];

/// The chart that is chosen, as wide as this and, where it can choose, as high.
pub fn figure(
    choice: &Choice,
    results: &Results,
    watched: &[Watched],
    texts: &Texts,
    [width, height]: [f64; 2],
) -> Figure {
    match choice.tab {
        Tab::Scenes => scenes_chart(results, choice.cost(), choice.depth_in(results), texts, width),
        Tab::Growth => {
            let (size, cost) = (choice.size(), choice.cost());
            let of = Growth { scene: choice.scene_in(results), size, cost };
            growth_chart(results, of, texts, [width, height.max(320.0)])
        }
        Tab::Published | Tab::Table => published_chart(results, texts, width),
        Tab::Processor => processor_chart(watched, texts, width),
    }
}

/// All numbers, line by line.
pub fn lines(results: &Results, texts: &Texts) -> Vec<String> {
    let mut lines = Vec::new();
    for site in &results.sites {
        let arguments = [
            ("scene", scene_name(&site.scene, texts).into()),
            ("depth", site.depth.into()),
            ("leaves", site.n_leaves.into()),
            ("rays", site.n_rays.into()),
        ];
        lines.push(texts.format("lab-site", &arguments));
        for table in bench::tables(site) {
            lines.push(String::new());
            lines.extend(table.lines().map(str::to_owned));
        }
        lines.push(String::new());
    }
    if lines.is_empty() {
        lines.push(texts.get("lab-nothing"));
    }
    lines
}
