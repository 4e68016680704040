//! Where the space view is looked at from, when the user asks by name.

/// What the camera is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Standpoint {
    /// Along x, from the right.
    Right,
    /// Along y, from the front.
    Front,
    /// Along z, from above.
    Above,
    /// The current node, in the middle and large.
    Node,
    /// Everything, from the present side.
    Everything,
}
