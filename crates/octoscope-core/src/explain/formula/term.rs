//! Formulas as data: what stands over, under and beside what.

use crate::explain::number::with_minus;
use crate::geometry::AXIS_NAMES;

/// A formula, or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// Parts side by side.
    Row(Vec<Formula>),
    /// Name of a quantity.
    Symbol {
        /// What is written.
        name: String,
        /// Axis whose colour it has.
        axis: Option<usize>,
    },
    /// A number that was computed.
    Number {
        /// The number itself, to the last digit.
        value: f64,
        /// Its short form.
        shown: String,
    },
    /// Digits of a whole number, or of a code in binary.
    Digits(String),
    /// Words: what follows.
    Words(String),
    /// A sign between or before others.
    Sign(Sign),
    /// A part with another one at its lower right.
    Sub {
        /// The part.
        body: Box<Formula>,
        /// What stands below.
        below: Box<Formula>,
    },
    /// A part with another one at its upper right.
    Sup {
        /// The part.
        body: Box<Formula>,
        /// What stands above.
        above: Box<Formula>,
    },
    /// A fraction with a bar.
    Fraction {
        /// What stands over the bar.
        over: Box<Formula>,
        /// What stands under it.
        under: Box<Formula>,
    },
    /// An operator over all of something, such as max over e.
    Over {
        /// Its name.
        operator: &'static str,
        /// What stands below it.
        limit: Box<Formula>,
    },
    /// A part between brackets as high as itself.
    Fenced {
        /// The brackets.
        fence: Fence,
        /// What is between them.
        body: Box<Formula>,
    },
}

/// Brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fence {
    /// ( )
    Round,
    /// ⌊ ⌋, the largest whole number below.
    Floor,
    /// ⌈ ⌉, the smallest whole number above.
    Ceiling,
    /// | |, the amount.
    Absolute,
}

impl Fence {
    /// Name in keys of texts.
    pub fn id(self) -> &'static str {
        match self {
            Self::Round => "round",
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Absolute => "absolute",
        }
    }
}

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sign {
    /// =
    Equal,
    /// ≈, where the short forms do not tell all digits.
    About,
    /// ≠
    Unequal,
    /// <
    Less,
    /// ≤
    LessOrEqual,
    /// >
    Greater,
    /// ≥
    GreaterOrEqual,
    /// ∈
    In,
    /// ∉
    NotIn,
    /// ⇒
    Implies,
    /// ←: takes the value.
    Takes,
    /// +
    Plus,
    /// −
    Minus,
    /// ·
    Times,
    /// ⊕
    Xor,
    /// xor
    XorWord,
    /// ^
    XorCaret,
    /// ∧: both are true.
    And,
    /// and: bit by bit.
    AndWord,
    /// &: bit by bit.
    BitAnd,
    /// ∨: one of them is true.
    Or,
    /// or: bit by bit.
    OrWord,
    /// |: bit by bit.
    BitOr,
    /// >>
    Shift,
    /// ¬
    Not,
    /// ,
    Comma,
    /// …
    To,
}

/// How much room a sign wants beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Room {
    /// Between two operands.
    Operation,
    /// Between two sides.
    Relation,
    /// Between a reason and what follows.
    Consequence,
    /// Only after it.
    Behind,
    /// None.
    Tight,
}

impl Sign {
    /// Every sign.
    pub const ALL: [Self; 27] = [
        Self::Equal,
        Self::About,
        Self::Unequal,
        Self::Less,
        Self::LessOrEqual,
        Self::Greater,
        Self::GreaterOrEqual,
        Self::In,
        Self::NotIn,
        Self::Implies,
        Self::Takes,
        Self::Plus,
        Self::Minus,
        Self::Times,
        Self::Xor,
        Self::XorWord,
        Self::XorCaret,
        Self::And,
        Self::AndWord,
        Self::BitAnd,
        Self::Or,
        Self::OrWord,
        Self::BitOr,
        Self::Shift,
        Self::Not,
        Self::Comma,
        Self::To,
    ];

    /// As it is written.
    pub fn text(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::About => "≈",
            Self::Unequal => "≠",
            Self::Less => "<",
            Self::LessOrEqual => "≤",
            Self::Greater => ">",
            Self::GreaterOrEqual => "≥",
            Self::In => "∈",
            Self::NotIn => "∉",
            Self::Implies => "⇒",
            Self::Takes => "←",
            Self::Plus => "+",
            Self::Minus => "−",
            Self::Times => "·",
            Self::Xor => "⊕",
            Self::XorWord => "xor",
            Self::XorCaret => "^",
            Self::And => "∧",
            Self::AndWord => "and",
            Self::BitAnd => "&",
            Self::Or => "∨",
            Self::OrWord => "or",
            Self::BitOr => "|",
            Self::Shift => ">>",
            Self::Not => "¬",
            Self::Comma => ",",
            Self::To => "…",
        }
    }

    /// As LaTeX reads it in mathematics.
    pub fn latex(self) -> &'static str {
        match self {
            Self::Equal => "=",
            Self::About => "\\approx",
            Self::Unequal => "\\ne",
            Self::Less => "<",
            Self::LessOrEqual => "\\le",
            Self::Greater => ">",
            Self::GreaterOrEqual => "\\ge",
            Self::In => "\\in",
            Self::NotIn => "\\notin",
            Self::Implies => "\\;\\Rightarrow\\;",
            Self::Takes => "\\gets",
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Times => "\\cdot",
            Self::Xor => "\\oplus",
            Self::XorWord => "\\mathbin{\\mathrm{xor}}",
            Self::XorCaret => "\\mathbin{\\wedge}",
            Self::And => "\\wedge",
            Self::AndWord => "\\mathbin{\\mathrm{and}}",
            Self::BitAnd => "\\mathbin{\\&}",
            Self::Or => "\\vee",
            Self::OrWord => "\\mathbin{\\mathrm{or}}",
            Self::BitOr => "\\mathbin{|}",
            Self::Shift => "\\mathbin{\\gg}",
            Self::Not => "\\neg",
            Self::Comma => ",\\;",
            Self::To => "\\dots",
        }
    }

    /// Key of how it is spoken.
    pub fn key(self) -> &'static str {
        match self {
            Self::Equal => "sign-equal",
            Self::About => "sign-about",
            Self::Unequal => "sign-unequal",
            Self::Less => "sign-less",
            Self::LessOrEqual => "sign-less-or-equal",
            Self::Greater => "sign-greater",
            Self::GreaterOrEqual => "sign-greater-or-equal",
            Self::In => "sign-in",
            Self::NotIn => "sign-not-in",
            Self::Implies => "sign-implies",
            Self::Takes => "sign-takes",
            Self::Plus => "sign-plus",
            Self::Minus => "sign-minus",
            Self::Times => "sign-times",
            Self::Xor | Self::XorWord | Self::XorCaret => "sign-xor",
            Self::And | Self::AndWord | Self::BitAnd => "sign-and",
            Self::Or | Self::OrWord | Self::BitOr => "sign-or",
            Self::Shift => "sign-shift",
            Self::Not => "sign-not",
            Self::Comma => "sign-comma",
            Self::To => "sign-to",
        }
    }

    /// The room beside it.
    pub fn room(self) -> Room {
        match self {
            Self::Implies => Room::Consequence,
            Self::Equal
            | Self::About
            | Self::Unequal
            | Self::Less
            | Self::LessOrEqual
            | Self::Greater
            | Self::GreaterOrEqual
            | Self::In
            | Self::NotIn
            | Self::Takes
            | Self::To => Room::Relation,
            Self::Plus
            | Self::Minus
            | Self::Times
            | Self::Xor
            | Self::XorWord
            | Self::XorCaret
            | Self::And
            | Self::AndWord
            | Self::BitAnd
            | Self::Or
            | Self::OrWord
            | Self::BitOr
            | Self::Shift => Room::Operation,
            Self::Comma => Room::Behind,
            Self::Not => Room::Tight,
        }
    }
}

impl From<Sign> for Formula {
    fn from(sign: Sign) -> Self {
        Self::Sign(sign)
    }
}

/// A symbol that belongs to no axis.
impl From<&str> for Formula {
    fn from(name: &str) -> Self {
        Self::Symbol { name: name.to_owned(), axis: None }
    }
}

/// A whole number.
impl From<i64> for Formula {
    fn from(number: i64) -> Self {
        Self::Digits(with_minus(number))
    }
}

/// Parts side by side, each as [`Formula`] takes it.
macro_rules! row {
    ($($part:expr),* $(,)?) => {
        $crate::explain::formula::term::Formula::Row(
            vec![$($crate::explain::formula::term::Formula::from($part)),*],
        )
    };
}
pub(super) use row;

impl Formula {
    /// `name` with the name of `axis` and `more` below it, in the colour of the axis.
    pub(super) fn on(axis: usize, name: &str, more: &str) -> Self {
        let coloured = |name: String| Self::Symbol { name, axis: Some(axis) };
        coloured(name.to_owned()).sub(coloured(format!("{}{more}", AXIS_NAMES[axis])))
    }

    /// The coordinate along `axis` with `more` below it: x_m.
    pub(super) fn coordinate(axis: usize, more: &str) -> Self {
        let coloured = |name: &str| Self::Symbol { name: name.to_owned(), axis: Some(axis) };
        if more.is_empty() {
            return coloured(AXIS_NAMES[axis]);
        }
        coloured(AXIS_NAMES[axis]).sub(coloured(more))
    }

    /// This with another one below.
    pub(super) fn sub(self, below: impl Into<Self>) -> Self {
        Self::Sub { body: Box::new(self), below: Box::new(below.into()) }
    }

    /// This with another one above.
    pub(super) fn sup(self, above: impl Into<Self>) -> Self {
        Self::Sup { body: Box::new(self), above: Box::new(above.into()) }
    }

    /// This over another one.
    pub(super) fn over(self, under: impl Into<Self>) -> Self {
        Self::Fraction { over: Box::new(self), under: Box::new(under.into()) }
    }

    /// This between brackets.
    pub(super) fn fenced(self, fence: Fence) -> Self {
        Self::Fenced { fence, body: Box::new(self) }
    }

    /// Parts between commas.
    pub(super) fn list(parts: impl IntoIterator<Item = Self>) -> Self {
        Self::separated(parts, Sign::Comma)
    }

    /// Parts with a sign between each two.
    pub(super) fn separated(parts: impl IntoIterator<Item = Self>, sign: Sign) -> Self {
        let mut all = Vec::new();
        for part in parts {
            if !all.is_empty() {
                all.push(Self::Sign(sign));
            }
            all.push(part);
        }
        Self::Row(all)
    }

    /// A function of some arguments: max(a, b).
    pub(super) fn call(name: &str, arguments: impl IntoIterator<Item = Self>) -> Self {
        Self::Row(vec![Self::Words(name.to_owned()), Self::list(arguments).fenced(Fence::Round)])
    }
}
