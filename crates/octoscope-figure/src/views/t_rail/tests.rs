//! Laws of the rail's drawing.

use super::*;
use crate::space::distance;
use crate::views::figure_texts;
use crate::{Palette, Shape, Show, Style, Theme, contrast, marks};
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::scenario::{AnyScenario, built_in};
use octoscope_core::text::Language;
use octoscope_core::trace::record;
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::{NodeId, Tree};

fn quadtree() -> Tree<2> {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
    scenario.tree().unwrap()
}

fn along<const D: usize>(algorithm: Algorithm, segment_end: Option<f64>) -> Query<D> {
    let options = Options { segment_end, ..Options::default() };
    Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles }
}

fn rail(tree: &Tree<2>, ray: &Ray<2>, query: &Query<2>, moment: &Moment<2>) -> Option<RailFigure> {
    let texts = Texts::new(Language::English, &[figure_texts(Language::English)]);
    let of = DiagramOf { tree, ray, query, moment, event: None, strayed: &[] };
    t_rail(&texts, &of, 400.0, RailRows::Small, 0.0)
}

/// A page: its width, how rows are set, and the least type.
type PageOfRail = (f64, RailRows, f64);

/// Panels of the narrowest, of usual and of wide windows; then lectures.
const PAGES: [PageOfRail; 8] = [
    (228.0, RailRows::Small, 0.0),
    (288.0, RailRows::Small, 0.0),
    (359.0, RailRows::Small, 0.0),
    (424.0, RailRows::Small, 0.0),
    (256.0, RailRows::Small, 12.5),
    (288.0, RailRows::Large, 12.5),
    (384.0, RailRows::Small, 12.5),
    (384.0, RailRows::Large, 12.5),
];

/// Shows `check` every rail of every algorithm along these rays, on pages of all sizes in
/// turn.
fn for_every_rail<const D: usize>(
    tree: &Tree<D>,
    rays: &[Ray<D>],
    check: &mut impl FnMut(&Drawing<D>, &str),
) {
    for (ray, algorithm) in rays.iter().flat_map(|ray| Algorithm::ALL.map(|one| (ray, one))) {
        let trace = record(tree, ray, &along(algorithm, None));
        let mut moment = Moment::default();
        for (step, event) in trace.events.iter().enumerate() {
            moment.apply(tree, event);
            let Some(rail) = Rail::of(&moment) else { continue };
            let rail = rail.with_planes(tree, ray);
            let (width, rows, least) = PAGES[step % PAGES.len()];
            let (range, track, sizes) = (rail.range(), track(width), rows.sizes());
            let drawing = Drawing { rail: &rail, range, track, rows, sizes, least };
            check(&drawing, &format!("{algorithm:?} after step {}, {width} wide", step + 1));
        }
    }
}

/// The octree of the points in space, and rays through it: the one of the scene, in the
/// other direction, along an axis, and in one plane.
fn octree() -> (Tree<3>, Vec<Ray<3>>) {
    let Some(AnyScenario::Octree(scenario)) = built_in("points-3d") else { panic!() };
    let rays = [
        ([-0.16, 0.13, 0.2], [1.0, 0.62, 0.41]),
        ([1.2, 0.9, 0.8], [-1.0, -0.62, -0.41]),
        ([-0.16, 0.13, 0.2], [1.0, 0.0, 0.0]),
        ([-0.1, 1.1, 0.3], [0.5, -0.5, 0.0]),
    ];
    let rays = rays.map(|(origin, direction)| Ray::new(origin, direction).unwrap());
    (scenario.tree().unwrap(), rays.to_vec())
}

#[test]
fn every_label_stands_at_its_mark_or_has_a_line_to_it() {
    let (mut n_lines, mut n_at_marks) = (0, 0);
    fn check_rail<const D: usize>(drawing: &Drawing<D>, told: &str, n: [&mut usize; 2]) {
        let [n_lines, n_at_marks] = n;
        for axis in 0..D {
            let labels = drawing.labels(axis);
            let mut lines: Vec<[[f64; 2]; 2]> = Vec::new();
            for label in &labels {
                let Some(mark) = label.mark else { continue };
                let middle = label.at[0] + 0.5 * label.width;
                match label.leader() {
                    Some(line) => {
                        assert_eq!([line[0], [line[1][0], 0.0]], [mark, [middle, 0.0]], "{told}");
                        let away = (line[1][1] - label.at[1]).abs();
                        assert!(away <= 1.2 * drawing.half_line(), "{told}: it ends elsewhere");
                        lines.push(line);
                        *n_lines += 1;
                    }
                    None => {
                        assert!((middle - mark[0]).abs() <= 2.0, "{told}: off by itself");
                        *n_at_marks += 1;
                    }
                }
            }
            let cross = |[a, b]: [&[[f64; 2]; 2]; 2]| {
                // Of one side of a bar.
                (a[1][1] == b[1][1])
                    && (a[0][0] < b[0][0]) != (a[1][0] < b[1][0])
                    && a[0][0] != b[0][0]
            };
            let all = lines.iter().enumerate();
            let pairs = all.flat_map(|(n, a)| lines[n + 1..].iter().map(move |b| [a, b]));
            assert!(!pairs.into_iter().any(cross), "{told}: lines of {axis} cross");
        }
    }
    let (tree, rays) = octree();
    for_every_rail(&tree, &rays, &mut |drawing, told| {
        check_rail(drawing, told, [&mut n_lines, &mut n_at_marks]);
    });
    let rays = [([-0.16, 0.13], [1.0, 0.62]), ([1.1, 0.2], [-1.0, 0.4]), ([0.5, 0.5], [0.0, 1.0])];
    let rays = rays.map(|(origin, direction)| Ray::new(origin, direction).unwrap());
    for_every_rail(&quadtree(), &rays, &mut |drawing, told| {
        check_rail(drawing, told, [&mut n_lines, &mut n_at_marks]);
    });
    assert!(n_lines > 500 && n_at_marks > n_lines, "{n_lines} {n_at_marks}");
}

#[test]
fn no_label_lies_on_another_or_on_a_dashed_line() {
    let texts = Texts::new(Language::English, &[figure_texts(Language::English)]);
    let mut n_limits = 0;
    let (tree, rays) = octree();
    for_every_rail(&tree, &rays[..2], &mut |drawing, told| {
        let half = drawing.half_line();
        let labels: Vec<Label> = (0..3).flat_map(|axis| drawing.labels(axis)).collect();
        let boxes = labels.iter().map(|label| {
            let [left, middle] = label.at;
            ([left, middle - half], [left + label.width, middle + half])
        });
        let boxes: Vec<([f64; 2], [f64; 2])> = boxes.collect();
        for (n, (min, max)) in boxes.iter().enumerate() {
            let is_over = |(other_min, other_max): &&([f64; 2], [f64; 2])| {
                (0..2).all(|e| min[e] < other_max[e] - 1e-9 && other_min[e] < max[e] - 1e-9)
            };
            let over = boxes[n + 1..].iter().find(is_over);
            assert!(over.is_none(), "{told}: {:?} {min:?} over {over:?}", labels[n].text.plain());
        }
        let mut sheet = Sheet::default();
        drawing.draw(&mut sheet, &texts, None);
        let drawn = sheet.figure([1.0; 2]).drawn;
        for line in drawn.iter().filter(|drawn| drawn.role == Role::Limit) {
            let Form::Polyline(points) = &line.form else { continue };
            let [[x, top], [_, bottom]] = [points[0], points[1]];
            n_limits += 1;
            let crossed = boxes.iter().position(|(min, max)| {
                min[0] < x && x < max[0] && top < max[1] - 1e-9 && min[1] < bottom - 1e-9
            });
            let crossed = crossed.map(|n| labels[n].text.plain());
            assert_eq!(crossed, None, "{told}: a dashed line at {x}");
        }
    });
    assert!(n_limits > 1000, "{n_limits}");
}

#[test]
fn frames_of_odd_numbers_do_not_touch() {
    let (tree, rays) = octree();
    let mut n_pairs = 0;
    for_every_rail(&tree, &rays[2..3], &mut |drawing, told| {
        for labels in (1..3).map(|axis| drawing.labels(axis)) {
            for two in labels.windows(2).filter(|two| two.iter().all(|label| label.is_framed)) {
                assert!(two[1].at[0] - two[0].at[0] >= two[0].width + 5.0, "{told}");
                n_pairs += 1;
            }
        }
    });
    assert!(n_pairs > 20, "{n_pairs}");
}

#[test]
fn the_common_axis_is_seen_in_every_theme() {
    let (tree, ray) = (quadtree(), Ray::new([-1.0, 0.5], [2.0, 0.0]).unwrap());
    let moment =
        Moment { current: Some(NodeId::ROOT), tested: Some([0.5, 1.0]), ..Moment::default() };
    let figure = rail(&tree, &ray, &Query::default(), &moment).unwrap().figure;
    let levels = figure.drawn.iter().filter_map(|drawn| match &drawn.form {
        Form::Polyline(line) if line[0][1] == line[1][1] => Some((line[0][1], drawn.role)),
        _ => None,
    });
    let (_, lowest) = levels.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    for theme in Theme::ALL {
        let line = Style::of(theme, lowest).stroke.unwrap();
        assert!(contrast(line, Palette::of(theme).background) >= 3.0, "{theme:?}");
    }
}

#[test]
fn the_largest_parameters_lie_at_different_places_of_the_rail() {
    for reach in [1e308, f64::MAX] {
        let range = [-reach, reach];
        let [near, middle, far] = [-reach, 0.0, reach].map(|t| share_of(t, range));
        assert!(near < 0.1 && (middle - 0.5).abs() < 1e-12 && far > 0.9, "{near} {middle} {far}");
        assert!(at_share(0.75, range) > at_share(0.25, range));
    }
}

#[test]
fn labels_that_want_the_same_place_are_spread_in_their_order() {
    let check = |wanted: &[[f64; 2]], starts: &[f64]| {
        assert_eq!(spread(wanted, 2.0, [0.0, 100.0]), starts, "{wanted:?}");
    };
    check(&[[10.0, 20.0], [50.0, 20.0]], &[10.0, 50.0]);
    check(&[[40.0, 20.0], [40.0, 20.0]], &[29.0, 51.0]);
    check(&[[-5.0, 20.0], [-5.0, 20.0], [0.0, 10.0]], &[0.0, 22.0, 44.0]);
    check(&[[50.0, 20.0], [95.0, 20.0], [99.0, 20.0]], &[36.0, 58.0, 80.0]);
    check(&[[55.0, 30.0], [90.0, 30.0]], &[38.0, 70.0]);
}

/// Why the leaves are missed that are, one by one.
fn misses(origin: [f64; 2], direction: [f64; 2], segment_end: Option<f64>) -> Vec<String> {
    let (tree, ray) = (quadtree(), Ray::new(origin, direction).unwrap());
    let query = along(Algorithm::Exhaustive, segment_end);
    let trace = record(&tree, &ray, &query);
    let at = |step| rail(&tree, &ray, &query, &Moment::after(&tree, &trace, step))?.missed;
    (1..=trace.events.len()).filter_map(at).collect()
}

#[test]
fn a_missed_leaf_is_told_with_what_rules_it_out() {
    let check = |all: &[String], wanted: &str| {
        assert!(all.iter().any(|text| text == wanted), "{wanted}: {all:#?}");
    };
    let missed = misses([-1.0, 3.0], [2.0, -1.0], None);
    check(&missed, "exit 0.75 before enter 2: missed");
    // From the last corner of the root on, which its leaf is left in.
    let behind = misses([1.0, 1.0], [1.0, 1.0], None);
    check(&behind, "exit −0.5 < 0, behind the origin: missed");
    assert!(behind.iter().all(|text| !text.contains(" 0 < ")), "{behind:#?}");
    // Along the lowest row, for its first tenth.
    let beyond = misses([0.0, 0.01], [1.0, 0.0], Some(0.1));
    check(&beyond, "enter 0.5 ≥ end 0.1: not reached");
    check(&beyond, "beside the ray along y: missed");
}

#[test]
fn of_a_missed_leaf_no_interval_is_shaded() {
    let (tree, ray) = (quadtree(), Ray::new([-1.0, 0.5], [2.0, 0.0]).unwrap());
    let query = along(Algorithm::Exhaustive, Some(0.25));
    let shades = |moment: &Moment<2>| {
        let drawn = rail(&tree, &ray, &query, moment).unwrap().figure.drawn;
        drawn.iter().any(|drawn| drawn.role == Role::Inside)
    };
    let current = Some(NodeId::ROOT);
    let met = Moment { current, tested: Some([0.5, 1.0]), ..Moment::default() };
    let missed = Moment { current, missed: vec![NodeId::ROOT], ..Moment::default() };
    assert_eq!([shades(&met), shades(&missed)], [true, false]);
}

#[test]
fn the_ray_enters_and_leaves_in_the_picture_where_it_does_on_the_rail() {
    let (tree, mut random) = (quadtree(), Random::new(41));
    let mut n_ends = 0;
    for (algorithm, _) in Algorithm::ALL.iter().flat_map(|one| (0..6).map(move |n| (*one, n))) {
        let origin = [-0.1, random.unit()];
        let ray = Ray::new(origin, [1.0, random.between(-0.6, 0.6)]).unwrap();
        let query = along(algorithm, None);
        let trace = record(&tree, &ray, &query);
        for step in 1..=trace.events.len() {
            let moment = Moment::after(&tree, &trace, step);
            let Some(rail) = Rail::of(&moment) else { continue };
            let event = trace.events.get(step - 1);
            let show = Show::at_first::<2>();
            let all = marks(&tree, &ray, &query, &moment, event, &show);
            let place = |role: Role| {
                let of_role = all.iter().filter(|mark| mark.role == role && mark.node.is_some());
                let mut points = of_role.filter_map(|mark| match mark.shape {
                    Shape::Point(point) => Some(point),
                    _ => None,
                });
                points.next_back()
            };
            let is_here = match rail.of {
                RailOf::Cell(_) => true,
                RailOf::Node(node) => moment.current == Some(node),
                RailOf::LastLeaf(_) => false,
            };
            let limits = rail.limits();
            for (t, role) in limits.into_iter().zip([Role::EntryPoint, Role::ExitPoint]) {
                let Some(point) = place(role).filter(|_| is_here) else { continue };
                n_ends += 1;
                let away = distance(point, ray.at(t.max(0.0)));
                assert!(away < 1e-9, "{algorithm:?} step {step} {role:?}: {away}");
            }
        }
    }
    assert!(n_ends > 1000, "{n_ends}");
}
