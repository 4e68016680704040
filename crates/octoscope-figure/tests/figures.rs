//! Whole figures: from a tree and a ray to SVG and PNG.

#[path = "shared/corner_tree.rs"]
mod corner_tree;

use corner_tree::corner_tree;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::scene::Content;
use octoscope_core::trace::{Moment, record};
use octoscope_core::traverse::{Algorithm, Options};
use octoscope_core::tree::{Domain, Split, Tree, grow};
use octoscope_figure::{
    Background, Camera, Drawn, Figure, FileOptions, Form, Mark, Page, Part, Role, Scale, Shape,
    Show, Theme, Unit, axes, cells, content, far_end, marks, pdf, png, space_figure, svg,
};

fn along_the_ray<const D: usize>() -> Query<D> {
    Query::Ray {
        algorithm: Algorithm::Parametric,
        options: Options::default(),
        arithmetic: Arithmetic::Doubles,
    }
}

/// Figure after `step` events.
fn figure<const D: usize>(step: usize, show: &Show) -> Figure {
    let tree = corner_tree::<D>(2);
    let ray = Ray::new([-0.25; D], std::array::from_fn(|e| 1.5 + 0.25 * e as f64));
    let ray = ray.expect("the direction is not zero");
    let query = along_the_ray();
    let trace = record(&tree, &ray, &query);
    let moment = Moment::after(&tree, &trace, step);
    let event = step.min(trace.events.len()).checked_sub(1).map(|last| &trace.events[last]);
    let page = Page { width: 240.0, height: 240.0 };
    let camera = Camera::framing(&tree.domain().root_box(), page);
    let mut all = cells(&tree, show, None);
    all.extend(axes(tree.domain(), show, &camera));
    all.extend(content(&Content::Points(vec![[0.125; D]]), None));
    all.extend(marks(&tree, &ray, &query, &moment, event, show));
    space_figure(&all, &camera, page).cropped(4.0)
}

#[test]
fn a_small_figure_is_written_as_expected() {
    let options = FileOptions {
        title: "Corner",
        scenario: r#"{"octoscope":1,"note":"a<b"}"#,
        ..FileOptions::default()
    };
    let text = svg(&figure::<2>(4, &Show::default()), &options);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/figures/corner.svg");
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(path, &text).unwrap();
    }
    assert_eq!(text, include_str!("figures/corner.svg"), "UPDATE_EXPECT=1 writes it anew");
}

#[test]
fn the_same_scene_gives_the_same_figure() {
    assert_eq!(figure::<3>(9, &Show::default()), figure::<3>(9, &Show::default()));
}

#[test]
fn every_step_is_drawn_within_the_page_in_every_theme() {
    for step in 0..30 {
        for figure in [figure::<2>(step, &everything()), figure::<3>(step, &everything())] {
            assert!(figure.drawn.len() > 5);
            let numbers: Vec<f64> = figure
                .drawn
                .iter()
                .filter_map(|drawn| match &drawn.form {
                    Form::Polygon(points) => Some(points.concat()),
                    _ => None,
                })
                .flatten()
                .collect();
            let side = figure.page.width.max(figure.page.height);
            assert!(numbers.iter().all(|x| (0.0..=side).contains(x)));
            for theme in Theme::ALL {
                let text = svg(&figure, &FileOptions { theme, ..FileOptions::default() });
                assert!(!text.contains("NaN") && !text.contains("inf"));
            }
        }
    }
}

fn everything() -> Show {
    Show {
        order_numbers: true,
        half_open_sides: true,
        codes: true,
        mirrored_ray: true,
        content: true,
        empty_leaves: true,
        ancestors: true,
        children: true,
        ..Show::default()
    }
}

#[test]
fn a_png_has_the_size_that_is_asked_for() {
    let figure = figure::<3>(9, &Show::default());
    for background in [Background::Filled, Background::Transparent] {
        let scale = Scale { factor: 300.0 / figure.page.width, unit: Unit::Pixel };
        let options = FileOptions { background, scale, ..FileOptions::default() };
        let file = png(&figure, &options).unwrap();
        let picture = resvg::tiny_skia::Pixmap::decode_png(&file).unwrap();
        let height = (300.0 * figure.page.height / figure.page.width).round() as u32;
        assert_eq!((picture.width(), picture.height()), (300, height));
        let corner = picture.pixel(0, 0).unwrap().alpha();
        assert_eq!(corner, if background == Background::Filled { 255 } else { 0 });
    }
}

#[test]
fn absurd_sizes_are_refused() {
    let figure = figure::<2>(0, &Show::default());
    for factor in [0.0001, 60.0, 1e9, f64::NAN] {
        let scale = Scale { factor, unit: Unit::Pixel };
        let options = FileOptions { scale, ..FileOptions::default() };
        let message = png(&figure, &options).unwrap_err().to_string();
        assert!(message.contains("1 to 16384"), "{factor}: {message}");
        if factor != 60.0 {
            let message = pdf(&figure, &options).unwrap_err().to_string();
            assert!(message.contains("1 to 14400"), "{factor}: {message}");
        }
    }
}

#[test]
fn letters_are_drawn() {
    let with = |label: &str| {
        let mark = Mark::new(Shape::Label([0.5, 0.5]), Role::ChildIndex);
        let page = Page { width: 40.0, height: 40.0 };
        let camera = Camera::framing(&corner_tree::<2>(2).domain().root_box(), page);
        let figure = space_figure(&[mark.with_text(label)], &camera, page);
        let options = FileOptions { background: Background::Transparent, ..FileOptions::default() };
        let file = png(&figure, &options).unwrap();
        let picture = resvg::tiny_skia::Pixmap::decode_png(&file).unwrap();
        picture.pixels().iter().filter(|pixel| pixel.alpha() > 0).count()
    };
    assert!(with("8") > 20);
    assert!(with("∧") > 5, "signs that only the mono has");
}

#[test]
fn the_marks_of_a_moment_follow_the_path_not_the_tree() {
    let tree = corner_tree::<2>(2);
    let ray = Ray::new([-0.25, -0.25], [1.5, 1.5]).unwrap();
    let query = along_the_ray();
    let trace = record(&tree, &ray, &query);
    let moment = Moment::after(&tree, &trace, trace.events.len());
    let all = marks(&tree, &ray, &query, &moment, trace.events.last(), &Show::default());
    let visited = all.iter().filter(|mark| matches!(mark.role, Role::Visited { .. })).count();
    assert_eq!(visited, trace.leaves().count());
    assert!(all.iter().all(|mark| mark.role != Role::Current), "nothing stays lit at the end");
}

#[test]
fn marks_of_the_slowest_ray_have_places() {
    let (tree, query) = (corner_tree::<2>(2), along_the_ray());
    for speed in [1e-200, 5e-324] {
        let ray = Ray::new([0.5, 0.25], [speed, 0.0]).expect("the direction is not zero");
        let trace = record(&tree, &ray, &query);
        let moment = Moment::after(&tree, &trace, 0);
        let marks = marks(&tree, &ray, &query, &moment, None, &Show::default());
        let shaft = marks.iter().find(|mark| mark.role == Role::Ray).expect("the ray is shown");
        let Shape::Arrow(ends) = shaft.shape else { panic!("the ray is an arrow") };
        assert!(ends.iter().flatten().all(|x| x.is_finite()), "{speed}: {ends:?}");
    }
}

#[test]
fn the_ray_is_an_arrow_up_to_where_it_is_asked_about() {
    let tree = corner_tree::<2>(2);
    let ray = Ray::new([-0.25, 0.25], [1.0, 0.0]).unwrap();
    let check = |segment_end, expected: [Option<[f64; 2]>; 2]| {
        let options = Options { segment_end, ..Options::default() };
        let query = Query::Ray {
            algorithm: Algorithm::Parametric,
            options,
            arithmetic: Arithmetic::Doubles,
        };
        let moment = Moment::after(&tree, &record(&tree, &ray, &query), 0);
        let marks = marks(&tree, &ray, &query, &moment, None, &Show::default());
        let ends = [Role::Ray, Role::RayBeyond].map(|role| {
            marks.iter().find(|mark| mark.role == role).map(|mark| match mark.shape {
                Shape::Arrow([_, to]) | Shape::Segment([_, to]) => to,
                _ => panic!("{role:?} is a line"),
            })
        });
        assert_eq!(ends, expected, "{segment_end:?}");
    };
    let far = Some(far_end(&tree, &ray));
    check(None, [far, None]);
    check(Some(f64::INFINITY), [far, None]);
    check(Some(9.0), [far, None]);
    check(Some(0.5), [Some([0.25, 0.25]), far]);
    check(Some(-1.0), [Some(ray.origin()), far]);
}

#[test]
fn a_child_is_rejected_unless_a_leaf_in_it_was_visited() {
    let (tree, query) = (corner_tree::<2>(2), along_the_ray());
    let ray = Ray::new([-0.25, -0.2], [1.5, 1.25]).unwrap();
    let trace = record(&tree, &ray, &query);
    let (mut n_rejected, mut n_passed) = (0, 0);
    for step in 1..=trace.events.len() {
        let moment = Moment::after(&tree, &trace, step);
        let all = marks(&tree, &ray, &query, &moment, trace.events.get(step - 1), &everything());
        let of = |wanted: Role| all.iter().filter(move |m| m.role == wanted).filter_map(|m| m.node);
        for child in of(Role::ChildIndex) {
            let bounds = tree.node_box(child);
            let mut inside = moment.leaves.iter().map(|leaf| tree.node_box(leaf.node).centre());
            let passed = inside.any(|middle| bounds.owns(middle));
            let rejected = of(Role::Rejected).any(|node| node == child);
            assert!(!(passed && rejected), "step {step}: {child:?}");
            n_rejected += usize::from(rejected);
            n_passed += usize::from(passed);
        }
    }
    assert!(n_rejected > 0 && n_passed > 0);
}

/// Discs of the order numbers in a figure of a ray through many small leaves.
fn discs_of_a_long_path<const D: usize>() -> Vec<[f64; 2]> {
    let place = |t: f64| std::array::from_fn(|e| t * (1.0 - 0.25 * e as f64));
    let path = (0..200).map(|n| {
        let chord = [n, n + 1].map(|n| place(f64::from(n) / 200.0));
        Mark::new(Shape::LabelAlong(chord), Role::OrderNumber).with_text((n + 1).to_string())
    });
    let marks: Vec<Mark<D>> = path.collect();
    let page = Page { width: 640.0, height: 480.0 };
    let camera = Camera::framing(&corner_tree::<D>(2).domain().root_box(), page);
    let figure = space_figure(&marks, &camera, page);
    let shown = figure.drawn.iter().filter(|drawn| drawn.role == Role::OrderNumber);
    let texts: Vec<_> = shown
        .clone()
        .filter_map(|drawn| match &drawn.form {
            Form::Text { text, .. } => Some(text.plain()),
            _ => None,
        })
        .collect();
    for order in ["1", "50", "100", "200"] {
        assert!(texts.iter().any(|text| text == order), "{order} of {texts:?}");
    }
    let discs = shown.filter_map(|drawn| match drawn.form {
        Form::Circle { centre, .. } => Some(centre),
        _ => None,
    });
    discs.collect()
}

#[test]
fn numbers_of_a_long_path_can_be_told_apart() {
    for discs in [discs_of_a_long_path::<2>(), discs_of_a_long_path::<3>()] {
        for (index, a) in discs.iter().enumerate() {
            for b in &discs[..index] {
                assert!((a[0] - b[0]).hypot(a[1] - b[1]) > 18.0, "{a:?} {b:?}");
            }
        }
    }
}

/// Figure of a cube that is divided into 8 · 8 · 8 leaves.
fn figure_of_a_cube(leaf: Split<Vec<()>>) -> Figure {
    let tree: Tree<3> = grow(Domain::unit(3), (), &Progress::default(), |cell, ()| {
        if cell.level == 0 { leaf.clone() } else { Split::Inner(vec![(); 8]) }
    })
    .expect("nobody cancels");
    let page = Page { width: 640.0, height: 480.0 };
    let camera = Camera::framing(&tree.domain().root_box(), page);
    space_figure(&cells(&tree, &everything(), None), &camera, page)
}

#[test]
fn only_what_can_be_seen_of_full_leaves_is_drawn() {
    let figure = figure_of_a_cube(Split::Full(Vec::new()));
    assert_eq!(figure.drawn.len(), 3 * 8 * 8, "the sides of the cube that face the eye");
}

#[test]
fn edges_that_leaves_share_are_drawn_once() {
    assert_eq!(figure_of_a_cube(Split::Empty).drawn.len(), 3 * 9 * 9);
}

#[test]
fn lines_of_tiny_leaves_are_fine() {
    let tree = corner_tree::<2>(2);
    let part = |side: f64| {
        let page = Page { width: side, height: side };
        let camera = Camera::framing(&tree.domain().root_box(), page);
        let figure = space_figure(&cells(&tree, &everything(), None), &camera, page);
        figure.drawn.iter().filter(|drawn| drawn.part == Part::Fine).count()
    };
    assert_eq!([part(400.0), part(70.0)], [0, 4]);
}

#[test]
fn small_nodes_are_not_written_on() {
    let n_texts = |side: f64| {
        let tree = corner_tree::<2>(2);
        let (ray, query) = (Ray::new([-0.25; 2], [1.5, 1.25]).unwrap(), along_the_ray());
        let trace = record(&tree, &ray, &query);
        let step = 4;
        let moment = Moment::after(&tree, &trace, step);
        let all = marks(&tree, &ray, &query, &moment, trace.events.get(step - 1), &everything());
        let page = Page { width: side, height: side };
        let camera = Camera::framing(&tree.domain().root_box(), page);
        let figure = space_figure(&all, &camera, page);
        let is_text = |drawn: &&Drawn| matches!(drawn.form, Form::Text { .. });
        figure.drawn.iter().filter(is_text).count()
    };
    assert!(n_texts(400.0) >= 4, "{}", n_texts(400.0));
    assert_eq!(n_texts(30.0), 0);
}
