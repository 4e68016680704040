//! Fingerprints of files.

use sha2::{Digest, Sha256};
use std::fmt::Write;

/// Fingerprint of `bytes` as scenarios store it: `sha256:` and 64 hexadecimal
/// digits [FIPS 180-4].
///
/// ```
/// assert!(octoscope_import::hash(b"abc").starts_with("sha256:ba7816bf8f01cfea"));
/// ```
pub fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold("sha256:".to_owned(), |mut text, byte| {
        write!(text, "{byte:02x}").expect("writing to a string cannot fail");
        text
    })
}
