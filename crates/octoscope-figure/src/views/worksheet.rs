//! A page to be filled in by hand, and the same page filled in.

use super::exercise::{Exercise, NodeAnswer};
use super::sheet::Sheet;
use super::words::{joined, on_axis, strong, tuple};
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::{RichText, Span, approx, number};
use octoscope_core::geometry::AXIS_NAMES;
use octoscope_core::text::Texts;
use octoscope_core::tree::{NodeId, Tree, branch};

/// What stands in the fields of a worksheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fields {
    /// Nothing.
    Empty,
    /// The solution.
    Solved,
}

/// An exercise on a page of this width: `picture` of the tree and the ray with what
/// is given beside it; a table of t for every inner node on the ray, with its
/// children in order; for every leaf its path and the bits of its codes.
pub fn worksheet<const D: usize>(
    tree: &Tree<D>,
    exercise: &Exercise<D>,
    picture: Figure,
    texts: &Texts,
    (fields, width): (Fields, f64),
) -> Figure {
    let page = Page { tree, exercise, texts, fields, width };
    let mut sheet = Sheet::default();
    let top = page.head(&mut sheet);
    let side = picture.page.width;
    let below = top + picture.page.height;
    sheet.place(picture.drawn, [0.0, top]);
    let given = page.given(&mut sheet, [side + 18.0, top]);
    let top = below.max(given) + 14.0;
    let top = page.nodes(&mut sheet, top) + 4.0;
    let bottom = page.leaves(&mut sheet, top);
    sheet.figure([width, bottom])
}

struct Page<'a, const D: usize> {
    tree: &'a Tree<D>,
    exercise: &'a Exercise<D>,
    texts: &'a Texts,
    fields: Fields,
    width: f64,
}

/// Height of a field, and width of one for a digit.
const FIELD: f64 = 18.0;
const DIGIT: f64 = 16.0;

impl<const D: usize> Page<'_, D> {
    /// Title, and room for a name; returns where they end.
    fn head(&self, sheet: &mut Sheet) -> f64 {
        let tree = self.texts.get(if D == 2 { "worksheet-quadtree" } else { "worksheet-octree" });
        let key = match self.fields {
            Fields::Empty => "worksheet-exercise",
            Fields::Solved => "worksheet-solution",
        };
        let number = self.exercise.number.map_or(String::new(), |number| format!(" {number}"));
        let arguments = [("number", number.into()), ("tree", tree.into())];
        sheet.text(Role::Heading, [0.0, 8.0], Anchor::Start, self.texts.format(key, &arguments));
        if self.fields == Fields::Empty {
            let room = 150.0;
            let name = self.texts.get("worksheet-name");
            let left = self.width - room;
            sheet.text(Role::Note, [left - 6.0, 8.0], Anchor::End, name);
            sheet.line(Role::Blank, [[left, 14.0], [self.width, 14.0]]);
        }
        sheet.line(Role::Rule, [[0.0, 20.0], [self.width, 20.0]]);
        32.0
    }

    /// What is given and asked, beside the picture; returns where it ends.
    fn given(&self, sheet: &mut Sheet, [left, top]: [f64; 2]) -> f64 {
        let width = self.width - left;
        let domain = self.tree.domain();
        let interval = |axis: usize| {
            let [min, max] = [0, domain.grid_size()].map(|code| number(domain.plane(axis, code)));
            format!("{min} ≤ {} < {max}", AXIS_NAMES[axis])
        };
        let box_text = joined((0..D).flat_map(|axis| {
            [RichText::from(if axis == 0 { "" } else { ", " }), on_axis(axis, interval(axis))]
        }));
        let ray = self.exercise.ray;
        let short = |numbers: [f64; D]| tuple(numbers.map(typographic));
        let mut y = top;
        for (key, text) in [
            ("worksheet-domain", box_text),
            ("ray-origin", short(ray.origin())),
            ("ray-direction", short(ray.direction())),
        ] {
            sheet.text(Role::Note, [left, y + 8.0], Anchor::Start, self.texts.get(key));
            y += 16.0;
            y += sheet.paragraph(Role::Words, [left, y], width, &text) + 4.0;
        }
        for key in ["worksheet-task-t", "worksheet-task-children", "worksheet-task-codes"] {
            y += 6.0;
            y += sheet.paragraph(Role::Words, [left, y], width, &self.texts.get(key).into());
        }
        y
    }

    /// A block for every inner node; returns where they end.
    fn nodes(&self, sheet: &mut Sheet, top: f64) -> f64 {
        const GAP: [f64; 2] = [18.0, 14.0];
        const NAME: f64 = 14.0;
        let n_columns = 3.0;
        let block = (self.width - (n_columns - 1.0) * GAP[0]) / n_columns;
        let height = 20.0 + 14.0 + FIELD * (D as f64 + 1.0) + 8.0;
        let nodes = self.exercise.nodes();
        for (n, answer) in nodes.iter().enumerate() {
            let (row, column) = (n / 3, n % 3);
            let left = column as f64 * (block + GAP[0]);
            let y = top + row as f64 * (height + GAP[1]);
            self.node_title(sheet, n, answer.node, [left, y + 8.0], block);
            let field = (block - NAME) / 3.0;
            let planes = [("0", answer.near), ("m", answer.mid), ("1", answer.far)];
            for (n, (plane, t)) in planes.into_iter().enumerate() {
                let x = left + NAME + field * n as f64;
                let name = joined(["t".into(), sub(plane)]);
                sheet.text(Role::Note, [x + 0.5 * field, y + 26.0], Anchor::Middle, name);
                for axis in 0..D {
                    let at = [x, y + 34.0 + FIELD * axis as f64];
                    self.field(sheet, at, [field, FIELD], short(t[axis]).into());
                }
            }
            for axis in 0..D {
                let at = [left, y + 34.0 + FIELD * (axis as f64 + 0.5)];
                sheet.text(Role::Words, at, Anchor::Start, on_axis(axis, AXIS_NAMES[axis]));
            }
            self.children(sheet, answer, [left, y + 34.0 + FIELD * D as f64 + 8.0], block);
        }
        let n_rows = nodes.len().div_ceil(3) as f64;
        top + n_rows * (height + GAP[1])
    }

    /// Number of a node, and its level and codes.
    fn node_title(&self, sheet: &mut Sheet, n: usize, node: NodeId, at: [f64; 2], block: f64) {
        let name = self.texts.format("worksheet-node", &[("n", (n + 1).into())]);
        let wide = sheet.text(Role::Words, at, Anchor::Start, strong(name));
        let x = at[0] + wide + 8.0;
        let codes = self.tree.code(node).map(|c| c.to_string());
        let level = self.tree.level(node);
        let place = joined([
            format!("{} {level}, ", self.texts.get("worksheet-level")).into(),
            tuple(codes),
        ]);
        if node == NodeId::ROOT {
            sheet.text(Role::Note, [x, at[1]], Anchor::Start, self.texts.get("worksheet-root"));
        } else if self.fields == Fields::Solved {
            sheet.text(Role::Note, [x, at[1]], Anchor::Start, place);
        } else {
            sheet.line(Role::Blank, [[x, at[1] + 6.0], [at[0] + block, at[1] + 6.0]]);
        }
    }

    /// Fields for the children of a node on the ray: at most D + 1.
    fn children(
        &self,
        sheet: &mut Sheet,
        answer: &NodeAnswer<D>,
        [left, top]: [f64; 2],
        block: f64,
    ) {
        let wanted = self.children_of(answer.node);
        let n = D + 1;
        let start = left + block - n as f64 * (DIGIT + 4.0) + 4.0;
        let name = self.texts.get("worksheet-children");
        sheet.text(Role::Note, [left, top + 0.5 * FIELD], Anchor::Start, name);
        for index in 0..n {
            let text = wanted.get(index).map_or(String::new(), u8::to_string);
            let at = [start + index as f64 * (DIGIT + 4.0), top];
            self.field(sheet, at, [DIGIT, FIELD], text.into());
        }
    }

    /// Children of a node in the order of the ray.
    fn children_of(&self, node: NodeId) -> Vec<u8> {
        let mut children: Vec<u8> = Vec::new();
        let level = self.tree.level(node);
        for (leaf, _) in self.exercise.trace.leaves() {
            if self.tree.ancestors(leaf).any(|above| above == node) {
                let child = branch(self.tree.code(leaf), level).0;
                if children.last() != Some(&child) {
                    children.push(child);
                }
            }
        }
        children
    }

    /// A row for every leaf; returns where they end.
    fn leaves(&self, sheet: &mut Sheet, top: f64) -> f64 {
        const GAP: f64 = 14.0;
        const BETWEEN: f64 = 30.0;
        const ROW: f64 = FIELD + 5.0;
        let title = self.texts.get("worksheet-leaves");
        sheet.text(Role::Words, [0.0, top + 8.0], Anchor::Start, strong(title));
        let top = top + 20.0;
        let levels = self.tree.domain().root_level();
        let group = f64::from(levels) * DIGIT;
        let path = self.texts.get("worksheet-path");
        let path_width = metrics::width(Role::Note, &path.as_str().into()).max(group);
        let path_left = 22.0;
        let axis_left = |axis: usize| path_left + path_width + GAP + (group + GAP) * axis as f64;
        let whole = axis_left(D) - GAP;
        let n_columns = ((self.width + BETWEEN) / (whole + BETWEEN)).floor().clamp(1.0, 3.0);
        let n_leaves = self.exercise.trace.leaves().count();
        let n_rows = n_leaves.div_ceil(n_columns as usize).max(1);
        for (n, (leaf, _)) in self.exercise.trace.leaves().enumerate() {
            let (column, row) = (n / n_rows, n % n_rows);
            let left = column as f64 * (whole + BETWEEN);
            if row == 0 {
                let at = [left + path_left, top + 8.0];
                sheet.text(Role::Note, at, Anchor::Start, path.as_str());
                for axis in 0..D {
                    let name = on_axis(axis, AXIS_NAMES[axis]);
                    let at = [left + axis_left(axis), top + 8.0];
                    sheet.text(Role::Words, at, Anchor::Start, name);
                }
            }
            let y = top + 18.0 + ROW * row as f64;
            let at = [left + path_left - 6.0, y + 0.5 * FIELD];
            sheet.text(Role::Note, at, Anchor::End, (n + 1).to_string());
            let (code, level) = (self.tree.code(leaf), self.tree.level(leaf));
            for step in 0..levels {
                let bit = levels - 1 - step;
                let x = f64::from(step) * DIGIT;
                let is_known = bit >= level;
                let path = if is_known { branch(code, bit + 1).0.to_string() } else { "·".into() };
                let at = [left + path_left + x, y];
                self.field(sheet, at, [DIGIT, FIELD], path.into());
                for axis in 0..D {
                    let digit = match (is_known, code[axis] >> bit & 1 == 1) {
                        (false, _) => "·",
                        (true, true) => "1",
                        (true, false) => "0",
                    };
                    let at = [left + axis_left(axis) + x, y];
                    self.field(sheet, at, [DIGIT, FIELD], on_axis(axis, digit));
                }
            }
        }
        top + 18.0 + ROW * n_rows as f64
    }

    /// A field, with its text in it if the sheet is solved.
    fn field(&self, sheet: &mut Sheet, at: [f64; 2], size: [f64; 2], text: RichText) {
        sheet.rect(Role::Blank, at, size);
        if self.fields == Fields::Solved {
            let middle = [at[0] + 0.5 * size[0], at[1] + 0.5 * size[1]];
            debug_assert!(metrics::width(Role::Note, &text) <= size[0] + 4.0, "{}", text.plain());
            sheet.text(Role::Note, middle, Anchor::Middle, text);
        }
    }
}

fn sub(plane: &str) -> RichText {
    RichText(vec![Span { text: plane.to_owned(), sub: true, ..Span::default() }])
}

/// A parameter in full if it is short, else to four digits.
fn short(t: f64) -> String {
    let whole = typographic(t);
    if whole.chars().count() <= 6 { whole } else { approx(t) }
}

/// The shortest number that reads back, with a typographic minus.
fn typographic(x: f64) -> String {
    // Sums of twentieths have a last bit too many.
    let rounded = (x * 1e9).round() / 1e9;
    number(rounded).replace('-', "−")
}
