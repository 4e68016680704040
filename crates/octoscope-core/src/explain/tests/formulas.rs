//! Formulas hold what was computed and what was found.

use super::*;

/// Whether an event computes or compares something that a formula tells.
fn is_told<const D: usize>(event: &Event<D>) -> bool {
    match event {
        Event::Clip { .. }
        | Event::Test { .. }
        | Event::Skip { .. }
        | Event::Halve { .. }
        | Event::First { .. }
        | Event::Step { .. }
        | Event::Enter { .. }
        | Event::Cuts { .. }
        | Event::Classify { .. }
        | Event::Flip { .. }
        | Event::Split { .. }
        | Event::Pop { .. }
        | Event::Grid { .. }
        | Event::Cross { .. }
        | Event::Parent { .. }
        | Event::Mirror { .. }
        | Event::Push { .. }
        | Event::Encode { .. }
        | Event::Compare { .. }
        | Event::Follow { .. }
        | Event::Exits { .. }
        | Event::Target { .. }
        | Event::Border { .. }
        | Event::Difference { .. }
        | Event::Leave { .. }
        | Event::Climb { .. }
        | Event::Corners { .. }
        | Event::Leaf { .. }
        | Event::Touch { .. } => true,
        Event::Visit { state, .. } => state.is_some(),
        Event::Sort { .. }
        | Event::Up { .. }
        | Event::Facing { .. }
        | Event::Rope { .. }
        | Event::Begin { .. }
        | Event::Resume { .. }
        | Event::Found { .. }
        | Event::End(_) => false,
    }
}

fn check_formulas<const D: usize>() {
    let mut strange = BTreeMap::new();
    for_all_runs::<D>(|tree, ray, _, query| {
        let trace = record(tree, ray, query);
        let mut before = Moment::default();
        for (index, event) in trace.events.iter().enumerate() {
            let mut known = None;
            let notation = Notation::ALL[index % 3];
            let language = Language::ALL[index % 2];
            let told = formulas(tree, ray, &trace, index + 1, notation, language);
            assert_eq!(!told.is_empty(), is_told(event), "{query:?} {event:?}");
            let text = spoken(&told, language);
            let placed = !text.contains(['{', '}', '$', '\n']) && !text.contains("  ");
            assert!(placed && !text.contains("sign-") && !text.contains("formula-"), "{text}");
            for line in told.iter().flat_map(|s| [Some(&s.symbols), s.numbers.as_ref()]).flatten() {
                let latex = math(line, Some(["x", "y", "z"]));
                assert_eq!(latex.matches('{').count(), latex.matches('}').count(), "{latex}");
                assert_eq!(latex.matches("\\left").count(), latex.matches("\\right").count());
                assert!(!latex.contains("U+"), "{latex}");
            }
            for number in told.iter().filter_map(|s| s.numbers.as_ref()).flat_map(numbers_in) {
                let known = known.get_or_insert_with(|| {
                    numbers_of(
                        tree,
                        ray,
                        &[&format!("{event:?} {query:?}"), &format!("{before:?}")],
                    )
                });
                let is_known = known.contains(&number.to_bits()) || number.is_nan();
                if !is_known {
                    strange.entry(format!("{event:?}")[..6].to_owned()).or_insert_with(|| {
                        format!("{number} in {text}: {query:?} {event:?} {ray:?}")
                    });
                }
            }
            before.apply(tree, event);
            // What is decided exactly may round to equal doubles, or to the next ones.
            let slack = if query.is_exact(tree.domain(), ray) { 8.0 * f64::EPSILON } else { 0.0 };
            for numbers in told.iter().filter_map(|statement| statement.numbers.as_ref()) {
                assert!(holds(numbers, slack), "{query:?} {event:?}\n{numbers:?}");
            }
        }
        assert_eq!(
            formulas(tree, ray, &trace, 0, Notation::Seed, Language::English),
            [],
            "nothing has happened yet"
        );
    });
    assert!(strange.is_empty(), "{strange:#?}");
}

/// The doubles that are set in a formula.
fn numbers_in(formula: &Formula) -> Vec<f64> {
    match formula {
        Formula::Number { value, .. } => vec![*value],
        Formula::Row(parts) => parts.iter().flat_map(numbers_in).collect(),
        Formula::Fraction { over, under } => [numbers_in(over), numbers_in(under)].concat(),
        Formula::Sub { body, .. } | Formula::Sup { body, .. } => numbers_in(body),
        Formula::Fenced { body, .. } => numbers_in(body),
        Formula::Over { limit, .. } => numbers_in(limit),
        Formula::Digits(_) | Formula::Symbol { .. } | Formula::Words(_) | Formula::Sign(_) => {
            Vec::new()
        }
    }
}

/// The numbers of which these texts tell, those of the ray, and the planes of the tree.
fn numbers_of<const D: usize>(tree: &Tree<D>, ray: &Ray<D>, texts: &[&str]) -> BTreeSet<u64> {
    let domain = tree.domain();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '-';
    let words = texts.iter().flat_map(|text| text.split(|c| !is_part(c)));
    let told = words.filter_map(|word| word.parse().ok());
    let planes = (0..D).flat_map(|e| (0..=domain.grid_size()).map(move |k| domain.plane(e, k)));
    // As it is, and as misprinted rules and right ones mirror it.
    let of_ray = (0..D).flat_map(|e| {
        let (p, d) = (ray.origin()[e], ray.direction()[e]);
        let ends = domain.plane(e, 0) + domain.plane(e, domain.grid_size());
        [p, d, d.abs(), domain.side() - p, ends - p]
    });
    // When the planes are met.
    let at_planes = (0..D).flat_map(|e| {
        let (p, d) = (ray.origin()[e], ray.direction()[e]);
        (0..=domain.grid_size()).map(move |k| (domain.plane(e, k) - p) / d)
    });
    let all = told.chain(planes).chain(of_ray).chain(at_planes).chain([0.0]);
    all.map(f64::to_bits).collect()
}

/// Value of a number, sum, difference, quotient, minimum or maximum.
fn value(formula: &Formula) -> Option<f64> {
    match formula {
        Formula::Number { value, .. } => Some(*value),
        Formula::Digits(text) => text.replace('−', "-").parse().ok(),
        Formula::Fenced { fence: Fence::Round, body } => value(body),
        Formula::Fraction { over, under } => match &**under {
            // A mean is computed by halves, which are exact.
            Formula::Digits(_) => Some(0.5 * value(over)?),
            Formula::Row(_)
            | Formula::Symbol { .. }
            | Formula::Number { .. }
            | Formula::Words(_)
            | Formula::Sign(_)
            | Formula::Sub { .. }
            | Formula::Sup { .. }
            | Formula::Fraction { .. }
            | Formula::Over { .. }
            | Formula::Fenced { .. } => Some(value(over)? / value(under)?),
        },
        Formula::Row(parts) => match &parts[..] {
            [one] => value(one),
            [Formula::Words(name), Formula::Fenced { body, .. }] => {
                let Formula::Row(parts) = &**body else { return None };
                let values: Option<Vec<f64>> = parts
                    .iter()
                    .filter(|part| !matches!(part, Formula::Sign(_)))
                    .map(value)
                    .collect();
                let fold = if name == "max" { f64::max } else { f64::min };
                values?.into_iter().reduce(fold)
            }
            [first, rest @ ..] => {
                let mut sum = value(first)?;
                for pair in rest.chunks(2) {
                    let [Formula::Sign(sign), part] = pair else { return None };
                    match sign {
                        Sign::Plus => sum += value(part)?,
                        Sign::Minus => sum -= value(part)?,
                        _ => return None,
                    }
                }
                Some(sum)
            }
            [] => None,
        },
        Formula::Symbol { .. }
        | Formula::Words(_)
        | Formula::Sign(_)
        | Formula::Sub { .. }
        | Formula::Sup { .. }
        | Formula::Over { .. }
        | Formula::Fenced { .. } => None,
    }
}

/// Whether every comparison and every equation of a line of numbers holds for the
/// numbers to their last digit, but for comparisons of numbers that differ by no more
/// than this share.
fn holds(line: &Formula, slack: f64) -> bool {
    let mut flat = Vec::new();
    flatten(line, &mut flat);
    let mut sides: Vec<(Vec<Formula>, Option<Sign>)> = vec![(Vec::new(), None)];
    for part in flat {
        match part {
            Formula::Sign(
                sign @ (Sign::Equal
                | Sign::About
                | Sign::Less
                | Sign::LessOrEqual
                | Sign::Greater
                | Sign::GreaterOrEqual
                | Sign::Implies),
            ) => {
                sides.last_mut().unwrap().1 = Some(sign);
                sides.push((Vec::new(), None));
            }
            part => sides.last_mut().unwrap().0.push(part),
        }
    }
    sides.windows(2).all(|pair| {
        let [left, right] = [0, 1].map(|n| value(&Formula::Row(pair[n].0.clone())));
        let (Some(left), Some(right)) = (left, right) else { return true };
        let is_near = slack > 0.0 && (left - right).abs() <= slack * left.abs().max(right.abs());
        match pair[0].1 {
            Some(Sign::Equal | Sign::About) => {
                let tiny = 1e-15 * left.abs().max(1.0);
                left == right || (left - right).abs() <= tiny || left.is_nan() || right.is_nan()
            }
            Some(Sign::Less | Sign::LessOrEqual | Sign::Greater | Sign::GreaterOrEqual)
                if is_near =>
            {
                true
            }
            Some(Sign::Less) => left < right || left.is_nan() || right.is_nan(),
            Some(Sign::LessOrEqual) => left <= right,
            Some(Sign::Greater) => left > right,
            Some(Sign::GreaterOrEqual) => left >= right,
            _ => true,
        }
    })
}

fn flatten(formula: &Formula, out: &mut Vec<Formula>) {
    match formula {
        Formula::Row(parts) => {
            // Operators stay with what they operate on.
            let is_flat = parts.iter().any(|part| matches!(part, Formula::Sign(_)))
                || parts.iter().any(|part| matches!(part, Formula::Row(_)));
            if is_flat {
                parts.iter().for_each(|part| flatten(part, out));
            } else {
                out.push(formula.clone());
            }
        }
        part => out.push(part.clone()),
    }
}

#[test]
fn what_computes_or_compares_has_a_formula_that_holds() {
    check_formulas::<2>();
    check_formulas::<3>();
}

/// The lines of the first step that `wanted` is true of.
fn lines<const D: usize>(
    ray: &Ray<D>,
    query: &Query<D>,
    notation: Notation,
    wanted: impl Fn(&Event<D>) -> bool,
) -> Vec<String> {
    let tree = tree(3);
    let trace = record(&tree, ray, query);
    let step = trace.events.iter().position(wanted).unwrap() + 1;
    let told = formulas(&tree, ray, &trace, step, notation, Language::English);
    let lines = told.iter().flat_map(|s| [Some(&s.symbols), s.numbers.as_ref()]).flatten();
    lines.map(|line| spoken_formula(line, Language::English)).collect()
}

#[test]
fn a_mid_plane_is_set_as_a_fraction_in_every_notation() {
    let ray = Ray::new([0.2, 0.125], [0.8, 0.25]).unwrap();
    let query = along(Algorithm::Parametric);
    let halve = |event: &Event<2>| matches!(event, Event::Halve { .. });
    let first = |notation| lines(&ray, &query, notation, halve);
    assert_eq!(
        first(Notation::Seed)[..2],
        ["t xm equals (x m minus p x) over d x", "(0.5 minus 0.2) over 0.8 is about 0.375",]
    );
    assert_eq!(first(Notation::Revelles)[0], "t xm (o) equals (x m (o) minus p x) over d x");
}

#[test]
fn a_mean_is_set_as_one_and_a_misprint_as_it_is_printed() {
    let ray = Ray::new([-0.5, 0.125], [1.0, 0.25]).unwrap();
    let halve = |event: &Event<2>| matches!(event, Event::Halve { .. });
    let of =
        |variant| lines(&ray, &with(Algorithm::ParametricTable, variant), Notation::Seed, halve);
    assert_eq!(
        of(Variant::Averaged)[..2],
        ["t xm equals (t x0 plus t x1) over 2", "(0.5 plus 1.5) over 2 equals 1"]
    );
    assert_eq!(
        of(Variant::B4)[..2],
        ["t xm equals (t x0 plus t x) over 2", "(0.5 plus 0.5) over 2 equals 0.5"]
    );
}

#[test]
fn the_bits_of_codes_are_shifted_and_the_highest_difference_tells_the_level() {
    let region = Query::Region { min: [0.26; 2], max: [0.3; 2], variants: Variants::NONE };
    let ray = rays::<2>()[0];
    let difference = |event: &Event<2>| matches!(event, Event::Difference { .. });
    let told = lines(&ray, &region, Notation::FriskenPerry, difference);
    assert_eq!(told[0], "diff x equals loc x0 xor loc x1");
    let follow = |event: &Event<2>| matches!(event, Event::Follow { .. });
    let told = lines(&ray, &region, Notation::FriskenPerry, follow);
    assert_eq!(told[0], "i x equals (loc x0 shifted right by (k minus 1)) and 1");
    assert!(told.iter().any(|line| line == "i equals 2 i y plus i x"), "{told:?}");
}
