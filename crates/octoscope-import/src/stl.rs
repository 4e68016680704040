//! Meshes in the STL format, text and binary.

use crate::error::{ImportError, Place};
use crate::kind::starts_with_word;
use crate::shape::{Shape, check_triangles};
use crate::words::lines;
use octoscope_core::progress::Progress;
use octoscope_core::text::Message;

/// Length of what precedes the triangles of a binary file: 80 bytes of comment
/// and the number of triangles.
const HEADER: usize = 84;

/// Length of a triangle: normal, three vertices, two bytes of attributes.
const TRIANGLE: usize = 50;

/// Triangles of an STL file; the normals are passed over.
///
/// # Errors
/// Tells line and column, or the byte, of what is wrong.
pub fn read(bytes: &[u8], progress: &Progress) -> Result<Shape, ImportError> {
    // Some binary files begin with "solid", too; then the length gives them away.
    let binary = match count(bytes) {
        Some(n) => {
            n.checked_mul(TRIANGLE) == Some(bytes.len() - HEADER)
                || !starts_with_word(bytes, b"solid")
        }
        None => !starts_with_word(bytes, b"solid"),
    };
    let triangles =
        if binary { read_binary(bytes, progress)? } else { read_text(bytes, progress)? };
    Shape::of(triangles, Vec::new())
}

fn count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER - 4..)?.first_chunk::<4>()?;
    Some(u32::from_le_bytes(*count) as usize)
}

fn read_binary(bytes: &[u8], progress: &Progress) -> Result<Vec<[[f64; 3]; 3]>, ImportError> {
    let Some(n_triangles) = count(bytes) else {
        let told = Message::new("import-stl-header-ends").with("length", HEADER);
        return Err(ImportError::at(Place::Byte(bytes.len()), told));
    };
    let rows = bytes[HEADER..].chunks_exact(TRIANGLE);
    if n_triangles > rows.len() {
        let told = Message::new("import-stl-count").with("announced", n_triangles);
        return Err(ImportError::at(Place::Byte(HEADER - 4), told.with("n", rows.len())));
    }
    check_triangles(n_triangles)?;
    let mut triangles = Vec::with_capacity(n_triangles);
    progress.start(n_triangles as u64);
    for (number, row) in rows.take(n_triangles).enumerate() {
        progress.advance(1)?;
        let number_at = |i: usize| {
            let start = 12 + 4 * i;
            let bytes = [row[start], row[start + 1], row[start + 2], row[start + 3]];
            f64::from(f32::from_le_bytes(bytes))
        };
        let corners: [[f64; 3]; 3] =
            std::array::from_fn(|v| std::array::from_fn(|e| number_at(3 * v + e)));
        if let Some(i) = corners.as_flattened().iter().position(|x| !x.is_finite()) {
            let place = Place::Byte(HEADER + number * TRIANGLE + 12 + 4 * i);
            let told = Message::new("import-stl-not-finite").with("number", number + 1);
            return Err(ImportError::at(place, told));
        }
        triangles.push(corners);
    }
    Ok(triangles)
}

fn read_text(bytes: &[u8], progress: &Progress) -> Result<Vec<[[f64; 3]; 3]>, ImportError> {
    let mut triangles = Vec::new();
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let (mut complete, mut last) = (false, Place::Line { line: 1, column: 1 });
    progress.start(bytes.len() as u64);
    for line in lines(bytes) {
        progress.advance(line.text.len() as u64 + 1)?;
        let mut words = line.words();
        let Some(keyword) = words.next() else { continue };
        last = line.end();
        complete = false;
        match keyword.text.to_ascii_lowercase().as_slice() {
            b"solid" | b"facet" | b"outer" | b"endfacet" => {}
            b"endsolid" => complete = true,
            b"vertex" => {
                let mut coordinate = || match words.next() {
                    Some(word) => word.number(),
                    None => Err(ImportError::at(line.end(), Message::new("import-stl-vertex"))),
                };
                corners.push([coordinate()?, coordinate()?, coordinate()?]);
                if corners.len() > 3 {
                    return Err(ImportError::at(keyword.place, Message::new("import-stl-long")));
                }
            }
            b"endloop" => {
                let Ok(triangle) = <[[f64; 3]; 3]>::try_from(corners.as_slice()) else {
                    let told = Message::new("import-stl-loop").with("n", corners.len());
                    return Err(ImportError::at(keyword.place, told));
                };
                corners.clear();
                triangles.push(triangle);
                check_triangles(triangles.len())?;
            }
            _ => {
                let told = Message::new("import-stl-keyword").with("word", keyword.short());
                return Err(ImportError::at(keyword.place, told));
            }
        }
    }
    if !complete {
        return Err(ImportError::at(last, Message::new("import-stl-ends")));
    }
    Ok(triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "solid a b\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1e0 -.5\n  endloop\n endfacet\nendsolid a b\n";

    fn binary(header: &[u8], announced: u32, triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, b' ');
        bytes.extend(announced.to_le_bytes());
        for corners in triangles {
            bytes.extend([0; 12]);
            bytes.extend(corners.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    const CORNERS: [[f32; 3]; 3] = [[0., 0., 0.], [1., 0., 0.], [0., 1., -0.5]];

    #[test]
    fn text_and_binary_hold_the_same_triangle() {
        let expected = Ok(Shape::Triangles(vec![CORNERS.map(|p| p.map(f64::from))]));
        assert_eq!(read(TEXT.as_bytes(), &Progress::default()), expected);
        assert_eq!(read(&binary(b"made", 1, &[CORNERS]), &Progress::default()), expected);
        assert_eq!(read(&binary(b"solid", 1, &[CORNERS]), &Progress::default()), expected);
    }

    #[track_caller]
    fn check(bytes: &[u8], message: &str) {
        let error = read(bytes, &Progress::default()).expect_err("the file is refused");
        assert_eq!(error.to_string(), message);
    }

    #[test]
    fn mistakes_in_text_are_told_with_line_and_column() {
        check(
            TEXT.replace("1e0", "one").as_bytes(),
            "line 6, column 13: “one” is not a number; write a number such as -1.25 or 3e-4",
        );
        check(
            TEXT.replace("0 1e0 -.5", "0 1").as_bytes(),
            "line 6, column 14: the vertex has too few coordinates; write “vertex x y z”",
        );
        check(
            TEXT.replace("   vertex 1 0 0\n", "").as_bytes(),
            "line 6, column 3: the loop has 2 vertices; give it 3",
        );
        check(
            TEXT.replace("  endloop\n", "vertex 0 0 0\n").as_bytes(),
            "line 7, column 1: the loop has more than 3 vertices; give it 3",
        );
        check(
            TEXT.replace(" endfacet", "end").as_bytes(),
            "line 8, column 1: “end” is no STL keyword; write solid, facet, outer, vertex, endloop, endfacet or endsolid",
        );
        check(
            TEXT.replace("endsolid a b\n", "").as_bytes(),
            "line 8, column 10: the file ends before “endsolid”; fetch the file again",
        );
        check(
            b"solid\nendsolid",
            "the file holds no points; choose a file with at least one point or triangle",
        );
    }

    #[test]
    fn mistakes_in_binary_are_told_with_their_byte() {
        check(
            b"\x01\x02",
            "byte 2: the file ends within its header of 84 bytes; fetch the file again",
        );
        check(
            &binary(b"", u32::MAX, &[CORNERS]),
            "byte 80: 4294967295 triangles are announced, 1 follow; fetch the file again",
        );
        let mut wrong = CORNERS;
        wrong[1][2] = f32::NAN;
        check(
            &binary(b"", 2, &[CORNERS, wrong]),
            "byte 166: a coordinate of triangle 2 is not finite; repair the mesh where it was made",
        );
    }
}
