//! What the view tells of the cell under the pointer: its outline, its level
//! and codes, and what a click there asks for.

use super::card::{Seen, in_corner};
use super::gesture::{Click, Under};
use crate::look::Look;
use crate::widgets::{PageInWindow, node_note, rich_job};
use eframe::egui::text::LayoutJob;
use eframe::egui::{
    FontId, Galley, Label, Pos2, Rect, RichText, Stroke, StrokeKind, Ui, Vec2, WidgetInfo,
    accesskit::Role, pos2, vec2,
};
use octoscope_core::explain::RichText as Words;
use octoscope_core::locate::Direction;
use octoscope_core::tree::{NodeId, Tree};
use octoscope_figure::{Mark, Role as MarkRole, Shape};
use std::sync::Arc;

/// Marks of a hovered node, and of the side of it that a click would cross.
pub fn marks<const D: usize>(
    tree: &Tree<D>,
    hovered: Option<NodeId>,
    under: Option<&Under<D>>,
) -> Vec<Mark<D>> {
    let outline = |node| Mark::new(Shape::Box(tree.node_box(node)), MarkRole::Hover).of_node(node);
    let side = under.and_then(|under| match under.click {
        Some(Click::Neighbour(direction)) => Some((under.leaf, direction)),
        Some(Click::Point) | None => None,
    });
    let side = side.and_then(|(leaf, direction)| side_mark(tree, leaf, direction));
    hovered.map(outline).into_iter().chain(side).collect()
}

fn side_mark<const D: usize>(
    tree: &Tree<D>,
    leaf: NodeId,
    direction: Direction<D>,
) -> Option<Mark<D>> {
    let components = direction.components();
    let mut axes = (0..D).filter(|&axis| components[axis] != 0);
    // Directions along several axes cross an edge or a corner.
    let (Some(axis), None) = (axes.next(), axes.next()) else { return None };
    let mut bounds = tree.node_box(leaf);
    let at = if components[axis] > 0 { bounds.max[axis] } else { bounds.min[axis] };
    (bounds.min[axis], bounds.max[axis]) = (at, at);
    Some(Mark::new(Shape::Plane { axis, bounds }, MarkRole::HoverSide).of_node(leaf))
}

/// What is said of the node that is pointed at.
pub struct Told {
    /// The node.
    pub node: NodeId,
    /// What rules it out, where it is not visited.
    pub why: Option<Words>,
    /// What a card with it leaves to be seen.
    pub seen: Seen,
}

/// Width of the text in a card, in points.
const CARD: f32 = 300.0;

/// Writes level and codes of a node, and why it is not visited, into a corner of the view.
pub fn card<const D: usize>(ui: &mut Ui, look: &Look, view: Rect, tree: &Tree<D>, told: &Told) {
    const PADDING: Vec2 = vec2(6.0, 3.0);
    let note = node_note(look, tree, Some(told.node));
    let most = CARD.min(view.width() - 32.0);
    let font = FontId::proportional(look.type_size(13.0));
    let note_job = LayoutJob::simple(note.clone(), font, look.palette.quiet, most);
    let why_job = told.why.as_ref().map(|why| rich_job(why, look, 14.0, most));
    let lines = [Some((note_job, note)), why_job.zip(told.why.as_ref().map(Words::plain))];
    let lines = lines.into_iter().flatten();
    let lines = lines.map(|(job, plain)| (ui.painter().layout_job(job), plain));
    let lines: Vec<(Arc<Galley>, String)> = lines.collect();
    let size = lines.iter().fold(Vec2::ZERO, |size, (galley, _)| {
        vec2(size.x.max(galley.size().x), size.y + galley.size().y)
    });
    let ground = in_corner(view, size + 2.0 * PADDING, &told.seen);
    paint_ground(ui, look, ground);
    let mut corner = ground.min + PADDING;
    for (galley, plain) in lines {
        let place = Rect::from_min_size(corner, galley.size());
        corner.y += galley.size().y;
        let response = ui.put(place, Label::new(galley).selectable(false));
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, plain.as_str()));
    }
}

/// Paints what parts a card from the picture below it.
fn paint_ground(ui: &Ui, look: &Look, ground: Rect) {
    let border = Stroke::new(1.0, look.palette.rail);
    ui.painter().rect(ground, 4.0, look.palette.panel, border, StrokeKind::Inside);
}

/// Says beside the pointer what a click does, and rather covers none of the `numbers`.
pub fn hint<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    frame: PageInWindow,
    under: &Under<D>,
    numbers: &[Rect],
) {
    let Some(Click::Neighbour(direction)) = under.click else { return };
    let pointer = frame.on_screen(under.at);
    let room = frame.rect().intersect(ui.clip_rect()).shrink(8.0);
    let text = look.text("space-click-neighbour");
    label(ui, look, text, |size| beside(pointer, direction.components(), size, room, numbers));
}

/// Place of a hint of this size at the pointer, within `room`: on the inner side of the
/// cell where there is room, else on the other one. It does not cover the side in this
/// direction, upwards being positive, as that is nearer to the pointer than the hint. Across
/// the direction it goes where it covers the fewest of the `numbers`.
fn beside<const D: usize>(
    pointer: Pos2,
    direction: [i8; D],
    size: Vec2,
    room: Rect,
    numbers: &[Rect],
) -> Rect {
    // From the pointer to the right, and to the left; downwards, and upwards.
    let right = [pointer.x + 14.0, pointer.x - 14.0 - size.x];
    let down = [pointer.y + 18.0, pointer.y - 14.0 - size.y];
    let chosen = |[first, second]: [f32; 2], fits: &dyn Fn(f32) -> bool, turned: bool| {
        let [wanted, other] = if turned { [second, first] } else { [first, second] };
        if fits(wanted) || !fits(other) { wanted } else { other }
    };
    let fits_across = |x: f32| room.left() <= x && x + size.x <= room.right();
    let fits_along = |y: f32| room.top() <= y && y + size.y <= room.bottom();
    let x = chosen(right, &fits_across, direction[0] > 0);
    let y = chosen(down, &fits_along, direction[1] < 0);
    let aside = |own: f32, all: [f32; 2], fits: &dyn Fn(f32) -> bool, along: i8| {
        let others = all.into_iter().filter(|other| along == 0 && *other != own && fits(*other));
        [own].into_iter().chain(others).collect::<Vec<f32>>()
    };
    let ys = aside(y, down, &fits_along, direction[1]);
    let places = aside(x, right, &fits_across, direction[0])
        .into_iter()
        .flat_map(|x| ys.iter().map(move |&y| Rect::from_min_size(pos2(x, y), size)));
    let n_covered = |place: &Rect| numbers.iter().filter(|other| other.intersects(*place)).count();
    places.min_by_key(n_covered).unwrap_or(Rect::from_min_size(pos2(x, y), size))
}

/// A line of quiet text on its own ground, which `place` lays out by its size.
fn label(ui: &mut Ui, look: &Look, text: String, place: impl FnOnce(Vec2) -> Rect) {
    let font = FontId::proportional(13.0);
    let color = look.palette.quiet;
    let size = ui.painter().layout_no_wrap(text.clone(), font.clone(), color).size();
    let ground = place(size + vec2(12.0, 6.0));
    paint_ground(ui, look, ground);
    let text = RichText::new(text).font(font).color(color);
    ui.put(ground, Label::new(text).selectable(false));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hint_lies_on_the_side_of_the_pointer_that_the_click_does_not_cross() {
        let (size, room) =
            (vec2(60.0, 20.0), Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        let placed = |direction| beside(pos2(100.0, 100.0), direction, size, room, &[]);
        assert!(placed([1, 0]).right() < 92.0);
        assert!(placed([-1, 0]).left() > 108.0);
        assert!(placed([0, 1]).top() > 108.0);
        assert!(placed([0, -1]).bottom() < 92.0);
    }

    #[test]
    fn the_hint_covers_no_number_where_there_is_another_place() {
        let (size, room) =
            (vec2(60.0, 20.0), Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        let placed = |direction, numbers: &[Rect]| {
            beside(pos2(100.0, 100.0), direction, size, room, numbers)
        };
        for direction in [[1, 0], [-1, 0], [0, 1], [0, -1]] {
            let first = placed(direction, &[]);
            let number = Rect::from_center_size(first.center(), vec2(10.0, 10.0));
            assert!(!placed(direction, &[number]).intersects(number), "{direction:?}");
        }
    }

    #[test]
    fn at_the_edge_of_the_view_the_hint_does_not_slide_over_the_side() {
        let (size, room) =
            (vec2(60.0, 20.0), Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        for pointer in [pos2(180.0, 100.0), pos2(20.0, 100.0), pos2(100.0, 190.0)] {
            for direction in [[1, 0], [-1, 0], [0, 1], [0, -1]] {
                let placed = beside(pointer, direction, size, room, &[]);
                assert!(room.contains_rect(placed), "{pointer} {direction:?}");
                let near = Rect::from_center_size(pointer, vec2(16.0, 16.0));
                assert!(!near.intersects(placed), "{pointer} {direction:?}");
            }
        }
    }
}
