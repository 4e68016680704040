//! How large a figure is: the page, and the length of its units.

use octoscope_figure::{Page, Scale, Unit};
use std::fmt;
use std::str::FromStr;

/// Width and height of a figure in a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Width, above 0.
    pub width: f64,
    /// Height, above 0.
    pub height: f64,
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
    /// times as large as usual. Its units are pixels, else points.
    pub fn page(self, type_scale: f64) -> Page {
        let side = |length: f64| length / (self.per_unit() * type_scale);
        Page { width: side(self.width), height: side(self.height) }
    }

    /// Length of the units of that page, in the unit of this size.
    pub fn scale(self, type_scale: f64) -> Scale {
        Scale { factor: self.per_unit() * type_scale, unit: self.unit }
    }

    /// A pixel or point in the unit of this size.
    fn per_unit(self) -> f64 {
        match self.unit {
            Unit::Millimetre => 25.4 / 72.0,
            Unit::Point | Unit::Pixel => 1.0,
        }
    }
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "give width and height such as 1280x720, 120x80mm or 340x227pt".to_owned();
        let unit = Unit::ALL.into_iter().find(|unit| text.ends_with(unit.id()));
        let numbers = text.strip_suffix(unit.map_or("", Unit::id)).unwrap_or(text).trim_end();
        let unit = unit.unwrap_or_default();
        let (width, height) = numbers.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
        let length = |text: &str| text.trim().parse::<f64>().map_err(|_| wrong());
        let size = Self { width: length(width)?, height: length(height)?, unit };
        let longest = Self::longest(unit);
        // An ordinary picture of pixels has whole ones.
        let fits = |side: f64| {
            (1.0..=longest).contains(&side) && (unit != Unit::Pixel || side.fract() == 0.0)
        };
        if fits(size.width) && fits(size.height) {
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
        write!(f, "{}x{}{}", self.width, self.height, self.unit.id())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, [width, height]: [f64; 2], unit: Unit) {
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
        for bad in ["640", "640x", "0x480", "-1x5", "640x99999", "a4", "640x480x2", "10.5x10", "mm"]
            .into_iter()
            .chain(["1x6000mm", "nanx5mm", "1x20000pt", "10x10cm"])
        {
            assert!(bad.parse::<Size>().unwrap_err().contains("1280x720"), "{bad}");
        }
    }

    #[test]
    fn units_of_a_page_are_points_or_pixels() {
        let size: Size = "254x127mm".parse().unwrap();
        let page = size.page(1.0);
        assert!((page.width - 720.0).abs() < 1e-9 && (page.height - 360.0).abs() < 1e-9);
        assert!((size.scale(1.0).points() - 1.0).abs() < 1e-9);
        let larger: Size = "640x480".parse().unwrap();
        assert_eq!(larger.page(2.0), Page { width: 320.0, height: 240.0 });
        assert_eq!(larger.scale(2.0), Scale { factor: 2.0, unit: Unit::Pixel });
    }
}
