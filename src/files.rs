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

/// Whether there is a file or folder at `path`.
pub fn is_there(path: &Path) -> bool {
    path.exists()
}

/// Writes `bytes` to `path`: the file appears whole or not at all.
///
/// # Errors
/// Says why it cannot be written, and its path.
pub fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let mut output = Output::open(Some(path))?;
    output.write_all(bytes).map_err(|error| about(path, &error))?;
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
    /// Standard output, or the file at `path`.
    ///
    /// # Errors
    /// Says why nothing can be written there.
    pub fn open(path: Option<&Path>) -> anyhow::Result<Self> {
        let Some(path) = path else {
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
        let mut builder = tempfile::Builder::new();
        builder.prefix(".octoscope-");
        // As usual for a new file; the user's mask takes away what it must.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let temporary = builder.tempfile_in(folder).map_err(failed)?;
        Ok(Self::File { temporary: BufWriter::new(temporary), target })
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
    if folder.is_dir() {
        return Ok(());
    }
    let fault = if folder.exists() { FileFault::FileAsFolder } else { FileFault::NoFolder };
    Err(fault.at(folder))
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
}
