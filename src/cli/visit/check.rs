//! Whether the algorithms agree on a ray.

use super::line::{Met, met, push_line, push_token, visited};
use super::{Answer, Asked, Touches};
use octoscope_core::geometry::Ray;
use octoscope_core::query::Arithmetic;
use octoscope_core::traverse::{Algorithm, Method, Slivers, StopAt, first_difference_of_run};
use octoscope_core::tree::{NodeId, Tree};

/// Appends the line of a ray to `lines`; returns the first difference between `methods`
/// in words. The line is that of the oracle, if it is among them, else of the first.
pub fn push_compared_line<const D: usize>(
    lines: &mut String,
    tree: &Tree<D>,
    ray: &Ray<D>,
    methods: &[Method],
    asked: Asked,
) -> Option<String> {
    let oracle = methods.iter().find(|method| method.algorithm == Algorithm::Exhaustive);
    let &reference = oracle.or(methods.first())?;
    let expected = met(tree, ray, reference, asked);
    push_line(lines, tree, &expected);
    if methods.len() == 1 {
        return None;
    }
    let whole = Asked { stop_at: StopAt::End, touches: Touches::LeftOut, ..asked };
    let all_leaves = visited(&met(tree, ray, reference, whole));
    let slivers = match asked.arithmetic {
        Arithmetic::Exact => Slivers::Count,
        Arithmetic::Doubles => Slivers::Ignore,
    };
    let others = methods.iter().filter(|&&method| method != reference);
    others
        .filter_map(|&method| {
            let found = visited(&met(tree, ray, method, asked));
            let options = asked.options(method.variants);
            let at = first_difference_of_run(tree, ray, options, &all_leaves, &found, slivers)?;
            let leaf = |node: Option<NodeId>| named(tree, node);
            Some(format!(
                "{} finds {} as leaf {} where {} finds {}",
                method,
                leaf(at.found),
                at.index + 1,
                reference,
                leaf(at.expected),
            ))
        })
        .next()
}

/// The differences found so far.
#[derive(Debug, Default)]
pub struct Differences {
    first: Option<String>,
    n_rays: usize,
}

impl Differences {
    /// Adds what was found on the ray of this index, counted from 0.
    pub fn add<const D: usize>(&mut self, index: usize, ray: &Ray<D>, difference: Option<String>) {
        let Some(difference) = difference else {
            return;
        };
        self.n_rays += 1;
        self.first.get_or_insert_with(|| {
            let numbers = ray.origin().into_iter().chain(ray.direction());
            let numbers: Vec<String> = numbers.map(|x| format!("{x:?}")).collect();
            format!("ray {} ({}): {difference}", index + 1, numbers.join(" "))
        });
    }

    /// Done, if there are none.
    pub fn answer(self, n_rays: usize) -> Answer {
        match self.first {
            None => Answer::Done,
            Some(first) => Answer::No(format!(
                "the algorithms differ on {} of {n_rays} rays; the first is {first}",
                self.n_rays
            )),
        }
    }
}

fn named<const D: usize>(tree: &Tree<D>, node: Option<NodeId>) -> String {
    let Some(node) = node else {
        return "nothing".to_owned();
    };
    let mut name = String::new();
    let full = tree.node(node).is_full();
    push_token(&mut name, tree, if full { Met::Full(node) } else { Met::Empty(node) });
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_difference_is_named_and_all_are_counted() {
        let ray = Ray::new([0.5, 0.25], [1.0, 0.0]).unwrap();
        let mut differences = Differences::default();
        differences.add(0, &ray, None);
        differences.add(1, &ray, Some("codes finds nothing".to_owned()));
        differences.add(2, &ray, Some("another".to_owned()));
        let message = "the algorithms differ on 2 of 3 rays; the first is \
                       ray 2 (0.5 0.25 1.0 0.0): codes finds nothing";
        assert_eq!(differences.answer(3), Answer::No(message.to_owned()));
        assert_eq!(Differences::default().answer(3), Answer::Done);
    }
}
