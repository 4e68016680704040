//! What can be shown and hidden of a tree in space.

#[path = "shared/corner_tree.rs"]
mod corner_tree;

use corner_tree::corner_tree;
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::Tree;
use octoscope_figure::{
    Camera, Cut, Form, Levels, Mark, Page, Part, Rest, Role, Shape, Show, Slice, cells, marks,
    space_figure,
};

const PAGE: Page = Page { width: 400.0, height: 400.0 };

fn run<const D: usize>(tree: &Tree<D>, direction: f64) -> (Ray<D>, Query<D>, Trace<D>) {
    let origin = if direction > 0.0 { -0.25 } else { 1.25 };
    let along = std::array::from_fn(|e| direction * (1.5 + 0.25 * e as f64));
    let ray = Ray::new([origin; D], along).expect("the direction is not zero");
    let query = Query::Ray {
        algorithm: Algorithm::Parametric,
        options: Options::default(),
        arithmetic: Arithmetic::Doubles,
    };
    let trace = record(tree, &ray, &query);
    (ray, query, trace)
}

fn marks_at<const D: usize>(direction: f64, step: usize, show: &Show) -> Vec<Mark<D>> {
    let tree = corner_tree::<D>(3);
    let (ray, query, trace) = run(&tree, direction);
    let moment = Moment::after(&tree, &trace, step);
    let event = step.checked_sub(1).map(|last| &trace.events[last]);
    marks(&tree, &ray, &query, &moment, event, show)
}

fn levels_of<const D: usize>(show: &Show) -> Vec<u8> {
    let tree = corner_tree::<D>(3);
    let marks = cells(&tree, show, None);
    let mut levels: Vec<u8> =
        marks.iter().map(|mark| tree.level(mark.node.expect("cells are nodes"))).collect();
    levels.sort_unstable();
    levels
}

#[test]
fn only_cells_of_the_chosen_levels_are_shown() {
    let show = Show { levels: Levels { least: 1, most: 2 }, ..Show::default() };
    assert_eq!(levels_of::<2>(&show), [1, 1, 1, 2, 2, 2]);
    assert_eq!(levels_of::<3>(&show), [[1; 7], [2; 7]].concat());
    let inner = Show { inner_nodes: true, ..show };
    assert_eq!(levels_of::<2>(&inner), [1, 1, 1, 1, 2, 2, 2, 2]);
    let full = Show { empty_leaves: false, ..Show::default() };
    assert_eq!(levels_of::<2>(&full), [0, 0, 0, 0]);
}

#[test]
fn what_is_off_the_path_is_plain_faint_or_hidden() {
    let tree = corner_tree::<3>(3);
    let roles = |rest| {
        let marks = cells(&tree, &Show { rest, ..Show::default() }, None);
        let is_faint = |mark: &&Mark<3>| mark.role == Role::FaintNode;
        (marks.iter().filter(is_faint).count(), marks.len())
    };
    assert_eq!(roles(Rest::Plain), (0, tree.n_leaves()));
    assert_eq!(roles(Rest::Faint), (tree.n_leaves(), tree.n_leaves()));
    assert_eq!(roles(Rest::Hidden), (0, 0));
}

#[test]
fn a_slice_takes_away_what_is_before_it_but_never_the_path() {
    let tree = corner_tree::<3>(3);
    let camera = Camera::framing(&tree.domain().root_box(), PAGE);
    let slice = Slice { axis: 0, at: 0.3 };
    let cut = slice.cut(tree.domain(), &camera).unwrap();
    assert_eq!(cut, Cut { axis: 0, at: 0.3, keeps_lower: true });
    let left = cells(&tree, &Show::default(), Some(&cut));
    for mark in &left {
        match mark.shape {
            Shape::Box(bounds) => assert!(bounds.min[0] < bounds.max[0] && bounds.max[0] <= 0.3),
            Shape::Plane { axis: 0, bounds } => assert_eq!(bounds.max[0], 0.3),
            _ => panic!("{mark:?}"),
        }
    }
    // The sections tile the plane.
    let areas = left.iter().filter(|mark| mark.role == Role::EmptySection).map(|mark| {
        let Shape::Plane { bounds, .. } = mark.shape else { panic!("{mark:?}") };
        bounds.size()[1] * bounds.size()[2]
    });
    assert!((areas.sum::<f64>() - 1.0).abs() < 1e-12);
    // Where the cells are faint, so are these.
    let faint = cells(&tree, &Show { rest: Rest::Faint, ..Show::default() }, Some(&cut));
    assert_eq!(faint.len(), left.len());
    assert!(faint.iter().all(|mark| mark.role == Role::FaintNode));
    let figure = space_figure(&faint, &camera, PAGE);
    let is_drawn = |drawn: &octoscope_figure::Drawn| matches!(drawn.form, Form::Polygon(_));
    assert!(figure.drawn.iter().any(is_drawn));
    let [whole, sliced] =
        [None, Some(slice)].map(|slice| marks_at::<3>(1.0, 9, &Show { slice, ..Show::default() }));
    assert_eq!(whole, sliced);
}

#[test]
fn cut_leaves_are_drawn_with_their_section_above_them() {
    let tree = corner_tree::<3>(3);
    let camera = Camera::framing(&tree.domain().root_box(), PAGE);
    let cut = Slice { axis: 2, at: 0.06 }.cut(tree.domain(), &camera).unwrap();
    let figure = space_figure(&cells(&tree, &Show::default(), Some(&cut)), &camera, PAGE);
    let place = |role| figure.drawn.iter().position(|drawn| drawn.role == role);
    let lit = figure.drawn.iter().rposition(|d| matches!(d.part, Part::Lit(_))).unwrap();
    assert!(place(Role::FullSection).unwrap() > lit);
    let n_full = figure.drawn.iter().filter(|drawn| drawn.role == Role::FullSection).count();
    assert_eq!(n_full, 4);
}

/// Boxes of the children that are moved apart at every step, with the taken one.
fn check_apart<const D: usize>() {
    let show = Show { explosion: Show::APART, ..Show::default() };
    let tree = corner_tree::<D>(3);
    let (.., trace) = run(&tree, 1.0);
    let mut n_apart = 0;
    for step in 0..=trace.events.len() {
        let marks = marks_at::<D>(1.0, step, &show);
        let apart: Vec<_> = marks
            .iter()
            .filter_map(|mark| match (mark.role, mark.shape) {
                (Role::Apart | Role::ApartTaken, Shape::Box(bounds)) => Some((mark, bounds)),
                _ => None,
            })
            .collect();
        assert!(apart.is_empty() || apart.len() == 1 << D, "step {step}");
        for (index, (a, bounds)) in apart.iter().enumerate() {
            let own = tree.node_box(a.node.expect("children are nodes"));
            assert!((0..D).all(|e| (bounds.size()[e] - own.size()[e]).abs() < 1e-12));
            for (_, other) in &apart[..index] {
                let gap = (0..D)
                    .map(|e| (bounds.min[e] - other.max[e]).max(other.min[e] - bounds.max[e]));
                assert!(gap.fold(f64::MIN, f64::max) > 0.6 * own.size()[0], "step {step}");
            }
        }
        let taken = apart.iter().filter(|(mark, _)| mark.role == Role::ApartTaken).count();
        assert!(taken <= 1);
        n_apart += usize::from(!apart.is_empty());
    }
    assert!(n_apart > trace.events.len() / 2);
}

#[test]
fn children_moved_apart_are_a_function_of_the_step() {
    check_apart::<2>();
    check_apart::<3>();
}

#[test]
fn children_have_both_numbers_where_the_mirrored_ray_is_shown() {
    let show = Show { explosion: 0.5, mirrored_ray: true, ..Show::default() };
    let named = |direction| {
        let marks = marks_at::<3>(direction, 4, &show);
        let labels =
            marks.iter().filter(|mark| matches!(mark.role, Role::Apart | Role::ApartTaken));
        labels.filter_map(|mark| mark.text.clone()).collect::<Vec<_>>()
    };
    assert!(named(1.0).contains(&"1".to_owned()));
    assert!(named(-1.0).contains(&"1 → 6".to_owned()));
}

#[test]
fn the_mirrored_path_lies_on_the_mirrored_ray() {
    let show = Show { mirrored_ray: true, ..Show::default() };
    let tree = corner_tree::<2>(3);
    let (.., trace) = run(&tree, -1.0);
    let marks = marks_at::<2>(-1.0, trace.events.len(), &show);
    let visited = marks.iter().filter(|mark| matches!(mark.role, Role::Visited { .. }));
    let mirrored: Vec<_> = marks.iter().filter(|mark| mark.role == Role::MirroredNode).collect();
    assert_eq!(visited.count(), mirrored.len());
    for mark in mirrored {
        let Shape::Box(bounds) = mark.shape else { panic!("{mark:?}") };
        let own = tree.node_box(mark.node.unwrap());
        assert_eq!(bounds.min, own.max.map(|x| 1.0 - x));
    }
}

#[test]
fn lower_sides_are_solid_and_upper_sides_dashed() {
    let show = Show { half_open_sides: true, ..Show::default() };
    let count = |marks: &[Role], role| marks.iter().filter(|r| **r == role).count();
    let roles = |marks: Vec<Role>| [Role::OwnedSide, Role::OpenSide].map(|r| count(&marks, r));
    let plane = marks_at::<2>(1.0, 4, &show).iter().map(|mark| mark.role).collect();
    assert_eq!(roles(plane), [2, 2]);
    // The edges in which two owned faces meet; nine are others'.
    let space: Vec<Role> = marks_at::<3>(1.0, 4, &show).iter().map(|mark| mark.role).collect();
    assert_eq!(count(&space, Role::OwnedFace), 3);
    assert_eq!(roles(space), [3, 9]);
}

#[test]
fn a_figure_of_all_of_it_has_only_finite_places() {
    let tree = corner_tree::<3>(3);
    let camera = Camera::framing(&tree.domain().root_box(), PAGE);
    let show = Show {
        slice: Some(Slice::MIDDLE),
        explosion: Show::MOST_APART,
        half_open_sides: true,
        mirrored_ray: true,
        inner_nodes: true,
        ..Show::default()
    };
    let cut = Slice::MIDDLE.cut(tree.domain(), &camera);
    let mut all = cells(&tree, &show, cut.as_ref());
    all.extend(marks_at::<3>(-1.0, 7, &show));
    assert!(all.iter().all(|mark| mark.node.is_none_or(|node| node.index() < tree.n_nodes())));
    for drawn in space_figure(&all, &camera, PAGE).drawn {
        if let Form::Polygon(points) | Form::Polyline(points) = drawn.form {
            assert!(points.iter().flatten().all(|x| x.is_finite()), "{:?}", drawn.role);
        }
    }
}
