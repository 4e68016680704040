//! What the roles in pictures mean.

use super::sheet::Sheet;
use crate::space::diamond;
use crate::{Anchor, Figure, Form, Part, Role, Style, Theme, metrics};
use octoscope_core::text::Texts;

/// How a role is shown in a legend.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Swatch {
    Field,
    Crossed,
    Ramp,
    Arrow,
    Disc,
    Diamond,
    Planes,
}

/// Roles that are explained where they occur, by their class.
const ENTRIES: [(&str, Role, Swatch); 23] = [
    ("ray", Role::Ray, Swatch::Arrow),
    ("ray-tip", Role::RayTip, Swatch::Diamond),
    ("ray-away", Role::RayAway, Swatch::Disc),
    ("mirrored-ray", Role::MirroredRay, Swatch::Arrow),
    ("mirrored-wrongly", Role::MirroredWrongly, Swatch::Arrow),
    ("visited", Role::Visited { share: 0.5 }, Swatch::Ramp),
    ("strayed", Role::Strayed, Swatch::Crossed),
    ("expected", Role::Expected, Swatch::Field),
    ("current", Role::Current, Swatch::Field),
    ("ancestor", Role::Ancestor { above: 1 }, Swatch::Field),
    ("taken", Role::Taken, Swatch::Field),
    ("rejected", Role::Rejected, Swatch::Field),
    ("missed", Role::Missed, Swatch::Field),
    ("pending", Role::Pending, Swatch::Field),
    ("grid-cell", Role::GridCell, Swatch::Field),
    ("found", Role::Found, Swatch::Field),
    ("region", Role::Region, Swatch::Field),
    ("target", Role::Target, Swatch::Field),
    ("touch", Role::Touch, Swatch::Disc),
    ("query-point", Role::QueryPoint, Swatch::Disc),
    ("entry-point", Role::EntryPoint, Swatch::Disc),
    ("exit-point", Role::ExitPoint, Swatch::Disc),
    ("planes", Role::MidPlane(0), Swatch::Planes),
];

/// Swatch and meaning of every role that occurs in `figures`, in lines of at most
/// `width`.
pub(super) fn legend<'a>(
    figures: impl Iterator<Item = &'a Figure>,
    texts: &Texts,
    width: f64,
) -> Figure {
    const SWATCH: f64 = 22.0;
    const GAP: f64 = 16.0;
    const ROW: f64 = 17.0;
    let roles: Vec<Role> = figures.flat_map(|f| f.drawn.iter().map(|drawn| drawn.role)).collect();
    let occurs = |role: Role| {
        let same = |other: &Role| match (role, *other) {
            (Role::Ancestor { .. }, Role::Ancestor { .. })
            | (Role::MidPlane(_), Role::MidPlane(_) | Role::ExitPlane(_)) => true,
            (role, other) => role.class() == other.class(),
        };
        roles.iter().any(same)
    };
    let mut sheet = Sheet::default();
    let [mut x, mut y] = [0.0, 0.5 * ROW];
    for (key, role, swatch) in ENTRIES.into_iter().filter(|entry| occurs(entry.1)) {
        let text = texts.get(&format!("legend-{key}"));
        let wide = SWATCH + 6.0 + metrics::width(Role::Note, &text.as_str().into());
        if x > 0.0 && x + wide > width {
            [x, y] = [0.0, y + ROW];
        }
        draw(&mut sheet, role, swatch, [x, y], SWATCH);
        sheet.text(Role::Note, [x + SWATCH + 6.0, y], Anchor::Start, text);
        x += wide + GAP;
    }
    sheet.figure([width, y + 0.5 * ROW])
}

fn draw(sheet: &mut Sheet, role: Role, swatch: Swatch, [x, y]: [f64; 2], width: f64) {
    const HEIGHT: f64 = 11.0;
    match swatch {
        Swatch::Field => sheet.rect(role, [x + 2.0, y - 0.5 * HEIGHT], [width - 4.0, HEIGHT]),
        Swatch::Crossed => {
            let ([left, top], [right, bottom]) =
                ([x + 2.0, y - 0.5 * HEIGHT], [x + width - 2.0, y + 0.5 * HEIGHT]);
            sheet.rect(role, [left, top], [right - left, bottom - top]);
            sheet.line(role, [[left, top], [right, bottom]]);
            sheet.line(role, [[left, bottom], [right, top]]);
        }
        Swatch::Ramp => {
            let part = (width - 4.0) / 3.0;
            for n in 0..3 {
                let role = Role::Visited { share: f64::from(n) / 2.0 };
                let left = x + 2.0 + f64::from(n) * part;
                sheet.rect(role, [left, y - 0.5 * HEIGHT], [part, HEIGHT]);
            }
        }
        Swatch::Arrow => sheet.arrow(role, [[x, y], [x + width, y]], 10.0),
        Swatch::Disc => {
            let form = Form::Circle { centre: [x + 0.5 * width, y], radius: 4.5 };
            sheet.push(role, Part::Whole, form);
        }
        Swatch::Diamond => {
            let radius = Style::of(Theme::Light, role).radius;
            sheet.push(role, Part::Whole, diamond([x + 0.5 * width, y], radius));
        }
        Swatch::Planes => {
            for axis in 0..2 {
                let x = x + width * (1.0 + axis as f64) / 3.0;
                let line = [[x, y - 0.5 * HEIGHT], [x, y + 0.5 * HEIGHT]];
                sheet.line(Role::MidPlane(axis), line);
            }
        }
    }
}
