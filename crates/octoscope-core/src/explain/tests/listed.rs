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
fn of_the_branches_of_a_step_only_the_one_taken_is_lit() {
    let mut lit_once: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    fn run<const D: usize>(lit_once: &mut BTreeMap<String, BTreeSet<&'static str>>) {
        for_all_runs::<D>(|tree, ray, name, query| {
            let listing = listing(query, Language::English);
            let events = record(tree, ray, query).events;
            let reached = lit_once.entry(name.to_owned()).or_default();
            for step in 1..=events.len() {
                let lit = listing.lit(&events[..step]);
                let lines = listing.lines.iter().zip(&lit).filter(|(_, lit)| **lit);
                let lines: Vec<&Line> = lines.map(|(line, _)| line).collect();
                let is_cut = label(&events[step - 1]) == "cut";
                assert!(is_cut || !lines.is_empty(), "{name}: {:?}", events[step - 1]);
                let branches: BTreeSet<&str> =
                    lines.iter().map(|line| line.branch).filter(|b| !b.is_empty()).collect();
                assert!(branches.len() <= 1, "{name}: {branches:?}");
                reached.extend(lines.iter().map(|line| line.code));
            }
        });
    }
    run::<2>(&mut lit_once);
    run::<3>(&mut lit_once);
    for (name, query) in queries::<2>() {
        for line in listing(&query, Language::English).lines {
            // By a misprint, what a line is for may never come.
            let is_reached = line.label.is_empty() || lit_once[name].contains(line.code);
            let is_right = listing(&query.corrected(), Language::English).lines.contains(&line);
            assert!(is_reached || !is_right, "{name}: {}", line.code);
        }
    }
}

#[test]
fn the_listing_of_a_partition_tells_which_halves_are_taken() {
    let query = along(Algorithm::Bsp);
    let ray = Ray::new([-0.25, 0.3], [1.0, 0.1]).unwrap();
    let listing = listing(&query, Language::English);
    let events = record(&tree(3), &ray, &query).events;
    let mut told = BTreeMap::new();
    for step in 1..=events.len() {
        if let Event::Split { halves, .. } = events[step - 1] {
            let lit = listing.lit(&events[..step]);
            let lit = listing.lines.iter().zip(lit).filter(|(_, lit)| *lit);
            let codes: Vec<&str> = lit.map(|(line, _)| line.code).collect();
            told.insert(format!("{halves:?}"), codes);
        }
    }
    assert_eq!(told["Near"], ["tm ← its next mid plane", "tm ≤ 0 or tm ≥ hi: near half"]);
    assert_eq!(told["Both"], ["tm ← its next mid plane", "else: near half, push(far half)"]);
}

/// Names that the lines of a listing give a value to, in the forms of the variables.
fn assigned<const D: usize>(query: &Query<D>) -> BTreeSet<String> {
    let lines = listing(query, Language::English).lines;
    let left = lines.iter().filter_map(|line| line.code.split_once(" ← "));
    let names = left.flat_map(|(names, _)| names.split(", "));
    // The axes m of a step are told in its sentence.
    names.filter(|name| !["m", "tMax of m", "up"].contains(name)).map(str::to_owned).collect()
}

fn check_names<const D: usize>() {
    let mut shown: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for_all_runs::<D>(|tree, ray, name, query| {
        let trace = record(tree, ray, query);
        for step in 0..=trace.events.len() {
            let variables = variables(tree, query, &Moment::after(tree, &trace, step));
            for variable in variables {
                // One parameter an axis: t_x0 for t0.
                let name_of = variable.name.plain();
                let short = name_of.replace("_x", "").replace("_y", "").replace("_z", "");
                shown.entry(name).or_default().insert(short);
            }
        }
    });
    for (name, query) in queries::<D>() {
        let missing: Vec<String> = assigned(&query).difference(&shown[name]).cloned().collect();
        assert!(missing.is_empty(), "{name}: {missing:?} of {:?}", shown[name]);
    }
}

#[test]
fn every_name_that_a_listing_gives_a_value_is_shown_with_it() {
    check_names::<2>();
    check_names::<3>();
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

#[test]
fn every_other_form_of_a_rule_stands_in_its_listing() {
    fn check<const D: usize>() {
        for (name, query) in queries::<D>() {
            let n_variants = query.variants_at_work().iter().count();
            let [other, right] = [query, query.with_variants(Variants::NONE)]
                .map(|query| listing(&query, Language::English).lines);
            assert_eq!(other.len(), right.len(), "{name}");
            let n_changed = other.iter().zip(&right).filter(|(a, b)| a.code != b.code).count();
            assert_eq!(n_changed == 0, n_variants == 0, "{name}: {query:?}");
        }
    }
    check::<2>();
    check::<3>();
}
