//! A page to be filled in by hand, and the same page filled in.

use super::exercise::{Exercise, NodeAnswer};
use super::sheet::Sheet;
use super::words::{joined, on_axis, strong, tuple};
use crate::{Anchor, Figure, Role, metrics};
use octoscope_core::explain::{RichText, Span, approx, shown_number};
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
/// children in order; for every leaf its path and the bits of its codes. Where the page
/// is narrow, as a column of text is, there is less beside each other.
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
    let beside = picture.page.width + 18.0;
    let below = top + picture.page.height;
    let is_narrow = width - beside < LEAST_GIVEN;
    let left = if is_narrow { 0.5 * (width - picture.page.width) } else { 0.0 };
    sheet.place(picture.drawn, [left, top]);
    let given = if is_narrow { [0.0, below + 12.0] } else { [beside, top] };
    let top = page.given(&mut sheet, given).max(below) + 14.0;
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

/// Height of a field, and usual width of one for a digit.
const FIELD: f64 = 18.0;
const DIGIT: f64 = 16.0;
const LEAST_DIGIT: f64 = 10.0;
/// Room before a leaf for its number, and between the fields of its path and codes.
const NUMBER: f64 = 22.0;
const GAP: f64 = 14.0;
/// Least width of the text beside the picture, and of the block of a node.
const LEAST_GIVEN: f64 = 180.0;
const LEAST_BLOCK: f64 = 138.0;
/// Most blocks beside each other, and the height of a title of one line.
const MOST_BLOCKS: f64 = 3.0;
const ONE_LINE: f64 = 20.0;

impl<const D: usize> Page<'_, D> {
    /// Title, and room for a name, beside each other or not; returns where they end.
    fn head(&self, sheet: &mut Sheet) -> f64 {
        const ROOM: f64 = 150.0;
        const TOP: f64 = -1.45;
        let tree = self.texts.get(if D == 2 { "worksheet-quadtree" } else { "worksheet-octree" });
        let key = match self.fields {
            Fields::Empty => "worksheet-exercise",
            Fields::Solved => "worksheet-solution",
        };
        let number = self.exercise.number.map_or(String::new(), |number| format!(" {number}"));
        let arguments = [("number", number.into()), ("tree", tree.into())];
        let title: RichText = self.texts.format(key, &arguments).into();
        let title_width = metrics::width(Role::Heading, &title);
        let mut bottom = TOP + sheet.paragraph(Role::Heading, [0.0, TOP], self.width, &title);
        if self.fields == Fields::Empty {
            let name = self.texts.get("worksheet-name");
            let name_width = metrics::width(Role::Note, &name.as_str().into());
            let is_beside = title_width + 18.0 + name_width + 6.0 + ROOM <= self.width;
            let (y, left) = if is_beside {
                (8.0, self.width - ROOM)
            } else {
                bottom += 26.0;
                (bottom - 10.0, name_width + 6.0)
            };
            sheet.text(Role::Note, [left - 6.0, y], Anchor::End, name);
            sheet.line(Role::Blank, [[left, y + 6.0], [self.width, y + 6.0]]);
        }
        let rule = bottom + 2.55;
        sheet.line(Role::Rule, [[0.0, rule], [self.width, rule]]);
        rule + 12.0
    }

    /// What is given and asked, beside the picture; returns where it ends.
    fn given(&self, sheet: &mut Sheet, [left, top]: [f64; 2]) -> f64 {
        let width = self.width - left;
        let domain = self.tree.domain();
        let interval = |axis: usize| {
            let [min, max] =
                [0, domain.grid_size()].map(|code| shown_number(domain.plane(axis, code)));
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
        let nodes = self.exercise.nodes();
        // The same for all, filled in or not.
        let least = LEAST_BLOCK.max(NAME + 3.0 * widest(&nodes));
        let fitting = ((self.width + GAP[0]) / (least + GAP[0])).floor();
        let n_columns = fitting.clamp(1.0, MOST_BLOCKS);
        let block = (self.width - (n_columns - 1.0) * GAP[0]) / n_columns;
        let title = self.title_height(&nodes, block);
        let height = title + 14.0 + FIELD * (D as f64 + 1.0) + 8.0;
        let n_columns = n_columns as usize;
        for (n, answer) in nodes.iter().enumerate() {
            let (row, column) = (n / n_columns, n % n_columns);
            let left = column as f64 * (block + GAP[0]);
            let y = top + row as f64 * (height + GAP[1]);
            self.node_title(sheet, (n, answer.node), [left, y + 8.0], [block, title]);
            let y = y + title;
            let field = (block - NAME) / 3.0;
            let planes = [("0", answer.near), ("m", answer.mid), ("1", answer.far)];
            for (n, (plane, t)) in planes.into_iter().enumerate() {
                let x = left + NAME + field * n as f64;
                let name = joined(["t".into(), sub(plane)]);
                sheet.text(Role::Note, [x + 0.5 * field, y + 6.0], Anchor::Middle, name);
                for axis in 0..D {
                    let at = [x, y + 14.0 + FIELD * axis as f64];
                    self.field(sheet, at, [field, FIELD], short(t[axis]).into());
                }
            }
            for axis in 0..D {
                let at = [left, y + 14.0 + FIELD * (axis as f64 + 0.5)];
                sheet.text(Role::Words, at, Anchor::Start, on_axis(axis, AXIS_NAMES[axis]));
            }
            self.children(sheet, answer, [left, y + 14.0 + FIELD * D as f64 + 8.0], block);
        }
        let n_rows = nodes.len().div_ceil(n_columns) as f64;
        top + n_rows * (height + GAP[1])
    }

    /// Number of a node, the n-th.
    fn name(&self, n: usize) -> RichText {
        strong(self.texts.format("worksheet-node", &[("n", (n + 1).into())]))
    }

    /// Its level and codes.
    fn place(&self, node: NodeId) -> RichText {
        if node == NodeId::ROOT {
            return self.texts.get("worksheet-root").into();
        }
        let codes = self.tree.code(node).map(|c| c.to_string());
        let level = self.tree.level(node);
        joined([format!("{} {level}, ", self.texts.get("worksheet-level")).into(), tuple(codes)])
    }

    /// Height of the title of a block: of two lines if the longest needs them.
    fn title_height(&self, nodes: &[NodeAnswer<D>], block: f64) -> f64 {
        let widths = nodes.iter().enumerate().map(|(n, answer)| {
            let name = metrics::width(Role::Words, &self.name(n));
            name + 8.0 + metrics::width(Role::Note, &self.place(answer.node))
        });
        if widths.fold(0.0, f64::max) <= block { ONE_LINE } else { ONE_LINE + 17.0 }
    }

    /// Number of a node, and its level and codes beside it or below.
    fn node_title(
        &self,
        sheet: &mut Sheet,
        (n, node): (usize, NodeId),
        at: [f64; 2],
        [block, height]: [f64; 2],
    ) {
        let wide = sheet.text(Role::Words, at, Anchor::Start, self.name(n));
        let is_beside = height == ONE_LINE;
        let [x, y] = if is_beside {
            [at[0] + wide + 8.0, at[1]]
        } else {
            [at[0], at[1] + height - ONE_LINE]
        };
        if node == NodeId::ROOT || self.fields == Fields::Solved {
            sheet.text(Role::Note, [x, y], Anchor::Start, self.place(node));
        } else {
            sheet.line(Role::Blank, [[x, y + 6.0], [at[0] + block, y + 6.0]]);
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
        const BETWEEN: f64 = 30.0;
        const ROW: f64 = FIELD + 5.0;
        let title = self.texts.get("worksheet-leaves");
        sheet.text(Role::Words, [0.0, top + 8.0], Anchor::Start, strong(title));
        let top = top + 20.0;
        let levels = self.tree.domain().root_level();
        let digit = self.digit(levels);
        let group = f64::from(levels) * digit;
        let path = self.texts.get("worksheet-path");
        let path_width = metrics::width(Role::Note, &path.as_str().into()).max(group);
        let path_left = NUMBER;
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
                let place = levels - 1 - step;
                let x = f64::from(step) * digit;
                let is_known = place >= level;
                let path =
                    if is_known { branch(code, place + 1).0.to_string() } else { "·".into() };
                let at = [left + path_left + x, y];
                self.field(sheet, at, [digit, FIELD], path.into());
                for axis in 0..D {
                    let bit = match (is_known, code[axis] >> place & 1 == 1) {
                        (false, _) => "·",
                        (true, true) => "1",
                        (true, false) => "0",
                    };
                    let at = [left + axis_left(axis) + x, y];
                    self.field(sheet, at, [digit, FIELD], on_axis(axis, bit));
                }
            }
        }
        top + 18.0 + ROW * n_rows as f64
    }

    /// Width of the field of a bit: less than usual if all `levels` of a leaf would
    /// not fit beside each other, though no less than a digit needs.
    fn digit(&self, levels: u8) -> f64 {
        let room = self.width - NUMBER - GAP * D as f64;
        (room / (f64::from(levels) * (D + 1) as f64)).clamp(LEAST_DIGIT, DIGIT)
    }

    /// A field, with its text in it if the sheet is solved.
    fn field(&self, sheet: &mut Sheet, at: [f64; 2], size: [f64; 2], text: RichText) {
        sheet.rect(Role::Blank, at, size);
        if self.fields == Fields::Solved {
            let middle = [at[0] + 0.5 * size[0], at[1] + 0.5 * size[1]];
            debug_assert!(metrics::width(Role::Note, &text) < size[0], "{}", text.plain());
            sheet.text(Role::Note, middle, Anchor::Middle, text);
        }
    }
}

/// Width of a field that holds every parameter of some nodes.
fn widest<const D: usize>(nodes: &[NodeAnswer<D>]) -> f64 {
    let all = nodes.iter().flat_map(|node| [node.near, node.mid, node.far]).flatten();
    let widths = all.map(|t| metrics::width(Role::Note, &short(t).into()));
    widths.fold(0.0, f64::max) + 3.0
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
    shown_number(rounded)
}
