//! Figures of the examples and the benchmarks: stacked line panels, log-log scatter plots with a frontier, and maps of
//! categories. Each is a plain value that [`Figure::save`] writes as SVG and as PNG.
//!
//! Both files come from the same drawing calls of `plotters`. The SVG is its own back end's; the PNG is rasterised by
//! `tiny-skia` with the embedded font, so a machine needs no font and no graphics library. Colours are the
//! colour-blind-safe set of Okabe and Ito.
//!
//! ```
//! use pendula_plot::{Curve, Figure, Panel, Panels, palette};
//!
//! let curve = Curve::new("cos t", palette::BLUE, (0..100).map(|i| f64::from(i) / 10.0).map(|t| (t, t.cos())));
//! let figure = Panels { title: "A cosine".into(), x_label: "t".into(), panels: vec![Panel::new("θ (rad)", [curve])] };
//! let files = figure.save(&std::env::temp_dir().join("pendula-plot-doc"))?;
//! assert!(files.iter().all(|file| file.exists()));
//! # Ok::<(), pendula_plot::Error>(())
//! ```
#![forbid(unsafe_code)]

mod axis;
mod clip;
mod frame;
mod map;
pub mod palette;
mod panels;
mod raster;
mod scatter;
mod sheet;

use std::cell::RefCell;
use std::fmt;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use plotters::drawing::{DrawingAreaErrorKind, IntoDrawingArea};
use plotters::prelude::{DrawingBackend, SVGBackend};

pub use axis::power_of_ten;
pub use map::{Category, Cell, Map};
pub use panels::{Curve, Panel, Panels};
pub use scatter::{LogLog, Marker, Series};
pub use sheet::Stroke;

use raster::Raster;
use sheet::{Sheet, UNITS};

/// Device pixels of the PNG per pixel of the figure, so that it stays sharp on a dense screen.
const PNG_SCALE: u32 = 2;

/// Anything that can be drawn on one sheet.
pub trait Figure {
    /// Width and height in pixels.
    fn size(&self) -> (u32, u32);

    /// Draws it; [`Figure::save`] calls this once per file.
    ///
    /// # Errors
    /// When the back end fails to draw.
    #[doc(hidden)]
    fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>) -> Result<(), Error>
    where
        B::ErrorType: 'static;

    /// Writes `stem.svg` and `stem.png`, makes the directory if there is none, and returns the two paths.
    ///
    /// # Errors
    /// When a file cannot be written.
    fn save(&self, stem: &Path) -> Result<[PathBuf; 2], Error> {
        let svg = self.save_svg(stem)?;
        let (width, height) = self.size();
        let size = (width * PNG_SCALE, height * PNG_SCALE);
        let raster = Rc::new(RefCell::new(Raster::new((width * UNITS, height * UNITS), size)?));
        self.draw(&Sheet::new((&raster).into()))?;
        let png = with_extension(stem, "png");
        std::fs::write(&png, raster.borrow().png()?)?;
        Ok([svg, png])
    }

    /// Writes `stem.svg` alone.
    ///
    /// # Errors
    /// When the file cannot be written.
    fn save_svg(&self, stem: &Path) -> Result<PathBuf, Error> {
        sheet::register_fonts();
        if let Some(directory) = stem.parent() {
            std::fs::create_dir_all(directory)?;
        }
        let (width, height) = self.size();
        let canvas = (width * UNITS, height * UNITS);
        let mut text = String::new();
        self.draw(&Sheet::new(SVGBackend::with_string(&mut text, canvas).into_drawing_area()))?;
        // The drawing has integer coordinates, so it is made large and shown at its nominal size through the view box.
        let shown = text.replacen(
            &format!("width=\"{}\" height=\"{}\"", canvas.0, canvas.1),
            &format!("width=\"{width}\" height=\"{height}\""),
            1,
        );
        let svg = with_extension(stem, "svg");
        std::fs::write(&svg, shown)?;
        Ok(svg)
    }
}

/// `stem` with `.extension` added, whatever dots it has.
fn with_extension(stem: &Path, extension: &str) -> PathBuf {
    PathBuf::from(format!("{}.{extension}", stem.display()))
}

/// Why a figure could not be written.
#[derive(Debug)]
pub enum Error {
    /// A drawing operation failed, or the image could not be encoded.
    Drawing(String),
    /// A file could not be written.
    Io(std::io::Error),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Drawing(why) => write!(f, "the figure could not be drawn: {why}"),
            Self::Io(why) => write!(f, "the figure could not be written: {why}"),
        }
    }
}

impl std::error::Error for Error {}

impl From<std::io::Error> for Error {
    fn from(why: std::io::Error) -> Self {
        Self::Io(why)
    }
}

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for Error {
    fn from(why: DrawingAreaErrorKind<E>) -> Self {
        Self::Drawing(why.to_string())
    }
}
