//! `octoscope trace`: the steps of one query.

use super::Answer;
use super::ray::RayChoice;
use super::values::{language, number};
use crate::document::Document;
use crate::files::Output;
use crate::open::open;
use crate::with_document;
use clap::{Args, ValueEnum};
use octoscope_core::explain::{trace_csv, trace_jsonl, trace_latex, trace_markdown, trace_text};
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::text::Language;
use octoscope_core::traverse::{Method, MethodError};
use std::io::Write;
use std::path::PathBuf;

/// Runs the query of a scenario and prints its steps.
///
/// As text, one numbered sentence a step; as JSON lines, a header and one
/// object a step with its event, its node as [level, x, y, z], the interval t,
/// the state and the variables; as CSV, the same in columns; as Markdown or LaTeX,
/// a table of the sentences with event, node and t.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope trace scene:quadtree-82\n  \
    octoscope trace lecture.octo --algorithm codes --lang de\n  \
    octoscope trace scene:cloud --ray gallery:corner --exact\n  \
    octoscope trace scene:figure-7 --ray \"1.5,0.3,0.2,-1,0.1,0.2\" --format jsonl -o a.jsonl")]
pub struct Trace {
    /// Scenario (.octo), data file, or built-in scene as scene:NAME.
    file: PathBuf,
    /// Traverses by this algorithm (see octoscope scenes), whatever the
    /// scenario asks; with @ and variants as in bsp@gem or, with
    /// commas between several, parametric@B-1,B-3.
    #[arg(long, value_name = "ID")]
    algorithm: Option<Method>,
    /// Takes this ray: origin and direction, four numbers in 2-D and six in
    /// 3-D, each a decimal, a fraction such as 1/3 or a hexadecimal float; or a
    /// degenerate one made for the tree, as gallery:ID (see octoscope scenes).
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ|gallery:ID", allow_hyphen_values = true)]
    ray: Option<RayChoice>,
    /// Ends the ray at this parameter t.
    #[arg(long, value_name = "T", value_parser = number, allow_hyphen_values = true)]
    end: Option<f64>,
    /// Compares exactly, whatever the (finite) numbers.
    #[arg(long)]
    exact: bool,
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
    /// A table for Markdown, with the sentences.
    Markdown,
    /// A table for LaTeX, with the sentences.
    Latex,
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
    if let Some(choice) = &arguments.ray {
        choice.aim(&mut document)?;
    }
    let scenario = &mut document.scenario;
    if arguments.algorithm.is_some() || arguments.end.is_some() || arguments.exact {
        scenario.query = along_ray(scenario.query, arguments)?;
    }
    document.trace_whole();
    let Document { tree, trace, scenario, .. } = &document;
    Ok(match arguments.format {
        Format::Text => trace_text(tree, &scenario.ray, trace, arguments.lang),
        Format::Jsonl => trace_jsonl(tree, &scenario.ray, trace),
        Format::Csv => trace_csv(tree, trace),
        Format::Markdown => trace_markdown(tree, &scenario.ray, trace, arguments.lang),
        Format::Latex => trace_latex(tree, &scenario.ray, trace, arguments.lang),
    })
}

/// `query`, if it is about the ray, else the default one that is; with what the
/// command line says of it.
///
/// # Errors
/// Names a rule that trees of this dimension do not have.
fn along_ray<const D: usize>(query: Query<D>, arguments: &Trace) -> Result<Query<D>, MethodError> {
    let mut query = match query {
        Query::Ray { .. } => query,
        Query::Point { .. } | Query::Region { .. } | Query::Neighbour { .. } => Query::default(),
    };
    if let Query::Ray { algorithm, options, arithmetic } = &mut query {
        if let Some(method) = arguments.algorithm {
            let method = method.in_dimension(D)?;
            (*algorithm, options.variants) = (method.algorithm, method.variants);
        }
        if arguments.exact {
            *arithmetic = Arithmetic::Exact;
        }
        options.segment_end = arguments.end.or(options.segment_end);
    }
    Ok(query)
}
