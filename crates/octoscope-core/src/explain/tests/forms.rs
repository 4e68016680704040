//! What is said of rules in another form than the right one.

use super::*;

#[test]
fn the_gem_is_told_by_what_it_compared() {
    let gem = with(Algorithm::Bsp, Variant::Gem);
    let check = |origin, direction, expected| {
        check_words(&Ray::new(origin, direction).unwrap(), &gem, expected);
    };
    // In the plane, along it: 0/0.
    check(
        [0.5, -0.25],
        [0.0, 1.0],
        [
            "t_xm = NaN is no number, so that no comparison with 1.25, 0 or 0.25 holds: the gem takes both halves, first the lower x half; the other one waits on the stack.",
            "t_xm = NaN ist keine Zahl, sodass kein Vergleich mit 1.25, 0 oder 0.25 zutrifft: Das Gem nimmt beide Hälften, zuerst die untere x-Hälfte; die andere wartet auf dem Stapel.",
        ],
    );
    // From the plane, away from it: −0, told as 0, is not less than 0.
    check(
        [0.5, 0.25],
        [-1.0, 0.0],
        [
            "t_xm = 0 is neither greater than 0.5 nor less than 0 or 0: the gem takes both halves, first the lower x half; the other one waits on the stack.",
            "t_xm = 0 ist weder größer als 0.5 noch kleiner als 0 oder 0: Das Gem nimmt beide Hälften, zuerst die untere x-Hälfte; die andere wartet auf dem Stapel.",
        ],
    );
    check(
        [0.75, 0.25],
        [1.0, 0.0],
        [
            "t_xm = −0.25 < 0: the gem takes the half on the side of the origin alone, the upper x half.",
            "t_xm = −0.25 < 0: Das Gem nimmt nur die Hälfte auf der Seite des Startpunkts, die obere x-Hälfte.",
        ],
    );
}

#[test]
fn the_first_sentence_tells_the_rules_in_another_form() {
    let ray = Ray::new([0.1, 0.2], [1.0, 0.0]).unwrap();
    check_words(
        &ray,
        &with(Algorithm::Bsp, Variant::Gem),
        [
            "A ray from (0.1, 0.2) along (1, 0) is followed through the quadtree by binary space partition. The halves are chosen by the comparisons of the gem.",
            "Ein Strahl von (0.1, 0.2) in Richtung (1, 0) wird mit binärer Raumteilung durch den Quadtree verfolgt. Die Hälften werden mit den Vergleichen des Gems gewählt.",
        ],
    );
}

#[test]
fn the_first_sentence_says_which_rules_are_taken_as_they_are_printed() {
    let ray = Ray::new([0.1, 0.2], [1.0, 0.0]).unwrap();
    let check = |variants, expected: [&str; 2]| {
        let options = Options { variants, ..Options::default() };
        let (algorithm, arithmetic) = (Algorithm::Parametric, Arithmetic::Doubles);
        let trace = record(&tree(3), &ray, &Query::Ray { algorithm, options, arithmetic });
        for (language, expected) in Language::ALL.into_iter().zip(expected) {
            let told = sentence(&tree(3), &ray, &trace, 0, language).plain();
            assert!(told.ends_with(expected), "{told}");
        }
    };
    let one = Variants::NONE.with(Variant::B3);
    check(one, ["Rule B-3 is taken as it is printed.", "Regel B-3 gilt, wie sie gedruckt ist."]);
    check(
        one.with(Variant::B5).with(Variant::OneByOne),
        [
            "Planes that are met at once are crossed one by one. Rules B-3 and B-5 are taken as they are printed.",
            "Ebenen, die zugleich getroffen werden, werden eine nach der anderen gekreuzt. Die Regeln B-3 und B-5 gelten, wie sie gedruckt sind.",
        ],
    );
}

#[test]
fn several_printed_rules_are_told_as_several() {
    let variants = Variants::NONE.with(Variant::B1).with(Variant::B10);
    let options = Options { variants, ..Options::default() };
    let (algorithm, arithmetic) = (Algorithm::ParametricTable, Arithmetic::Doubles);
    check_words(
        &Ray::new([-0.25, 0.125], [1.0, 0.25]).unwrap(),
        &Query::Ray { algorithm, options, arithmetic },
        [
            "By the printed rules, B-1 and B-10, the root is hit, from t = −0.5 to t = 3.5.",
            "Nach den gedruckten Regeln, B-1 und B-10, wird die Wurzel getroffen, von t = −0.5 bis t = 3.5.",
        ],
    );
}

#[test]
fn of_planes_met_at_once_the_one_that_counts_is_told() {
    let ray = Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap();
    check_words(
        &ray,
        &with(Algorithm::Dda, Variant::OneByOne),
        [
            "t_xMax = 0.375 = t_yMax = 0.375, so the ray crosses the x plane: on to cell (1, 0). Of equal parameters the first axis counts.",
            "t_xMax = 0.375 = t_yMax = 0.375, also kreuzt der Strahl die x-Ebene: weiter zu Zelle (1, 0). Von gleichen Parametern zählt die erste Achse.",
        ],
    );
    check_words(
        &ray,
        &along(Algorithm::ParametricTable),
        [
            "Child 0 is left at the y plane: t_ym = 0.75 = t_xm = 0.75, so the y bit is set: state 1. Of equal parameters the last axis counts.",
            "Kind 0 wird an der y-Ebene verlassen: t_ym = 0.75 = t_xm = 0.75, also wird das y-Bit 1: Zustand 1. Von gleichen Parametern zählt die letzte Achse.",
        ],
    );
}

#[test]
fn mid_planes_that_are_means_are_told_as_that() {
    check_words(
        &Ray::new([-0.25, 0.125], [1.0, 0.25]).unwrap(),
        &with(Algorithm::ParametricTable, Variant::Averaged),
        [
            "The ray meets the mid planes of the node at t_xm = 0.75 and t_ym = 1.5. These are the means of the parameters of the near and far planes.",
            "Der Strahl trifft die Mittelebenen des Knotens bei t_xm = 0.75 und t_ym = 1.5. Das sind die Mittel der Parameter der nahen und fernen Ebenen.",
        ],
    );
}

#[test]
fn equal_numbers_are_told_as_equal_whatever_they_are_compared_in() {
    let query = |arithmetic| Query::Ray {
        algorithm: Algorithm::ParametricTable,
        options: Options::default(),
        arithmetic,
    };
    for arithmetic in [Arithmetic::Doubles, Arithmetic::Exact] {
        check_words(
            &Ray::new([-0.25, -0.25], [1.0, 1.0]).unwrap(),
            &query(arithmetic),
            [
                "Child 0 is left at the y plane: t_ym = 0.75 = t_xm = 0.75, so the y bit is set: state 1. Of equal parameters the last axis counts.",
                "Kind 0 wird an der y-Ebene verlassen: t_ym = 0.75 = t_xm = 0.75, also wird das y-Bit 1: Zustand 1. Von gleichen Parametern zählt die letzte Achse.",
            ],
        );
        check_words(
            &Ray::new([-0.25, 0.25], [1.0, 1.0]).unwrap(),
            &query(arithmetic),
            [
                "t_ym = 0.25 = t_x0 = 0.25, so no bit is 1: the ray enters in state 0.",
                "t_ym = 0.25 = t_x0 = 0.25, also ist kein Bit gesetzt: Der Strahl tritt im Zustand 0 ein.",
            ],
        );
    }
}

#[test]
fn a_printed_rule_is_named_only_where_it_makes_a_difference() {
    let beyond = Ray::new([2.0, 2.0], [1.0, 1.0]).unwrap();
    check_words(
        &beyond,
        &with(Algorithm::ParametricTable, Variant::B1),
        [
            "By the printed rule, B-1, the root is missed, with t_min = −2 and t_max = −1.",
            "Nach der gedruckten Regel, B-1, wird die Wurzel verfehlt, mit t_min = −2 und t_max = −1.",
        ],
    );
    let inside = Query::Point {
        at: [0.3, 0.9],
        method: PointMethod::Codes,
        variants: Variants::NONE.with(Variant::B21),
    };
    check_words(
        &beyond,
        &inside,
        [
            "The point (0.3, 0.9) has the location codes (010, 111) in binary.",
            "Der Punkt (0.3, 0.9) hat binär die Ortscodes (010, 111).",
        ],
    );
    check_words(
        &Ray::new([-0.25, 0.125], [1.0, 0.25]).unwrap(),
        &with(Algorithm::Parametric, Variant::B10),
        [
            "t_ym = 1.5 > t_x0 = 0.25, so no bit is 1: the ray enters in state 0.",
            "t_ym = 1.5 > t_x0 = 0.25, also ist kein Bit gesetzt: Der Strahl tritt im Zustand 0 ein.",
        ],
    );
}

/// The sentences of the counterexample of a variant, in English.
fn printed(variant: Variant) -> Vec<String> {
    fn of<const D: usize>(scenario: &Scenario<D>) -> Vec<String> {
        let tree = scenario.tree().unwrap();
        let trace = record(&tree, &scenario.ray, &scenario.query);
        let sentences = sentence::sentences(&tree, &scenario.ray, &trace, Language::English);
        sentences.map(|text| text.plain()).collect()
    }
    match counterexample(variant) {
        AnyScenario::Quadtree(scenario) => of(&scenario),
        AnyScenario::Octree(scenario) => of(&scenario),
    }
}

#[test]
fn steps_by_a_printed_rule_say_so() {
    for (variant, expected) in [
        (Variant::B1, "By the printed rule, B-1, the root is hit, from t = 0 to t = 3."),
        (Variant::B2, "By the printed rule, B-2, the ray enters in state 1."),
        (Variant::B2Morton, "By the printed rule, B-2-morton, the ray enters in state 1."),
        (
            Variant::B2Morton,
            "1 is read as x + 2y + 4z, B-2-morton, which means child 4 of the tree; it is visited: the node (1, 0, 0) of level 0.",
        ),
        (
            Variant::B1,
            "By the printed rule, B-1, the node (0, 1) of level 0 is reported, from t = 0.5 to t = 2.5.",
        ),
        (
            Variant::B4,
            "By the printed rule, B-4, the walk comes to the node (0, 1) of level 0, but would leave it at t = 1, no later than it enters it: it is not reported.",
        ),
        (
            Variant::B18,
            "By the printed rule, B-18, bit 2 of the codes is read. It is 0 in x and 0 in y, which selects child 0: the node (0, 0) of level 0.",
        ),
        (
            Variant::B19,
            "By the printed rule, B-19, bit 2 of the codes is read. It is 0 in x and 0 in y, which selects child 0: the node (0, 0) of level 1.",
        ),
        (
            Variant::B24a,
            "By the printed rule, B-24a, the common ancestor has level 1. But the codes differ first in bit 1, so it has level 2.",
        ),
        (
            Variant::B24b,
            "By the printed rule, B-24b, the common ancestor has level 0. But the codes differ first in bit 1, so it has level 2.",
        ),
        (
            Variant::B25Leftmost,
            "By the printed rule, B-25-leftmost, the common ancestor has level 1. But the codes differ first in bit 1, so it has level 2.",
        ),
        (
            Variant::B5,
            "t_z0 = 1 < t_z1 = 2. But t_x1 = NaN is no number, so that no comparison with it holds and it decides nothing. So says the printed rule, B-5.",
        ),
        (Variant::B18, "The point (0.375, 0.375) has the location codes (001, 001) in binary."),
        (
            Variant::B21,
            "The point (1, 0.25) has the location codes (10, 00) in binary. So says the printed rule, B-21.",
        ),
        (Variant::B28, "By the printed rule, B-28, the codes beyond it along x are (0, 0)."),
        (
            Variant::B3,
            "By the printed rule, B-3, the children visited are those of states 0, 1 and 3.",
        ),
    ] {
        let sentences = printed(variant);
        assert!(sentences.iter().any(|text| text.ends_with(expected)), "{sentences:#?}");
    }
    for variant in Variant::ALL.into_iter().filter(|variant| variant.is_misprint()) {
        let named = format!("printed rule, {}", variant.id());
        assert!(printed(variant).iter().any(|text| text.contains(&named)), "{named}");
    }
}

#[test]
fn a_child_behind_the_origin_is_left_with_a_reason() {
    let ray = Ray::new([0.75, 0.25, -1.0], [0.0625, 0.0625, 1.0]).unwrap();
    let options = Options { variants: Variants::NONE.with(Variant::B2), ..Options::default() };
    let query =
        Query::Ray { algorithm: Algorithm::Parametric, options, arithmetic: Arithmetic::Doubles };
    check_words(
        &ray,
        &query,
        [
            "Child 1 is left at t_x1 = −4 ≤ 0, so it lies behind the origin and is skipped: back up to the node (0, 0, 0) of level 3.",
            "Kind 1 wird bei t_x1 = −4 ≤ 0 verlassen; es liegt also hinter dem Startpunkt und wird übersprungen: zurück hinauf zu Knoten (0, 0, 0) auf Stufe 3.",
        ],
    );
}

#[test]
fn a_printed_rule_is_named_at_every_step_that_it_decides() {
    // The rule, and how many sentences of its counterexample are of these kinds.
    for variant in [Variant::B5, Variant::B6, Variant::B7] {
        let named = format!("printed rule, {}", variant.id());
        let sentences = printed(variant);
        let told = sentences.iter().filter(|text| text.contains(&named));
        let leaves = told.clone().filter(|text| text.contains("is reported, from"));
        assert!(told.count() - leaves.count() >= 3, "{sentences:#?}");
    }
}

#[test]
fn without_a_branch_for_equal_planes_no_child_is_chosen() {
    let ray = Ray::new([-1.0, -1.0], [1.0, 1.0]).unwrap();
    check_words(
        &ray,
        &with(Algorithm::Parametric, Variant::B3),
        [
            "The ray meets the mid planes of the node at t_xm = 1.5 and t_ym = 1.5. Neither is the smaller one, and the printed rule, B-3, has no branch for that: no child is chosen.",
            "Der Strahl trifft die Mittelebenen des Knotens bei t_xm = 1.5 und t_ym = 1.5. Keiner ist der kleinere, und die gedruckte Regel, B-3, hat dafür keinen Zweig: Es wird kein Kind gewählt.",
        ],
    );
}

/// Along two faces of the root and, where B-7 is at work, too, downwards.
#[test]
fn all_planes_without_a_number_are_told_with_all_their_rules() {
    for (variants, z, direction, rules) in [
        (
            Variants::NONE.with(Variant::B5),
            -1.0,
            1.0,
            ["So says the printed rule, B-5.", "So sagt es die gedruckte Regel, B-5."],
        ),
        (
            Variants::NONE.with(Variant::B5).with(Variant::B7),
            2.0,
            -1.0,
            [
                "So say the printed rules, B-5 and B-7.",
                "So sagen es die gedruckten Regeln, B-5 und B-7.",
            ],
        ),
    ] {
        let (tree, ray) = (tree(3), Ray::new([1.0, 1.0, z], [0.0, 0.0, direction]).unwrap());
        let options = Options { variants, ..Options::default() };
        let (algorithm, arithmetic) = (Algorithm::Parametric, Arithmetic::Doubles);
        let trace = record(&tree, &ray, &Query::Ray { algorithm, options, arithmetic });
        let planes = [
            "t_x1 = NaN and t_y1 = NaN are no numbers",
            "t_x1 = NaN und t_y1 = NaN sind keine Zahlen",
        ];
        for (n, language) in [Language::English, Language::German].into_iter().enumerate() {
            let sentences = sentence::sentences(&tree, &ray, &trace, language);
            let told: Vec<String> = sentences.map(|text| text.plain()).collect();
            let is_told = told.iter().any(|t| t.contains(planes[n]) && t.ends_with(rules[n]));
            assert!(is_told, "{told:#?}");
        }
    }
}

#[test]
fn every_form_that_is_no_misprint_is_told_before_the_first_step() {
    for variant in Variant::ALL.into_iter().filter(|variant| !variant.is_misprint()) {
        let key = format!("start-{}", variant.id());
        for language in Language::ALL {
            assert!(step_texts(language).has(&key), "{key} {language:?}");
        }
    }
}
