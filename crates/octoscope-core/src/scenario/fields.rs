//! Fields of a scenario file, as JSON has them.

use super::{Parameters, StepAt, View};
use crate::geometry::Ray;
use crate::locate::{Direction, NeighbourMethod, Reach};
use crate::query::{Arithmetic, PointMethod};
use crate::scene::Cube;
use crate::traverse::{Algorithm, Options};
use crate::tree::{Fill, MAX_ROOT_LEVEL, Merge};
use serde::Deserialize;
use serde::de::{Deserializer, Error, IgnoredAny, SeqAccess, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// What has to be known before the rest can be read.
#[derive(Deserialize)]
pub(super) struct Head {
    pub octoscope: u64,
    pub dimension: Option<u64>,
    pub scene: HeadScene,
}

/// Name of the scene, if it is built in.
#[derive(Deserialize)]
pub(super) struct HeadScene {
    #[serde(rename = "built-in")]
    pub built_in: Option<String>,
}

/// The whole file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File<const D: usize> {
    #[serde(rename = "octoscope")]
    _version: IgnoredAny,
    #[serde(rename = "dimension")]
    _dimension: Option<IgnoredAny>,
    pub domain: Option<DomainField<D>>,
    pub scene: Scene<D>,
    #[serde(default)]
    pub build: Build,
    pub ray: Option<RayField<D>>,
    pub query: Option<QueryField<D>>,
    pub algorithm: Option<Algorithm>,
    pub options: Option<Options>,
    pub arithmetic: Option<Arithmetic>,
    pub step: Option<Step>,
    #[serde(default)]
    pub view: View,
}

/// Exactly one of the kinds of content.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct Scene<const D: usize> {
    pub built_in: Option<String>,
    pub parameters: Option<Parameters>,
    pub points: Option<Vec<Vector<f64, D>>>,
    pub cells: Option<Vec<Vector<u32, D>>>,
    pub image: Option<Picture>,
    pub spheres: Option<Vec<Ball<D>>>,
    pub boxes: Option<Vec<Corners<D>>>,
    pub triangles: Option<Vec<[Vector<f64, D>; 3]>>,
    pub file: Option<String>,
    pub hash: Option<String>,
}

/// Rows from the top; a pixel is two (grey) or six hexadecimal digits.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Picture {
    pub width: u32,
    pub height: u32,
    pub rows: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Ball<const D: usize> {
    pub centre: Vector<f64, D>,
    pub radius: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Corners<const D: usize> {
    pub min: Vector<f64, D>,
    pub max: Vector<f64, D>,
}

/// What is missing keeps its default.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Build {
    pub depth: Option<Depth>,
    pub capacity: Option<Capacity>,
    pub merge: Option<Merge>,
    pub threshold: Option<u8>,
    pub fill: Option<Fill>,
}

#[derive(Deserialize)]
#[serde(try_from = "u64")]
pub(super) struct Depth(pub u8);

impl TryFrom<u64> for Depth {
    type Error = String;

    fn try_from(depth: u64) -> Result<Self, String> {
        let most = MAX_ROOT_LEVEL;
        let fits = u8::try_from(depth).ok().filter(|&d| d <= most);
        fits.map(Self)
            .ok_or_else(|| format!("the depth is {depth}; give a number from 0 to {most}"))
    }
}

#[derive(Deserialize)]
#[serde(try_from = "u32")]
pub(super) struct Capacity(pub u32);

impl TryFrom<u32> for Capacity {
    type Error = &'static str;

    fn try_from(capacity: u32) -> Result<Self, &'static str> {
        if capacity == 0 { Err("the capacity is 0; give 1 or more") } else { Ok(Self(capacity)) }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DomainNumbers<const D: usize> {
    min: Vector<f64, D>,
    side: f64,
}

#[derive(Deserialize)]
#[serde(try_from = "DomainNumbers<D>")]
pub(super) struct DomainField<const D: usize>(pub Cube<D>);

impl<const D: usize> TryFrom<DomainNumbers<D>> for DomainField<D> {
    type Error = crate::tree::DomainError;

    fn try_from(numbers: DomainNumbers<D>) -> Result<Self, Self::Error> {
        let cube = Cube { min: numbers.min.0, side: numbers.side };
        cube.cut(0).map(|_| Self(cube))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RayNumbers<const D: usize> {
    origin: Vector<f64, D>,
    direction: Vector<f64, D>,
}

#[derive(Deserialize)]
#[serde(try_from = "RayNumbers<D>")]
pub(super) struct RayField<const D: usize>(pub Ray<D>);

impl<const D: usize> TryFrom<RayNumbers<D>> for RayField<D> {
    type Error = crate::geometry::RayError;

    fn try_from(numbers: RayNumbers<D>) -> Result<Self, Self::Error> {
        Ray::new(numbers.origin.0, numbers.direction.0).map(Self)
    }
}

/// `"ray"`, or one of the others with its numbers.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) enum QueryField<const D: usize> {
    Ray,
    Point {
        at: Vector<f64, D>,
        #[serde(default)]
        method: PointMethod,
    },
    Region {
        min: Vector<f64, D>,
        max: Vector<f64, D>,
    },
    Neighbour {
        level: Depth,
        code: Vector<u32, D>,
        direction: DirectionField<D>,
        #[serde(default)]
        reach: Reach,
        #[serde(default)]
        method: NeighbourMethod,
    },
}

#[derive(Deserialize)]
#[serde(try_from = "Vector<i8, D>")]
pub(super) struct DirectionField<const D: usize>(pub Direction<D>);

impl<const D: usize> TryFrom<Vector<i8, D>> for DirectionField<D> {
    type Error = crate::locate::DirectionError;

    fn try_from(components: Vector<i8, D>) -> Result<Self, Self::Error> {
        Direction::new(components.0).map(Self)
    }
}

/// D numbers in brackets.
pub(super) struct Vector<T, const D: usize>(pub [T; D]);

impl<'de, T: Deserialize<'de>, const D: usize> Deserialize<'de> for Vector<T, D> {
    fn deserialize<R: Deserializer<'de>>(reader: R) -> Result<Self, R::Error> {
        struct Numbers<T, const D: usize>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>, const D: usize> Visitor<'de> for Numbers<T, D> {
            type Value = Vector<T, D>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "{D} numbers, one for each axis")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
                let mut numbers = Vec::new();
                while let Some(number) = seq.next_element()? {
                    numbers.push(number);
                }
                let count = numbers.len();
                let numbers = <[T; D]>::try_from(numbers);
                numbers.map(Vector).map_err(|_| A::Error::invalid_length(count, &self))
            }
        }

        reader.deserialize_seq(Numbers(PhantomData))
    }
}

/// `"first"`, `"last"` or a number.
pub(super) struct Step(pub StepAt);

impl<'de> Deserialize<'de> for Step {
    fn deserialize<R: Deserializer<'de>>(reader: R) -> Result<Self, R::Error> {
        struct Position;

        impl Visitor<'_> for Position {
            type Value = Step;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "\"first\", \"last\" or a number from 0")
            }

            fn visit_str<E: Error>(self, name: &str) -> Result<Step, E> {
                match name {
                    "first" => Ok(Step(StepAt::First)),
                    "last" => Ok(Step(StepAt::Last)),
                    other => Err(E::invalid_value(serde::de::Unexpected::Str(other), &self)),
                }
            }

            fn visit_u64<E: Error>(self, step: u64) -> Result<Step, E> {
                Ok(Step(StepAt::At(step as usize)))
            }
        }

        reader.deserialize_any(Position)
    }
}
