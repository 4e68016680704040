//! Which members of a list are not those of another one.

/// Members of `before` and of `after` that are not in a longest list which both hold in
/// this order; `None` if they are more than `most` [Myers 1986]. Takes
/// O((n + m) · `most`) comparisons, far fewer where little differs.
pub(crate) fn changes<'a, T: PartialEq>(
    before: &'a [T],
    after: &'a [T],
    most: usize,
) -> Option<Vec<&'a T>> {
    // After d changes, how many members of `before` are passed at most on each of the
    // diagonals -d, -d + 2 … d: the difference of the members that are passed.
    let mut rows: Vec<Vec<usize>> = Vec::new();
    loop {
        let n_changes = rows.len();
        if n_changes > most {
            return None;
        }
        let mut row = Vec::with_capacity(n_changes + 1);
        for place in 0..=n_changes {
            let mut x = step(rows.last(), place).0;
            let mut y = x + n_changes - 2 * place;
            while x < before.len() && y < after.len() && before[x] == after[y] {
                (x, y) = (x + 1, y + 1);
            }
            row.push(x);
            if x == before.len() && y == after.len() {
                return Some(way_back(&rows, place, before, after));
            }
        }
        rows.push(row);
    }
}

/// The kind of a change.
#[derive(Clone, Copy)]
enum Change {
    /// A member of the first list is passed.
    Gone,
    /// A member of the second list is passed.
    New,
}

/// How many members of the first list are passed at `place` of the row after `row`, and
/// by which change.
fn step(row: Option<&Vec<usize>>, place: usize) -> (usize, Change) {
    let Some(row) = row else { return (0, Change::New) };
    let gone = place.checked_sub(1).map(|below| row[below] + 1);
    match (gone, row.get(place)) {
        (Some(gone), Some(&new)) if gone > new => (gone, Change::Gone),
        (Some(gone), None) => (gone, Change::Gone),
        (_, Some(&new)) => (new, Change::New),
        (None, None) => (0, Change::New),
    }
}

/// The changes on the way to `place` of the row after `rows`.
fn way_back<'a, T>(
    rows: &[Vec<usize>],
    mut place: usize,
    before: &'a [T],
    after: &'a [T],
) -> Vec<&'a T> {
    let mut found = Vec::with_capacity(rows.len());
    for n_changes in (1..=rows.len()).rev() {
        let (x, change) = step(rows.get(n_changes - 1), place);
        let y = x + n_changes - 2 * place;
        match change {
            Change::Gone => {
                found.extend(x.checked_sub(1).and_then(|index| before.get(index)));
                place -= 1;
            }
            Change::New => found.extend(y.checked_sub(1).and_then(|index| after.get(index))),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Changes from one word to another, in the order of the alphabet.
    #[track_caller]
    fn check(before: &str, after: &str, most: usize, expected: Option<&str>) {
        let [before, after] = [before, after].map(|word| word.chars().collect::<Vec<_>>());
        let found = changes(&before, &after, most).map(|found| {
            let mut found: Vec<char> = found.into_iter().copied().collect();
            found.sort_unstable();
            found.into_iter().collect::<String>()
        });
        assert_eq!(found.as_deref(), expected, "{before:?} {after:?}");
    }

    #[test]
    fn what_both_lists_hold_is_no_change() {
        check("", "", 0, Some(""));
        check("abc", "abc", 0, Some(""));
        check("abc", "abxc", 9, Some("x"));
        check("abc", "", 9, Some("abc"));
        check("", "ab", 9, Some("ab"));
        check("abcdefg", "xbcdyfz", 9, Some("aegxyz"));
        check("abc", "cab", 9, Some("cc"));
        check("abcd", "wxyz", 7, None);
        check("abcd", "wxyz", 8, Some("abcdwxyz"));
    }

    #[test]
    fn lists_differ_by_as_many_as_they_are_longer_than_what_they_share() {
        // All pairs of words of five letters over two.
        let words = || (0..32_u32).map(|n| (0..5).map(|bit| n >> bit & 1).collect::<Vec<_>>());
        for a in words() {
            for b in words() {
                let mut longest = [[0; 6]; 6];
                for x in 0..5 {
                    for y in 0..5 {
                        longest[x + 1][y + 1] = match a[x] == b[y] {
                            true => longest[x][y] + 1,
                            false => longest[x][y + 1].max(longest[x + 1][y]),
                        };
                    }
                }
                let found = changes(&a, &b, 10).unwrap();
                assert_eq!(found.len(), 10 - 2 * longest[5][5], "{a:?} {b:?}");
            }
        }
    }
}
