//! Bounding volume hierarchies over the occupied cells.

use crate::{NOTHING, Row};
use bvh::aabb::Bounded;
use bvh::bounding_hierarchy::BHShape;
use glam::Vec3A;
use nalgebra::{Point3, Vector3};
use obvhs::BvhBuildParams;
use obvhs::cwbvh::builder::build_cwbvh;
use obvhs::ray::RayHit;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::traverse::StopAt;
use parry3d::partitioning::{Bvh, BvhBuildStrategy};
use std::time::Duration;

/// All of them.
pub fn rows<'a>(boxes: &[Aabb<3>], rays: &'a [Ray<3>], stop_at: StopAt) -> Vec<Row<'a>> {
    vec![obvhs(boxes, rays, stop_at), parry(boxes, rays, stop_at), bvh(boxes, rays, stop_at)]
}

fn single(x: [f64; 3]) -> [f32; 3] {
    x.map(|x| x as f32)
}

/// obvhs: eight boxes a node, compressed, tested with vectors.
fn obvhs<'a>(boxes: &[Aabb<3>], rays: &[Ray<3>], stop_at: StopAt) -> Row<'a> {
    let vector = |x: [f64; 3]| Vec3A::from(single(x));
    let boxes: Vec<_> =
        boxes.iter().map(|b| obvhs::aabb::Aabb::new(vector(b.min), vector(b.max))).collect();
    let tree = build_cwbvh(&boxes, BvhBuildParams::medium_build(), &mut Duration::default());
    let rays: Vec<obvhs::ray::Ray> = rays
        .iter()
        .map(|ray| obvhs::ray::Ray::new_inf(vector(ray.origin()), vector(ray.direction())))
        .collect();
    // In the order of the hierarchy, as its authors advise.
    let in_order: Vec<_> = tree.primitive_indices.iter().map(|&n| boxes[n as usize]).collect();
    let run = move |answers: &mut [u32]| {
        for (ray, answer) in rays.iter().zip(answers) {
            if stop_at == StopAt::End {
                let mut count = 0;
                tree.ray_traverse_anyhit(*ray, |ray, id| {
                    count += u32::from(entry(&in_order[id], ray).is_finite());
                });
                *answer = count;
            } else {
                let mut hit = RayHit::none();
                let is_hit = tree.ray_traverse(*ray, &mut hit, |ray, id| entry(&in_order[id], ray));
                let nearest = || tree.primitive_indices[hit.primitive_id as usize];
                *answer = if is_hit { nearest() } else { NOTHING };
            }
        }
    };
    Row { name: "obvhs, CWBVH", run: Box::new(run), is_ours: false }
}

/// Parameter at which a ray enters a box, infinite if it does not.
fn entry(b: &obvhs::aabb::Aabb, ray: &obvhs::ray::Ray) -> f32 {
    let [low, high] = [b.min, b.max].map(|corner| (corner - ray.origin) * ray.inv_direction);
    let enter = low.min(high).max_element().max(0.0);
    let exit = low.max(high).min_element();
    if enter <= exit { enter } else { f32::INFINITY }
}

/// parry3d: two boxes a node, the most promising one first.
fn parry<'a>(boxes: &[Aabb<3>], rays: &[Ray<3>], stop_at: StopAt) -> Row<'a> {
    use parry3d::bounding_volume::Aabb as Box3;
    use parry3d::query::{Ray as Ray3, RayCast};
    let point = |x: [f64; 3]| Point3::from(single(x));
    let boxes: Vec<Box3> = boxes.iter().map(|b| Box3::new(point(b.min), point(b.max))).collect();
    let tree = Bvh::from_leaves(BvhBuildStrategy::Ploc, &boxes);
    let rays: Vec<Ray3> = rays
        .iter()
        .map(|ray| Ray3::new(point(ray.origin()), Vector3::from(single(ray.direction()))))
        .collect();
    let run = move |answers: &mut [u32]| {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = if stop_at == StopAt::End {
                tree.leaves(|node| node.cast_ray(ray, f32::MAX) < f32::MAX).count() as u32
            } else {
                let enter = |n: u32, best| boxes[n as usize].cast_local_ray(ray, best, true);
                tree.cast_ray(ray, f32::MAX, enter).map_or(NOTHING, |(nearest, _)| nearest)
            };
        }
    };
    Row { name: "parry3d, Bvh", run: Box::new(run), is_ours: false }
}

/// A box of the crate bvh.
struct Shape {
    bounds: bvh::aabb::Aabb<f32, 3>,
    number: u32,
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> bvh::aabb::Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// bvh: two boxes a node.
fn bvh<'a>(boxes: &[Aabb<3>], rays: &[Ray<3>], stop_at: StopAt) -> Row<'a> {
    let point = |x: [f64; 3]| Point3::from(single(x));
    let mut shapes: Vec<Shape> = (0..)
        .zip(boxes)
        .map(|(number, b)| {
            let bounds = bvh::aabb::Aabb::with_bounds(point(b.min), point(b.max));
            Shape { bounds, number, node: 0 }
        })
        .collect();
    let tree = bvh::bvh::Bvh::build(&mut shapes);
    let rays: Vec<bvh::ray::Ray<f32, 3>> = rays
        .iter()
        .map(|ray| {
            let direction = Vector3::from(single(ray.direction()));
            bvh::ray::Ray::new(point(ray.origin()), direction)
        })
        .collect();
    let run = move |answers: &mut [u32]| {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = if stop_at == StopAt::End {
                tree.traverse_iterator(ray, &shapes).count() as u32
            } else {
                let mut nearest = tree.nearest_traverse_iterator(ray, &shapes);
                nearest.next().map_or(NOTHING, |shape| shape.number)
            };
        }
    };
    Row { name: "bvh", run: Box::new(run), is_ours: false }
}
