//! Meshes and point clouds in the PLY format, text and binary.

use crate::error::{ImportError, Place};
use crate::ply_header::{self, Element, Encoding, Header, Property, Scalar};
use crate::shape::{Shape, check_points, check_triangles, push_fan};
use crate::words::{Word, lines};
use octoscope_core::progress::Progress;
use octoscope_core::text::Message;

/// Triangles of the faces of a PLY file, or its vertices if it has no faces.
///
/// Faces of n corners become fans of n − 2 triangles; colours, normals and
/// elements other than `vertex` and `face` are passed over.
///
/// # Errors
/// Tells line and column, or the byte, of what is wrong. A header that
/// announces more rows than the file can hold is refused before any is read.
pub fn read(bytes: &[u8], progress: &Progress) -> Result<Shape, ImportError> {
    let header = ply_header::read(bytes)?;
    check_counts(&header, bytes.len() - header.length)?;
    progress.start(header.elements.iter().map(|e| e.count as u64).sum());
    match header.encoding {
        Encoding::Text => {
            let words = lines(&bytes[header.length..]).flat_map(|line| {
                let number = line.number + header.n_lines;
                crate::words::Line { number, ..line }.words()
            });
            let end = Place::Line { line: header.n_lines + 1, column: 1 };
            tables(&header, &mut Text { words, last: end }, progress)
        }
        Encoding::LittleEndian | Encoding::BigEndian => {
            let mut binary = Binary { bytes, offset: header.length, encoding: header.encoding };
            tables(&header, &mut binary, progress)
        }
    }
}

fn check_counts(header: &Header<'_>, mut available: usize) -> Result<(), ImportError> {
    for element in &header.elements {
        let row = element.least_row(header.encoding);
        if row == 0 && element.count > 0 {
            let told = Message::new("import-ply-no-properties");
            return Err(ImportError::at(element.place, told));
        }
        let needed = row.saturating_mul(element.count);
        if needed > available {
            let told = Message::new("import-ply-announced").with("rows", element.count.to_string());
            let told = told.with("needed", needed.to_string()).with("found", available);
            return Err(ImportError::at(element.place, told));
        }
        available -= needed;
        match element.name {
            b"vertex" => check_points(element.count)?,
            b"face" => check_triangles(element.count)?,
            _ => {}
        }
    }
    Ok(())
}

/// Source of the numbers behind the header.
trait Numbers {
    /// Next number, of the given type.
    fn next(&mut self, scalar: Scalar) -> Result<f64, ImportError>;

    /// Where the last number was read.
    fn place(&self) -> Place;
}

fn tables(
    header: &Header<'_>,
    numbers: &mut impl Numbers,
    progress: &Progress,
) -> Result<Shape, ImportError> {
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for element in &header.elements {
        match element.name {
            b"vertex" => read_vertices(element, numbers, &mut vertices, progress)?,
            b"face" => read_faces(element, numbers, &vertices, &mut triangles, progress)?,
            _ => {
                for _ in 0..element.count {
                    progress.advance(1)?;
                    for property in &element.properties {
                        pass_over(property, numbers)?;
                    }
                }
            }
        }
    }
    Shape::of(triangles, vertices)
}

fn read_vertices(
    element: &Element<'_>,
    numbers: &mut impl Numbers,
    vertices: &mut Vec<[f64; 3]>,
    progress: &Progress,
) -> Result<(), ImportError> {
    let axis = |p: &Property<'_>| match (p.name, p.length) {
        (b"x", None) => Some(0),
        (b"y", None) => Some(1),
        (b"z", None) => Some(2),
        _ => None,
    };
    if !(0..3).all(|e| element.properties.iter().any(|p| axis(p) == Some(e))) {
        return Err(ImportError::at(element.place, Message::new("import-ply-no-xyz")));
    }
    for _ in 0..element.count {
        progress.advance(1)?;
        let mut vertex = [0.0; 3];
        for property in &element.properties {
            let Some(axis) = axis(property) else {
                pass_over(property, numbers)?;
                continue;
            };
            let coordinate = numbers.next(property.item)?;
            if !coordinate.is_finite() {
                let told = Message::new("import-ply-not-finite").with("number", vertices.len());
                return Err(ImportError::at(numbers.place(), told));
            }
            vertex[axis] = coordinate;
        }
        vertices.push(vertex);
    }
    Ok(())
}

fn read_faces(
    element: &Element<'_>,
    numbers: &mut impl Numbers,
    vertices: &[[f64; 3]],
    triangles: &mut Vec<[[f64; 3]; 3]>,
    progress: &Progress,
) -> Result<(), ImportError> {
    let is_corners = |p: &Property<'_>| {
        p.length.is_some() && matches!(p.name, b"vertex_indices" | b"vertex_index")
    };
    if element.count > 0 && !element.properties.iter().any(is_corners) {
        return Err(ImportError::at(element.place, Message::new("import-ply-no-indices")));
    }
    let mut corners = Vec::new();
    for _ in 0..element.count {
        progress.advance(1)?;
        for property in &element.properties {
            if !is_corners(property) {
                pass_over(property, numbers)?;
                continue;
            }
            corners.clear();
            for _ in 0..length(property, numbers)? {
                let index = numbers.next(property.item)?;
                let vertex = (index >= 0.0 && index.fract() == 0.0)
                    .then(|| vertices.get(index as usize))
                    .flatten();
                let Some(vertex) = vertex else {
                    let told = Message::new("import-ply-missing").with("number", index.to_string());
                    let told = told.with("n", vertices.len());
                    return Err(ImportError::at(numbers.place(), told));
                };
                corners.push(*vertex);
                // A polygon of n corners becomes n − 2 triangles.
                check_triangles(corners.len().saturating_sub(2))?;
            }
            if corners.len() < 3 {
                let told = Message::new("import-face").with("n", corners.len());
                return Err(ImportError::at(numbers.place(), told));
            }
            push_fan(&corners, triangles)?;
        }
    }
    Ok(())
}

/// Number of items that follow: one, or those of a list.
fn length(property: &Property<'_>, numbers: &mut impl Numbers) -> Result<u64, ImportError> {
    let Some(scalar) = property.length else { return Ok(1) };
    let length = numbers.next(scalar)?;
    if length < 0.0 || length.fract() != 0.0 || !length.is_finite() {
        let told = Message::new("import-ply-length").with("length", length.to_string());
        return Err(ImportError::at(numbers.place(), told));
    }
    Ok(length as u64)
}

fn pass_over(property: &Property<'_>, numbers: &mut impl Numbers) -> Result<(), ImportError> {
    // Every item takes at least one byte of the file, so this ends.
    for _ in 0..length(property, numbers)? {
        numbers.next(property.item)?;
    }
    Ok(())
}

struct Text<I> {
    words: I,
    last: Place,
}

impl<'a, I: Iterator<Item = Word<'a>>> Numbers for Text<I> {
    fn next(&mut self, _: Scalar) -> Result<f64, ImportError> {
        let Some(word) = self.words.next() else {
            return Err(ImportError::at(self.last, Message::new("import-ply-ends")));
        };
        self.last = word.place;
        // Words such as "nan" are numbers where nobody needs them finite.
        let parsed = std::str::from_utf8(word.text).ok().and_then(|text| text.parse().ok());
        match parsed {
            Some(number) => Ok(number),
            None => word.finite(None),
        }
    }

    fn place(&self) -> Place {
        self.last
    }
}

struct Binary<'a> {
    bytes: &'a [u8],
    offset: usize,
    encoding: Encoding,
}

impl Binary<'_> {
    /// Next N bytes, the least significant first.
    fn take<const N: usize>(&mut self) -> Result<[u8; N], ImportError> {
        let Some(chunk) = self.bytes.get(self.offset..).and_then(|rest| rest.first_chunk::<N>())
        else {
            let place = Place::Byte(self.bytes.len());
            return Err(ImportError::at(place, Message::new("import-ply-row-ends")));
        };
        self.offset += N;
        let mut chunk = *chunk;
        if self.encoding == Encoding::BigEndian {
            chunk.reverse();
        }
        Ok(chunk)
    }
}

impl Numbers for Binary<'_> {
    fn next(&mut self, scalar: Scalar) -> Result<f64, ImportError> {
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.take()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.take()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.take()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.take()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.take()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.take()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.take()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.take()?),
        })
    }

    fn place(&self) -> Place {
        Place::Byte(self.offset)
    }
}

#[cfg(test)]
#[path = "ply_tests.rs"]
mod tests;
