//! Misprinted rules as formulas, beside the right ones.

use super::term::{Fence, Formula, Sign, row};
use crate::traverse::Variant;

/// A rule as it is printed, and as it is right, in the notation of the paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Misprint {
    /// As it is printed.
    pub printed: Formula,
    /// As it is right.
    pub right: Formula,
}

const X: usize = 0;
const Y: usize = 1;
const Z: usize = 2;

/// The misprint that a variant follows, if a formula tells it.
pub fn misprint_formula(variant: Variant) -> Option<Misprint> {
    let [printed, right] = match variant {
        Variant::B1 => {
            let interval =
                |first, last| row![bound("min", first, "0"), Sign::Comma, bound("max", last, "1")];
            [interval("min", "max"), interval("max", "min")]
        }
        Variant::B2 => [sets(1), sets(4)],
        Variant::B2Morton => [[X, Y, Z], [Z, Y, X]].map(numbered),
        Variant::B3 => [
            row![
                t(X, "m"),
                Sign::Less,
                t(Y, "m"),
                Sign::Implies,
                q(1),
                Sign::Comma,
                t(Y, "m"),
                Sign::Less,
                t(Y, "1"),
                Sign::Implies,
                q(3),
            ],
            row![
                t(X, "m"),
                Sign::Less,
                t(Y, "m"),
                Sign::Implies,
                q(2),
                Sign::Comma,
                t(Y, "m"),
                Sign::Less,
                t(X, "1"),
                Sign::Implies,
                q(3),
            ],
        ],
        Variant::B4 => ["", "1"].map(|last| {
            row![t(X, "m"), Sign::Equal, row![t(X, "0"), Sign::Plus, t(X, last)].over(2)]
        }),
        Variant::B5 => [Sign::Less, Sign::LessOrEqual].map(|sign| {
            let quotient = Formula::from("x").over(0);
            let end = Formula::Digits("−∞".to_owned());
            row!["x", sign, 0, Sign::Implies, quotient, Sign::Equal, end]
        }),
        Variant::B6 => {
            let mean = row![t(X, "0"), Sign::Plus, t(X, "1")].over(2);
            let still = row![Formula::on(X, "d", ""), Sign::Equal, 0];
            let below = row![Formula::on(X, "p", ""), Sign::Less, Formula::coordinate(X, "m")];
            let beyond = Formula::Digits("∞".to_owned());
            [
                row![still.clone(), Sign::Implies, t(X, "m"), Sign::Equal, mean],
                row![still, Sign::Comma, below, Sign::Implies, t(X, "m"), Sign::Equal, beyond],
            ]
        }
        Variant::B7 => {
            let (p, turned) = (Formula::on(X, "p", ""), Formula::on(X, "p", "").sup("′"));
            let [x0, x1] = ["0", "1"].map(|index| Formula::coordinate(X, index));
            [
                row![turned.clone(), Sign::Equal, "s", Sign::Minus, p.clone()],
                row![turned, Sign::Equal, x0, Sign::Plus, x1, Sign::Minus, p],
            ]
        }
        Variant::B9 => {
            let near = || [X, Y, Z].map(|e| t(e, "0"));
            let entry = |all: Vec<Formula>| row!["t", Sign::Equal, Formula::call("max", all)];
            let mut clamped = near().to_vec();
            clamped.push(0.into());
            [entry(near().to_vec()), entry(clamped)]
        }
        Variant::B10 => {
            let meets = row![limit("min"), Sign::Less, limit("max")];
            let ahead = row![0, Sign::Less, limit("max")];
            [meets.clone(), row![meets, Sign::And, ahead]]
        }
        Variant::B11 => [
            row![limit("min"), Sign::LessOrEqual, limit("max")],
            row![limit("min"), Sign::Less, limit("max")],
        ],
        Variant::B19 => [Formula::from("ℓ"), row!["ℓ", Sign::Minus, 1].fenced(Fence::Round)]
            .map(|by| bit_of(Formula::on(X, "c", ""), by)),
        Variant::B21 => [Sign::LessOrEqual, Sign::Less]
            .map(|sign| row![0, Sign::LessOrEqual, Formula::coordinate(X, ""), sign, 1]),
        Variant::B24a => {
            let highest = highest(Sign::OrWord);
            [
                row!["ℓ", Sign::Equal, highest.clone()],
                row!["ℓ", Sign::Equal, 1, Sign::Plus, highest],
            ]
        }
        Variant::B24b => [Sign::AndWord, Sign::OrWord]
            .map(|sign| row!["ℓ", Sign::Equal, 1, Sign::Plus, highest(sign)]),
        Variant::B24c => ["Δ", "c"].map(|name| {
            let by = row!["ℓ", Sign::Minus, 1].fenced(Fence::Round);
            bit_of(Formula::on(X, name, ""), by)
        }),
        Variant::B28 => {
            let (c, next) = (Formula::on(X, "c", ""), Formula::on(X, "c", "").sup("′"));
            let side = Formula::from(2).sup("ℓ");
            [
                row![next.clone(), Sign::Equal, c.clone(), Sign::Minus, side],
                row![next, Sign::Equal, c, Sign::Minus, 1],
            ]
        }
        // These are about the order of bits and digits, which words tell better.
        Variant::B18
        | Variant::B25Leftmost
        | Variant::B25Rightmost
        | Variant::OneByOne
        | Variant::Averaged
        | Variant::Push
        | Variant::Gem => return None,
    };
    Some(Misprint { printed, right })
}

fn t(axis: usize, plane: &str) -> Formula {
    Formula::on(axis, "t", plane)
}

fn q(child: i64) -> Formula {
    Formula::from("q").sub(child)
}

/// t_min or t_max.
fn limit(name: &str) -> Formula {
    Formula::from("t").sub(name)
}

/// t_min = max(t_x0, t_y0)
fn bound(name: &str, operator: &str, plane: &str) -> Formula {
    row![limit(name), Sign::Equal, Formula::call(operator, [X, Y].map(|e| t(e, plane)))]
}

/// t_xm < t_z0 sets a bit of this weight.
fn sets(weight: i64) -> Formula {
    row![
        t(X, "m"),
        Sign::Less,
        t(Z, "0"),
        Sign::Implies,
        "i",
        Sign::Takes,
        "i",
        Sign::OrWord,
        weight,
    ]
}

/// i = i_x + 2 i_y + 4 i_z: the axes in the order of their weights.
fn numbered(axes: [usize; 3]) -> Formula {
    let [one, two, four] = axes.map(|e| Formula::on(e, "i", ""));
    let mut terms = [one, row![2, two], row![4, four]];
    if axes[0] == Z {
        terms.reverse();
    }
    row!["i", Sign::Equal, Formula::separated(terms, Sign::Plus)]
}

/// i_x = (code >> by) and 1
fn bit_of(code: Formula, by: Formula) -> Formula {
    let shifted = row![code, Sign::Shift, by].fenced(Fence::Round);
    row![Formula::on(X, "i", ""), Sign::Equal, shifted, Sign::AndWord, 1]
}

/// Number of the highest 1 of both differences, put together.
fn highest(sign: Sign) -> Formula {
    let both = Formula::separated([X, Y].map(|e| Formula::on(e, "Δ", "")), sign);
    row![Formula::Words("log".to_owned()).sub(2), both.fenced(Fence::Round)].fenced(Fence::Floor)
}
