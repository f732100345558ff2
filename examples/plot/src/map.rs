//! A map: rows and columns of cells coloured by category, with a text in each.

use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, VPos};

use crate::frame::{LABEL_SIZE, TICK_SIZE, Window, title};
use crate::palette::{Colour, INK, WHITE, ink_on, tint};
use crate::sheet::{Sheet, Type, text_width};
use crate::{Error, Figure};

/// What a colour stands for.
#[derive(Clone, Debug)]
pub struct Category {
    /// Its entry in the legend.
    pub label: String,
    /// Its colour at full strength.
    pub colour: Colour,
}

/// One cell.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Index into the categories.
    pub category: usize,
    /// Strength of the colour, 0 (white) to 1.
    pub strength: f64,
    /// A short text; empty for none.
    pub text: String,
}

/// Cells in rows from top to bottom.
#[derive(Clone, Debug)]
pub struct Map {
    /// Above the cells.
    pub title: String,
    /// Caption of the columns.
    pub x_label: String,
    /// Caption of the rows.
    pub y_label: String,
    /// One text per column.
    pub columns: Vec<String>,
    /// One text per row.
    pub rows: Vec<String>,
    /// What the colours stand for.
    pub categories: Vec<Category>,
    /// `cells[row][column]`.
    pub cells: Vec<Vec<Cell>>,
    /// What the texts and the strength of the colours stand for; below the categories. Lines are split at `\n`.
    pub note: String,
}

/// Size of a cell, in pixels.
const CELL: (f64, f64) = (46.0, 26.0);
const MARGIN: Window = Window { left: 104.0, top: 44.0, right: 18.0, bottom: 54.0 };
const LEGEND_STEP: f64 = 23.0;

impl Map {
    fn window(&self) -> Window {
        Window {
            left: MARGIN.left,
            top: MARGIN.top,
            right: MARGIN.left + CELL.0 * self.columns.len() as f64,
            bottom: MARGIN.top + CELL.1 * self.rows.len() as f64,
        }
    }

    fn legend_width(&self) -> f64 {
        let labels = self.categories.iter().map(|category| text_width(&category.label, LABEL_SIZE) + 26.0);
        labels.chain(self.note.lines().map(|line| text_width(line, TICK_SIZE))).fold(0.0, f64::max)
    }

    fn colour(&self, cell: &Cell) -> Colour {
        self.categories.get(cell.category).map_or(WHITE, |category| tint(category.colour, cell.strength))
    }

    fn draw_cells<B: DrawingBackend>(&self, sheet: &Sheet<B>, window: Window) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let text = Type::new(TICK_SIZE, INK, HPos::Center, VPos::Center);
        for (row, cells) in self.cells.iter().enumerate() {
            for (column, cell) in cells.iter().enumerate() {
                let (x, y) = (window.left + CELL.0 * column as f64, window.top + CELL.1 * row as f64);
                let colour = self.colour(cell);
                sheet.rectangle((x + 0.5, y + 0.5), (x + CELL.0 - 0.5, y + CELL.1 - 0.5), colour)?;
                let middle = (x + CELL.0 / 2.0, y + CELL.1 / 2.0);
                sheet.text(&cell.text, middle, Type { colour: ink_on(colour), ..text })?;
            }
        }
        Ok(())
    }

    fn draw_captions<B: DrawingBackend>(&self, sheet: &Sheet<B>, window: Window) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        for (column, label) in self.columns.iter().enumerate() {
            let x = window.left + CELL.0 * (column as f64 + 0.5);
            sheet.text(label, (x, window.bottom + 7.0), Type::new(TICK_SIZE, INK, HPos::Center, VPos::Top))?;
        }
        for (row, label) in self.rows.iter().enumerate() {
            let y = window.top + CELL.1 * (row as f64 + 0.5);
            sheet.text(label, (window.left - 8.0, y), Type::new(TICK_SIZE, INK, HPos::Right, VPos::Center))?;
        }
        let caption = Type::new(LABEL_SIZE, INK, HPos::Center, VPos::Top);
        sheet.text(&self.x_label, (f64::midpoint(window.left, window.right), window.bottom + 29.0), caption)?;
        let middle = f64::midpoint(window.top, window.bottom);
        sheet.text(&self.y_label, (14.0, middle), caption.upwards())
    }

    fn draw_legend<B: DrawingBackend>(&self, sheet: &Sheet<B>, window: Window) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let left = window.right + MARGIN.right;
        let mut y = window.top + 10.0;
        for category in &self.categories {
            sheet.rectangle((left, y - 7.0), (left + 18.0, y + 7.0), category.colour)?;
            sheet.text(&category.label, (left + 26.0, y), Type::new(LABEL_SIZE, INK, HPos::Left, VPos::Center))?;
            y += LEGEND_STEP;
        }
        y += 6.0;
        for line in self.note.lines() {
            sheet.text(line, (left, y), Type::new(TICK_SIZE, INK, HPos::Left, VPos::Center))?;
            y += 17.0;
        }
        Ok(())
    }
}

impl Figure for Map {
    fn size(&self) -> (u32, u32) {
        let window = self.window();
        let width = window.right + MARGIN.right + self.legend_width() + 14.0;
        (width.ceil() as u32, (window.bottom + MARGIN.bottom).ceil() as u32)
    }

    fn draw<B: DrawingBackend>(&self, sheet: &Sheet<B>) -> Result<(), Error>
    where
        B::ErrorType: 'static,
    {
        let window = self.window();
        title(sheet, &self.title, window)?;
        self.draw_cells(sheet, window)?;
        self.draw_captions(sheet, window)?;
        self.draw_legend(sheet, window)
    }
}
