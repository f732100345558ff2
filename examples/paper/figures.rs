//! The paper's figures: θ(t) above, the deviations from it below.

use crate::approximation::{Approximation, approximation};
use pendula_plot::{Curve, Figure, Panel, Panels, Stroke, palette};
use std::error::Error;
use std::path::Path;

/// One figure.
struct Drawing {
    file: &'static str,
    /// Where the paper shows it.
    place: &'static str,
    harmonic: Approximation,
    fourier: Approximation,
}

fn drawings() -> [Drawing; 4] {
    [
        Drawing {
            file: "figure-2-half-pi",
            place: "Figure 2 of the paper",
            harmonic: approximation!((π / 2), method = harmonic),
            fourier: approximation!((π / 2), n = 2),
        },
        Drawing {
            file: "figure-3-four-fifths-pi",
            place: "Figure 3 of the paper",
            harmonic: approximation!((4π / 5), method = harmonic),
            fourier: approximation!((4π / 5), n = 3),
        },
        Drawing {
            file: "figure-4-seven-eighths-pi",
            place: "Figure 4 of the paper",
            harmonic: approximation!((7π / 8), method = harmonic),
            fourier: approximation!((7π / 8), n = 4),
        },
        Drawing {
            file: "beyond-0.95-pi",
            place: "closer to the top",
            harmonic: approximation!((0.95π), method = harmonic),
            fourier: approximation!((0.95π), n = 6),
        },
    ]
}

pub(crate) fn write(directory: &Path) -> Result<(), Box<dyn Error>> {
    println!("Figures:\n");
    for drawing in drawings() {
        for file in drawing.panels()?.save(&directory.join(drawing.file))? {
            println!("  {}", file.display());
        }
    }
    Ok(())
}

impl Drawing {
    fn panels(&self) -> Result<Panels, pendula::Error> {
        let (theta0, period) = (self.fourier.theta0, self.fourier.period);
        let exact = self.fourier.exact()?;
        let over = |f: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            let points = 600;
            (0..=points).map(|i| f64::from(i) / f64::from(points)).map(|s| (s, f(s * period))).collect()
        };
        let harmonic = |points| Curve::new("harmonic (Eq. 17)", palette::ORANGE, points).stroke(Stroke::Dashed);
        let name = format!("Fourier (Eq. 22), N = {}", self.fourier.terms);
        let fourier = |points| Curve::new(&name, palette::BLUE, points);
        let deviation = |of: &Approximation| over(&|t| 100.0 * ((of.theta)(t) - exact.theta(t)) / theta0);
        let motion = [
            Curve { width: 5.0, ..Curve::new("exact", palette::tint(palette::GREY, 0.45), over(&|t| exact.theta(t))) },
            harmonic(over(&self.harmonic.theta)),
            Curve { width: 1.5, ..fourier(over(&self.fourier.theta)) },
        ];
        let both = [harmonic(deviation(&self.harmonic)), fourier(deviation(&self.fourier))];
        Ok(Panels {
            title: format!("Released at rest from θ₀ = {} ({})", self.fourier.label(), self.place),
            x_label: "t / T".into(),
            panels: vec![
                panel(1.0, "θ (rad)", motion.into()),
                panel(0.6, "deviation / θ₀ (%)", both.into()),
                panel(0.6, "Fourier alone (%)", vec![fourier(deviation(&self.fourier))]),
            ],
        })
    }
}

/// A panel as high as its curves, which lie about zero, with an eighth of room.
fn panel(share: f64, y_label: &str, curves: Vec<Curve>) -> Panel {
    let largest = curves.iter().flat_map(|curve| &curve.points).fold(0.0_f64, |largest, (_, y)| largest.max(y.abs()));
    let room = 1.125 * largest;
    Panel { share, y_range: Some(-room..=room), ..Panel::new(y_label, curves) }
}
