//! The panels, each a function that shows its part of the state.

pub mod automaton;
pub mod children;
pub mod codes;
pub mod compare;
pub mod counters;
pub mod cuts;
pub mod dialogs;
pub mod grid;
pub mod halves;
pub mod links;
pub mod listing;
pub mod menu;
pub mod neighbour;
pub mod paper;
pub mod query;
pub mod ray;
pub mod region;
pub mod scene;
pub mod sentence;
pub mod show;
pub mod stack;
pub mod t_rail;
pub mod tables;
pub mod timeline;
pub mod variables;
pub mod way_down;
