//! How long figures take to be written: ten thousand marks as SVG, PDF, TikZ and
//! PNG, and two hundred steps as GIF and APNG.
//!
//! `cargo run --release -p octoscope-figure --example formats`

use octoscope_core::geometry::Aabb;
use octoscope_core::progress::Progress;
use octoscope_core::tree::{Cell, Domain, Split, Tree, grow};
use octoscope_figure::{
    Apng, Camera, Figure, FileOptions, Gif, Mark, Page, Pixels, Rasteriser, Role, Shape, Show,
    TikzForm, cells, pdf, png, space_figure, svg, tikz,
};
use std::error::Error;
use std::time::Instant;

const PAGE: Page = Page { width: 960.0, height: 720.0 };

fn main() -> Result<(), Box<dyn Error>> {
    let figure = many_marks(10_000)?;
    println!("{} shapes", figure.drawn.len());
    let options = FileOptions::default();
    timed("svg", || Ok(svg(&figure, &options).into_bytes()))?;
    timed("pdf", || Ok(pdf(&figure, &options)?))?;
    timed("tikz", || Ok(tikz(&figure, TikzForm::Standalone, &options).into_bytes()))?;
    timed("png", || Ok(png(&figure, &options)?))?;

    // Leaves and marks of all steps, and one mark more from step to step.
    let all = many_marks(1000)?;
    let mut rasteriser = Rasteriser::new(&options);
    let mut frame = |step: usize| -> Result<Pixels, Box<dyn Error>> {
        let drawn = all.drawn[..all.drawn.len() - 200 + step].to_vec();
        Ok(rasteriser.pixels(&Figure { drawn, ..all })?)
    };
    timed("gif, 200 steps", || {
        let mut file = Vec::new();
        let samples = [frame(0)?, frame(100)?, frame(199)?];
        let mut gif = Gif::begin(&mut file, &samples, 0.5)?;
        for step in 0..200 {
            gif.frame(frame(step)?)?;
        }
        gif.finish()?;
        Ok(file)
    })?;
    timed("apng, 200 steps", || {
        let mut file = Vec::new();
        let mut apng = Apng::begin(&mut file, frame(0)?, 200, 0.5, &options)?;
        for step in 1..200 {
            apng.frame(frame(step)?)?;
        }
        apng.finish()?;
        Ok(file)
    })
}

fn timed(
    name: &str,
    work: impl FnOnce() -> Result<Vec<u8>, Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let started = Instant::now();
    let bytes = work()?.len();
    println!("{name:16} {:8.3} s {:9} bytes", started.elapsed().as_secs_f64(), bytes);
    Ok(())
}

/// The leaves of a grid, `n` visited ones with their numbers, and as many points.
fn many_marks(n: usize) -> Result<Figure, Box<dyn Error>> {
    let tree: Tree<2> = grow(Domain::unit(5), (), &Progress::default(), |cell: Cell<2>, ()| {
        if cell.level == 0 { Split::Empty } else { Split::Inner(vec![(); 4]) }
    })?;
    let mut all = cells(&tree, &Show::default(), None);
    let side = (n as f64).sqrt().ceil();
    for index in 0..n {
        let min = [index as f64 % side / side, (index as f64 / side).floor() / side];
        let bounds = Aabb { min, max: min.map(|x| x + 0.8 / side) };
        let role = match index % 3 {
            0 => Role::Visited { share: index as f64 / n as f64 },
            1 => Role::Rejected,
            _ => Role::Taken,
        };
        all.push(Mark::new(Shape::Box(bounds), role));
        if index % 10 == 0 {
            let label = Mark::new(Shape::Label(bounds.centre()), Role::ChildIndex);
            all.push(label.with_text(index.to_string()));
        }
    }
    let camera = Camera::framing(&tree.domain().root_box(), PAGE);
    Ok(space_figure(&all, &camera, PAGE))
}
