//! The sheet that figures are drawn on: lines, shapes and text at pixel positions that need not be whole.

use std::sync::Once;

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, PathElement, Polygon, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, FontTransform, IntoFont, IntoTextStyle, RGBColor, ShapeStyle, register_font};

use crate::Error;
use crate::palette::Colour;

/// Steps per pixel: `plotters` has integer coordinates, and a curve on whole pixels looks jagged.
pub(crate) const UNITS: u32 = 4;

/// The embedded font first, then what a viewer of the SVG is likely to have.
pub(crate) const FAMILY: &str = "Inter, Helvetica Neue, Arial, sans-serif";
/// Regular weight.
pub(crate) const REGULAR: &[u8] = include_bytes!("../fonts/Inter-Regular.otf");
/// Semi-bold weight, for titles.
pub(crate) const BOLD: &[u8] = include_bytes!("../fonts/Inter-SemiBold.otf");

/// `plotters` sizes a font by its line, 1.24 em.
pub(crate) const LINE_HEIGHT: f64 = 1.24;

/// Makes the embedded font known to `plotters`, which measures text with it.
pub(crate) fn register_fonts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        for (style, bytes) in [(FontStyle::Normal, REGULAR), (FontStyle::Bold, BOLD)] {
            // A font that cannot be read shows as an error of the first text, with the name of the family.
            let _ = register_font(FAMILY, style, bytes);
        }
    });
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// Unbroken.
    Solid,
    /// Dashes of 7 pixels.
    Dashed,
    /// Dots.
    Dotted,
}

impl Stroke {
    /// Lengths drawn and left out, in pixels.
    fn pattern(self) -> Option<(f64, f64)> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some((7.0, 4.0)),
            Self::Dotted => Some((1.5, 3.0)),
        }
    }
}

/// Colour, width in pixels and stroke of a line.
#[derive(Clone, Copy)]
pub(crate) struct Pen {
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) stroke: Stroke,
}

impl Pen {
    /// An unbroken line.
    pub(crate) fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, stroke: Stroke::Solid }
    }
}

/// How a text stands: size in pixels, and which of its points is at the given position.
#[derive(Clone, Copy)]
pub(crate) struct Type {
    pub(crate) size: f64,
    pub(crate) bold: bool,
    pub(crate) colour: Colour,
    pub(crate) across: HPos,
    pub(crate) down: VPos,
    pub(crate) upwards: bool,
}

impl Type {
    /// Regular, level text.
    pub(crate) fn new(size: f64, colour: Colour, across: HPos, down: VPos) -> Self {
        Self { size, bold: false, colour, across, down, upwards: false }
    }

    /// The same in the bold weight.
    pub(crate) fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    /// The same, read from bottom to top.
    pub(crate) fn upwards(self) -> Self {
        Self { upwards: true, ..self }
    }
}

/// A drawing area in pixels.
pub struct Sheet<B: DrawingBackend> {
    area: DrawingArea<B, Shift>,
}

fn units((x, y): (f64, f64)) -> (i32, i32) {
    let scale = f64::from(UNITS);
    ((x * scale).round() as i32, (y * scale).round() as i32)
}

fn rgb(colour: Colour) -> RGBColor {
    RGBColor(colour.0, colour.1, colour.2)
}

impl<B: DrawingBackend> Sheet<B>
where
    B::ErrorType: 'static,
{
    pub(crate) fn new(area: DrawingArea<B, Shift>) -> Self {
        Self { area }
    }

    /// A line through `points`.
    pub(crate) fn line(&self, points: &[(f64, f64)], pen: Pen) -> Result<(), Error> {
        let width = (pen.width * f64::from(UNITS)).round().max(1.0) as u32;
        let style = ShapeStyle { color: rgb(pen.colour).into(), filled: false, stroke_width: width };
        let pieces = match pen.stroke.pattern() {
            None => vec![points.to_vec()],
            Some((on, off)) => dashes(points, on, off),
        };
        for piece in pieces.into_iter().filter(|piece| piece.len() > 1) {
            self.area.draw(&PathElement::new(piece.into_iter().map(units).collect::<Vec<_>>(), style))?;
        }
        Ok(())
    }

    /// A filled polygon.
    pub(crate) fn polygon(&self, corners: &[(f64, f64)], colour: Colour) -> Result<(), Error> {
        let corners: Vec<_> = corners.iter().copied().map(units).collect();
        Ok(self.area.draw(&Polygon::new(corners, rgb(colour)))?)
    }

    /// A filled rectangle between two corners.
    pub(crate) fn rectangle(&self, (x0, y0): (f64, f64), (x1, y1): (f64, f64), colour: Colour) -> Result<(), Error> {
        self.polygon(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)], colour)
    }

    /// A disc.
    pub(crate) fn circle(&self, centre: (f64, f64), radius: f64, colour: Colour) -> Result<(), Error> {
        let radius = (radius * f64::from(UNITS)).round() as i32;
        let style = ShapeStyle { color: rgb(colour).into(), filled: true, stroke_width: 1 };
        Ok(self.area.draw(&Circle::new(units(centre), radius, style))?)
    }

    /// A line of text.
    pub(crate) fn text(&self, text: &str, at: (f64, f64), kind: Type) -> Result<(), Error> {
        let style = if kind.bold { FontStyle::Bold } else { FontStyle::Normal };
        let turn = if kind.upwards { FontTransform::Rotate270 } else { FontTransform::None };
        let font = (FAMILY, kind.size * LINE_HEIGHT * f64::from(UNITS), style).into_font().transform(turn);
        let style = font.color(&rgb(kind.colour)).into_text_style(&self.area).pos(Pos::new(kind.across, kind.down));
        Ok(self.area.draw(&Text::new(text.to_owned(), units(at), style))?)
    }
}

/// Width of `text` in pixels at `size`, in the regular weight; 0 if it cannot be measured.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let font = (FAMILY, size * LINE_HEIGHT * f64::from(UNITS)).into_font();
    font.layout_box(text).map_or(0.0, |((x0, _), (x1, _))| f64::from(x1 - x0) / f64::from(UNITS))
}

/// Cuts a line into pieces of length `on` with gaps of length `off`.
fn dashes(points: &[(f64, f64)], on: f64, off: f64) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = Vec::new();
    let mut piece: Vec<(f64, f64)> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, on);
    for pair in points.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        let length = (x1 - x0).hypot(y1 - y0);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let at = (x0 + (x1 - x0) * done / length, y0 + (y1 - y0) * done / length);
            if drawing {
                piece.push(at);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![at];
            }
            drawing = !drawing;
            left = if drawing { on } else { off };
        }
        left -= length - done;
        if drawing {
            piece.push((x1, y1));
        }
    }
    pieces.push(piece);
    pieces
}
