//! Names and numbers in charts.

use octoscope_core::explain::{algorithm_name, approx};
use octoscope_core::measure::{Claim, Quantity, Results, Way};
use octoscope_core::text::Texts;
use octoscope_core::traverse::Kernel;

/// Name of an algorithm with its variants, or of the kernel for many rays.
pub fn way_name(way: Way, texts: &Texts) -> String {
    let method = match way {
        Way::Traced(method) => method,
        Way::Batch(Kernel::Plain) => return texts.get("lab-name-batch-plain"),
        Way::Batch(Kernel::Vector) => return texts.get("lab-name-batch"),
    };
    let name = algorithm_name(method.algorithm, texts.language());
    let id = method.to_string();
    id.split_once('@').map_or(name.clone(), |(_, variants)| format!("{name} @{variants}"))
}

/// Name of a scene, as the window has it; its identifier where there is none.
pub fn scene_name(scene: &str, texts: &Texts) -> String {
    let key = format!("scene-{scene}");
    if texts.has(&key) { texts.get(&key) } else { scene.to_owned() }
}

/// What a published statement is about: two algorithms, and where they were compared, a
/// space before it, if not everywhere.
pub(super) fn claim_names(claim: &Claim, texts: &Texts) -> [String; 3] {
    let [of, against] = [claim.of, claim.against].map(|one| way_name(one.into(), texts));
    let scene = match claim.scenes {
        [scene] => Some(scene_name(scene, texts)),
        _ => None,
    };
    let depth = claim.depth.map(|depth| texts.format("lab-depth-n", &[("depth", depth.into())]));
    let place = scene.into_iter().chain(depth).map(|place| format!(" ({place})"));
    [of, against, place.collect()]
}

/// A number in the unit in which a quantity is shown: times a ray in microseconds.
pub(super) fn in_unit(quantity: Quantity, x: f64) -> f64 {
    match quantity {
        Quantity::Time => x / 1000.0,
        Quantity::TimePerLeaf
        | Quantity::Steps
        | Quantity::NodeTouches
        | Quantity::Comparisons
        | Quantity::Lines
        | Quantity::CacheMisses
        | Quantity::BranchMisses
        | Quantity::Cells
        | Quantity::TreeLeaves
        | Quantity::RayLeaves => x,
    }
}

/// That times were measured once only, if times are shown; the end of a note.
pub(super) fn measured_once(results: &Results, cost: Quantity, texts: &Texts) -> String {
    let rows = || results.sites.iter().flat_map(|site| &site.rows);
    let is_time = matches!(cost, Quantity::Time | Quantity::TimePerLeaf);
    let is_once = rows().next().is_some() && rows().all(|row| row.times.len() == 1);
    if is_time && is_once { texts.get("lab-measured-once") } else { String::new() }
}

/// A number with three digits or so.
pub(super) fn short(x: f64) -> String {
    let digits = match x.abs() {
        0.0..10.0 => 2,
        10.0..100.0 => 1,
        _ => 0,
    };
    let rounded = if x.is_finite() { format!("{x:.digits$}").parse().unwrap_or(x) } else { x };
    approx(rounded)
}

/// A ratio with three digits, or so.
pub(super) fn ratio(x: Option<f64>) -> String {
    let digits = |x: f64| if x < 10.0 { 2 } else { usize::from(x < 100.0) };
    x.map_or_else(|| "–".to_owned(), |x| format!("{x:.*}", digits(x)))
}
