//! What can be measured: an algorithm, or the kernel for many rays.

use crate::traverse::{Algorithm, Kernel, Method, MethodError};
use std::fmt;
use std::str::FromStr;

/// A way to find the leaves on many rays, by name: that of an algorithm with its
/// variants; `batch`, the kernel with the processor's vectors; `batch@plain`, the
/// same without them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Ray by ray, as it is explained.
    Traced(Method),
    /// Many rays at once, always exactly; nothing of it can be counted but leaves.
    Batch(Kernel),
}

impl Way {
    /// The kernels.
    pub const KERNELS: [Self; 2] = [Self::Batch(Kernel::Plain), Self::Batch(Kernel::Vector)];

    /// The algorithms in their right form, then the kernels.
    pub fn all() -> Vec<Self> {
        Algorithm::ALL.into_iter().map(Self::from).chain(Self::KERNELS).collect()
    }

    /// The method, if that is what it is.
    pub fn method(self) -> Option<Method> {
        match self {
            Self::Traced(method) => Some(method),
            Self::Batch(_) => None,
        }
    }
}

impl Default for Way {
    fn default() -> Self {
        Self::Traced(Method::default())
    }
}

impl From<Method> for Way {
    fn from(method: Method) -> Self {
        Self::Traced(method)
    }
}

impl From<Algorithm> for Way {
    fn from(algorithm: Algorithm) -> Self {
        Self::Traced(algorithm.into())
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Traced(method) => method.fmt(f),
            Self::Batch(Kernel::Plain) => f.write_str("batch@plain"),
            Self::Batch(Kernel::Vector) => f.write_str("batch"),
        }
    }
}

impl FromStr for Way {
    type Err = MethodError;

    fn from_str(text: &str) -> Result<Self, MethodError> {
        let kernel = Self::KERNELS.into_iter().find(|kernel| kernel.to_string() == text);
        kernel.map_or_else(|| text.parse().map(Self::Traced), Ok)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for way in Way::all() {
            assert_eq!(way.to_string().parse(), Ok(way));
        }
        let way: Way = "bsp@gem".parse().unwrap();
        assert_eq!(way.to_string(), "bsp@gem");
        assert!("batch@gem".parse::<Way>().is_err());
    }
}
