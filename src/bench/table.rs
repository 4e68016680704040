//! Results as text.

use octoscope_core::measure::{
    PowerLaw, Published, Quantity, Results, Row, Site, Verdict, Way, growth, judged,
};
use octoscope_core::trace::Counter;
use std::fmt::Write;

/// A column of a table.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its head in files and on the command line.
    pub head: &'static str,
    /// Key of its head in the language files; empty where the window says it otherwise.
    pub key: &'static str,
    /// The entry of a row, if there is one.
    pub of: fn(&Site, &Row) -> Option<String>,
}

type Of = fn(&Site, &Row) -> Option<String>;

const fn column(head: &'static str, key: &'static str, of: Of) -> Column {
    Column { head, key, of }
}

/// What is measured: times, which depend on the machine; what is computed; the way through
/// the tree, with what it costs a processor. Means of a ray, but for the stack.
pub const GROUPS: [(&str, &[Column]); 3] =
    [("lab-times", &TIMES), ("lab-computed", &COMPUTED), ("lab-way", &WAY)];

const ALGORITHM: Column = column("algorithm", "", |_, row| Some(row.way.to_string()));

const TIMES: [Column; 5] = [
    column("us/ray", "lab-column-time", |_, row| decimals(row.median() / 1000.0, 3)),
    column("+-%", "lab-column-spread", |_, row| decimals(100.0 * row.spread()?, 1)),
    column("ns/leaf", "lab-column-time-per-leaf", |site, row| {
        decimals(Quantity::TimePerLeaf.of(site, row), 1)
    }),
    column("rays/s", "lab-column-rate", |_, row| decimals(1e9 / row.median(), 0)),
    column("of-best", "lab-column-of-best", |site, row| {
        decimals(row.median() / site.least(Quantity::Time)?, 2)
    }),
];

const COMPUTED: [Column; 7] = [
    column("nodes", "lab-nodes", |site, row| counted(site, row, Counter::NodeTouches)),
    column("entry", "lab-kind-entry", |site, row| counted(site, row, Counter::EntryComparisons)),
    column("exit", "lab-kind-exit", |site, row| counted(site, row, Counter::ExitComparisons)),
    column("range", "lab-kind-range", |site, row| counted(site, row, Counter::RangeComparisons)),
    column("codes", "lab-column-codes", |site, row| counted(site, row, Counter::CodeComparisons)),
    column("sort", "lab-kind-sort", |site, row| counted(site, row, Counter::SortComparisons)),
    column("divisions", "lab-column-divisions", |site, row| counted(site, row, Counter::Divisions)),
];

const WAY: [Column; 7] = [
    column("locations", "lab-column-locations", |site, row| {
        counted(site, row, Counter::PointLocations)
    }),
    column("up", "lab-column-up", |site, row| counted(site, row, Counter::Ascends)),
    column("down", "lab-column-down", |site, row| counted(site, row, Counter::Descends)),
    column("stack", "lab-column-stack", |_, row| stack(row)),
    column("lines", "lab-column-lines", |site, row| decimals(Quantity::Lines.of(site, row), 1)),
    column("uncached", "lab-column-uncached", |site, row| {
        decimals(Quantity::CacheMisses.of(site, row), 1)
    }),
    column("misguessed", "lab-column-misguessed", |site, row| {
        decimals(Quantity::BranchMisses.of(site, row), 1)
    }),
];

/// The site, before the columns above.
const PLACE: [Column; 6] = [
    column("scene", "", |site, _| Some(site.scene.clone())),
    column("depth", "", |site, _| Some(site.depth.to_string())),
    column("tree-leaves", "", |site, _| Some(site.n_leaves.to_string())),
    column("rays", "", |site, _| Some(site.n_rays.to_string())),
    column("leaves/ray", "", |site, row| decimals(Quantity::RayLeaves.of(site, row), 2)),
    column("checksum", "", |_, row| Some(format!("{:016x}", row.counted.checksum))),
];

fn counted(site: &Site, row: &Row, counter: Counter) -> Option<String> {
    row.way.method()?;
    decimals(row.counted.counters.get(counter) as f64 / site.n_rays.max(1) as f64, 1)
}

/// Greatest depth of the stack, where it is counted.
fn stack(row: &Row) -> Option<String> {
    row.way.method()?;
    Some(row.counted.counters.get(Counter::StackDepth).to_string())
}

/// A number, if there is one.
fn decimals(x: f64, digits: usize) -> Option<String> {
    x.is_finite().then(|| format!("{x:.digits$}"))
}

/// What stands where there is nothing.
fn or_dash(cell: Option<String>) -> String {
    cell.unwrap_or_else(|| "-".to_owned())
}

/// Heads of columns, and their entries for every row of some sites.
fn lines<'a>(columns: &[Column], sites: impl IntoIterator<Item = &'a Site>) -> Vec<Vec<String>> {
    let head = columns.iter().map(|column| column.head.to_owned()).collect();
    let rows = sites.into_iter().flat_map(|site| {
        let cells = |row| columns.iter().map(|column| or_dash((column.of)(site, row))).collect();
        site.rows.iter().map(cells).collect::<Vec<_>>()
    });
    std::iter::once(head).chain(rows).collect()
}

/// All rows as CSV with a head.
pub fn csv(results: &Results) -> String {
    let line = |cells: Vec<String>| cells.iter().map(|cell| quoted(cell)).collect::<Vec<_>>();
    let mut csv = String::new();
    for cells in all_rows(results) {
        csv.push_str(&line(cells).join(","));
        csv.push('\n');
    }
    csv
}

/// All rows as a table in Markdown.
pub fn markdown(results: &Results) -> String {
    let mut table = String::new();
    for (n, cells) in all_rows(results).into_iter().enumerate() {
        let n_cells = cells.len();
        table.push_str(&format!("| {} |\n", cells.join(" | ")));
        if n == 0 {
            table.push_str(&format!("|{}\n", "---|".repeat(n_cells)));
        }
    }
    table
}

/// The site first, the algorithm once.
fn all_rows(results: &Results) -> Vec<Vec<String>> {
    let groups = GROUPS.iter().flat_map(|(_, columns)| *columns);
    let columns: Vec<Column> = PLACE.iter().chain([&ALGORITHM]).chain(groups).copied().collect();
    lines(&columns, &results.sites)
}

/// A field with a comma, as in the names of variants, stands in quotes.
fn quoted(cell: &str) -> String {
    if cell.contains(',') { format!("\"{cell}\"") } else { cell.to_owned() }
}

/// Two tables for every scene and depth, for people.
pub fn text(results: &Results) -> String {
    let mut text = String::new();
    for site in &results.sites {
        let Some(first) = site.rows.first() else { continue };
        text.push_str(&format!(
            "{}, depth {}: {} leaves; {} rays with {} leaves each, checksum {:016x}\n\n",
            site.scene,
            site.depth,
            site.n_leaves,
            site.n_rays,
            or_dash(decimals(Quantity::RayLeaves.of(site, first), 2)),
            first.counted.checksum,
        ));
        for table in tables(site) {
            text.push_str(&table);
            text.push('\n');
        }
    }
    text
}

/// What depends on the machine, and what does not.
fn tables(site: &Site) -> [String; 2] {
    let counts: Vec<Column> = COMPUTED.into_iter().chain(WAY).collect();
    [&TIMES[..], &counts].map(|columns| {
        let columns: Vec<Column> = [ALGORITHM].iter().chain(columns).copied().collect();
        aligned(&lines(&columns, [site]))
    })
}

/// How the time grows with the leaves of the tree, and what of the published comparison
/// holds; nothing of what was not measured.
pub fn summary(results: &Results) -> String {
    let mut text = String::new();
    if results.depths().len() > 1 {
        let scenes = results.scenes();
        let exponent = |scene: &str, way: Way, size: Quantity| {
            let (_, law) = growth(results, scene, way, [size, Quantity::Time]);
            or_dash(law.and_then(|PowerLaw { exponent, .. }| decimals(exponent, 2)))
        };
        for (size, title) in [
            (Quantity::TreeLeaves, "leaves of the tree"),
            (Quantity::RayLeaves, "leaves on the ray"),
        ] {
            let _ = write!(text, "exponent e of the time a ray ~ ({title})^e over the depths\n\n");
            let mut head = vec!["algorithm".to_owned()];
            head.extend(scenes.iter().map(|scene| (*scene).to_owned()));
            let rows = results.ways().into_iter().map(|way| {
                let mut row = vec![way.to_string()];
                row.extend(scenes.iter().map(|scene| exponent(scene, way, size)));
                row
            });
            text.push_str(&aligned(&std::iter::once(head).chain(rows).collect::<Vec<_>>()));
            text.push('\n');
        }
    }
    let measured: Vec<_> =
        judged(results).into_iter().filter(|one| one.verdict != Verdict::NotMeasured).collect();
    if !measured.is_empty() {
        text.push_str("time of one algorithm in units of that of another, published and here\n\n");
        let head = ["statement", "published", "here", "nodes", "comparisons", "holds"];
        let mut lines = vec![head.map(str::to_owned).to_vec()];
        for one in measured {
            let number = |x: Option<f64>| or_dash(x.and_then(|x| decimals(x, 3)));
            let depth = one.claim.depth.map(|depth| format!(" (depth {depth})"));
            lines.push(vec![
                format!(
                    "{} / {}, {}{}",
                    one.claim.of.id(),
                    one.claim.against.id(),
                    match one.claim.scenes {
                        [scene] => scene,
                        _ => "all",
                    },
                    depth.unwrap_or_default()
                ),
                match one.claim.published {
                    Published::Equal => "about 1".to_owned(),
                    Published::Share(share) => number(Some(share)),
                },
                number(one.time),
                number(one.node_touches),
                number(one.comparisons),
                match one.verdict {
                    Verdict::Agrees => "yes",
                    Verdict::SameSide => "in sign",
                    Verdict::Differs => "no",
                    Verdict::NotMeasured => "-",
                }
                .to_owned(),
            ]);
        }
        text.push_str(&aligned(&lines));
    }
    text
}

/// Lines in columns, names at the left, numbers at the right.
fn aligned(lines: &[Vec<String>]) -> String {
    let mut text = String::new();
    for line in lines {
        let padded = line.iter().enumerate().map(|(column, cell)| {
            let cells = lines.iter().filter_map(|line| line.get(column));
            let width = cells.map(|cell| cell.chars().count()).max().unwrap_or(0);
            if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        });
        text.push_str(padded.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn results() -> Results {
        let row = |text: &str, time: f64| Row {
            way: text.parse().unwrap(),
            times: vec![time],
            ..Row::default()
        };
        let site = |depth, n_leaves, rows| Site {
            scene: "spheres-512".to_owned(),
            depth,
            n_leaves,
            n_rays: 10,
            rows,
            ..Site::default()
        };
        let rows =
            |factor: f64| vec![row("parametric", 900.0 * factor), row("bsp", 1000.0 * factor)];
        let sites = vec![site(5, 100, rows(1.0)), site(6, 400, rows(2.0))];
        Results { seed: 1, sites, ..Results::default() }
    }

    #[test]
    fn csv_has_a_field_for_every_head_in_every_line() {
        let mut results = results();
        results.sites[0].rows[0].way = "parametric@one-by-one,averaged".parse().unwrap();
        let csv = csv(&results);
        let lines: Vec<&str> = csv.lines().collect();
        assert_eq!(lines.len(), 5);
        assert!(
            lines[0].starts_with("scene,depth,tree-leaves,rays,leaves/ray,checksum,algorithm,")
        );
        let n_fields = lines[0].split(',').count();
        assert!(lines[2..].iter().all(|line| line.split(',').count() == n_fields), "{csv}");
        assert!(lines[1].contains(",\"parametric@one-by-one,averaged\",0.900,"), "{csv}");
        assert!(markdown(&results).lines().all(|line| line.starts_with('|')));
    }

    #[test]
    fn times_are_told_with_their_share_of_the_best() {
        let text = text(&results());
        let bsp = text.lines().find(|line| line.starts_with("bsp")).unwrap();
        let cells: Vec<&str> = bsp.split_whitespace().collect();
        // One repetition tells no spread.
        assert_eq!(cells, ["bsp", "1.000", "-", "-", "1000000", "1.11"]);
    }

    #[test]
    fn the_summary_tells_exponents_and_what_holds() {
        let summary = summary(&results());
        // Four times the leaves, twice the time.
        let line = |start: &str| summary.lines().find(|line| line.starts_with(start)).unwrap();
        assert!(line("bsp ").ends_with("0.50"), "{summary}");
        let claim: Vec<&str> = line("parametric / bsp").split_whitespace().collect();
        assert!(claim.ends_with(&["0.896", "0.900", "-", "-", "yes"]), "{claim:?}");
        assert!(!summary.contains("samet /"), "it was not measured");
        assert_eq!(super::summary(&Results::default()), "");
    }
}
