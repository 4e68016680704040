//! A folder with files in which the program is run.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use tempfile::TempDir;

/// A folder with files, and the program run in it.
pub struct Desk(pub TempDir);

impl Desk {
    /// Folder with one occupied cell of a 4×4 grid and three rays.
    pub fn new() -> Self {
        let desk = Self(tempfile::tempdir().unwrap());
        desk.put("a.cells", "# corner\n3 0\n");
        desk.put("a.rays", "-1 0.125 1 0\n0.5 0.5 0x1p-1 0x1p-1\n5 5 1 1 # misses\n");
        desk
    }

    pub fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    pub fn run(&self, arguments: &str) -> Output {
        self.command(arguments).output().unwrap()
    }

    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_octoscope"));
        command.args(arguments.split_whitespace()).current_dir(self.0.path());
        for display in ["DISPLAY", "WAYLAND_DISPLAY"] {
            command.env_remove(display);
        }
        command
    }

    /// Standard output of a run that succeeds without a message.
    #[track_caller]
    pub fn prints(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert_eq!(text(&output.stderr), "", "{arguments}");
        assert_eq!(output.status.code(), Some(0), "{arguments}");
        text(&output.stdout)
    }

    /// The message of a run that ends with status 2 and prints nothing.
    #[track_caller]
    pub fn refuses(&self, arguments: &str) -> String {
        let output = self.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}");
        assert_eq!(text(&output.stdout), "", "{arguments}");
        text(&output.stderr)
    }
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

pub const VISIT: &str = "visit --cells a.cells --depth 2 --rays a.rays --dim 2";
pub const LINES: &str = "3 1:0,0 0:2,0 0:3,0*\n1 1:2,2\n0\n";

pub const SCENARIO: &str = r#"{
  "octoscope": 1,
  "dimension": 2,
  "scene": {"points": [[0.1, 0.2], [0.15, 0.25], [0.8, 0.9]]},
  "build": {"depth": 4, "capacity": 1},
  "ray": {"origin": [-0.25, 0.1], "direction": [1, 0.5]},
  "step": 3
}"#;

/// A folder with a scenario and a file that ends too early.
pub fn desk_with_scenario() -> Desk {
    let desk = Desk::new();
    desk.put("a.octo", SCENARIO);
    desk.put("cut.octo", &SCENARIO[..SCENARIO.len() / 2]);
    desk.put("a.xyz", "0 0 0\n1 1 1\n");
    desk
}
