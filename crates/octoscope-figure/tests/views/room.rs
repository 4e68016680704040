//! Room of texts: none covers another.

use octoscope_figure::{Figure, Form, Page, metrics};

/// A text with its left, top, right and bottom.
pub type Written = (String, [f64; 4]);

/// The texts of a figure.
pub fn written(figure: &Figure) -> Vec<Written> {
    let figure = figure.spelled_out();
    let texts = figure.drawn.iter().filter_map(|drawn| match &drawn.form {
        Form::Text { at: [x, y], anchor, text } => {
            let width = metrics::width(drawn.role, text);
            let left = x - anchor.share() * width;
            // Capitals and what hangs below the line.
            let size = metrics::size(drawn.role);
            Some((text.plain(), [left, y - 0.4 * size, left + width, y + 0.5 * size]))
        }
        Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => None,
    });
    texts.collect()
}

/// No text covers another or leaves the page.
#[track_caller]
pub fn check_room(figure: &Figure, what: &str) {
    let texts = written(figure);
    for (index, (text, [left, top, right, bottom])) in texts.iter().enumerate() {
        let Page { width, height } = figure.page;
        let is_on = *left > -0.5 && *top > -1.0 && *right < width + 0.5 && *bottom < height + 1.0;
        assert!(is_on, "{what}: ‘{text}’ leaves the page of {width} × {height}");
        for (other, [l, t, r, b]) in &texts[..index] {
            let is_apart = right <= l || r <= left || bottom <= t || b <= top;
            assert!(is_apart, "{what}: ‘{text}’ covers ‘{other}’");
        }
    }
}
