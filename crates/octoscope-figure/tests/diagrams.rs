//! Diagrams of trees, small and large.

use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::progress::Progress;
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::trace::{Moment, Trace, record};
use octoscope_core::traverse::Variants;
use octoscope_core::tree::{Domain, NodeId, Split, Tree, grow};
use octoscope_figure::{
    Diagram, DiagramLens, DiagramOf, Form, NodeKind, Page, Part, Role, tree_diagram,
};

const PAGE: Page = Page { width: 360.0, height: 290.0 };

/// Tree in which every node down to level 0 has children.
fn full<const D: usize>(depth: u8) -> Tree<D> {
    grow(Domain::unit(depth), (), &Progress::default(), |cell, ()| match cell.level {
        0 => Split::Empty,
        _ => Split::Inner(vec![(); 1 << D]),
    })
    .expect("nobody cancels")
}

struct Run<const D: usize> {
    tree: Tree<D>,
    ray: Ray<D>,
    query: Query<D>,
    trace: Trace<D>,
}

fn run<const D: usize>(depth: u8) -> Run<D> {
    let tree = full(depth);
    let direction = std::array::from_fn(|e| 1.5 - 0.25 * e as f64);
    let ray = Ray::new([-0.25; D], direction).expect("the direction is not zero");
    let query = Query::default();
    let trace = record(&tree, &ray, &query);
    Run { tree, ray, query, trace }
}

impl<const D: usize> Run<D> {
    fn diagram(&self, step: usize, unfolded: &[NodeId], page: Page) -> Diagram {
        let moment = Moment::after(&self.tree, &self.trace, step);
        let event = step.checked_sub(1).and_then(|index| self.trace.events.get(index));
        let Self { tree, ray, query, .. } = self;
        let of = DiagramOf { tree, ray, query, moment: &moment, event, strayed: &[] };
        tree_diagram(&of, unfolded, None, page, DiagramLens::default())
    }
}

fn is_last<const D: usize>(event: &Event<D>) -> bool {
    matches!(event, Event::Step { next: None, .. })
}

fn n_of(diagram: &Diagram, role: Role, part: Part) -> usize {
    let is_it = |role_of: Role, part_of: Part| role_of.class() == role.class() && part_of == part;
    diagram.figure.drawn.iter().filter(|drawn| is_it(drawn.role, drawn.part)).count()
}

#[test]
fn the_current_node_and_its_children_are_there_at_every_step() {
    let run = run::<3>(4);
    for step in 0..=run.trace.events.len() {
        let diagram = run.diagram(step, &[], PAGE);
        let moment = Moment::after(&run.tree, &run.trace, step);
        let at_work = moment.at_work(&run.tree).expect("the root has children");
        let shown = |id: NodeId| diagram.nodes.iter().any(|node| node.node == id);
        assert!(shown(at_work), "{step}");
        let children: Vec<_> =
            run.tree.children(run.tree.node(at_work)).filter(|child| shown(child.id)).collect();
        assert!(moment.current.is_none() || children.len() == 8, "{step}: {}", children.len());
        assert!(moment.current.is_none_or(shown));
    }
}

#[test]
fn every_leaf_is_in_exactly_one_node_of_a_page_with_room_for_all() {
    let run = run::<2>(5);
    let page = Page { width: 4000.0, height: 600.0 };
    for step in [0, 30, run.trace.events.len()] {
        let diagram = run.diagram(step, &[NodeId(2)], page);
        let leaves = diagram.nodes.iter().map(|node| match node.kind {
            NodeKind::Leaf => 1,
            NodeKind::Folded { n_leaves } => n_leaves,
            NodeKind::Unfolded => 0,
        });
        assert_eq!(leaves.sum::<usize>(), run.tree.n_leaves());
    }
}

#[test]
fn at_the_end_every_visited_leaf_has_its_number_where_there_is_room() {
    let run = run::<2>(4);
    let page = Page { width: 4000.0, height: 600.0 };
    let n_leaves = run.trace.leaves().count();
    let diagram = run.diagram(usize::MAX, &[], page);
    let numbers: Vec<String> = diagram
        .figure
        .drawn
        .iter()
        .filter(|drawn| drawn.role == Role::OrderNumber)
        .filter_map(|drawn| match &drawn.form {
            Form::Text { text, .. } => Some(text.plain()),
            Form::Polygon(_) | Form::Polyline(_) | Form::Circle { .. } | Form::Formula { .. } => {
                None
            }
        })
        .collect();
    assert_eq!(numbers.len(), n_leaves);
    for n in 1..=n_leaves {
        assert!(numbers.contains(&n.to_string()), "{n}");
    }
}

#[test]
fn children_that_are_ruled_out_have_dashed_branches() {
    let run = run::<2>(2);
    let last = run.trace.events.iter().rposition(is_last).expect("the root is left");
    let diagram = run.diagram(last + 1, &[], PAGE);
    assert_eq!(n_of(&diagram, Role::Rejected, Part::Edge), 1);
}

#[test]
fn a_point_has_its_path_and_its_node() {
    let tree = full::<2>(3);
    let ray = Ray::new([0.0; 2], [1.0; 2]).expect("the direction is not zero");
    let query =
        Query::Point { at: [0.3, 0.8], method: PointMethod::Codes, variants: Variants::NONE };
    let trace = record(&tree, &ray, &query);
    let run = Run { tree, ray, query, trace };
    let diagram = run.diagram(usize::MAX, &[], PAGE);
    assert_eq!(n_of(&diagram, Role::Found, Part::Whole), 1);
    assert_eq!(n_of(&diagram, Role::Path, Part::Edge), 3);
}

#[test]
fn what_is_drawn_of_a_million_leaves_is_what_is_drawn_of_a_thousand() {
    let small = run::<2>(5);
    let large = run::<2>(10);
    assert_eq!(small.tree.n_leaves(), 1 << 10);
    assert_eq!(large.tree.n_leaves(), 1 << 20);
    for share in [0.0, 0.3, 0.6, 1.0] {
        let drawn = |run: &Run<2>| {
            let step = (run.trace.events.len() as f64 * share).round() as usize;
            let diagram = run.diagram(step, &[], PAGE);
            let folded = diagram.nodes.iter().filter_map(|node| match node.kind {
                NodeKind::Folded { n_leaves } => Some(n_leaves),
                NodeKind::Leaf | NodeKind::Unfolded => None,
            });
            (diagram.nodes.len(), diagram.figure.drawn.len(), folded.max().unwrap_or(0))
        };
        let (nodes, shapes, _) = drawn(&large);
        let (few, _, _) = drawn(&small);
        assert!(nodes <= few + 5 * 4 && nodes <= 100, "{share}: {nodes} of {few}");
        assert!(shapes <= 8 * nodes + 30, "{share}: {shapes}");
        // A quarter of the tree is one triangle.
        assert!(share == 0.0 || drawn(&large).2 <= 1 << 18);
    }
    // The user may unfold nodes, each of which shows its children only.
    let unfolded: Vec<NodeId> = (1..=40).map(NodeId).collect();
    assert!(large.diagram(3, &unfolded, PAGE).nodes.len() <= 41 * 4 + 1 + 10 * 4);
}

#[test]
fn no_branch_crosses_what_is_written_below_a_folded_node() {
    let run = run::<3>(4);
    let page = Page { width: 900.0, height: 290.0 };
    let mut n_below = 0;
    for step in 0..=run.trace.events.len() {
        let diagram = run.diagram(step, &[], page);
        let folded = |node| matches!(node, NodeKind::Folded { .. });
        let mut below = Vec::new();
        for drawn in &diagram.figure.drawn {
            let Form::Text { at, text, .. } = &drawn.form else { continue };
            let node = diagram.nodes.iter().find(|node| Some(node.node) == drawn.node);
            if node.is_some_and(|node| folded(node.kind) && at[1] > node.at[1]) {
                // Digits are wider and higher than this.
                below.push((*at, [2.5 * text.plain().chars().count() as f64, 3.5]));
            }
        }
        n_below += below.len();
        for drawn in &diagram.figure.drawn {
            let Form::Polyline(line) = &drawn.form else { continue };
            if drawn.role == Role::Level {
                continue;
            }
            for ends in line.windows(2) {
                // Points close enough together that none steps over a text.
                let mut on_line = (0..=200).map(|n| {
                    let share = f64::from(n) / 200.0;
                    [0, 1].map(|e| ends[0][e] + share * (ends[1][e] - ends[0][e]))
                });
                let crosses = on_line.any(|point| {
                    below
                        .iter()
                        .any(|(at, reach)| (0..2).all(|e| (point[e] - at[e]).abs() < reach[e]))
                });
                assert!(!crosses, "step {step}: {line:?}");
            }
        }
    }
    assert!(n_below > 100, "{n_below}");
}

/// The branches of a figure, each with the node to which it leads.
fn branches(diagram: &Diagram) -> impl Iterator<Item = (NodeId, &[[f64; 2]])> {
    diagram.figure.drawn.iter().filter_map(|drawn| {
        let is_branch = matches!(drawn.role, Role::Path | Role::Branch | Role::Rejected);
        match &drawn.form {
            Form::Polyline(line) if is_branch && drawn.part != Part::Whole => {
                Some((drawn.node?, &line[..]))
            }
            _ => None,
        }
    })
}

#[test]
fn no_branch_passes_behind_another_node() {
    fn check<const D: usize>(run: &Run<D>, page: Page) {
        for step in (0..=run.trace.events.len()).step_by(3) {
            let diagram = run.diagram(step, &[], page);
            for (child, line) in branches(&diagram) {
                let parent = run.tree.parent(child);
                let others = diagram
                    .nodes
                    .iter()
                    .filter(|node| node.node != child && Some(node.node) != parent);
                for other in others {
                    let is_met = line.windows(2).any(|ends| {
                        (0..=60).any(|n| {
                            let share = f64::from(n) / 60.0;
                            (0..2).all(|e| {
                                let at = ends[0][e] + share * (ends[1][e] - ends[0][e]);
                                (at - other.at[e]).abs() <= other.half
                            })
                        })
                    });
                    assert!(!is_met, "step {step}: the branch to {child:?} meets {other:?}");
                }
            }
        }
    }
    check(&run::<2>(4), PAGE);
    check(&run::<3>(3), Page { width: 360.0, height: 290.0 });
}

#[test]
fn nodes_beside_each_other_do_not_touch() {
    let run = run::<2>(4);
    for width in [200.0, 360.0, 900.0] {
        for step in 0..=run.trace.events.len() {
            let diagram = run.diagram(step, &[], Page { width, height: 290.0 });
            for (n, node) in diagram.nodes.iter().enumerate() {
                for other in &diagram.nodes[..n] {
                    let apart = (node.at[0] - other.at[0]).abs() - node.half - other.half;
                    let is_level = (node.at[1] - other.at[1]).abs() < 1.0;
                    assert!(!is_level || apart > 1.5, "{width} {step}: {node:?} {other:?}");
                }
            }
        }
    }
}

#[test]
fn a_diagram_takes_the_width_that_its_page_has() {
    let run = run::<2>(3);
    let page = Page { width: 900.0, height: 290.0 };
    let diagram = run.diagram(usize::MAX, &[], page);
    let ends = diagram.nodes.iter().map(|node| node.at[0]);
    let [left, right] = [ends.clone().fold(f64::MAX, f64::min), ends.fold(0.0, f64::max)];
    assert!(right - left > 0.55 * page.width, "{left} {right}");
    for drawn in diagram.figure.drawn.iter().filter(|drawn| drawn.role == Role::Level) {
        if let Form::Polyline(line) = &drawn.form {
            assert_eq!(line[1][0], page.width);
        }
    }
}

#[test]
fn on_a_level_all_folded_nodes_have_their_number_of_leaves_or_none_has() {
    let run = run::<3>(4);
    let (mut n_all, page) = (0, Page { width: 500.0, height: 290.0 });
    for step in 0..=run.trace.events.len() {
        let diagram = run.diagram(step, &[], page);
        let has_count = |node: NodeId| {
            diagram.figure.drawn.iter().any(|drawn| {
                let is_below = |at: [f64; 2]| {
                    diagram.nodes.iter().any(|own| own.node == node && at[1] > own.at[1])
                };
                drawn.node == Some(node)
                    && drawn.role == Role::Branch
                    && matches!(drawn.form, Form::Text { at, .. } if is_below(at))
            })
        };
        let moment = Moment::after(&run.tree, &run.trace, step);
        let is_visited =
            |node: NodeId| moment.leaves.iter().any(|leaf| run.tree.holds(node, leaf.node));
        let folded = diagram
            .nodes
            .iter()
            .filter(|node| matches!(node.kind, NodeKind::Folded { .. }) && !is_visited(node.node));
        let folded: Vec<_> = folded.map(|node| (node.at[1], has_count(node.node))).collect();
        for (y, has_one) in &folded {
            n_all += usize::from(*has_one);
            let same = folded.iter().filter(|(other, _)| (other - y).abs() < 1.0);
            assert!(same.into_iter().all(|(_, other)| other == has_one), "step {step}: {folded:?}");
        }
    }
    assert!(n_all > 100, "{n_all}");
}

#[test]
fn leaves_that_are_ruled_out_are_dashed_as_their_branches_are() {
    let run = run::<2>(1);
    let last = run.trace.events.iter().rposition(is_last).expect("the root is left");
    let diagram = run.diagram(last + 1, &[], PAGE);
    let n_branches = n_of(&diagram, Role::Rejected, Part::Edge);
    assert!(n_branches > 0);
    // Two dashes from each corner of a square.
    assert_eq!(n_of(&diagram, Role::Rejected, Part::Whole), 8 * n_branches);
}

#[test]
fn no_dashed_outline_has_gaps_in_which_its_sides_are_lost() {
    let run = run::<2>(4);
    let mut n_sides = 0;
    for step in 0..=run.trace.events.len() {
        let diagram = run.diagram(step, &[], Page { width: 1200.0, height: 290.0 });
        for node in &diagram.nodes {
            let dashes: Vec<f64> = diagram
                .figure
                .drawn
                .iter()
                .filter(|drawn| drawn.node == Some(node.node) && drawn.part == Part::Whole)
                .filter_map(|drawn| match &drawn.form {
                    Form::Polyline(line) if drawn.role == Role::Rejected => {
                        Some((line[1][0] - line[0][0]).hypot(line[1][1] - line[0][1]))
                    }
                    _ => None,
                })
                .collect();
            let (half, total) = (node.half, dashes.iter().sum::<f64>());
            let around = match node.kind {
                NodeKind::Leaf => 8.0 * half,
                NodeKind::Folded { .. } => 2.0 * half * (1.0 + 5.0_f64.sqrt()),
                NodeKind::Unfolded => continue,
            };
            if !dashes.is_empty() {
                n_sides += 1;
                assert!(total > 0.6 * around, "step {step}: {total} of {around}");
                let each = around / dashes.len() as f64;
                assert!(each < 7.5, "step {step}: a dash for {each} of {node:?}");
            }
        }
    }
    assert!(n_sides > 20, "{n_sides}");
}
