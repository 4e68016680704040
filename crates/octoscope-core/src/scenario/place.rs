//! Where in the text of a scenario a field or a value stands.

/// Name of a field, or a value.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Spot {
    /// Path from the whole, such as `scene.points[3]`; empty for the whole.
    pub path: String,
    /// Offset of its first byte.
    pub start: usize,
    /// Offset behind its last byte; of an object or list that is still open,
    /// behind its bracket.
    pub end: usize,
}

/// The last field name, value or closed list that begins before `offset`.
pub(super) fn spot_before(text: &str, offset: usize) -> Spot {
    let mut scan = Scan::new(text);
    let mut last = Spot::default();
    while let Some(found) = scan.next_found() {
        if found.begins >= offset {
            break;
        }
        last = scan.spot(&found);
    }
    last
}

/// The value at `path`, or the one around it if it is not there.
pub(super) fn spot_of(text: &str, path: &str) -> Spot {
    let mut scan = Scan::new(text);
    let most_open = path.matches(['.', '[']).count() + 1;
    let mut best = Spot::default();
    while let Some(found) = scan.next_found() {
        // Its path would be longer, and long to write if much is open.
        if found.n_open > most_open {
            continue;
        }
        let spot = scan.spot(&found);
        let within = path.strip_prefix(spot.path.as_str());
        let fits = spot.path.is_empty() || within.is_some_and(|w| !w.starts_with(is_of_a_name));
        if fits && spot.path.len() >= best.path.len() {
            best = spot;
        }
    }
    best
}

/// Line and column of byte `offset`, both from 1, the column in characters.
pub(super) fn line_and_column(text: &str, offset: usize) -> [usize; 2] {
    let before = &text[..text.floor_char_boundary(offset)];
    let line_start = before.rfind('\n').map_or(0, |end| end + 1);
    [before.matches('\n').count() + 1, before[line_start..].chars().count() + 1]
}

fn is_of_a_name(c: char) -> bool {
    c.is_alphanumeric() || c == '-' || c == '_'
}

/// Goes through the names and values of a text, whether it is whole or not.
struct Scan<'a> {
    text: &'a str,
    offset: usize,
    /// Objects and lists that are open, the outermost first.
    open: Vec<Open<'a>>,
}

/// Object or list that is open, with the offset of its bracket.
enum Open<'a> {
    Object { start: usize, name: &'a str, part: Part },
    List { start: usize, index: usize },
}

/// What comes next in an object.
#[derive(PartialEq, Eq)]
enum Part {
    Name,
    Value,
}

/// A name or a value, as long as nothing after it has been scanned.
struct Found {
    /// Where what ends it begins: the closing bracket of an object or a list,
    /// else itself.
    begins: usize,
    /// Offsets of its first byte and behind its last.
    start: usize,
    end: usize,
    /// How many objects and lists are open around it.
    n_open: usize,
}

impl<'a> Scan<'a> {
    fn new(text: &'a str) -> Self {
        Self { text, offset: 0, open: Vec::new() }
    }

    fn next_found(&mut self) -> Option<Found> {
        loop {
            let start = self.offset;
            let c = self.text[start..].chars().next()?;
            self.offset += c.len_utf8();
            match c {
                '{' | '[' => {
                    let found = self.found(start, start);
                    self.open.push(match c {
                        '{' => Open::Object { start, name: "", part: Part::Name },
                        _ => Open::List { start, index: 0 },
                    });
                    return Some(found);
                }
                '}' | ']' => match self.open.pop() {
                    Some(Open::Object { start: begin, .. } | Open::List { start: begin, .. }) => {
                        return Some(self.found(start, begin));
                    }
                    None => {}
                },
                ',' => match self.open.last_mut() {
                    Some(Open::Object { part, .. }) => *part = Part::Name,
                    Some(Open::List { index, .. }) => *index += 1,
                    None => {}
                },
                ':' => {
                    if let Some(Open::Object { part, .. }) = self.open.last_mut() {
                        *part = Part::Value;
                    }
                }
                '"' => {
                    let inside = self.skip_string();
                    if let Some(Open::Object { name, part: Part::Name, .. }) = self.open.last_mut()
                    {
                        *name = inside;
                    }
                    return Some(self.found(start, start));
                }
                c if c.is_whitespace() => {}
                _ => {
                    let rest = &self.text[start..];
                    let is_end = |c: char| c.is_whitespace() || "{}[]:,\"".contains(c);
                    self.offset = start + rest.find(is_end).unwrap_or(rest.len());
                    return Some(self.found(start, start));
                }
            }
        }
    }

    /// Goes behind the quotation mark that ends a string; returns what is inside.
    fn skip_string(&mut self) -> &'a str {
        let start = self.offset;
        let mut escaped = false;
        for (i, c) in self.text[start..].char_indices() {
            if c == '"' && !escaped {
                self.offset = start + i + 1;
                return &self.text[start..start + i];
            }
            escaped = c == '\\' && !escaped;
        }
        self.offset = self.text.len();
        &self.text[start..]
    }

    /// What goes from `start` to here.
    fn found(&self, begins: usize, start: usize) -> Found {
        Found { begins, start, end: self.offset, n_open: self.open.len() }
    }

    /// What was found last, with its path.
    fn spot(&self, found: &Found) -> Spot {
        let mut path = String::new();
        for open in &self.open[..found.n_open] {
            match open {
                Open::Object { name, .. } if path.is_empty() => path.push_str(name),
                Open::Object { name, .. } => {
                    path.push('.');
                    path.push_str(name);
                }
                Open::List { index, .. } => path.push_str(&format!("[{index}]")),
            }
        }
        Spot { path, start: found.start, end: found.end }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "{\"a\": [1, {\"ü\": tru}],\n \"b\\\"\": \"x\"}";

    fn before(part: &str) -> (String, &'static str) {
        let offset = TEXT.find(part).unwrap() + part.len();
        let spot = spot_before(TEXT, offset);
        (spot.path, &TEXT[spot.start..spot.end])
    }

    #[test]
    fn the_last_name_or_value_is_found_with_its_path() {
        let check = |part, path: &str, text| assert_eq!(before(part), (path.to_owned(), text));
        check("\"a", "a", "\"a\"");
        check("1", "a[0]", "1");
        check("{\"ü\"", "a[1].ü", "\"ü\"");
        check("tru", "a[1].ü", "tru");
        check("}", "a[1]", "{\"ü\": tru}");
        check("]", "a", "[1, {\"ü\": tru}]");
        check("b", "b\\\"", "\"b\\\"\"");
        check("\"x\"}", "", TEXT);
    }

    #[test]
    fn paths_are_found_or_what_is_around_them() {
        let check = |path: &str, text| {
            let spot = spot_of(TEXT, path);
            assert_eq!(&TEXT[spot.start..spot.end], text, "{path}");
        };
        check("a[0]", "1");
        check("a[1].x", "{\"ü\": tru}");
        check("a[7]", "[1, {\"ü\": tru}]");
        check("ab", TEXT);
        check("", TEXT);
    }

    #[test]
    fn a_text_nested_deep_is_searched_in_one_pass() {
        let text = "[".repeat(200_000);
        assert_eq!(spot_of(&text, "a").end, 1);
        assert_eq!(spot_of(&text, "[0]").start, 1);
    }

    #[test]
    fn columns_count_characters() {
        assert_eq!(line_and_column("ä\nöü", 5), [2, 2]);
        assert_eq!(line_and_column("", 9), [1, 1]);
    }
}
