//! The path as the algorithm mirrors it, and the two numbers of a child.

use super::{Scene, far_end};
use crate::{Mark, Role, Shape};
use octoscope_core::geometry::{Aabb, Axes, Ray};
use octoscope_core::query::Query;
use octoscope_core::traverse::{Variant, Variants, mirrored_origin};
use octoscope_core::tree::{Child, Domain, NodeId};

/// Where a ray begins once it is mirrored, and where it does as the printed rule has it, if a
/// query follows that.
pub(crate) fn mirrored_origins<const D: usize>(
    domain: &Domain<D>,
    ray: &Ray<D>,
    query: &Query<D>,
) -> Option<[[f64; D]; 2]> {
    let variants = query.variants_at_work();
    let origins = [Variants::NONE, variants].map(|rules| mirrored_origin(domain, ray, rules));
    let is_asked = matches!(query, Query::Ray { .. }) && variants.has(Variant::B7);
    is_asked.then_some(origins)
}

impl<const D: usize> Scene<'_, D> {
    /// The mirrored ray, and the current and the visited nodes in the mirrored tree.
    pub(super) fn mirrored(&self, marks: &mut Vec<Mark<D>>) {
        let mask = self.shown_mask();
        let Query::Ray { .. } = self.query else {
            return;
        };
        if mask.is_empty() {
            return;
        }
        let centre = self.tree.domain().root_box().centre();
        let mirror = |p: [f64; D]| -> [f64; D] {
            std::array::from_fn(|e| if mask.contains(e) { 2.0 * centre[e] - p[e] } else { p[e] })
        };
        let visited = self.moment.leaves.iter().map(|leaf| leaf.node);
        let nodes = visited.chain(self.moment.current.filter(|node| *node != NodeId::ROOT));
        for node in nodes {
            let bounds = self.tree.node_box(node);
            let Some(bounds) = Aabb::around([bounds.min, bounds.max].map(mirror)) else { continue };
            marks.push(Mark::new(Shape::Box(bounds), Role::MirroredNode).of_node(node));
        }
        let ends = [self.ray.origin(), far_end(self.tree, self.ray)].map(mirror);
        marks.push(Mark::new(Shape::Arrow(ends), Role::MirroredRay));
        marks.push(Mark::new(Shape::Point(ends[0]), Role::MirroredOrigin));
        marks.extend(self.wrongly_mirrored());
    }

    /// The ray as the printed rule, eq. 16, mirrors it, where that is another one.
    fn wrongly_mirrored(&self) -> Option<Mark<D>> {
        let [_, origin] = mirrored_origins(self.tree.domain(), self.ray, self.query)?;
        let ray = Ray::new(origin, self.ray.direction().map(f64::abs)).ok()?;
        let ends = [origin, far_end(self.tree, &ray)];
        Some(Mark::new(Shape::Arrow(ends), Role::MirroredWrongly))
    }

    /// The number of a child; where the mirrored ray is shown, its number in the
    /// mirrored tree as well.
    pub(super) fn child_name(&self, child: Child<D>) -> String {
        let mask = self.shown_mask();
        if mask.is_empty() {
            return child.0.to_string();
        }
        format!("{} → {}", child.0, child.mirrored(mask).0)
    }

    /// The axes that are mirrored, if that is shown.
    fn shown_mask(&self) -> Axes<D> {
        let mask = self.moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
        if self.show.mirrored_ray { mask } else { Axes::NONE }
    }
}
