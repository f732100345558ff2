//! The colours of Okabe and Ito, "Color Universal Design" (2008), but for their yellow, which is faint on white: told
//! apart with any colour vision, and in grey.

/// Red, green and blue, 0 to 255.
pub type Colour = (u8, u8, u8);

/// Black.
pub const BLACK: Colour = (0, 0, 0);
/// Orange.
pub const ORANGE: Colour = (230, 159, 0);
/// Sky blue.
pub const SKY: Colour = (86, 180, 233);
/// Bluish green.
pub const GREEN: Colour = (0, 158, 115);
/// Blue.
pub const BLUE: Colour = (0, 114, 178);
/// Vermilion.
pub const VERMILION: Colour = (213, 94, 0);
/// Reddish purple.
pub const PURPLE: Colour = (204, 121, 167);
/// A neutral grey for what is not the subject.
pub const GREY: Colour = (120, 120, 120);

/// White.
pub(crate) const WHITE: Colour = (255, 255, 255);
/// Text and axes.
pub(crate) const INK: Colour = (38, 38, 38);
/// Major grid lines.
pub(crate) const GRID: Colour = (222, 222, 222);

/// `colour` mixed with white: 1 leaves it, 0 gives white.
#[must_use]
pub fn tint(colour: Colour, strength: f64) -> Colour {
    let mix = |channel: u8| (255.0 - (255.0 - f64::from(channel)) * strength.clamp(0.0, 1.0)).round() as u8;
    (mix(colour.0), mix(colour.1), mix(colour.2))
}

/// Black or white, whichever is read more easily on `background` (by its luma, ITU-R BT.601).
pub(crate) fn ink_on(background: Colour) -> Colour {
    let luma = 0.299 * f64::from(background.0) + 0.587 * f64::from(background.1) + 0.114 * f64::from(background.2);
    if luma > 140.0 { INK } else { WHITE }
}
