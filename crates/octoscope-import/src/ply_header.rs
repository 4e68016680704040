//! The header of PLY files: which numbers follow, and how they are written.

use crate::error::{ImportError, Place};
use crate::words::{Line, Word, lines};
use octoscope_core::text::Message;

/// How the numbers behind the header are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// As words.
    Text,
    /// As bytes, the least significant first.
    LittleEndian,
    /// As bytes, the most significant first.
    BigEndian,
}

/// Type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    /// Signed, 1 byte.
    I8,
    /// Unsigned, 1 byte.
    U8,
    /// Signed, 2 bytes.
    I16,
    /// Unsigned, 2 bytes.
    U16,
    /// Signed, 4 bytes.
    I32,
    /// Unsigned, 4 bytes.
    U32,
    /// Floating point, 4 bytes.
    F32,
    /// Floating point, 8 bytes.
    F64,
}

/// One number, or one list of numbers, of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Property<'a> {
    /// Name, such as `x`.
    pub name: &'a [u8],
    /// Type of the length that precedes a list; `None` for a single number.
    pub length: Option<Scalar>,
    /// Type of the number or of the items.
    pub item: Scalar,
}

/// A table: `count` rows of the same properties.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element<'a> {
    /// Name, such as `vertex`.
    pub name: &'a [u8],
    /// Announced number of rows; no promise.
    pub count: usize,
    /// Properties of a row, in order.
    pub properties: Vec<Property<'a>>,
    /// Where the element is announced.
    pub place: Place,
}

/// What a header says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header<'a> {
    /// How the rows are written.
    pub encoding: Encoding,
    /// Tables, in the order in which they follow.
    pub elements: Vec<Element<'a>>,
    /// Offset of the first byte behind the header.
    pub length: usize,
    /// Lines of the header.
    pub n_lines: usize,
}

impl Scalar {
    /// Number of bytes.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    fn named(word: &Word<'_>) -> Result<Self, ImportError> {
        Ok(match word.text {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => {
                let told = Message::new("import-ply-type").with("word", word.short());
                return Err(ImportError::at(word.place, told));
            }
        })
    }
}

impl Element<'_> {
    /// Fewest bytes that a row takes; lists may be empty.
    pub fn least_row(&self, encoding: Encoding) -> usize {
        let least = |p: &Property<'_>| p.length.unwrap_or(p.item).size();
        match encoding {
            Encoding::Text => (2 * self.properties.len()).saturating_sub(1),
            Encoding::LittleEndian | Encoding::BigEndian => self.properties.iter().map(least).sum(),
        }
    }
}

/// Reads the header of a PLY file.
///
/// # Errors
/// Tells line and column of what is wrong.
pub fn read(bytes: &[u8]) -> Result<Header<'_>, ImportError> {
    let mut encoding = None;
    let mut elements: Vec<Element<'_>> = Vec::new();
    let mut length = 0;
    let mut last = Place::Line { line: 1, column: 1 };
    for line in lines(bytes) {
        length = (length + line.text.len() + 1).min(bytes.len());
        last = line.end();
        let words: Vec<_> = line.words().take(6).collect();
        let [keyword, arguments @ ..] = words.as_slice() else { continue };
        match (keyword.text, arguments) {
            (b"ply", []) if line.number == 1 => {}
            (b"comment" | b"obj_info", _) => {}
            (b"format", [name, ..]) => encoding = Some(encoding_named(name)?),
            (b"element", [name, count]) => elements.push(Element {
                name: name.text,
                count: whole(count)?,
                properties: Vec::new(),
                place: count.place,
            }),
            (b"property", arguments) => {
                let property = property(&line, arguments)?;
                let Some(element) = elements.last_mut() else {
                    let told = Message::new("import-ply-property-first");
                    return Err(ImportError::at(keyword.place, told));
                };
                element.properties.push(property);
            }
            (b"end_header", []) => {
                let Some(encoding) = encoding else {
                    let told = Message::new("import-ply-no-format");
                    return Err(ImportError::at(keyword.place, told));
                };
                return Ok(Header { encoding, elements, length, n_lines: line.number });
            }
            _ => {
                let told = Message::new("import-ply-line").with("word", keyword.short());
                return Err(ImportError::at(keyword.place, told));
            }
        }
    }
    Err(ImportError::at(last, Message::new("import-ply-header-ends")))
}

fn encoding_named(word: &Word<'_>) -> Result<Encoding, ImportError> {
    match word.text {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::LittleEndian),
        b"binary_big_endian" => Ok(Encoding::BigEndian),
        _ => {
            let told = Message::new("import-ply-format").with("word", word.short());
            Err(ImportError::at(word.place, told))
        }
    }
}

fn property<'a>(line: &Line<'a>, arguments: &[Word<'a>]) -> Result<Property<'a>, ImportError> {
    match arguments {
        [list, length, item, name] if list.text == b"list" => {
            let counts = Scalar::named(length)?;
            if matches!(counts, Scalar::F32 | Scalar::F64) {
                let told = Message::new("import-ply-length-type");
                return Err(ImportError::at(length.place, told));
            }
            Ok(Property { name: name.text, length: Some(counts), item: Scalar::named(item)? })
        }
        [item, name] => Ok(Property { name: name.text, length: None, item: Scalar::named(item)? }),
        _ => Err(ImportError::at(line.end(), Message::new("import-ply-property"))),
    }
}

fn whole(word: &Word<'_>) -> Result<usize, ImportError> {
    let parsed = std::str::from_utf8(word.text).ok().and_then(|text| text.parse().ok());
    parsed.ok_or_else(|| {
        let told = Message::new("import-ply-rows").with("word", word.short());
        ImportError::at(word.place, told)
    })
}
