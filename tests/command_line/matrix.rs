//! Every view in every format, from the command line and read back.

use crate::desk::{Desk, desk_with_scenario, text};
use octoscope_figure::fonts;
use octoscope_figure::views::FigureView;
use resvg::{tiny_skia::Pixmap, tiny_skia::Transform, usvg};
use std::fs;
use std::io::{BufReader, Cursor, Write};
use std::path::Path;
use std::process::{Command, Output};

/// Every view with what it is asked for, and a range of steps: as many frames as
/// the last number says.
const VIEWS: [(&str, &str, usize); 14] = [
    ("a.octo --view space", "3-5", 3),
    ("scene:figure-7 --view space", "5-6", 2),
    ("a.octo --view tree", "7-8", 2),
    ("a.octo --view automaton", "7-8", 2),
    ("scene:figure-7 --view t-rail", "3-5", 3),
    ("a.octo --view codes --algorithm codes", "5-6", 2),
    ("region.octo --view region", "5-7", 3),
    ("a.octo --view neighbour --algorithm codes", "20-21", 2),
    ("a.octo --view listing --lang de", "5-6", 2),
    ("a.octo --view table", "8-9", 2),
    ("a.octo --view chart", "8-9", 2),
    ("a.octo --view formula --notation revelles", "5-7", 3),
    ("a.octo --view storyboard --steps leaves:3", "1", 1),
    ("scene:figure-1 --view worksheet --seed 4 --solution", "1", 1),
];

fn desk() -> Desk {
    let desk = desk_with_scenario();
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    fs::copy(scenes.join("region.octo"), desk.0.path().join("region.octo")).unwrap();
    desk
}

/// The file of a view, exported.
#[track_caller]
fn file(desk: &Desk, arguments: &str, name: &str) -> Vec<u8> {
    desk.prints(&format!("export {arguments} -o {name}"));
    fs::read(desk.0.path().join(name)).unwrap()
}

/// Says what is not checked on this machine. Written to the stream itself: what a
/// test that passes prints is not shown.
fn not_run(what: &str) {
    writeln!(std::io::stderr().lock(), "NOT RUN: {what}").unwrap();
}

/// Output of a program that may not be installed; then a line says so.
fn outside(desk: &Desk, program: &str, arguments: &[&str]) -> Option<Output> {
    match Command::new(program).args(arguments).current_dir(desk.0.path()).output() {
        Ok(output) => Some(output),
        Err(error) => {
            not_run(&format!("{program} {}: {error}", arguments.join(" ")));
            None
        }
    }
}

/// What a browser with the right typefaces shows of an SVG.
fn shown(svg: &[u8], [width, height]: [u32; 2]) -> Pixmap {
    let mut setting = usvg::Options::default();
    for font in fonts::ALL {
        setting.fontdb_mut().load_font_data(font.to_vec());
    }
    let tree = usvg::Tree::from_data(svg, &setting).unwrap();
    let mut drawn = Pixmap::new(width, height).unwrap();
    let [x, y] = [width as f32 / tree.size().width(), height as f32 / tree.size().height()];
    resvg::render(&tree, Transform::from_scale(x, y), &mut drawn.as_mut());
    drawn
}

/// Share of the numbers of two pictures that differ by more than `most`.
fn difference(a: &Pixmap, b: &Pixmap, most: u8) -> f64 {
    assert_eq!([a.width(), a.height()], [b.width(), b.height()]);
    let differ = a.data().iter().zip(b.data()).filter(|(a, b)| a.abs_diff(**b) > most);
    differ.count() as f64 / a.data().len() as f64
}

#[test]
fn every_view_is_among_those_that_are_exported() {
    for view in FigureView::ALL {
        let asked = format!("--view {}", view.id());
        let is_of_it = |(arguments, ..): &(&str, &str, usize)| {
            arguments.split(" --").any(|option| format!("--{option}") == asked)
        };
        assert!(VIEWS.iter().any(is_of_it), "{asked}");
    }
}

#[test]
fn an_svg_of_every_view_shows_what_its_png_shows() {
    let desk = desk();
    for (view, steps, _) in VIEWS {
        let one = format!("{view} --step {}", steps.split('-').next().unwrap());
        let png = Pixmap::decode_png(&file(&desk, &one, "a.png")).unwrap();
        let inked = png.pixels().iter().filter(|pixel| pixel.red() < 250).count();
        assert!(inked > 1000, "{view}: {inked} pixels");
        let svg = shown(&file(&desk, &one, "a.svg"), [png.width(), png.height()]);
        assert_eq!(difference(&svg, &png, 0), 0.0, "{view}");
        for name in ["a.png", "a.svg"] {
            desk.prints(&format!("check {name}"));
        }
    }
}

#[test]
fn a_pdf_of_every_view_shows_what_its_png_shows() {
    let desk = desk();
    for (view, steps, n_frames) in VIEWS {
        let pdf = file(&desk, &format!("{view} --step {steps}"), "a.pdf");
        assert!(pdf.starts_with(b"%PDF"));
        desk.prints("check a.pdf");
        let Some(output) = outside(&desk, "pdfinfo", &["a.pdf"]) else { continue };
        let info = text(&output.stdout);
        assert!(info.contains(&format!("Pages:           {n_frames}\n")), "{view}: {info}");

        let one = format!("{view} --step {}", steps.split('-').next().unwrap());
        let png = Pixmap::decode_png(&file(&desk, &one, "a.png")).unwrap();
        file(&desk, &one, "a.pdf");
        let [width, height] = [png.width(), png.height()].map(|side| side.to_string());
        let draw = ["-scale-to-x", &width, "-scale-to-y", &height, "-singlefile", "-png"];
        if outside(&desk, "pdftoppm", &[&draw[..], &["a.pdf", "b"]].concat()).is_some() {
            let drawn = fs::read(desk.0.path().join("b.png")).unwrap();
            let share = difference(&Pixmap::decode_png(&drawn).unwrap(), &png, 128);
            // Poppler draws letters and moves lines in another way.
            assert!(share < 0.02, "{view}: {share}");
        }
        let Some(output) = outside(&desk, "pdffonts", &["a.pdf"]) else { continue };
        let said = text(&output.stdout);
        let mut fonts = said.lines().skip(2).peekable();
        assert!(fonts.peek().is_some() && fonts.all(|line| line.contains("yes yes yes")), "{said}");
    }
}

#[test]
fn latex_sets_every_view_on_a_page_of_its_size() {
    let desk = desk();
    let mut document = "\\documentclass[tikz]{standalone}\n\\usepackage[utf8]{inputenc}\n\
                        \\usepackage[T1]{fontenc}\n\\usepackage{lmodern}\n\\begin{document}\n"
        .to_owned();
    let mut sizes = Vec::new();
    for (view, steps, _) in VIEWS {
        let one = format!("{view} --step {}", steps.split('-').next().unwrap());
        let tikz = String::from_utf8(file(&desk, &one, "a.tex")).unwrap();
        assert!(tikz.contains("\\documentclass") && tikz.contains("octo "), "{view}");
        assert!(!tikz.contains("[U+"), "LaTeX has a sign for every letter: {view}");
        desk.prints("check a.tex");
        let snippet = file(&desk, &format!("{one} --snippet"), "a.tex");
        // Names of styles and colours are those of one picture.
        document += &format!("{{\n{}}}\n", String::from_utf8(snippet).unwrap());
        let png = Pixmap::decode_png(&file(&desk, &one, "a.png")).unwrap();
        sizes.push([png.width(), png.height()]);
    }
    document += "\\end{document}\n";
    fs::write(desk.0.path().join("all.tex"), document).unwrap();
    let arguments = ["-interaction=nonstopmode", "-halt-on-error", "all.tex"];
    let Some(output) = outside(&desk, "pdflatex", &arguments) else { return };
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    if said.contains(".cls' not found") || said.contains(".sty' not found") {
        return not_run("pdflatex lacks standalone or lmodern");
    }
    assert!(output.status.success(), "{said}");
    let Some(output) = outside(&desk, "pdfinfo", &["-l", "-1", "all.pdf"]) else { return };
    let info = text(&output.stdout);
    let found: Vec<Vec<f64>> = info
        .lines()
        .filter(|line| line.starts_with("Page ") && line.contains("size:"))
        .map(|line| line.split_whitespace().filter_map(|word| word.parse().ok()).collect())
        .collect();
    assert_eq!(found.len(), VIEWS.len(), "{info}");
    for ((view, _, _), (found, pixels)) in VIEWS.iter().zip(found.iter().zip(&sizes)) {
        let [.., width, height] = found[..] else { panic!("{info}") };
        // A pixel is 0.75 points; a picture has whole ones.
        for (points, pixels) in [width, height].into_iter().zip(pixels) {
            assert!((points / 0.75 - f64::from(*pixels)).abs() < 1.0, "{view}: {found:?} {pixels}");
        }
    }
}

#[test]
fn slides_of_every_view_are_as_many_as_the_steps() {
    let desk = desk();
    for (view, steps, n_frames) in VIEWS {
        let arguments = format!("{view} --step {steps} --beamer");
        let tikz = String::from_utf8(file(&desk, &arguments, "a.tex")).unwrap();
        assert!(tikz.contains("\\documentclass{beamer}"));
        let pictures = tikz
            .lines()
            .filter(|line| line.strip_prefix("\\only<").is_some_and(|rest| rest.ends_with(">{%")));
        assert_eq!(pictures.count(), n_frames, "{view}");
        assert_eq!(tikz.matches("\\only<").count(), 2 * n_frames, "{view}");
    }
    // One of them is set; all share what is around the pictures.
    file(&desk, "scene:figure-7 --view space --step 3-7 --beamer", "a.tex");
    let arguments = ["-interaction=nonstopmode", "-halt-on-error", "a.tex"];
    let Some(output) = outside(&desk, "pdflatex", &arguments) else { return };
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    if said.contains("beamer.cls' not found") {
        return not_run("pdflatex has no class beamer");
    }
    assert!(said.contains("(5 pages"), "{said}");
    assert!(!said.contains("Overfull"), "{said}");
}

/// Every frame of a GIF as it is shown, and its pause in hundredths of a second.
fn shown_frames_of_gif(file: &[u8]) -> Vec<(Vec<u8>, u16)> {
    let mut setting = gif::DecodeOptions::new();
    setting.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = setting.read_info(file).unwrap();
    let row = usize::from(decoder.width());
    let mut screen = vec![0; 4 * row * usize::from(decoder.height())];
    let mut shown = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        let [left, top, width] = [frame.left, frame.top, frame.width].map(usize::from);
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            if pixel[3] > 0 {
                let at = 4 * ((top + index / width) * row + left + index % width);
                screen[at..at + 4].copy_from_slice(pixel);
            }
        }
        shown.push((screen.clone(), frame.delay));
    }
    shown
}

/// Every frame of an animated PNG as it is shown.
fn shown_frames_of_apng(file: &[u8]) -> Vec<Vec<u8>> {
    let mut reader = png::Decoder::new(Cursor::new(file)).read_info().unwrap();
    let row = reader.info().width as usize;
    let n_frames = reader.info().animation_control().unwrap().num_frames;
    let mut screen = vec![0; reader.output_buffer_size().unwrap()];
    let frames = (0..n_frames).map(|_| {
        let mut part = vec![0; screen.len()];
        let info = reader.next_frame(&mut part).unwrap();
        let control = *reader.info().frame_control().unwrap();
        let length = 4 * info.width as usize;
        for (y, pixels) in part.chunks_exact(length).take(info.height as usize).enumerate() {
            let at = 4 * ((control.y_offset as usize + y) * row + control.x_offset as usize);
            screen[at..at + length].copy_from_slice(pixels);
        }
        screen.clone()
    });
    frames.collect()
}

#[test]
fn what_moves_has_a_frame_a_step_that_shows_what_its_png_shows() {
    let desk = desk();
    for (view, steps, n_frames) in VIEWS {
        let arguments = format!("{view} --step {steps} --size 200x150 --pause 0.3");
        let gif = shown_frames_of_gif(&file(&desk, &arguments, "a.gif"));
        let apng = file(&desk, &format!("{arguments} --format apng"), "a.png");
        desk.prints("check a.png");
        let apng = shown_frames_of_apng(&apng);
        assert_eq!([gif.len(), apng.len()], [n_frames; 2], "{view}");
        // Files of the same steps lie on the same page.
        desk.prints(&format!("export {view} --step {steps} --size 200x150 -o b.png"));
        let first: usize = steps.split('-').next().unwrap().parse().unwrap();
        for (index, ((gif, pause), apng)) in gif.iter().zip(&apng).enumerate() {
            assert_eq!(*pause, 30, "{view}");
            let step = first + index;
            let name = if n_frames == 1 { "b.png" } else { &format!("b-{step:03}.png") };
            let one = fs::File::open(desk.0.path().join(name)).unwrap();
            let mut reader = png::Decoder::new(BufReader::new(one)).read_info().unwrap();
            let mut alone = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut alone).unwrap();
            assert!(*apng == alone, "{view}, step {step}");
            // A GIF has 255 colours.
            let worst = gif.iter().zip(apng).map(|(a, b)| a.abs_diff(*b)).max();
            assert!(worst <= Some(24), "{view}, step {step}: {worst:?}");
        }
    }
}
