//! Where the sides of a child are looked up.

/// Where it is looked up on which sides of its parent a child lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lookup {
    /// In the tables of adjacency and of the common part [Samet 1989].
    Tables,
    /// In the bits of the child, compared with those of the ray's corner.
    Bits,
}
