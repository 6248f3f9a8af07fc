//! Plot of error against time, both logarithmic: points by tier, the line of 1/255, and the front
//! of the tiers that no other beats in both.

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::{Align2, FontId, Pos2, Rect, Sense, Shape, Stroke, Ui, pos2, vec2};

use super::panel::{tier_name, told};
use crate::accuracy::MeasurementRow;
use crate::accuracy::report::pareto_front;
use crate::widgets::theme;

/// Range of the plot's height, in points; it leaves room for the table.
const HEIGHT: std::ops::RangeInclusive<f32> = 110.0..=260.0;
/// Least error of the plot: smaller ones, which f32 cannot tell from 0, are drawn there.
const LEAST_ERROR: f64 = 1e-8;
const LEAST_TIME: f64 = 1e-3;
const VISIBLE: f64 = 1.0 / 255.0;

/// Logarithmic axis.
struct Axis {
    low: f64,
    high: f64,
    from: f32,
    to: f32,
}

impl Axis {
    fn new(numbers: impl Iterator<Item = f64> + Clone, from: f32, to: f32) -> Self {
        let low = numbers.clone().fold(f64::INFINITY, f64::min).log10();
        let high = numbers.fold(f64::NEG_INFINITY, f64::max).log10();
        let (low, high) =
            if low.is_finite() && high.is_finite() { (low, high) } else { (-1.0, 1.0) };
        // The range has a margin, and is never so narrow that noise fills the plot.
        let spare = (0.15 * (high - low)).max(0.15);
        Self { low: low - spare, high: high + spare, from, to }
    }

    fn at(&self, number: f64) -> f32 {
        let share = (number.log10() - self.low) / (self.high - self.low);
        self.from + share as f32 * (self.to - self.from)
    }

    /// Positions of grid lines: powers of ten, and 2 and 5 times those where there is room.
    fn ticks(&self) -> Vec<f64> {
        let decades = self.high - self.low;
        let steps: &[f64] = if decades < 1.5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let stride = ((decades / 6.0).ceil() as i32).max(1);
        let powers =
            (self.low.floor() as i32..=self.high.ceil() as i32).filter(|power| power % stride == 0);
        let all = powers.flat_map(|power| steps.iter().map(move |step| step * 10f64.powi(power)));
        all.filter(|number| (self.low..=self.high).contains(&number.log10())).collect()
    }
}

/// Plots the rows of one subject, and returns the row that was clicked.
pub(super) fn show(
    ui: &mut Ui,
    rows: &[&MeasurementRow],
    title: String,
    in_use: impl Fn(&MeasurementRow) -> bool,
) -> Option<MeasurementRow> {
    let height = (ui.clip_rect().height() * 0.62).clamp(*HEIGHT.start(), *HEIGHT.end());
    let (rect, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Canvas, true, tr!("Error against time"))
    });
    let inner = Rect::from_min_max(rect.min + vec2(46.0, 20.0), rect.max - vec2(10.0, 20.0));
    let time = |row: &MeasurementRow| row.time.median.max(LEAST_TIME);
    let error = |row: &MeasurementRow| row.max_error().unwrap_or(0.0).max(LEAST_ERROR);
    let x = Axis::new(rows.iter().map(|row| time(row)), inner.left(), inner.right());
    let y =
        Axis::new(rows.iter().map(|row| error(row)).chain([VISIBLE]), inner.bottom(), inner.top());
    grid(ui, rect, inner, &x, &y);
    ui.painter().text(
        rect.left_top(),
        Align2::LEFT_TOP,
        title,
        FontId::proportional(theme::SMALL_TEXT),
        theme::of(ui).text,
    );
    let place = |row: &MeasurementRow| pos2(x.at(time(row)), y.at(error(row)));
    let front: Vec<Pos2> = pareto_front(rows).into_iter().map(|index| place(rows[index])).collect();
    ui.painter().add(Shape::line(front, Stroke::new(1.0, theme::of(ui).dim)));
    // Points are widgets of their own, so that the keyboard and screen readers reach them; where
    // points overlap, the nearest to the pointer counts.
    let points: Vec<(Pos2, &MeasurementRow)> = rows.iter().map(|row| (place(row), *row)).collect();
    let touch = |(index, (at, row)): (usize, &(Pos2, &MeasurementRow))| {
        let reach = Rect::from_center_size(*at, vec2(20.0, 20.0));
        let point = ui.interact(reach, response.id.with(index), Sense::click());
        let label = tr!("Point {tier}", tier = tier_name(row.tier));
        point.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::Button, row.tier.is_choice(), label.clone())
        });
        point
    };
    let touched: Vec<egui::Response> = points.iter().enumerate().map(touch).collect();
    for ((at, row), point) in points.iter().zip(&touched) {
        let at = *at;
        let span = [row.time.low, row.time.high]
            .map(|time| x.at(time.max(LEAST_TIME)).clamp(x.from, x.to));
        let ink = theme::of(ui).of_tier(row.tier);
        ui.painter().hline(span[0]..=span[1], at.y, Stroke::new(1.0, ink.gamma_multiply(0.6)));
        let is_near = point.hovered() || point.has_focus();
        ui.painter().circle_filled(at, if is_near { 6.5 } else { 5.0 }, ink);
        if in_use(row) {
            ui.painter().circle_stroke(at, 8.5, Stroke::new(1.5, theme::of(ui).text));
        }
    }
    name_points(ui, inner, &points);
    let mut clicked = None;
    for ((_, row), point) in points.iter().zip(touched) {
        if point.clicked() && row.tier.is_choice() {
            clicked = Some((*row).clone());
        }
        let point = point.on_hover_text(told(row, in_use(row)));
        if row.tier.is_choice() {
            point.on_hover_cursor(egui::CursorIcon::PointingHand);
        }
    }
    clicked
}

/// Draws the tiers' names beside their points, each where it covers neither a point nor another
/// name.
fn name_points(ui: &Ui, inner: Rect, points: &[(Pos2, &MeasurementRow)]) {
    let mut taken: Vec<Rect> =
        points.iter().map(|(at, _)| Rect::from_center_size(*at, vec2(14.0, 14.0))).collect();
    for (at, row) in points {
        let ink = theme::of(ui).of_tier(row.tier);
        let font = FontId::proportional(theme::SMALL_TEXT);
        let galley = ui.painter().layout_no_wrap(tier_name(row.tier).to_owned(), font, ink);
        let (right, above) = (9.0 + galley.size().x / 2.0, 9.0 + galley.size().y / 2.0);
        let sides = [vec2(right, 0.0), vec2(-right, 0.0), vec2(0.0, -above), vec2(0.0, above)];
        let corners =
            [vec2(right, -above), vec2(-right, -above), vec2(right, above), vec2(-right, above)];
        let places = sides
            .into_iter()
            .chain(corners)
            .map(|offset| Rect::from_center_size(*at + offset, galley.size()));
        let is_free = |place: &Rect| {
            inner.contains_rect(*place) && !taken.iter().any(|other| other.intersects(*place))
        };
        let place = places
            .clone()
            .find(is_free)
            .or_else(|| places.clone().find(|place| inner.contains_rect(*place)));
        if let Some(place) = place {
            ui.painter().galley(place.min, galley, ink);
            taken.push(place);
        }
    }
}

fn grid(ui: &Ui, rect: Rect, inner: Rect, x: &Axis, y: &Axis) {
    let painter = ui.painter();
    let font = FontId::proportional(10.0);
    painter.rect_filled(inner, 2.0, theme::of(ui).canvas);
    for time in x.ticks() {
        painter.vline(x.at(time), inner.y_range(), Stroke::new(1.0, theme::of(ui).grid));
        let text = crate::values::number_text(time, 4);
        painter.text(
            pos2(x.at(time), inner.bottom() + 3.0),
            Align2::CENTER_TOP,
            text,
            font.clone(),
            theme::of(ui).dim,
        );
    }
    for error in y.ticks() {
        painter.hline(inner.x_range(), y.at(error), Stroke::new(1.0, theme::of(ui).grid));
        let text = format!("{error:.0e}");
        painter.text(
            pos2(inner.left() - 5.0, y.at(error)),
            Align2::RIGHT_CENTER,
            text,
            font.clone(),
            theme::of(ui).dim,
        );
    }
    let visible = y.at(VISIBLE);
    painter.extend(Shape::dashed_line(
        &[pos2(inner.left(), visible), pos2(inner.right(), visible)],
        Stroke::new(1.0, theme::of(ui).warning.gamma_multiply(0.7)),
        4.0,
        4.0,
    ));
    let at = pos2(inner.left() + 3.0, visible - 1.0);
    painter.text(at, Align2::LEFT_BOTTOM, "1/255", font.clone(), theme::of(ui).warning);
    painter.text(
        rect.right_top(),
        Align2::RIGHT_TOP,
        tr!("max error over milliseconds"),
        font,
        theme::of(ui).dim,
    );
}
