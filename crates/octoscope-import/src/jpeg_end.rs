//! Whether a JPEG is whole: decoders paint what is missing grey.

/// Whether the segments of the JPEG in `bytes` go on up to the marker of its
/// end; what follows it does not matter. O(n) [ITU T.81, annex B].
///
/// A thumbnail inside has an end of its own, which does not count.
pub fn jpeg_is_whole(bytes: &[u8]) -> bool {
    let mut rest = bytes;
    while let Some(start) = rest.windows(2).position(|pair| is_marker([pair[0], pair[1]])) {
        let marker = rest[start + 1];
        rest = &rest[start + 2..];
        match marker {
            END => return true,
            START => {}
            // A segment with its length; the scan behind it has no markers but
            // restarts, and is searched for the next one.
            _ => {
                let Some(&[high, low]) = rest.first_chunk() else { return false };
                let Some(behind) = rest.get(usize::from(u16::from_be_bytes([high, low]))..) else {
                    return false;
                };
                rest = behind;
            }
        }
    }
    false
}

const START: u8 = 0xd8;
const END: u8 = 0xd9;

/// Whether two bytes begin a segment or the end: neither a byte 0xff of a scan
/// (0 follows), nor filling, nor a restart within a scan.
fn is_marker([first, second]: [u8; 2]) -> bool {
    first == 0xff && !matches!(second, 0 | 1 | 0xff | 0xd0..=0xd7)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(bytes: &[u8], whole: bool) {
        assert_eq!(jpeg_is_whole(bytes), whole);
    }

    #[test]
    fn only_the_end_of_the_picture_itself_counts() {
        check(b"\xff\xd8\xff\xda\0\x03.scan\xff\0\xff\xd0scan\xff\xd9", true);
        check(b"\xff\xd8\xff\xda\0\x03.scan\xff\0\xff\xd0scan\xff", false);
        check(b"\xff\xd8\xff\xda\0\x03.scan\xff\xd9 trailer", true);
        // A thumbnail with start and end, inside a segment.
        check(b"\xff\xd8\xff\xe1\0\x06\xff\xd8\xff\xd9", false);
        check(b"\xff\xd8\xff\xe1\0\x06\xff\xd8\xff\xd9\xff\xd9", true);
        check(b"\xff\xd8\xff\xe1\0", false);
        check(b"\xff\xd8\xff\xe1\xff\xff\xff\xd9", false);
    }
}
