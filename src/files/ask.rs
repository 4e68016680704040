//! The system's file dialogs, which are asked on another thread.

use eframe::egui::Context;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};

/// Endings of what the bench lab writes: charts, then tables.
pub const LAB_ENDINGS: [&str; 6] = ["svg", "pdf", "png", "tex", "csv", "md"];

/// What the user has chosen in a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Chosen {
    /// This path, as it was chosen or typed.
    Path(Purpose, PathBuf),
    /// There is no dialog on this system: a path has to be typed.
    NoDialog(Purpose),
}

/// What a file is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// To be opened.
    Open,
    /// To hold the scenario.
    Save,
    /// To hold the view, in the format of this file ending.
    Export(&'static str),
    /// To hold what the bench lab shows, in the format of this file ending.
    Lab(&'static str),
}

impl Purpose {
    /// `path` with an ending by which the program knows the file again: the scenario's
    /// own, or, of a figure, any.
    pub fn named(self, path: &Path) -> PathBuf {
        let (ending, is_named) = match self {
            Self::Open => return path.to_owned(),
            Self::Save => {
                let own = path.extension();
                ("octo", own.is_some_and(|own| own.eq_ignore_ascii_case("octo")))
            }
            Self::Export(ending) => (ending, path.extension().is_some()),
            Self::Lab(ending) => {
                let own = path.extension();
                let is = |known: &&str| own.is_some_and(|own| own.eq_ignore_ascii_case(known));
                (ending, LAB_ENDINGS.iter().any(is))
            }
        };
        if is_named {
            return path.to_owned();
        }
        let mut named = path.as_os_str().to_owned();
        named.push(".");
        named.push(ending);
        named.into()
    }
}

/// Answers of dialogs that have been opened.
pub struct Answers {
    sender: Sender<Chosen>,
    receiver: Receiver<Chosen>,
}

impl Default for Answers {
    fn default() -> Self {
        let (sender, receiver) = channel();
        Self { sender, receiver }
    }
}

/// Endings of the files that can be opened.
const OPENED: [&str; 14] = [
    "octo", "png", "jpg", "jpeg", "obj", "ply", "stl", "xyz", "csv", "tsv", "svg", "pdf", "tex",
    "apng",
];

impl Answers {
    /// The next answer, if there is one.
    pub fn take(&self) -> Option<Chosen> {
        self.receiver.try_recv().ok()
    }

    /// Asks which file to open.
    pub fn ask_open(&self, context: &Context) {
        let dialog = rfd::AsyncFileDialog::new().add_filter("Octoscope", &OPENED);
        self.ask(context, Purpose::Open, async move { dialog.pick_file().await });
    }

    /// Asks where to save the scenario.
    pub fn ask_save(&self, context: &Context) {
        let dialog = rfd::AsyncFileDialog::new()
            .add_filter("Octoscope", &["octo"])
            .set_file_name("scenario.octo");
        self.ask(context, Purpose::Save, async move { dialog.save_file().await });
    }

    /// Asks where to export to, in the format of this file ending.
    pub fn ask_export(&self, context: &Context, ending: &'static str) {
        self.ask_named(context, Purpose::Export(ending), "octoscope", ending);
    }

    /// Asks where to save what the bench lab shows, in the format of this file ending.
    pub fn ask_lab(&self, context: &Context, ending: &'static str) {
        self.ask_named(context, Purpose::Lab(ending), "bench", ending);
    }

    /// Asks for the name of a file, which gets this ending if it has none.
    fn ask_named(&self, context: &Context, purpose: Purpose, name: &str, ending: &'static str) {
        let dialog = rfd::AsyncFileDialog::new()
            .add_filter(ending.to_uppercase(), &[ending])
            .set_file_name(format!("{name}.{ending}"));
        self.ask(context, purpose, async move { dialog.save_file().await });
    }

    fn ask(
        &self,
        context: &Context,
        purpose: Purpose,
        answer: impl Future<Output = Option<rfd::FileHandle>> + Send + 'static,
    ) {
        if !has_dialogs() {
            // The window goes on; nobody else holds the sender's other end.
            let _ = self.sender.send(Chosen::NoDialog(purpose));
            return;
        }
        let (sender, context) = (self.sender.clone(), context.clone());
        std::thread::spawn(move || {
            if let Some(file) = pollster::block_on(answer) {
                let _ = sender.send(Chosen::Path(purpose, file.path().to_owned()));
                context.request_repaint();
            }
        });
    }
}

/// Whether the system can show a file dialog: on Linux through the desktop
/// portal on the session bus, or through zenity.
fn has_dialogs() -> bool {
    if cfg!(not(target_os = "linux")) {
        return true;
    }
    let bus = std::env::var_os("DBUS_SESSION_BUS_ADDRESS").is_some();
    let folders = std::env::var_os("PATH").unwrap_or_default();
    bus || std::env::split_paths(&folders).any(|folder| folder.join("zenity").is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_get_an_ending_by_which_they_are_known_again() {
        let check = |purpose: Purpose, path: &str, named: &str| {
            assert_eq!(purpose.named(Path::new(path)), Path::new(named));
        };
        check(Purpose::Save, "a/scene", "a/scene.octo");
        check(Purpose::Save, "scene.OCTO", "scene.OCTO");
        check(Purpose::Save, "version 1.2", "version 1.2.octo");
        check(Purpose::Save, "scene.txt", "scene.txt.octo");
        check(Purpose::Export("svg"), "a.b/figure", "a.b/figure.svg");
        check(Purpose::Export("svg"), "figure.png", "figure.png");
        check(Purpose::Lab("csv"), "run 1.2", "run 1.2.csv");
        check(Purpose::Lab("csv"), "run.PDF", "run.PDF");
        check(Purpose::Open, "scene", "scene");
    }
}
