//! `octoscope trace`: the steps of one query.

use super::Answer;
use super::values::{Numbers, language};
use crate::document::Document;
use crate::files::Output;
use crate::open::open;
use crate::with_document;
use anyhow::{anyhow, bail};
use clap::{Args, ValueEnum};
use octoscope_core::explain::{trace_csv, trace_jsonl, trace_text};
use octoscope_core::geometry::{AXIS_NAMES, Ray};
use octoscope_core::progress::Progress;
use octoscope_core::query::Query;
use octoscope_core::text::Language;
use octoscope_core::traverse::Algorithm;
use std::io::Write;
use std::path::PathBuf;

/// Runs the query of a scenario and prints its steps.
///
/// As text, one numbered sentence a step; as JSON lines, a header and one
/// object a step with its event, its node as [level, x, y, z], the interval t,
/// the state and the variables; as CSV, the same in columns.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope trace scene:quadtree-82\n  \
    octoscope trace lecture.octo --algorithm codes --lang de\n  \
    octoscope trace scene:figure-7 --ray \"1.5,0.3,0.2,-1,0.1,0.2\" --format jsonl -o a.jsonl")]
pub struct Trace {
    /// Scenario (.octo), data file, or built-in scene as scene:NAME.
    file: PathBuf,
    /// Traverses by this algorithm (see octoscope scenes), whatever the
    /// scenario asks.
    #[arg(long, value_name = "ID")]
    algorithm: Option<Algorithm>,
    /// Takes this ray: origin and direction, four numbers in 2-D and six in
    /// 3-D, decimal or hexadecimal.
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", allow_hyphen_values = true)]
    ray: Option<Numbers>,
    /// What is printed.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Language of the sentences: en or de.
    #[arg(long, value_name = "LANGUAGE", default_value = "en", value_parser = language)]
    lang: Language,
    /// Writes to this file, which appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// What is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// One numbered sentence a step.
    Text,
    /// A header, then one JSON object a step.
    Jsonl,
    /// Columns between commas.
    Csv,
}

/// Runs the command.
///
/// # Errors
/// Says what is wrong with the file or the ray.
pub fn trace(arguments: &Trace) -> anyhow::Result<Answer> {
    let document = open(&arguments.file, &Progress::default())?;
    let text = with_document!(document, document => traced(*document, arguments))?;
    let mut output = Output::open(arguments.output.as_deref())?;
    output.write_all(text.as_bytes())?;
    output.finish()?;
    Ok(Answer::Done)
}

fn traced<const D: usize>(mut document: Document<D>, arguments: &Trace) -> anyhow::Result<String> {
    let scenario = &mut document.scenario;
    if let Some(numbers) = &arguments.ray {
        scenario.ray = ray(numbers)?;
    }
    if arguments.ray.is_some() || arguments.algorithm.is_some() {
        scenario.query = along_ray(scenario.query, arguments.algorithm);
    }
    document.refresh(0);
    let Document { tree, trace, scenario, .. } = &document;
    Ok(match arguments.format {
        Format::Text => trace_text(tree, &scenario.ray, trace, arguments.lang),
        Format::Jsonl => trace_jsonl(tree, &scenario.ray, trace),
        Format::Csv => trace_csv(tree, trace),
    })
}

fn ray<const D: usize>(numbers: &Numbers) -> anyhow::Result<Ray<D>> {
    let Numbers(numbers) = numbers;
    if numbers.len() != 2 * D {
        let names = |letter| AXIS_NAMES[..D].iter().map(move |axis| format!("{letter}{axis}"));
        let order: Vec<String> = names('o').chain(names('d')).collect();
        let tree = if D == 2 { "a quadtree" } else { "an octree" };
        bail!(
            "--ray has {} numbers; a ray through {tree} takes {}: {}",
            numbers.len(),
            2 * D,
            order.join(",")
        );
    }
    let [origin, direction] = [0, D].map(|start| std::array::from_fn(|e| numbers[start + e]));
    Ray::new(origin, direction).map_err(|error| anyhow!("--ray: {error}"))
}

/// `query`, if it is about the ray, else the default one that is; by
/// `algorithm`, if there is one.
fn along_ray<const D: usize>(query: Query<D>, algorithm: Option<Algorithm>) -> Query<D> {
    let mut along = match query {
        Query::Ray { .. } => query,
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => Query::default(),
    };
    if let (Query::Ray { algorithm, .. }, Some(wanted)) = (&mut along, algorithm) {
        *algorithm = wanted;
    }
    along
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_has_as_many_numbers_as_its_tree_asks() {
        let check = |n: usize| ray::<2>(&Numbers(vec![1.0; n])).map_err(|error| error.to_string());
        assert_eq!(check(4), Ok(Ray::new([1.0; 2], [1.0; 2]).unwrap()));
        let message = "--ray has 6 numbers; a ray through a quadtree takes 4: ox,oy,dx,dy";
        assert_eq!(check(6), Err(message.to_owned()));
        assert!(ray::<2>(&Numbers(vec![0.0; 4])).is_err());
    }
}
