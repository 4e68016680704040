//! The option --ray: numbers, or a ray of the gallery.

use super::values::Numbers;
use crate::document::Document;
use anyhow::{anyhow, bail};
use octoscope_core::gallery::Degenerate;
use octoscope_core::geometry::{AXIS_NAMES, Ray};
use octoscope_core::query::Query;
use octoscope_core::tree::Tree;
use std::str::FromStr;

/// A ray as the command line gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum RayChoice {
    /// Origin and direction.
    Numbers(Numbers),
    /// A degenerate ray, made for the tree: gallery:ID.
    Gallery(Degenerate),
}

impl FromStr for RayChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.strip_prefix("gallery:") {
            Some(id) => id.parse().map(Self::Gallery).map_err(|error| format!("{error}")),
            None => text.parse().map(Self::Numbers),
        }
    }
}

impl RayChoice {
    /// The ray, for `tree`.
    ///
    /// # Errors
    /// Says why the numbers make no ray, or why the tree has none of this kind.
    fn ray<const D: usize>(&self, tree: &Tree<D>) -> anyhow::Result<Ray<D>> {
        match self {
            Self::Numbers(numbers) => ray(numbers),
            Self::Gallery(kind) => kind.ray(tree).ok_or_else(|| {
                let of_space = D == 2 && kind.is_of_space();
                let why = if of_space {
                    "is a ray through octrees only"
                } else if tree.root().is_leaf() {
                    "needs a divided root, and this tree is one leaf"
                } else {
                    "has no numbers in this tree that are doubles"
                };
                anyhow!("--ray gallery:{} {why}", kind.id())
            }),
        }
    }

    /// Gives `document` the ray, and a query along it if it has another one.
    ///
    /// # Errors
    /// Says why there is no such ray.
    pub fn aim<const D: usize>(&self, document: &mut Document<D>) -> anyhow::Result<()> {
        document.scenario.ray = self.ray(&document.tree)?;
        if !matches!(document.scenario.query, Query::Ray { .. }) {
            document.scenario.query = Query::default();
        }
        Ok(())
    }
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

    #[test]
    fn a_ray_of_the_gallery_is_named() {
        assert_eq!("gallery:corner".parse(), Ok(RayChoice::Gallery(Degenerate::Corner)));
        let message = "gallery:none".parse::<RayChoice>().unwrap_err();
        assert!(message.starts_with("there is no ray ‘none’ in the gallery; there are axis-"));
        assert!(matches!("1,2,3,4".parse(), Ok(RayChoice::Numbers(_))));
    }
}
