//! Pictures read back pixel by pixel. They need a graphics driver; software
//! will do (`mesa-vulkan-drivers`). Without one they are not run, which is a failure
//! where `CI` is set, or `TEST_GPU`.

use super::*;
use eframe::egui::{self, Color32, ColorImage, Id};
use eframe::egui_wgpu::RendererOptions;
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};
use glam::camera::rh::{proj::directx, view};
use glam::{Mat4, Vec3};
use std::io::Write;
use std::sync::{Mutex, OnceLock};

const ORANGE: Color32 = Color32::from_rgb(0xE6, 0x9F, 0x00);
const GRID: Grid = Grid { min: [0.0; 3], cell: 1.0, root_level: 2 };

/// Runs a test on the one device of all tests, or says why not.
fn with_gpu(test: impl FnOnce(&mut Gpu)) {
    static GPU: OnceLock<Option<Mutex<Gpu>>> = OnceLock::new();
    let gpu = GPU.get_or_init(|| match Gpu::new() {
        Ok(gpu) => Some(Mutex::new(gpu)),
        Err(error) => {
            let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
            assert!(!is_set("CI") && !is_set("TEST_GPU"), "{error}");
            // Written to the stream itself: what a test that passes prints is not shown.
            let mut stream = std::io::stderr().lock();
            writeln!(stream, "NOT RUN: tests of the picture; {error}").unwrap();
            None
        }
    });
    if let Some(gpu) = gpu {
        test(&mut gpu.lock().unwrap_or_else(|poisoned| poisoned.into_inner()));
    }
}

/// Camera at `from` that looks at the middle of [`GRID`].
fn looking_from(from: Vec3) -> View {
    let seen = view::look_at_mat4(from, Vec3::splat(2.0), Vec3::Y);
    let clip_from_offset = directx::perspective(0.7, 1.0, 0.1, 100.0) * seen;
    View::Space(Space { origin: [0.0; 3], clip_from_offset })
}

fn front() -> View {
    looking_from(Vec3::new(2.0, 2.0, 12.0))
}

fn picture(view: View, layers: Vec<Layer>) -> Picture {
    Picture { view, slice: [0.0; 4], layers, background: Color32::WHITE }
}

fn drawn(gpu: &mut Gpu, picture: &Picture) -> ColorImage {
    render_to_image(gpu, picture, [64, 64], 1.0).unwrap()
}

fn mark(fill: Color32) -> BoxMark {
    let edge = Color32::TRANSPARENT;
    let (line, is_crossed) = (Line::Solid, false);
    let [min, max] = [[1.0; 3], [3.0; 3]];
    BoxMark { min, max, fill, edge, width: 1.0, line, layer: 0, is_crossed }
}

#[test]
fn opaque_faces_have_exactly_the_colour_asked_for() {
    with_gpu(|gpu| {
        let image = drawn(gpu, &picture(front(), vec![Layer::marks(vec![mark(ORANGE)])]));
        assert_eq!(image[(32, 32)], ORANGE);
        assert_eq!(image[(2, 2)], Color32::WHITE);

        let style = BoxStyle { fill: ORANGE, edge: Color32::TRANSPARENT, width: 0.0 };
        let cell = Cell { level: 2, style: 0, code: [0; 3] };
        let image = drawn(gpu, &picture(front(), vec![Layer::boxes(GRID, &[cell], &[style])]));
        assert_eq!(image[(32, 32)], ORANGE);
    });
}

#[test]
fn a_mark_shines_through_surfaces_before_it() {
    with_gpu(|gpu| {
        let wall = |z: f64| {
            let triangle = [[-20.0, -20.0, z], [20.0, -20.0, z], [2.0, 40.0, z]];
            Layer::triangles(&[triangle], Color32::from_gray(120))
        };
        for z in [4.0, -1.0] {
            let layers = vec![wall(z), Layer::marks(vec![mark(ORANGE)])];
            let image = drawn(gpu, &picture(front(), layers));
            assert_eq!(image[(32, 32)], ORANGE, "wall at {z}");
        }
    });
}

#[test]
fn points_and_spheres_cover_their_centres() {
    with_gpu(|gpu| {
        let grey = Color32::from_gray(90);
        let image = drawn(gpu, &picture(front(), vec![Layer::points(&[[2.0; 3]], grey, 3.0)]));
        assert_eq!(image[(32, 32)], grey);
        assert_eq!(image[(32, 40)], Color32::WHITE);
        let sphere = Layer::spheres(&[[2.0, 2.0, 2.0, 1.5]], grey);
        let image = drawn(gpu, &picture(front(), vec![sphere]));
        assert_ne!(image[(32, 32)], Color32::WHITE);
    });
}

#[test]
fn spheres_are_round_at_any_size() {
    with_gpu(|gpu| {
        let black = Color32::BLACK;
        // Seen along an axis of no coordinate.
        let from = Vec3::splat(2.0) + 7.0 * Vec3::new(1.0, 0.7, 1.3);
        let away = from.distance(Vec3::splat(2.0));
        for pixels in [2.0, 3.5, 6.0, 12.0, 25.0_f32] {
            // So large that its rim is seen that far from the middle of 64 pixels.
            let tangent = pixels / 32.0 * (0.5 * 0.7_f32).tan();
            let radius = f64::from(away * tangent / (1.0 + tangent * tangent).sqrt());
            let layer = Layer::spheres(&[[2.0, 2.0, 2.0, radius]], black);
            let image = drawn(gpu, &picture(looking_from(from), vec![layer]));
            for (index, colour) in image.pixels.iter().enumerate() {
                let [x, y] = [index % 64, index / 64].map(|at| at as f32 + 0.5 - 32.0);
                let inside = pixels - x.hypot(y);
                let covered = 1.0 - f32::from(colour.r()) / 255.0;
                let expected = (inside + 0.5).clamp(0.0, 1.0);
                // Whether a sample at a rim is covered at all is asked from a fifth on.
                assert!((covered - expected).abs() < 0.3, "{pixels}: {inside}, {covered}");
            }
        }
    });
}

#[test]
fn cells_of_the_plane_are_crisp_at_any_zoom() {
    with_gpu(|gpu| {
        let blue = Color32::from_rgb(0, 0, 200);
        let cell = |x, y, colour| (Cell { level: 0, style: 0, code: [x, y, 0] }, colour);
        let last = (1 << 20) - 1;
        let grid = Grid { min: [0.0; 3], cell: 1e-3, root_level: 20 };
        let cells = [cell(last, last, blue), cell(last - 1, last, ORANGE)];
        let layer = Layer::cells(grid, &cells, Color32::BLACK, 1.0);
        // The line between the two cells lies in the middle, 20 pixels a cell.
        let middle = f64::from(last) * 1e-3;
        let view = View::Plane(Plane { centre: [middle, middle + 5e-4], scale: 2e4 });
        let image = drawn(gpu, &picture(view, vec![layer]));
        let row: Vec<_> = [11, 12, 13, 31, 32, 33, 51, 52, 53].map(|x| image[(x, 32)]).into();
        let [w, k] = [Color32::WHITE, Color32::BLACK];
        assert_eq!(row, [w, k, ORANGE, ORANGE, k, blue, blue, k, w]);
    });
}

#[test]
fn layers_larger_than_any_buffer_are_drawn_whole() {
    with_gpu(|gpu| {
        let grey = Color32::from_gray(90);
        let at = |n: u32| [f64::from(n % 8) * 0.5, f64::from(n / 8) * 0.5, 1.0];
        let triangles: Vec<_> = (0..64)
            .map(|n| [at(n), [at(n)[0] + 0.3, at(n)[1], 1.0], [at(n)[0], at(n)[1] + 0.3, 1.0]])
            .collect();
        let code = |n: u32| [n % 4, n / 4 % 4, n / 16];
        let cell = |n: u32| Cell { level: 0, style: n.is_multiple_of(3).into(), code: code(n) };
        let cells: Vec<Cell> = (0..64).map(cell).collect();
        let style = |fill| BoxStyle { fill, edge: grey, width: 1.0 };
        let styles = [style(ORANGE), style(Color32::TRANSPARENT)];
        let spheres: Vec<_> = (0..64).map(|n| [at(n)[0], at(n)[1], 1.0, 0.2]).collect();
        let flat = |n: u32| {
            let cell = Cell { level: 0, style: 0, code: [n % 4, n / 4, 0] };
            (cell, if n.is_multiple_of(3) { ORANGE } else { grey })
        };
        let flat: Vec<_> = (0..16).map(flat).collect();
        let plane = View::Plane(Plane { centre: [2.0, 2.0], scale: 12.0 });
        let pictures = [
            picture(front(), vec![Layer::triangles(&triangles, grey)]),
            picture(front(), vec![Layer::points(&(0..64).map(at).collect::<Vec<_>>(), grey, 2.0)]),
            picture(front(), vec![Layer::spheres(&spheres, grey)]),
            picture(front(), vec![Layer::boxes(GRID, &cells, &styles)]),
            picture(plane, vec![Layer::cells(GRID, &flat, Color32::BLACK, 1.0)]),
        ];
        let whole = pictures.each_ref().map(|picture| drawn(gpu, picture));
        let most_bytes = std::mem::replace(&mut gpu.renderer.most_bytes, 100);
        for (picture, whole) in pictures.iter().zip(&whole) {
            // Layers made anew are uploaded anew.
            drawn(gpu, &Picture { layers: Vec::new(), ..picture.clone() });
            assert_eq!(drawn(gpu, picture), *whole);
            assert!(whole.pixels.iter().any(|&pixel| pixel != Color32::WHITE));
        }
        gpu.renderer.most_bytes = most_bytes;
    });
}

#[test]
fn a_picture_too_large_or_empty_is_refused() {
    with_gpu(|gpu| {
        for size in [[0, 5], [5, 1 << 20]] {
            let result = render_to_image(gpu, &picture(front(), vec![]), size, 1.0);
            assert!(matches!(result, Err(ImageError::Size(..))));
        }
    });
}

/// Everything that is drawn in space, moved as a whole, is seen as before if the view
/// moves with it.
#[test]
fn far_from_zero_nothing_trembles() {
    with_gpu(|gpu| {
        let grey = Color32::from_gray(90);
        let View::Space(near) = front() else { panic!() };
        let style = BoxStyle { fill: Color32::TRANSPARENT, edge: Color32::BLACK, width: 1.5 };
        let cell = |x| Cell { level: 0, style: 0, code: [x, 1, 2] };
        let shown = |by: f64| {
            let grid = Grid { min: [by; 3], cell: 1.0, ..GRID };
            let [a, b, c] = [[0.5, 0.25, 0.0], [3.5, 0.5, 1.0], [1.0, 3.0, 0.5]];
            let moved = |p: [f64; 3]| p.map(|x| x + by);
            let marked = mark(Color32::from_rgba_unmultiplied(200, 0, 0, 90));
            let layers = vec![
                Layer::boxes(grid, &[cell(0), cell(1), cell(3)], &[style]),
                Layer::triangles(&[[moved(a), moved(b), moved(c)]], ORANGE),
                Layer::points(&[moved([3.0; 3])], grey, 3.0),
                Layer::spheres(&[[by + 1.0, by + 3.0, by + 2.0, 0.5]], grey),
                Layer::marks(vec![BoxMark {
                    min: moved(marked.min),
                    max: moved(marked.max),
                    ..marked
                }]),
            ];
            let view = View::Space(Space { origin: [by; 3], ..near });
            // What lies above x = 3.25 is before the slice.
            let slice = [1.0, 0.0, 0.0, -3.25 - by];
            Picture { slice, ..picture(view, layers) }
        };
        let image = drawn(gpu, &shown(0.0));
        assert!(image.pixels.iter().any(|&pixel| pixel == ORANGE || pixel == grey));
        for by in [1e6, -3e9] {
            assert_eq!(drawn(gpu, &shown(by)), image, "{by}");
        }
    });
}

#[test]
fn a_singular_view_draws_without_a_crash() {
    with_gpu(|gpu| {
        let picture = picture(
            View::Space(Space { origin: [0.0; 3], clip_from_offset: Mat4::ZERO }),
            vec![Layer::marks(vec![mark(ORANGE)])],
        );
        drawn(gpu, &picture);
    });
}

#[test]
fn the_window_shows_the_colour_and_draws_only_what_changed() {
    with_gpu(|_| {
        let state = create_render_state(default_wgpu_setup(), RendererOptions::PREDICTABLE);
        install(&state);
        let renderer = WgpuTestRenderer::from_render_state(state.clone());
        let first = picture(front(), vec![Layer::marks(vec![mark(ORANGE)])]);
        let mut harness = egui_kittest::Harness::builder()
            .with_size(egui::vec2(100.0, 80.0))
            .renderer(renderer)
            .build_ui_state(
                |ui, picture: &mut Picture| {
                    let rect = ui.max_rect();
                    paint(ui, rect, Id::unique("space"), picture);
                },
                first,
            );
        let image = harness.render().unwrap();
        assert_eq!(image.get_pixel(50, 40).0, ORANGE.to_array());
        let once = stats(&state).unwrap();
        assert_eq!(once.frames, 1);
        assert!(once.uploaded_bytes > 0);

        harness.run();
        harness.render().unwrap();
        assert_eq!(stats(&state), Some(once));

        harness.state_mut().view = looking_from(Vec3::new(3.0, 2.0, 12.0));
        harness.run();
        harness.render().unwrap();
        assert_eq!(stats(&state).unwrap().frames, 2);
    });
}

#[test]
fn a_picture_that_moves_is_coarse_and_becomes_the_whole_one_bit_by_bit() {
    with_gpu(|_| {
        let code = |n: u32| [n % 4, n / 4 % 4, n / 16];
        let cell = |n: u32| Cell { level: 0, style: u8::from(n == 9), code: code(n) };
        let style = |fill| BoxStyle { fill, edge: Color32::BLACK, width: 1.0 };
        let styles = [style(Color32::TRANSPARENT), style(ORANGE)];
        let many = Layer::boxes(GRID, &(0..64).map(cell).collect::<Vec<_>>(), &styles);
        let root = Cell { level: 2, style: 0, code: [0; 3] };
        let few = Layer::boxes(GRID, &[root], &styles);
        let pictures = [picture(front(), vec![few]), picture(front(), vec![many])];
        let state = create_render_state(default_wgpu_setup(), RendererOptions::PREDICTABLE);
        install(&state);
        let speed = Speed { vertices: 300 };
        let mut harness = egui_kittest::Harness::builder()
            .with_size(egui::vec2(100.0, 80.0))
            .renderer(WgpuTestRenderer::from_render_state(state.clone()))
            .build_ui_state(
                |ui, (pictures, in_steps): &mut ([Picture; 2], Option<Speed>)| {
                    let (rect, [coarse, whole]) = (ui.max_rect(), pictures);
                    match in_steps {
                        Some(speed) => {
                            let speed = (*speed, Pace::Busy);
                            paint_in_steps(ui, rect, Id::unique("a"), [coarse, whole], speed);
                        }
                        None => paint(ui, rect, Id::unique("b"), whole),
                    }
                },
                (pictures.clone(), None),
            );
        let mut next = || {
            harness.step();
            harness.render().unwrap()
        };
        let expected = next();
        harness.state_mut().1 = Some(speed);
        let mut next = || {
            harness.step();
            (harness.render().unwrap(), stats(&state).unwrap())
        };
        let (first, at_first) = next();
        assert!(at_first.is_coarse && first != expected);
        let mut n_frames = 1;
        while next().1.is_coarse {
            n_frames += 1;
            assert!(n_frames < 40);
        }
        assert!(n_frames > 6, "300 edges at 25 a frame");
        let (last, at_rest) = next();
        assert_eq!(last, expected);
        assert_eq!(next().1, at_rest, "it is not drawn again");

        for picture in &mut harness.state_mut().0 {
            picture.view = looking_from(Vec3::new(3.0, 2.0, 12.0));
        }
        harness.step();
        harness.render().unwrap();
        let moved = stats(&state).unwrap();
        assert!(moved.is_coarse);
        let sent = moved.uploaded_bytes - at_rest.uploaded_bytes;
        assert!(sent < 2000, "{sent} bytes: the layers are there");
    });
}

#[test]
fn without_a_driver_painting_does_nothing() {
    let picture = picture(front(), vec![Layer::marks(vec![mark(ORANGE)])]);
    let mut harness = egui_kittest::Harness::new_ui(|ui| {
        paint(ui, ui.max_rect(), Id::unique("space"), &picture);
    });
    harness.run();
}

#[test]
fn a_slice_leaves_only_what_is_behind_it_and_the_marks() {
    with_gpu(|gpu| {
        let triangle = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]];
        let content = Layer::triangles(&[triangle], ORANGE);
        let whole = picture(front(), vec![content.clone()]);
        let is_background = |image: &ColorImage, x| image[(x, 40)] == Color32::WHITE;
        let image = drawn(gpu, &whole);
        assert!(!is_background(&image, 20) && !is_background(&image, 28));
        // What lies above x = 1 is before the slice.
        let slice = [1.0, 0.0, 0.0, -1.0];
        let image = drawn(gpu, &Picture { slice, ..whole.clone() });
        assert!(!is_background(&image, 20) && is_background(&image, 28));
        let marked = Picture { slice, ..picture(front(), vec![Layer::marks(vec![mark(ORANGE)])]) };
        assert_eq!(drawn(gpu, &marked)[(32, 32)], ORANGE);
    });
}
