//! Reading files whole: no more than fits into memory, and not for ever.

use super::about;
use super::fault::{FileFault, Kind, Size};
use octoscope_core::progress::Progress;
use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// Longest file that is read, 2 GiB.
pub const MOST_BYTES: u64 = 2 << 30;

/// Most bytes that are read from a device, which may have no end, 64 MiB.
const MOST_BYTES_OF_A_DEVICE: u64 = 64 << 20;

/// Bytes between two looks at whether the result is still wanted.
const CHUNK: u64 = 1 << 20;

/// How long a named pipe may be without anybody who writes into it.
const PATIENCE: Duration = Duration::from_secs(3);

/// Bytes of the file at `path`, at most [`MOST_BYTES`]. Pipes are read to their
/// end.
///
/// # Errors
/// Says why it cannot be read, and its path.
pub fn read(path: &Path, progress: &Progress) -> anyhow::Result<Vec<u8>> {
    let found = fs::metadata(path).map_err(|error| about(path, &error))?;
    if found.is_dir() {
        return Err(FileFault::Folder.at(path));
    }
    if is_pipe(&found) {
        return read_pipe(path, progress);
    }
    let (kind, limit) = match found.is_file() {
        true => (Kind::File, MOST_BYTES),
        false => (Kind::Device, MOST_BYTES_OF_A_DEVICE),
    };
    if found.len() > limit {
        return Err(too_long(kind, limit, path));
    }
    let mut file = File::open(path).map_err(|error| about(path, &error))?;
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(found.len() as usize).map_err(|_| FileFault::NoMemory.at(path))?;
    progress.start(found.len());
    loop {
        let n = read_chunk(&mut file, &mut bytes).map_err(|error| about(path, &error))?;
        progress.advance(n as u64)?;
        if bytes.len() as u64 > limit {
            return Err(too_long(kind, limit, path));
        }
        if n == 0 {
            return Ok(bytes);
        }
    }
}

/// The bytes as text; a byte order mark is left out.
///
/// # Errors
/// Says where they are none.
pub fn as_text(bytes: &[u8]) -> anyhow::Result<&str> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Err(FileFault::Utf16.into());
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    std::str::from_utf8(text).map_err(|error| FileFault::NoText(error.valid_up_to()).into())
}

fn read_chunk(file: &mut File, bytes: &mut Vec<u8>) -> io::Result<usize> {
    file.take(CHUNK).read_to_end(bytes)
}

/// Reads on another thread, since nobody can tell how long that waits.
fn read_pipe(path: &Path, progress: &Progress) -> anyhow::Result<Vec<u8>> {
    let (sender, receiver) = sync_channel(4);
    let name = path.to_owned();
    thread::spawn(move || {
        if let Err(error) = send_chunks(&name, &sender) {
            // Nobody may be waiting any more.
            let _ = sender.send(Err(error));
        }
    });
    let started = Instant::now();
    let (mut opened, mut bytes) = (false, Vec::new());
    progress.start(0);
    loop {
        match receiver.recv_timeout(Duration::from_millis(50)) {
            Ok(chunk) => bytes.extend(chunk.map_err(|error| about(path, &error))?),
            Err(RecvTimeoutError::Timeout) if !opened && started.elapsed() > PATIENCE => {
                return Err(FileFault::NobodyWrites.at(path));
            }
            Err(RecvTimeoutError::Timeout) => {
                progress.check()?;
                continue;
            }
            Err(RecvTimeoutError::Disconnected) => return Ok(bytes),
        }
        opened = true;
        progress.check()?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(too_long(Kind::Pipe, MOST_BYTES, path));
        }
    }
}

/// Opens the pipe at `path` and sends what comes, first of all nothing.
fn send_chunks(path: &Path, sender: &SyncSender<io::Result<Vec<u8>>>) -> io::Result<()> {
    let mut pipe = File::open(path)?;
    let mut chunk = Vec::new();
    loop {
        let wanted = sender.send(Ok(std::mem::take(&mut chunk))).is_ok();
        if !wanted || read_chunk(&mut pipe, &mut chunk)? == 0 {
            return Ok(());
        }
    }
}

fn too_long(kind: Kind, limit: u64, path: &Path) -> anyhow::Error {
    FileFault::TooLong { kind, limit: Size(limit) }.at(path)
}

#[cfg(unix)]
fn is_pipe(found: &Metadata) -> bool {
    std::os::unix::fs::FileTypeExt::is_fifo(&found.file_type())
}

#[cfg(not(unix))]
fn is_pipe(_: &Metadata) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use octoscope_core::progress::Cancelled;

    #[track_caller]
    fn refused(path: &Path, fact: &str) {
        let message = read(path, &Progress::default()).unwrap_err().to_string();
        assert_eq!(message, format!("{fact}: {}", path.display()));
    }

    #[test]
    fn errors_end_with_the_path() {
        refused(Path::new("no/such.file"), "there is no such file or folder");
        let folder = tempfile::tempdir().unwrap();
        refused(folder.path(), "this is a folder, not a file; choose a file");
    }

    #[test]
    fn a_file_of_any_length_up_to_the_limit_is_read_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        for length in [0, 1, CHUNK as usize, CHUNK as usize + 1] {
            fs::write(&path, vec![7; length]).unwrap();
            let bytes = read(&path, &Progress::default()).unwrap();
            assert!(bytes == vec![7; length], "{length}");
        }
        // A hole takes no room on the disk.
        File::create(&path).unwrap().set_len(MOST_BYTES + 1).unwrap();
        refused(&path, "the file holds more than 2 GiB; reduce it first");
    }

    #[test]
    fn reading_can_be_cancelled() {
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), "text").unwrap();
        let progress = Progress::default();
        progress.cancel();
        assert!(read(file.path(), &progress).unwrap_err().is::<Cancelled>());
    }

    #[test]
    #[cfg(unix)]
    fn a_device_without_end_is_refused_and_an_empty_one_is_read() {
        let fact = "the device holds more than 64 MiB; reduce it first";
        refused(Path::new("/dev/zero"), fact);
        assert_eq!(read(Path::new("/dev/null"), &Progress::default()).unwrap(), b"");
    }

    #[test]
    fn what_is_no_text_is_told_with_its_place() {
        assert_eq!(as_text("ä".as_bytes()).unwrap(), "ä");
        let message = |bytes| as_text(bytes).unwrap_err().to_string();
        assert_eq!(message(b"ab\xff"), "byte 2 is no text; give a text in UTF-8");
        assert_eq!(message(b"\xff\xfea\0"), "the text is in UTF-16; save it in UTF-8");
    }
}
