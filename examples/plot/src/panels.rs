//! Line panels, one above the other, with a common horizontal axis.

use std::ops::RangeInclusive;

use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};

use crate::axis::Axis;
use crate::clip::clip;
use crate::frame::{Frame, LABEL_SIZE, Window, title};
use crate::palette::{Colour, INK};
use crate::sheet::{Pen, Sheet, Stroke, Type, text_width};
use crate::{Error, Figure};

/// A line with a name; curves of one name in several panels share an entry of the legend.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its entry in the legend; none if empty.
    pub label: String,
    /// Its colour.
    pub colour: Colour,
    /// Unbroken, dashed or dotted.
    pub stroke: Stroke,
    /// Width in pixels.
    pub width: f64,
    /// Its points from left to right; one that is not finite breaks the line.
    pub points: Vec<(f64, f64)>,
}

impl Curve {
    /// An unbroken line, 2 pixels wide.
    pub fn new(label: &str, colour: Colour, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { label: label.into(), colour, stroke: Stroke::Solid, width: 2.0, points: points.into_iter().collect() }
    }

    /// The same with another stroke.
    #[must_use]
    pub fn stroke(self, stroke: Stroke) -> Self {
        Self { stroke, ..self }
    }
}

/// One panel.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Caption of the vertical axis.
    pub y_label: String,
    /// Range of the vertical axis; that of the curves if none is given. What lies outside is cut off.
    pub y_range: Option<RangeInclusive<f64>>,
    /// Height beside that of the other panels.
    pub share: f64,
    /// The lines, drawn in this order.
    pub curves: Vec<Curve>,
}

impl Panel {
    /// A panel that shows all of its curves.
    pub fn new(y_label: &str, curves: impl IntoIterator<Item = Curve>) -> Self {
        Self { y_label: y_label.into(), y_range: None, share: 1.0, curves: curves.into_iter().collect() }
    }

    fn values(&self) -> impl Iterator<Item = (f64, f64)> {
        self.curves.iter().flat_map(|curve| &curve.points).copied()
    }
}

/// Panels above each other.
#[derive(Clone, Debug)]
pub struct Panels {
    /// Above the first panel.
    pub title: String,
    /// Caption of the common horizontal axis.
    pub x_label: String,
    /// From top to bottom.
    pub panels: Vec<Panel>,
}

/// The sheet is this wide, and this much of it goes to captions left, right, above and below.
const WIDTH: u32 = 820;
const MARGIN: Window = Window { left: 84.0, top: 66.0, right: 20.0, bottom: 54.0 };
/// Height of a panel of share 1, and the gap between two, in pixels.
const HEIGHT: f64 = 220.0;
const GAP: f64 = 16.0;

impl Panels {
    fn windows(&self) -> Vec<Window> {
        let mut top = MARGIN.top;
        let place = |panel: &Panel| {
            let window = Window {
                left: MARGIN.left,
                top,
                right: f64::from(WIDTH) - MARGIN.right,
                bottom: top + HEIGHT * panel.share,
            };
            top = window.bottom + GAP;
            window
        };
        self.panels.iter().map(place).collect()
    }

    /// Every name once, in the order of appearance, in one row above the first panel.
    fn legend<B: DrawingBackend>(&self, sheet: &Sheet<B>, window: Window) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let mut named: Vec<&Curve> = Vec::new();
        for curve in self.panels.iter().flat_map(|panel| &panel.curves).filter(|curve| !curve.label.is_empty()) {
            if named.iter().all(|seen| seen.label != curve.label) {
                named.push(curve);
            }
        }
        let (mut x, y) = (window.left, window.top - 13.0);
        for curve in named {
            let pen = Pen { colour: curve.colour, width: curve.width, stroke: curve.stroke };
            sheet.line(&[(x, y), (x + 28.0, y)], pen)?;
            sheet.text(&curve.label, (x + 34.0, y), Type::new(LABEL_SIZE, INK, HPos::Left, VPos::Center))?;
            x += 34.0 + text_width(&curve.label, LABEL_SIZE) + 22.0;
        }
        Ok(())
    }
}

impl Figure for Panels {
    fn size(&self) -> (u32, u32) {
        let bottom = self.windows().last().map_or(MARGIN.top, |window| window.bottom);
        (WIDTH, (bottom + MARGIN.bottom).round() as u32)
    }

    fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let windows = self.windows();
        let xs = self.panels.iter().flat_map(Panel::values).map(|(x, _)| x).filter(|x| x.is_finite());
        let (low, high) = xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let x = Axis::linear(&self.x_label, if low < high { low..=high } else { 0.0..=1.0 });
        for (index, (panel, &window)) in self.panels.iter().zip(&windows).enumerate() {
            let y = match &panel.y_range {
                Some(range) => Axis::linear(&panel.y_label, range.clone()),
                None => {
                    Axis::around(&panel.y_label, panel.values().map(|(_, y)| y), (window.bottom - window.top) / 45.0)
                }
            };
            let frame = Frame { window, x: x.clone(), y };
            frame.draw(sheet, index + 1 == windows.len())?;
            for curve in &panel.curves {
                let pen = Pen { colour: curve.colour, width: curve.width, stroke: curve.stroke };
                for piece in clip(&curve.points, &frame.x.range, &frame.y.range) {
                    sheet.line(&piece.into_iter().map(|point| frame.place(point)).collect::<Vec<_>>(), pen)?;
                }
            }
        }
        let Some(&first) = windows.first() else { return Ok(()) };
        title(sheet, &self.title, Window { top: first.top - 20.0, ..first })?;
        self.legend(sheet, first)
    }
}
