//! A back end of `plotters` that rasterises with `tiny-skia`, smooth lines and outlined text included.

use ab_glyph::{Font, FontRef, OutlineCurve};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontStyle,
    FontTransform,
};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, Transform};

use crate::Error;
use crate::sheet::{BOLD, LINE_HEIGHT, REGULAR};

type Drawn = Result<(), DrawingErrorKind<std::io::Error>>;

/// An image that takes drawing calls in canvas units.
pub(crate) struct Raster {
    image: Pixmap,
    canvas: (u32, u32),
    to_pixels: Transform,
    regular: FontRef<'static>,
    bold: FontRef<'static>,
}

impl Raster {
    /// A white image of `size` pixels that shows a canvas of `canvas` units.
    pub(crate) fn new(canvas: (u32, u32), size: (u32, u32)) -> Result<Self, Error> {
        let font = |bytes| FontRef::try_from_slice(bytes).map_err(|why| Error::Drawing(why.to_string()));
        let mut image = Pixmap::new(size.0, size.1).ok_or_else(|| Error::Drawing("an empty image".into()))?;
        image.fill(Color::WHITE);
        let scale = size.0 as f32 / canvas.0 as f32;
        let to_pixels = Transform::from_scale(scale, scale);
        Ok(Self { image, canvas, to_pixels, regular: font(REGULAR)?, bold: font(BOLD)? })
    }

    /// The image as a PNG file.
    pub(crate) fn png(&self) -> Result<Vec<u8>, Error> {
        self.image.encode_png().map_err(|why| Error::Drawing(why.to_string()))
    }

    fn fill(&mut self, path: Option<Path>, colour: BackendColor) {
        if let Some(path) = path {
            self.image.fill_path(&path, &paint(colour), FillRule::Winding, self.to_pixels, None);
        }
    }

    fn stroke(&mut self, path: Option<Path>, colour: BackendColor, width: u32) {
        if let Some(path) = path {
            let stroke = Stroke {
                width: width as f32,
                line_cap: LineCap::Butt,
                line_join: LineJoin::Round,
                ..Stroke::default()
            };
            self.image.stroke_path(&path, &paint(colour), &stroke, self.to_pixels, None);
        }
    }
}

fn paint(colour: BackendColor) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    let (red, green, blue) = colour.rgb;
    paint.set_color_rgba8(red, green, blue, (colour.alpha * 255.0).round() as u8);
    paint
}

fn path(points: impl IntoIterator<Item = BackendCoord>, close: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for (index, (x, y)) in points.into_iter().enumerate() {
        if index == 0 {
            builder.move_to(x as f32, y as f32);
        } else {
            builder.line_to(x as f32, y as f32);
        }
    }
    if close {
        builder.close();
    }
    builder.finish()
}

/// The outline of `text` from the origin along the base line, y downwards, and its width; `em` in canvas units.
fn outline(font: &FontRef<'_>, text: &str, em: f32) -> (Option<Path>, f32) {
    let scale = em / font.units_per_em().unwrap_or(1000.0);
    let mut builder = PathBuilder::new();
    let mut x = 0.0;
    for character in text.chars() {
        let glyph = font.glyph_id(character);
        let curves = font.outline(glyph).map(|outline| outline.curves).unwrap_or_default();
        trace(&mut builder, &curves, |point| (x + point.x * scale, -point.y * scale));
        x += font.h_advance_unscaled(glyph) * scale;
    }
    (builder.finish(), x)
}

/// Adds one glyph; its contours follow each other without a mark, so a jump of the pen starts the next.
fn trace(builder: &mut PathBuilder, curves: &[OutlineCurve], place: impl Fn(ab_glyph::Point) -> (f32, f32)) {
    let mut pen = None;
    for curve in curves {
        let (start, end) = match curve {
            OutlineCurve::Line(a, b) | OutlineCurve::Quad(a, _, b) | OutlineCurve::Cubic(a, _, _, b) => (*a, *b),
        };
        if pen != Some(start) {
            let (x, y) = place(start);
            builder.move_to(x, y);
        }
        let (x, y) = place(end);
        match curve {
            OutlineCurve::Line(..) => builder.line_to(x, y),
            OutlineCurve::Quad(_, c, _) => {
                let (cx, cy) = place(*c);
                builder.quad_to(cx, cy, x, y);
            }
            OutlineCurve::Cubic(_, c, d, _) => {
                let ((cx, cy), (dx, dy)) = (place(*c), place(*d));
                builder.cubic_to(cx, cy, dx, dy, x, y);
            }
        }
        pen = Some(end);
    }
}

impl DrawingBackend for Raster {
    type ErrorType = std::io::Error;

    fn get_size(&self) -> (u32, u32) {
        self.canvas
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, (x, y): BackendCoord, colour: BackendColor) -> Drawn {
        let square = Rect::from_xywh(x as f32, y as f32, 1.0, 1.0).map(PathBuilder::from_rect);
        self.fill(square, colour);
        Ok(())
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, points: I, style: &S) -> Drawn {
        self.stroke(path(points, false), style.color(), style.stroke_width());
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        (x0, y0): BackendCoord,
        (x1, y1): BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let outline = path([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], true);
        if fill {
            self.fill(outline, style.color());
        } else {
            self.stroke(outline, style.color(), style.stroke_width());
        }
        Ok(())
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, fill: bool) -> Drawn {
        let circle = PathBuilder::from_circle(centre.0 as f32, centre.1 as f32, radius as f32);
        if fill {
            self.fill(circle, style.color());
        } else {
            self.stroke(circle, style.color(), style.stroke_width());
        }
        Ok(())
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, corners: I, style: &S) -> Drawn {
        self.fill(path(corners, true), style.color());
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        let em = (style.size() / LINE_HEIGHT) as f32;
        let font = if matches!(style.style(), FontStyle::Bold) { &self.bold } else { &self.regular };
        let (outline, width) = outline(font, text, em);
        let dx = match style.anchor().h_pos {
            HPos::Left => 0.0,
            HPos::Center => -width / 2.0,
            HPos::Right => -width,
        };
        // As the SVG back end does it: 0.76 em down, or half the height of an x (1.118/2.048 em in Inter) up or down.
        let half_x = 0.273 * em;
        let dy = match style.anchor().v_pos {
            VPos::Top => 0.76 * em,
            VPos::Center => half_x,
            VPos::Bottom => -half_x,
        };
        let turn = match style.transform() {
            FontTransform::None => 0.0,
            FontTransform::Rotate90 => 90.0,
            FontTransform::Rotate180 => 180.0,
            FontTransform::Rotate270 => 270.0,
        };
        let place = Transform::from_translate(at.0 as f32, at.1 as f32).pre_rotate(turn).pre_translate(dx, dy);
        self.fill(outline.and_then(|outline| outline.transform(place)), style.color());
        Ok(())
    }
}
