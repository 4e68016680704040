//! How large a figure is: the page, and the length of its units.
//!
//! Page units are pixels; on paper 96 of them are an inch, so that type of 12 units is
//! one of 9 points.

use octoscope_figure::{Page, Scale, Unit};
use std::fmt;
use std::str::FromStr;

/// Width of a figure in a unit, and its height where that does not follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Width, above 0.
    pub width: f64,
    /// Height, above 0; without it, as high as what is drawn.
    pub height: Option<f64>,
    /// Unit of both.
    pub unit: Unit,
}

impl Size {
    /// Longest side in this unit: what PDF readers show, and pictures have.
    pub fn longest(unit: Unit) -> f64 {
        match unit {
            Unit::Millimetre => 5080.0,
            Unit::Point => 14_400.0,
            Unit::Pixel => 16_384.0,
        }
    }

    /// The page on which a figure is laid out, if type and lines are `type_scale`
    /// times as large as usual. Of a figure as high as what is drawn, it is cut off.
    pub fn page(self, type_scale: f64) -> Page {
        const HIGHEST: f64 = 1.25;
        let side = |length: f64| length / (self.per_unit() * type_scale);
        let width = side(self.width);
        Page { width, height: self.height.map_or(HIGHEST * width, side) }
    }

    /// Length of the units of that page, in the unit of this size.
    pub fn scale(self, type_scale: f64) -> Scale {
        Scale { factor: self.per_unit() * type_scale, unit: self.unit }
    }

    /// A pixel in the unit of this size.
    fn per_unit(self) -> f64 {
        match self.unit {
            Unit::Millimetre => 25.4 / 96.0,
            Unit::Point => 72.0 / 96.0,
            Unit::Pixel => 1.0,
        }
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            "give width and height such as 1280x720, 120x80mm or 340x227pt, or a width with its \
             unit such as 85mm"
                .to_owned()
        };
        let unit = Unit::ALL.into_iter().find(|unit| text.ends_with(unit.id()));
        let numbers = text.strip_suffix(unit.map_or("", Unit::id)).unwrap_or(text).trim_end();
        let length = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
        let (width, height) = match (numbers.split_once(['x', 'X', '×']), unit) {
            (Some((width, height)), _) => (length(width)?, Some(length(height)?)),
            (None, Some(_)) => (length(numbers)?, None),
            (None, None) => return Err(wrong()),
        };
        let unit = unit.unwrap_or_default();
        let size = Self { width, height, unit };
        let longest = Self::longest(unit);
        // An ordinary picture of pixels has whole ones.
        let fits = |side: f64| {
            (1.0..=longest).contains(&side) && (unit != Unit::Pixel || side.fract() == 0.0)
        };
        if fits(size.width) && size.height.is_none_or(fits) {
            return Ok(size);
        }
        let whole = if unit == Unit::Pixel { "whole numbers " } else { "" };
        Err(format!(
            "give {whole}from 1 to {longest} {} along each side, such as 1280x720, 120x80mm or \
             340x227pt",
            unit.id()
        ))
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", self.width)?;
        self.height.map_or(Ok(()), |height| write!(f, "x{height}"))?;
        f.write_str(self.unit.id())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, [width, height]: [f64; 2], unit: Unit) {
        check_size(text, width, Some(height), unit);
    }

    #[track_caller]
    fn check_size(text: &str, width: f64, height: Option<f64>, unit: Unit) {
        let size = Size { width, height, unit };
        assert_eq!(text.parse(), Ok(size), "{text}");
        assert_eq!(size.to_string().parse(), Ok(size), "{text}");
    }

    #[test]
    fn sizes_are_width_and_height_in_a_unit() {
        check("640x480", [640.0, 480.0], Unit::Pixel);
        check("640x480px", [640.0, 480.0], Unit::Pixel);
        check("120x80.5mm", [120.0, 80.5], Unit::Millimetre);
        check("340×227 pt", [340.0, 227.0], Unit::Point);
        check_size("85mm", 85.0, None, Unit::Millimetre);
        check_size("320px", 320.0, None, Unit::Pixel);
        for bad in ["640", "640x", "0x480", "-1x5", "640x99999", "a4", "640x480x2", "10.5x10", "mm"]
            .into_iter()
            .chain(["1x6000mm", "nanx5mm", "1x20000pt", "10x10cm", "0mm", "6000mm", "10.5px"])
        {
            assert!(bad.parse::<Size>().unwrap_err().contains("1280x720"), "{bad}");
        }
    }

    #[test]
    fn units_of_a_page_are_pixels() {
        let size: Size = "254x127mm".parse().unwrap();
        let page = size.page(1.0);
        assert!((page.width - 960.0).abs() < 1e-9 && (page.height - 480.0).abs() < 1e-9);
        assert!((size.scale(1.0).points() - 0.75).abs() < 1e-9);
        let larger: Size = "640x480".parse().unwrap();
        assert_eq!(larger.page(2.0), Page { width: 320.0, height: 240.0 });
        assert_eq!(larger.scale(2.0), Scale { factor: 2.0, unit: Unit::Pixel });
    }
}
