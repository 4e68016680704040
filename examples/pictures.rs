//! Draws what the window can look like, into `target/pictures`, to be looked at:
//!
//! ```text
//! cargo run --example pictures -- lecture german 1024
//! ```
//!
//! Every state of the window in four themes, two languages and three sizes; only
//! those whose names contain every word. Needs the software driver for Vulkan.

#![allow(clippy::unwrap_used, reason = "it is run by hand")]

#[path = "../tests/window/desk.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod desk;
#[path = "../tests/window/drawn.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod drawn;
#[path = "../tests/window/states.rs"]
#[allow(dead_code, reason = "tests use more of it")]
mod states;

use desk::Desk;
use octoscope_core::text::Language;
use octoscope_figure::Theme;
use states::State;
use std::fs;
use std::path::Path;

/// The projector's lecture, a small and a large screen.
const SIZES: [[u16; 2]; 3] = [[1024, 768], [1280, 800], [1920, 1080]];

fn main() {
    let words: Vec<String> = std::env::args().skip(1).map(|word| word.to_lowercase()).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/pictures");
    fs::create_dir_all(&folder).unwrap();
    for state in states::all() {
        for theme in Theme::ALL {
            for language in Language::ALL {
                for [width, height] in SIZES {
                    let how = format!("{}-{language:?}-{width}x{height}", theme.id());
                    let name = format!("{}-{how}", state.name).to_lowercase();
                    if words.iter().all(|word| name.contains(word)) {
                        let size = [width, height].map(f32::from);
                        let path = folder.join(format!("{name}.png"));
                        draw(&state, theme, language, size, &path);
                        println!("{}", path.display());
                    }
                }
            }
        }
    }
}

fn draw(state: &State, theme: Theme, language: Language, size: [f32; 2], path: &Path) {
    let mut desk: Desk = drawn::drawn_desk(size).expect("there is a software driver for Vulkan");
    (desk.state_mut().view.theme, desk.state_mut().view.language) = (theme, language);
    desk.run();
    state.reach(&mut desk);
    desk.render().unwrap().save(path).unwrap();
}
