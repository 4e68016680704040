//! The scenarios that come with the program.

use super::{AnyScenario, Parameters, Scenario, Source, SourceError, StepAt, View};
use crate::geometry::Ray;
use crate::query::{PointMethod, Query};
use crate::scene::{Content, Cube, made};
use crate::traverse::Variants;
use crate::tree::{Merge, Recipe};

/// A scenario that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuiltIn {
    /// Its name.
    pub id: &'static str,
    /// 2 or 3.
    pub dimension: usize,
    /// Seed of its random numbers, if it has any.
    pub seed: Option<u64>,
    /// What parameter `n` is at first and at most, if it has one.
    pub n: Option<[u32; 2]>,
}

/// All of them: the one to begin with first, then the plane, then space.
pub const BUILT_IN: [BuiltIn; 13] = [
    BuiltIn { id: "quadtree-82", dimension: 2, seed: Some(6), n: Some([82, 1_000_000]) },
    BuiltIn { id: "figure-1", dimension: 2, seed: None, n: None },
    BuiltIn { id: "checker-cells", dimension: 2, seed: None, n: Some([4, 10]) },
    BuiltIn { id: "rings", dimension: 2, seed: None, n: Some([256, 4096]) },
    BuiltIn { id: "figure-7", dimension: 3, seed: None, n: None },
    BuiltIn { id: "points-3d", dimension: 3, seed: Some(3), n: Some([300, 1_000_000]) },
    BuiltIn { id: "sphere-grid", dimension: 3, seed: None, n: Some([3, 6]) },
    BuiltIn { id: "cloud", dimension: 3, seed: Some(0xC10D), n: Some([1890, 100_000]) },
    BuiltIn { id: "cylinders", dimension: 3, seed: Some(0xC1), n: Some([4320, 20_000]) },
    BuiltIn { id: "objects", dimension: 3, seed: Some(0x0B), n: Some([4350, 20_000]) },
    BuiltIn { id: "spheres-512", dimension: 3, seed: None, n: None },
    BuiltIn { id: "spheres-4096", dimension: 3, seed: None, n: None },
    BuiltIn { id: "spheres-32768", dimension: 3, seed: None, n: None },
];

/// The built-in scenario of this name with its own parameters.
pub fn built_in(id: &str) -> Option<AnyScenario> {
    let entry = BUILT_IN.iter().find(|entry| entry.id == id)?;
    Some(match entry.dimension {
        2 => AnyScenario::Quadtree(scenario(entry, Parameters::default())),
        _ => AnyScenario::Octree(scenario(entry, Parameters::default())),
    })
}

/// No scene has this name.
pub(super) fn unknown(name: &str) -> SourceError {
    let known = BUILT_IN.map(|entry| entry.id).join(", ");
    SourceError::Unknown { name: name.to_owned(), known }
}

/// The entry of a scene for dimension `D`, and its `n`.
fn find<const D: usize>(
    name: &str,
    parameters: Parameters,
) -> Result<(&'static BuiltIn, u32), SourceError> {
    let entry = BUILT_IN.iter().find(|entry| entry.id == name).ok_or_else(|| unknown(name))?;
    if entry.dimension != D {
        let (name, has) = (name.to_owned(), entry.dimension);
        return Err(SourceError::Dimension { name, has, asked: D });
    }
    let refuse = |parameter| SourceError::NoParameter { name: name.to_owned(), parameter };
    if entry.seed.is_none() && parameters.seed.is_some() {
        return Err(refuse("seed"));
    }
    let n = match (entry.n, parameters.n) {
        (None, None) => 0,
        (None, Some(_)) => return Err(refuse("n")),
        (Some([usual, _]), None) => usual,
        (Some([_, most]), Some(n)) if (1..=most).contains(&n) => n,
        (Some([_, most]), Some(n)) => {
            return Err(SourceError::Range { name: name.to_owned(), n, most });
        }
    };
    Ok((entry, n))
}

/// The scenario of the scene `name` with these parameters.
pub(super) fn checked<const D: usize>(
    name: &str,
    parameters: Parameters,
) -> Result<Scenario<D>, SourceError> {
    find::<D>(name, parameters).map(|(entry, _)| scenario(entry, parameters))
}

/// Content of the scene `name`.
pub(super) fn content<const D: usize>(
    name: &str,
    parameters: Parameters,
) -> Result<Content<D>, SourceError> {
    let (entry, n) = find::<D>(name, parameters)?;
    let seed = parameters.seed.or(entry.seed).unwrap_or(0);
    Ok(match entry.id {
        "quadtree-82" | "points-3d" => made::clustered_points(seed, n),
        "figure-1" => Content::Points(FIGURE_1.map(|p| first_of(p.map(|x| x / 32.0))).to_vec()),
        "checker-cells" => made::chequered_cells(n),
        "rings" => Content::Image(made::rings(n)),
        "figure-7" => Content::Cells(vec![first_of([0, 1, 0])]),
        "sphere-grid" => made::sphere_grid(n),
        "cloud" => made::cloud(seed, n),
        "cylinders" => in_space(made::cylinders_and_spheres(seed, n)),
        "objects" => in_space(made::objects(seed, n)),
        "spheres-512" => made::sphere_grid(3),
        "spheres-4096" => made::sphere_grid(4),
        "spheres-32768" => made::sphere_grid(5),
        other => unreachable!("‘{other}’ is in the list without content"),
    })
}

/// Content of space as that of dimension `D`, which is 3.
fn in_space<const D: usize>(content: Content<3>) -> Content<D> {
    let Content::Triangles(triangles) = content else {
        unreachable!("solids are made of triangles")
    };
    Content::Triangles(triangles.into_iter().map(|t| t.map(first_of)).collect())
}

/// Points whose quadtree of capacity 1 and 5 levels has, along the x axis, the
/// cells of the report's binary tree: [0, 1/4), [1/4, 1/2), [1/2, 5/8) and so
/// on; in thirty-seconds [Frisken, Perry 2002, figure 1].
const FIGURE_1: [[f64; 2]; 9] = [
    [3.0, 4.0],
    [12.0, 3.0],
    [18.0, 2.0],
    [21.0, 1.0],
    [22.5, 0.5],
    [23.5, 1.5],
    [28.0, 3.0],
    [8.0, 24.0],
    [24.0, 22.0],
];

/// The first D of some numbers; what is missing is the default.
fn first_of<T: Copy + Default, const N: usize, const D: usize>(numbers: [T; N]) -> [T; D] {
    std::array::from_fn(|e| numbers.get(e).copied().unwrap_or_default())
}

/// The scenario of an entry whose dimension is `D`.
fn scenario<const D: usize>(entry: &BuiltIn, parameters: Parameters) -> Scenario<D> {
    let n = parameters.n.or(entry.n.map(|[usual, _]| usual)).unwrap_or(0);
    let mut domain = Cube::UNIT;
    let mut recipe = Recipe::default();
    let mut query = Query::default();
    let mut ray = ([-0.16, 0.13, 0.2], [1.0, 0.62, 0.41]);
    match entry.id {
        "quadtree-82" => recipe = Recipe { depth: 5, capacity: 2, ..recipe },
        "figure-1" => {
            recipe = Recipe { depth: 5, capacity: 1, ..recipe };
            // The report locates 0.55 on the axis.
            let (at, method) = (first_of([0.55, 0.1]), PointMethod::Codes);
            query = Query::Point { at, method, variants: Variants::NONE };
            ray = ([-0.125, 0.046_875, 0.0], [1.0, 0.0625, 0.0]);
        }
        "checker-cells" => recipe.depth = n as u8,
        "rings" => {
            let side = f64::from(n.next_power_of_two());
            domain.side = side;
            recipe.depth = (n.next_power_of_two().ilog2() as u8).clamp(1, 7);
            ray = (ray.0.map(|x| x * side), ray.1.map(|x| x * side));
        }
        "figure-7" => {
            recipe.depth = 1;
            ray = ([1.5, 0.125, 0.25], [-1.0, 0.5, 0.0625]);
        }
        "points-3d" => recipe = Recipe { depth: 5, capacity: 4, ..recipe },
        "sphere-grid" => {
            recipe.depth = n as u8 + 3;
            ray = ([-0.25, 0.1, 0.15], [1.0, 0.5, 0.45]);
        }
        "cloud" => recipe.depth = 7,
        // Of many small spheres every cell would be full, and the tree one leaf.
        "cylinders" | "objects" | "spheres-512" | "spheres-4096" | "spheres-32768" => {
            recipe.merge = Merge::Kept;
            ray = ([-0.25, 0.1, 0.15], [1.0, 0.5, 0.45]);
        }
        other => unreachable!("‘{other}’ is in the list without a scenario"),
    }
    let ray = Ray::new(first_of(ray.0), first_of(ray.1));
    Scenario {
        domain,
        source: Source::BuiltIn { name: entry.id.to_owned(), parameters },
        recipe,
        ray: ray.expect("the rays of the list are finite and not zero"),
        query,
        step: StepAt::First,
        view: View::new(),
    }
}
