//! What is told by colour is told to colour-blind eyes, too: the colours of roles
//! stay apart in simulated vision.

use octoscope_figure::{Colour, Palette, Theme, ramp};

/// How colours come to eyes, as a matrix on linear RGB.
type Vision = [[f64; 3]; 3];

/// Usual vision, and the three kinds of colour blindness at their strongest
/// [Machado, Oliveira, Fernandes 2009, table 1].
const VISIONS: [(&str, Vision); 4] = [
    ("usual", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "protanopia",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "deuteranopia",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
    (
        "tritanopia",
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ),
];

/// Least distance of two roles. In this space black and white are 1 apart; colours
/// side by side are told apart from about 0.02 on.
const LEAST: f64 = 0.08;

/// A colour in Oklab [Ottosson 2020], as it comes to these eyes.
fn seen(colour: Colour, vision: &Vision) -> [f64; 3] {
    let linear = colour.rgb.map(|c| {
        let c = f64::from(c) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    });
    let times = |rows: &Vision, v: [f64; 3]| rows.map(|row| (0..3).map(|e| row[e] * v[e]).sum());
    let comes: [f64; 3] = times(vision, linear);
    let cones: [f64; 3] = times(
        &[
            [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
            [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
            [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
        ],
        comes.map(|c| c.clamp(0.0, 1.0)),
    );
    times(
        &[
            [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
            [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
            [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
        ],
        cones.map(f64::cbrt),
    )
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|e| (a[e] - b[e]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn roles_stay_apart_in_every_theme_and_for_every_kind_of_eyes() {
    for theme in Theme::ALL {
        let p = Palette::of(theme);
        let roles = [
            ("x", p.axes[0]),
            ("y", p.axes[1]),
            ("z", p.axes[2]),
            ("ray", p.ray),
            ("current", p.current_outline),
            ("rejected", p.rejected),
            ("ancestor", p.ancestor),
        ];
        for (vision, matrix) in &VISIONS {
            for (n, (one, a)) in roles.iter().enumerate() {
                for (other, b) in &roles[n + 1..] {
                    let apart = distance(seen(*a, matrix), seen(*b, matrix));
                    assert!(apart >= LEAST, "{theme:?} {vision}: {one} and {other} {apart:.3}");
                }
            }
        }
    }
}

#[test]
fn no_visited_leaf_has_the_colour_of_the_current_node() {
    for theme in Theme::ALL {
        for (vision, matrix) in &VISIONS {
            let current = seen(Palette::of(theme).current, matrix);
            for step in 0..=20 {
                let share = f64::from(step) / 20.0;
                let apart = distance(seen(ramp(theme, share), matrix), current);
                assert!(apart >= LEAST, "{theme:?} {vision} {share}: {apart:.3}");
            }
        }
    }
}

#[test]
fn the_space_of_colours_is_the_published_one() {
    let [white, red] = [0xff_ff_ff, 0xff_00_00].map(|rgb| seen(Colour::hex(rgb), &VISIONS[0].1));
    assert!(distance(white, [1.0, 0.0, 0.0]) < 1e-3, "{white:?}");
    assert!(distance(red, [0.627_96, 0.224_86, 0.125_85]) < 1e-3, "{red:?}");
}
