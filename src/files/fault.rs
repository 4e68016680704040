//! Why a file cannot be read or written.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a file cannot be read or written, and its path.
#[derive(Debug, Error)]
#[error("{fault}: {}", path.display())]
pub struct FileError {
    /// What is wrong.
    pub fault: FileFault,
    /// Where.
    pub path: PathBuf,
}

/// What can be wrong with a file, whatever it holds.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FileFault {
    /// Nothing is there.
    #[error("there is no such file or folder")]
    NotFound,
    /// The system does not allow it.
    #[error("permission denied; allow it, or name another")]
    Denied,
    /// The disk is full.
    #[error("there is no room left; make some, or write elsewhere")]
    Full,
    /// A folder is to be read.
    #[error("this is a folder, not a file; choose a file")]
    Folder,
    /// A folder is to be written to as if it were a file.
    #[error("this is a folder; name a file")]
    FolderAsFile,
    /// A file is to be written into as if it were a folder.
    #[error("this is a file, so nothing can be written inside it; name a folder")]
    FileAsFolder,
    /// The folder to write to is not there.
    #[error("there is no such folder to write to; create it first, or name another")]
    NoFolder,
    /// A folder that is there takes no file.
    #[error("no file can be made in this folder; name another folder")]
    NoFileHere,
    /// A file that is there must not be replaced.
    #[error("this file is read-only; allow writing it, or name another")]
    ReadOnly,
    /// A name, or the whole path, is longer than the system takes.
    #[error("the name is too long; choose a shorter one")]
    NameTooLong,
    /// More than is read.
    #[error("the {kind} holds more than {limit}; reduce it first")]
    TooLong {
        /// What is read.
        kind: Kind,
        /// The most that is read of it.
        limit: Size,
    },
    /// The file does not fit into memory.
    #[error("there is not memory enough for this file; reduce it first")]
    NoMemory,
    /// A pipe without another end.
    #[error("nobody writes into this pipe; start who does, or name a file")]
    NobodyWrites,
    /// Bytes that are no text, from this offset on.
    #[error("byte {0} is no text; give a text in UTF-8")]
    NoText(usize),
    /// A text in another encoding.
    #[error("the text is in UTF-16; save it in UTF-8")]
    Utf16,
    /// Anything else, as the system says it.
    #[error("{0}")]
    System(String),
}

/// What bytes are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A regular file.
    File,
    /// Something that may have no end.
    Device,
    /// What another program writes.
    Pipe,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::File => "file",
            Self::Device => "device",
            Self::Pipe => "pipe",
        })
    }
}

/// A number of bytes, in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size(pub u64);

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 >> 30 {
            0 => write!(f, "{} MiB", self.0 >> 20),
            gib => write!(f, "{gib} GiB"),
        }
    }
}

impl FileFault {
    /// This, at a path.
    pub(super) fn at(self, path: &Path) -> anyhow::Error {
        FileError { fault: self, path: path.to_owned() }.into()
    }
}

impl From<&io::Error> for FileFault {
    fn from(error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::NotFound => Self::NotFound,
            io::ErrorKind::PermissionDenied => Self::Denied,
            io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => Self::Full,
            io::ErrorKind::ReadOnlyFilesystem => Self::NoFileHere,
            io::ErrorKind::InvalidFilename => Self::NameTooLong,
            io::ErrorKind::NotADirectory => Self::FileAsFolder,
            // The number of the system's error helps nobody.
            _ => {
                let told = error.to_string();
                Self::System(told.split(" (os error").next().unwrap_or_default().to_owned())
            }
        }
    }
}
