//! The scenario inside an exported file.

use crate::pdf::ATTACHMENT;
use crate::png::KEYWORD;
use crate::tikz::SCENARIO_LINE;
use flate2::read::ZlibDecoder;
use roxmltree::{Document, ParsingOptions};
use std::io::Read;

/// The scenario inside an SVG, PDF, PNG or TikZ file that this program has
/// written, as JSON; `None` if there is none.
pub fn scenario_inside(bytes: &[u8]) -> Option<String> {
    if bytes.starts_with(PNG_SIGNATURE) {
        return inside_png(&bytes[PNG_SIGNATURE.len()..]);
    }
    if bytes.starts_with(b"%PDF-") {
        return inside_pdf(bytes);
    }
    let text = std::str::from_utf8(bytes).ok()?;
    inside_tikz(text).or_else(|| inside_svg(text))
}

const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Most bytes of a scenario that are unpacked, 256 MiB.
const MOST_BYTES: u64 = 256 << 20;

/// The international text under our keyword, among the chunks: length, name,
/// data, checksum.
fn inside_png(mut rest: &[u8]) -> Option<String> {
    loop {
        let length = u32::from_be_bytes(*rest.first_chunk::<4>()?) as usize;
        let (name, data) = (rest.get(4..8)?, rest.get(8..8 + length)?);
        if name == b"iTXt"
            && let Some(scenario) = international_text(data)
        {
            return Some(scenario);
        }
        rest = rest.get(12 + length..)?;
    }
}

/// Keyword, 0, whether it is compressed, how, language, 0, its translation, 0,
/// text.
fn international_text(data: &[u8]) -> Option<String> {
    let data = data.strip_prefix(KEYWORD.as_bytes())?.strip_prefix(b"\0")?;
    let (is_compressed, data) = (*data.first()? != 0, data.get(2..)?);
    let mut fields = data.splitn(3, |&byte| byte == 0);
    let text = fields.nth(2)?;
    if is_compressed { inflated(text) } else { as_scenario(text) }
}

/// The attached file. Its name is written plainly, so that a foreign PDF is
/// passed over at once; the file itself is one of the streams.
fn inside_pdf(bytes: &[u8]) -> Option<String> {
    find(bytes, ATTACHMENT.as_bytes())?;
    let mut rest = bytes;
    while let Some(start) = find(rest, b"stream") {
        rest = &rest[start + b"stream".len()..];
        let data = rest.strip_prefix(b"\r\n").or_else(|| rest.strip_prefix(b"\n"));
        let Some(data) = data else { continue };
        let end = find(data, b"endstream")?;
        if let Some(scenario) = as_scenario(&data[..end]).or_else(|| inflated(&data[..end])) {
            return Some(scenario);
        }
        rest = &data[end + b"endstream".len()..];
    }
    None
}

fn inside_svg(text: &str) -> Option<String> {
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).ok()?;
    let mut inside = document.descendants().filter(|node| node.has_tag_name("metadata"));
    inside.find_map(|node| as_scenario(node.text()?.trim().as_bytes()))
}

fn inside_tikz(text: &str) -> Option<String> {
    let lines: Vec<&str> =
        text.lines().filter_map(|line| line.strip_prefix(SCENARIO_LINE)).collect();
    as_scenario(lines.join("\n").as_bytes())
}

fn inflated(bytes: &[u8]) -> Option<String> {
    let mut text = Vec::new();
    ZlibDecoder::new(bytes).take(MOST_BYTES).read_to_end(&mut text).ok()?;
    as_scenario(&text)
}

/// The text, if it looks like a scenario.
fn as_scenario(bytes: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(bytes).ok()?.trim();
    let is_whole = text.starts_with('{') && text.ends_with('}');
    (is_whole && text.contains("\"octoscope\"")).then(|| text.to_owned())
}

fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}
