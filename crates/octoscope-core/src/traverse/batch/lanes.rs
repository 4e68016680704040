//! The lanes.
//!
//! Every field is an array with one value a lane, and every line of a step a loop
//! over the lanes without a jump, so that the compiler computes them with vectors. What
//! it cannot (rows of the tree, lists of leaves) is loops of their own, in which nothing
//! is computed: vectors and single values that take turns wait for each other.

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
    /// 1: the lane is in a leaf.
    leaf: [u64; N],
    /// 1: the lane's ray has left the root or met the leaf at which it stops.
    ended: [u64; N],
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

/// A double from 2^52 to 2^53 is an integer, which its lowest bits spell: so a code
/// becomes a double, and a double a code, without being converted.
const INTEGERS: f64 = (1u64 << 52) as f64;

/// Number of the highest 1 bit, plus 1; of 0 it is no matter what.
#[inline(always)]
fn bit_length(integer: u64) -> u64 {
    let double = f64::from_bits(integer | INTEGERS.to_bits()) - INTEGERS;
    (double.to_bits() >> 52).wrapping_sub(1022)
}

/// Number of 1 bits among the lowest 7, where all others are 0.
#[inline(always)]
fn n_ones(bits: u64) -> u64 {
    let pairs = bits - (bits >> 1 & 0x55);
    let fours = (pairs & 0x33) + (pairs >> 2 & 0x33);
    (fours + (fours >> 4)) & 0xf
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
            leaf: [0; N],
            ended: [0; N],
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
            if self.step() {
                for lane in 0..N {
                    if self.ended[lane] == 1 {
                        self.end(lane, take);
                    }
                }
            }
        }
    }

    /// Hands on what the ray of a lane has met, and gives the lane another one.
    #[inline(always)]
    fn end(&mut self, lane: usize, take: &mut impl FnMut(usize, &[Leaf])) {
        if self.ray[lane] == IDLE {
            return self.rest(lane);
        }
        // Outside the root there is no leaf, whatever the last step has taken for one.
        let is_out = self.level[lane] >= u64::from(self.tree.domain().root_level());
        let none = is_out && self.leaf[lane] == 1;
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
        self.leaf[lane] = 1;
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
        self.leaf[lane] = 0;
        self.stack[root_level as usize % LEVELS][lane] = 0;
        self.place[lane] = lane * self.part;
    }

    /// One step of every lane; returns whether any of them has ended.
    #[inline(always)]
    fn step(&mut self) -> bool {
        if self.room == 0 {
            self.make_room();
        }
        self.room -= 1;

        // Planes ahead: by a cell in a leaf, by half a cell in an inner node.
        let mut is_leaf = [0; N];
        let mut ahead = [0; N];
        for l in 0..N {
            is_leaf[l] = self.leaf[l];
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
            let (mut first, mut second) = ((t[0][l] - now[l]).abs(), f64::INFINITY);
            for e in 1..D {
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
        for l in 0..N {
            changed[l] = (0..D).fold(0, |bits, e| bits | step[e][l] ^ self.code[e][l]);
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
            child[l] = (child[l] ^ self.mirror[l]) & ((1 << D) - 1);
        }

        // The child: of the node itself, or of one that was kept on the way down. All
        // rows are fetched first, so that waiting for one is waiting for all.
        let mut row = [0; N];
        let mut word = [0; N];
        for l in 0..N {
            row[l] = u64::from(self.stack[parent_level[l] as usize % LEVELS][l]);
            word[l] = self.rows[row[l] as usize].0;
        }
        let stops = u64::from(self.stop_at == StopAt::FirstFull);
        let mut below = [0; N];
        let mut met = [0; N];
        let mut any_ended = 0;
        for l in 0..N {
            let inner = word[l] >> Row::INNER;
            below[l] = word[l] + n_ones(inner & ((1 << child[l]) - 1));
            let is_full = word[l] >> (u64::from(Row::FULL) + child[l]) & 1;
            met[l] = row[l] << D | child[l] | is_full << 31;
            self.leaf[l] = !inner >> child[l] & 1;
            self.ended[l] = is_out[l] | is_full & stops;
            any_ended |= self.ended[l];
        }

        // It is an inner node, which is kept, or a leaf, which is met.
        for l in 0..N {
            self.stack[(parent_level[l] as usize - 1) % LEVELS][l] = below[l] as u32;
            self.found[self.place[l]] = Leaf(met[l] as u32);
        }
        for l in 0..N {
            self.place[l] += self.leaf[l] as usize;
        }
        any_ended != 0
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
                is_leaf: self.leaf[l] == 1,
            };
            let axes = settle(self.tree.domain(), &self.rays[self.ray[l]], place);
            for e in 0..D {
                step[e][l] = if axes.contains(e) { next[e][l] } else { self.code[e][l] };
            }
        }
        step
    }
}
