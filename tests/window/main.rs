//! The window as its users meet it: the real program, operated by mouse and
//! keyboard through the accessibility tree.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod again;
mod algorithms;
mod camera;
mod complaints;
mod controls;
mod desk;
mod drawn;
mod export;
mod export_command;
mod export_matrix;
mod files;
mod find;
mod foot;
mod formulas;
mod hall;
mod keyboard;
mod lab;
mod layout;
mod lecture;
mod limits;
mod links;
mod map;
mod notices;
mod numbers;
mod panels;
mod paper;
mod pictures;
mod pictures_of_algorithms;
mod queries;
mod ray;
mod show;
mod states;
mod steps;
mod tree;
mod undo;
mod whole;
