//! Reading scenario files.

use super::fault::{LEAST, explained, scenario_texts};
use super::fields::{File, Head, Picture, QueryField, Scene, Vector, Version};
use super::place::{line_and_column, spot_of};
use super::{
    AnyScenario, BUILT_IN, Parameters, Scenario, Source, SourceError, built_in, default_ray,
};
use crate::geometry::{Aabb, Ray, RayError};
use crate::locate::{Direction, DirectionError};
use crate::query::Query;
use crate::scene::{Content, Cube, Image, Sphere};
use crate::text::{Language, Message, Texts};
use crate::tree::{DomainError, MAX_ROOT_LEVEL, Outside, Recipe, outside};
use serde::Deserialize;
use std::sync::LazyLock;
use thiserror::Error;

/// Version of the format that is written, and the newest that is read.
pub const VERSION: u64 = 1;

/// Why a text is no scenario, and where.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("line {line}, column {column}: {fault}")]
pub struct ScenarioError {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// What is wrong there.
    pub fault: Fault,
}

/// What is wrong with a scenario.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Fault {
    /// No JSON, an unknown or missing field, or a value that does not fit; in words of
    /// [`scenario_texts`].
    #[error("{}", .0.told(&IN_ENGLISH))]
    Field(Message),
    /// Neither empty nor an object.
    #[error("this is no scenario; write an object such as {LEAST}")]
    NoObject,
    /// Written by a newer program.
    #[error(
        "the scenario has version {0}, this program reads up to {VERSION}; use a newer program"
    )]
    Newer(u64),
    /// A version that never was.
    #[error("there is no version 0 of the format; write {VERSION}")]
    NoVersion,
    /// Neither plane nor space.
    #[error("the dimension is {0}; give 2 for a quadtree or 3 for an octree")]
    Dimension(u64),
    /// No dimension, and none that follows from the scene.
    #[error("the field ‘dimension’ is missing; give 2 for a quadtree or 3 for an octree")]
    NoDimension,
    /// Not exactly one kind of content.
    #[error(
        "the scene has {0} kinds of content; give exactly one of built-in, points, cells, image, \
         spheres, boxes, triangles and file"
    )]
    Kinds(usize),
    /// A field of the scene that goes with another kind of content.
    #[error("the scene's field ‘{field}’ goes only with ‘{with}’; leave it out")]
    Stray {
        /// The field.
        field: &'static str,
        /// What it belongs to.
        with: &'static str,
    },
    /// Rows or pixels of a picture that are no colours or too many or few.
    #[error(
        "row {0} of the picture, counted from 1, does not fit; give as many rows as ‘height’ says, \
         and in each as many colours of 2 or 6 hexadecimal digits as ‘width’ says"
    )]
    Row(usize),
    /// A picture without a pixel.
    #[error("the picture has no pixels; give a ‘width’ and a ‘height’ of 1 or more")]
    NoPixels,
    /// More levels than codes have bits.
    #[error(
        "{0} is above {MAX_ROOT_LEVEL}, the number of bits of codes; give a number from 0 to {MAX_ROOT_LEVEL}"
    )]
    Level(u64, &'static str),
    /// Nodes without room for anything.
    #[error("the capacity is 0; give 1 or more")]
    Capacity,
    /// Numbers that make no ray.
    #[error(transparent)]
    Ray(#[from] RayError),
    /// Numbers that lead to no neighbour.
    #[error(transparent)]
    Direction(#[from] DirectionError),
    /// The built-in scene or its parameters.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// Domain and depth do not go together.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Points or cells outside the domain that the scenario gives.
    #[error(
        "this item lies outside the domain, the first of {count} that do; enlarge or move the \
         domain, or leave them out"
    )]
    Outside {
        /// Field of the items.
        kind: &'static str,
        /// How many.
        count: usize,
        /// Number of the first, from 0.
        first: usize,
    },
    /// An item with impossible numbers.
    #[error(
        "this item has a negative size or turned corners; give a radius from 0, and no corner \
         ‘min’ above ‘max’"
    )]
    Unusable {
        /// Field of the items.
        kind: &'static str,
        /// Number of the item, from 0.
        item: usize,
    },
}

static IN_ENGLISH: LazyLock<Texts> = LazyLock::new(|| {
    let language = Language::English;
    Texts::new(language, &[scenario_texts(language)])
});

impl Fault {
    /// The same with its place in `text`.
    fn placed(self, text: &str) -> ScenarioError {
        let spot = spot_of(text, &self.path());
        let [line, column] = line_and_column(text, spot.start);
        ScenarioError { line, column, fault: self }
    }

    /// Path of the field that is to blame.
    fn path(&self) -> String {
        match self {
            Self::Field(_) | Self::NoObject | Self::NoDimension => String::new(),
            Self::Newer(_) | Self::NoVersion => "octoscope".to_owned(),
            Self::Dimension(_) => "dimension".to_owned(),
            Self::Kinds(_) => "scene".to_owned(),
            Self::Stray { field, .. } => format!("scene.{field}"),
            Self::NoPixels => "scene.image".to_owned(),
            Self::Row(row) => format!("scene.image.rows[{}]", row.saturating_sub(1)),
            Self::Source(source) => match source {
                SourceError::Unknown { .. }
                | SourceError::Dimension { .. }
                | SourceError::NotRead(_) => "scene.built-in".to_owned(),
                SourceError::NoParameter { parameter, .. } => {
                    format!("scene.parameters.{parameter}")
                }
                SourceError::Range { .. } => "scene.parameters.n".to_owned(),
            },
            Self::Level(_, path) => (*path).to_owned(),
            Self::Capacity => "build.capacity".to_owned(),
            Self::Ray(RayError::NotFinite) => "ray".to_owned(),
            Self::Ray(RayError::ZeroDirection) => "ray.direction".to_owned(),
            Self::Direction(_) => "query.neighbour.direction".to_owned(),
            Self::Domain(DomainError::NotABox) => "domain".to_owned(),
            Self::Domain(DomainError::TooDeep(_) | DomainError::TooFine) => "build".to_owned(),
            Self::Unusable { kind, item } | Self::Outside { kind, first: item, .. } => {
                format!("scene.{kind}[{item}]")
            }
        }
    }
}

impl AnyScenario {
    /// Scenario written in `text`, the JSON of an `.octo` file.
    ///
    /// Only `octoscope`, `scene` and, unless the scene is built in,
    /// `dimension` must be there. Whatever is missing comes from the built-in
    /// scenario, or fits the content.
    ///
    /// # Errors
    /// See [`ScenarioError`].
    pub fn parse(text: &str) -> Result<Self, ScenarioError> {
        if text.trim_start().starts_with(|c| c != '{') {
            return Err(Fault::NoObject.placed(text));
        }
        let version = read::<Version>(text, None)?.octoscope;
        if version > VERSION {
            return Err(Fault::Newer(version).placed(text));
        }
        if version == 0 {
            return Err(Fault::NoVersion.placed(text));
        }
        let head: Head = read(text, None)?;
        let name = head.scene.built_in.as_deref();
        let known = BUILT_IN.iter().find(|entry| Some(entry.id) == name);
        let fault = match head.dimension.or(known.map(|entry| entry.dimension as u64)) {
            Some(2) => return read_as(text).map(Self::Quadtree),
            Some(3) => return read_as(text).map(Self::Octree),
            Some(other) => Fault::Dimension(other),
            None => match name {
                Some(name) => built_in::unknown(name).into(),
                None => Fault::NoDimension,
            },
        };
        Err(fault.placed(text))
    }
}

/// Scenario of dimension `D` written in `text`.
fn read_as<const D: usize>(text: &str) -> Result<Scenario<D>, ScenarioError> {
    scenario(read::<File<D>>(text, Some(D))?).map_err(|fault| fault.placed(text))
}

fn read<'a, T: Deserialize<'a>>(
    text: &'a str,
    dimension: Option<usize>,
) -> Result<T, ScenarioError> {
    serde_json::from_str(text).map_err(|error| explained(&error, text, dimension))
}

fn scenario<const D: usize>(file: File<D>) -> Result<Scenario<D>, Fault> {
    let mut source = source(file.scene)?;
    let mut scenario = match &source {
        Source::BuiltIn { name, parameters } => built_in::checked(name, *parameters)?,
        Source::Inline(content) => {
            if let Some(item) = content.first_unusable() {
                return Err(Fault::Unusable { kind: field(content), item });
            }
            Scenario::with_defaults(source.clone(), content.fit())
        }
        Source::File { .. } => Scenario::with_defaults(source.clone(), Cube::UNIT),
    };
    if let Source::File { fit, .. } = &mut source {
        *fit = file.domain.is_none();
    }
    scenario.source = source;
    if let Some(domain) = file.domain {
        // A ray that was left open follows a domain that was not.
        let domain = Cube { min: domain.min.0, side: domain.side };
        domain.cut(0)?;
        let moved = domain != scenario.domain;
        scenario.domain = domain;
        scenario.ray = if moved { default_ray(&domain) } else { scenario.ray };
    }
    if let Some(ray) = file.ray {
        scenario.ray = Ray::new(ray.origin.0, ray.direction.0)?;
    }

    let recipe = &mut scenario.recipe;
    *recipe = Recipe {
        depth: match file.build.depth {
            Some(depth) => level(depth, "build.depth")?,
            None => recipe.depth,
        },
        capacity: match file.build.capacity {
            Some(0) => return Err(Fault::Capacity),
            Some(capacity) => capacity,
            None => recipe.capacity,
        },
        merge: file.build.merge.unwrap_or(recipe.merge),
        threshold: file.build.threshold.unwrap_or(recipe.threshold),
        fill: file.build.fill.unwrap_or(recipe.fill),
    };

    let of_rays = file.algorithm.is_some() || file.options.is_some() || file.arithmetic.is_some();
    scenario.query = match file.query {
        None if !of_rays => scenario.query,
        None | Some(QueryField::Ray) => Query::Ray {
            algorithm: file.algorithm.unwrap_or_default(),
            options: file.options.unwrap_or_default(),
            arithmetic: file.arithmetic.unwrap_or_default(),
        },
        Some(QueryField::Point { at, method, variants }) => {
            Query::Point { at: at.0, method, variants }
        }
        Some(QueryField::Region { min, max, variants }) => {
            Query::Region { min: min.0, max: max.0, variants }
        }
        Some(QueryField::Neighbour { level: of, code, direction, reach, method, variants }) => {
            Query::Neighbour {
                level: level(of, "query.neighbour.level")?,
                code: code.0,
                direction: Direction::new(direction.0)?,
                reach,
                method,
                variants,
            }
        }
    };
    scenario.step = file.step.map_or(scenario.step, |step| step.0);
    scenario.view = file.view;
    let domain = scenario.grid()?;
    if let Source::Inline(content) = &scenario.source
        && let Some(Outside { count, first }) = outside(content, &domain)
    {
        return Err(Fault::Outside { kind: field(content), count, first });
    }
    Ok(scenario)
}

/// Level or depth `number`, which stands at `path`.
fn level(number: u64, path: &'static str) -> Result<u8, Fault> {
    let fits = u8::try_from(number).ok().filter(|&level| level <= MAX_ROOT_LEVEL);
    fits.ok_or(Fault::Level(number, path))
}

fn source<const D: usize>(scene: Scene<D>) -> Result<Source<D>, Fault> {
    let all = |vectors: Vec<Vector<f64, D>>| vectors.into_iter().map(|v| v.0).collect();
    let stray = |field, with| Err(Fault::Stray { field, with });
    if scene.parameters.is_some() && scene.built_in.is_none() {
        return stray("parameters", "built-in");
    }
    if scene.hash.is_some() && scene.file.is_none() {
        return stray("hash", "file");
    }
    let parameters: Parameters = scene.parameters.unwrap_or_default();
    let hash = scene.hash.unwrap_or_default();
    let mut kinds = Vec::new();
    kinds.extend(scene.built_in.map(|name| Source::BuiltIn { name, parameters }));
    kinds.extend(scene.file.map(|path| Source::File { path, hash, fit: false }));
    let mut inline = Vec::new();
    inline.extend(scene.points.map(|points| Content::Points(all(points))));
    inline.extend(scene.cells.map(|c| Content::Cells(c.into_iter().map(|v| v.0).collect())));
    if let Some(image) = scene.image {
        inline.push(Content::Image(picture(&image)?));
    }
    inline.extend(scene.spheres.map(|spheres| {
        let sphere = spheres.into_iter().map(|s| Sphere { centre: s.centre.0, radius: s.radius });
        Content::Spheres(sphere.collect())
    }));
    inline.extend(scene.boxes.map(|boxes| {
        Content::Boxes(boxes.into_iter().map(|b| Aabb { min: b.min.0, max: b.max.0 }).collect())
    }));
    inline.extend(scene.triangles.map(|triangles| {
        Content::Triangles(triangles.into_iter().map(|t| t.map(|corner| corner.0)).collect())
    }));
    kinds.extend(inline.into_iter().map(Source::Inline));
    let count = kinds.len();
    match (kinds.pop(), count) {
        (Some(source), 1) => Ok(source),
        _ => Err(Fault::Kinds(count)),
    }
}

/// Field of the scene that holds such content.
fn field<const D: usize>(content: &Content<D>) -> &'static str {
    match content {
        Content::Points(_) => "points",
        Content::Cells(_) => "cells",
        Content::Image(_) => "image",
        Content::Spheres(_) => "spheres",
        Content::Boxes(_) => "boxes",
        Content::Triangles(_) => "triangles",
    }
}

fn picture(picture: &Picture) -> Result<Image, Fault> {
    let mut pixels = Vec::new();
    if picture.width == 0 || picture.height == 0 {
        return Err(Fault::NoPixels);
    }
    if picture.rows.len() != picture.height as usize {
        return Err(Fault::Row(picture.rows.len().min(picture.height as usize) + 1));
    }
    for (number, row) in picture.rows.iter().enumerate() {
        let colours: Option<Vec<[u8; 3]>> = row.split_whitespace().map(colour).collect();
        let fitting = colours.filter(|colours| colours.len() == picture.width as usize);
        pixels.extend(fitting.ok_or(Fault::Row(number + 1))?);
    }
    Ok(Image { width: picture.width, height: picture.height, pixels })
}

/// Two (grey) or six hexadecimal digits.
fn colour(digits: &str) -> Option<[u8; 3]> {
    if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
        return None;
    }
    let channel = |from: usize| u8::from_str_radix(digits.get(from..from + 2)?, 16).ok();
    match digits.len() {
        2 => channel(0).map(|grey| [grey; 3]),
        6 => Some([channel(0)?, channel(2)?, channel(4)?]),
        _ => None,
    }
}
