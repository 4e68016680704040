//! A few numbers: each has a place, and together they have the best ones.

use super::crowd::{Crowd, collide};
use super::grid::{Costs, Grid, ROWS, Slot, shared_out};
use super::places::{aside, beside};
use super::{Area, Kept, Number, Stand, distance};

/// Where each of `numbers` stands. Those that find room in their leaves stand there, the
/// last one first. The others are shared out in a row on both sides of the ray, the nearest
/// that has room for all; then each goes where it would stand better, as long as
/// that is better for those, too, which it pushes away. O(n² · places).
pub(super) fn settled(numbers: &[Number], kept: Kept) -> Vec<Option<Stand>> {
    const SWEEPS: usize = 2;
    let crowd = Crowd::new(kept);
    let mut settling = Settling::of(numbers, &crowd);
    settling.share_out(numbers, &crowd);
    for _ in 0..SWEEPS {
        let is_better = order(numbers.len()).map(|index| settling.improve(index));
        if is_better.filter(|is_better| *is_better).count() == 0 {
            break;
        }
    }
    (0..numbers.len()).map(|index| settling.choice(index).map(|choice| choice.stand)).collect()
}

/// The order in which numbers choose: the last one tells where the algorithm is.
fn order(n: usize) -> impl Iterator<Item = usize> {
    n.checked_sub(1).into_iter().chain(0..n.saturating_sub(1))
}

/// A place that a number can have.
struct Choice {
    stand: Stand,
    /// Its slot in the grid, if it is one of that.
    slot: Option<Slot>,
    /// Least and largest corner of the disc and its line.
    extent: [[f64; 2]; 2],
    /// The more, the worse it is: about the length of its line.
    cost: f64,
}

/// What it costs to cover what must be seen.
const COVERS: f64 = 1e4;
/// What it costs a line to cross another one that has to be seen.
const CROSSES: f64 = 30.0;
/// What it costs to have no place.
const NONE: f64 = 1e6;

struct Settling {
    /// The places that each number can have, the best first.
    choices: Vec<Vec<Choice>>,
    /// Which of its choices each number has taken.
    taken: Vec<Option<usize>>,
}

impl Settling {
    /// Those numbers have places that find room in their leaves.
    fn of(numbers: &[Number], crowd: &Crowd<'_>) -> Self {
        let on_leaf = |number: &Number| {
            let free = beside(number).into_iter().filter(|stand| crowd.is_free(stand));
            let places = free.enumerate().map(|(n, stand)| (None, stand, 0.1 * n as f64));
            choices(places, crowd)
        };
        let mut settling = Self {
            choices: numbers.iter().map(on_leaf).collect(),
            taken: vec![None; numbers.len()],
        };
        for index in order(numbers.len()) {
            settling.taken[index] = settling.first_free(index);
        }
        settling
    }

    /// Shares the numbers without a place out in the nearest row that has room for all of
    /// them, or in the one where most of them find room.
    fn share_out(&mut self, numbers: &[Number], crowd: &Crowd<'_>) {
        let without = (0..numbers.len()).filter(|index| self.taken[*index].is_none());
        let mut without: Vec<usize> = without.collect();
        let led: Vec<&Number> = without.iter().map(|index| &numbers[*index]).collect();
        let Some(grid) = Grid::of(&led) else { return };
        let place = |index: &usize| grid.place_of(&numbers[*index]);
        without.sort_by(|a, b| place(a).total_cmp(&place(b)));
        for &index in &without {
            // Nearby, where the grid is too coarse.
            let near = aside(&numbers[index]).filter(|stand| crowd.is_free(stand));
            let places = near.map(|stand| (None, stand, cost(&stand, index, numbers, crowd)));
            let choices = choices(places, crowd);
            self.choices[index].extend(choices);
        }
        let mut best: Option<(f64, Vec<(usize, Stand)>)> = None;
        for row in 0..ROWS {
            for &index in &without {
                let places = grid.places(&numbers[index], row).into_iter();
                let places = places.map(|(slot, stand)| {
                    let covers = if crowd.is_free(&stand) { 0.0 } else { COVERS };
                    (Some(slot), stand, covers + cost(&stand, index, numbers, crowd))
                });
                let choices = choices(places, crowd);
                self.choices[index].extend(choices);
                sort(&mut self.choices[index]);
            }
            let (cost, stands) = self.in_row(row, &without);
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, stands));
            }
            if cost < COVERS {
                break;
            }
        }
        for (index, stand) in best.into_iter().flat_map(|(_, stands)| stands) {
            let taken = self.choices[index].iter().position(|choice| choice.stand == stand);
            let is_free =
                |taken: &usize| self.met(&self.choices[index][*taken], index, &[]).next().is_none();
            self.taken[index] = taken.filter(is_free);
        }
    }

    /// Where numbers stand best in a row, and what that costs.
    fn in_row(&self, row: usize, without: &[usize]) -> (f64, Vec<(usize, Stand)>) {
        let last = self.taken.len() - 1;
        let free = |index: usize| {
            let of_row = self.choices[index].iter().filter_map(move |choice| {
                choice.slot.filter(|slot| slot.row == row).map(|slot| (slot, choice))
            });
            of_row.filter(move |(_, choice)| self.met(choice, index, &[]).next().is_none())
        };
        let slots = || without.iter().flat_map(|&index| free(index)).map(|(slot, _)| slot.index);
        let first = slots().min().unwrap_or(0);
        let n_slots = slots().max().map_or(0, |last| last + 1 - first);
        let costs = without.iter().map(|&index| {
            let mut costs: Costs = [(); 2].map(|()| vec![f64::INFINITY; n_slots]);
            for (slot, choice) in free(index) {
                costs[slot.side][slot.index - first] = choice.cost;
            }
            costs
        });
        let costs: Vec<Costs> = costs.collect();
        let none = |n: usize| if without[n] == last { 9.0 * NONE } else { NONE };
        let (cost, places) = shared_out(&costs, n_slots, none);
        let stands = places.into_iter().zip(without).filter_map(|(place, &index)| {
            let [side, slot] = place?;
            let is_there = |of: &Slot| of.side == side && of.index == first + slot;
            let (_, choice) = free(index).find(|(of, _)| is_there(of))?;
            Some((index, choice.stand))
        });
        (cost, stands.collect())
    }

    fn choice(&self, index: usize) -> Option<&Choice> {
        self.taken[index].map(|taken| &self.choices[index][taken])
    }

    fn cost(&self, index: usize) -> f64 {
        self.choice(index).map_or(NONE, |choice| choice.cost)
    }

    /// Other numbers whose places a choice meets, but for some of them.
    fn met<'a>(
        &'a self,
        choice: &'a Choice,
        index: usize,
        except: &'a [usize],
    ) -> impl Iterator<Item = usize> + 'a {
        (0..self.taken.len()).filter(move |other| {
            *other != index
                && !except.contains(other)
                && self.choice(*other).is_some_and(|other| meet(choice, other))
        })
    }

    /// The best choice of a number that meets none of the others.
    fn first_free(&self, index: usize) -> Option<usize> {
        let is_free = |choice: &Choice| self.met(choice, index, &[]).next().is_none();
        self.choices[index].iter().position(is_free)
    }

    /// Takes the choice of a number that makes its place and those of the others it pushes
    /// away better together; whether there is one.
    fn improve(&mut self, index: usize) -> bool {
        const LEAST: f64 = 2.0;
        const MOST_PUSHED: usize = 2;
        let before = self.cost(index);
        let mut best: Option<(f64, Vec<(usize, usize)>)> = None;
        for (taken, choice) in self.choices[index].iter().enumerate() {
            let least = best.as_ref().map_or(LEAST, |(gain, _)| *gain);
            let most = before - choice.cost - least;
            if most <= 0.0 {
                break;
            }
            let pushed: Vec<usize> = self.met(choice, index, &[]).take(MOST_PUSHED + 1).collect();
            if pushed.len() > MOST_PUSHED {
                continue;
            }
            let Some((lost, others)) = self.pushed_away(choice, index, &pushed, most) else {
                continue;
            };
            if lost < most {
                let changes = others.into_iter().chain([(index, taken)]).collect();
                best = Some((before - choice.cost - lost, changes));
            }
        }
        let is_better = best.is_some();
        for (index, taken) in best.into_iter().flat_map(|(_, changes)| changes) {
            self.taken[index] = Some(taken);
        }
        is_better
    }

    /// Where others that meet a choice go, and what they lose by it, if that is not more
    /// than `most`.
    fn pushed_away(
        &self,
        choice: &Choice,
        index: usize,
        pushed: &[usize],
        most: f64,
    ) -> Option<(f64, Vec<(usize, usize)>)> {
        let except: Vec<usize> = pushed.iter().copied().chain([index]).collect();
        let (mut lost, mut moves): (f64, Vec<(usize, usize)>) = (0.0, Vec::new());
        for &other in pushed {
            let is_free = |new: &Choice| {
                let meets_moved =
                    |&(moved, taken): &(usize, usize)| meet(new, &self.choices[moved][taken]);
                !meet(new, choice)
                    && !moves.iter().any(meets_moved)
                    && self.met(new, other, &except).next().is_none()
            };
            let dearest = self.cost(other) + most - lost;
            let choices = &self.choices[other];
            let n = choices.partition_point(|choice| choice.cost < dearest);
            let taken = choices[..n].iter().position(is_free)?;
            lost += choices[taken].cost - self.cost(other);
            moves.push((other, taken));
        }
        Some((lost, moves))
    }
}

/// Places on the page as choices, the best first.
fn choices(
    places: impl Iterator<Item = (Option<Slot>, Stand, f64)>,
    crowd: &Crowd<'_>,
) -> Vec<Choice> {
    let on_page = places.filter(|(_, stand, _)| crowd.is_on_page(stand));
    let mut choices: Vec<Choice> = on_page
        .map(|(slot, stand, cost)| Choice { stand, slot, extent: stand.extent(), cost })
        .collect();
    sort(&mut choices);
    choices
}

fn sort(choices: &mut [Choice]) {
    choices.sort_by(|a, b| a.cost.total_cmp(&b.cost));
}

/// What a place with a line costs: its length, and what it covers and crosses.
fn cost(stand: &Stand, index: usize, numbers: &[Number], crowd: &Crowd<'_>) -> f64 {
    let extent = stand.extent();
    let others = numbers.iter().enumerate().filter(|(other, _)| *other != index);
    let near = others.map(|(_, other)| &other.leaf).filter(|leaf| leaf.reaches(extent));
    let length = stand.leader.map_or(0.0, |[foot, rim]| distance(foot, rim));
    let crosses = if crowd.is_crossed(stand) { CROSSES } else { 0.0 };
    length + crosses + near.map(|leaf| covered(stand, leaf)).sum::<f64>()
}

/// What it costs to lie on the leaf of another number.
fn covered(stand: &Stand, leaf: &Area) -> f64 {
    let Stand { at: [x, y], radius, leader } = *stand;
    let across = [[[x - radius, y], [x + radius, y]], [[x, y - radius], [x, y + radius]]];
    let disc = across.map(|line| leaf.length_on(line)).into_iter().sum::<f64>();
    2.0 * leader.map_or(0.0, |line| leaf.length_on(line)) + 0.4 * disc
}

fn meet(a: &Choice, b: &Choice) -> bool {
    let is_near =
        (0..2).all(|e| a.extent[0][e] <= b.extent[1][e] && b.extent[0][e] <= a.extent[1][e]);
    is_near && collide(&a.stand, &b.stand)
}
