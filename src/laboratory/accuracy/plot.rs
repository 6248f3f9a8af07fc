//! Plot of error against time as an SVG: one point a measurement, and the Pareto front.

use std::fmt::Write as _;

use super::Measure;
use super::report::{
    BenchReport, MeasuredTier, MeasurementRow, MeasurementSubject, pareto_front_by,
};
use crate::document::Tier;
use crate::drawing::escaped;

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 560.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 64.0;
/// Smallest error that is drawn: f32 cannot tell smaller ones from none.
const LEAST_ERROR: f64 = 1e-8;

/// A logarithmic axis: powers of ten from `from` to `to`, drawn between `start` and `end`.
struct Axis {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

impl Axis {
    fn new(numbers: impl Iterator<Item = f64>, start: f64, end: f64) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for number in numbers.filter(|number| *number > 0.0) {
            low = low.min(number.log10());
            high = high.max(number.log10());
        }
        if !low.is_finite() {
            (low, high) = (-1.0, 0.0);
        }
        // The axis leaves room around the points, even if all lie on one.
        let room = 0.12 * (high - low) + 0.15;
        Self { from: low - room, to: high + room, start, end }
    }

    fn at(&self, number: f64) -> f64 {
        let share = (number.max(1e-300).log10() - self.from) / (self.to - self.from);
        self.start + share.clamp(0.0, 1.0) * (self.end - self.start)
    }

    /// Round numbers with a tick: 1, 2 and 5 of each decade on an axis of few decades, powers of
    /// ten on one of many.
    fn ticks(&self) -> Vec<f64> {
        let decades = self.from.floor() as i32..=self.to.ceil() as i32;
        let steps: &[f64] = if self.to - self.from < 3.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let every = ((self.to - self.from) / 9.0).ceil().max(1.0) as i32;
        let ticks = decades
            .filter(|decade| decade.rem_euclid(every) == 0)
            .flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
        ticks.filter(|tick| (self.from..=self.to).contains(&tick.log10())).collect()
    }
}

/// Draws those rows of the report whose subject `about` accepts, with errors by `measure`.
pub fn svg(
    report: &BenchReport,
    about: impl Fn(&MeasurementSubject) -> bool,
    title: &str,
    measure: Measure,
) -> String {
    let rows: Vec<&MeasurementRow> =
        report.rows.iter().filter(|row| about(&row.subject) && row.error.is_some()).collect();
    let error_of =
        |row: &MeasurementRow| row.error_by(measure).unwrap_or_default().max(LEAST_ERROR);
    let x = Axis::new(rows.iter().map(|row| row.time.median), LEFT, WIDTH - RIGHT);
    let errors = rows.iter().map(|row| error_of(row)).chain([1.0 / 255.0]);
    let y = Axis::new(errors, HEIGHT - BOTTOM, TOP);
    let mut svg = String::new();
    frame(&mut svg, (&x, &y), title, report, measure);
    let front = pareto_front_by(&rows, measure);
    let line: Vec<String> = front
        .iter()
        .map(|&index| {
            format!("{:.1},{:.1}", x.at(rows[index].time.median), y.at(error_of(rows[index])))
        })
        .collect();
    let _ = writeln!(
        svg,
        r##"<polyline points="{}" fill="none" stroke="#8fa3b8" stroke-width="1.5"/>"##,
        line.join(" ")
    );
    let mut labels: Vec<(f64, f64)> = Vec::new();
    for row in &rows {
        point(&mut svg, row, x.at(row.time.median), y.at(error_of(row)), (&x, &mut labels));
    }
    svg.push_str("</svg>\n");
    svg
}

fn frame(
    svg: &mut String,
    (x, y): (&Axis, &Axis),
    title: &str,
    report: &BenchReport,
    measure: Measure,
) {
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
         font-family=\"sans-serif\" font-size=\"13\" fill=\"#2b3440\">\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#fbfaf8\"/>\n\
         <text x=\"{LEFT}\" y=\"26\" font-size=\"17\" font-weight=\"600\">{}</text>\n\
         <text x=\"{LEFT}\" y=\"44\" fill=\"#6b7683\">{}x{} on {}{}</text>",
        escaped(title),
        report.size[0],
        report.size[1],
        escaped(&report.adapter),
        if report.is_software { ", in software" } else { "" },
    );
    for tick in x.ticks() {
        let at = x.at(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{at:.1} {TOP}V{:.1}\" stroke=\"#e4e1da\"/><text x=\"{at:.1}\" y=\"{:.1}\" \
             text-anchor=\"middle\">{}</text>",
            HEIGHT - BOTTOM,
            HEIGHT - BOTTOM + 20.0,
            number(tick),
        );
    }
    for tick in y.ticks() {
        let at = y.at(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{LEFT} {at:.1}H{:.1}\" stroke=\"#e4e1da\"/><text x=\"{:.1}\" y=\"{:.1}\" \
             text-anchor=\"end\">{}</text>",
            WIDTH - RIGHT,
            LEFT - 8.0,
            at + 4.5,
            number(tick),
        );
    }
    let visible = y.at(1.0 / 255.0);
    let _ = writeln!(
        svg,
        r##"<path d="M{LEFT} {visible:.1}H{:.1}" stroke="#c07a4b" stroke-dasharray="5 4"/>
         <text x="{:.1}" y="{:.1}" text-anchor="end" fill="#a05f34">1/255, what 8 bits show</text>
         <text x="{:.1}" y="{:.1}" text-anchor="middle">milliseconds</text>
         <text transform="translate(20 {:.1}) rotate(-90)" text-anchor="middle">{}</text>"##,
        WIDTH - RIGHT,
        WIDTH - RIGHT - 4.0,
        visible - 6.0,
        0.5 * (LEFT + WIDTH - RIGHT),
        HEIGHT - 18.0,
        0.5 * (TOP + HEIGHT - BOTTOM),
        measure.meaning(),
    );
}

fn point(
    svg: &mut String,
    row: &MeasurementRow,
    at_x: f64,
    at_y: f64,
    (x, labels): (&Axis, &mut Vec<(f64, f64)>),
) {
    let color = match row.tier {
        MeasuredTier::Named(Tier::Exact) => "#35618f",
        MeasuredTier::Named(Tier::Balanced) => "#4f8f5b",
        MeasuredTier::Named(Tier::Fast) => "#c0583f",
        MeasuredTier::Automatic => "#8a6d1f",
        MeasuredTier::AsSet => "#6d5a8c",
    };
    let (low, high) = (x.at(row.time.low.max(1e-6)), x.at(row.time.high.max(1e-6)));
    let _ = writeln!(
        svg,
        "<path d=\"M{low:.1} {at_y:.1}H{high:.1}\" stroke=\"{color}\" stroke-opacity=\"0.5\" \
         stroke-width=\"3\"/>\n\
         <circle cx=\"{at_x:.1}\" cy=\"{at_y:.1}\" r=\"5.5\" fill=\"{color}\"/>",
    );
    let mut label_y = at_y - 11.0;
    while labels.iter().any(|(x, y)| (x - at_x).abs() < 90.0 && (y - label_y).abs() < 14.0) {
        label_y -= 15.0;
    }
    labels.push((at_x, label_y));
    let name = match &row.subject {
        MeasurementSubject::Node { name, .. } => format!("{name}, {}", row.tier.word()),
        _ => row.tier.word().to_owned(),
    };
    let anchor = if at_x > WIDTH - 140.0 { "end" } else { "start" };
    let _ = writeln!(
        svg,
        r##"<text x="{at_x:.1}" y="{label_y:.1}" text-anchor="{anchor}" fill="{color}">{}</text>"##,
        escaped(&name)
    );
}

fn number(number: f64) -> String {
    if (0.001..10_000.0).contains(&number) {
        let text = format!("{number:.3}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    format!("{number:.0e}")
}
