//! Files that are not what they should be.

use crate::desk::{Desk, VISIT, text};
use std::fs;

/// What `octoscope check` says of a file that is bad.
#[track_caller]
fn bad(desk: &Desk, name: &str) -> String {
    let output = desk.run(&format!("check {name}"));
    assert_eq!(output.status.code(), Some(1), "{name}");
    assert_eq!(text(&output.stderr), "octoscope: the file is bad\n", "{name}");
    let report = text(&output.stdout);
    assert_eq!(report.lines().count(), 1, "{report}");
    let reason = report.strip_prefix(&format!("{name}: bad, ")).unwrap().trim_end();
    assert!(!reason.contains(name), "{report}");
    reason.to_owned()
}

#[test]
fn every_strange_file_has_one_message() {
    let desk = Desk::new();
    let put = |name: &str, bytes: &[u8]| fs::write(desk.0.path().join(name), bytes).unwrap();
    let png = include_bytes!("../../assets/scenes/landscape.png");
    let header = "element vertex 1000000000000\nproperty float x\nproperty float y\n\
                  property float z\nend_header\n";
    let binary_ply = format!("ply\nformat binary_big_endian 1.0\n{header}");
    let text_ply = format!("ply\nformat ascii 1.0\n{header}0 0 0");
    let all: [(&str, &[u8], &str); 13] = [
        ("a.xyz", b"", "the file is empty"),
        ("a.png", &png[..png.len() / 2], "the picture is damaged"),
        ("binary.ply", binary_ply.as_bytes(), "rows"),
        ("text.ply", text_ply.as_bytes(), "line 3, column 16"),
        ("a.obj", b"v 0 0 0\nv nan 1 0\n", "line 2, column 3"),
        ("a.csv", b"x,y,z\n", "holds no points"),
        ("utf16.xyz", b"\xff\xfe1\x002\x00", "save it in UTF-8"),
        ("utf16.octo", b"\xff\xfe{\0", "save it in UTF-8"),
        ("binary.octo", b"\x80\0\xff", "byte 0"),
        ("binary.xyz", b"\x80\0\xff", "binary data"),
        ("a.tiff", b"II*\0", ".octo"),
        ("gone.octo", br#"{"octoscope":1,"dimension":3,"scene":{"file":"no.xyz"}}"#, "no.xyz"),
        (
            "other.octo",
            br#"{"octoscope":1,"dimension":2,"scene":{"file":"a.csv","hash":"x"}}"#,
            "hash",
        ),
    ];
    for (name, bytes, _) in all {
        put(name, bytes);
    }
    for (name, _, part) in all {
        let reason = bad(&desk, name);
        assert!(reason.contains(part), "{name}: {reason}");
    }
    // A hole takes no room on the disk.
    let large = fs::File::create(desk.0.path().join("large.octo")).unwrap();
    large.set_len((256 << 20) + 1).unwrap();
    assert!(bad(&desk, "large.octo").contains("larger than 256 MiB"));
    fs::create_dir(desk.0.path().join("folder.xyz")).unwrap();
    assert_eq!(bad(&desk, "folder.xyz"), "this is a folder, not a file; choose a file");
}

#[test]
fn line_ends_and_byte_order_marks_of_all_systems_are_read() {
    let desk = Desk::new();
    desk.put("a.xyz", "0 0 0\n1 1 1\n");
    let report = desk.prints("check a.xyz");
    for text in ["0 0 0\r\n1 1 1\r\n", "0 0 0\r1 1 1\r", "\u{feff}0 0 0\n1 1 1"] {
        desk.put("a.xyz", text);
        assert_eq!(desk.prints("check a.xyz"), report, "{text:?}");
    }
    desk.put("a.octo", "\u{feff}{\"octoscope\":1,\r\n\"scene\":{\"built-in\":\"figure-1\"}}\r\n");
    desk.prints("check a.octo");
}

#[test]
#[cfg(unix)]
fn pipes_and_devices_neither_hang_nor_exhaust_memory() {
    let desk = Desk::new();
    let made = std::process::Command::new("mkfifo").arg(desk.0.path().join("pipe.xyz")).status();
    assert!(made.unwrap().success());
    assert!(bad(&desk, "pipe.xyz").starts_with("nobody writes into this pipe"));
    assert!(desk.refuses(&VISIT.replace("a.rays", "/dev/zero")).contains("more than 64 MiB"));
    // A pipe that somebody writes into is as good as a file.
    let path = desk.0.path().join("pipe.xyz");
    let writer = std::thread::spawn(move || fs::write(path, "0 0 0\n1 1 1\n"));
    assert!(desk.prints("check pipe.xyz").contains("2 points"));
    writer.join().unwrap().unwrap();
}

#[test]
#[cfg(target_os = "linux")]
fn without_a_display_what_is_wrong_with_the_file_comes_first() {
    let desk = Desk::new();
    desk.put("bad.octo", "{");
    for (name, fact) in [
        ("nope.octo", "there is no such file or folder: nope.octo\n"),
        ("bad.octo", "line 1, column 2: the text ends within an object"),
        ("scene:figure-1", "no window can be opened"),
    ] {
        let message = desk.refuses(name);
        assert!(message.starts_with(&format!("octoscope: {fact}")), "{message}");
        assert!(message.contains("no window can be opened"), "{message}");
    }
}
