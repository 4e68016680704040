//! Where the numbers of the visited leaves stand: each at its leaf, beside the
//! part of the ray that lies in it, and none on another or on a handle. Where
//! there is no room a number is left out: round ones stay, so that the sequence
//! can still be read, and tens and the last one are rather pulled aside, with a
//! line to their leaf.

/// Number that looks for a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number {
    /// Its place in the order, from 1.
    pub order: usize,
    /// The part of the ray in its leaf, on the page.
    pub chord: [[f64; 2]; 2],
    /// Radius of its disc, the line around it included.
    pub radius: f64,
    /// Least and largest corner of its leaf on the page, where the leaf is an area
    /// of it: in the plane.
    pub leaf: Option<[[f64; 2]; 2]>,
}

/// Where a number stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stand {
    /// Middle of its disc.
    pub at: [f64; 2],
    /// Line from the leaf to the disc, if it was pulled aside.
    pub leader: Option<[[f64; 2]; 2]>,
}

/// Middle and half extents of what numbers may not cover.
pub(crate) type Taken = [[f64; 2]; 2];

/// Room between a disc and the ray.
pub(crate) const GAP: f64 = 4.0;
/// Room between two discs.
const BETWEEN: f64 = 1.0;

/// Where `numbers`, in their order, stand on a page of this size, one entry
/// each. The last of them has a place unless handles leave none. O(n²) at
/// worst, though no more discs are compared than the page has room for.
pub(crate) fn stands(numbers: &[Number], taken: &[Taken], page: [f64; 2]) -> Vec<Option<Stand>> {
    let mut crowd = Crowd { taken, page, placed: Vec::new() };
    let mut stands = vec![None; numbers.len()];

    // Round numbers choose first: they are the ones by which one counts.
    let mut by_rank: Vec<usize> = (0..numbers.len()).collect();
    by_rank.sort_by_key(|&index| rank(numbers[index].order));
    for index in by_rank {
        let number = &numbers[index];
        // Lines are for the few that one looks for; more would be a thicket.
        let is_sought = rank(number.order) == 0 || index + 1 == numbers.len();
        let aside = aside(number).filter(|_| is_sought);
        let place = beside(number).chain(aside).find(|stand| crowd.has_room(number, stand));
        if let Some(stand) = place {
            crowd.placed.push((number.radius, stand));
            stands[index] = place;
        }
    }

    // The last one tells where the algorithm is; it takes the room of others,
    // of those that are missed least.
    if let Some((last, number)) = numbers.iter().enumerate().next_back()
        && stands[last].is_none()
    {
        let covered = |stand: Stand| {
            let stands = &stands;
            (0..last).filter(move |&other| {
                let there = numbers[other].radius;
                stands[other].is_some_and(|other| collide((number.radius, stand), (there, other)))
            })
        };
        let loss = |stand: &Stand| -> usize {
            covered(*stand).map(|other| 1 << (2 * (3 - rank(numbers[other].order)))).sum()
        };
        let free = beside(number).filter(|stand| crowd.is_free(number, stand));
        if let Some(stand) = free.min_by_key(loss) {
            let covered: Vec<usize> = covered(stand).collect();
            covered.into_iter().for_each(|other| stands[other] = None);
            stands[last] = Some(stand);
        }
    }
    stands
}

/// The smaller, the earlier a number chooses its place.
fn rank(order: usize) -> usize {
    let steps = [10, 5, 2].iter().position(|step| order.is_multiple_of(*step));
    if order == 1 { 0 } else { steps.unwrap_or(3) }
}

/// Places that touch the chord, the best first: those in the leaf, then those of
/// which half is; at its middle, to the upper side, then the lower; then towards
/// its ends.
fn beside(number: &Number) -> impl Iterator<Item = Stand> + use<> {
    let Number { chord, radius, leaf, .. } = *number;
    let across = upwards(chord);
    let away = radius + GAP;
    let mut places: Vec<[f64; 2]> = [0.5, 0.25, 0.75, 0.0, 1.0]
        .into_iter()
        .flat_map(|share| [away, -away].map(|away| moved(between(chord, share), across, away)))
        .collect();
    if let Some([min, max]) = leaf {
        let room = |at: &[f64; 2]| {
            let sides = (0..2).map(|e| (at[e] - min[e]).min(max[e] - at[e]));
            sides.fold(f64::INFINITY, f64::min)
        };
        places.sort_by_key(|at| match room(at) {
            room if room >= radius => 0,
            room if room >= 0.0 => 1,
            _ => 2,
        });
    }
    places.into_iter().map(|at| Stand { at, leader: None })
}

/// Places a little farther away, with a line from the middle of the chord.
fn aside(number: &Number) -> impl Iterator<Item = Stand> + use<> {
    let Number { chord, radius, .. } = *number;
    let across = upwards(chord);
    let along = [-across[1], across[0]];
    let foot = between(chord, 0.5);
    // Not farther than a glance follows the line.
    let rows = [1.0, -1.0].map(|side| side * (3.0 * radius + GAP + 3.0));
    rows.into_iter().flat_map(move |away| {
        [0.0, -0.6, 0.6].map(|shift| {
            let at = moved(moved(foot, across, away), along, shift * radius);
            let length = distance(foot, at);
            let rim = between([foot, at], 1.0 - radius / length);
            Stand { at, leader: Some([foot, rim]) }
        })
    })
}

struct Crowd<'a> {
    taken: &'a [Taken],
    page: [f64; 2],
    placed: Vec<(f64, Stand)>,
}

impl Crowd<'_> {
    fn has_room(&self, number: &Number, stand: &Stand) -> bool {
        self.is_free(number, stand)
            && !self.placed.iter().any(|&other| collide((number.radius, *stand), other))
    }

    /// Whether the disc lies on the page and covers nothing that must be seen.
    fn is_free(&self, number: &Number, stand: &Stand) -> bool {
        let radius = number.radius;
        let on_page = (0..2).all(|e| (radius..=self.page[e] - radius).contains(&stand.at[e]));
        on_page
            && !self.taken.iter().any(|[middle, reach]| {
                let beyond: [f64; 2] =
                    std::array::from_fn(|e| ((stand.at[e] - middle[e]).abs() - reach[e]).max(0.0));
                square(beyond) < radius * radius
            })
    }
}

/// Whether two numbers, or the line of one and the disc of the other, meet.
fn collide((radius, stand): (f64, Stand), (other_radius, other): (f64, Stand)) -> bool {
    let crosses = |line: Option<[[f64; 2]; 2]>, at, radius| {
        line.is_some_and(|line| distance_to_segment(at, line) < radius + BETWEEN)
    };
    // All pairs are asked: a root would take most of the time.
    let apart = std::array::from_fn(|e| stand.at[e] - other.at[e]);
    square(apart) < (radius + other_radius + BETWEEN).powi(2)
        || crosses(stand.leader, other.at, other_radius)
        || crosses(other.leader, stand.at, radius)
}

/// Unit vector across a chord that points up on the page; to the right where
/// the chord stands upright.
fn upwards([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    let length = distance(from, to);
    if length < 1e-9 {
        return [0.0, -1.0];
    }
    let across: [f64; 2] = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    let is_down = across[1] > 0.0 || across[1] == 0.0 && across[0] < 0.0;
    if is_down { across.map(|x| -x) } else { across }
}

fn between([from, to]: [[f64; 2]; 2], share: f64) -> [f64; 2] {
    std::array::from_fn(|e| from[e] + share * (to[e] - from[e]))
}

fn moved(from: [f64; 2], along: [f64; 2], by: f64) -> [f64; 2] {
    std::array::from_fn(|e| from[e] + by * along[e])
}

fn square([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Distance of a point from a line between two points.
pub(crate) fn distance_to_segment(at: [f64; 2], segment: [[f64; 2]; 2]) -> f64 {
    let [from, to] = segment;
    let length = distance(from, to);
    if length < 1e-9 {
        return distance(at, from);
    }
    let along = (0..2).map(|e| (at[e] - from[e]) * (to[e] - from[e])).sum::<f64>();
    distance(at, between(segment, (along / (length * length)).clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::random::Random;

    const PAGE: [f64; 2] = [800.0, 600.0];
    const RADIUS: f64 = 9.5;

    /// Chords of these lengths, one after the other along a line from `from`.
    fn path(
        from: [f64; 2],
        along: [f64; 2],
        lengths: impl IntoIterator<Item = f64>,
    ) -> Vec<Number> {
        let mut at = 0.0;
        let mut numbers = Vec::new();
        for (index, length) in lengths.into_iter().enumerate() {
            let chord = [at, at + length].map(|by| moved(from, along, by));
            numbers.push(Number { order: index + 1, chord, radius: RADIUS, leaf: None });
            at += length;
        }
        numbers
    }

    fn check(numbers: &[Number], taken: &[Taken]) -> Vec<usize> {
        let stands = stands(numbers, taken, PAGE);
        let shown: Vec<(&Number, Stand)> =
            numbers.iter().zip(stands).filter_map(|(n, stand)| Some((n, stand?))).collect();
        for (index, (number, stand)) in shown.iter().enumerate() {
            let away = distance_to_segment(stand.at, number.chord);
            let near = if stand.leader.is_some() { 4.0 * RADIUS } else { RADIUS + GAP + 1e-9 };
            assert!(away <= near, "{number:?} stands at {stand:?}");
            for (other, place) in &shown[..index] {
                assert!(!collide((RADIUS, *stand), (RADIUS, *place)), "{number:?} and {other:?}");
            }
            for [middle, reach] in taken {
                let clear =
                    (0..2).any(|e| (stand.at[e] - middle[e]).abs() >= reach[e] + RADIUS / 1.5);
                assert!(clear, "{number:?} covers a handle");
            }
        }
        shown.into_iter().map(|(number, _)| number.order).collect()
    }

    #[test]
    fn all_numbers_are_shown_where_there_is_room() {
        let numbers = path([50.0, 500.0], [0.8, -0.6], [40.0; 15]);
        assert_eq!(check(&numbers, &[]).len(), 15);
        let upper = stands(&numbers, &[], PAGE);
        assert!(upper.iter().all(|stand| stand.is_some_and(|stand| stand.leader.is_none())));
    }

    #[test]
    fn round_numbers_and_the_last_one_stay_in_a_crowd() {
        let numbers = path([50.0, 300.0], [1.0, 0.0], [2.0; 157]);
        let shown = check(&numbers, &[]);
        assert!(shown.len() < 100, "{shown:?}");
        for order in (10..=150).step_by(10).chain([1, 157]) {
            assert!(shown.contains(&order), "{order} of {shown:?}");
        }
    }

    #[test]
    fn numbers_stand_in_their_leaf_where_it_has_room() {
        // The ray cuts the upper left corner off; above it lies another leaf.
        let chord = [[0.0, 112.0], [20.0, 100.0]];
        let leaf = Some([[0.0, 100.0], [80.0, 180.0]]);
        let number = Number { order: 1, chord, radius: RADIUS, leaf };
        let stand = stands(&[number], &[], PAGE)[0].unwrap();
        assert!(stand.at[0] > RADIUS && stand.at[1] > 100.0 + RADIUS, "{stand:?}");
    }

    #[test]
    fn numbers_keep_off_the_handles() {
        let numbers = path([100.0, 300.0], [1.0, 0.0], [12.0; 30]);
        let handles = [[[100.0, 300.0], [8.0; 2]], [[220.0, 300.0], [5.0; 2]]];
        assert!(check(&numbers, &handles).contains(&30));
    }

    #[test]
    fn numbers_of_any_path_stand_at_their_leaves() {
        let mut random = Random::new(7);
        for _ in 0..200 {
            let angle = random.between(0.0, std::f64::consts::TAU);
            let from = [random.between(0.0, 800.0), random.between(0.0, 600.0)];
            let n = random.between(1.0, 120.0) as usize;
            let lengths: Vec<f64> = (0..n).map(|_| random.between(0.0, 9.0).powi(2)).collect();
            check(&path(from, [angle.cos(), angle.sin()], lengths), &[[from, [8.0; 2]]]);
        }
    }
}
