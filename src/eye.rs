//! Where the scene is looked at from, as the command line and scenarios tell it.

use crate::document::Document;
use anyhow::bail;
use octoscope_figure::{Camera, Lens, Page};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Where the scene is looked at from.
#[derive(Clone, Debug, PartialEq)]
pub struct Eye {
    /// Turn about the z axis; 0 looks from +x, 90 from +y.
    pub yaw_degrees: f64,
    /// Height above the plane of x and y; 90 looks from above.
    pub pitch_degrees: f64,
    /// 1 where everything fits.
    pub zoom: f64,
    /// Point of the world in the middle of the page; empty where everything
    /// fits around it.
    pub middle: Vec<f64>,
    /// How depth looks; in words only that parallel lines stay parallel.
    pub lens: Lens,
}

/// Why a text does not say where the scene is looked at from.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum EyeError {
    /// There is something else than numbers.
    #[error("give numbers such as -30,20,1.5")]
    NoNumbers,
    /// There are more or less of them.
    #[error(
        "there are {0} numbers; give three: yaw and pitch in degrees, zoom; and then, if you like, \
         the point in the middle, and the word parallel"
    )]
    Count(usize),
    /// The height is none.
    #[error("the pitch is {0}; give degrees from -90 to 90")]
    Pitch(f64),
    /// The zoom is too small or too large.
    #[error("the zoom is {0}; give a factor from 0.001 to 1000000")]
    Zoom(f64),
}

/// What an eye says of parallel lines that stay parallel.
const PARALLEL: &str = "parallel";

/// Smallest and largest zoom.
const ZOOMS: [f64; 2] = [0.001, 1e6];

impl Eye {
    /// The eye of a camera that looks at `document` on `page`, in few digits.
    pub fn of<const D: usize>(camera: &Camera<D>, document: &Document<D>, page: Page) -> Self {
        let degrees = |angle: f64| (angle.to_degrees() * 100.0).round() / 100.0;
        let pitch_degrees = degrees(camera.pitch).clamp(-90.0, 90.0);
        let yaw_degrees = degrees(camera.yaw).rem_euclid(360.0);
        let (zoom, middle, lens) = (1.0, Vec::new(), camera.lens);
        let mut eye = Self { yaw_degrees, pitch_degrees, zoom, middle, lens };
        let framed = eye.framed(document, page);
        eye.zoom = short(framed.height / camera.height).clamp(ZOOMS[0], ZOOMS[1]);
        // A thousandth of what the page shows is not seen.
        let unit = 10f64.powf((camera.height * 1e-3).log10().floor());
        let rounded = |x: f64| format!("{:.12}", (x / unit).round() * unit).parse().unwrap_or(x);
        eye.middle = camera.target.map(rounded).to_vec();
        eye
    }

    /// The camera.
    ///
    /// # Errors
    /// Refuses a middle of another dimension than the scene.
    pub fn camera<const D: usize>(
        &self,
        document: &Document<D>,
        page: Page,
    ) -> anyhow::Result<Camera<D>> {
        let mut camera = self.framed(document, page);
        camera.height /= self.zoom;
        if self.middle.is_empty() {
            return Ok(camera);
        }
        let Ok(middle) = <[f64; D]>::try_from(&self.middle[..]) else {
            bail!(
                "the middle of --camera has {} numbers; give {D} in this scene, or none",
                self.middle.len()
            );
        };
        camera.target = middle;
        Ok(camera)
    }

    fn framed<const D: usize>(&self, document: &Document<D>, page: Page) -> Camera<D> {
        let mut camera = document.framed(page);
        camera.yaw = self.yaw_degrees.rem_euclid(360.0).to_radians();
        camera.pitch = self.pitch_degrees.to_radians();
        // In the plane a lens means nothing.
        camera.lens = if D == 2 { Lens::default() } else { self.lens };
        document.frame(&mut camera, page);
        camera
    }
}

/// Four digits of a number.
fn short(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

impl FromStr for Eye {
    type Err = EyeError;

    fn from_str(text: &str) -> Result<Self, EyeError> {
        let (text, lens) = match text.rsplit_once(',') {
            Some((numbers, word)) if word.trim() == PARALLEL => (numbers, Lens::Orthographic),
            Some(_) | None => (text, Lens::Perspective),
        };
        let numbers: Result<Vec<f64>, _> =
            text.split(',').map(|number| number.trim().parse()).collect();
        let numbers = numbers.ok().filter(|numbers| numbers.iter().all(|x| x.is_finite()));
        let numbers = numbers.ok_or(EyeError::NoNumbers)?;
        let ([yaw_degrees, pitch_degrees, zoom], 0 | 2 | 3) =
            (numbers.first_chunk().copied().unwrap_or([f64::NAN; 3]), numbers.len().max(3) - 3)
        else {
            return Err(EyeError::Count(numbers.len()));
        };
        if numbers.len() < 3 {
            return Err(EyeError::Count(numbers.len()));
        }
        if !(-90.0..=90.0).contains(&pitch_degrees) {
            return Err(EyeError::Pitch(pitch_degrees));
        }
        if !(ZOOMS[0]..=ZOOMS[1]).contains(&zoom) {
            return Err(EyeError::Zoom(zoom));
        }
        Ok(Self { yaw_degrees, pitch_degrees, zoom, middle: numbers[3..].to_vec(), lens })
    }
}

impl fmt::Display for Eye {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{},{},{}", self.yaw_degrees, self.pitch_degrees, self.zoom)?;
        self.middle.iter().try_for_each(|x| write!(f, ",{x}"))?;
        match self.lens {
            Lens::Perspective => Ok(()),
            Lens::Orthographic => write!(f, ",{PARALLEL}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::AnyDocument;
    use crate::open::open_built_in;
    use octoscope_core::progress::Progress;

    #[test]
    fn the_eye_has_three_numbers_within_bounds_and_a_middle() {
        let (far, parallel) = (Lens::Perspective, Lens::Orthographic);
        let eye = |middle: &[f64], lens| Eye {
            yaw_degrees: -30.0,
            pitch_degrees: 20.0,
            zoom: 1.5,
            middle: middle.to_vec(),
            lens,
        };
        for (text, eye) in [
            ("-30,20,1.5", eye(&[], far)),
            ("-30,20,1.5,0.5,-1", eye(&[0.5, -1.0], far)),
            ("-30,20,1.5,parallel", eye(&[], parallel)),
            ("-30,20,1.5,0.5,-1,2,parallel", eye(&[0.5, -1.0, 2.0], parallel)),
        ] {
            assert_eq!(text.parse(), Ok(eye.clone()));
            assert_eq!(eye.to_string(), text);
        }
        for bad in [
            "-30,20",
            "1,2,3,4",
            "0,91,1",
            "0,0,0",
            "0,0,-1",
            "0,0,nan",
            "a,b,c",
            "",
            "parallel",
            "1,2,3,par",
        ] {
            assert!(bad.parse::<Eye>().is_err(), "{bad}");
        }
    }

    #[test]
    fn parallel_lines_stay_so_in_space_alone() {
        let page = Page { width: 400.0, height: 300.0 };
        let eye: Eye = "-30,20,1.5,parallel".parse().unwrap();
        for (id, lens) in [("points-3d", Lens::Orthographic), ("quadtree-82", Lens::Perspective)] {
            let document = open_built_in(id, &Progress::default()).unwrap();
            let found = match &document {
                AnyDocument::Plane(document) => eye.camera(document, page).unwrap().lens,
                AnyDocument::Space(document) => {
                    let camera = eye.camera(document, page).unwrap();
                    assert_eq!(Eye::of(&camera, document, page).lens, Lens::Orthographic);
                    camera.lens
                }
            };
            assert_eq!(found, lens, "{id}");
        }
    }

    #[test]
    fn an_eye_looks_as_its_camera_does() {
        let document = open_built_in("quadtree-82", &Progress::default()).unwrap();
        let AnyDocument::Plane(document) = document else { panic!("not a quadtree") };
        let page = Page { width: 400.0, height: 300.0 };
        let mut camera = document.framed(page);
        (camera.height, camera.target) = (camera.height / 3.0, [0.123_456, 0.7]);
        let again = Eye::of(&camera, &document, page).camera(&document, page).unwrap();
        assert!((again.height / camera.height - 1.0).abs() < 1e-3);
        for e in 0..2 {
            assert!((again.target[e] - camera.target[e]).abs() < 1e-3 * camera.height);
        }
    }
}
