//! Where what is said of the cell under the pointer stands: in a corner of the view in
//! which it covers neither that cell nor the ray.

use eframe::egui::{Align2, Pos2, Rect, Vec2, vec2};

/// What a card should leave to be seen.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// The cell that is spoken of.
    pub cell: Option<Rect>,
    /// The ends of the ray, its head included.
    pub ray: Option<[Pos2; 2]>,
    /// Numbers and names of the axes.
    pub axes: Vec<Rect>,
}

/// Room between a card and the edges of the view.
const INSET: Vec2 = vec2(10.0, 4.0);

/// Place of a card of this size in `view`: the corner in which it covers least of what
/// is to be seen. Those at the top come first, as most numbers of the axes stand below.
pub fn in_corner(view: Rect, size: Vec2, seen: &Seen) -> Rect {
    let room = view.shrink2(INSET);
    let corners = [Align2::LEFT_TOP, Align2::RIGHT_TOP, Align2::RIGHT_BOTTOM, Align2::LEFT_BOTTOM];
    let [first, others @ ..] = corners.map(|corner| corner.align_size_within_rect(size, room));
    let better = |best: Rect, other: Rect| {
        if n_covered(other, seen) < n_covered(best, seen) { other } else { best }
    };
    others.into_iter().fold(first, better)
}

fn n_covered(card: Rect, seen: &Seen) -> usize {
    let is_cell = seen.cell.is_some_and(|cell| cell.intersects(card));
    let is_ray = seen.ray.is_some_and(|ray| is_met(card, ray));
    let is_axis = seen.axes.iter().any(|text| text.intersects(card));
    usize::from(is_cell) + usize::from(is_ray) + usize::from(is_axis)
}

/// Whether the stretch between two points comes near a rectangle.
fn is_met(rect: Rect, [from, to]: [Pos2; 2]) -> bool {
    const NEAR: f32 = 12.0;
    let rect = rect.expand(NEAR);
    let [mut enter, mut exit] = [0.0_f32, 1.0];
    let step = to - from;
    for (near, far, at, step) in
        [(rect.left(), rect.right(), from.x, step.x), (rect.top(), rect.bottom(), from.y, step.y)]
    {
        if step == 0.0 {
            if at < near || far < at {
                return false;
            }
            continue;
        }
        let [a, b] = [near, far].map(|plane| (plane - at) / step);
        (enter, exit) = (enter.max(a.min(b)), exit.min(a.max(b)));
    }
    enter <= exit
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    const SIZE: Vec2 = vec2(200.0, 40.0);

    fn view() -> Rect {
        Rect::from_min_max(pos2(0.0, 0.0), pos2(600.0, 500.0))
    }

    fn check(seen: Seen, corner: Align2) {
        let card = in_corner(view(), SIZE, &seen);
        assert_eq!(card, corner.align_size_within_rect(SIZE, view().shrink2(INSET)), "{seen:?}");
    }

    fn ray(from: [f32; 2], to: [f32; 2]) -> Seen {
        Seen { ray: Some([from, to].map(|[x, y]| pos2(x, y))), ..Seen::default() }
    }

    #[test]
    fn a_card_leaves_the_ray_and_the_cell_to_be_seen() {
        check(Seen::default(), Align2::LEFT_TOP);
        check(ray([0.0, 480.0], [590.0, 10.0]), Align2::LEFT_TOP);
        check(ray([10.0, 10.0], [590.0, 480.0]), Align2::RIGHT_TOP);
        check(ray([0.0, 30.0], [600.0, 30.0]), Align2::RIGHT_BOTTOM);
        check(ray([300.0, 0.0], [300.0, 500.0]), Align2::LEFT_TOP);
        let cell = Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 100.0));
        check(Seen { cell: Some(cell), ..Seen::default() }, Align2::RIGHT_TOP);
        let falling = ray([10.0, 10.0], [590.0, 480.0]).ray;
        let right = Rect::from_min_max(pos2(500.0, 0.0), pos2(600.0, 100.0));
        let seen = Seen { cell: Some(right), ray: falling, axes: vec![] };
        check(seen, Align2::LEFT_BOTTOM);
    }

    #[test]
    fn a_card_leaves_the_numbers_of_the_axes_to_be_seen() {
        let at = |x: f32, y: f32| Rect::from_center_size(pos2(x, y), vec2(24.0, 12.0));
        let of_axes = |axes: &[Rect]| Seen { axes: axes.to_vec(), ..Seen::default() };
        check(of_axes(&[at(30.0, 20.0)]), Align2::RIGHT_TOP);
        check(of_axes(&[at(30.0, 20.0), at(570.0, 20.0)]), Align2::RIGHT_BOTTOM);
        check(of_axes(&[at(300.0, 250.0)]), Align2::LEFT_TOP);
    }

    #[test]
    fn where_everything_is_covered_a_card_stays_in_the_view() {
        let seen = Seen { cell: Some(view()), ..ray([0.0, 30.0], [600.0, 470.0]) };
        assert!(view().contains_rect(in_corner(view(), SIZE, &seen)));
    }
}
