//! How costs grow.

use super::{Quantity, Results, Way};

/// y = factor · x^exponent, fitted to points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLaw {
    /// The exponent: the slope in logarithmic axes.
    pub exponent: f64,
    /// y at x = 1.
    pub factor: f64,
    /// Share of the variance of log y that the law explains, 0 … 1.
    pub r_squared: f64,
}

impl PowerLaw {
    /// The law that fits `points` best: least squares of the logarithms. Points that
    /// have none are left out; `None` without two different x.
    pub fn fit(points: &[[f64; 2]]) -> Option<Self> {
        let usable = points.iter().filter(|p| p.iter().all(|x| *x > 0.0 && x.is_finite()));
        let logs: Vec<[f64; 2]> = usable.map(|p| p.map(f64::ln)).collect();
        let n = logs.len() as f64;
        let mean = |e: usize| logs.iter().map(|p| p[e]).sum::<f64>() / n;
        let [x, y] = [mean(0), mean(1)];
        let spread = |a: usize, b: usize| -> f64 {
            let middle = [x, y];
            logs.iter().map(|p| (p[a] - middle[a]) * (p[b] - middle[b])).sum()
        };
        let [xx, xy, yy] = [spread(0, 0), spread(0, 1), spread(1, 1)];
        if logs.len() < 2 || xx < 1e-12 {
            return None;
        }
        let exponent = xy / xx;
        let r_squared = if yy < 1e-24 { 1.0 } else { xy * xy / (xx * yy) };
        Some(Self { exponent, factor: (y - exponent * x).exp(), r_squared })
    }

    /// y at this x.
    pub fn at(&self, x: f64) -> f64 {
        self.factor * x.powf(self.exponent)
    }
}

/// How quantity `y` of a way grows with quantity `x` over the depths of a scene: the
/// points, and the law.
pub fn growth(
    results: &Results,
    scene: &str,
    way: Way,
    [x, y]: [Quantity; 2],
) -> (Vec<[f64; 2]>, Option<PowerLaw>) {
    let sites = results.sites.iter().filter(|site| site.scene == scene);
    let points: Vec<[f64; 2]> = sites
        .filter_map(|site| {
            let row = site.row(way)?;
            Some([x.of(site, row), y.of(site, row)])
        })
        .collect();
    let law = PowerLaw::fit(&points);
    (points, law)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_found_again() {
        let law = |x: f64| 3.0 * x.powf(1.5);
        let points = [1.0, 2.0, 5.0, 40.0].map(|x| [x, law(x)]);
        let found = PowerLaw::fit(&points).unwrap();
        assert!((found.exponent - 1.5).abs() < 1e-12 && (found.factor - 3.0).abs() < 1e-12);
        assert!((found.r_squared - 1.0).abs() < 1e-12);
        assert!((found.at(7.0) - law(7.0)).abs() < 1e-9);
    }

    /// Logarithms to base 2: (0, 0), (1, 2), (2, 1): slope 1/2, and a quarter of the
    /// variance.
    #[test]
    fn the_slope_is_that_of_least_squares() {
        let found = PowerLaw::fit(&[[1.0, 1.0], [2.0, 4.0], [4.0, 2.0]]).unwrap();
        assert!((found.exponent - 0.5).abs() < 1e-12);
        assert!((found.r_squared - 0.25).abs() < 1e-12);
    }

    #[test]
    fn one_point_has_no_law_nor_have_numbers_without_logarithms() {
        for points in [&[][..], &[[1.0, 2.0]], &[[2.0, 1.0], [2.0, 3.0]], &[[0.0, 1.0], [1.0, 1.0]]]
        {
            assert_eq!(PowerLaw::fit(points), None, "{points:?}");
        }
        // What does not grow has the exponent 0.
        assert_eq!(PowerLaw::fit(&[[1.0, 2.0], [3.0, 2.0]]).map(|law| law.exponent), Some(0.0));
    }
}
