//! The pictures of each algorithm in the middle of its work, in the plane and in space.

use crate::drawn::{At, asked, compare, plane};
use octoscope::view::Preset;
use octoscope_core::scenario::{AnyScenario, built_in};
use octoscope_core::traverse::Algorithm;

/// Compares the picture of an algorithm in the middle of its work in the plane.
fn compare_in_plane(algorithm: Algorithm, preset: Preset, at: &At) {
    compare(&format!("algorithm-{}-2d", algorithm.id()), |desk| {
        desk.open_scenario(&plane("quadtree-82", |scenario| scenario.query = asked(algorithm)));
        desk.state_mut().view.preset = preset;
        desk.go_to(at);
    });
}

/// The same in space.
fn compare_in_space(algorithm: Algorithm, preset: Preset, at: &At) {
    compare(&format!("algorithm-{}-3d", algorithm.id()), |desk| {
        let Some(AnyScenario::Octree(mut scenario)) = built_in("points-3d") else { panic!() };
        scenario.query = asked(algorithm);
        desk.open_scenario(&AnyScenario::Octree(scenario));
        desk.state_mut().view.preset = preset;
        desk.go_to(at);
    });
}

#[test]
fn one_rule_takes_the_automaton_on() {
    compare_in_plane(Algorithm::Parametric, Preset::Automaton, &At::Nth(5, "Step"));
}

#[test]
fn one_rule_takes_the_automaton_on_in_space() {
    compare_in_space(Algorithm::Parametric, Preset::Automaton, &At::Nth(9, "Step"));
}

#[test]
fn tables_tell_the_first_and_the_next_child() {
    compare_in_plane(Algorithm::ParametricTable, Preset::Automaton, &At::Nth(5, "Step"));
}

#[test]
fn tables_tell_the_first_and_the_next_child_in_space() {
    compare_in_space(Algorithm::ParametricTable, Preset::Automaton, &At::Nth(4, "First"));
}

#[test]
fn recursion_is_done_without() {
    compare_in_plane(Algorithm::Esvo, Preset::Rail, &At::Nth(8, "Resume"));
}

#[test]
fn recursion_is_done_without_in_space() {
    compare_in_space(Algorithm::Esvo, Preset::Rail, &At::Nth(3, "Resume"));
}

#[test]
fn every_child_is_tested() {
    compare_in_plane(Algorithm::AllChildren, Preset::Rail, &At::Nth(14, "Test"));
}

#[test]
fn every_child_is_tested_in_space() {
    compare_in_space(Algorithm::AllChildren, Preset::Rail, &At::Nth(14, "Test"));
}

#[test]
fn hero_flips_a_bit() {
    compare_in_plane(Algorithm::Hero, Preset::Rail, &At::Nth(3, "Flip"));
}

#[test]
fn hero_flips_a_bit_in_space() {
    compare_in_space(Algorithm::Hero, Preset::Rail, &At::Nth(2, "Flip"));
}

#[test]
fn gargantini_classifies_a_piece() {
    compare_in_plane(Algorithm::Gargantini, Preset::Rail, &At::Nth(5, "Classify"));
}

#[test]
fn gargantini_classifies_a_piece_in_space() {
    compare_in_space(Algorithm::Gargantini, Preset::Rail, &At::Nth(6, "Classify"));
}

#[test]
fn codes_tell_the_common_ancestor() {
    compare_in_plane(Algorithm::Codes, Preset::Bits, &At::Nth(8, "Difference"));
}

#[test]
fn codes_tell_the_common_ancestor_in_space() {
    compare_in_space(Algorithm::Codes, Preset::Bits, &At::Nth(4, "Difference"));
}

#[test]
fn glassner_begins_at_the_root_again() {
    compare_in_plane(Algorithm::Glassner, Preset::Rail, &At::Nth(16, "Follow"));
}

#[test]
fn glassner_begins_at_the_root_again_in_space() {
    compare_in_space(Algorithm::Glassner, Preset::Rail, &At::Nth(14, "Follow"));
}

#[test]
fn samet_mirrors_the_way_up() {
    compare_in_plane(Algorithm::Samet, Preset::Rail, &At::Nth(11, "Mirror"));
}

#[test]
fn samet_mirrors_the_way_up_in_space() {
    compare_in_space(Algorithm::Samet, Preset::Rail, &At::Nth(4, "Mirror"));
}

#[test]
fn samet_corner_climbs() {
    compare_in_plane(Algorithm::SametCorner, Preset::Rail, &At::Nth(13, "Parent"));
}

#[test]
fn samet_corner_climbs_in_space() {
    compare_in_space(Algorithm::SametCorner, Preset::Rail, &At::Nth(2, "Parent"));
}

#[test]
fn samet_net_follows_a_link() {
    compare_in_plane(Algorithm::SametNet, Preset::Rail, &At::Nth(8, "Rope"));
}

#[test]
fn samet_net_follows_a_link_in_space() {
    compare_in_space(Algorithm::SametNet, Preset::Rail, &At::Nth(4, "Rope"));
}

#[test]
fn bsp_splits_a_part() {
    compare_in_plane(Algorithm::Bsp, Preset::Rail, &At::Nth(9, "Split"));
}

#[test]
fn bsp_splits_a_part_in_space() {
    compare_in_space(Algorithm::Bsp, Preset::Rail, &At::Nth(12, "Split"));
}

#[test]
fn dda_crosses_a_plane() {
    compare_in_plane(Algorithm::Dda, Preset::Rail, &At::Nth(9, "Cross"));
}

#[test]
fn dda_crosses_a_plane_in_space() {
    compare_in_space(Algorithm::Dda, Preset::Rail, &At::Nth(9, "Cross"));
}

#[test]
fn dda_looks_a_cell_up() {
    compare_in_plane(Algorithm::DdaOctree, Preset::Rail, &At::Nth(12, "Cross"));
}

#[test]
fn dda_looks_a_cell_up_in_space() {
    compare_in_space(Algorithm::DdaOctree, Preset::Rail, &At::Nth(8, "Cross"));
}

#[test]
fn every_leaf_is_tested() {
    compare_in_plane(Algorithm::Exhaustive, Preset::Rail, &At::Nth(40, "Test"));
}

#[test]
fn every_leaf_is_tested_in_space() {
    compare_in_space(Algorithm::Exhaustive, Preset::Rail, &At::Nth(6, "Leaf"));
}
