//! What the tree is built from, and how.

use crate::document::Document;
use crate::look::Look;
use crate::widgets::{Listed, Present, drop_down, heading, slider_field};
use eframe::egui::{Grid, Ui};
use octoscope_core::scenario::{BUILT_IN, Source};
use octoscope_core::scene::Content;
use octoscope_core::tree::MAX_ROOT_LEVEL;

/// Shows the source and edits the recipe. Returns the identifier of a built-in
/// scene to open.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    document: &mut Document<D>,
) -> Option<&'static str> {
    let items = document.content.len();
    let counts = [("leaves", document.tree.n_leaves().into()), ("items", items.into())];
    let counts = look.texts.format(content_key(&document.content), &counts);
    heading(ui, look, &look.text("panel-scene"), &counts);
    let name = |id: &str| look.text(&format!("scene-{id}"));
    let present = match &document.opened().source {
        Source::BuiltIn { name, .. } => BUILT_IN.iter().map(|scene| scene.id).find(|id| id == name),
        Source::File { .. } | Source::Inline(_) => None,
    };
    let source = match &document.opened().source {
        Source::BuiltIn { name: id, .. } => name(id),
        Source::File { path, .. } => path.clone(),
        Source::Inline(_) => look.text("scene-inline"),
    };
    let lines = BUILT_IN.map(|scene| Listed::Entry(scene.id, name(scene.id)));
    let width = ui.available_width();
    let present = Present { entry: present, name: source };
    let (list, chosen) = drop_down(ui, look, "scene", width, present, &lines);
    list.on_hover_text(look.text("scene-source"));
    let recipe = &mut document.scenario.recipe;
    Grid::new("recipe").num_columns(2).spacing([8.0, 4.0]).show(ui, |ui| {
        let depth = look.text("scene-depth");
        ui.label(&depth);
        let most = if matches!(*document.content, Content::Image(_)) { 12 } else { MAX_ROOT_LEVEL };
        slider_field(ui, look, &depth, &mut recipe.depth, [0, most], 0.05, |slider| slider);
        ui.end_row();
        match &*document.content {
            Content::Points(_) => {
                let name = look.text("scene-capacity");
                ui.label(&name);
                let range = [1, 64];
                slider_field(ui, look, &name, &mut recipe.capacity, range, 0.2, |slider| {
                    slider.logarithmic(true)
                });
                ui.end_row();
            }
            Content::Image(_) => {
                let name = look.text("scene-threshold");
                ui.label(&name);
                let range = [0, 255];
                slider_field(ui, look, &name, &mut recipe.threshold, range, 0.5, |slider| slider);
                ui.end_row();
            }
            Content::Cells(_) | Content::Spheres(_) | Content::Boxes(_) | Content::Triangles(_) => {
            }
        }
    });
    chosen
}

fn content_key<const D: usize>(content: &Content<D>) -> &'static str {
    match content {
        Content::Points(_) => "scene-counts-points",
        Content::Cells(_) => "scene-counts-cells",
        Content::Image(_) => "scene-counts-image",
        Content::Spheres(_) => "scene-counts-spheres",
        Content::Boxes(_) => "scene-counts-boxes",
        Content::Triangles(_) => "scene-counts-triangles",
    }
}
