//! A display that nobody sees.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// A running Xvfb; it ends with this value.
pub struct VirtualDisplay {
    server: Child,
    /// Name for `DISPLAY`, such as `:1`.
    pub name: String,
}

impl VirtualDisplay {
    /// Starts a display of 1280×800 under the first free number.
    ///
    /// # Errors
    /// Says why Xvfb did not start.
    pub fn start() -> Result<Self, String> {
        let mut server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"])
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| format!("Xvfb could not be started: {error}"))?;
        // The server writes its number as soon as it takes connections.
        let mut number = String::new();
        if let Some(output) = server.stdout.take() {
            // Without a line the number stays empty, which is refused below.
            let _ = BufReader::new(output).read_line(&mut number);
        }
        let mut display = Self { server, name: format!(":{}", number.trim()) };
        if number.trim().is_empty() {
            let status = display.server.wait();
            return Err(format!("Xvfb ended at once: {status:?}"));
        }
        Ok(display)
    }

    /// Makes `command` open its windows here. `folder` stands for the user's
    /// folder of sockets, if there is none.
    pub fn show(&self, command: &mut Command, folder: &Path) {
        command.env("DISPLAY", &self.name).env_remove("WAYLAND_DISPLAY");
        // The graphics driver looks there for Wayland, and calls it an error if
        // there is no place to look.
        if std::env::var_os("XDG_RUNTIME_DIR").is_none() {
            command.env("XDG_RUNTIME_DIR", folder);
        }
    }
}

impl Drop for VirtualDisplay {
    fn drop(&mut self) {
        // A server that has already ended is as good as one that is ended here;
        // it is asked politely, so that it takes its socket and lock away.
        let asked = request_to_end(self.server.id()).status();
        if !asked.is_ok_and(|status| status.success()) {
            let _ = self.server.kill();
        }
        let _ = self.server.wait();
    }
}

/// Asks a process to end, by the shell's own `kill`: a small Debian has no
/// program of that name.
fn request_to_end(process: u32) -> Command {
    let mut command = Command::new("/bin/sh");
    command.args(["-c", "kill \"$0\"", &process.to_string()]);
    command
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::process::ExitStatusExt;

    #[test]
    fn a_process_is_asked_to_end_where_no_other_program_is() {
        let mut process = Command::new("cat").stdin(Stdio::piped()).spawn().unwrap();
        let asked = request_to_end(process.id()).env("PATH", "/nowhere").status();
        if !asked.as_ref().is_ok_and(|status| status.success()) {
            process.kill().unwrap();
        }
        assert_eq!(process.wait().unwrap().signal(), Some(15), "{asked:?}");
    }
}
