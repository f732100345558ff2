//! One figure of each kind with made-up data, to look at when the drawing changes:
//! `cargo run -p pendula-plot --example gallery` writes to `target/gallery/`.

use std::path::Path;

use pendula_plot::{Category, Cell, Curve, Error, Figure, LogLog, Map, Marker, Panel, Panels, Series, Stroke, palette};

fn main() -> Result<(), Error> {
    let directory = Path::new("target/gallery");
    for files in [
        panels().save(&directory.join("panels"))?,
        scatter().save(&directory.join("scatter"))?,
        map().save(&directory.join("map"))?,
    ] {
        println!("{} {}", files[0].display(), files[1].display());
    }
    Ok(())
}

fn panels() -> Panels {
    let over = |f: fn(f64) -> f64| (0..=600).map(move |i| f64::from(i) / 50.0).map(move |t| (t, f(t)));
    let motion = [
        Curve::new("exact", palette::BLACK, over(|t| 2.7 * t.cos())),
        Curve::new("harmonic, Eq. 17", palette::ORANGE, over(|t| 2.5 * t.cos())).stroke(Stroke::Dashed),
        Curve::new("Fourier, Eq. 22, N = 4", palette::BLUE, over(|t| 2.6 * (1.01 * t).cos())).stroke(Stroke::Dotted),
    ];
    let deviation = [
        Curve::new("harmonic, Eq. 17", palette::ORANGE, over(|t| 0.2 * (3.0 * t).cos())).stroke(Stroke::Dashed),
        Curve::new("Fourier, Eq. 22, N = 4", palette::BLUE, over(|t| 0.01 * (9.0 * t).cos())).stroke(Stroke::Dotted),
    ];
    Panels {
        title: "Released at θ₀ = 7π/8".into(),
        x_label: "ωt".into(),
        panels: vec![
            Panel::new("θ (rad)", motion),
            Panel { share: 0.7, ..Panel::new("deviation from θ (rad)", deviation) },
        ],
    }
}

fn scatter() -> LogLog {
    let line = |label: &str, colour, marker, start: f64, slope: f64| Series {
        label: label.into(),
        colour,
        marker: Some(marker),
        line: Some((Stroke::Solid, 2.0)),
        points: (0..13).map(|i| (start * 1.2_f64.powi(i), 1e-3 * 10.0_f64.powf(slope * f64::from(i)))).collect(),
    };
    let lone = |label: &str, colour, marker, x, y| Series {
        label: label.into(),
        colour,
        marker: Some(marker),
        line: None,
        points: vec![(x, y)],
    };
    LogLog {
        title: "Run time against error, θ₀ = 7π/8".into(),
        x_label: "time per value (ns)".into(),
        y_label: "largest error (rad)".into(),
        y_range: (1e-17, 20.0),
        series: vec![
            line("pendula, planned", palette::BLUE, Marker::Disc, 0.9, -1.0),
            line("the formula as written", palette::ORANGE, Marker::Square, 40.0, -0.5),
            lone("RK4", palette::GREEN, Marker::Triangle, 12.0, 1e-4),
            lone("leapfrog", palette::VERMILION, Marker::Nabla, 9.0, 2e-2),
            lone("GSL", palette::PURPLE, Marker::Diamond, 131.0, 1e-13),
            lone("Boost.Math", palette::SKY, Marker::Cross, 220.0, 3e-14),
        ],
    }
}

fn map() -> Map {
    let cell = |row: u32, column: u32| {
        let category = ((row + column) / 8) as usize;
        Cell { category, strength: 0.4 + 0.05 * f64::from(row), text: (row + column).to_string() }
    };
    Map {
        title: "Planned methods".into(),
        x_label: "promised error (rad)".into(),
        y_label: "release angle θ₀".into(),
        columns: ["10⁻¹", "10⁻³", "10⁻⁵", "10⁻⁷", "10⁻⁹", "10⁻¹¹", "10⁻¹³", "full"].map(String::from).into(),
        rows: ["10⁻⁶", "π/6", "π/3", "π/2", "7π/8", "0.99π", "π − 10⁻⁶"].map(String::from).into(),
        categories: [("harmonic", palette::ORANGE), ("series", palette::GREEN), ("polynomial", palette::BLUE)]
            .map(|(label, colour)| Category { label: label.into(), colour })
            .into(),
        cells: (0..7).map(|row| (0..8).map(|column| cell(row, column)).collect()).collect(),
        note: "Numbers: terms.\nDarker: more operations.".into(),
    }
}
