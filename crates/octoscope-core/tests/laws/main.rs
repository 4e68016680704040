//! Laws on random trees: every algorithm against the oracle, every query
//! against brute force, every trace against itself.

mod agreement;
mod batch;
mod fates;
mod misprints;
mod queries;
mod rays;
mod rounding;
mod traces;
mod traversals;
mod trees;
