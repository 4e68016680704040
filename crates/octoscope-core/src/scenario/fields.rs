//! Fields of a scenario file, as JSON has them; whether their numbers make sense
//! is seen later.

use super::{Parameters, StepAt, View};
use crate::locate::{NeighbourMethod, Reach};
use crate::query::{Arithmetic, PointMethod};
use crate::traverse::{Algorithm, Options, Variants};
use crate::tree::{Fill, Merge};
use serde::Deserialize;
use serde::de::{Deserializer, Error, IgnoredAny, SeqAccess, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// What has to be known before anything else.
#[derive(Deserialize)]
pub(super) struct Version {
    pub octoscope: u64,
}

/// What has to be known before the rest can be read.
#[derive(Deserialize)]
pub(super) struct Head {
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
    pub depth: Option<u64>,
    pub capacity: Option<u32>,
    pub merge: Option<Merge>,
    pub threshold: Option<u8>,
    pub fill: Option<Fill>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DomainField<const D: usize> {
    pub min: Vector<f64, D>,
    pub side: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RayField<const D: usize> {
    pub origin: Vector<f64, D>,
    pub direction: Vector<f64, D>,
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
        #[serde(default)]
        variants: Variants,
    },
    Region {
        min: Vector<f64, D>,
        max: Vector<f64, D>,
        #[serde(default)]
        variants: Variants,
    },
    Neighbour {
        level: u64,
        code: Vector<u32, D>,
        direction: Vector<i8, D>,
        #[serde(default)]
        reach: Reach,
        #[serde(default)]
        method: NeighbourMethod,
        #[serde(default)]
        variants: Variants,
    },
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
