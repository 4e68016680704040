//! Few colours for many.

use crate::Pixels;
use std::collections::HashMap;

/// At most 255 colours in place of those of pictures. What is seen most keeps
/// its colour exactly; the others lie no farther from theirs than needed.
#[derive(Clone, Debug)]
pub(crate) struct FewColours {
    chosen: Vec<[u8; 3]>,
    nearest: HashMap<[u8; 3], u8>,
}

impl FewColours {
    /// Most colours; one number is left for what is transparent.
    const MOST: usize = 255;

    /// Colours for `pictures` and those like them.
    pub(crate) fn of<'a>(pictures: impl IntoIterator<Item = &'a Pixels>) -> Self {
        let mut counts: HashMap<[u8; 3], u32> = HashMap::new();
        for pixel in pictures.into_iter().flat_map(|picture| picture.rgba.chunks_exact(4)) {
            if pixel[3] >= 128 {
                *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
            }
        }
        let mut wanted: Vec<_> = counts.into_iter().collect();
        wanted.sort_unstable_by_key(|&(colour, count)| (u32::MAX - count, colour));
        let mut chosen = Vec::new();
        for apart in [0, 6, 12, 18, 24, 36, 48, 64, 96, 128, 192] {
            chosen = spread(&wanted, apart * apart);
            if chosen.len() <= Self::MOST {
                break;
            }
        }
        chosen.truncate(Self::MOST);
        Self { chosen, nearest: HashMap::new() }
    }

    /// Red, green and blue of all, one after the other.
    pub(crate) fn palette(&self) -> Vec<u8> {
        self.chosen.concat()
    }

    /// Number of the colour that stands for `colour`.
    pub(crate) fn number(&mut self, colour: [u8; 3]) -> u8 {
        *self.nearest.entry(colour).or_insert_with(|| {
            let distances = self.chosen.iter().map(|&other| distance(colour, other));
            let nearest = distances.enumerate().min_by_key(|&(_, distance)| distance);
            nearest.map_or(0, |(number, _)| number as u8)
        })
    }
}

/// The first colours that lie farther than `apart` from each other, one too many
/// at most.
fn spread(wanted: &[([u8; 3], u32)], apart: u32) -> Vec<[u8; 3]> {
    let mut chosen: Vec<[u8; 3]> = Vec::new();
    for &(colour, _) in wanted {
        if apart == 0 || chosen.iter().all(|&other| distance(colour, other) > apart) {
            chosen.push(colour);
        }
        if chosen.len() > FewColours::MOST {
            break;
        }
    }
    chosen
}

/// Square of the distance.
fn distance(a: [u8; 3], b: [u8; 3]) -> u32 {
    a.iter().zip(b).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_colours_are_kept_and_many_are_near() {
        let picture = |colours: Vec<[u8; 3]>| {
            let rgba = colours.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
            Pixels { width: colours.len() as u32, height: 1, rgba }
        };
        let mut few = FewColours::of(&[picture(vec![[1, 2, 3], [4, 5, 6], [1, 2, 3]])]);
        assert_eq!(few.palette(), [1, 2, 3, 4, 5, 6]);
        assert_eq!(few.number([5, 5, 5]), 1);
        let many: Vec<_> = (0..4096u16).map(|i| [i as u8, (i >> 4) as u8, 7]).collect();
        let mut few = FewColours::of(&[picture([vec![[255; 3]; 9000], many.clone()].concat())]);
        assert!(few.chosen.len() <= 255);
        assert_eq!(few.chosen[0], [255; 3], "what is seen most");
        for colour in many {
            let number = few.number(colour);
            assert!(distance(colour, few.chosen[usize::from(number)]) <= 24 * 24);
        }
    }
}
