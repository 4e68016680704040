//! The marks of the run.

use crate::document::Document;
use octoscope_core::trace::Moment;
use octoscope_figure::{Mark, Role, Show, cross_out, marks};

/// What the run shows at a moment. While a long run along a ray that was moved is
/// still being traced, that ray is where it is held; all else belongs to the traced one.
pub fn run_marks<const D: usize>(
    document: &Document<D>,
    moment: &Moment<D>,
    show: &Show,
) -> Vec<Mark<D>> {
    let of = document.shown(moment);
    let mut shown = marks(of.tree, of.ray, of.query, moment, of.event, show);
    cross_out(&mut shown, of.strayed);
    if document.needs_tracing() {
        let is_held = |mark: &Mark<D>| is_of_ray(mark.role);
        let (ray, query) = (&document.scenario.ray, &document.scenario.query);
        let untraced = marks(of.tree, ray, query, &document.moment(0), None, show);
        shown.retain(|mark| !is_held(mark));
        shown.extend(untraced.into_iter().filter(is_held));
    }
    shown
}

fn is_of_ray(role: Role) -> bool {
    matches!(role, Role::Ray | Role::RayBeyond | Role::RayOrigin | Role::RayTip)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::AnyDocument;
    use crate::open::open_built_in;
    use octoscope_core::progress::Progress;

    #[test]
    fn only_the_ray_itself_moves_before_it_is_traced() {
        let any = open_built_in("quadtree-82", &Progress::default()).unwrap();
        let AnyDocument::Plane(mut document) = any else { panic!() };
        let (moment, show) = (document.moment(document.trace.events.len()), Show::at_first::<2>());
        let parts = |document: &Document<2>| -> [Vec<Mark<2>>; 2] {
            let marks = run_marks(document, &moment, &show);
            let (ray, others) = marks.into_iter().partition(|mark| mark.role == Role::Ray);
            let is_end = |mark: &Mark<2>| matches!(mark.role, Role::RayOrigin | Role::RayTip);
            let (_, others) = Vec::into_iter(others).partition::<Vec<_>, _>(is_end);
            [ray, others]
        };
        let [ray, others] = parts(&document);
        document.reverse_ray();
        let [moved, same] = parts(&document);
        assert_eq!((moved.len(), &same), (1, &others));
        assert_ne!(moved, ray);
    }
}
