//! Where a column ends that goes on below the window: not within a line.

use crate::look::Look;
use eframe::egui::{Mesh, Rect, Shape, Ui, pos2};

/// Height of the mark below which a column goes on.
const MARK: f32 = 14.0;
/// What is at most this high is a line, and not cut.
const LINE: f32 = 40.0;
/// What is cut takes at most this from a column.
const MOST: f32 = 96.0;
/// How far lines reach into each other.
const SLACK: f32 = 2.0;

/// Lets a column end above the lines that its lower edge would cut, and marks that it goes
/// on there.
pub fn end_above_what_is_cut(ui: &Ui, look: &Look, column: Rect) {
    let painted = ui.ctx().graphics(|graphics| {
        let mut painted = Vec::new();
        let layer = graphics.get(ui.layer_id());
        for clipped in layer.into_iter().flat_map(|list| list.all_entries()) {
            for_each(&clipped.shape, &mut |shape| painted.push(shape.visual_bounding_rect()));
        }
        painted
    });
    let beside = |rect: &Rect| rect.is_finite() && column.x_range().contains(rect.center().x);
    let painted: Vec<Rect> = painted.into_iter().filter(beside).collect();
    let edge = edge_above(&painted, column);
    let ground = look.palette.panel;
    let mut cover = Mesh::default();
    let clear = ground.gamma_multiply(0.0);
    for (y, color) in [(edge - SLACK, clear), (edge, ground), (column.bottom(), ground)] {
        for x in [column.left(), column.right()] {
            cover.colored_vertex(pos2(x, y), color);
        }
    }
    for first in [0, 2] {
        cover.add_triangle(first, first + 1, first + 2);
        cover.add_triangle(first + 1, first + 2, first + 3);
    }
    ui.painter().add(cover);
    let tip = pos2(column.center().x, column.bottom() - 0.25 * MARK);
    let points = [[-6.0, -5.0], [0.0, 0.0], [6.0, -5.0]];
    let points = points.map(|[x, y]| pos2(tip.x + x, tip.y + y)).to_vec();
    ui.painter().add(Shape::line(points, (1.5, look.palette.quiet)));
}

/// Shows `see` all that a shape consists of.
fn for_each(shape: &Shape, see: &mut impl FnMut(&Shape)) {
    match shape {
        Shape::Vec(all) => all.iter().for_each(|shape| for_each(shape, see)),
        one => see(one),
    }
}

/// The lowest edge that cuts no line of what is painted, above the mark at the lower end of
/// a column.
fn edge_above(painted: &[Rect], column: Rect) -> f32 {
    let mut edge = column.bottom() - MARK;
    let is_cut = |rect: &&Rect, edge: f32| {
        rect.height() <= LINE && rect.top() + SLACK < edge && edge < rect.bottom() - SLACK
    };
    while let Some(line) = painted.iter().find(|rect| is_cut(rect, edge)) {
        if line.top() < column.bottom() - MOST {
            break;
        }
        edge = line.top();
    }
    edge
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(lines: &[[f32; 2]], edge: f32) {
        let column = Rect::from_x_y_ranges(0.0..=100.0, 0.0..=500.0);
        let lines =
            lines.iter().map(|&[top, bottom]| Rect::from_x_y_ranges(10.0..=90.0, top..=bottom));
        assert_eq!(edge_above(&lines.collect::<Vec<_>>(), column), edge);
    }

    #[test]
    fn a_column_ends_above_the_lines_that_would_be_cut() {
        check(&[], 486.0);
        check(&[[440.0, 460.0], [464.0, 484.0]], 486.0);
        check(&[[440.0, 460.0], [470.0, 490.0]], 470.0);
        // Beside it is one that would be cut then.
        check(&[[470.0, 490.0], [460.0, 480.0]], 460.0);
        // Lines reach a little into each other.
        check(&[[470.0, 490.0], [451.0, 471.0]], 470.0);
        // A picture is cut.
        check(&[[300.0, 600.0]], 486.0);
    }
}
