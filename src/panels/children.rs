//! Every child of a node, tested one after the other.

use crate::look::Look;
use crate::widgets::{ROW, Setting, bits_of, caption, node_note, range, table};
use eframe::egui::Ui;
use octoscope_core::event::Event;
use octoscope_core::explain::approx;
use octoscope_core::geometry::Axes;
use octoscope_core::trace::Moment;
use octoscope_core::tree::{Child, NodeId, Tree};
use octoscope_figure::Anchor;
use octoscope_figure::views::{Entry, Table, Tone};

/// The node whose children are tested. `past` are the events so far.
pub fn note<const D: usize>(
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    past: &[Event<D>],
) -> String {
    node_note(look, tree, at_work(tree, moment, past).map(|(node, _)| node))
}

/// The height that it takes in a lecture, in points.
pub fn lecture_height<const D: usize>() -> f32 {
    18.0 + 18.0 * (1 << D) as f32
}

/// The children of the node at work in the order of their tests: hit or missed,
/// and between which parameters. `past` are the events so far.
pub fn ui<const D: usize>(
    ui: &mut Ui,
    look: &Look,
    tree: &Tree<D>,
    moment: &Moment<D>,
    past: &[Event<D>],
) {
    let Some((parent, tests)) = at_work(tree, moment, past) else {
        caption(ui, look, look.text("children-none"));
        return;
    };
    let mask = moment.clip.map_or(Axes::NONE, |clip| clip.mirror);
    let row = |(n, state): (usize, Child<D>)| {
        let child = state.mirrored(mask);
        let node = tree.child(tree.node(parent), child).id;
        let test = tests.iter().find(|test| test.node == node);
        let last = tests.last().is_some_and(|test| test.node == node);
        let visited = moment.stack.iter().any(|frame| frame.node == node);
        let interval = test.map(|test| test.interval);
        let tone = match (last, visited, interval) {
            (true, _, _) => Tone::Used,
            (false, true, _) => Tone::Line,
            (false, false, Some(Some(_))) => Tone::Plain,
            (false, false, Some(None) | None) => Tone::Quiet,
        };
        let told = match interval {
            Some(Some([enter, exit])) if enter == exit => Entry::new(approx(enter), tone),
            Some(Some(interval)) => Entry::new(range(interval), tone),
            Some(None) => Entry::words(look.text("children-missed"), tone),
            None => Entry::new("·", tone),
        };
        vec![
            Entry::new((n + 1).to_string(), tone),
            Entry::new(child.0.to_string(), tone),
            Entry::new(bits_of(child), tone),
            told,
        ]
    };
    let head = ["children-order", "children-child", "children-bits", "children-interval"];
    let children = Table {
        columns: vec![Anchor::Middle, Anchor::Middle, Anchor::Start, Anchor::Start],
        head: head.map(|key| look.text(key).into()).to_vec(),
        rows: Child::<D>::all().enumerate().map(row).collect(),
    };
    table(ui, look, &children, Setting { gap: 14.0, least: 16.0, row: ROW });
}

/// Test of a node.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Test {
    node: NodeId,
    /// Parameters between which the ray is in it; `None` if it misses it.
    interval: Option<[f64; 2]>,
}

/// The node whose children are told and their tests: as long as none of its own is
/// tested, a node is told as a child of its parent.
fn at_work<const D: usize>(
    tree: &Tree<D>,
    moment: &Moment<D>,
    past: &[Event<D>],
) -> Option<(NodeId, Vec<Test>)> {
    let nodes = moment.stack.iter().rev().map(|frame| frame.node);
    let inner = nodes.filter(|node| !tree.node(*node).is_leaf());
    let mut all = inner.map(|node| (node, tests_of(tree, node, past)));
    let first = all.next()?;
    if first.1.is_empty() { all.next().or(Some(first)) } else { Some(first) }
}

/// Tests of the children of `parent` since it was entered last.
fn tests_of<const D: usize>(tree: &Tree<D>, parent: NodeId, past: &[Event<D>]) -> Vec<Test> {
    let entered = |event: &Event<D>| matches!(event, Event::Visit { node, .. } if *node == parent);
    let start = past.iter().rposition(entered).unwrap_or(past.len());
    let tests = past[start..].iter().filter_map(|event| {
        if let &Event::Test { node, interval, .. } = event {
            Some(Test { node, interval })
        } else {
            None
        }
    });
    tests.filter(|test| tree.parent(test.node) == Some(parent)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    use octoscope_core::query::{Arithmetic, Query};
    use octoscope_core::scenario::{AnyScenario, built_in};
    use octoscope_core::trace::record;
    use octoscope_core::traverse::{Algorithm, Options};

    #[test]
    fn a_child_that_is_visited_is_told_beside_its_siblings_until_its_own_are_tested() {
        let Some(AnyScenario::Quadtree(scenario)) = built_in("quadtree-82") else { panic!() };
        let tree = scenario.tree().unwrap();
        let (algorithm, options) = (Algorithm::AllChildren, Options::default());
        let query = Query::Ray { algorithm, options, arithmetic: Arithmetic::Doubles };
        let trace = record(&tree, &scenario.ray, &query);
        let mut moment = Moment::default();
        let mut n_inner = 0;
        for (index, event) in trace.events.iter().enumerate() {
            moment.apply(&tree, event);
            let Event::Visit { node, state: Some(_), .. } = *event else { continue };
            let (parent, tests) = at_work(&tree, &moment, &trace.events[..=index]).unwrap();
            assert_eq!(Some(parent), tree.parent(node));
            assert_eq!(tests.last().map(|test| test.node), Some(node));
            n_inner += usize::from(!tree.node(node).is_leaf());
        }
        assert!(n_inner > 2);
    }
}
