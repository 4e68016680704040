//! Octoscope.
fn main() {}
