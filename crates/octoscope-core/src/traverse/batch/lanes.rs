//! The lanes.
//!
//! Every field is an array with one value a lane, and every line of a step a loop
//! over the lanes without a jump, so that the compiler computes them with vectors.

use super::super::algorithm::StopAt;
use super::prepare::{Prepared, Start, prepare};
use super::settle::{Place, settle};
use super::{Leaf, visit_one};
use crate::geometry::{Ray, per_axis};
use crate::tree::{MAX_ROOT_LEVEL, Row, Tree};

/// Room for the levels of all trees, a power of two.
const LEVELS: usize = 32;
const _: () = assert!(LEVELS > MAX_ROOT_LEVEL as usize + 1);

/// Number of a lane without a ray.
const IDLE: usize = usize::MAX;

/// Rays in flight, `N` of them. Numbers of lanes have 64 bits, as their parameters,
/// so that the vectors of all are of one kind.
pub struct Lanes<'a, const D: usize, const N: usize> {
    tree: &'a Tree<D>,
    rows: &'a [Row],
    rays: &'a [Ray<D>],
    stop_at: StopAt,
    /// The next ray that gets a lane.
    next_ray: usize,
    n_active: usize,

    // The rays.
    ray: [usize; N],
    slope: [[f64; N]; D],
    start: [[f64; N]; D],
    error: [f64; N],
    mirror: [u64; N],

    // Where they are.
    /// Code of the current node, mirrored; as the bits of a double, see [`INTEGERS`].
    code: [[u64; N]; D],
    level: [u64; N],
    /// Bit l: lane l is in a leaf.
    leaves: u64,
    /// When the current node is entered.
    entry: [f64; N],
    /// Rows of the inner nodes down to the current one, by their level.
    stack: [[u32; N]; LEVELS],

    // What they have met.
    /// Leaves, in one part of equal length for each lane, and where the next ones go.
    found: Vec<Leaf>,
    place: [usize; N],
    /// Length of a part, and for how many steps it certainly suffices.
    part: usize,
    room: usize,
}

/// Lanes that have ended, one bit each.
struct Ended {
    /// Their rays have left the root.
    out: u64,
    /// Their rays have met the leaf at which they stop.
    met_last: u64,
}

/// A double from 2^52 to 2^53 is an integer, which its lowest bits spell: so a code
/// becomes a double, and a double a code, without being converted.
const INTEGERS: f64 = (1u64 << 52) as f64;

/// Number of the highest 1 bit, plus 1; of 0 it is no matter what.
#[inline(always)]
fn bit_length(integer: u64) -> u64 {
    let double = f64::from_bits(integer | INTEGERS.to_bits()) - INTEGERS;
    (double.to_bits() >> 52).wrapping_sub(1022)
}

impl<'a, const D: usize, const N: usize> Lanes<'a, D, N> {
    /// All lanes idle.
    #[inline(always)]
    pub fn new(tree: &'a Tree<D>, rays: &'a [Ray<D>], stop_at: StopAt) -> Self {
        let part = 64;
        Self {
            tree,
            rows: tree.rows(),
            rays,
            stop_at,
            next_ray: 0,
            n_active: 0,
            ray: [IDLE; N],
            slope: [[0.0; N]; D],
            start: [[0.0; N]; D],
            error: [0.0; N],
            mirror: [0; N],
            code: [[0; N]; D],
            level: [0; N],
            leaves: 0,
            entry: [0.0; N],
            stack: [[0; N]; LEVELS],
            found: vec![Leaf::default(); part * N],
            place: std::array::from_fn(|lane| lane * part),
            part,
            room: part,
        }
    }

    /// Walks until all rays have ended.
    #[inline(always)]
    pub fn run(&mut self, take: &mut impl FnMut(usize, &[Leaf])) {
        let root = self.tree.root();
        if root.is_leaf() {
            // No lane is needed.
            let mut found = Vec::new();
            for (index, ray) in self.rays.iter().enumerate() {
                found.clear();
                visit_one(self.tree, ray, self.stop_at, &mut found);
                take(index, &found);
            }
            return;
        }
        for lane in 0..N {
            self.fill(lane, take);
        }
        while self.n_active > 0 {
            let Ended { out, met_last } = self.step();
            if out | met_last != 0 {
                for lane in 0..N {
                    let [out, met_last] = [out, met_last].map(|mask| mask >> lane & 1 == 1);
                    if out | met_last {
                        self.end(lane, out, take);
                    }
                }
            }
        }
    }

    /// Hands on what the ray of a lane has met, and gives the lane another one.
    #[inline(always)]
    fn end(&mut self, lane: usize, is_out: bool, take: &mut impl FnMut(usize, &[Leaf])) {
        if self.ray[lane] == IDLE {
            return self.rest(lane);
        }
        // Outside the root there is no leaf, whatever the last step has taken for one.
        let none = is_out && self.leaves >> lane & 1 == 1;
        let to = self.place[lane] - usize::from(none);
        take(self.ray[lane], &self.found[lane * self.part..to]);
        self.n_active -= 1;
        self.fill(lane, take);
    }

    /// Gives a lane the next ray that needs one.
    #[inline(always)]
    fn fill(&mut self, lane: usize, take: &mut impl FnMut(usize, &[Leaf])) {
        while let Some(ray) = self.rays.get(self.next_ray) {
            let index = self.next_ray;
            self.next_ray += 1;
            match prepare(self.tree.domain(), ray) {
                Start::Misses => take(index, &[]),
                Start::Single => {
                    let mut found = Vec::new();
                    visit_one(self.tree, ray, self.stop_at, &mut found);
                    take(index, &found);
                }
                Start::Lane(prepared) => {
                    self.ray[lane] = index;
                    self.n_active += 1;
                    self.begin(lane, &prepared);
                    return;
                }
            }
        }
        self.ray[lane] = IDLE;
        self.rest(lane);
    }

    /// Lets a lane without a ray leave the root in every step.
    fn rest(&mut self, lane: usize) {
        let (slope, start) = ([1.0; D], [0.0; D]);
        self.begin(lane, &Prepared { slope, start, error: -1.0, entry: 0.0, mirror: 0 });
        self.leaves |= 1 << lane;
    }

    /// Puts a ray into the root.
    #[inline(always)]
    fn begin(&mut self, lane: usize, prepared: &Prepared<D>) {
        for e in 0..D {
            self.slope[e][lane] = prepared.slope[e];
            self.start[e][lane] = prepared.start[e];
            self.code[e][lane] = INTEGERS.to_bits();
        }
        self.error[lane] = prepared.error;
        self.mirror[lane] = prepared.mirror;
        self.entry[lane] = prepared.entry;
        let root_level = u64::from(self.tree.domain().root_level());
        self.level[lane] = root_level;
        self.leaves &= !(1 << lane);
        self.stack[root_level as usize % LEVELS][lane] = 0;
        self.place[lane] = lane * self.part;
    }

    /// One step of every lane; returns which of them have ended.
    #[inline(always)]
    fn step(&mut self) -> Ended {
        if self.room == 0 {
            self.make_room();
        }
        self.room -= 1;

        // Planes ahead: by a cell in a leaf, by half a cell in an inner node.
        let mut is_leaf = [0; N];
        let mut ahead = [0; N];
        for l in 0..N {
            is_leaf[l] = self.leaves >> l & 1;
            ahead[l] = 1 << (self.level[l] + is_leaf[l] - 1);
        }
        let mut next = [[0; N]; D];
        let mut t = [[0.0; N]; D];
        for e in 0..D {
            for l in 0..N {
                next[e][l] = self.code[e][l] + ahead[l];
                let plane = f64::from_bits(next[e][l]) - INTEGERS;
                t[e][l] = plane * self.slope[e][l] + self.start[e][l];
            }
        }

        // Passed: the planes that are not after the exit of the leaf, or the entry of
        // the inner node.
        let mut now = [0.0; N];
        for l in 0..N {
            let mut exit = t[0][l];
            for e in 1..D {
                exit = if t[e][l] < exit { t[e][l] } else { exit };
            }
            now[l] = if is_leaf[l] == 1 { exit } else { self.entry[l] };
        }

        // Open: what is too close to tell. In a leaf the exit is close to itself.
        let mut any_open = 0;
        let mut closest = [0.0; N];
        for l in 0..N {
            let (mut first, mut second) = (f64::INFINITY, f64::INFINITY);
            for e in 0..D {
                let gap = (t[e][l] - now[l]).abs();
                let later = if gap > first { gap } else { first };
                first = if gap < first { gap } else { first };
                second = if later < second { later } else { second };
            }
            closest[l] = if is_leaf[l] == 1 { second } else { first };
            any_open |= if closest[l] > self.error[l] { 0 } else { 1 };
        }
        let mut step = [[0; N]; D];
        for e in 0..D {
            for l in 0..N {
                step[e][l] = if t[e][l] <= now[l] { next[e][l] } else { self.code[e][l] };
            }
        }
        if any_open != 0 {
            step = self.settle(&closest, next, step);
        }

        // Next: beyond the passed planes; the highest bit that changes tells the level
        // of the node below which the next one is.
        let mut changed = [0; N];
        for e in 0..D {
            for l in 0..N {
                changed[l] |= step[e][l] ^ self.code[e][l];
            }
        }
        let root_level = u64::from(self.tree.domain().root_level());
        let mut parent_level = [0; N];
        let mut is_out = [0; N];
        for l in 0..N {
            let common = bit_length(changed[l]);
            parent_level[l] = if is_leaf[l] == 1 { common } else { self.level[l] };
            self.level[l] = parent_level[l] - 1;
            self.entry[l] = now[l];
            is_out[l] = if parent_level[l] > root_level { 1 } else { 0 };
        }
        let mut child = [0; N];
        for e in 0..D {
            for l in 0..N {
                let above = step[e][l] >> self.level[l];
                child[l] = child[l] << 1 | (above & 1);
                self.code[e][l] = above << self.level[l];
            }
        }
        for l in 0..N {
            child[l] ^= self.mirror[l];
        }

        // The child: of the node itself, or of one that was kept on the way down. It
        // is an inner node, which is kept, or a leaf, which is met.
        let (mut leaves, mut met_last, mut out) = (0, 0, 0);
        for l in 0..N {
            let level = parent_level[l] as usize;
            let row = self.stack[level % LEVELS][l];
            let Row { base, inner, full } = self.rows[row as usize];
            let [inner, full] = [inner, full].map(u32::from);
            let child = child[l] as u32;
            let before = inner & ((1 << child) - 1);
            self.stack[(level - 1) % LEVELS][l] = base + before.count_ones();
            let is_leaf = !inner >> child & 1;
            let is_full = full >> child & 1;
            self.found[self.place[l]] = Leaf(row << D | child | is_full << 31);
            self.place[l] += is_leaf as usize;
            leaves |= u64::from(is_leaf) << l;
            met_last |= u64::from(is_full) << l;
            out |= is_out[l] << l;
        }
        self.leaves = leaves;
        if self.stop_at == StopAt::End {
            met_last = 0;
        }
        Ended { out, met_last }
    }

    /// Makes the lists of the lanes long enough for at least one more step.
    #[cold]
    fn make_room(&mut self) {
        let lengths = (0..N).map(|lane| self.place[lane] - lane * self.part);
        let longest = lengths.fold(0, usize::max);
        if longest == self.part {
            let old = std::mem::take(&mut self.found);
            for part in old.chunks(self.part) {
                self.found.extend_from_slice(part);
                self.found.resize(self.found.len() + self.part, Leaf::default());
            }
            for lane in 0..N {
                self.place[lane] += lane * self.part;
            }
            self.part *= 2;
        }
        self.room = self.part - longest;
    }

    /// The next codes where exact comparisons decide which planes are passed.
    #[cold]
    #[inline(never)]
    fn settle(
        &self,
        closest: &[f64; N],
        next: [[u64; N]; D],
        mut step: [[u64; N]; D],
    ) -> [[u64; N]; D] {
        for l in 0..N {
            if closest[l] > self.error[l] {
                continue;
            }
            let place = Place {
                level: self.level[l] as u8,
                mirrored: per_axis(|e| self.code[e][l] as u32),
                is_leaf: self.leaves >> l & 1 == 1,
            };
            let axes = settle(self.tree.domain(), &self.rays[self.ray[l]], place);
            for e in 0..D {
                step[e][l] = if axes.contains(e) { next[e][l] } else { self.code[e][l] };
            }
        }
        step
    }
}
