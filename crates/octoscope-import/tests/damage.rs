//! Damaged files give an error or a smaller content, never a panic.

use octoscope_core::progress::Progress;
use octoscope_core::random::Random;
use octoscope_import::import;
use std::io::Cursor;

fn picture(format: image::ImageFormat) -> Vec<u8> {
    let image = image::RgbImage::from_fn(9, 7, |x, y| image::Rgb([x as u8 * 20, y as u8 * 30, 99]));
    let mut file = Cursor::new(Vec::new());
    image.write_to(&mut file, format).expect("a small picture can be written");
    file.into_inner()
}

fn binary_stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(2u32.to_le_bytes());
    for i in 0..2 {
        bytes.extend((0..12).flat_map(|k| (k as f32 + i as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn binary_ply() -> Vec<u8> {
    let mut bytes = b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n".to_vec();
    bytes.extend((0..9).flat_map(|k| (k as f32).to_le_bytes()));
    bytes.push(3);
    bytes.extend((0..3i32).flat_map(i32::to_le_bytes));
    bytes
}

fn files() -> Vec<(&'static str, Vec<u8>)> {
    let text_ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    vec![
        ("a.png", picture(image::ImageFormat::Png)),
        ("a.jpg", picture(image::ImageFormat::Jpeg)),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2//2 -1\n".to_vec()),
        ("text.stl", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n".to_vec()),
        ("binary.stl", binary_stl()),
        ("text.ply", text_ply.into()),
        ("binary.ply", binary_ply()),
        ("a.xyz", "# ä\n0 0 0\n1, 2, 3\n".into()),
        ("a.csv", b"x;y;z\n1;2;3\n\"4\";5;6\n".to_vec()),
    ]
}

#[test]
fn whole_files_are_read() {
    for (name, bytes) in files() {
        let read = import(name, &bytes, &Progress::default());
        assert!(read.is_ok(), "{name}: {read:?}");
    }
}

#[test]
fn files_cut_at_any_byte_do_not_panic() {
    for (name, bytes) in files() {
        for length in 0..bytes.len() {
            let read = import(name, &bytes[..length], &Progress::default());
            assert!(length > 0 || read.is_err(), "{name}");
            let binary = name.starts_with("binary") || name == "a.jpg";
            if binary || name == "a.png" && length < bytes.len() - 12 {
                assert!(read.is_err(), "{name} of {length} bytes: {read:?}");
            }
        }
    }
}

#[test]
fn files_with_changed_bytes_do_not_panic() {
    let mut random = Random::new(5);
    for (name, bytes) in files() {
        for _ in 0..1000 {
            let mut damaged = bytes.clone();
            for _ in 0..=random.below(3) {
                let i = random.below(damaged.len() as u64) as usize;
                damaged[i] = random.bits() as u8;
            }
            if let Err(error) = import(name, &damaged, &Progress::default()) {
                assert!(!error.to_string().is_empty());
            }
        }
    }
}

#[test]
fn huge_pictures_are_refused_before_they_are_decoded() {
    let mut bytes = picture(image::ImageFormat::Png);
    bytes[16..24].copy_from_slice(&[0, 1, 0x86, 0xa0, 0, 1, 0x86, 0xa0]);
    // The check sum of the header, CRC-32 bit by bit.
    let crc = !bytes[12..29].iter().fold(u32::MAX, |crc, &b| {
        (0..8).fold(crc ^ u32::from(b), |c, _| c >> 1 ^ if c & 1 == 1 { 0xedb8_8320 } else { 0 })
    });
    bytes[29..33].copy_from_slice(&crc.to_be_bytes());
    let error = import("huge.png", &bytes, &Progress::default()).expect_err("refused");
    assert_eq!(
        error.to_string(),
        "the file holds 10000000000 pixels, more than 67108864; reduce it first"
    );
}

#[test]
fn cancelled_reading_ends() {
    let progress = Progress::default();
    progress.cancel();
    for (name, bytes) in files() {
        let error = import(name, &bytes, &progress).expect_err("cancelled");
        assert_eq!(error.to_string(), "cancelled", "{name}");
    }
}
