//! What figures are expected to be written as.

use octoscope_figure::{Figure, FileOptions, Scale, Theme, TikzForm, Unit, svg, tikz};

/// Compares a figure with its text; UPDATE_EXPECT=1 writes it anew.
pub fn check_text(name: &str, figure: Figure) {
    let text = svg(&figure.cropped(6.0), &FileOptions::default());
    check_file(&format!("{name}.svg"), &text);
}

/// The same, as SVG and as TikZ.
pub fn check_texts(name: &str, figure: Figure) {
    let scale = Scale { factor: 1.0, unit: Unit::Point };
    let options = FileOptions { theme: Theme::Print, scale, ..FileOptions::default() };
    let text = tikz(&figure.clone().cropped(6.0), TikzForm::Snippet, &options);
    check_file(&format!("{name}.tex"), &text);
    check_text(name, figure);
}

fn check_file(name: &str, text: &str) {
    let path = format!("{}/tests/views/{name}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::create_dir_all(std::path::Path::new(&path).parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
    }
    let expected = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(text == expected, "{name}: UPDATE_EXPECT=1 writes it anew");
}
