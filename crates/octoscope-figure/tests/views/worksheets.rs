//! Worksheets: room, and what they tell.

use crate::expected::check_texts;
use crate::room::{check_room, written};
use crate::scene::{Scene, picture, texts};
use octoscope_core::query::Query;
use octoscope_core::scenario::{AnyScenario, Scenario, built_in};
use octoscope_core::text::Language;
use octoscope_figure::views::{Exercise, Fields, FigureView, worksheet};
use octoscope_figure::{Figure, Page, Role};

fn check_worksheets<const D: usize>(scenario: Scenario<D>) {
    let scene = Scene::new(scenario);
    for number in 0..20 {
        let ray = Exercise::ray_of(&scene.tree, number).unwrap();
        let exercise = Exercise::of(&scene.tree, &ray, Some(number)).unwrap();
        for (language, fields, width) in [
            (Language::English, Fields::Solved, 500.0),
            (Language::German, Fields::Empty, 500.0),
            (Language::English, Fields::Empty, 309.0),
            (Language::German, Fields::Solved, 309.0),
            (Language::German, Fields::Solved, 280.0),
            (Language::English, Fields::Solved, 420.0),
        ] {
            let picture = Figure { page: Page { width: 220.0, height: 220.0 }, drawn: Vec::new() };
            let layout = (fields, width);
            let sheet = worksheet(&scene.tree, &exercise, picture, &texts(language), layout);
            let wide = sheet.extent().expect("something is drawn");
            assert!(wide.min[0] > -1.0 && wide.max[0] < width + 1.0, "{number}: {wide:?}");
            check_room(&sheet.cropped(6.0), &format!("worksheet {number}, {width} wide"));
        }
    }
}

#[test]
fn worksheets_have_room_for_every_solution() {
    for id in ["figure-1", "figure-7", "quadtree-82"] {
        match built_in(id).unwrap() {
            AnyScenario::Quadtree(scenario) => check_worksheets(scenario),
            AnyScenario::Octree(scenario) => check_worksheets(scenario),
        }
    }
}

#[test]
fn an_empty_worksheet_tells_nothing_of_the_solution() {
    let Some(AnyScenario::Quadtree(scenario)) = built_in("figure-1") else { panic!() };
    let scene = Scene::new(scenario);
    let ray = Exercise::ray_of(&scene.tree, 7).unwrap();
    let exercise = Exercise::of(&scene.tree, &ray, Some(7)).unwrap();
    let sheet = |fields| {
        let picture = Figure { page: Page { width: 220.0, height: 220.0 }, drawn: Vec::new() };
        let english = texts(Language::English);
        worksheet(&scene.tree, &exercise, picture, &english, (fields, 500.0))
    };
    let boxes = |figure: &Figure| figure.drawn.iter().filter(|d| d.role == Role::Blank).count();
    let [empty, solved] = [Fields::Empty, Fields::Solved].map(sheet);
    let texts_of = |figure: &Figure| -> Vec<String> {
        written(figure).into_iter().map(|(text, _)| text).collect()
    };
    let n_filled = texts_of(&solved).len() - texts_of(&empty).len();
    assert!(n_filled > 30, "{n_filled}");
    // The lines for a name and for the places of nodes are on the empty one only.
    assert!(boxes(&empty) > boxes(&solved));
    assert!(texts_of(&empty).iter().all(|text| !text.contains("level")));
}

#[test]
fn worksheets_are_written_as_expected() {
    let Some(AnyScenario::Quadtree(mut scenario)) = built_in("figure-1") else { panic!() };
    let tree = Scene::new(scenario.clone()).tree;
    scenario.ray = Exercise::ray_of(&tree, 7).unwrap();
    scenario.query = Query::default();
    let scene = Scene::new(scenario);
    let exercise = Exercise::of(&scene.tree, &scene.scenario.ray, Some(7)).unwrap();
    for (name, fields, language) in [
        ("figure-1-worksheet", Fields::Empty, Language::German),
        ("figure-1-solution", Fields::Solved, Language::English),
    ] {
        let (layout, texts) = ((fields, FigureView::Worksheet.width::<2>()), texts(language));
        let picture = picture(&scene, 0, 230.0).cropped(0.0);
        check_texts(name, worksheet(&scene.tree, &exercise, picture, &texts, layout));
    }
}
