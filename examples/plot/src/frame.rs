//! The frame of a plot: a rectangle on the sheet with two axes.

use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};

use crate::Error;
use crate::axis::Axis;
use crate::palette::{GRID, INK, tint};
use crate::sheet::{Pen, Sheet, Type};

/// Size of the texts at ticks, of captions and legends, and of the title, in pixels.
pub(crate) const TICK_SIZE: f64 = 12.0;
pub(crate) const LABEL_SIZE: f64 = 13.0;
pub(crate) const TITLE_SIZE: f64 = 16.0;

/// A rectangle in pixels.
#[derive(Clone, Copy)]
pub(crate) struct Window {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

/// Two axes on a window.
pub(crate) struct Frame {
    pub(crate) window: Window,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
}

impl Frame {
    /// Where a point lies on the sheet.
    pub(crate) fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let Window { left, top, right, bottom } = self.window;
        (left + (right - left) * self.x.place(x), bottom - (bottom - top) * self.y.place(y))
    }

    /// Grid, ticks, border and captions; the texts below the frame only with `labelled_x`.
    pub(crate) fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>, labelled_x: bool) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        self.draw_x(sheet, labelled_x)?;
        self.draw_y(sheet)?;
        let Window { left, top, right, bottom } = self.window;
        let border = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top), (right, top)];
        sheet.line(&border, Pen::solid(INK, 1.0))
    }

    fn draw_x<B: DrawingBackend>(&self, sheet: &Sheet<B>, labelled: bool) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let Window { left, top, right, bottom } = self.window;
        let text = Type::new(TICK_SIZE, INK, HPos::Center, VPos::Top);
        for tick in self.x.ticks((right - left) / 75.0) {
            let x = left + (right - left) * tick.at;
            grid_line(sheet, [(x, top), (x, bottom)], tick.text.is_some())?;
            let length = if tick.text.is_some() { 5.0 } else { 3.0 };
            sheet.line(&[(x, bottom), (x, bottom - length)], Pen::solid(INK, 1.0))?;
            if let Some(label) = tick.text.filter(|_| labelled) {
                sheet.text(&label, (x, bottom + 6.0), text)?;
            }
        }
        if labelled {
            let caption = Type::new(LABEL_SIZE, INK, HPos::Center, VPos::Top);
            sheet.text(&self.x.label, (f64::midpoint(left, right), bottom + 27.0), caption)?;
        }
        Ok(())
    }

    fn draw_y<B: DrawingBackend>(&self, sheet: &Sheet<B>) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let Window { left, top, right, bottom } = self.window;
        let text = Type::new(TICK_SIZE, INK, HPos::Right, VPos::Center);
        for tick in self.y.ticks((bottom - top) / 38.0) {
            let y = bottom - (bottom - top) * tick.at;
            grid_line(sheet, [(left, y), (right, y)], tick.text.is_some())?;
            let length = if tick.text.is_some() { 5.0 } else { 3.0 };
            sheet.line(&[(left, y), (left + length, y)], Pen::solid(INK, 1.0))?;
            if let Some(label) = tick.text {
                sheet.text(&label, (left - 7.0, y), text)?;
            }
        }
        let caption = Type::new(LABEL_SIZE, INK, HPos::Center, VPos::Top).upwards();
        sheet.text(&self.y.label, (left - 66.0, f64::midpoint(top, bottom)), caption)
    }
}

fn grid_line<B: DrawingBackend>(sheet: &Sheet<B>, ends: [(f64, f64); 2], major: bool) -> Result<(), Error>
where
    B::ErrorType: 'static,
{
    let colour = if major { GRID } else { tint(GRID, 0.5) };
    sheet.line(&ends, Pen::solid(colour, 0.75))
}

/// The title above a window, aligned with its left edge.
pub(crate) fn title<B: DrawingBackend>(sheet: &Sheet<B>, text: &str, window: Window) -> Result<(), Error>
where
    B::ErrorType: 'static,
{
    let kind = Type::new(TITLE_SIZE, INK, HPos::Left, VPos::Center).bold();
    sheet.text(text, (window.left, window.top - 22.0), kind)
}
