//! What happens, in words.

mod number;
mod rich;

pub use number::{approx, distinct, number};
pub use rich::{RichText, Span};
