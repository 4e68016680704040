//! A picture that takes long, drawn bit by bit.

use super::draw::Call;
use std::ops::Range;

/// Where drawing goes on: at an instance of a call.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Cursor {
    call: usize,
    /// Among the instances of the call, from 0.
    instance: u32,
}

impl Cursor {
    /// Whether nothing is drawn yet.
    pub fn is_start(self) -> bool {
        self == Self::default()
    }
}

/// The calls from `cursor` on, with their instances, that take no more than
/// `most_vertices`, but at least one instance; and where to go on, `None` at the end.
pub(super) fn share(
    calls: &[Call],
    mut cursor: Cursor,
    most_vertices: u64,
) -> (Vec<(usize, Range<u32>)>, Option<Cursor>) {
    let (mut shares, mut left) = (Vec::new(), most_vertices);
    while let Some(call) = calls.get(cursor.call) {
        let vertices = u64::from(call.vertices());
        let start = call.instances.start + cursor.instance;
        let n_left = u64::from(call.instances.end.saturating_sub(start));
        let is_first = shares.is_empty();
        let n = n_left.min((left / vertices).max(u64::from(is_first)));
        if n > 0 {
            shares.push((cursor.call, start..start + n as u32));
            left = left.saturating_sub(n * vertices);
        }
        if n < n_left {
            cursor.instance += n as u32;
            return (shares, Some(cursor));
        }
        cursor = Cursor { call: cursor.call + 1, instance: 0 };
    }
    (shares, None)
}

#[cfg(test)]
mod tests {
    use super::super::draw::{Kind, Uniform};
    use super::*;
    use bytemuck::Zeroable as _;

    fn call(kind: Kind, instances: Range<u32>) -> Call {
        Call { layer: 0, kind, uniform: Uniform::zeroed(), instances }
    }

    #[test]
    fn shares_are_the_whole_one_after_another() {
        let calls = [
            call(Kind::Edges, 0..5),
            call(Kind::Edges, 5..5),
            call(Kind::Spheres, 0..2),
            call(Kind::Triangles, 7..9),
        ];
        for most in [0, 6, 7, 13, 30, 1000] {
            let mut drawn = vec![Vec::new(); calls.len()];
            let mut next = Some(Cursor::default());
            while let Some(cursor) = next {
                let (shares, after) = share(&calls, cursor, most);
                let cost = |(call, range): &(usize, Range<u32>)| {
                    u64::from(calls[*call].vertices()) * range.len() as u64
                };
                let total: u64 = shares.iter().map(cost).sum();
                assert!(total <= most || shares.len() == 1 && shares[0].1.len() == 1);
                assert_ne!(after, Some(cursor));
                shares.into_iter().for_each(|(call, range)| drawn[call].extend(range));
                next = after;
            }
            let all = calls.each_ref().map(|call| call.instances.clone().collect::<Vec<_>>());
            assert_eq!(drawn, all, "{most}");
        }
    }
}
