//! The system's file dialogs, which are asked on another thread.

use eframe::egui::Context;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

/// What the user has chosen in a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Chosen {
    /// Open this file.
    Open(PathBuf),
    /// Save the scenario here.
    Save(PathBuf),
    /// Export the view here.
    Export(PathBuf),
    /// Save what the bench lab shows here.
    Lab(PathBuf),
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
        self.ask(context, Purpose::Open, async move { dialog.pick_file().await }, Chosen::Open);
    }

    /// Asks where to save the scenario.
    pub fn ask_save(&self, context: &Context) {
        let dialog = rfd::AsyncFileDialog::new()
            .add_filter("Octoscope", &["octo"])
            .set_file_name("scenario.octo");
        self.ask(context, Purpose::Save, async move { dialog.save_file().await }, Chosen::Save);
    }

    /// Asks where to export to, in the format of this file ending.
    pub fn ask_export(&self, context: &Context, ending: &'static str) {
        self.ask_named(context, Purpose::Export(ending), ("octoscope", ending), Chosen::Export);
    }

    /// Asks where to save what the bench lab shows, in the format of this file ending.
    pub fn ask_lab(&self, context: &Context, ending: &'static str) {
        self.ask_named(context, Purpose::Lab(ending), ("bench", ending), Chosen::Lab);
    }

    /// Asks for the name of a file, which gets this ending if it has none.
    fn ask_named(
        &self,
        context: &Context,
        purpose: Purpose,
        (name, ending): (&str, &'static str),
        chosen: fn(PathBuf) -> Chosen,
    ) {
        let dialog = rfd::AsyncFileDialog::new()
            .add_filter(ending.to_uppercase(), &[ending])
            .set_file_name(format!("{name}.{ending}"));
        let named = move |path: PathBuf| {
            let has_ending = path.extension().is_some();
            chosen(if has_ending { path } else { path.with_extension(ending) })
        };
        self.ask(context, purpose, async move { dialog.save_file().await }, named);
    }

    fn ask(
        &self,
        context: &Context,
        purpose: Purpose,
        answer: impl Future<Output = Option<rfd::FileHandle>> + Send + 'static,
        chosen: impl FnOnce(PathBuf) -> Chosen + Send + 'static,
    ) {
        if !has_dialogs() {
            // The window goes on; nobody else holds the sender's other end.
            let _ = self.sender.send(Chosen::NoDialog(purpose));
            return;
        }
        let (sender, context) = (self.sender.clone(), context.clone());
        std::thread::spawn(move || {
            if let Some(file) = pollster::block_on(answer) {
                let _ = sender.send(chosen(file.path().to_owned()));
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
