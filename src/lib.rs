//! Octoscope shows quadtrees and octrees, and every step of the algorithms on
//! them: in a window and on the command line.

pub mod app;
pub mod arrangement;
pub mod cli;
pub mod command;
pub mod comparison;
pub mod complaint;
pub mod document;
pub mod export;
pub mod export_dialog;
pub mod figures;
pub mod files;
pub mod finder;
pub mod history;
pub mod job;
pub mod kept_show;
pub mod look;
pub mod notice;
pub mod open;
pub mod panels;
pub mod playback;
pub mod render;
pub mod save;
pub mod shortcut;
pub mod show_change;
pub mod sidebar;
pub mod space;
pub mod text;
pub mod theme;
pub mod traced;
pub mod tree_view;
pub mod view;
pub mod widgets;
pub mod window;
