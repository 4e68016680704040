//! Print without colours: what differs in meaning differs in lightness or in form.

use octoscope_figure::{Colour, Dash, Palette, Role, Style, Theme, contrast};

/// Colours closer than this in lightness look the same in grey. Contrast is one of
/// lightness alone.
const APART: f64 = 1.15;

fn fill(role: Role) -> Colour {
    let paper = Palette::of(Theme::Print).background;
    Style::of(Theme::Print, role).fill.map_or(paper, |fill| fill.over(paper))
}

fn line(role: Role) -> (Colour, f64, Dash) {
    let paper = Palette::of(Theme::Print).background;
    let style = Style::of(Theme::Print, role);
    (style.stroke.map_or(paper, |stroke| stroke.over(paper)), style.width, style.dash)
}

/// Whether areas of both roles can be told apart in grey.
fn check_areas(a: Role, b: Role) {
    let ratio = contrast(fill(a), fill(b));
    assert!(ratio >= APART, "{a:?} {b:?}: {ratio:.2}");
}

/// Whether lines of both roles differ in grey, in width or in their pattern.
fn check_lines(a: Role, b: Role) {
    let [(colour_a, width_a, dash_a), (colour_b, width_b, dash_b)] = [a, b].map(line);
    let ratio = contrast(colour_a, colour_b);
    let wider = (width_a / width_b).max(width_b / width_a);
    assert!(
        ratio >= 1.3 || wider >= 1.3 || dash_a != dash_b,
        "{a:?} {b:?}: {ratio:.2}, {wider:.2} times as wide"
    );
}

#[test]
fn areas_are_told_apart_in_grey() {
    let [first, middle, last] = [0.0, 0.5, 1.0].map(|share| Role::Visited { share });
    for (a, b) in [
        (first, middle),
        (middle, last),
        (first, Role::Current),
        (last, Role::EmptyLeaf),
        (Role::FullLeaf, Role::EmptyLeaf),
        (Role::FullSection, Role::EmptySection),
        (Role::Taken, Role::EmptyLeaf),
        (Role::Spent, Role::Planned),
        (Role::StateNow, Role::StateNext),
        (Role::EntryPoint, Role::ExitPoint),
        (Role::RayOrigin, Role::RayTip),
    ] {
        check_areas(a, b);
    }
}

#[test]
fn lines_are_told_apart_in_grey() {
    for (a, b) in [
        (Role::Ray, Role::Root),
        (Role::Ray, Role::Ancestor { above: 1 }),
        (Role::Ray, Role::MirroredRay),
        (Role::Ray, Role::RayBeyond),
        (Role::Ray, Role::EmptyLeaf),
        (Role::Current, Role::Ancestor { above: 1 }),
        (Role::Current, Role::Visited { share: 0.5 }),
        (Role::Rejected, Role::Taken),
        (Role::Rejected, Role::Missed),
        (Role::Strayed, Role::Visited { share: 0.5 }),
        (Role::MidPlane(0), Role::ExitPlane(0)),
        (Role::OwnedSide, Role::OpenSide),
        (Role::Transition(1), Role::TransitionTaken(1)),
        (Role::Expected, Role::Current),
    ] {
        check_lines(a, b);
    }
}

#[test]
fn cells_can_be_counted_on_paper() {
    let paper = Palette::of(Theme::Print).background;
    let ratio = contrast(line(Role::EmptyLeaf).0, paper);
    assert!(ratio >= 2.0, "{ratio:.2}");
}
