//! The listings, and the order of events in them.

use super::*;

#[test]
fn every_event_has_a_line_and_every_line_an_event() {
    let mut reached: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    fn run<const D: usize>(reached: &mut BTreeMap<String, BTreeSet<&'static str>>) {
        for_all_runs::<D>(|tree, ray, name, query| {
            let labels = record(tree, ray, query).events.iter().map(label).collect::<Vec<_>>();
            reached.entry(name.to_owned()).or_default().extend(labels);
        });
    }
    run::<2>(&mut reached);
    run::<3>(&mut reached);
    for (name, query) in queries::<2>() {
        let lines = listing(&query, Language::English).lines;
        let labels: BTreeSet<&str> =
            lines.iter().map(|line| line.label).filter(|label| !label.is_empty()).collect();
        assert_eq!(labels, reached[name], "{name}");
    }
}

#[test]
fn listings_fit_their_panel_and_are_commented_in_both_languages() {
    for (name, query) in queries::<2>() {
        let [english, german] = Language::ALL.map(|language| listing(&query, language).lines);
        for (line, translated) in english.iter().zip(&german) {
            let width = line.code.chars().count() + 2 * usize::from(line.indent);
            assert!(width <= 44, "{name}: {}", line.code);
            assert_eq!(line.comment.is_empty(), translated.comment.is_empty(), "{}", line.code);
        }
    }
}

#[test]
fn an_exit_point_is_pushed_then_encoded_then_compared_with_the_border() {
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.0]).unwrap();
    let trace = record(&tree(3), &ray, &with(Algorithm::Glassner, Variant::Push));
    let labels: Vec<_> = trace.events.iter().map(label).collect();
    let at: Vec<usize> = (0..labels.len()).filter(|&n| labels[n] == "push").collect();
    let (last, others) = at.split_last().unwrap();
    assert!(others.iter().all(|&n| labels[n + 1..].starts_with(&["encode", "border", "begin"])));
    assert_eq!(labels[last + 1..], ["border", "end"]);
}

#[test]
fn the_listing_of_the_octree_grid_follows_its_events() {
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.1]).unwrap();
    let query = along(Algorithm::DdaOctree);
    let trace = record(&tree(3), &ray, &query);
    let lines = listing(&query, Language::English).lines;
    // Lines of the loop and behind it, in order, each label once.
    let mut order: Vec<&str> = lines.iter().map(|line| line.label).collect();
    order.retain(|label| !label.is_empty());
    order.dedup();
    assert_eq!(
        order,
        [
            "clip",
            "missed",
            "grid",
            "begin",
            "follow",
            "leaf",
            "touch",
            "stop",
            "segment-end",
            "cross",
            "end"
        ]
    );
    let mut labels: Vec<_> = trace.events.iter().map(label).collect();
    labels.dedup();
    assert_eq!(labels[..5], ["clip", "grid", "begin", "follow", "leaf"]);
    assert_eq!(labels[labels.len() - 2..], ["cross", "end"]);
}

#[test]
fn what_is_reconstructed_is_listed_as_that() {
    for algorithm in Algorithm::ALL {
        let lines = listing(&along(algorithm), Language::English).lines;
        let says_so = lines.iter().any(|line| line.code.contains("a reconstruction"));
        let is_one = matches!(algorithm, Algorithm::SametCorner | Algorithm::SametNet);
        assert_eq!(says_so, is_one, "{algorithm:?}");
    }
}
