//! What of the marks of a moment is drawn, and that one is told from the other.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

#[path = "shared/corner_tree.rs"]
mod corner_tree;

use corner_tree::corner_tree;
use octoscope_core::event::Event;
use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_figure::{
    Camera, Drawn, Figure, Form, Mark, Page, Part, Role, Shape, Show, Style, Theme, marks,
    space_figure,
};

const PAGE: Page = Page { width: 400.0, height: 400.0 };

/// The marks after every event of a ray through the corner.
fn all_marks<const D: usize>(algorithm: Algorithm) -> Vec<(Event<D>, Vec<Mark<D>>)> {
    let tree = corner_tree::<D>(3);
    let along = std::array::from_fn(|e| 1.5 + 0.25 * e as f64);
    let ray = Ray::new([-0.25; D], along).expect("the direction is not zero");
    let (options, arithmetic) = (Options::default(), Arithmetic::Doubles);
    let query = Query::Ray { algorithm, options, arithmetic };
    let trace: Trace<D> = record(&tree, &ray, &query);
    let at = |step: usize| {
        let moment = Moment::after(&tree, &trace, step + 1);
        let event = &trace.events[step];
        (*event, marks(&tree, &ray, &query, &moment, Some(event), &Show::default()))
    };
    (0..trace.events.len()).map(at).collect()
}

fn unit_box<const D: usize>(min: f64, max: f64) -> Aabb<D> {
    Aabb { min: [min; D], max: [max; D] }
}

/// Figure of these marks, with a root of [0, 1] around them.
fn figure<const D: usize>(marks: &[Mark<D>]) -> Figure {
    let root = Mark::new(Shape::Box(unit_box(0.0, 1.0)), Role::Root);
    let all: Vec<_> = std::iter::once(root).chain(marks.iter().cloned()).collect();
    space_figure(&all, &Camera::framing(&unit_box(0.0, 1.0), PAGE), PAGE)
}

fn of_role(figure: &Figure, role: Role) -> Vec<&Drawn> {
    figure.drawn.iter().filter(|drawn| drawn.role == role).collect()
}

#[test]
fn the_child_that_is_left_for_none_is_shown() {
    let mut n_last = 0;
    for (event, marks) in all_marks::<2>(Algorithm::ParametricTable) {
        if matches!(event, Event::Step { next: None, .. }) {
            n_last += 1;
            assert!(marks.iter().any(|mark| mark.role == Role::ChildIndex), "{event:?}");
            assert!(marks.iter().any(|mark| mark.role == Role::Taken), "{event:?}");
        }
    }
    assert!(n_last > 0);
}

#[test]
fn no_node_has_a_meaning_twice_at_a_time() {
    for algorithm in Algorithm::ALL {
        for (event, marks) in all_marks::<3>(algorithm) {
            let boxes = marks.iter().filter(|mark| matches!(mark.shape, Shape::Box(_)));
            let mut boxes: Vec<_> = boxes
                .filter(|mark| mark.node.is_some() && mark.role != Role::Pending)
                .map(|mark| (mark.node, format!("{:?}", mark.role)))
                .collect();
            let n = boxes.len();
            boxes.sort();
            boxes.dedup();
            assert_eq!(boxes.len(), n, "{algorithm:?} {event:?}");
        }
    }
}

#[test]
fn the_child_that_the_algorithm_comes_back_from_is_shown() {
    let mut n_up = 0;
    for algorithm in [Algorithm::Parametric, Algorithm::Hero, Algorithm::Gargantini] {
        let mut left = None;
        for (event, marks) in all_marks::<3>(algorithm) {
            if let Event::Up { node: Some(_) } = event {
                let taken = marks.iter().find(|mark| mark.role == Role::Taken);
                assert_eq!(taken.and_then(|mark| mark.node), left, "{algorithm:?}");
                n_up += 1;
            }
            let current = marks.iter().find(|mark| mark.role == Role::Current);
            left = current.and_then(|mark| mark.node);
        }
    }
    assert!(n_up > 3, "{n_up}");
}

#[test]
fn a_walk_over_the_grid_shows_the_plane_that_it_crosses() {
    let tree = corner_tree::<3>(3);
    let mut n_crossed = 0;
    for (event, marks) in all_marks::<3>(Algorithm::Dda) {
        let Event::Cross { axes, cell, .. } = event else { continue };
        for axis in axes.iter() {
            // The ray goes on along all axes.
            let at = tree.domain().plane(axis, cell[axis] as u32);
            let is_there = |mark: &Mark<3>| match mark.shape {
                Shape::Plane { axis: own, bounds } => own == axis && bounds.min[axis] == at,
                _ => false,
            };
            assert!(marks.iter().any(is_there), "{event:?}");
            n_crossed += 1;
        }
    }
    assert!(n_crossed > 3, "{n_crossed}");
}

#[test]
fn the_neighbour_that_esvo_looks_for_lies_beside_the_cell_and_is_as_large() {
    let (tree, mut n_targets) = (corner_tree::<3>(3), 0);
    let (options, arithmetic) = (Options::default(), Arithmetic::Doubles);
    let query = Query::Ray { algorithm: Algorithm::Esvo, options, arithmetic };
    let [min, max] = [tree.domain().root_box().min, tree.domain().root_box().max];
    for (from, sign) in [(min, 1.0), (max, -1.0)] {
        let along = [0, 1, 2].map(|e| sign * (1.5 + 0.25 * e as f64));
        let from = [0, 1, 2].map(|e| from[e] - 0.1 * along[e]);
        let ray = Ray::new(from, along).unwrap();
        let trace = record(&tree, &ray, &query);
        for step in 1..=trace.events.len() {
            let event = &trace.events[step - 1];
            let &Event::Target { level, from, axes, .. } = event else { continue };
            let moment = Moment::after(&tree, &trace, step);
            let marks = marks(&tree, &ray, &query, &moment, Some(event), &Show::default());
            let Some(mark) = marks.iter().find(|mark| mark.role == Role::Target) else { continue };
            let Shape::Box(target) = mark.shape else { panic!("{mark:?}") };
            let own = tree.domain().cell_box(level, from);
            for e in 0..3 {
                let by = if axes.contains(e) { sign * own.size()[e] } else { 0.0 };
                assert_eq!(target.min[e], own.min[e] + by, "{event:?}");
                assert_eq!(target.size()[e], own.size()[e], "{event:?}");
            }
            n_targets += 1;
        }
    }
    assert!(n_targets > 3, "{n_targets}");
}

#[test]
fn a_mid_plane_ends_where_the_part_does_that_it_divides() {
    let mut n_halves = 0;
    for (event, marks) in all_marks::<3>(Algorithm::Bsp) {
        let Event::Split { axis, taken, .. } = event else { continue };
        let part = taken.bounds(&corner_tree(3));
        let planes: Vec<_> = marks.iter().filter(|m| matches!(m.role, Role::MidPlane(_))).collect();
        let [Mark { shape: Shape::Plane { bounds, .. }, .. }] = planes[..] else {
            panic!("{planes:?}")
        };
        for e in (0..3).filter(|e| *e != usize::from(axis)) {
            assert_eq!([bounds.min[e], bounds.max[e]], [part.min[e], part.max[e]], "{event:?}");
        }
        n_halves += usize::from(!taken.halved.is_empty());
    }
    assert!(n_halves > 0);
}

#[test]
fn the_head_of_an_arrow_is_less_than_half_as_long_as_its_shaft_and_specks_are_left_out() {
    for length in [0.004, 0.03, 0.1, 0.7] {
        for role in [Role::WayUp, Role::WayDown, Role::Link, Role::Direction] {
            let arrow = Shape::Arrow([[0.1, 0.5], [0.1 + length, 0.5]]);
            let figure = figure(&[Mark::new(arrow, role)]);
            let span = |drawn: &Drawn| match &drawn.form {
                Form::Polygon(points) | Form::Polyline(points) => {
                    let x = |pick: fn(f64, f64) -> f64| points.iter().map(|p| p[0]).reduce(pick);
                    x(f64::max).zip(x(f64::min)).map_or(0.0, |(most, least)| most - least)
                }
                Form::Circle { .. } | Form::Text { .. } | Form::Formula { .. } => 0.0,
            };
            let drawn = of_role(&figure, role);
            let of = |part| drawn.iter().find(|d| d.part == part).map(|d| span(d));
            match [of(Part::Head), of(Part::Edge).or(of(Part::FineEdge))] {
                [Some(head), Some(shaft)] => {
                    assert!(head < 0.5 * shaft, "{role:?} {head} {shaft}");
                }
                [None, None] => assert!(length < 0.02, "{role:?} {length}"),
                other => panic!("{role:?} {other:?}"),
            }
        }
    }
}

#[test]
fn a_way_there_and_back_is_two_lines_on_both_sides_of_the_direction() {
    let [a, b] = [[0.2, 0.3], [0.6, 0.7]];
    for share in [0.1, 1.0] {
        let b = [0, 1].map(|e| a[e] + share * (b[e] - a[e]));
        let way = |ends, role| Mark::new(Shape::Arrow(ends), role);
        let direction = way([a, b], Role::Direction);
        let figure = figure(&[way([a, b], Role::WayUp), way([b, a], Role::WayDown), direction]);
        let line = |role| {
            let is_line = |d: &&Drawn| matches!(d.form, Form::Polyline(_));
            let drawn = of_role(&figure, role).into_iter().rfind(is_line);
            let Form::Polyline(points) = &drawn.unwrap().form else { panic!("no line") };
            points.clone()
        };
        let asked = line(Role::Direction);
        // How far the middle of a line lies to one side of the direction.
        let off = |role| {
            let (points, [from, to]) = (line(role), [asked[0], asked[1]]);
            let at = points[points.len() / 2];
            let [along, across] = [[to[0] - from[0], to[1] - from[1]], [from[1], from[0]]];
            let length = along[0].hypot(along[1]);
            (along[0] * (at[1] - across[0]) - along[1] * (at[0] - across[1])) / length
        };
        let [up, down] = [off(Role::WayUp), off(Role::WayDown)];
        assert!(up * down < 0.0 && up.abs().min(down.abs()) > 4.0, "{up} {down}");
    }
}

#[test]
fn ways_bend_away_from_the_direction() {
    let [from, to, aside] = [[0.2, 0.3], [0.5, 0.6], [0.5, 0.4]];
    let arrow = |ends, role| Mark::new(Shape::Arrow(ends), role);
    let bend = |asked, way| {
        let way = arrow([from, way], Role::WayUp);
        let figure = figure(&[way, arrow([from, asked], Role::Direction)]);
        let drawn = of_role(&figure, Role::WayUp);
        let Form::Polyline(points) = &drawn[0].form else { panic!("{drawn:?}") };
        let [first, middle, last] = [0, points.len() / 2, points.len() - 1].map(|n| points[n]);
        let [along, off] = [last, middle].map(|at| [at[0] - first[0], at[1] - first[1]]);
        along[0] * off[1] - along[1] * off[0]
    };
    let [right, left] = [bend(to, aside), bend(aside, to)];
    assert!(right * left < 0.0, "{right} {left}");
}

#[test]
fn a_rejected_child_lies_within_its_cell() {
    let figure = figure(&[Mark::new(Shape::Box(unit_box::<2>(0.0, 0.5)), Role::Rejected)]);
    let outer = Camera::framing(&unit_box::<2>(0.0, 1.0), PAGE).project(PAGE, [0.0; 2]).unwrap().at;
    let [drawn] = of_role(&figure, Role::Rejected)[..] else { panic!("one shape") };
    let Form::Polygon(points) = &drawn.form else { panic!("{drawn:?}") };
    let nearest = points.iter().map(|p| (p[0] - outer[0]).hypot(p[1] - outer[1]));
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!((2.0..6.0).contains(&nearest), "{nearest}");
}

#[test]
fn what_is_ruled_out_in_space_is_outlined_as_one_body_without_hidden_edges() {
    let child = |n: usize| {
        let min: [f64; 3] = std::array::from_fn(|e| 0.5 * (n >> e & 1) as f64);
        let bounds = Aabb { min, max: min.map(|x| x + 0.5) };
        Mark::new(Shape::Box(bounds), Role::Rejected)
    };
    let n_edges = |children: &[usize]| {
        let marks: Vec<_> = children.iter().map(|&n| child(n)).collect();
        let figure = figure(&marks);
        let drawn = of_role(&figure, Role::Rejected);
        assert!(drawn.iter().all(|drawn| drawn.part == Part::Edge), "{drawn:?}");
        drawn.len()
    };
    // Nine edges of a cube are seen; a body of eight has two pieces in each of them.
    assert_eq!(n_edges(&[0]), 9);
    assert_eq!(n_edges(&[0, 1, 2, 3, 4, 5, 6, 7]), 18);
    for out in 0..8 {
        let seven: Vec<usize> = (0..8).filter(|n| *n != out).collect();
        let n = n_edges(&seven);
        assert!((12..=24).contains(&n), "without {out}: {n}");
    }
}

#[test]
fn edges_of_ancestors_leave_those_of_the_current_node_to_it() {
    let current = Mark::new(Shape::Box(unit_box::<3>(0.0, 0.5)), Role::Current);
    let ends = |figure: &Figure, role| -> Vec<[[f64; 2]; 2]> {
        let lines = of_role(figure, role).into_iter().filter_map(|d| match &d.form {
            Form::Polyline(points) => Some([points[0], points[1]]),
            Form::Polygon(_) | Form::Circle { .. } | Form::Text { .. } | Form::Formula { .. } => {
                None
            }
        });
        lines.collect()
    };
    let length = |lines: &[[[f64; 2]; 2]]| -> f64 {
        lines.iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum()
    };
    let [alone, with] = [figure::<3>(&[]), figure(&[current])].map(|f| ends(&f, Role::Root));
    // Three edges of the root begin in the corner that both share.
    assert_eq!(with.len(), 12);
    assert!(length(&with) < 0.95 * length(&alone));
}

#[test]
fn a_current_node_is_filled_alike_at_any_size_and_a_small_one_has_fine_lines() {
    let parts = |side: f64| -> Vec<Part> {
        let mark = Mark::new(Shape::Box(unit_box::<2>(0.0, side)), Role::Current);
        of_role(&figure(&[mark]), Role::Current).iter().map(|drawn| drawn.part).collect()
    };
    assert_eq!(parts(0.9), [Part::Face(0), Part::Edge]);
    assert_eq!(parts(0.1), [Part::Face(0), Part::Edge]);
    assert_eq!(parts(0.02), [Part::Face(0), Part::FineEdge]);
}

#[test]
fn the_outline_of_the_current_node_is_the_strongest_of_all_boxes_at_every_size() {
    for theme in Theme::ALL {
        let least = Part::FineEdge.width() * Style::of(theme, Role::Current).width;
        let above = [0, 1, 2, 3].map(|above| Role::Ancestor { above });
        let others = [Role::Root, Role::Rejected, Role::Taken, Role::Visited { share: 0.5 }];
        for role in above.into_iter().chain(others) {
            assert!(Style::of(theme, role).width < least, "{theme:?} {role:?}");
        }
    }
}

#[test]
fn a_cell_that_is_looked_for_is_seen_as_an_outline_however_small_it_is() {
    for side in [1e-6, 0.005, 0.2] {
        let mark = Mark::new(Shape::Box(unit_box::<2>(0.5, 0.5 + side)), Role::Target);
        let figure = figure(&[mark]);
        for drawn in of_role(&figure, Role::Target) {
            let Form::Polygon(corners) = &drawn.form else { panic!("{drawn:?}") };
            let wide = (corners[2][0] - corners[0][0]).abs();
            assert!(wide > 11.99, "{side}: {wide}");
        }
    }
}

#[test]
fn a_plane_is_seen_beyond_its_node() {
    let bounds = Aabb { min: [0.25, 0.5], max: [0.75, 0.5] };
    let figure = figure(&[Mark::new(Shape::Plane { axis: 1, bounds }, Role::ExitPlane(1))]);
    let camera = Camera::framing(&unit_box::<2>(0.0, 1.0), PAGE);
    let end = camera.project(PAGE, bounds.min).unwrap().at;
    let drawn = of_role(&figure, Role::ExitPlane(1));
    assert_eq!(drawn.iter().map(|d| d.part).collect::<Vec<_>>(), [Part::Casing, Part::Edge]);
    let Form::Polyline(points) = &drawn[1].form else { panic!("{drawn:?}") };
    assert!(points[0][0] < end[0] - 4.0, "{points:?} {end:?}");
}

#[test]
fn what_is_asked_for_lies_above_the_planes_in_space() {
    let bounds = Aabb { min: [0.5, 0.0, 0.0], max: [0.5, 1.0, 1.0] };
    let plane = Mark::new(Shape::Plane { axis: 0, bounds }, Role::MidPlane(0));
    let region = Mark::new(Shape::Box(unit_box::<3>(0.3, 0.4)), Role::Region);
    let figure = figure(&[region, plane]);
    let place = |role| figure.drawn.iter().rposition(|drawn| drawn.role == role);
    let first = figure.drawn.iter().position(|drawn| drawn.role == Role::Region);
    assert!(first > place(Role::MidPlane(0)));
}
