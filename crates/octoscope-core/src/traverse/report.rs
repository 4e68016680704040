//! How traversals report leaves and end.

use super::algorithm::{Options, StopAt};
use crate::event::{End, Event, Observer, Outcome};
use crate::geometry::Parameter;
use crate::tree::Node;
use std::ops::ControlFlow;

/// What is wanted of the leaves on a ray.
#[derive(Clone, Copy, Debug)]
pub struct Report<P> {
    stop_at: StopAt,
    segment_end: Option<P>,
}

impl<P: Parameter> Report<P> {
    /// As the options say.
    pub fn of(options: Options) -> Self {
        Self { stop_at: options.stop_at, segment_end: options.end().map(P::given) }
    }

    /// Reports that the ray is in leaf `node` from `enter` to `exit`: as a touch
    /// if these are no interval. Breaks if nothing is wanted of later leaves.
    #[inline(always)]
    pub fn leaf<const D: usize>(
        &self,
        node: Node,
        enter: P,
        exit: P,
        observe: &mut impl Observer<D>,
    ) -> ControlFlow<Outcome> {
        if !enter.before(exit) {
            observe.observe(Event::Touch { node: node.id, at: exit.value() });
            return go_on(observe);
        }
        self.crossed(node, enter, exit, observe)
    }

    /// Reports that the ray is in leaf `node` from `enter` to `exit`, whatever
    /// these are. Breaks if nothing is wanted of later leaves.
    #[inline(always)]
    pub fn crossed<const D: usize>(
        &self,
        node: Node,
        enter: P,
        exit: P,
        observe: &mut impl Observer<D>,
    ) -> ControlFlow<Outcome> {
        let ends = self.segment_end.filter(|&end| !exit.before(end));
        let exit = ends.unwrap_or(exit).value();
        let full = node.is_full();
        observe.observe(Event::Leaf { node: node.id, enter: enter.value(), exit, full });
        if full && self.stop_at == StopAt::FirstFull {
            ControlFlow::Break(Outcome::at(End::FirstFull, node.id))
        } else if ends.is_some() {
            ControlFlow::Break(Outcome::without_node(End::SegmentEnd))
        } else {
            go_on(observe)
        }
    }
}

/// Breaks if whoever watches wants no more.
#[inline]
pub fn go_on<const D: usize>(observe: &impl Observer<D>) -> ControlFlow<Outcome> {
    if observe.wants_more() {
        ControlFlow::Continue(())
    } else {
        ControlFlow::Break(Outcome::without_node(End::Cut))
    }
}

/// Ends a traversal that was `walked` to its stop, or out of the root.
pub fn finish<const D: usize>(
    walked: ControlFlow<Outcome>,
    observe: &mut impl Observer<D>,
) -> Outcome {
    let outcome = match walked {
        ControlFlow::Break(outcome) => outcome,
        ControlFlow::Continue(()) => Outcome::without_node(End::LeftRoot),
    };
    observe.observe(Event::End(outcome.end));
    outcome
}

/// Ends the traversal of a ray that misses the root.
pub fn missed<const D: usize>(observe: &mut impl Observer<D>) -> Outcome {
    observe.observe(Event::End(End::Missed));
    Outcome::without_node(End::Missed)
}
