//! The only place that touches the disk.

mod ask;
mod fault;
mod read;

pub use ask::{Answers, Chosen, LAB_ENDINGS, Purpose};
pub use fault::{FileError, FileFault};
pub use read::{MOST_BYTES, as_text, read};

use anyhow::anyhow;
use octoscope_core::progress::Progress;
use std::fs::{self, File};
use std::io::{self, BufWriter, Stdout, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Text of the file at `path`.
///
/// # Errors
/// Says why it cannot be read or where it is no text, and its path.
pub fn read_text(path: &Path) -> anyhow::Result<String> {
    let bytes = read(path, &Progress::default())?;
    let text = as_text(&bytes).map_err(|error| anyhow!("{error}: {}", path.display()))?;
    Ok(text.to_owned())
}

/// Whether `path` stands for standard output.
pub fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Whether there is a file or folder at `path`.
pub fn is_there(path: &Path) -> bool {
    path.exists()
}

/// What is at a path already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum There {
    /// Nothing.
    Nothing,
    /// A file, or something else that can be written to.
    File,
    /// A folder.
    Folder,
}

/// What is at `path` already.
pub fn there(path: &Path) -> There {
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => There::Folder,
        Ok(_) => There::File,
        Err(_) => There::Nothing,
    }
}

/// The whole of a path that may begin in the folder in which the program was started.
pub fn whole(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// Writes `bytes` to `path`: the file appears whole or not at all.
///
/// # Errors
/// Says why it cannot be written, and its path.
pub fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let mut output = Output::open(Some(path))?;
    output.put(bytes)?;
    output.finish()
}

/// Where results go. Until [`Output::finish`], a file does not appear under
/// its name.
pub enum Output {
    /// Standard output.
    Standard(BufWriter<Stdout>),
    /// A file that is about to appear.
    File {
        /// What is written so far, beside the target.
        temporary: BufWriter<NamedTempFile>,
        /// Where it will appear.
        target: PathBuf,
    },
    /// Something that is no regular file, such as a pipe; written in place.
    Device(BufWriter<File>, PathBuf),
}

impl Output {
    /// Standard output, as `-` too, or the file at `path`.
    ///
    /// # Errors
    /// Says why nothing can be written there.
    pub fn open(path: Option<&Path>) -> anyhow::Result<Self> {
        let Some(path) = path.filter(|path| !is_standard(path)) else {
            return Ok(Self::Standard(BufWriter::new(io::stdout())));
        };
        let failed = |error: io::Error| about(path, &error);
        if fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
            let file = File::options().write(true).open(path).map_err(failed)?;
            return Ok(Self::Device(BufWriter::new(file), path.to_owned()));
        }
        if path.is_dir() {
            return Err(FileFault::FolderAsFile.at(path));
        }
        // A link stays a link: what it points to is replaced.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        check_folder(folder)?;
        if fs::metadata(&target).is_ok_and(|found| found.permissions().readonly()) {
            return Err(FileFault::ReadOnly.at(path));
        }
        let mut builder = tempfile::Builder::new();
        builder.prefix(".octoscope-");
        // As usual for a new file; the user's mask takes away what it must.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        // The folder is there: that nothing is found means that it takes no file.
        let temporary = builder.tempfile_in(folder).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => FileFault::NoFileHere.at(path),
            _ => failed(error),
        })?;
        Ok(Self::File { temporary: BufWriter::new(temporary), target })
    }

    /// Writes bytes.
    ///
    /// # Errors
    /// Says why they cannot be written, and where to.
    pub fn put(&mut self, bytes: &[u8]) -> anyhow::Result<()> {
        let Err(error) = self.write_all(bytes) else { return Ok(()) };
        Err(match self {
            // Whoever asks ends quietly then.
            Self::Standard(_) if error.kind() == io::ErrorKind::BrokenPipe => error.into(),
            Self::Standard(_) => about(Path::new("standard output"), &error),
            Self::File { target, .. } => about(target, &error),
            Self::Device(_, path) => about(path, &error),
        })
    }

    /// Ends the output; a file appears under its name.
    ///
    /// # Errors
    /// Says what of it could not be written.
    pub fn finish(self) -> anyhow::Result<()> {
        match self {
            Self::Standard(mut output) => match output.flush() {
                // Whoever asks ends quietly then.
                Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Err(error.into()),
                flushed => flushed.map_err(|error| about(Path::new("standard output"), &error)),
            },
            Self::Device(mut output, path) => output.flush().map_err(|error| about(&path, &error)),
            Self::File { temporary, target } => {
                let file = temporary.into_inner().map_err(|e| about(&target, e.error()))?;
                file.persist(&target).map_err(|failed| about(&target, &failed.error))?;
                Ok(())
            }
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Standard(output) => output.write(bytes),
            Self::File { temporary, .. } => temporary.write(bytes),
            Self::Device(output, _) => output.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Standard(output) => output.flush(),
            Self::File { temporary, .. } => temporary.flush(),
            Self::Device(output, _) => output.flush(),
        }
    }
}

/// Refuses what is no folder that a file can appear in.
fn check_folder(folder: &Path) -> anyhow::Result<()> {
    match fs::metadata(folder) {
        Ok(found) if found.is_dir() => Ok(()),
        Ok(_) => Err(FileFault::FileAsFolder.at(folder)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(FileFault::NoFolder.at(folder))
        }
        Err(error) => Err(about(folder, &error)),
    }
}

/// The fact first, the path last.
fn about(path: &Path, error: &io::Error) -> anyhow::Error {
    FileFault::from(error).at(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_appears_only_when_it_is_finished() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.txt");
        let mut output = Output::open(Some(&path)).unwrap();
        output.write_all(b"half").unwrap();
        output.flush().unwrap();
        assert!(!path.exists());
        output.finish().unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"half");
    }

    #[test]
    fn what_is_not_finished_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.txt");
        write(&path, b"old").unwrap();
        let mut output = Output::open(Some(&path)).unwrap();
        output.write_all(b"new").unwrap();
        drop(output);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    /// What is said when nothing can be written to `path`.
    #[track_caller]
    fn check_refused(path: &Path, expected: &str) {
        let said = write(path, b"new").unwrap_err().to_string();
        assert!(said.starts_with(expected), "{said}");
    }

    #[test]
    fn what_cannot_be_written_is_told_with_what_to_do() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), b"old").unwrap();
        check_refused(folder.path(), "this is a folder; name a file: ");
        check_refused(&at("none/a.svg"), "there is no such folder to write to; create it first");
        check_refused(&at("file/a.svg"), "this is a file, so nothing can be written inside it");
        check_refused(&at("file/b/a.svg"), "this is a file, so nothing can be written inside it");
        check_refused(&at(&"x".repeat(300)), "the name is too long; choose a shorter one: ");
        let deep = at(&"d/".repeat(3000)).join("a.svg");
        check_refused(&deep, "the name is too long; choose a shorter one: ");
        let mut kept = fs::metadata(at("file")).unwrap().permissions();
        kept.set_readonly(true);
        fs::set_permissions(at("file"), kept).unwrap();
        check_refused(&at("file"), "this file is read-only; allow writing it, or name another");
        assert_eq!(fs::read(at("file")).unwrap(), b"old");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn folders_and_devices_that_take_nothing_say_so() {
        let here = "no file can be made in this folder; name another folder: /proc/a.svg";
        check_refused(Path::new("/proc/a.svg"), here);
        check_refused(Path::new("/dev/full"), "there is no room left; make some");
    }
}
