//! No box, plane or line is drawn over what hides it.

use super::*;
use crate::{Lens, Page};
use octoscope_core::random::Random;

const ROOT: Aabb<3> = Aabb { min: [0.0; 3], max: [1.0; 3] };
const PAGE: Page = Page { width: 800.0, height: 600.0 };

/// Leaves of a random octree.
fn leaves(random: &mut Random, cell: Aabb<3>, depth: u8, into: &mut Vec<Aabb<3>>) {
    if depth == 0 || random.between(0.0, 1.0) < 0.4 {
        into.push(cell);
        return;
    }
    let middle = cell.centre();
    for octant in 0..8 {
        let upper = |e: usize| octant >> e & 1 == 1;
        let part = Aabb {
            min: std::array::from_fn(|e| if upper(e) { middle[e] } else { cell.min[e] }),
            max: std::array::from_fn(|e| if upper(e) { cell.max[e] } else { middle[e] }),
        };
        leaves(random, part, depth - 1, into);
    }
}

fn front(painted: Painted<3>) -> Option<usize> {
    match painted {
        Painted::Half(index, Half::Front) => Some(index),
        Painted::Half(_, Half::Behind) | Painted::Flat(..) | Painted::Piece(..) => None,
    }
}

/// Where the line of sight to `point` is in a box: distances from the eye in
/// units of that to the point.
fn sight_through(camera: &Camera<3>, point: [f64; 3], bounds: &Aabb<3>) -> Option<[f64; 2]> {
    let back = camera.towards_eye(point);
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for e in 0..3 {
        let [a, b] = [bounds.min[e], bounds.max[e]].map(|x| 1.0 - (x - point[e]) / back[e]);
        (enter, exit) = (enter.max(a.min(b)), exit.min(a.max(b)));
    }
    (enter < exit && exit > 0.0).then_some([enter, exit])
}

#[test]
fn a_line_is_drawn_after_what_it_hides_and_before_what_hides_it() {
    let mut random = Random::new(11);
    let (mut n_before, mut n_inside, mut n_after) = (0, 0, 0);
    for _ in 0..60 {
        let mut boxes = vec![ROOT];
        leaves(&mut random, ROOT, 3, &mut boxes);
        // Ancestors of some of them, as nodes on a stack.
        boxes.extend([0.5, 0.25].map(|side| Aabb { min: [0.0; 3], max: [side; 3] }));
        let mut point = || std::array::from_fn(|_| random.between(-0.5, 1.5));
        let lines = [[point(), point()], [point(), point()]];
        let mut camera = Camera::framing(&ROOT, PAGE);
        camera.yaw = random.between(0.0, 6.3);
        camera.pitch = random.between(-1.5, 1.5);
        if random.between(0.0, 1.0) < 0.5 {
            camera.lens = Lens::Orthographic;
        }
        let order = back_to_front(&ROOT, &boxes, &lines, &camera);
        let place = |wanted| order.iter().position(|p| *p == wanted).unwrap();
        let mut lengths = [0.0; 2];
        for (at, painted) in order.iter().enumerate() {
            let Painted::Piece(line, [from, to]) = *painted else { continue };
            lengths[line] += to - from;
            for share in [0.03, 0.3, 0.5, 0.7, 0.97] {
                let point = at_share(lines[line], from + share * (to - from));
                for (index, bounds) in boxes.iter().enumerate() {
                    let Some([enter, exit]) = sight_through(&camera, point, bounds) else {
                        continue;
                    };
                    let [behind, front] =
                        [Half::Behind, Half::Front].map(|half| place(Painted::Half(index, half)));
                    if exit < 1.0 - 1e-9 {
                        assert!(at < behind, "{painted:?} lies beyond {bounds:?}");
                        n_after += 1;
                    } else if enter > 1.0 + 1e-9 {
                        assert!(at > front, "{painted:?} lies before {bounds:?}");
                        n_before += 1;
                    } else if enter < 1.0 - 1e-9 && exit > 1.0 + 1e-9 {
                        assert!(behind < at && at < front, "{painted:?} is in {bounds:?}");
                        n_inside += 1;
                    }
                }
            }
        }
        assert!(lengths.iter().all(|length| (length - 1.0).abs() < 1e-9), "{lengths:?}");
    }
    assert!(n_before > 1000 && n_inside > 1000 && n_after > 1000);
}

#[test]
fn of_equal_boxes_the_later_one_is_drawn_last() {
    let camera = Camera::framing(&ROOT, PAGE);
    let order = back_to_front(&ROOT, &[ROOT, ROOT], &[[[0.1; 3], [0.9; 3]]], &camera);
    let whole = Painted::Piece(0, [0.0, 1.0]);
    let half = Painted::Half;
    let wanted = [half(1, Half::Behind), half(0, Half::Behind), whole];
    assert_eq!(order[..3], wanted);
    assert_eq!(order[3..], [half(0, Half::Front), half(1, Half::Front)]);
}

#[test]
fn a_line_through_nested_boxes_is_cut_where_it_enters_and_leaves_them() {
    let nested = [1.0, 0.5, 0.25].map(|side| Aabb { min: [0.0; 3], max: [side; 3] });
    let camera = Camera { yaw: 0.3, pitch: 0.4, ..Camera::framing(&ROOT, PAGE) };
    let line = [[0.9, 0.15, 0.2], [-0.6, 0.1, 0.1]];
    let order = back_to_front(&ROOT, &nested, &[line], &camera);
    let pieces = order.iter().filter(|p| matches!(p, Painted::Piece(..))).count();
    // Beyond, in the smallest, in the middle one, in the largest.
    assert_eq!(pieces, 4, "{order:?}");
}

/// Whether a line of sight can meet `a` before `b`: no plane that parts them
/// has `b` on the eye's side.
fn may_hide(camera: &Camera<3>, a: &Aabb<3>, b: &Aabb<3>) -> bool {
    (0..3).all(|e| {
        let above = |plane: f64| camera.towards_eye([plane; 3])[e] > 0.0;
        let parted_below = a.max[e] <= b.min[e] && above(a.max[e]);
        let parted_above = b.max[e] <= a.min[e] && !above(a.min[e]);
        !(parted_below || parted_above)
    })
}

#[test]
fn no_box_is_drawn_over_one_that_hides_it() {
    let mut random = Random::new(3);
    for _ in 0..20 {
        let mut boxes = Vec::new();
        leaves(&mut random, ROOT, 3, &mut boxes);
        let mut camera = Camera::framing(&ROOT, PAGE);
        camera.yaw = random.between(0.0, 6.3);
        camera.pitch = random.between(-1.5, 1.5);
        camera.height = random.between(0.1, 3.0);
        if random.between(0.0, 1.0) < 0.5 {
            camera.lens = Lens::Orthographic;
        }
        let order = back_to_front(&ROOT, &boxes, &[], &camera);
        assert_eq!(order.len(), 2 * boxes.len());
        let order: Vec<usize> = order.into_iter().filter_map(front).collect();
        for (place, &late) in order.iter().enumerate() {
            for &early in &order[..place] {
                let [early, late] = [&boxes[early], &boxes[late]];
                let wrong = may_hide(&camera, early, late) && !may_hide(&camera, late, early);
                assert!(!wrong, "{early:?} is covered by {late:?}");
            }
        }
    }
}

#[test]
fn a_box_is_drawn_around_what_lies_in_it_and_a_plane_between_its_halves() {
    let half = |e: usize, upper: bool| {
        let mut part = Aabb { min: [0.0; 3], max: [0.5; 3] };
        if upper {
            (part.min[e], part.max[e]) = (0.5, 1.0);
        }
        part
    };
    let plane = Aabb { min: [0.5, 0.0, 0.0], max: [0.5, 1.0, 1.0] };
    let boxes = [half(0, true), plane, ROOT, half(0, false)];
    let camera = Camera { yaw: 0.0, pitch: 0.0, ..Camera::framing(&ROOT, PAGE) };
    let order = back_to_front(&ROOT, &boxes, &[], &camera);
    let whole = |painted: Painted<3>| match painted {
        Painted::Flat(index, bounds) => Some((index, bounds == plane)),
        Painted::Half(index, Half::Front) => Some((index, true)),
        Painted::Half(_, Half::Behind) | Painted::Piece(..) => None,
    };
    let fronts: Vec<_> = order.iter().copied().filter_map(whole).collect();
    assert_eq!(order[0], Painted::Half(2, Half::Behind));
    assert_eq!(fronts, [(3, true), (1, true), (0, true), (2, true)]);
}

#[test]
fn a_plane_on_a_side_is_drawn_before_the_box_or_after_it_as_the_side_faces_the_eye() {
    let side = |at: f64| Aabb { min: [at, 0.0, 0.0], max: [at, 1.0, 1.0] };
    // Something that parts the cell.
    let within = Aabb { min: [0.0; 3], max: [0.5; 3] };
    for yaw in [0.3, 3.4] {
        let camera = Camera { yaw, ..Camera::framing(&ROOT, PAGE) };
        let order = back_to_front(&ROOT, &[ROOT, side(0.0), side(1.0), within], &[], &camera);
        let at = |wanted: &dyn Fn(&Painted<3>) -> bool| order.iter().position(wanted).unwrap();
        let front = at(&|painted| *painted == Painted::Half(0, Half::Front));
        let near = usize::from(camera.towards_eye(ROOT.max)[0] > 0.0) + 1;
        let flat = |index: usize| {
            at(&|painted| matches!(painted, Painted::Flat(other, _) if *other == index))
        };
        assert!(flat(near) > front && flat(3 - near) < front, "{order:?}");
    }
}

#[test]
fn planes_that_cross_each_other_are_cut_where_they_do() {
    let plane = |axis: usize| {
        let mut bounds = ROOT;
        (bounds.min[axis], bounds.max[axis]) = (0.5, 0.5);
        bounds
    };
    let boxes = [ROOT, plane(0), plane(1), plane(2)];
    let mut random = Random::new(5);
    for _ in 0..40 {
        let mut camera = Camera::framing(&ROOT, PAGE);
        camera.yaw = random.between(0.0, 6.3);
        camera.pitch = random.between(-1.5, 1.5);
        let order = back_to_front(&ROOT, &boxes, &[], &camera);
        let parts: Vec<(usize, Aabb<3>)> = order
            .iter()
            .filter_map(|painted| match *painted {
                Painted::Flat(index, bounds) => Some((index, bounds)),
                Painted::Half(..) | Painted::Piece(..) => None,
            })
            .collect();
        for (late, (index, bounds)) in parts.iter().enumerate() {
            for (other, earlier) in &parts[..late] {
                let wrong = may_hide(&camera, earlier, bounds)
                    && !may_hide(&camera, bounds, earlier)
                    && other != index;
                assert!(!wrong, "{earlier:?} is covered by {bounds:?}");
            }
        }
        for index in 1..4 {
            let own = parts.iter().filter(|(other, _)| *other == index);
            let area: f64 =
                own.map(|(_, b)| b.size().into_iter().filter(|x| *x > 0.0).product::<f64>()).sum();
            assert!((area - 1.0).abs() < 1e-9, "{area}");
        }
    }
}

#[test]
fn planes_off_the_middle_of_everything_are_parted_by_each_other_alone() {
    let plane = |axis: usize| {
        let mut bounds = Aabb { min: [0.13; 3], max: [0.77; 3] };
        (bounds.min[axis], bounds.max[axis]) = (0.31, 0.31);
        bounds
    };
    let camera = Camera { yaw: 0.5, pitch: 0.3, ..Camera::framing(&ROOT, PAGE) };
    let lines = [[[-0.4, 0.2, 0.3], [1.4, 0.5, 0.6]]];
    for around in [vec![], vec![Aabb { min: [0.1; 3], max: [0.8; 3] }, ROOT]] {
        let boxes = [vec![plane(0), plane(1), plane(2)], around].concat();
        let order = back_to_front(&ROOT, &boxes, &lines, &camera);
        let n_parts = order.iter().filter(|p| matches!(p, Painted::Flat(..))).count();
        // One whole, the next one halved, the last one in quarters; more where boxes
        // are, but not many more.
        assert!((7..300).contains(&n_parts), "{n_parts} parts");
    }
}

#[test]
fn halves_and_quarters_of_a_node_are_drawn_beside_each_other() {
    let part = |min: [f64; 3], max: [f64; 3]| Aabb { min, max };
    let boxes = [
        part([0.0; 3], [0.5, 1.0, 1.0]),
        part([0.5, 0.0, 0.0], [1.0, 0.5, 1.0]),
        part([0.5, 0.5, 0.0], [1.0, 1.0, 0.5]),
        part([0.5, 0.5, 0.5], [1.0; 3]),
    ];
    let mut random = Random::new(9);
    for _ in 0..40 {
        let mut camera = Camera::framing(&ROOT, PAGE);
        camera.yaw = random.between(0.0, 6.3);
        camera.pitch = random.between(-1.5, 1.5);
        let order = back_to_front(&ROOT, &boxes, &[], &camera);
        for index in 0..4 {
            let behind = Painted::Half(index, Half::Behind);
            let at = order.iter().position(|painted| *painted == behind).unwrap();
            assert_eq!(order[at + 1], Painted::Half(index, Half::Front), "{order:?}");
        }
        let fronts: Vec<usize> = order.into_iter().filter_map(front).collect();
        for (late, &index) in fronts.iter().enumerate() {
            for &earlier in &fronts[..late] {
                let [a, b] = [&boxes[earlier], &boxes[index]];
                assert!(!may_hide(&camera, a, b) || may_hide(&camera, b, a), "{a:?} {b:?}");
            }
        }
    }
}
