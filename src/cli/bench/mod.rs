//! `octoscope bench`: what algorithms cost.

mod chart;

use super::Answer;
use super::progress::run_with_progress;
use super::values::{language, theme, whole};
use crate::bench::{MOST_DEPTH, MOST_RAYS, MOST_REPEATS, Plan, csv, run, summary, text};
use crate::files::Output;
use chart::{Chart, cost, size};
use clap::Args;
use octoscope_core::measure::Quantity;
use octoscope_core::measure::{Disagreement, LeftOut, Results, Way};
use octoscope_core::scenario::BUILT_IN;
use octoscope_core::text::Language;
use octoscope_core::traverse::MethodError;
use octoscope_figure::Theme;
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// Measures algorithms, and the kernel for many rays, in scenes at several depths, all in one run.
///
/// For each scene and depth two tables. What depends on the machine: microseconds a
/// ray, the median of the repetitions, which take turns, taken of every 16 rays by
/// themselves, and how far the middle half of them lies around it; nanoseconds a visited
/// leaf; rays a second; the time in units of the best. What does not, a ray: nodes
/// reached, comparisons by kind, divisions, searches from the root, steps up and down;
/// the greatest depth of the stack; lines of 64 bytes read, reads that a cache of 32
/// KiB does not have, and comparisons that a two-bit counter guesses wrong. Below them,
/// how the time grows, and what of the published comparison holds.
///
/// Every occupied cell is a leaf of its own, as with visit --keep-cells. All rays come
/// from outside, from a seed. Exit status: 1 if an algorithm finds other
/// leaves than the first.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope bench\n  \
    octoscope bench --scene cloud --depth 6 --algorithm parametric --algorithm gargantini\n  \
    octoscope bench --depth 5-8 --rays 10000 --csv -o bench.csv\n  \
    octoscope bench --chart scenes=times.svg --chart growth=growth.pdf\n  \
    octoscope bench --algorithm parametric --algorithm batch --chart scenes=batch.png")]
pub struct Bench {
    /// Built-in scene (see octoscope scenes); may be given several times. Without it,
    /// the six of the published comparison.
    #[arg(long, value_name = "NAME", value_parser = scene)]
    scene: Vec<&'static str>,
    /// Identifier of an algorithm, with @ and variants as in bsp@gem or, with commas
    /// between several, parametric@B-1,B-3; may be given several times. Or batch, the
    /// kernel for many rays at once with the vectors of the processor, and batch@plain,
    /// the same without: exact, but no steps can be counted. Or all, with the oracle,
    /// which tests all leaves; without the option, all but the oracle.
    #[arg(long, value_name = "ID")]
    algorithm: Vec<Choice>,
    /// Levels below the root: one number, or the least and the most.
    #[arg(long, value_name = "N-N", default_value = "5-8", value_parser = depths, allow_hyphen_values = true)]
    depth: Depths,
    /// Number of rays.
    #[arg(long, value_name = "N", default_value = "1000", value_parser = rays, allow_hyphen_values = true)]
    rays: usize,
    /// Seed of the rays.
    #[arg(long, value_name = "N", default_value = "24301", value_parser = seed, allow_hyphen_values = true)]
    seed: u64,
    /// How often every algorithm runs through all rays.
    #[arg(long, value_name = "N", default_value = "9", value_parser = repeats, allow_hyphen_values = true)]
    repeat: usize,
    /// Prints one line for each scene, depth and algorithm, as CSV.
    #[arg(long)]
    csv: bool,
    /// Writes to this file, which appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Draws a chart to a file as well, whose ending is svg, pdf, png or tex: scenes
    /// (bars in units of the best, at the greatest depth), growth (lines over the
    /// depths of the first scene) or published (the published statements); may be
    /// given several times.
    #[arg(long, value_name = "KIND=FILE")]
    chart: Vec<Chart>,
    /// What the charts show: time, time-per-leaf, steps, node-touches, comparisons,
    /// lines, cache-misses or branch-misses.
    #[arg(long, value_name = "COST", default_value = "time", value_parser = cost, requires = "chart")]
    cost: Quantity,
    /// Against what growth is drawn: cells, tree-leaves or ray-leaves.
    #[arg(long, value_name = "SIZE", default_value = "tree-leaves", value_parser = size, requires = "chart")]
    against: Quantity,
    /// light, dark, print or projector: colours of the charts.
    #[arg(long, default_value = "print", value_parser = theme, requires = "chart")]
    theme: Theme,
    /// Language of the charts: en or de.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = language, requires = "chart")]
    lang: Language,
}

fn scene(name: &str) -> Result<&'static str, String> {
    let id = name.strip_prefix("scene:").unwrap_or(name);
    let found = BUILT_IN.iter().find(|entry| entry.id == id);
    found.map(|entry| entry.id).ok_or_else(|| {
        format!(
            "there is no built-in scene; there are {}",
            BUILT_IN.map(|entry| entry.id).join(", ")
        )
    })
}

/// Levels from the least to the most.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Depths(RangeInclusive<u8>);

fn depths(text: &str) -> Result<Depths, String> {
    let wrong = || {
        format!(
            "give a number of levels from 1 to {MOST_DEPTH}, or the least and the most as in 5-8"
        )
    };
    let (least, most) = text.split_once('-').unwrap_or((text, text));
    let level =
        |text: &str| whole::<u8>(text.trim(), 1..=MOST_DEPTH.into(), "").map_err(|_| wrong());
    let (least, most) = (level(least)?, level(most)?);
    if least > most { Err(wrong()) } else { Ok(Depths(least..=most)) }
}

fn rays(text: &str) -> Result<usize, String> {
    whole(text, 1..=MOST_RAYS as u64, "")
}

fn seed(text: &str) -> Result<u64, String> {
    whole(text, 0..=u64::MAX, "")
}

fn repeats(text: &str) -> Result<usize, String> {
    whole(text, 1..=MOST_REPEATS as u64, "")
}

/// One algorithm or every one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    One(Way),
    All,
}

impl std::str::FromStr for Choice {
    type Err = MethodError;

    fn from_str(id: &str) -> Result<Self, MethodError> {
        if id == "all" { Ok(Self::All) } else { id.parse().map(Self::One) }
    }
}

impl Bench {
    fn plan(&self) -> Plan {
        let usual = Plan::default();
        let mut ways: Vec<Way> = Vec::new();
        for choice in &self.algorithm {
            let chosen = match choice {
                Choice::One(way) => vec![*way],
                Choice::All => Way::all(),
            };
            for way in chosen {
                if !ways.contains(&way) {
                    ways.push(way);
                }
            }
        }
        let mut scenes = Vec::new();
        for &scene in &self.scene {
            if !scenes.contains(&scene) {
                scenes.push(scene);
            }
        }
        Plan {
            scenes: if scenes.is_empty() { usual.scenes } else { scenes },
            depths: self.depth.0.clone(),
            ways: if ways.is_empty() { usual.ways } else { ways },
            n_rays: self.rays,
            seed: self.seed,
            n_repeats: self.repeat,
        }
    }
}

/// Runs the command.
///
/// # Errors
/// Says which tree cannot be built, or what cannot be written.
pub fn bench(arguments: &Bench) -> anyhow::Result<Answer> {
    // Whether it can be written is known before everything is measured; nothing of it
    // is left where the measurement is broken off.
    drop(Output::open(arguments.output.as_deref())?);
    for chart in &arguments.chart {
        drop(Output::open(Some(&chart.path))?);
    }
    let plan = arguments.plan();
    let results = run_with_progress(|progress| run(&plan, progress))?;
    for LeftOut { why, .. } in &results.left_out {
        eprintln!("octoscope: left out: {why}");
    }
    let mut output = Output::open(arguments.output.as_deref())?;
    if arguments.csv {
        output.write_all(csv(&results).as_bytes())?;
    } else {
        output.write_all(text(&results).as_bytes())?;
        output.write_all(summary(&results).as_bytes())?;
        if cfg!(debug_assertions) {
            let note = "this program was built without optimisation: its times tell nothing";
            writeln!(output, "\n{note}, its counts do")?;
        }
    }
    output.finish()?;
    let texts = crate::text::texts(arguments.lang);
    for chart in &arguments.chart {
        chart.write(&results, [arguments.cost, arguments.against], &texts, arguments.theme)?;
    }
    Ok(answer(&results))
}

/// Done, if all algorithms have found the same.
fn answer(results: &Results) -> Answer {
    let different =
        results.sites.iter().find_map(|site| site.disagreement.map(|found| (site, found)));
    match different {
        None => Answer::Done,
        Some((site, Disagreement { way, reference, ray, leaf })) => Answer::No(format!(
            "in {} at depth {} {way} finds other leaves than {reference}, first on ray {} at \
             leaf {}",
            site.scene,
            site.depth,
            ray + 1,
            leaf + 1
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_are_one_number_or_two() {
        assert_eq!(depths("6"), Ok(Depths(6..=6)));
        assert_eq!(depths("5-8"), Ok(Depths(5..=8)));
        for bad in ["", "8-5", "0", "13", "5-", "-5", "5-8-9", "x", "5.5"] {
            assert!(depths(bad).unwrap_err().starts_with("give a number of levels"), "{bad}");
        }
    }

    #[test]
    fn scenes_are_named_with_or_without_their_prefix() {
        assert_eq!(scene("cloud"), scene("scene:cloud"));
        assert!(scene("fog").unwrap_err().contains("spheres-4096"));
    }
}
