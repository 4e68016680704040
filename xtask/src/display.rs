//! A display that nobody sees.

use std::io::{BufRead, BufReader};
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
}

impl Drop for VirtualDisplay {
    fn drop(&mut self) {
        // A server that has already ended is as good as one that is ended here;
        // it is asked politely, so that it takes its socket and lock away.
        let asked = Command::new("kill").arg(self.server.id().to_string()).status();
        if !asked.is_ok_and(|status| status.success()) {
            let _ = self.server.kill();
        }
        let _ = self.server.wait();
    }
}
