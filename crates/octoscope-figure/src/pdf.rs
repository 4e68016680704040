//! Figures as PDF: vectors, text as text, letters embedded.

use crate::typeset::{Line, Run, runs};
use crate::{
    Background, Colour, Dashes, Drawn, Figure, FileOptions, Form, Lettering, Paint, Palette, Style,
    fonts,
};
use krilla::color::rgb;
use krilla::embed::{AssociationKind, EmbeddedFile, MimeType};
use krilla::geom::{Path, PathBuilder, Point, Rect, Transform};
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, LineJoin, Stroke, StrokeDash};
use krilla::surface::Surface;
use krilla::text::{Font, GlyphId, KrillaGlyph};
use thiserror::Error;

/// Name of the scenario among the attachments of a PDF.
pub const ATTACHMENT: &str = "scenario.octo";

/// Longest side of a page in points: 200 inches, as readers are promised.
pub const LONGEST_SIDE: f64 = 14_400.0;

/// Why a PDF could not be made.
#[derive(Debug, Error)]
pub enum PdfError {
    /// A page would have no extent, or be longer than readers show.
    #[error("a page of {0:.0} × {1:.0} points is not possible; choose 1 to 14400 along each side")]
    Size(f64, f64),
    /// The document is not sound.
    #[error("the PDF could not be written: {0}")]
    Document(String),
}

/// A PDF that is being written, a page a figure.
pub struct Pdf<'a> {
    document: krilla::Document,
    options: FileOptions<'a>,
    fonts: Vec<Font>,
}

/// PDF file of one figure on a page of its extent.
///
/// # Errors
/// Refuses a page that readers do not show.
pub fn pdf(figure: &Figure, options: &FileOptions) -> Result<Vec<u8>, PdfError> {
    let mut pdf = Pdf::new(options);
    pdf.page(figure)?;
    pdf.finish()
}

impl<'a> Pdf<'a> {
    /// PDF without pages.
    pub fn new(options: &FileOptions<'a>) -> Self {
        let font = |font: &'static [u8]| {
            Font::new(font.into(), 0).expect("the typefaces of the program are sound")
        };
        Self {
            document: krilla::Document::new(),
            options: *options,
            fonts: fonts::ALL.into_iter().map(font).collect(),
        }
    }

    /// Appends a page of the figure's extent.
    ///
    /// # Errors
    /// Refuses a page that readers do not show.
    pub fn page(&mut self, figure: &Figure) -> Result<(), PdfError> {
        let figure = &*figure.spelled_out();
        let scale = self.options.scale.points();
        let [width, height] = [figure.page.width, figure.page.height].map(|side| side * scale);
        let fits = |side: f64| (1.0..=LONGEST_SIDE).contains(&side);
        let settings = PageSettings::from_wh(width as f32, height as f32);
        let settings = settings.filter(|_| fits(width) && fits(height));
        let mut page =
            self.document.start_page_with(settings.ok_or(PdfError::Size(width, height))?);
        let mut surface = page.surface();
        surface.push_transform(&Transform::from_scale(scale as f32, scale as f32));
        let theme = self.options.theme;
        if self.options.background == Background::Filled {
            let [width, height] = [figure.page.width, figure.page.height].map(|side| side as f32);
            let mut path = PathBuilder::new();
            path.push_rect(Rect::from_xywh(0.0, 0.0, width, height).expect("as long as the page"));
            surface.set_fill(Some(fill(Palette::of(theme).background)));
            surface.set_stroke(None);
            if let Some(path) = path.finish() {
                surface.draw_path(&path);
            }
        }
        for drawn in &figure.drawn {
            draw(&mut surface, drawn, &self.options, &self.fonts);
        }
        surface.pop();
        surface.finish();
        page.finish();
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// Says why it is not sound.
    pub fn finish(mut self) -> Result<Vec<u8>, PdfError> {
        let FileOptions { title, scenario, .. } = self.options;
        let metadata = Metadata::new().title(title.to_owned()).creator("Octoscope".to_owned());
        self.document.set_metadata(metadata);
        if !scenario.is_empty() {
            self.document.embed_file(EmbeddedFile {
                path: ATTACHMENT.to_owned(),
                mime_type: MimeType::new("application/json"),
                description: Some("Scenario of this figure; Octoscope opens it".to_owned()),
                association_kind: AssociationKind::Source,
                data: scenario.as_bytes().to_vec().into(),
                modification_date: None,
                compress: Some(true),
                location: None,
            });
        }
        self.document.finish().map_err(|error| PdfError::Document(format!("{error:?}")))
    }
}

fn draw(surface: &mut Surface, drawn: &Drawn, options: &FileOptions, fonts: &[Font]) {
    let theme = options.theme;
    if let Some(line) = Line::of(&drawn.form) {
        if let Some(look) = Style::of(theme, drawn.role).text {
            write(surface, &line, look, &runs(theme, look, line.text), fonts);
        }
        return;
    }
    let paint = Paint::of(theme, drawn).with_lines(options.line_scale);
    let (fill, stroke) = (paint.fill.map(fill), stroke(&paint, &drawn.form));
    let Some(path) = path(&drawn.form).filter(|_| fill.is_some() || stroke.is_some()) else {
        return;
    };
    surface.set_fill(fill);
    surface.set_stroke(stroke);
    surface.draw_path(&path);
}

fn write(surface: &mut Surface, line: &Line, look: Lettering, runs: &[Run], fonts: &[Font]) {
    surface.set_stroke(None);
    let [x, y] = line.at;
    let mut x = x - line.anchor.share() * runs.iter().map(Run::width).sum::<f64>();
    // Capitals and digits are 0.73 of the type's height: centre them.
    let y = y + 0.365 * look.size;
    for run in runs {
        let glyphs = run.glyphs.iter().map(|glyph| {
            let id = GlyphId::new(u32::from(glyph.id));
            let advance = glyph.advance as f32;
            KrillaGlyph::new(id, advance, 0.0, 0.0, 0.0, glyph.range.clone(), None)
        });
        let glyphs: Vec<_> = glyphs.collect();
        let start = Point::from_xy(x as f32, (y + run.drop) as f32);
        let (font, size) = (fonts[run.font].clone(), run.look.size as f32);
        surface.set_fill(Some(fill(run.look.colour)));
        surface.draw_glyphs(start, &glyphs, font, &run.text, size, false);
        x += run.width();
    }
}

fn path(form: &Form) -> Option<Path> {
    let mut path = PathBuilder::new();
    match form {
        Form::Polygon(points) | Form::Polyline(points) => {
            for (index, [x, y]) in points.iter().map(|p| p.map(rounded)).enumerate() {
                if index == 0 {
                    path.move_to(x, y);
                } else {
                    path.line_to(x, y);
                }
            }
            if matches!(form, Form::Polygon(_)) {
                path.close();
            }
        }
        Form::Circle { centre: [x, y], radius } => {
            // Four arcs; the handles of a quarter circle [Riškus 2006].
            let (x, y, r, h) = (*x, *y, *radius, 0.552_284_75 * radius);
            let start = [x + r, y].map(rounded);
            path.move_to(start[0], start[1]);
            let mut arc = |points: [[f64; 2]; 3]| {
                let [a, b, c] = points.map(|p| p.map(rounded));
                path.cubic_to(a[0], a[1], b[0], b[1], c[0], c[1]);
            };
            arc([[x + r, y + h], [x + h, y + r], [x, y + r]]);
            arc([[x - h, y + r], [x - r, y + h], [x - r, y]]);
            arc([[x - r, y - h], [x - h, y - r], [x, y - r]]);
            arc([[x + h, y - r], [x + r, y - h], start.map(f64::from)]);
            path.close();
        }
        Form::Text { .. } | Form::Formula { .. } => {}
    }
    path.finish()
}

/// Hundredths of a page unit, so that files stay small.
fn rounded(x: f64) -> f32 {
    ((x * 100.0).round() / 100.0) as f32
}

fn fill(colour: Colour) -> Fill {
    Fill { paint: rgb_of(colour).into(), opacity: opacity(colour), ..Fill::default() }
}

fn stroke(paint: &Paint, form: &Form) -> Option<Stroke> {
    let colour = paint.stroke.filter(|_| paint.width > 0.0)?;
    let dash = paint.dashes(form).map(|Dashes { lengths, offset }| StrokeDash {
        array: lengths.into_iter().map(|length| length as f32).collect(),
        offset: offset as f32,
    });
    Some(Stroke {
        paint: rgb_of(colour).into(),
        opacity: opacity(colour),
        width: paint.width as f32,
        line_join: LineJoin::Round,
        dash,
        ..Stroke::default()
    })
}

fn rgb_of(colour: Colour) -> rgb::Color {
    let [r, g, b] = colour.rgb;
    rgb::Color::new(r, g, b)
}

fn opacity(colour: Colour) -> NormalizedF32 {
    NormalizedF32::new(colour.opacity.clamp(0.0, 1.0) as f32).unwrap_or(NormalizedF32::ONE)
}
