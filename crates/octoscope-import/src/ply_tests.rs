use super::*;

const HEAD: &str = "comment made by hand\nelement vertex 4\nproperty float x\nproperty uchar red\nproperty double y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

fn text() -> String {
    format!("ply\nformat ascii 1.0\n{HEAD}0 9 0 0\n1 9 0 0\n1 9 1 0\n0 9 1 0\n4 0 1 2 3\n")
}

fn binary(encoding: &str, order: impl Fn(&mut [u8])) -> Vec<u8> {
    let mut bytes = format!("ply\nformat {encoding} 1.0\n{HEAD}").into_bytes();
    let mut put = |mut number: Vec<u8>| {
        order(&mut number);
        bytes.extend(number);
    };
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        put((x as f32).to_le_bytes().to_vec());
        put(vec![9]);
        put(f64::to_le_bytes(y).to_vec());
        put(0f32.to_le_bytes().to_vec());
    }
    put(vec![4]);
    for index in 0..4i32 {
        put(index.to_le_bytes().to_vec());
    }
    bytes
}

fn read_quietly(bytes: &[u8]) -> Result<Shape, ImportError> {
    read(bytes, &Progress::default())
}

#[test]
fn all_three_encodings_hold_the_same_square() {
    let [a, b, c, d] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let square = Ok(Shape::Triangles(vec![[a, b, c], [a, c, d]]));
    assert_eq!(read_quietly(text().as_bytes()), square);
    assert_eq!(read_quietly(text().replace('\n', "\r\n").as_bytes()), square);
    assert_eq!(read_quietly(&binary("binary_little_endian", |_| ())), square);
    assert_eq!(read_quietly(&binary("binary_big_endian", <[u8]>::reverse)), square);
}

#[test]
fn vertices_without_faces_are_points() {
    let cloud = text().replace("element face 1", "element face 0").replace("4 0 1 2 3\n", "");
    assert!(matches!(read_quietly(cloud.as_bytes()), Ok(Shape::Points(p)) if p.len() == 4));
}

#[test]
fn other_elements_are_passed_over() {
    let other = text()
        .replace(
            "element face",
            "element edge 2\nproperty list int float weights\nproperty int a\nelement face",
        )
        .replace("4 0 1 2 3", "0 7\n2 .5 nan 7\n4 0 1 2 3");
    assert_eq!(read_quietly(other.as_bytes()), read_quietly(text().as_bytes()));
}

#[track_caller]
fn check(from: &str, to: &str, message: &str) {
    assert!(text().contains(from), "the pattern must be there");
    let error = read_quietly(text().replace(from, to).as_bytes()).expect_err("refused");
    assert_eq!(error.to_string(), message);
}

#[test]
fn mistakes_are_told_with_line_and_column() {
    check(
        "4 0 1 2 3",
        "4 0 1 2 4",
        "line 16, column 9: vertex 4 is not among the 4; number the vertices from 0 and put them before the faces",
    );
    check("4 0 1 2 3", "2 0 1", "line 16, column 5: the face has 2 corners; give it at least 3");
    check(
        "4 0 1 2 3",
        "4 0 1",
        "line 16, column 5: the file ends behind this, where more numbers are due; fetch the file again",
    );
    check(
        "4 0 1 2 3",
        "-4 0 1",
        "line 16, column 1: a list cannot have -4 items; write a whole number from 0",
    );
    check(
        "1 9 1 0",
        "1 9 inf 0",
        "line 14, column 5: a coordinate of vertex 2 is not finite; repair the file where it was made",
    );
    check(
        "1 9 1 0",
        "1 9 a 0",
        "line 14, column 5: “a” is not a number; write a number such as -1.25 or 3e-4",
    );
    check(
        "property double y\n",
        "",
        "line 4, column 16: the vertices lack one of the properties x, y and z; add what is missing",
    );
    check(
        "vertex_indices",
        "corners",
        "line 9, column 14: the faces lack the list vertex_indices; add it, or leave the faces out",
    );
    check(
        "end_header",
        "end",
        "line 11, column 1: “end” is no complete line of a PLY header; write format, comment, element, property or end_header",
    );
    check(
        "property double",
        "property real",
        "line 7, column 10: “real” is no type of PLY; write char, uchar, short, ushort, int, uint, float or double",
    );
    check(
        "ascii",
        "ASCII",
        "line 2, column 8: “ASCII” is no format of PLY; write ascii, binary_little_endian or binary_big_endian",
    );
    check(
        "vertex 4",
        "vertex many",
        "line 4, column 16: “many” is not a number of rows; write a whole number from 0",
    );
    check(
        "format ascii 1.0\n",
        "",
        "line 10, column 1: the header names no format; add “format ascii 1.0” or one of the binary formats",
    );
}

#[test]
fn counts_beyond_the_file_are_refused_before_anything_is_read() {
    check(
        "vertex 4",
        "vertex 18446744073709551615",
        "line 4, column 16: 18446744073709551615 rows are announced, which take 18446744073709551615 bytes or more, but 42 follow; fetch the file again",
    );
    check(
        "property list uchar int vertex_indices\n",
        "",
        "line 9, column 14: an element with rows has no properties; give it properties or 0 rows",
    );
}

#[test]
fn headers_without_an_end_are_refused() {
    let error = read_quietly(b"ply\nformat ascii 1.0\n").expect_err("refused");
    assert_eq!(
        error.to_string(),
        "line 3, column 1: the file ends before “end_header”; fetch the file again"
    );
}
