//! Where doubles would have decided otherwise, they do.

use crate::rays::{Class, random_ray};
use crate::trees::{domain, random_tree};
use octoscope_core::event::Event;
use octoscope_core::geometry::Ray;
use octoscope_core::query::{Arithmetic, Query};
use octoscope_core::random::Random;
use octoscope_core::trace::{Moment, Trace, double_would_differ, record, rounded_steps};
use octoscope_core::traverse::{Algorithm, Options, Variant, Variants, doubles_suffice};
use octoscope_core::tree::Tree;

/// Algorithms all of whose decisions are looked at.
const TOP_DOWN: [Algorithm; 6] = [
    Algorithm::Parametric,
    Algorithm::ParametricTable,
    Algorithm::AllChildren,
    Algorithm::Hero,
    Algorithm::Gargantini,
    Algorithm::Bsp,
];

fn for_random_rays<const D: usize>(mut check: impl FnMut(&Tree<D>, &Ray<D>, Class)) {
    let mut random = Random::new(6);
    for n in 0..40 {
        let tree = random_tree(domain::<D>(1 + (n % 8) as u8, n / 8), 20, &mut random);
        for class in Class::ALL {
            for _ in 0..8 {
                let ray = random_ray(&tree, class, &mut random);
                if doubles_suffice(tree.domain(), &ray) {
                    check(&tree, &ray, class);
                }
            }
        }
    }
}

fn queries<const D: usize>(algorithm: Algorithm, arithmetic: Arithmetic) -> Vec<Query<D>> {
    let mut variants = vec![Variants::NONE];
    if Variant::OneByOne.belongs_to(algorithm) {
        variants.push(Variants::NONE.with(Variant::OneByOne));
    }
    let options = |variants| Options { variants, ..Options::default() };
    let query = |variants| Query::Ray { algorithm, options: options(variants), arithmetic };
    variants.into_iter().map(query).collect()
}

fn doubles_never_differ_from_themselves<const D: usize>() {
    for_random_rays::<D>(|tree, ray, class| {
        for algorithm in Algorithm::ALL {
            for query in queries(algorithm, Arithmetic::Doubles) {
                let trace = record(tree, ray, &query);
                let mut before = Moment::default();
                for event in &trace.events {
                    let found = double_would_differ(tree, ray, &query, event, &before);
                    assert_eq!(found, None, "{query:?} {class:?} {ray:?} {event:?}");
                    before.apply(tree, event);
                }
            }
        }
    });
}

#[test]
fn a_run_in_doubles_never_differs_from_doubles() {
    doubles_never_differ_from_themselves::<2>();
    doubles_never_differ_from_themselves::<3>();
}

/// What was decided in an event, without the numbers.
fn decision<const D: usize>(event: &Event<D>) -> String {
    match *event {
        Event::Clip { hit, .. } => format!("{hit}"),
        Event::Test { node, interval, touch, .. } => {
            format!("{node:?} {} {touch}", interval.is_some())
        }
        Event::Visit { node, state, .. } => format!("{node:?} {state:?}"),
        Event::Skip { behind, .. } => format!("{behind}"),
        Event::Halve { .. } => String::new(),
        Event::First { compared, state, .. } => format!("{compared:?} {state:?}"),
        Event::Step { axes, next, .. } => format!("{axes:?} {next:?}"),
        Event::Enter { node, .. } => format!("{node:?}"),
        Event::Classify { child, .. } => format!("{child:?}"),
        Event::Flip { axes, .. } => format!("{axes:?}"),
        Event::Split { halves, taken, .. } => format!("{halves:?} {taken:?}"),
        Event::Pop { part, .. } => format!("{part:?}"),
        Event::Leaf { node, .. } => format!("leaf {node:?}"),
        Event::Touch { node, .. } => format!("touch {node:?}"),
        ref other => format!("{other:?}"),
    }
}

/// The first step in which an exact run and one in doubles decide differently is
/// the first one that is told. Returns how many runs part.
fn runs_part_where_it_says<const D: usize>() -> usize {
    let mut n_parted = 0;
    for_random_rays::<D>(|tree, ray, class| {
        for algorithm in TOP_DOWN {
            let exact = queries(algorithm, Arithmetic::Exact);
            for (exact, doubles) in exact.iter().zip(queries(algorithm, Arithmetic::Doubles)) {
                let trace = record(tree, ray, exact);
                let rounded = record(tree, ray, &doubles);
                let pairs = trace.events.iter().zip(&rounded.events);
                let together = pairs.take_while(|(a, b)| decision(a) == decision(b)).count();
                let parted = (together < trace.events.len()).then_some(together + 1);
                let told = rounded_steps(tree, ray, &trace).first().map(|(step, _)| *step);
                assert_eq!(told, parted, "{exact:?} {class:?} {ray:?}");
                n_parted += usize::from(parted.is_some());
            }
        }
    });
    n_parted
}

#[test]
fn an_exact_run_and_one_in_doubles_part_where_it_is_told() {
    assert!(runs_part_where_it_says::<2>() > 500);
    assert!(runs_part_where_it_says::<3>() > 500);
}

#[test]
fn leaves_that_doubles_lack_or_add_are_told_of() {
    let mut n_other = 0;
    for_random_rays::<3>(|tree, ray, class| {
        for algorithm in Algorithm::ALL {
            let [exact, doubles] = [Arithmetic::Exact, Arithmetic::Doubles].map(|arithmetic| {
                let options = Options::default();
                record(tree, ray, &Query::Ray { algorithm, options, arithmetic })
            });
            let ids = |trace: &Trace<3>| trace.leaves().map(|(id, _)| id).collect::<Vec<_>>();
            if ids(&exact) != ids(&doubles) {
                n_other += 1;
                let told = rounded_steps(tree, ray, &exact);
                assert!(!told.is_empty(), "{algorithm:?} {class:?} {ray:?}");
            }
        }
    });
    assert!(n_other > 500, "{n_other}");
}
