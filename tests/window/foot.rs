//! A column that goes on below the window ends above the lines that would be cut.

use crate::desk::Desk;
use crate::drawn::At;
use crate::lecture::each_text;
use crate::states::{Question, SCENES};
use eframe::egui::{Rect, Shape};
use egui_kittest::Harness;
use octoscope::view::Preset;
use octoscope_core::scenario::built_in;

/// What covers the lower ends of columns.
fn covers(desk: &Desk) -> Vec<Rect> {
    let cover = |shape: &Shape| {
        let Shape::Mesh(mesh) = shape else { return None };
        let [first, .., from, _, _, last] = &mesh.vertices[..] else { return None };
        let is_cover = first.color.a() == 0 && last.color.a() == 255 && mesh.vertices.len() == 6;
        is_cover.then(|| Rect::from_two_pos(from.pos, last.pos))
    };
    desk.output().shapes.iter().filter_map(|clipped| cover(&clipped.shape)).collect()
}

/// Texts that are seen in part.
fn cut(desk: &Desk) -> Vec<String> {
    /// How far lines reach into each other.
    const SLACK: f32 = 2.5;
    let covers = covers(desk);
    let mut all = Vec::new();
    for clipped in &desk.output().shapes {
        each_text(&clipped.shape, &mut |text| {
            let (seen, foot) = (text.visual_bounding_rect(), clipped.clip_rect.bottom());
            let over = covers.iter().find(|cover| {
                cover.x_range().contains(seen.center().x) && cover.bottom() + 1.0 > foot
            });
            let edge = over.map_or(foot, |cover| cover.top());
            let is_cut = seen.top() + SLACK < edge && edge < seen.bottom() - SLACK;
            // What is wholly outside at a side is not there at all.
            if is_cut && clipped.clip_rect.intersects(seen) {
                all.push(text.galley.job.text.clone());
            }
        });
    }
    all
}

#[test]
fn no_line_of_a_column_is_seen_in_part() {
    let (mut faults, mut n_covers) = (Vec::new(), 0);
    for (scene, id) in SCENES {
        let mut desk = Desk::of(Harness::builder(), [1280.0, 800.0]);
        for question in Question::all() {
            desk.open_scenario(&built_in(id).unwrap());
            question.ask(&mut desk);
            for preset in [Preset::Bits, Preset::Rail, Preset::Automaton, Preset::Debug] {
                desk.state_mut().view.preset = preset;
                desk.go_to(&At::Share(0.6));
                n_covers += covers(&desk).len();
                let place = format!("{scene} {} {preset:?}", question.name());
                faults.extend(cut(&desk).into_iter().map(|text| format!("{place}: {text}")));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(n_covers > 4, "{n_covers}");
}
