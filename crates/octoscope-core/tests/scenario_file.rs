//! Scenario files: what is written is read back, and what is wrong is named.

use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, Scenario, Source, StepAt, built_in};
use octoscope_core::scene::{Content, Cube, Image, Sphere};
use octoscope_core::traverse::{Algorithm, Variant, Variants};
use serde_json::{Value, json};
use std::collections::BTreeSet;

fn reads_back(scenario: AnyScenario) {
    let text = scenario.print();
    assert_eq!(AnyScenario::parse(&text), Ok(scenario), "{text}");
}

fn refused(text: &str, parts: &[&str]) {
    let message = AnyScenario::parse(text).expect_err(text).to_string();
    for part in parts {
        assert!(message.contains(part), "‘{part}’ is not in: {message}");
    }
}

#[test]
fn built_in_scenarios_read_back() {
    for entry in BUILT_IN {
        reads_back(built_in(entry.id).unwrap());
    }
}

#[test]
fn every_kind_of_content_reads_back() {
    let mut random = Random::new(5);
    let mut point = || [(); 3].map(|()| f64::from_bits(random.bits() >> 2 | 1 << 61));
    let corners = Aabb { min: [-0.0, 0.1, -1e300], max: [1.0, 5e-324, 1e22] };
    let contents = [
        Content::Points((0..200).map(|_| point()).collect()),
        Content::Cells(vec![[0, 1, 2], [7, 0, 0]]),
        Content::Spheres(vec![Sphere { centre: point(), radius: 0.3 }]),
        Content::Boxes(vec![Aabb { max: [1.0, 0.2, 0.0], ..corners }]),
        Content::Triangles(vec![[point(), point(), [0.1; 3]]]),
        Content::Points(Vec::new()),
    ];
    for content in contents {
        let mut scenario = Scenario::of(Source::Inline(content.clone()), &content);
        scenario.domain = Cube { min: [-1.0, -0.1, -1.5], side: 3.7 };
        reads_back(AnyScenario::Octree(scenario));
    }
    let pixels = vec![[0, 0, 0], [1, 2, 3], [255; 3], [254, 254, 254]];
    let content = Content::Image(Image { width: 4, height: 1, pixels });
    let scenario = Scenario::of(Source::Inline(content.clone()), &content);
    reads_back(AnyScenario::Quadtree(scenario));
}

#[test]
fn every_query_and_a_file_read_back() {
    let queries = [
        Query::Point { at: [0.1, -0.0], method: PointMethod::Comparison, variants: Variants::NONE },
        Query::Region {
            min: [0.1, 0.2],
            max: [0.3, 0.4],
            variants: Variants::NONE.with(Variant::B24a).with(Variant::B24c),
        },
        Query::Neighbour {
            level: 2,
            code: [4, 8],
            direction: Direction::new([-1, 1]).unwrap(),
            reach: Reach::Leaf,
            method: NeighbourMethod::Tables,
            variants: Variants::NONE,
        },
        Query::default(),
    ];
    for (i, query) in queries.into_iter().enumerate() {
        let (path, hash) = ("a “mesh”.ply".to_owned(), "12ab".to_owned());
        let source = Source::File { path, hash, fit: i > 0 };
        let content = Content::Points(Vec::new());
        let mut scenario = Scenario { query, ..Scenario::of(source, &content) };
        scenario.step = [StepAt::At(7), StepAt::Last, StepAt::First][i % 3];
        scenario.ray = Ray::new([0.1, 0.2], [-0.0, 1e-9]).unwrap();
        scenario.view.insert("theme".to_owned(), Value::from("dark"));
        reads_back(AnyScenario::Quadtree(scenario));
    }
}

#[test]
fn little_is_needed() {
    let text = r#"{"octoscope": 1, "scene": {"built-in": "cloud"}}"#;
    assert_eq!(AnyScenario::parse(text).ok(), built_in("cloud"));
    let text = r#"{"octoscope": 1, "dimension": 2, "scene": {"points": [[3, 4], [5, 6]]}}"#;
    let Ok(AnyScenario::Quadtree(scenario)) = AnyScenario::parse(text) else { panic!("{text}") };
    assert!(scenario.grid().unwrap().root_box().owns([5.0, 6.0]));
}

#[test]
fn a_file_without_a_domain_is_fitted_later() {
    let text = r#"{"octoscope": 1, "dimension": 2, "scene": {"file": "a.xyz"}}"#;
    let Ok(AnyScenario::Quadtree(mut scenario)) = AnyScenario::parse(text) else {
        panic!("{text}")
    };
    scenario.fit_to(&Content::Points(vec![[30.0, 40.0], [50.0, 60.0]]));
    assert!(scenario.grid().unwrap().root_box().owns([50.0, 60.0]));
    assert!(matches!(scenario.source, Source::File { fit: false, .. }));
}

/// Checks the message of a scenario of points with these further fields, which
/// begin in line 3.
#[track_caller]
fn refused_with(fields: &str, message: &str) {
    let text = format!(
        "{{\"octoscope\": 1, \"dimension\": 2,\n\"scene\": {{\"points\": []}},\n{fields}}}"
    );
    assert_eq!(AnyScenario::parse(&text).expect_err(fields).to_string(), message);
}

#[test]
fn unknown_fields_are_told_with_the_nearest_known_one() {
    refused_with(
        r#""raay": 1"#,
        "line 3, column 1: there is no field ‘raay’ here; write ‘ray’, or one of octoscope, \
         dimension, domain, scene, build, ray, query, algorithm, options, arithmetic, step, view",
    );
    refused_with(
        r#""build": {"deph": 1}"#,
        "line 3, column 11: there is no field ‘deph’ here; write ‘depth’, or one of depth, \
         capacity, merge, threshold, fill",
    );
    let at = "there is no field ‘x’ here; there are at, method, variants";
    refused_with(
        r#""query": {"point": {"at": [0, 0], "x": 1}}"#,
        &format!("line 3, column 35: {at}"),
    );
    refused_with(
        r#""query": {"kind": "ray"}"#,
        "line 3, column 11: there is no field ‘kind’ here; there are ray, point, region, neighbour",
    );
    refused_with(
        r#""query": {"ray": {"origin": [0, 0]}}"#,
        "line 3, column 11: ‘query.ray’ is not written so; write \"query\": \"ray\"; its numbers go \
         into the field \"ray\" beside it",
    );
    refused_with(
        r#""options": {"x": 1}"#,
        "line 3, column 13: there is no field ‘x’ here; there are stop-at, segment-end, variants",
    );
}

#[test]
fn values_that_do_not_fit_are_told_with_what_would() {
    let numbers = "write 2 numbers in brackets, one for each axis";
    let check =
        |fields: &str, message: &str| refused_with(fields, &format!("line 3, column {message}"));
    check(
        r#""build": {"depth": "x"}"#,
        "20: ‘build.depth’ is \"x\"; write a whole number from 0 to 20",
    );
    check(
        r#""build": {"depth": 21}"#,
        "20: 21 is above 20, the number of bits of codes; give a number from 0 to 20",
    );
    check(
        r#""build": {"depth": 1.5}"#,
        "20: ‘build.depth’ is 1.5; write a whole number from 0 to 20",
    );
    check(r#""build": {"capacity": 0}"#, "23: the capacity is 0; give 1 or more");
    check(
        r#""domain": {"min": [0], "side": 1}"#,
        &format!("19: ‘domain.min’ is [0], \"side\": 1}}}}; {numbers}"),
    );
    check(
        r#""domain": {"min": [0, 0], "side": 0}"#,
        "11: the domain needs finite corners and a side above 0",
    );
    check(
        r#""domain": {"min": [0, 0]}"#,
        "11: the field ‘side’ is missing; write a number above 0",
    );
    check(
        r#""domain": {"min": [NaN, 0], "side": 1}"#,
        "20: NaN is no value; write a finite number or a text in quotes",
    );
    check(
        r#""domain": {"min": [1e999, 0], "side": 1}"#,
        "20: 1e999 is no number; write one below 1e308, such as -0.25",
    );
    let ray = r#""ray": {"origin": [0, 0], "direction": "#;
    check(
        &format!("{ray}[0, -0.0]}}"),
        "40: the direction of the ray is zero; give at least one component another value",
    );
    check(
        &format!("{ray}[1, \"a\"]}}"),
        "44: ‘ray.direction[1]’ is \"a\"; write 2 numbers in brackets, one for each axis, not all of them 0",
    );
    check(
        r#""algorithm": "paramtric""#,
        &format!(
            "14: ‘algorithm’ is \"paramtric\"; write ‘parametric’, or one of {}",
            Algorithm::ALL.map(Algorithm::id).join(", ")
        ),
    );
    check(
        r#""step": "middle""#,
        "9: ‘step’ is \"middle\"; write \"first\", \"last\" or a whole number from 0",
    );
    check(r#""step": 1, "step": 2"#, "12: the field ‘step’ is there twice; take one away");
}

#[test]
fn what_is_no_json_is_told_with_what_would_be() {
    let check = |text: &str, message: &str| {
        assert_eq!(AnyScenario::parse(text).expect_err(text).to_string(), message);
    };
    let least = r#"{"octoscope": 1, "scene": {"built-in": "cloud"}}"#;
    check(" \n", &format!("line 1, column 1: the text is empty; write {least} at least"));
    check(
        "[1, 2]",
        &format!("line 1, column 1: this is no scenario; write an object such as {least}"),
    );
    check(
        "{\"octoscope\": 1,\n",
        "line 1, column 17: the text ends where a value is due; write what is missing",
    );
    check(
        "{\"octoscope\": 1",
        "line 1, column 16: the text ends within an object; close it with }",
    );
    check(
        "{\"octoscope\": \"1",
        "line 1, column 17: the text ends within quotation marks; close them",
    );
    check(
        "{\"ä\": 1,}",
        "line 1, column 9: a comma stands before the closing bracket; take it away",
    );
    check(
        "{\"ä\": 1\n \"b\": 2}",
        "line 2, column 2: a comma is missing before \"b\", or a }; write what is due",
    );
    check("{\"ä\" 1}", "line 1, column 6: a colon is missing before 1; write \"name\": value");
    check(
        "{octoscope: 1}",
        "line 1, column 2: octoscope is no name of a field; write the name in quotation marks",
    );
    check(
        "{\"ä\": True}",
        "line 1, column 7: True is no value; write a finite number or a text in quotes",
    );
    check(
        "{\"octoscope\": 1} x",
        "line 1, column 18: x follows the end of the scenario; take it away",
    );
    let deep = format!("{{\"a\": {}{}}}", "[".repeat(200), "]".repeat(200));
    let text = format!(r#"{{"octoscope": 1, "scene": {{"built-in": "cloud"}}, "view": {deep}}}"#);
    refused(&text, &["nested more than 127 deep"]);
}

#[test]
fn what_is_wrong_with_the_whole_is_told_with_its_place() {
    let check = |text: &str, message: &str| {
        assert_eq!(AnyScenario::parse(text).expect_err(text).to_string(), message);
    };
    check(
        r#"{"what": 1, "scene": 7, "octoscope": 2}"#,
        "line 1, column 38: the scenario has version 2, this program reads up to 1; use a newer program",
    );
    refused(r#"{"octoscope": 0, "scene": {}}"#, &["line 1, column 15", "no version 0", "write 1"]);
    refused(r#"{"octoscope": "1"}"#, &["line 1, column 15", "‘octoscope’ is \"1\"", "write 1"]);
    refused(r#"{"scene": {}}"#, &["line 1, column 1", "‘octoscope’ is missing", "write 1"]);
    refused(r#"{"octoscope": 1, "dimension": 4, "scene": {}}"#, &["column 31", "dimension is 4"]);
    refused(
        r#"{"octoscope": 1, "scene": {"points": []}}"#,
        &["column 1:", "‘dimension’ is missing"],
    );
    refused(
        r#"{"octoscope": 1, "dimension": 2}"#,
        &["column 1:", "‘scene’ is missing", "built-in"],
    );
    refused(r#"{"octoscope": 1, "dimension": 2, "scene": {}}"#, &["column 43", "0 kinds"]);
    refused(r#"{"octoscope": 1, "scene": {"built-in": "fog"}}"#, &["column 40", "fog", "cloud"]);
    refused(
        r#"{"octoscope": 1, "scene": {"built-in": "rings", "parameters": {"seed": 1}}}"#,
        &["column 72", "‘rings’ has no parameter ‘seed’"],
    );
    refused(
        r#"{"octoscope": 1, "scene": {"built-in": "rings", "parameters": {"n": 1e3}}}"#,
        &["column 69", "‘scene.parameters.n’ is 1e3", "from 1 to 4096, in digits alone"],
    );
    refused(
        r#"{"octoscope": 1, "scene": {"built-in": "figure-1", "parameters": {"n": "a"}}}"#,
        &["write a whole number from 1, in digits alone"],
    );
    let scene = |scene| format!(r#"{{"octoscope": 1, "dimension": 2, "scene": {{{scene}}}}}"#);
    refused(
        &scene(r#""spheres": [{"centre": [0, 0], "radius": 1}, {"centre": [0, 0], "radius": -1}]"#),
        &["column 89", "negative size"],
    );
    refused(
        &scene(r#""image": {"width": 2, "height": 1, "rows": ["00"]}"#),
        &["column 88", "row 1 of the picture"],
    );
    for image in [
        r#""image": {"width": 4294967295, "height": 0, "rows": []}"#,
        r#""image": {"width": 0, "height": 1, "rows": [""]}"#,
    ] {
        refused(&scene(image), &["column 53", "the picture has no pixels"]);
    }
    refused(&scene(r#""points": [], "hash": "x""#), &["column 66", "‘hash’ goes only with ‘file’"]);
}

#[test]
fn damage_anywhere_is_told_with_a_place() {
    let check = |text: &str| {
        let Err(error) = AnyScenario::parse(text) else { return 0 };
        let message = error.to_string();
        assert!(message.starts_with("line ") && message.len() > 25, "{message}: {text}");
        assert!(!message.contains(" at line ") && !message.contains('`'), "{message}: {text}");
        1
    };
    let mut n_refused = 0;
    for entry in BUILT_IN {
        let text = built_in(entry.id).unwrap().print();
        for i in 0..text.len() {
            n_refused += check(&text[..i]);
            for other in ["ä", "\"", "{", "]", ",", "\n", "-", "e", ""] {
                n_refused += check(&format!("{}{other}{}", &text[..i], &text[i + 1..]));
            }
        }
    }
    assert!(n_refused > 10_000, "{n_refused}");
}

/// Names of the fields of an object.
fn names(value: &Value) -> Vec<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

#[test]
fn the_schema_has_exactly_the_fields_of_a_file() {
    let schema = include_str!("../../../assets/schemas/octo.schema.json");
    let schema: Value = serde_json::from_str(schema).unwrap();
    let properties = &schema["properties"];
    for entry in BUILT_IN {
        let file: Value = serde_json::from_str(&built_in(entry.id).unwrap().print()).unwrap();
        let fields = names(&file);
        let rays = ["algorithm", "options", "arithmetic"];
        let expected: Vec<&str> = names(properties)
            .into_iter()
            .filter(|name| file["query"] == "ray" || !rays.contains(name))
            .collect();
        assert_eq!(fields, expected);
        for part in ["domain", "build", "ray"] {
            assert_eq!(names(&file[part]), names(&properties[part]["properties"]), "{part}");
        }
    }
    let text = r#"{"octoscope": 1, "dimension": 2, "scene": {"x": 1}}"#;
    let message = AnyScenario::parse(text).expect_err(text).to_string();
    let (_, listed) = message.split_once("there are ").expect("a list");
    let listed: BTreeSet<&str> = listed.split(", ").collect();
    assert_eq!(listed, names(&properties["scene"]["properties"]).into_iter().collect());
}

#[test]
fn the_schema_knows_every_algorithm_and_every_variant() {
    let schema = include_str!("../../../assets/schemas/octo.schema.json");
    let schema: Value = serde_json::from_str(schema).unwrap();
    let properties = &schema["properties"];
    assert_eq!(properties["algorithm"]["enum"], json!(Algorithm::ALL.map(Algorithm::id)));
    let variants = &properties["options"]["properties"]["variants"]["items"]["enum"];
    assert_eq!(*variants, json!(Variant::ALL.map(Variant::id)));

    let variants = Variants::NONE;
    let (level, code, reach) = (0, [0; 2], Reach::default());
    let (direction, method) = (Direction::new([1, 0]).unwrap(), NeighbourMethod::Codes);
    for (kind, query) in [
        ("point", Query::Point { at: [0.0; 2], method: PointMethod::Codes, variants }),
        ("region", Query::Region { min: [0.0; 2], max: [0.0; 2], variants }),
        ("neighbour", Query::Neighbour { level, code, direction, reach, method, variants }),
    ] {
        let own = Variant::ALL.into_iter().filter(|&variant| query.takes(variant));
        let own: Vec<_> = own.map(Variant::id).collect();
        let kinds = properties["query"]["oneOf"].as_array().unwrap();
        let fields = kinds.iter().find_map(|k| k["properties"].get(kind)).unwrap();
        assert_eq!(fields["properties"]["variants"]["items"]["enum"], json!(own), "{kind}");
    }
}
