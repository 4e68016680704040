//! Figures as files of every format, read back.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use octoscope_core::explain::{RichText, Span};
use octoscope_figure::{
    Anchor, Apng, Background, Drawn, Figure, FileOptions, Form, Gif, Page, Part, Pdf, Pixels, Role,
    Scale, Theme, Tikz, TikzForm, Unit, pdf, png, scenario_inside, svg, tikz,
};
use resvg::{tiny_skia, usvg};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output};

const SCENARIO: &str = "{\n  \"octoscope\": 1,\n  \"note\": \"a<b & ü\"\n}";

/// A letter with a subscript, and more.
fn label() -> RichText {
    let piece = |text: &str, sub| Span { text: text.to_owned(), sub, ..Span::default() };
    RichText(vec![piece("t", false), piece("x0", true), piece(" ≤ 50 %", false)])
}

/// What is said of a sample, with a letter in the colour of its axis.
fn caption(n_visited: usize) -> RichText {
    let on_y = Span { text: "t".to_owned(), axis: Some(1), ..Span::default() };
    let sub = Span { text: "y0".to_owned(), sub: true, ..on_y.clone() };
    let more = Span { text: format!(" < 50 %: {n_visited} leaves"), ..Span::default() };
    RichText(vec![on_y, sub, more])
}

/// A leaf, its number, an axis with an arrow, and a label with a subscript.
fn sample(n_visited: usize) -> Figure {
    let square = |x: f64| vec![[x, 10.0], [x + 30.0, 10.0], [x + 30.0, 40.0], [x, 40.0]];
    let drawn = |role, part, form| Drawn { form, role, part, node: None };
    let mut all = vec![
        drawn(Role::EmptyLeaf, Part::Whole, Form::Polygon(square(5.0))),
        drawn(Role::EmptyLeaf, Part::Fine, Form::Polygon(square(35.0))),
    ];
    for n in 0..n_visited {
        let share = n as f64 / 4.0;
        let (role, at) = (Role::Visited { share }, [20.0 + 30.0 * n as f64, 25.0]);
        all.push(drawn(role, Part::Whole, Form::Polygon(square(5.0 + 30.0 * n as f64))));
        let disc = Form::Circle { centre: at, radius: 9.0 };
        all.push(drawn(Role::OrderNumber, Part::Whole, disc));
        let text = Form::Text { at, anchor: Anchor::Middle, text: (n + 1).to_string().into() };
        all.push(drawn(Role::OrderNumber, Part::Whole, text));
    }
    let head = vec![[90.0, 30.0], [84.0, 33.0], [84.0, 27.0]];
    all.extend([
        drawn(Role::Rejected, Part::HiddenEdge, Form::Polyline(vec![[5.0, 45.0], [95.0, 45.0]])),
        drawn(Role::Ray, Part::Edge, Form::Polyline(vec![[2.0, 12.5], [85.125, 30.0]])),
        drawn(Role::Ray, Part::Head, Form::Polygon(head)),
        drawn(
            Role::AxisLabel(0),
            Part::Whole,
            Form::Text { at: [50.0, 52.0], anchor: Anchor::Middle, text: label() },
        ),
    ]);
    Figure { page: Page { width: 100.0, height: 60.0 }, drawn: all }
}

fn options() -> FileOptions<'static> {
    let scale = Scale { factor: 1.0, unit: Unit::Point };
    FileOptions {
        theme: Theme::Print,
        title: "Sample",
        scenario: SCENARIO,
        scale,
        ..FileOptions::default()
    }
}

/// Compares with a file in tests/figures.
#[track_caller]
fn expect(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/figures").join(name);
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&path, text).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap();
    assert_eq!(text, expected, "UPDATE_EXPECT=1 writes {name} anew");
}

/// Says what is not checked on this machine. Written to the stream itself: what a
/// test that passes prints is not shown.
fn not_run(what: &str) {
    let mut stream = std::io::stderr().lock();
    writeln!(stream, "NOT RUN: {what}").unwrap();
}

/// Output of a program that may not be installed; then a line says so.
fn outside(program: &str, arguments: &[&str], folder: &Path) -> Option<Output> {
    match Command::new(program).args(arguments).current_dir(folder).output() {
        Ok(output) => Some(output),
        Err(error) => {
            not_run(&format!("{program} {}: {error}", arguments.join(" ")));
            None
        }
    }
}

#[test]
fn tikz_is_written_as_expected() {
    expect("sample.tex", &tikz(&sample(2), TikzForm::Standalone, &options()));
    let mut slides = Tikz::new(TikzForm::Beamer, &options());
    (0..3).for_each(|n| slides.figure(&sample(n), &caption(n)));
    expect("slides.tex", &slides.finish());
}

#[test]
fn every_slide_has_its_caption_and_nothing_else_has() {
    let of = |form, said: &dyn Fn(usize) -> RichText| {
        let mut slides = Tikz::new(form, &options());
        (0..3).for_each(|n| slides.figure(&sample(n), &said(n)));
        slides.finish()
    };
    let said =
        "\\only<3>{\\textcolor{octo-axis-y}{\\textbf{t\\textsubscript{y0}}} $<$ 50 \\%: 2 leaves}%";
    for form in [TikzForm::Beamer, TikzForm::BeamerSnippet] {
        let text = of(form, &caption);
        assert!(text.contains(said), "{text}");
        assert!(text.contains("\\definecolor{octo-axis-y}"), "{text}");
        assert!(!of(form, &|_| RichText::default()).contains("minipage"));
    }
    for form in [TikzForm::Standalone, TikzForm::Snippet] {
        assert!(!of(form, &caption).contains("leaves"));
    }
}

#[test]
fn a_snippet_is_a_picture_and_no_document() {
    let plain = FileOptions { background: Background::Transparent, ..options() };
    let text = tikz(&sample(1), TikzForm::Snippet, &plain);
    assert!(!text.contains("document") && !text.contains("octo background"));
    assert_eq!(text.matches("\\begin{tikzpicture}").count(), 1);
}

#[test]
fn every_format_holds_the_scenario() {
    let (figure, options) = (sample(1), options());
    for bytes in [
        svg(&figure, &options).into_bytes(),
        pdf(&figure, &options).unwrap(),
        png(&figure, &options).unwrap(),
        tikz(&figure, TikzForm::Standalone, &options).into_bytes(),
    ] {
        let inside = scenario_inside(&bytes);
        assert_eq!(inside.as_deref(), Some(SCENARIO), "{}", String::from_utf8_lossy(&bytes[..8]));
        // A file that was cut off holds none, or all of it.
        for end in (0..bytes.len()).step_by(97) {
            let inside = scenario_inside(&bytes[..end]);
            assert!(inside.is_none_or(|inside| inside == SCENARIO), "{end}");
        }
    }
    let bare = FileOptions { scenario: "", ..options };
    assert_eq!(scenario_inside(&pdf(&figure, &bare).unwrap()), None);
    assert_eq!(scenario_inside(&png(&figure, &bare).unwrap()), None);
    assert_eq!(scenario_inside(b"<svg><metadata>{}</metadata></svg>"), None);
}

#[test]
fn an_svg_shows_what_the_png_shows() {
    let scale = Scale { factor: 3.0, unit: Unit::Pixel };
    for theme in Theme::ALL {
        let options = FileOptions { theme, scale, ..options() };
        let mut setting = usvg::Options::default();
        for font in octoscope_figure::fonts::ALL {
            setting.fontdb_mut().load_font_data(font.to_vec());
        }
        let tree = usvg::Tree::from_str(&svg(&sample(2), &options), &setting).unwrap();
        assert_eq!((tree.size().width(), tree.size().height()), (300.0, 180.0));
        let mut drawn = tiny_skia::Pixmap::new(300, 180).unwrap();
        resvg::render(&tree, tiny_skia::Transform::identity(), &mut drawn.as_mut());
        let picture = tiny_skia::Pixmap::decode_png(&png(&sample(2), &options).unwrap()).unwrap();
        let differ = drawn.data().iter().zip(picture.data()).filter(|(a, b)| a.abs_diff(**b) > 8);
        assert_eq!(differ.count(), 0, "{theme:?}");
    }
}

#[test]
fn lines_grow_alone() {
    let wide = FileOptions { line_scale: 2.0, ..options() };
    let of = |options: &FileOptions| {
        let figure = sample(1);
        let tikz = tikz(&figure, TikzForm::Snippet, options);
        let pixels = Pixels::of(&figure, options).unwrap();
        let inked = pixels.rgba.chunks_exact(4).filter(|pixel| pixel[0] < 250).count();
        (svg(&figure, options), tikz, inked, pdf(&figure, options).unwrap())
    };
    let (usual, wider) = (of(&options()), of(&wide));
    for (file, width) in [(&usual, 1.76), (&wider, 3.52)] {
        assert!(file.0.contains(&format!("stroke-width:{width}")), "{}", file.0);
        assert!(file.1.contains(&format!("line width={width}bp")), "{}", file.1);
    }
    // Type is as large as before.
    let type_sizes = |tikz: &str| tikz.matches("\\fontsize{11bp}").count();
    assert_eq!(type_sizes(&usual.1), type_sizes(&wider.1));
    assert!(wider.2 > usual.2 && wider.3 != usual.3);
}

#[test]
fn a_pdf_has_pages_of_the_right_size_and_its_letters_inside() {
    let folder = tempfile::tempdir().unwrap();
    let scale = Scale { factor: 2.54, unit: Unit::Millimetre };
    let options = FileOptions { scale, ..options() };
    let mut file = Pdf::new(&options);
    (0..3).for_each(|n| file.page(&sample(n)).unwrap());
    std::fs::write(folder.path().join("a.pdf"), file.finish().unwrap()).unwrap();
    if let Some(output) = outside("pdfinfo", &["a.pdf"], folder.path()) {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.contains("Pages:           3"), "{text}");
        assert!(text.contains("Page size:       720 x 432 pts"), "{text}");
        assert!(text.contains("Title:           Sample"), "{text}");
    }
    if let Some(output) = outside("pdffonts", &["a.pdf"], folder.path()) {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        for font in ["Inter-SemiBold", "JetBrainsMono-Regular"] {
            let line = text.lines().find(|line| line.contains(font)).unwrap_or_default();
            assert!(line.contains("yes yes yes"), "embedded, a subset, with its text: {text}");
        }
    }
    if let Some(output) = outside("pdftotext", &["-layout", "a.pdf", "-"], folder.path()) {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(text.contains('≤') && text.contains("50 %"), "{text}");
    }
    // What poppler draws of the second page is what our own picture shows.
    let draw = ["-r", "72", "-f", "2", "-l", "2", "-singlefile", "-png", "a.pdf", "a"];
    if outside("pdftoppm", &draw, folder.path()).is_some() {
        let found = std::fs::read(folder.path().join("a.png")).unwrap();
        let found = tiny_skia::Pixmap::decode_png(&found).unwrap();
        let scale = Scale { factor: 7.2, unit: Unit::Pixel };
        let own = Pixels::of(&sample(1), &FileOptions { scale, ..options }).unwrap();
        assert_eq!((found.width(), found.height()), (own.width, own.height));
        let differ = found.data().iter().zip(&own.rgba).filter(|(a, b)| a.abs_diff(**b) > 96);
        let share = differ.count() as f64 / own.rgba.len() as f64;
        // Poppler moves lines to whole pixels.
        assert!(share < 0.025, "{share}");
    }
}

#[test]
fn latex_accepts_the_documents() {
    let folder = tempfile::tempdir().unwrap();
    let mut slides = Tikz::new(TikzForm::Beamer, &options());
    (0..3).for_each(|n| slides.figure(&sample(n), &caption(n)));
    let documents = [
        ("standalone", tikz(&sample(2), TikzForm::Standalone, &options()), 1),
        ("beamer", slides.finish(), 3),
    ];
    for (class, text, n_pages) in documents {
        std::fs::write(folder.path().join("a.tex"), text).unwrap();
        let arguments = ["-interaction=nonstopmode", "-halt-on-error", "a.tex"];
        let Some(output) = outside("pdflatex", &arguments, folder.path()) else { return };
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        if said.contains(&format!("{class}.cls' not found")) {
            not_run(&format!("pdflatex has no class {class}"));
            continue;
        }
        assert!(output.status.success(), "{said}");
        let pages = if n_pages == 1 { "1 page".to_owned() } else { format!("{n_pages} pages") };
        assert!(said.contains(&pages), "{said}");
    }
}

#[test]
fn what_moves_has_a_frame_a_figure_and_shows_it() {
    let scale = Scale { factor: 2.0, unit: Unit::Pixel };
    let options = FileOptions { scale, ..options() };
    let frames: Vec<_> = [0, 1, 1, 2].map(|n| Pixels::of(&sample(n), &options).unwrap()).into();

    let mut file = Vec::new();
    let mut gif = Gif::begin(&mut file, &frames, 0.25).unwrap();
    frames.iter().for_each(|frame| gif.frame(frame.clone()).unwrap());
    gif.finish().unwrap();
    let mut setting = gif::DecodeOptions::new();
    setting.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = setting.read_info(&file[..]).unwrap();
    let mut screen = vec![0; frames[0].rgba.len()];
    let mut n_frames = 0;
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!(frame.delay, 25);
        let (left, top) = (usize::from(frame.left), usize::from(frame.top));
        let width = usize::from(frame.width);
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            if pixel[3] > 0 {
                let at = 4 * ((top + index / width) * 200 + left + index % width);
                screen[at..at + 4].copy_from_slice(pixel);
            }
        }
        let shown = screen.iter().zip(&frames[n_frames].rgba);
        let worst = shown.map(|(a, b)| a.abs_diff(*b)).max();
        assert!(worst <= Some(12), "frame {n_frames}: {worst:?}");
        n_frames += 1;
    }
    assert_eq!(n_frames, 4);

    let mut file = Vec::new();
    let mut apng = Apng::begin(&mut file, frames[0].clone(), 4, 0.25, &options).unwrap();
    frames[1..].iter().for_each(|frame| apng.frame(frame.clone()).unwrap());
    apng.finish().unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(&file)).read_info().unwrap();
    assert_eq!(reader.info().animation_control().unwrap().num_frames, 4);
    let mut screen = vec![0; frames[0].rgba.len()];
    for frame in &frames {
        let mut part = vec![0; screen.len()];
        let info = reader.next_frame(&mut part).unwrap();
        let control = *reader.info().frame_control().unwrap();
        for row in 0..info.height as usize {
            let at = 4 * ((control.y_offset as usize + row) * 200 + control.x_offset as usize);
            let length = 4 * info.width as usize;
            screen[at..at + length].copy_from_slice(&part[row * length..][..length]);
        }
        assert!(screen == frame.rgba);
    }
    assert_eq!(scenario_inside(&file).as_deref(), Some(SCENARIO));
}
