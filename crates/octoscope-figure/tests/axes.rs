//! Numbers and letters of the axes, on every page and from every side.

use octoscope_core::random::Random;
use octoscope_core::tree::Domain;
use octoscope_figure::{
    Camera, Figure, Form, Lens, Mark, Page, Role, Shape, Show, axes, metrics, space_figure,
};
use std::f64::consts::{FRAC_PI_2, TAU};

#[test]
fn the_numbers_of_the_axes_stand_on_a_page_of_any_size_and_beside_the_root() {
    let domain = Domain::<2>::unit(7);
    for [width, height] in [[300.0, 300.0], [400.0, 300.0], [200.0, 600.0], [1280.0, 720.0]] {
        let (page, bounds) = (Page { width, height }, domain.root_box());
        let camera = Camera::framing(&bounds, page);
        let root = camera.project(page, bounds.min).unwrap().at;
        for drawn in space_figure(&axes(&domain, &Show::default(), &camera), &camera, page).drawn {
            let Form::Text { at, text, .. } = drawn.form else { panic!("{:?}", drawn.form) };
            let text = text.plain();
            let half = 0.5 * 6.8 * text.len() as f64;
            assert!(at[0] >= half && at[0] + half <= width && at[1] + 6.0 <= height, "{at:?}");
            assert!(at[0] + half < root[0] || at[1] > root[1] + 6.0, "{text} at {at:?}");
        }
    }
}

#[test]
fn the_numbers_of_an_axis_are_even_and_apart_however_small_the_page_and_whatever_the_ray() {
    let (domain, mut random, mut n_numbers) = (Domain::<2>::unit(7), Random::new(12), 0);
    for n in 0..400 {
        let side = 60.0 + f64::from(n % 40) * 8.0;
        let page = Page { width: side, height: side };
        let camera = Camera::framing(&domain.root_box(), page);
        let mut marks = axes(&domain, &Show::default(), &camera);
        let mut on_page = || [0; 2].map(|_| random.between(-0.4, 1.4));
        marks.push(Mark::new(Shape::Arrow([on_page(), on_page()]), Role::Ray));
        let figure = space_figure(&marks, &camera, page);
        for axis in 0..2 {
            let of_axis = figure.drawn.iter().filter(|drawn| drawn.role == Role::AxisLabel(axis));
            let texts = of_axis.filter_map(|drawn| match &drawn.form {
                Form::Text { at, text, .. } => {
                    let reach = [metrics::width(drawn.role, text), metrics::size(drawn.role)];
                    Some((at[axis], 0.5 * reach[axis], text.plain().parse::<f64>().unwrap()))
                }
                _ => None,
            });
            let mut texts: Vec<_> = texts.collect();
            texts.sort_by(|a, b| a.2.total_cmp(&b.2));
            for pair in texts.windows(2) {
                let apart = (pair[0].0 - pair[1].0).abs() - pair[0].1 - pair[1].1;
                assert!(apart >= 3.0, "{apart} between {pair:?} on {side}");
            }
            // But for those that the ray crosses.
            let steps = || texts.windows(2).map(|pair| pair[1].2 - pair[0].2);
            let step = steps().fold(f64::INFINITY, f64::min);
            assert!(steps().all(|by| (by / step).fract() == 0.0), "{texts:?}");
            n_numbers += texts.len();
        }
    }
    assert!(n_numbers > 1500, "{n_numbers}");
}

#[test]
fn axes_are_told_in_the_coordinates_of_the_ray_and_in_codes_where_these_are_shown() {
    let domain = Domain::<2>::new([-100.0, 0.0], 512.0, 5).unwrap();
    let texts = |codes: bool| -> Vec<String> {
        let camera = Camera::framing(&domain.root_box(), Page { width: 1.0, height: 1.0 });
        let marks = axes(&domain, &Show { codes, ..Show::default() }, &camera);
        let x = marks.into_iter().filter(|mark| mark.role == Role::AxisLabel(0));
        x.filter_map(|mark| mark.text).collect()
    };
    assert_eq!(texts(false), ["−100", "28", "156", "284", "412"]);
    assert_eq!(texts(true), ["0", "8", "16", "24", "32"]);
}

const PAGE: Page = Page { width: 480.0, height: 400.0 };

/// Root and axes of a space domain as they are seen from here.
fn seen_from(camera: &Camera<3>, domain: &Domain<3>) -> Figure {
    let mut marks = axes(domain, &Show::default(), camera);
    marks.push(Mark::new(Shape::Box(domain.root_box()), Role::Root));
    space_figure(&marks, camera, PAGE)
}

/// The letters in a figure, with the middle and half extent of each.
fn letters(figure: &Figure) -> Vec<(String, [f64; 2], [f64; 2])> {
    let letter = |drawn: &octoscope_figure::Drawn| {
        let Form::Text { at, text, .. } = &drawn.form else { return None };
        let reach = [0.5 * metrics::width(drawn.role, text), 0.4 * metrics::size(drawn.role)];
        Some((text.plain(), *at, reach))
    };
    figure.drawn.iter().filter_map(letter).collect()
}

/// Whether a rectangle lies on the far side of some line between two of `points` that
/// has all of them on the other: outside of their hull.
fn is_outside(points: &[[f64; 2]], at: [f64; 2], reach: [f64; 2]) -> bool {
    let pairs = points.iter().flat_map(|a| points.iter().map(move |b| (a, b)));
    pairs.into_iter().filter(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) > 1e-6).any(|(a, b)| {
        let across = [b[1] - a[1], a[0] - b[0]];
        let side = |p: [f64; 2]| across[0] * (p[0] - a[0]) + across[1] * (p[1] - a[1]);
        let nearest = side(at) - across[0].abs() * reach[0] - across[1].abs() * reach[1];
        nearest > 0.0 && points.iter().all(|p| side(*p) < 1e-6)
    })
}

#[test]
fn letters_of_the_axes_stand_outside_of_the_root_from_every_side() {
    let domain = Domain::<3>::new([-3.0, 2.0, 10.0], 4.0, 3).unwrap();
    let mut random = Random::new(7);
    let mut n_whole = 0;
    for index in 0..400 {
        let mut camera = Camera::framing(&domain.root_box(), PAGE);
        camera.yaw = random.between(0.0, TAU);
        camera.pitch = random.between(-FRAC_PI_2, FRAC_PI_2);
        camera.lens = Lens::ALL[index % 2];
        camera.frame(&domain.root_box(), PAGE);
        let bounds = domain.root_box();
        let corner = |n: usize| {
            std::array::from_fn(|e| if n >> e & 1 == 1 { bounds.max[e] } else { bounds.min[e] })
        };
        let corners: Vec<[f64; 2]> =
            (0..8).map(|n| camera.project(PAGE, corner(n)).unwrap().at).collect();
        let letters = letters(&seen_from(&camera, &domain));
        for (letter, at, reach) in &letters {
            assert!(is_outside(&corners, *at, *reach), "{letter} at {at:?} in {camera:?}");
        }
        // One axis may point at the eye.
        assert!(letters.len() >= 2, "{letters:?} in {camera:?}");
        n_whole += usize::from(letters.len() == 3);
    }
    assert!(n_whole > 250, "{n_whole} of 400 show all three axes");
}

#[test]
fn from_inside_the_axes_are_those_through_the_least_corner() {
    let domain = Domain::<3>::unit(3);
    let mut camera = Camera::framing(&domain.root_box(), PAGE);
    camera.height = 0.1;
    for mark in axes(&domain, &Show::default(), &camera) {
        let Shape::Segment([from, _]) = mark.shape else { panic!("{mark:?}") };
        assert_eq!(from, [0.0; 3]);
    }
}
