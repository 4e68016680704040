//! Octoscope.
