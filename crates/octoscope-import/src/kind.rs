//! What kind of file bytes are.

use crate::error::ImportError;

/// Kinds of files that can be imported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Picture, PNG.
    Png,
    /// Picture, JPEG.
    Jpeg,
    /// Mesh as text, Wavefront.
    Obj,
    /// Mesh, text or binary.
    Stl,
    /// Mesh or points, text or binary.
    Ply,
    /// Points, one a line, between blanks or commas.
    Xyz,
    /// Points in a table.
    Csv,
}

impl Kind {
    /// Kind of the file `name` that holds `bytes`: the first bytes decide where
    /// they can, the ending of the name otherwise.
    ///
    /// # Errors
    /// Refuses an empty file, an unknown kind, and a content that cannot be what
    /// the name says.
    pub fn of(name: &str, bytes: &[u8]) -> Result<Self, ImportError> {
        if bytes.is_empty() {
            return Err(ImportError::Empty);
        }
        if let Some(kind) = by_content(bytes) {
            return Ok(kind);
        }
        let kind = by_name(name).ok_or(ImportError::UnknownKind)?;
        if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
            return Err(ImportError::Utf16);
        }
        let found = looks_like(bytes);
        let fits = match kind {
            Self::Png | Self::Jpeg | Self::Ply => false,
            Self::Obj | Self::Xyz | Self::Csv => found == TEXT,
            Self::Stl => match found {
                TEXT => starts_with_word(bytes, b"solid"),
                other => other == BINARY,
            },
        };
        if fits {
            return Ok(kind);
        }
        Err(ImportError::WrongContent { expected: kind.noun(), found })
    }

    /// Whether the ending of `name` is that of an importable file.
    pub fn by_name(name: &str) -> Option<Self> {
        by_name(name)
    }

    fn noun(self) -> &'static str {
        match self {
            Self::Png => "a PNG picture",
            Self::Jpeg => "a JPEG picture",
            Self::Obj => "an OBJ mesh",
            Self::Stl => "an STL mesh",
            Self::Ply => "a PLY mesh or point cloud",
            Self::Xyz => "an XYZ point cloud",
            Self::Csv => "a CSV table",
        }
    }
}

/// Whether the first word of a text is `word`, in any case.
pub(crate) fn starts_with_word(bytes: &[u8], word: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    text.len() >= word.len()
        && text[..word.len()].eq_ignore_ascii_case(word)
        && text.get(word.len()).is_none_or(u8::is_ascii_whitespace)
}

fn by_name(name: &str) -> Option<Kind> {
    let (_, ending) = name.rsplit_once('.')?;
    match ending.to_ascii_lowercase().as_str() {
        "png" => Some(Kind::Png),
        "jpg" | "jpeg" => Some(Kind::Jpeg),
        "obj" => Some(Kind::Obj),
        "stl" => Some(Kind::Stl),
        "ply" => Some(Kind::Ply),
        "xyz" => Some(Kind::Xyz),
        "csv" | "tsv" => Some(Kind::Csv),
        _ => None,
    }
}

fn by_content(bytes: &[u8]) -> Option<Kind> {
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        return Some(Kind::Png);
    }
    if bytes.starts_with(b"\xff\xd8\xff") {
        return Some(Kind::Jpeg);
    }
    (bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r\n")).then_some(Kind::Ply)
}

const TEXT: &str = "text";
const BINARY: &str = "binary data";

/// Best guess at what the start of a file is, in words.
fn looks_like(bytes: &[u8]) -> &'static str {
    const KNOWN: [(&[u8], &str); 4] = [
        (b"GIF8", "a GIF picture"),
        (b"%PDF", "a PDF document"),
        (b"PK\x03\x04", "a ZIP archive"),
        (b"\x1f\x8b", "compressed data (gzip)"),
    ];
    let known = KNOWN.iter().find(|(start, _)| bytes.starts_with(start));
    if let Some((_, noun)) = known {
        return noun;
    }
    let is_control = |b: &u8| *b < b' ' && !b.is_ascii_whitespace();
    if bytes.iter().take(8192).any(is_control) { BINARY } else { TEXT }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_wins_over_the_name() {
        let png = b"\x89PNG\r\n\x1a\nrest";
        assert_eq!(Kind::of("photo.jpg", png), Ok(Kind::Png));
        assert_eq!(Kind::of("photo", png), Ok(Kind::Png));
        assert_eq!(Kind::of("cloud.xyz", b"ply\nformat"), Ok(Kind::Ply));
        assert_eq!(Kind::of("A.CSV", b"x,y"), Ok(Kind::Csv));
    }

    #[track_caller]
    fn check(name: &str, bytes: &[u8], message: &str) {
        let error = Kind::of(name, bytes).expect_err("the file is refused");
        assert_eq!(error.to_string(), message);
    }

    #[test]
    fn content_that_cannot_be_what_the_name_says_is_refused() {
        check(
            "notes.png",
            b"hello",
            "the name says a PNG picture, but the file holds text; give it the ending of what it holds",
        );
        check(
            "mesh.stl",
            b"v 1 2 3",
            "the name says an STL mesh, but the file holds text; give it the ending of what it holds",
        );
        check(
            "a.xyz",
            b"PK\x03\x04\0",
            "the name says an XYZ point cloud, but the file holds a ZIP archive; give it the ending of what it holds",
        );
        check(
            "a.docx",
            b"x",
            "files of this kind cannot be read; choose a file that ends in .png, .jpg, .obj, .stl, .ply, .xyz or .csv",
        );
        check("a.xyz", b"\xff\xfe1\0", "the text is in UTF-16; save it in UTF-8");
        check(
            "a.obj",
            b"",
            "the file is empty; choose a file that holds a picture, a mesh or points",
        );
    }
}
