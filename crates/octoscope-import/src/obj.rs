//! Meshes in the Wavefront OBJ format: the statements `v` and `f`; all others
//! are passed over. A `\` at the end of a line joins the next one to it.

use crate::error::{ImportError, Place};
use crate::shape::{Shape, check_points, push_fan};
use crate::words::{Line, Word, lines};
use octoscope_core::progress::Progress;
use octoscope_core::text::Message;

/// Most words that a statement may have.
const MOST_WORDS: usize = 1 << 20;

/// Triangles of the faces of an OBJ file, or its vertices if it has no faces.
///
/// Faces of n corners become fans of n − 2 triangles.
///
/// # Errors
/// Tells line and column of what is wrong.
pub fn read(bytes: &[u8], progress: &Progress) -> Result<Shape, ImportError> {
    let mut mesh = Mesh::default();
    let mut words = Vec::new();
    let mut end = Place::Line { line: 1, column: 1 };
    progress.start(bytes.len() as u64);
    for line in lines(bytes) {
        progress.advance(line.text.len() as u64 + 1)?;
        let (line, goes_on) = without_continuation(line.without_comment());
        words.extend(line.words().take(MOST_WORDS + 1));
        end = line.end();
        if words.len() > MOST_WORDS {
            let told = Message::new("import-obj-statement").with("most", MOST_WORDS);
            return Err(ImportError::at(line.place(0), told));
        }
        if !goes_on {
            mesh.add(&words, end)?;
            words.clear();
        }
    }
    mesh.add(&words, end)?;
    Shape::of(mesh.triangles, mesh.vertices)
}

/// What has been read so far.
#[derive(Default)]
struct Mesh {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[[f64; 3]; 3]>,
}

impl Mesh {
    /// Takes one statement in, whose last line ends at `end`.
    fn add(&mut self, words: &[Word<'_>], end: Place) -> Result<(), ImportError> {
        let Some((keyword, words)) = words.split_first() else { return Ok(()) };
        match keyword.text {
            b"v" => {
                self.vertices.push(vertex(words, end)?);
                check_points(self.vertices.len())?;
            }
            b"f" => {
                let corner = |word| index(word, self.vertices.len()).map(|i| self.vertices[i]);
                let corners: Vec<_> = words.iter().map(corner).collect::<Result<_, _>>()?;
                if corners.len() < 3 {
                    let told = Message::new("import-face").with("n", corners.len());
                    return Err(ImportError::at(end, told));
                }
                push_fan(&corners, &mut self.triangles)?;
            }
            _ => {}
        }
        Ok(())
    }
}

/// The line without a `\` at its end, and whether there was one: then the
/// statement goes on in the next line.
fn without_continuation(line: Line<'_>) -> (Line<'_>, bool) {
    match line.text.trim_ascii_end().strip_suffix(b"\\") {
        Some(text) => (Line { text, ..line }, true),
        None => (line, false),
    }
}

fn vertex(words: &[Word<'_>], end: Place) -> Result<[f64; 3], ImportError> {
    let [x, y, z, ..] = words else {
        for word in words {
            word.number()?;
        }
        return Err(ImportError::at(end, Message::new("import-obj-vertex")));
    };
    Ok([x.number()?, y.number()?, z.number()?])
}

/// Index from 0 of a reference such as `7`, `7/2/5` or `-1` (the last vertex so
/// far).
fn index(word: &Word<'_>, n_vertices: usize) -> Result<usize, ImportError> {
    let number = word.text.split(|&b| b == b'/').next().unwrap_or_default();
    let parsed = std::str::from_utf8(number).ok().and_then(|text| text.parse::<i64>().ok());
    let Some(reference) = parsed else {
        let told = Message::new("import-obj-number").with("word", word.short());
        return Err(ImportError::at(word.place, told));
    };
    let from_zero = match reference {
        1.. => reference.checked_sub(1),
        _ => reference.checked_add(n_vertices as i64).filter(|_| reference != 0),
    };
    from_zero.and_then(|i| usize::try_from(i).ok()).filter(|&i| i < n_vertices).ok_or_else(|| {
        let told = Message::new("import-obj-missing").with("number", reference.to_string());
        ImportError::at(word.place, told)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "# square\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\r\nv 0 1 0\nvn 0 0 1\n";

    fn read_text(faces: &str) -> Result<Shape, ImportError> {
        read(format!("{SQUARE}{faces}").as_bytes(), &Progress::default())
    }

    #[test]
    fn quads_become_two_triangles() {
        let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        let expected = Ok(Shape::Triangles(vec![[a, b, c], [a, c, d]]));
        assert_eq!(read_text("f 1 2 3 4"), expected);
        assert_eq!(read_text("o name\nf 1/9/9 2//9 3/9 4 # all"), expected);
        assert_eq!(read_text("f -4 -3 -2 -1\n\n"), expected);
    }

    #[test]
    fn statements_go_on_behind_a_backslash() {
        let whole = read_text("f 1 2 3 4\nf 1 2 4");
        assert_eq!(read_text("f 1 2 \\\n  3 4\nf 1 \\\r\n\\\n2\\\n4 \\"), whole);
        assert_eq!(read_text("f 1 2 3 4 # \\\nf 1 2 4"), whole);
    }

    #[test]
    fn vertices_without_faces_are_points() {
        assert!(matches!(read_text(""), Ok(Shape::Points(points)) if points.len() == 4));
    }

    #[test]
    fn degenerate_triangles_are_kept() {
        assert!(matches!(read_text("f 1 1 1"), Ok(Shape::Triangles(t)) if t.len() == 1));
    }

    #[track_caller]
    fn check(faces: &str, message: &str) {
        let error = read_text(faces).expect_err("the file is refused");
        assert_eq!(error.to_string(), message);
    }

    #[test]
    fn mistakes_are_told_with_line_and_column() {
        const NUMBER: &str = "number the vertices from 1, or from -1 backwards";
        check("f 1 2 5", &format!("line 7, column 7: vertex 5 is not defined above; {NUMBER}"));
        check("f 0 2 1", &format!("line 7, column 3: vertex 0 is not defined above; {NUMBER}"));
        check("f -5 2 1", &format!("line 7, column 3: vertex -5 is not defined above; {NUMBER}"));
        check(
            "f -9223372036854775808 2 1",
            &format!(
                "line 7, column 3: vertex -9223372036854775808 is not defined above; {NUMBER}"
            ),
        );
        check("f 1 a 2", &format!("line 7, column 5: “a” is not a vertex number; {NUMBER}"));
        check("f 1 2", "line 7, column 6: the face has 2 corners; give it at least 3");
        check("f 1 \\\n 2", "line 8, column 3: the face has 2 corners; give it at least 3");
        check(
            "f 1 2 \\\n 5",
            &format!("line 8, column 2: vertex 5 is not defined above; {NUMBER}"),
        );
        check("v 1 2", "line 7, column 6: the vertex has too few coordinates; write “v x y z”");
        check(
            "v 1 nan 3",
            "line 7, column 5: “nan” is not a finite number; write a number below 1e308",
        );
        check(
            "v 1 2 3,5",
            "line 7, column 7: “3,5” is not a number; write a number such as -1.25 or 3e-4",
        );
    }

    #[test]
    fn endless_statements_are_refused() {
        check(
            &format!("f{}", " 1".repeat(MOST_WORDS)),
            "line 7, column 1: the statement has more than 1048576 words; split it",
        );
    }

    #[test]
    fn text_without_statements_holds_no_points() {
        assert_eq!(read(b"# nothing\n", &Progress::default()), Err(ImportError::NoPoints));
    }
}
