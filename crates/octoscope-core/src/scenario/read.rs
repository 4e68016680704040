//! Reading scenario files.

use super::fields::{File, Head, Picture, QueryField, Scene, Vector};
use super::{
    AnyScenario, BUILT_IN, Parameters, Scenario, Source, SourceError, built_in, default_ray,
};
use crate::geometry::Aabb;
use crate::query::Query;
use crate::scene::{Content, Cube, Image, Sphere};
use crate::tree::{DomainError, Recipe};
use thiserror::Error;

/// Version of the format that is written, and the newest that is read.
pub const VERSION: u64 = 1;

/// Why a text is no scenario.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ScenarioError {
    /// No JSON, an unknown or missing field, or a value that does not fit;
    /// the message ends with line and column.
    #[error("{0}")]
    Field(String),
    /// Written by a newer program.
    #[error(
        "the scenario has version {0}, this program reads up to {VERSION}; use a newer program"
    )]
    Newer(u64),
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
    #[error("row {0} of the picture (counted from 1) has not as many colours as its width says")]
    Row(usize),
    /// The built-in scene or its parameters.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// Domain and depth do not go together.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// An item with impossible numbers.
    #[error("item number {0} of the scene (counted from 0) has a negative size or turned corners")]
    Unusable(usize),
}

impl From<serde_json::Error> for ScenarioError {
    fn from(error: serde_json::Error) -> Self {
        Self::Field(error.to_string())
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
        let head: Head = serde_json::from_str(text)?;
        if head.octoscope > VERSION {
            return Err(ScenarioError::Newer(head.octoscope));
        }
        let name = head.scene.built_in.as_deref();
        let known = BUILT_IN.iter().find(|entry| Some(entry.id) == name);
        match head.dimension.or(known.map(|entry| entry.dimension as u64)) {
            Some(2) => Ok(Self::Quadtree(scenario(serde_json::from_str(text)?)?)),
            Some(3) => Ok(Self::Octree(scenario(serde_json::from_str(text)?)?)),
            Some(other) => Err(ScenarioError::Dimension(other)),
            None => match name {
                Some(name) => Err(built_in::unknown(name).into()),
                None => Err(ScenarioError::NoDimension),
            },
        }
    }
}

fn scenario<const D: usize>(file: File<D>) -> Result<Scenario<D>, ScenarioError> {
    let mut source = source(file.scene)?;
    let mut scenario = match &source {
        Source::BuiltIn { name, parameters } => built_in::checked(name, *parameters)?,
        Source::Inline(content) => {
            if let Some(item) = content.first_unusable() {
                return Err(ScenarioError::Unusable(item));
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
        let moved = domain.0 != scenario.domain;
        scenario.domain = domain.0;
        scenario.ray = if moved { default_ray(&domain.0) } else { scenario.ray };
    }
    if let Some(ray) = file.ray {
        scenario.ray = ray.0;
    }

    let recipe = &mut scenario.recipe;
    *recipe = Recipe {
        depth: file.build.depth.map_or(recipe.depth, |depth| depth.0),
        capacity: file.build.capacity.map_or(recipe.capacity, |capacity| capacity.0),
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
        Some(QueryField::Point { at, method }) => Query::Point { at: at.0, method },
        Some(QueryField::Region { min, max }) => Query::Region { min: min.0, max: max.0 },
        Some(QueryField::Neighbour { level, code, direction, reach, method }) => {
            let (level, code, direction) = (level.0, code.0, direction.0);
            Query::Neighbour { level, code, direction, reach, method }
        }
    };
    scenario.step = file.step.map_or(scenario.step, |step| step.0);
    scenario.view = file.view;
    scenario.grid()?;
    Ok(scenario)
}

fn source<const D: usize>(scene: Scene<D>) -> Result<Source<D>, ScenarioError> {
    let all = |vectors: Vec<Vector<f64, D>>| vectors.into_iter().map(|v| v.0).collect();
    let stray = |field, with| Err(ScenarioError::Stray { field, with });
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
        _ => Err(ScenarioError::Kinds(count)),
    }
}

fn picture(picture: &Picture) -> Result<Image, ScenarioError> {
    let mut pixels = Vec::new();
    if picture.rows.len() != picture.height as usize {
        return Err(ScenarioError::Row(picture.rows.len().min(picture.height as usize) + 1));
    }
    for (number, row) in picture.rows.iter().enumerate() {
        let colours: Option<Vec<[u8; 3]>> = row.split_whitespace().map(colour).collect();
        let fitting = colours.filter(|colours| colours.len() == picture.width as usize);
        pixels.extend(fitting.ok_or(ScenarioError::Row(number + 1))?);
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
