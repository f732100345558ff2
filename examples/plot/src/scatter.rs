//! Points and lines over two logarithmic axes.

use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};

use crate::axis::{Axis, Scale};
use crate::clip::clip;
use crate::frame::{Frame, LABEL_SIZE, Window, title};
use crate::palette::{Colour, INK, WHITE};
use crate::sheet::{Pen, Sheet, Stroke, Type, text_width};
use crate::{Error, Figure};

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// A disc.
    Disc,
    /// A square.
    Square,
    /// A diamond.
    Diamond,
    /// A triangle on its base.
    Triangle,
    /// A triangle on its tip.
    Nabla,
    /// A cross.
    Cross,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its entry in the legend.
    pub label: String,
    /// Its colour.
    pub colour: Colour,
    /// The shape of the points; none leaves the line alone.
    pub marker: Option<Marker>,
    /// The line that joins them, in the order given, and its width in pixels.
    pub line: Option<(Stroke, f64)>,
    /// The points; those that are not positive and finite are left out.
    pub points: Vec<(f64, f64)>,
}

/// A plot over two logarithmic axes with its legend on the right.
#[derive(Clone, Debug)]
pub struct LogLog {
    /// Above the frame.
    pub title: String,
    /// Caption of the horizontal axis.
    pub x_label: String,
    /// Caption of the vertical axis.
    pub y_label: String,
    /// The ends of the vertical axis. What lies outside is cut off.
    pub y_range: (f64, f64),
    /// In the order of the legend; earlier ones lie on top.
    pub series: Vec<Series>,
}

/// Least height of the sheet, in pixels; a long legend makes it higher.
const HEIGHT: f64 = 560.0;
/// Width of the frame, in pixels.
const FRAME_WIDTH: f64 = 620.0;
const MARGIN: Window = Window { left: 84.0, top: 44.0, right: 16.0, bottom: 54.0 };
/// Radius of a marker, in pixels.
const RADIUS: f64 = 4.6;
/// Distance of the lines of the legend, in pixels.
const LEGEND_STEP: f64 = 21.0;

fn visible(series: &Series) -> impl Iterator<Item = (f64, f64)> {
    series.points.iter().copied().filter(|(x, y)| [x, y].iter().all(|v| v.is_finite() && **v > 0.0))
}

impl LogLog {
    fn height(&self) -> f64 {
        let entries = self.series.iter().filter(|series| !series.label.is_empty()).count();
        HEIGHT.max(MARGIN.top + LEGEND_STEP * entries as f64 + 8.0)
    }

    fn frame(&self) -> Frame {
        let (low, high) = self.y_range;
        let x = Axis::logarithmic(&self.x_label, self.series.iter().flat_map(visible).map(|(x, _)| x));
        let y = Axis { label: self.y_label.clone(), scale: Scale::Log, range: low.log10()..=high.log10() };
        let window = Window {
            left: MARGIN.left,
            top: MARGIN.top,
            right: MARGIN.left + FRAME_WIDTH,
            bottom: self.height() - MARGIN.bottom,
        };
        Frame { window, x, y }
    }

    fn legend_width(&self) -> f64 {
        let widths = self.series.iter().map(|series| text_width(&series.label, LABEL_SIZE));
        44.0 + widths.fold(0.0, f64::max)
    }
}

impl Figure for LogLog {
    fn size(&self) -> (u32, u32) {
        let width = MARGIN.left + FRAME_WIDTH + MARGIN.right + self.legend_width() + 12.0;
        (width.ceil() as u32, self.height().ceil() as u32)
    }

    fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let frame = self.frame();
        title(sheet, &self.title, frame.window)?;
        frame.draw(sheet, true)?;
        for series in self.series.iter().rev() {
            series.draw(sheet, &frame)?;
        }
        let left = frame.window.right + MARGIN.right;
        for (row, series) in self.series.iter().filter(|series| !series.label.is_empty()).enumerate() {
            let y = frame.window.top + 8.0 + row as f64 * LEGEND_STEP;
            if let Some((stroke, width)) = series.line {
                sheet.line(&[(left, y), (left + 28.0, y)], Pen { colour: series.colour, width, stroke })?;
            }
            if let Some(marker) = series.marker {
                marker.draw(sheet, (left + 14.0, y), series.colour)?;
            }
            sheet.text(&series.label, (left + 36.0, y), Type::new(LABEL_SIZE, INK, HPos::Left, VPos::Center))?;
        }
        Ok(())
    }
}

impl Series {
    fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>, frame: &Frame) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        if let Some((stroke, width)) = self.line {
            let logs: Vec<_> = visible(self).map(|(x, y)| (x.log10(), y.log10())).collect();
            for piece in clip(&logs, &frame.x.range, &frame.y.range) {
                let places = piece.into_iter().map(|(x, y)| frame.place((10.0_f64.powf(x), 10.0_f64.powf(y))));
                sheet.line(&places.collect::<Vec<_>>(), Pen { colour: self.colour, width, stroke })?;
            }
        }
        let Some(marker) = self.marker else { return Ok(()) };
        for point in visible(self).filter(|(_, y)| frame.y.range.contains(&y.log10())) {
            marker.draw(sheet, frame.place(point), self.colour)?;
        }
        Ok(())
    }
}

impl Marker {
    /// The shape with a white rim, so that overlapping points stay apart.
    fn draw<B: DrawingBackend>(self, sheet: &Sheet<B>, at: (f64, f64), colour: Colour) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        if self == Self::Cross {
            let arm = 0.8 * RADIUS;
            for (rim, ink) in [(4.2, WHITE), (2.2, colour)] {
                for slope in [-1.0, 1.0] {
                    let ends = [(at.0 - arm, at.1 - slope * arm), (at.0 + arm, at.1 + slope * arm)];
                    sheet.line(&ends, Pen::solid(ink, rim))?;
                }
            }
            return Ok(());
        }
        for (radius, ink) in [(RADIUS + 1.2, WHITE), (RADIUS, colour)] {
            match self.corners() {
                None => sheet.circle(at, radius, ink)?,
                Some(corners) => {
                    let corners: Vec<_> = corners.iter().map(|(x, y)| (at.0 + radius * x, at.1 + radius * y)).collect();
                    sheet.polygon(&corners, ink)?;
                }
            }
        }
        Ok(())
    }

    /// Corners about the centre for radius 1; areas near that of the disc.
    fn corners(self) -> Option<Vec<(f64, f64)>> {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| (0.9 * x, 0.9 * y));
        match self {
            Self::Disc | Self::Cross => None,
            Self::Square => Some(square.to_vec()),
            Self::Diamond => Some(vec![(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)]),
            Self::Triangle => Some(vec![(0.0, -1.25), (1.15, 0.8), (-1.15, 0.8)]),
            Self::Nabla => Some(vec![(0.0, 1.25), (1.15, -0.8), (-1.15, -0.8)]),
        }
    }
}
