//! Scenario files: what is written is read back, and what is wrong is named.

use octoscope_core::geometry::{Aabb, Ray};
use octoscope_core::locate::{Direction, NeighbourMethod, Reach};
use octoscope_core::query::{PointMethod, Query};
use octoscope_core::random::Random;
use octoscope_core::scenario::{AnyScenario, BUILT_IN, Scenario, Source, StepAt, built_in};
use octoscope_core::scene::{Content, Cube, Image, Sphere};
use octoscope_core::traverse::{Algorithm, Variant};
use serde_json::{Value, json};

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
        scenario.domain = Cube { min: [-1.0, 0.1, 2.5], side: 3.7 };
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
        Query::Point { at: [0.1, -0.0], method: PointMethod::Comparison },
        Query::Region { min: [0.1, 0.2], max: [0.3, 0.4] },
        Query::Neighbour {
            level: 2,
            code: [4, 8],
            direction: Direction::new([-1, 1]).unwrap(),
            reach: Reach::Leaf,
            method: NeighbourMethod::Tables,
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

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let with = |fields: &str| {
        format!("{{\"octoscope\": 1, \"dimension\": 2,\n\"scene\": {{\"points\": []}},\n{fields}}}")
    };
    refused(&with("\"raay\": 1"), &["unknown field `raay`", "line 3 column"]);
    refused(&with("\"build\": {\"deep\": 1}"), &["unknown field `deep`", "line 3"]);
    refused(&with("\"options\": {\"x\": 1}"), &["unknown field `x`", "line 3"]);
    refused(&with("\"query\": {\"point\": {\"at\": [0, 0], \"x\": 1}}"), &["unknown field `x`"]);
    refused(&with("\"build\": {\"depth\": 21}"), &["depth is 21", "0 to 20", "line 3"]);
    refused(&with("\"build\": {\"capacity\": 0}"), &["capacity is 0", "line 3"]);
    refused(&with("\"domain\": {\"min\": [0], \"side\": 1}"), &["length 1", "2 numbers", "line 3"]);
    refused(&with("\"domain\": {\"min\": [0, 0], \"side\": 0}"), &["side above 0", "line 3"]);
    refused(&with("\"domain\": {\"min\": [NaN, 0], \"side\": 1}"), &["line 3"]);
    refused(&with("\"domain\": {\"min\": [1e999, 0], \"side\": 1}"), &["out of range", "line 3"]);
    let ray = |d: &str| with(&format!("\"ray\": {{\"origin\": [0, 0], \"direction\": {d}}}"));
    refused(&ray("[0, -0.0]"), &["direction of the ray is zero", "line 3"]);
    refused(&ray("[1, 2, 3]"), &["length 3", "2 numbers"]);
    refused(&with("\"algorithm\": \"magic\""), &["magic", "parametric-table", "line 3"]);
    refused(&with("\"step\": \"middle\""), &["middle", "first", "line 3"]);
    refused(r#"{"octoscope": 2, "what": 1, "scene": {}}"#, &["version 2", "newer"]);
    refused(r#"{"octoscope": 1, "dimension": 4, "scene": {}}"#, &["dimension is 4"]);
    refused(r#"{"octoscope": 1, "dimension": 2}"#, &["missing field `scene`"]);
    refused(r#"{"octoscope": 1, "dimension": 2, "scene": {}}"#, &["0 kinds"]);
    refused(r#"{"octoscope": 1, "scene": {"built-in": "fog"}}"#, &["fog", "cloud"]);
    refused(
        r#"{"octoscope": 1, "scene": {"built-in": "rings", "parameters": {"seed": 1}}}"#,
        &["‘rings’ has no parameter ‘seed’"],
    );
    refused("{\"octoscope\": 1,\n", &["line 2"]);
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
    let scene = names(&properties["scene"]["properties"]).join("`, `");
    let text = r#"{"octoscope": 1, "dimension": 2, "scene": {"x": 1}}"#;
    let message = AnyScenario::parse(text).expect_err(text).to_string();
    for name in scene.split("`, `") {
        assert!(message.contains(name), "{name} in {message}");
    }
    assert_eq!(message.matches('`').count() / 2 - 1, scene.split("`, `").count());
}

#[test]
fn the_schema_knows_every_algorithm_and_every_variant() {
    let schema = include_str!("../../../assets/schemas/octo.schema.json");
    let schema: Value = serde_json::from_str(schema).unwrap();
    let properties = &schema["properties"];
    assert_eq!(properties["algorithm"]["enum"], json!(Algorithm::ALL.map(Algorithm::id)));
    let variants = &properties["options"]["properties"]["variants"]["items"]["enum"];
    assert_eq!(*variants, json!(Variant::ALL.map(Variant::id)));
}
