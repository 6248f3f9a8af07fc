//! Plot of rows of points on a logarithmic axis, as an SVG: errors and their bounds.

use std::fmt::Write as _;

/// One row: a label, points with their colors, and a bound.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotRow {
    /// Label of the row.
    pub label: String,
    /// Numbers with their colors; the last is drawn on top.
    pub points: Vec<(f64, &'static str)>,
    /// Bound of the numbers.
    pub bound: Option<f64>,
}

const WIDTH: f64 = 900.0;
const LEFT: f64 = 260.0;
const RIGHT: f64 = 28.0;
const TOP: f64 = 78.0;
const ROW: f64 = 17.0;
/// Smallest error that is drawn: f32 cannot tell smaller ones from none.
const LEAST: f64 = 1e-8;
/// Largest error that is drawn; a result that is infinite is as far off as that.
const MOST: f64 = 1e12;

/// Draws rows under a title, with a legend of colors.
pub fn svg(title: &str, axis: &str, rows: &[PlotRow], legend: &[(&str, &str)]) -> String {
    let numbers =
        || rows.iter().flat_map(|row| row.points.iter().map(|point| point.0).chain(row.bound));
    let low = numbers().fold(1e-4, |low: f64, x| low.min(x.max(LEAST))).log10().floor();
    let high = numbers().fold(1e-6, f64::max).min(MOST).log10().ceil();
    let at = |x: f64| {
        let x = if x.is_nan() { MOST } else { x.clamp(LEAST, MOST) };
        LEFT + (x.log10() - low) / (high - low).max(1.0) * (WIDTH - LEFT - RIGHT)
    };
    let bottom = TOP + ROW * rows.len() as f64;
    let height = bottom + 44.0;
    let mut svg = String::new();
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
         font-family=\"sans-serif\" font-size=\"12\" fill=\"#2b3440\">\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fbfaf8\"/>\n\
         <text x=\"16\" y=\"26\" font-size=\"17\" font-weight=\"600\">{title}</text>"
    );
    let mut x = 22.0;
    for (word, color) in legend.iter().chain(&[("bound", "")]) {
        let mark = if color.is_empty() {
            format!(r##"<path d="M{x} 41V53" stroke="#a05f34" stroke-width="2"/>"##)
        } else {
            format!(r##"<circle cx="{x}" cy="47" r="4.5" fill="{color}"/>"##)
        };
        let _ = writeln!(svg, r##"{mark}<text x="{:.0}" y="51">{word}</text>"##, x + 10.0);
        x += 34.0 + 6.6 * word.len() as f64;
    }
    for decade in low as i32..=high as i32 {
        let x = at(10_f64.powi(decade));
        let label = if decade == 0 { "1".to_owned() } else { format!("1e{decade}") };
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {:.1}V{bottom:.1}\" stroke=\"#e4e1da\"/><text x=\"{x:.1}\" \
             y=\"{:.1}\" text-anchor=\"middle\" fill=\"#6b7683\">{label}</text>",
            TOP - 6.0,
            bottom + 18.0
        );
    }
    for (index, row) in rows.iter().enumerate() {
        let y = TOP + ROW * (index as f64 + 0.5);
        if index % 2 == 1 {
            let _ = writeln!(
                svg,
                "<rect x=\"8\" y=\"{:.1}\" width=\"{:.1}\" height=\"{ROW}\" fill=\"#2b3440\" \
                 fill-opacity=\"0.035\"/>",
                y - 0.5 * ROW,
                WIDTH - 16.0
            );
        }
        let _ = writeln!(
            svg,
            r##"<text x="{:.1}" y="{:.1}" text-anchor="end">{}</text>"##,
            LEFT - 12.0,
            y + 4.0,
            row.label
        );
        for (number, color) in &row.points {
            // A ring stands for no error at all.
            let fill = if *number == 0.0 { "none" } else { color };
            let _ = writeln!(
                svg,
                r##"<circle cx="{:.1}" cy="{y:.1}" r="4" fill="{fill}" stroke="{color}"/>"##,
                at(*number)
            );
        }
        if let Some(bound) = row.bound {
            let _ = writeln!(
                svg,
                r##"<path d="M{0:.1} {1:.1}V{2:.1}" stroke="#a05f34" stroke-width="2"/>"##,
                at(bound),
                y - 6.0,
                y + 6.0
            );
        }
    }
    let middle = 0.5 * (LEFT + WIDTH - RIGHT);
    let _ = writeln!(
        svg,
        "<text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{axis}; a ring is no error at \
         all</text>",
        bottom + 36.0
    );
    svg.push_str("</svg>\n");
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_stand_where_their_decades_are() {
        let points = vec![(1e-6, "blue"), (1e-4, "red"), (0.0, "green")];
        let rows = [PlotRow { label: "a".into(), points, bound: Some(1.0) }];
        let svg = svg("Title", "axis", &rows, &[("one", "blue")]);
        let x_of = |color: &str| {
            let line = svg
                .lines()
                .find(|line| line.contains(&format!("stroke=\"{color}\"")))
                .expect("a point");
            let from = line.find("cx=\"").expect("a place") + 4;
            line[from..].split('"').next().and_then(|x| x.parse::<f64>().ok()).expect("a number")
        };
        // The axis goes from 1e-8, where the point without an error is, to 1.
        let width = WIDTH - LEFT - RIGHT;
        assert!((x_of("green") - LEFT).abs() < 0.1);
        assert!((x_of("blue") - LEFT - 0.25 * width).abs() < 0.1);
        assert!((x_of("red") - LEFT - 0.5 * width).abs() < 0.1);
    }

    #[test]
    fn an_infinite_error_is_drawn_within_the_plot() {
        let points = vec![(f64::INFINITY, "#000"), (1e-6, "#000")];
        let row = PlotRow { label: "node".to_owned(), points, bound: Some(2e-6) };
        let text = svg("Errors", "relative", &[row], &[]);
        assert!(text.len() < 10_000 && !text.contains("inf"), "{text}");
    }
}
