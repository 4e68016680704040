//! `octoscope visit`: many rays through one tree.

mod batch;
mod check;
mod in_order;
mod line;
mod summary;

use super::values::{number, whole};
use super::{Answer, tell};
use crate::files::{self, Output};
use anyhow::anyhow;
use clap::Args;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scene::Content;
use octoscope_core::traverse::{Algorithm, Method, MethodError, Options, StopAt, Variants};
use octoscope_core::tree::{Domain, MAX_ROOT_LEVEL, Merge, Recipe, Tree, build};
use std::fmt::Display;
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

/// Prints the leaves on many rays through one tree.
///
/// The tree is the region quadtree or octree of the occupied cells, over the
/// domain [0, 1). For each ray, in order, one line: the number of leaves, then
/// level:x,y,z for each leaf, with the codes of its minimum corner and level 0
/// for the smallest cell; a * marks an occupied leaf. A ray that misses gives 0.
///
/// A leaf is on the ray if a part of positive length with t ≥ 0 is in it. In
/// doubles, leaves that hold less than 1e-12 of the root's side may be there or
/// not.
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:\n  \
    octoscope visit --cells a.cells --depth 6 --rays a.rays\n  \
    octoscope visit --cells a.cells --depth 6 --rays a.rays --algorithm all --exact\n  \
    octoscope visit --cells a.cells --depth 6 --rays a.rays --summary --repeat 9")]
pub struct Visit {
    /// Occupied cells: one a line, integers from 0 to 2^depth − 1 between
    /// blanks; # starts a comment. Without any cell, the tree is one empty leaf.
    #[arg(long, value_name = "FILE")]
    cells: PathBuf,
    /// Levels below the root, 0 to 20; the domain has 2^depth cells along each
    /// axis.
    #[arg(long, value_name = "N", value_parser = depth, allow_hyphen_values = true)]
    depth: u8,
    /// Rays: one a line, origin and direction, decimal or hexadecimal floats;
    /// # starts a comment. Without any ray, nothing is printed.
    #[arg(long, value_name = "FILE")]
    rays: PathBuf,
    /// Dimension: 2 for a quadtree, 3 for an octree.
    #[arg(long, value_name = "N", default_value = "3", value_parser = dimension, allow_hyphen_values = true)]
    dim: Dimension,
    /// Identifier of the algorithm (see octoscope scenes), with @ and variants
    /// as in bsp@gem or, with commas between several, parametric@B-1,B-3; or all: runs
    /// every one, prints what the oracle finds, and fails where one differs from it;
    /// or batch: many rays at once, always exactly, by the kernel that is made for
    /// speed and that no debugger shows.
    #[arg(long, value_name = "ID", default_value = "parametric")]
    algorithm: Choice,
    /// Ends each ray at its first occupied leaf.
    #[arg(long)]
    first: bool,
    /// Ends each ray at this parameter t.
    #[arg(long, value_name = "T", value_parser = number, allow_hyphen_values = true)]
    end: Option<f64>,
    /// Lists leaves met in one point as well, as ~level:x,y,z; they do not
    /// count. Algorithms report the touches that they notice, the oracle all.
    #[arg(long)]
    touches: bool,
    /// Does not merge full nodes: every occupied cell stays a leaf of level 0.
    #[arg(long)]
    keep_cells: bool,
    /// Compares exactly, whatever the (finite) numbers.
    #[arg(long)]
    exact: bool,
    /// Number of threads; the output stays in order.
    #[arg(long, value_name = "N", default_value = "1", value_parser = threads, allow_hyphen_values = true)]
    threads: NonZeroUsize,
    /// Prints for each algorithm the number of rays, of leaves and of occupied
    /// leaves, a checksum of the output (FNV-1a, 64 bits) and the time that the
    /// traversals alone take. In that of dda every cell is looked up in the
    /// tree, which stands in for the array of a grid.
    #[arg(long)]
    summary: bool,
    /// How often the summary measures.
    #[arg(long, value_name = "N", default_value = "5", requires = "summary", value_parser = repeat, allow_hyphen_values = true)]
    repeat: NonZeroUsize,
    /// Writes to this file, which appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Of what the tree is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Dimension {
    Plane,
    Space,
}

fn depth(text: &str) -> Result<u8, String> {
    let why = format!("location codes have {MAX_ROOT_LEVEL} bits here");
    whole(text, 0..=MAX_ROOT_LEVEL.into(), &why)
}

fn dimension(text: &str) -> Result<Dimension, &'static str> {
    match text {
        "2" => Ok(Dimension::Plane),
        "3" => Ok(Dimension::Space),
        _ => Err("give 2 for a quadtree or 3 for an octree"),
    }
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let count = whole::<usize>(text, 1..=1024, "more threads would only wait for each other")?;
    Ok(NonZeroUsize::new(count).unwrap_or(NonZeroUsize::MIN))
}

fn repeat(text: &str) -> Result<NonZeroUsize, String> {
    let count = whole::<usize>(text, 1..=1_000_000, "")?;
    Ok(NonZeroUsize::new(count).unwrap_or(NonZeroUsize::MIN))
}

/// One algorithm or every one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    One(Method),
    All,
    /// Many rays at once.
    Batch,
}

impl std::str::FromStr for Choice {
    type Err = String;

    fn from_str(id: &str) -> Result<Self, String> {
        match id.split_once('@') {
            None if id == "all" => Ok(Self::All),
            None if id == batch::BATCH => Ok(Self::Batch),
            Some((several @ ("all" | batch::BATCH), _)) => {
                Err(format!("‘{several}’ runs without variants; name one algorithm for them"))
            }
            _ => id.parse().map(Self::One).map_err(|error: MethodError| error.to_string()),
        }
    }
}

impl Choice {
    fn methods(self) -> Vec<Method> {
        match self {
            Self::One(method) => vec![method],
            Self::All => Algorithm::ALL.map(Method::from).to_vec(),
            Self::Batch => Vec::new(),
        }
    }
}

/// What is asked of every ray.
#[derive(Clone, Copy, Debug)]
struct Asked {
    stop_at: StopAt,
    segment_end: Option<f64>,
    arithmetic: Arithmetic,
    touches: Touches,
}

impl Asked {
    /// The question to a tree, by this method.
    fn along<const D: usize>(self, Method { algorithm, variants }: Method) -> Query<D> {
        let options = self.options(variants);
        Query::Ray { algorithm, options, arithmetic: self.arithmetic }
    }

    fn options(self, variants: Variants) -> Options {
        let Self { stop_at, segment_end, .. } = self;
        Options { stop_at, segment_end, variants }
    }
}

/// Whether touches are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Touches {
    Listed,
    LeftOut,
}

/// Runs the command.
///
/// # Errors
/// Says what is wrong with a file, and where.
pub fn visit(arguments: &Visit) -> anyhow::Result<Answer> {
    match arguments.dim {
        Dimension::Plane => visit_in::<2>(arguments),
        Dimension::Space => visit_in::<3>(arguments),
    }
}

fn visit_in<const D: usize>(arguments: &Visit) -> anyhow::Result<Answer> {
    let tree = read_tree::<D>(arguments)?;
    let rays = read_rays::<D>(&arguments.rays)?;
    let methods: Result<Vec<Method>, _> =
        arguments.algorithm.methods().into_iter().map(|method| method.in_dimension(D)).collect();
    let methods = methods?;
    let asked = Asked {
        stop_at: if arguments.first { StopAt::FirstFull } else { StopAt::End },
        segment_end: arguments.end,
        arithmetic: if arguments.exact { Arithmetic::Exact } else { Arithmetic::Doubles },
        touches: if arguments.touches { Touches::Listed } else { Touches::LeftOut },
    };
    if arguments.algorithm == Choice::Batch {
        return visit_at_once(arguments, &tree, &rays, asked);
    }
    let mut output = Output::open(arguments.output.as_deref())?;
    let threads = arguments.threads;
    let mut differences = check::Differences::default();
    if arguments.summary {
        let mut rows = Vec::new();
        for &method in &methods {
            let measured =
                summary::measure(&tree, &rays, method, asked, threads, arguments.repeat)?;
            rows.push(measured);
        }
        output.write_all(summary::table(&rows).as_bytes())?;
    }
    let prints = !arguments.summary;
    if prints || methods.len() > 1 {
        let work = |rays: &[Ray<D>]| {
            let mut lines = String::new();
            let compared = rays
                .iter()
                .map(|ray| check::push_compared_line(&mut lines, &tree, ray, &methods, asked));
            let found: Vec<Option<String>> = compared.collect();
            (lines, found)
        };
        let mut n_rays = 0;
        in_order::in_order(&rays, threads, work, |(lines, found)| {
            for difference in found {
                differences.add(n_rays, &rays[n_rays], difference);
                n_rays += 1;
            }
            if prints { output.write_all(lines.as_bytes()) } else { Ok(()) }
        })?;
    }
    output.finish()?;
    Ok(differences.answer(rays.len()))
}

/// The same by the kernel for many rays.
fn visit_at_once<const D: usize>(
    arguments: &Visit,
    tree: &Tree<D>,
    rays: &[Ray<D>],
    Asked { stop_at, segment_end, touches, .. }: Asked,
) -> anyhow::Result<Answer> {
    if segment_end.is_some() || touches == Touches::Listed {
        let remedy = "leave out --end and --touches, or choose an algorithm";
        return Err(anyhow!("batch visits whole rays and notices no touches; {remedy}"));
    }
    let threads = arguments.threads;
    let mut output = Output::open(arguments.output.as_deref())?;
    if arguments.summary {
        let row = batch::measure(tree, rays, stop_at, threads, arguments.repeat)?;
        output.write_all(summary::table(&[row]).as_bytes())?;
    } else {
        batch::lines(tree, rays, stop_at, threads, |(lines, _)| {
            output.write_all(lines.as_bytes())
        })?;
    }
    output.finish()?;
    Ok(Answer::Done)
}

fn read_tree<const D: usize>(arguments: &Visit) -> anyhow::Result<Tree<D>> {
    let path = &arguments.cells;
    let cells = octoscope_import::cells::<D>(&files::read_text(path)?, arguments.depth)
        .map_err(|error| in_file(error, path))?;
    if cells.is_empty() {
        tell(&format!("there is no cell, so the tree is one empty leaf: {}", path.display()));
    }
    let recipe = Recipe {
        depth: arguments.depth,
        merge: if arguments.keep_cells { Merge::Kept } else { Merge::Whole },
        ..Recipe::default()
    };
    let domain = Domain::unit(arguments.depth);
    build(&Content::Cells(cells), domain, &recipe, &Progress::default())
        .map_err(|error| in_file(error, path))
}

fn read_rays<const D: usize>(path: &Path) -> anyhow::Result<Vec<Ray<D>>> {
    let rays = octoscope_import::rays::<D>(&files::read_text(path)?);
    let rays = rays.map_err(|error| in_file(error, path))?;
    if rays.is_empty() {
        tell(&format!("there is no ray, so nothing is visited: {}", path.display()));
    }
    Ok(rays)
}

/// The fact first, the path last.
fn in_file(error: impl Display, path: &Path) -> anyhow::Error {
    anyhow!("{error}: {}", path.display())
}
