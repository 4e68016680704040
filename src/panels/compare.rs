//! All algorithms on the same ray, side by side.

use crate::comparison::Run;
use crate::look::Look;
use eframe::egui::{
    Align, FontFamily, FontId, Grid, Id, Label, Layout, Rect, Response, RichText, Sense, Ui,
    WidgetInfo, accesskit::Role, vec2,
};
use octoscope_core::explain::algorithm_name;
use octoscope_core::trace::Counter;
use octoscope_core::traverse::Algorithm;

/// Room between two columns.
const GAP: f32 = 10.0;
/// Room inside the button of a name, and a little more.
const BUTTON: f32 = 20.0;

/// Keys of the heads of the numbers' columns.
const HEADS: [&str; 5] =
    ["compare-leaves", "compare-steps", "compare-nodes", "compare-tests", "compare-quotients"];

/// Costs of every algorithm and whether it finds the right leaves, a row each; a click
/// on a head orders the rows, one on a name chooses the algorithm. Returns the chosen one.
pub fn ui(ui: &mut Ui, look: &Look, runs: &[Run], shown: Option<Algorithm>) -> Option<Algorithm> {
    if runs.is_empty() {
        ui.label(RichText::new(look.text("compare-none")).color(look.palette.quiet));
        return None;
    }
    let mut chosen = None;
    let mut order: Order = ui.data(|data| data.get_temp(Order::id())).unwrap_or_default();
    let n_numbers = n_fitting(ui, look, runs);
    let quiet =
        |text: String| RichText::new(text).size(look.type_size(12.0)).color(look.palette.quiet);
    let grid = Grid::new("compare").num_columns(7).striped(true).min_row_height(22.0);
    grid.spacing([GAP, 2.0]).min_col_width(16.0).show(ui, |ui| {
        if head(ui, look, "compare-algorithm", order.sign(None)) {
            order = Order::default();
        }
        for (column, key) in HEADS.iter().enumerate().take(n_numbers) {
            let clicked = ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                head(ui, look, key, order.sign(Some(column)))
            });
            if clicked.inner {
                order = order.by(column);
            }
        }
        ui.end_row();
        let ranges = ranges(runs);
        for run in order.of(runs) {
            if row(ui, look, run, shown == Some(run.algorithm), &ranges[..n_numbers]) {
                chosen = Some(run.algorithm);
            }
            ui.end_row();
        }
    });
    ui.data_mut(|data| data.insert_temp(Order::id(), order));
    if runs.len() < Algorithm::ALL.len() {
        ui.label(quiet(look.text("compare-too-many")));
    }
    chosen
}

/// Number of the columns of numbers for which there is room.
fn n_fitting(ui: &Ui, look: &Look, runs: &[Run]) -> usize {
    let width = |text: String, font: FontId| {
        ui.painter().layout_no_wrap(text, font, look.palette.ink).size().x
    };
    let widest = |widths: &mut dyn Iterator<Item = f32>| widths.fold(16.0, f32::max);
    let language = look.texts.language();
    let name = |run: &Run| {
        width(algorithm_name(run.algorithm, language), FontId::proportional(look.type_size(13.0)))
    };
    let names = widest(&mut runs.iter().map(name)) + BUTTON;
    let columns = HEADS.iter().enumerate().scan(names, |end, (n, key)| {
        let head = width(look.text(key), FontId::proportional(look.type_size(12.0)));
        // The sign of the verdict stands before a number.
        let sign = if n == 0 { "= " } else { "" };
        let number =
            |run: &Run| width(format!("{sign}{}", numbers(run)[n]), FontId::monospace(13.0));
        *end += GAP + widest(&mut runs.iter().map(number)).max(head);
        Some(*end)
    });
    let room = ui.available_width();
    columns.take_while(|&end| end <= room).count().max(1)
}

/// Head of a column with the sign of its order; true if it is clicked.
fn head(ui: &mut Ui, look: &Look, key: &str, sign: &str) -> bool {
    let name = look.text(key);
    let text =
        RichText::new(format!("{name}{sign}")).size(look.type_size(12.0)).color(look.palette.quiet);
    let label = ui.add(Label::new(text).selectable(false).sense(Sense::click()));
    let sort = look.texts.format("compare-sort", &[("column", name.into())]);
    label.widget_info(|| WidgetInfo::labeled(Role::Button, true, sort.as_str()));
    label.on_hover_text(look.text(&format!("{key}-why"))).clicked()
}

/// In which order the rows stand: that of the menu, or that of a column's numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Order(Option<(usize, Direction)>);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    SmallestFirst,
    LargestFirst,
}

impl Order {
    /// Where it is remembered.
    fn id() -> Id {
        Id::unique("order-of-comparison")
    }

    /// The order after a click on the head of a column.
    fn by(self, column: usize) -> Self {
        let direction = if self.0 == Some((column, Direction::SmallestFirst)) {
            Direction::LargestFirst
        } else {
            Direction::SmallestFirst
        };
        Self(Some((column, direction)))
    }

    /// What stands after the head of a column, or of the names.
    fn sign(self, column: Option<usize>) -> &'static str {
        match self.0 {
            Some((by, Direction::SmallestFirst)) if column == Some(by) => " ↑",
            Some((by, Direction::LargestFirst)) if column == Some(by) => " ↓",
            Some(_) | None => "",
        }
    }

    /// The runs in this order; equal ones in that of the menu.
    fn of(self, runs: &[Run]) -> Vec<&Run> {
        let mut rows: Vec<&Run> = runs.iter().collect();
        match self.0 {
            None => {}
            Some((column, Direction::SmallestFirst)) => rows.sort_by_key(|r| numbers(r)[column]),
            Some((column, Direction::LargestFirst)) => {
                rows.sort_by_key(|run| std::cmp::Reverse(numbers(run)[column]));
            }
        }
        rows
    }
}

/// Numbers of the columns.
fn numbers(run: &Run) -> [u64; HEADS.len()] {
    [
        run.counters.get(Counter::Leaves),
        run.n_steps as u64,
        run.counters.get(Counter::NodeTouches),
        run.counters.comparisons(),
        run.counters.get(Counter::Divisions),
    ]
}

/// The smallest and the largest number of every column.
fn ranges(runs: &[Run]) -> [[u64; 2]; HEADS.len()] {
    std::array::from_fn(|column| {
        let all = || runs.iter().map(|run| numbers(run)[column]);
        [all().min().unwrap_or(0), all().max().unwrap_or(0)]
    })
}

/// Row of one algorithm, with the first few of its numbers, which range so; true if its
/// name is clicked.
fn row(ui: &mut Ui, look: &Look, run: &Run, is_shown: bool, ranges: &[[u64; 2]]) -> bool {
    let name = algorithm_name(run.algorithm, look.texts.language());
    let text = RichText::new(&name).size(look.type_size(13.0));
    let response = ui.selectable_label(is_shown, text);
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_shown, &name));
    let clicked = response.on_hover_text(run.algorithm.id()).clicked();

    let numbers = numbers(run);
    let n_leaves = numbers[0];
    let key = match (run.agrees, run.n_expected as u64 == n_leaves) {
        (true, true) => "compare-agrees",
        (true, false) => "compare-slivers",
        (false, _) => "compare-differs",
    };
    let arguments = [("leaves", n_leaves.into()), ("expected", run.n_expected.into())];
    let verdict = look.texts.format(key, &arguments);
    for (column, (&number, range)) in numbers.iter().zip(ranges).enumerate() {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if column == 0 {
                let label = leaves(ui, look, run.agrees, n_leaves);
                label.widget_info(|| WidgetInfo::labeled(Role::Label, true, verdict.as_str()));
                label.on_hover_text(verdict.as_str());
            } else {
                cost(ui, look, number, *range);
            }
        });
    }
    clicked
}

/// The number of leaves, and whether they are the right ones.
fn leaves(ui: &mut Ui, look: &Look, agrees: bool, n_leaves: u64) -> Response {
    let (sign, color, family) = if agrees {
        ("=", look.palette.ink, FontFamily::Monospace)
    } else {
        ("≠", look.palette.rejected, look.mono_strong_family())
    };
    let text = RichText::new(format!("{sign} {n_leaves}")).family(family);
    ui.label(text.size(look.type_size(13.0)).color(color))
}

/// A cost with its share of the largest in its column as a bar below it; the least is
/// emphasised.
fn cost(ui: &mut Ui, look: &Look, number: u64, [least, most]: [u64; 2]) {
    const BAR: f32 = 3.0;
    let is_least = number == least && least < most;
    let family = if is_least { look.mono_strong_family() } else { FontFamily::Monospace };
    let text = RichText::new(number.to_string()).family(family).size(look.type_size(13.0));
    let cell = ui.max_rect();
    ui.label(text.color(look.palette.ink));
    let share = number as f32 / most.max(1) as f32;
    let corner = cell.right_bottom() - vec2(share * cell.width(), BAR);
    let bar = Rect::from_min_max(corner, cell.right_bottom());
    ui.painter().rect_filled(bar, 1.0, look.palette.accent.gamma_multiply(0.55));
}
