//! The figure of a scene: marks, seen through a camera.

mod apart;
mod arrows;
mod at_frame;
mod at_work;
mod away;
mod boxes;
mod cells;
mod codes;
mod cross;
mod indices;
mod inset;
mod kept;
mod labels;
mod order;
mod overlaid;
mod painted;
mod points;
mod rejected;
mod ticks;

pub(crate) use codes::BETWEEN;

use crate::ground::{bounds_of, ground, is_ground};
use crate::handle::last_point;
use crate::parts::Arrow;
use crate::{Camera, Drawn, Figure, Form, Mark, Page, Part, Role, Shape, Style, Theme};
use apart::is_apart;
use arrows::Bend;
use at_work::{looked_at, most_of_dots, small_area};
use indices::chosen;
pub use inset::{drawn_box, edge_part};
use octoscope_core::geometry::Aabb;
use octoscope_core::tree::NodeId;
use overlaid::strong_boxes;
use painted::painted;
use rejected::rejected_boxes;
use ticks::is_tick;

/// Figure of `marks` as `camera` shows them on `page`. In space, boxes of one
/// tree cover each other as they do for the eye; leaves and solids lie below
/// the marks of the path, and what cannot be seen of them is left out.
pub fn space_figure<const D: usize>(marks: &[Mark<D>], camera: &Camera<D>, page: Page) -> Figure {
    space_figure_over(&[], marks, camera, page)
}

/// The same over boxes that are drawn `below` by others: labels and arrows heed them.
pub fn space_figure_over<const D: usize>(
    below: &[Mark<D>],
    marks: &[Mark<D>],
    camera: &Camera<D>,
    page: Page,
) -> Figure {
    let all = || below.iter().chain(marks);
    let root: Vec<_> = all().filter(|mark| mark.role == Role::Root).collect();
    let root = bounds_of(&root).or_else(|| bounds_of(&all().collect::<Vec<_>>()));
    let middle = root.and_then(|root| camera.project(page, root.centre()));
    let mut canvas = Canvas {
        camera,
        page,
        dot: most_of_dots(all(), camera, page),
        middle: middle.map_or([0.5 * page.width, 0.5 * page.height], |middle| middle.at),
        axes: marks.iter().filter_map(|mark| axis_on_page(mark, camera, page)).collect(),
        strong: strong_boxes(all()),
        rejected: rejected_boxes(all()),
        bend: Bend::of(all(), camera, page),
        is_apart: marks.iter().any(|mark| is_apart(mark.role)),
        last: marks.iter().find_map(|mark| match (mark.role, mark.shape) {
            (Role::RayTip, Shape::Tip(ends)) => last_point(ends, root.as_ref()),
            _ => None,
        }),
        drawn: vec![],
        in_space: vec![],
        arrows: vec![],
        chosen: chosen(all()),
        taken: vec![],
        kept: vec![],
        spared: vec![],
        small: all().filter_map(|mark| small_area(mark, camera, page)).collect(),
        looked_at: looked_at(all(), camera, page),
    };
    below.iter().for_each(|mark| canvas.heed(mark));
    let (ground_marks, others): (Vec<_>, Vec<_>) = marks.iter().partition(|mark| is_ground(mark));
    for mark in others {
        canvas.draw(mark);
    }
    // Labels look for room once everything is drawn that they may not cover:
    // those of the axes first, which have but one place, numbers last.
    let is_of_axis = |mark: &&Mark<D>| matches!(mark.role, Role::AxisLabel(_));
    canvas.write_ticks(marks);
    let names = marks.iter().filter(is_of_axis).filter(|mark| !is_tick(mark));
    names.for_each(|mark| canvas.write(mark));
    canvas.write_away(marks, root.as_ref());
    marks.iter().filter(|mark| !is_of_axis(mark)).for_each(|mark| canvas.write(mark));
    canvas.write_indices(marks);
    canvas.write_apart(marks);
    canvas.number(all());

    let Canvas { mut drawn, in_space, arrows, .. } = canvas;
    drawn.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let mut figure = Figure { page, drawn: Vec::new() };
    if let Some(root) = root {
        figure.drawn = ground(&ground_marks, &root, camera, page);
    }
    let above = drawn.partition_point(|(order, _)| *order < ABOVE_SPACE);
    let above = drawn.split_off(above);
    figure.drawn.extend(drawn.into_iter().map(|(_, drawn)| drawn));
    figure.drawn.extend(painted(in_space, &arrows, root.as_ref(), camera, page));
    figure.drawn.extend(above.into_iter().map(|(_, drawn)| drawn));
    figure
}

/// The line of an axis in space.
fn axis_on_page<const D: usize>(
    mark: &Mark<D>,
    camera: &Camera<D>,
    page: Page,
) -> Option<(usize, [[f64; 2]; 2])> {
    match (mark.role, mark.shape) {
        (Role::AxisLabel(axis), Shape::Segment(ends)) => {
            Some((axis, camera.visible_segment(page, ends)?))
        }
        _ => None,
    }
}

/// Place in the drawing order of what lies above all of space, by its role.
const ABOVE_SPACE: f64 = f64::MAX / 4.0;
/// Place of what is only a hint in space, below all else there.
const HINT: f64 = -f64::MAX / 4.0;
/// Leaves of less than this side, in page units, have finer lines.
const FINE: f64 = 12.0;
/// Planes of less than this length, in page units, bear no letter in space, and lead farther
/// beyond their nodes in the plane.
const LEGIBLE: f64 = 36.0;
/// Planes of less than this length bear no letter, and are not larger than others.
const SMALL: f64 = 18.0;
/// Place of areas on which everything else lies.
const GROUND: f64 = -f64::MAX / 2.0;

struct Canvas<'a, const D: usize> {
    camera: &'a Camera<D>,
    page: Page,
    /// Most that points of the node at work reach from their middle.
    dot: f64,
    /// Middle of the root on the page.
    middle: [f64; 2],
    /// The last point on the ray.
    last: Option<[f64; D]>,
    /// Axes that are drawn in space, with their numbers.
    axes: Vec<(usize, [[f64; 2]; 2])>,
    /// Boxes whose edges are to be seen where those above them lie on them.
    strong: Vec<Aabb<D>>,
    /// Children that are ruled out.
    rejected: Vec<Aabb<D>>,
    /// Whether children are moved apart: they would hide the ray.
    is_apart: bool,
    /// To which side ways bend.
    bend: Bend,
    drawn: Vec<(f64, Drawn)>,
    /// What is drawn in the order of its depth.
    in_space: Vec<InSpace<D>>,
    /// Arrows that are drawn among it, in pieces.
    arrows: Vec<Arrow<D>>,
    /// The child that is taken, or the current node.
    chosen: Vec<NodeId>,
    /// Middles and half extents of what labels may not cover.
    taken: Vec<[[f64; 2]; 2]>,
    /// Lines that numbers may not cover.
    kept: Vec<[[f64; 2]; 2]>,
    /// Lines and points that labels rather do not cover.
    spared: Vec<[[f64; 2]; 2]>,
    /// Middles and half extents of small nodes at work, which order numbers would hide.
    small: Vec<[[f64; 2]; 2]>,
    /// The same of a node whose children and planes are looked at.
    looked_at: Option<[[f64; 2]; 2]>,
}

/// A mark in space.
struct InSpace<const D: usize> {
    bounds: Aabb<D>,
    /// What is drawn before, and after, what lies in it.
    behind: Vec<Drawn>,
    front: Vec<Drawn>,
}

impl<const D: usize> Canvas<'_, D> {
    fn draw(&mut self, mark: &Mark<D>) {
        match mark.shape {
            Shape::Box(bounds) if D == 2 => self.draw_cell(mark, &self.drawn_box(mark, &bounds)),
            Shape::Box(bounds) => self.draw_box(mark, &self.drawn_box(mark, &bounds)),
            Shape::Plane { axis, bounds } => self.draw_plane(mark, axis, &bounds),
            Shape::Segment(ends) => self.draw_segment(mark, ends),
            Shape::Arrow(ends) => self.draw_visible_arrow(mark, ends),
            Shape::Point(point) => self.draw_point(mark, point),
            Shape::Tip(ends) => self.draw_tip(mark, ends),
            Shape::Sphere { centre, radius } => self.draw_sphere(mark, centre, radius),
            Shape::Triangle(points) => self.draw_triangle(mark, &points),
            // Of spheres in space alone, and these lie in the ground.
            Shape::CutSphere { .. }
            | Shape::Label(_)
            | Shape::LabelIn { .. }
            | Shape::LabelAlong(_) => {}
        }
    }

    fn draw_segment(&mut self, mark: &Mark<D>, ends: [[f64; D]; 2]) {
        let Some(line) = self.camera.project_segment(self.page, ends) else { return };
        let line = line.map(|p| p.at);
        self.spared.push(line);
        self.keep_line(mark.role, line);
        let form = Form::Polyline(line.to_vec());
        self.push_cased(mark, point_box(ends[0]), Part::Edge, form);
    }

    /// An arrow that leaves the page ends at its border, head and all.
    fn draw_visible_arrow(&mut self, mark: &Mark<D>, ends: [[f64; D]; 2]) {
        let (ends, line) = if mark.role == Role::Ray {
            let arrow = self.camera.ray_arrow(self.page, ends, self.last);
            let Some(arrow) = arrow else { return };
            (arrow.ends, arrow.on_page)
        } else {
            let Some(line) = self.camera.visible_segment(self.page, ends) else { return };
            (ends, self.off_border(ends[1], line))
        };
        self.draw_arrow(mark, ends, line);
    }

    fn drawn_box(&self, mark: &Mark<D>, bounds: &Aabb<D>) -> Aabb<D> {
        drawn_box(mark.role, bounds, self.camera.unit(self.page))
    }

    /// The edges of a box so small that its line would fill it are finer.
    fn edge_part(&self, mark: &Mark<D>, bounds: &Aabb<D>) -> Part {
        edge_part(&Style::of(Theme::Light, mark.role), bounds, self.camera.unit(self.page))
    }

    /// Labels shall not cover this outline, if they can.
    fn spare(&mut self, outline: &[[f64; 2]]) {
        let next = outline.iter().cycle().skip(1);
        self.spared.extend(outline.iter().zip(next).map(|(a, b)| [*a, *b]));
    }

    /// The same for a line.
    fn spare_line(&mut self, line: &[[f64; 2]]) {
        self.spared.extend(line.windows(2).map(|ends| [ends[0], ends[1]]));
    }

    /// Whether a disc reaches the page.
    fn is_near(&self, [x, y]: [f64; 2], radius: f64) -> bool {
        (-radius..=self.page.width + radius).contains(&x)
            && (-radius..=self.page.height + radius).contains(&y)
    }

    /// Draws a form of a mark that lies in `bounds`.
    fn push(&mut self, mark: &Mark<D>, bounds: Aabb<D>, part: Part, form: Form) {
        self.push_parts(mark, bounds, vec![(part, form)]);
    }

    /// The same, parted from what lies below it if its role is.
    fn push_cased(&mut self, mark: &Mark<D>, bounds: Aabb<D>, part: Part, form: Form) {
        let has_casing = mark.role.has_casing();
        let casing = has_casing.then(|| (Part::Casing, form.clone()));
        self.push_parts(mark, bounds, casing.into_iter().chain([(part, form)]).collect());
    }

    fn push_parts(&mut self, mark: &Mark<D>, bounds: Aabb<D>, parts: Vec<(Part, Form)>) {
        let Mark { role, node, .. } = *mark;
        let parts = parts.into_iter().map(|(part, form)| Drawn { form, role, part, node });
        if D == 2 || is_above(role) {
            let has_small = !self.small.is_empty();
            self.drawn.extend(parts.map(|drawn| (order_of(&drawn, has_small), drawn)));
        } else if is_hint(role) {
            self.drawn.extend(parts.map(|drawn| (HINT, drawn)));
        } else {
            self.in_space.push(InSpace { bounds, behind: Vec::new(), front: parts.collect() });
        }
    }

    fn push_at(&mut self, order: f64, mark: &Mark<D>, part: Part, form: Form) {
        self.drawn.push((order, Drawn { form, role: mark.role, part, node: mark.node }));
    }
}

/// Place of a part in the drawing order of the plane. What parts a plane from cells lies
/// below the outlines of nodes, which it would cut; so do planes through a node's middle
/// where one at work is so small that they would hide it.
fn order_of(drawn: &Drawn, has_small: bool) -> f64 {
    match (drawn.role, drawn.part) {
        (Role::MidPlane(_) | Role::ExitPlane(_), Part::Casing) => above_space(Role::Ghost),
        (Role::MidPlane(_), _) if has_small => above_space(Role::Ghost),
        (role, _) => above_space(role),
    }
}

fn above_space(role: Role) -> f64 {
    ABOVE_SPACE * (1.0 + role.layer() as f64 / 64.0)
}

/// Whether a role is drawn above everything in space: handles, points and
/// lines that must not be lost behind boxes.
fn is_above(role: Role) -> bool {
    role.layer() >= Role::MirroredRay.layer()
        || matches!(role, Role::Touch | Role::Region | Role::OwnedSide | Role::OpenSide)
}

/// Whether a role is but a hint beside the path, and must not cover it.
fn is_hint(role: Role) -> bool {
    matches!(role, Role::Rejected | Role::MirroredNode)
}

/// Whether, in the plane, the area of a role lies below everything in it.
fn has_ground(role: Role) -> bool {
    matches!(role, Role::Current | Role::Taken | Role::Found | Role::Region)
}

/// The point as a box without extent.
fn point_box<const D: usize>(point: [f64; D]) -> Aabb<D> {
    Aabb { min: point, max: point }
}

/// A square that stands on its corner, so that it is told from the points of nodes.
pub(crate) fn diamond([x, y]: [f64; 2], radius: f64) -> Form {
    Form::Polygon(vec![[x + radius, y], [x, y + radius], [x - radius, y], [x, y - radius]])
}

pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
