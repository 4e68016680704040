//! What was published about the speed of the algorithms, against what was measured.

use super::{Quantity, Results, SCENES, Way};
use crate::traverse::Algorithm;

/// What was published about two algorithms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Published {
    /// They take about the same time.
    Equal,
    /// The first takes this share of the time of the second, below 1.
    Share(f64),
}

/// A published statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Claim {
    /// Its name, for texts.
    pub id: &'static str,
    /// The algorithm that it is about.
    pub of: Algorithm,
    /// The one that it is compared with.
    pub against: Algorithm,
    /// What is said.
    pub published: Published,
    /// The scenes that are meant, or that stand for those.
    pub scenes: &'static [&'static str],
    /// The depth, if a certain one is meant.
    pub depth: Option<u8>,
}

/// Claims of the paper, from Revelles et al. 2000, and the geometric means of the table
/// of Havran 1999, in which the depth is the largest possible one.
pub const CLAIMS: [Claim; 7] = [
    Claim {
        id: "par-gargantini",
        of: Algorithm::Parametric,
        against: Algorithm::Gargantini,
        published: Published::Equal,
        scenes: &["cloud", "cylinders", "objects"],
        depth: None,
    },
    octree_and_bsp("bsp-512", 0.104, &["spheres-512"]),
    octree_and_bsp("bsp-4096", 0.127, &["spheres-4096"]),
    octree_and_bsp("bsp-32768", 0.068, &["spheres-32768"]),
    samet_and_gargantini("samet-5", 0.91, 5),
    samet_and_gargantini("samet-6", 0.88, 6),
    samet_and_gargantini("samet-7", 0.84, 7),
];

const fn octree_and_bsp(id: &'static str, less: f64, scenes: &'static [&'static str]) -> Claim {
    Claim {
        id,
        of: Algorithm::Parametric,
        against: Algorithm::Bsp,
        published: Published::Share(1.0 - less),
        scenes,
        depth: None,
    }
}

const fn samet_and_gargantini(id: &'static str, share: f64, depth: u8) -> Claim {
    Claim {
        id,
        of: Algorithm::Samet,
        against: Algorithm::Gargantini,
        published: Published::Share(share),
        scenes: &SCENES,
        depth: Some(depth),
    }
}

/// Whether a statement holds here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// To within `NEAR_EQUAL` or `NEAR_SHARE`.
    Agrees,
    /// The same algorithm is faster, by another factor, and by `LEAD` at least.
    SameSide,
    /// It does not.
    Differs,
    /// Nobody has measured it here.
    NotMeasured,
}

/// About the same time is within this share: differences that small come and go with
/// the compiler.
const NEAR_EQUAL: f64 = 0.1;

/// A published share of the time is met within this; the shares lie 0.07 to 0.16 below 1.
const NEAR_SHARE: f64 = 0.05;

/// A lead of less than this share is none.
const LEAD: f64 = 0.02;

/// A statement, and what was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The statement.
    pub claim: &'static Claim,
    /// Whether it holds.
    pub verdict: Verdict,
    /// Time of the one algorithm in units of that of the other: the geometric mean of
    /// the sites that were meant and measured.
    pub time: Option<f64>,
    /// The same of the nodes that are reached.
    pub node_touches: Option<f64>,
    /// The same of the comparisons.
    pub comparisons: Option<f64>,
    /// Number of the sites.
    pub n_sites: usize,
}

/// All statements with what `results` say of them.
pub fn judged(results: &Results) -> Vec<Judged> {
    CLAIMS.iter().map(|claim| judge(claim, results)).collect()
}

fn judge(claim: &'static Claim, results: &Results) -> Judged {
    let sites = results.sites.iter().filter(|site| {
        claim.scenes.contains(&site.scene.as_str())
            && claim.depth.is_none_or(|depth| depth == site.depth)
    });
    let pairs: Vec<_> = sites
        .filter_map(|site| {
            let [of, against] =
                [claim.of, claim.against].map(|algorithm| site.row(Way::from(algorithm)));
            Some((site, of?, against?))
        })
        .collect();
    let mean = |quantity: Quantity| {
        let ratios = pairs
            .iter()
            .map(|(site, of, against)| quantity.of(site, of) / quantity.of(site, against));
        geometric_mean(&ratios.collect::<Vec<f64>>())
    };
    let time = mean(Quantity::Time);
    let verdict = match (time, claim.published) {
        (None, _) => Verdict::NotMeasured,
        (Some(time), Published::Equal) => {
            if time.ln().abs() <= (1.0 + NEAR_EQUAL).ln() {
                Verdict::Agrees
            } else {
                Verdict::Differs
            }
        }
        (Some(time), Published::Share(share)) => {
            if (time - share).abs() <= NEAR_SHARE {
                Verdict::Agrees
            } else if time <= 1.0 - LEAD {
                Verdict::SameSide
            } else {
                Verdict::Differs
            }
        }
    };
    Judged {
        claim,
        verdict,
        time,
        node_touches: mean(Quantity::NodeTouches),
        comparisons: mean(Quantity::Comparisons),
        n_sites: pairs.len(),
    }
}

/// Geometric mean of positive numbers; `None` if there is none, or another number.
fn geometric_mean(numbers: &[f64]) -> Option<f64> {
    let usable = !numbers.is_empty() && numbers.iter().all(|x| *x > 0.0 && x.is_finite());
    usable.then(|| (numbers.iter().map(|x| x.ln()).sum::<f64>() / numbers.len() as f64).exp())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Row, Site};
    use crate::scenario::BUILT_IN;

    /// Verdict on the first claim of this name, where the two algorithms take these
    /// times at the sites.
    fn check(id: &str, sites: &[(&str, u8, [f64; 2])], expected: Verdict, time: Option<f64>) {
        let claim = CLAIMS.iter().find(|claim| claim.id == id).unwrap();
        let site = |&(scene, depth, times): &(&str, u8, [f64; 2])| Site {
            scene: scene.to_owned(),
            depth,
            n_rays: 1,
            rows: [claim.of, claim.against]
                .into_iter()
                .zip(times)
                .map(|(algorithm, time)| Row {
                    way: algorithm.into(),
                    times: vec![time],
                    ..Row::default()
                })
                .collect(),
            ..Site::default()
        };
        let results = Results { sites: sites.iter().map(site).collect(), ..Results::default() };
        let all = judged(&results);
        let found = all.iter().find(|judged| judged.claim.id == id).unwrap();
        assert_eq!(found.verdict, expected, "{id} {sites:?}");
        match (found.time, time) {
            (Some(found), Some(time)) => assert!((found - time).abs() < 1e-9, "{found}"),
            (found, time) => assert_eq!(found, time),
        }
    }

    #[test]
    fn about_equal_is_within_a_tenth_either_way() {
        let at = |a, b| [("cloud", 6, [a, b])];
        check("par-gargantini", &at(100.0, 100.0), Verdict::Agrees, Some(1.0));
        check("par-gargantini", &at(100.0, 109.0), Verdict::Agrees, Some(100.0 / 109.0));
        check("par-gargantini", &at(100.0, 115.0), Verdict::Differs, Some(100.0 / 115.0));
        check("par-gargantini", &at(115.0, 100.0), Verdict::Differs, Some(1.15));
    }

    #[test]
    fn a_share_is_met_or_lies_on_the_same_side_or_not() {
        let at = |a, b| [("spheres-512", 6, [a, b])];
        check("bsp-512", &at(90.0, 100.0), Verdict::Agrees, Some(0.9));
        check("bsp-512", &at(50.0, 100.0), Verdict::SameSide, Some(0.5));
        check("bsp-512", &at(97.9, 100.0), Verdict::SameSide, Some(0.979));
        check("bsp-512", &at(98.1, 100.0), Verdict::Differs, Some(0.981));
        check("bsp-512", &at(120.0, 100.0), Verdict::Differs, Some(1.2));
    }

    #[test]
    fn only_what_was_meant_counts_in_the_mean() {
        let other = [("cloud", 6, [1.0, 1.0])];
        check("bsp-512", &other, Verdict::NotMeasured, None);
        // Depth 6 is another claim's; of 0.25 and 1 the geometric mean is 0.5.
        let sites =
            [("cloud", 5, [1.0, 4.0]), ("cloud", 6, [9.0, 1.0]), ("objects", 5, [3.0, 3.0])];
        check("samet-5", &sites, Verdict::SameSide, Some(0.5));
    }

    #[test]
    fn the_scenes_of_the_comparison_exist() {
        for scene in SCENES {
            assert!(BUILT_IN.iter().any(|entry| entry.id == scene && entry.dimension == 3));
        }
        assert!(CLAIMS.iter().flat_map(|claim| claim.scenes).all(|scene| SCENES.contains(scene)));
    }
}
