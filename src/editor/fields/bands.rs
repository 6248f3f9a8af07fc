//! Bands of a layer: flat colors from the light to the dark with an edge between each two, all of
//! one softness, kept as a ramp over the angle from the light.
//!
//! Hard bands are a stepped ramp with one stop for each color, whose edges the shader averages over
//! a pixel. Soft ones are a straight ramp with two stops for each edge. The document holds the ramp
//! alone; other ramps are no bands, and are edited as ramps.

use std::f64::consts::PI;

use chiaro_locale::tr;
use eframe::egui::{
    self, Button, Color32, Id, Pos2, Rect, RichText, Sense, Stroke, StrokeKind, Ui, WidgetInfo,
    pos2, vec2,
};

use crate::document::{ColorSpace, Interpolation, Ramp, RampStop, Value};
use crate::widgets::color;
use crate::widgets::handle;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::theme;

/// Name of the input that holds bands.
pub(crate) const PORT: &str = "bands";

/// Bands, from the light on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bands {
    /// Straight RGB or RGBA in the look's color space; at least one.
    pub(crate) colors: Vec<Vec<f64>>,
    /// Angles from the light in radians, in order, one less than colors.
    pub(crate) edges: Vec<f64>,
    /// Width of each edge in radians, where its neighbors leave room.
    pub(crate) softness: f64,
}

impl Bands {
    /// Largest number of colors: soft edges take two of a ramp's stops each.
    pub(crate) const MOST: usize = Ramp::MAX_STOPS / 2 + 1;
    /// Widest edge, in radians.
    const WIDEST: f64 = 0.5 * PI;

    /// Bands of a ramp; `None` for a ramp of another form.
    pub(crate) fn of(ramp: &Ramp) -> Option<Self> {
        let stops = &ramp.stops;
        let angle = |stop: &RampStop| (stop.at * PI).clamp(0.0, PI);
        let color = |stop: &RampStop| stop.color.clone();
        let is_known = stops.iter().all(|stop| stop.at.is_finite());
        let is_hard = ramp.interpolation == Interpolation::Stepped || stops.len() == 1;
        let bands = match stops.split_first() {
            Some((_, edges)) if is_hard => Self {
                colors: stops.iter().map(color).collect(),
                edges: edges.iter().map(angle).collect(),
                softness: 0.0,
            },
            Some((first, _))
                if ramp.interpolation == Interpolation::Linear && stops.len().is_multiple_of(2) =>
            {
                let pairs = || stops.chunks_exact(2);
                let joins = stops[1..].chunks_exact(2).all(|pair| pair[0].color == pair[1].color);
                if !joins {
                    return None;
                }
                let widths = pairs().map(|pair| angle(&pair[1]) - angle(&pair[0]));
                Self {
                    colors: std::iter::once(color(first))
                        .chain(pairs().map(|pair| color(&pair[1])))
                        .collect(),
                    edges: pairs().map(|pair| 0.5 * (angle(&pair[0]) + angle(&pair[1]))).collect(),
                    softness: widths.fold(0.0, f64::max).min(Self::WIDEST),
                }
            }
            _ => return None,
        };
        (is_known && bands.colors.len() <= Self::MOST).then_some(bands)
    }

    /// Bands nearest to any ramp: its colors, with edges midway between its stops.
    pub(crate) fn nearest(ramp: &Ramp) -> Self {
        let stops = &ramp.stops[..ramp.stops.len().min(Self::MOST)];
        let mut edges: Vec<f64> = stops
            .windows(2)
            .map(|pair| (0.5 * (pair[0].at + pair[1].at) * PI).clamp(0.0, PI))
            .collect();
        edges.sort_by(f64::total_cmp);
        let colors: Vec<Vec<f64>> = stops.iter().map(|stop| stop.color.clone()).collect();
        let colors = if colors.is_empty() { vec![vec![1.0; 3]] } else { colors };
        Self { colors, edges, softness: 0.0 }
    }

    /// The ramp over the angle, from 0 at the light to 1 opposite of it.
    pub(crate) fn ramp(&self) -> Ramp {
        // A millionth of half a turn is far below a pixel, and keeps files readable.
        let part = |angle: f64| (angle / PI * 1e6).round() / 1e6;
        let stop =
            |angle: f64, color: &Vec<f64>| RampStop { at: part(angle), color: color.clone() };
        if self.softness <= 0.0 || self.edges.is_empty() {
            let places = std::iter::once(0.0).chain(self.edges.iter().copied());
            let stops = places.zip(&self.colors).map(|(angle, color)| stop(angle, color));
            return Ramp { stops: stops.collect(), interpolation: Interpolation::Stepped };
        }
        let edges = self.edges.iter().enumerate().flat_map(|(index, &edge)| {
            let half = 0.5 * self.width(index);
            [stop(edge - half, &self.colors[index]), stop(edge + half, &self.colors[index + 1])]
        });
        Ramp { stops: edges.collect(), interpolation: Interpolation::Linear }
    }

    /// Width of an edge that its neighbors leave, in radians.
    fn width(&self, index: usize) -> f64 {
        let [low, high] = self.limits(index);
        let edge = self.edges[index];
        let end = |limit: f64, is_end: bool| if is_end { limit } else { 0.5 * limit };
        let before = end(edge - low, index == 0);
        let after = end(high - edge, index + 1 == self.edges.len());
        (2.0 * before.min(after)).clamp(0.0, self.softness)
    }

    /// Range of an edge, in radians: between its neighbors.
    pub(crate) fn limits(&self, index: usize) -> [f64; 2] {
        let low = index.checked_sub(1).map_or(0.0, |before| self.edges[before]);
        [low, self.edges.get(index + 1).copied().unwrap_or(PI)]
    }

    /// Moves an edge between its neighbors.
    pub(crate) fn move_edge(&mut self, index: usize, angle: f64) {
        if index < self.edges.len() && angle.is_finite() {
            let [low, high] = self.limits(index);
            self.edges[index] = angle.clamp(low, high);
        }
    }

    /// Splits a band in two of the same color, if there is room for one more.
    pub(crate) fn split(&mut self, index: usize) {
        if self.colors.len() >= Self::MOST || index >= self.colors.len() {
            return;
        }
        let low = index.checked_sub(1).map_or(0.0, |before| self.edges[before]);
        // What lies beyond a quarter turn is dark in any case: the last band is cut before that.
        let high =
            self.edges.get(index).copied().unwrap_or(if low < 0.4 * PI { 0.5 * PI } else { PI });
        self.edges.insert(index, 0.5 * (low + high));
        let color = self.colors[index].iter().enumerate();
        let darker = color.map(|(at, x)| if at < 3 { (0.8 * x * 1e4).round() / 1e4 } else { *x });
        self.colors.insert(index + 1, darker.collect());
    }

    /// Takes a band away; the one after it, or else the one before, takes its place.
    pub(crate) fn remove(&mut self, index: usize) {
        if self.colors.len() < 2 || index >= self.colors.len() {
            return;
        }
        self.colors.remove(index);
        self.edges.remove(index.saturating_sub(usize::from(index == self.edges.len())));
    }

    /// Swaps the colors of two bands; the edges stay.
    pub(crate) fn swap(&mut self, a: usize, b: usize) {
        if a.max(b) < self.colors.len() {
            self.colors.swap(a, b);
        }
    }

    /// Straight RGBA of a band.
    fn rgba(&self, index: usize) -> [f64; 4] {
        let channel =
            |at: usize, otherwise| self.colors[index].get(at).copied().unwrap_or(otherwise);
        [channel(0, 0.0), channel(1, 0.0), channel(2, 0.0), channel(3, 1.0)]
    }
}

/// Shows the bands of a layer, or a button that makes bands of another ramp. Returns the id of the
/// widget and the new value where it changed; `None` for a value that is no ramp.
pub(crate) fn show(
    ui: &mut Ui,
    label: Id,
    value: Option<&Value>,
    space: ColorSpace,
) -> Option<(Id, Value)> {
    let Some(Value::Ramp(ramp)) = value else { return None };
    let Some(mut bands) = Bands::of(ramp) else {
        let response =
            ui.button(tr!("As bands")).on_hover_text(tr!("Flat colors, one for each stop"));
        let made = Bands::nearest(ramp).ramp();
        let made = response.clicked().then_some((response.id, Value::Ramp(made)));
        return made.or_else(|| crate::widgets::ramp::show(ui, label, value));
    };
    let mut changed = None;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), BAR), Sense::hover());
    bar(ui, rect.shrink2(vec2(8.0, 0.0)), &mut bands, space, BandsOf::Layer, &mut changed);
    for index in 0..bands.colors.len() {
        ui.horizontal(|ui| band_row(ui, index, &mut bands, space, &mut changed));
    }
    ui.horizontal(|ui| {
        let help = tr!("How wide every edge is; 0 is hard");
        let label = ui.label(tr!("Softness")).on_hover_text(help).id;
        let mut degrees = bands.softness.to_degrees();
        ui.spacing_mut().slider_width = (ui.available_width() - 66.0).max(40.0);
        let slider = number_slider(ui, &mut degrees, 0.0..=Bands::WIDEST.to_degrees());
        let response = ui.add(slider.suffix("°").max_decimals(1)).labelled_by(label);
        if response.on_hover_text(help).changed() && degrees.is_finite() {
            bands.softness = degrees.to_radians();
            changed = Some(ui.scope_id().with("softness of bands"));
        }
    });
    changed.map(|id| (id, Value::Ramp(bands.ramp())))
}

/// Height of the bar of colors, in points.
const BAR: f32 = 26.0;

/// Shows one band: its color, the angle up to which it goes, and what changes the list.
fn band_row(
    ui: &mut Ui,
    index: usize,
    bands: &mut Bands,
    space: ColorSpace,
    changed: &mut Option<Id>,
) {
    let (count, number) = (bands.colors.len(), index + 1);
    let id = ui.scope_id().with(("band", index));
    let name = tr!("Color of band {number}");
    if let Some((widget, color)) = color::named_swatch(ui, &name, bands.rgba(index), space, true) {
        let is_opaque = color[3] == 1.0;
        bands.colors[index] = if is_opaque { color[..3].to_vec() } else { color.to_vec() };
        *changed = Some(widget);
    }
    match bands.edges.get(index).copied() {
        Some(edge) => {
            let label = ui.label(tr!("up to")).id;
            let mut degrees = edge.to_degrees();
            let [low, high] = bands.limits(index).map(f64::to_degrees);
            let field = number_field(ui, &mut degrees)
                .range(low..=high)
                .clamp_existing_to_range(false)
                .speed(0.5)
                .max_decimals(1)
                .suffix("°");
            let response = ui.add(field).labelled_by(label);
            let name = tr!("Edge {number}");
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
            if response.changed() && degrees.is_finite() {
                bands.move_edge(index, degrees.to_radians());
                *changed = Some(response.id);
            }
            response.on_hover_text(tr!(
                "Angle from the light; drag it on the bar or on the object too"
            ));
        }
        None => drop(ui.label(RichText::new(tr!("the rest")).color(theme::of(ui).dim))),
    }
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        let mut act = |ui: &mut Ui, text: &str, label: String, help: &str, is_on: bool| {
            let response = ui.add_enabled(is_on, Button::new(text).small());
            response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, is_on, &label));
            let is_clicked = response.on_hover_text(help).clicked();
            if is_clicked {
                *changed = Some(id.with(text));
            }
            is_clicked
        };
        let [removes, splits, moves_down, moves_up] = [
            tr!("Remove band {number}"),
            tr!("Split band {number}"),
            tr!("Move down band {number}"),
            tr!("Move up band {number}"),
        ];
        if act(ui, "×", removes, tr!("Takes this band away"), count > 1) {
            bands.remove(index);
        } else if act(ui, "+", splits, tr!("Makes two bands of this one"), count < Bands::MOST) {
            bands.split(index);
        } else if act(ui, "⏷", moves_down, tr!("Its color to the next band"), number < count) {
            bands.swap(index, index + 1);
        } else if act(ui, "⏶", moves_up, tr!("Its color to the band before"), index > 0) {
            bands.swap(index, index - 1);
        }
    });
}

/// Owner of bands that a bar shows, for the names of its edges.
#[derive(Clone, Copy, Debug, Hash)]
pub(crate) enum BandsOf<'a> {
    /// The layer that is inspected.
    Layer,
    /// The layer of the strip over the picture.
    Strip,
    /// The layer of this name.
    Named(&'a str),
}

impl BandsOf<'_> {
    fn edge(self, number: usize) -> String {
        match self {
            Self::Layer => tr!("Edge {number} of the bands of the layer"),
            Self::Strip => tr!("Edge {number} of the bands of the strip"),
            Self::Named(name) => tr!("Edge {number} of the bands of {name}"),
        }
    }
}

/// Shows the bands over the angles from 0 to half a turn, with edges that are dragged.
pub(crate) fn bar(
    ui: &Ui,
    rect: Rect,
    bands: &mut Bands,
    space: ColorSpace,
    of: BandsOf<'_>,
    changed: &mut Option<Id>,
) {
    let painter = ui.painter();
    painter.rect_filled(rect, 2.0, theme::of(ui).canvas);
    let x = |angle: f64| rect.left() + (angle / PI) as f32 * rect.width();
    let mut left = rect.left();
    for index in 0..bands.colors.len() {
        let right = bands.edges.get(index).map_or(rect.right(), |edge| x(*edge));
        let part = Rect::from_x_y_ranges(left..=right, rect.y_range());
        painter.rect_filled(part, 0.0, shown(color::encoded(bands.rgba(index), space)));
        left = right;
    }
    painter.rect_stroke(rect, 2.0, Stroke::new(1.0, theme::of(ui).swatch_edge), StrokeKind::Inside);
    let id = ui.scope_id().with(("bands", of));
    for index in 0..bands.edges.len() {
        let edge = bands.edges[index];
        let at = pos2(x(edge), rect.center().y);
        let label = of.edge(index + 1);
        let handled = handle::handle(ui, id.with(index), at, &label, edge.to_degrees(), true);
        paint_edge(ui, rect, at, handled.response.dragged() || handled.response.hovered());
        let to = match handled.to {
            Some(Pos2 { x, .. }) => f64::from((x - rect.left()) / rect.width().max(1.0)) * 180.0,
            None if handled.steps.x != 0.0 => edge.to_degrees() + f64::from(handled.steps.x),
            None => continue,
        };
        bands.move_edge(index, ((to * 2.0).round() / 2.0).to_radians());
        *changed = Some(handled.response.id);
    }
}

fn paint_edge(ui: &Ui, rect: Rect, at: Pos2, is_hot: bool) {
    let (halo, line) = if is_hot { (5.0, 2.5) } else { (3.0, 1.2) };
    let ends = [pos2(at.x, rect.top()), pos2(at.x, rect.bottom())];
    ui.painter().line_segment(ends, Stroke::new(halo, theme::HALO));
    ui.painter().line_segment(ends, Stroke::new(line, Color32::WHITE));
}

fn shown([r, g, b, a]: [f64; 4]) -> Color32 {
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    Color32::from_rgba_unmultiplied(byte(r), byte(g), byte(b), byte(a))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three(edges: [f64; 2], softness: f64) -> Bands {
        let colors = [0.9, 0.5, 0.1].map(|gray| vec![gray; 3]).to_vec();
        Bands { colors, edges: edges.to_vec(), softness }
    }

    fn is_near(a: &Bands, b: &Bands) -> bool {
        let edges = a.edges.iter().zip(&b.edges).all(|(a, b)| (a - b).abs() < 1e-5);
        a.colors == b.colors && edges && (a.softness - b.softness).abs() < 1e-5
    }

    #[test]
    fn bands_are_read_from_the_ramp_that_they_wrote() {
        for edges in [[0.8, 1.4], [0.0, PI], [1.0, 1.0], [0.2, 3.0]] {
            let hard = three(edges, 0.0);
            assert_eq!(Bands::of(&hard.ramp()).map(|read| is_near(&read, &hard)), Some(true));
        }
        for softness in [1e-3, 0.1, 0.5] {
            let soft = three([0.8, 1.4], softness);
            let ramp = soft.ramp();
            assert_eq!(ramp.stops.len(), 4);
            assert!(ramp.stops.windows(2).all(|pair| pair[0].at <= pair[1].at), "{ramp:?}");
            assert!(is_near(&Bands::of(&ramp).expect("bands"), &soft), "{softness}");
        }
    }

    #[test]
    fn soft_edges_leave_room_to_their_neighbors_and_the_ends() {
        let crowded = three([0.1, 0.2], 1.0);
        let places: Vec<f64> = crowded.ramp().stops.iter().map(|stop| stop.at * PI).collect();
        for (place, wanted) in places.iter().zip([0.05, 0.15, 0.15, 0.25]) {
            assert!((place - wanted).abs() < 1e-5, "{places:?}");
        }
        let one = Bands { colors: vec![vec![1.0; 3]], edges: Vec::new(), softness: 0.4 };
        assert_eq!(Bands::of(&one.ramp()).map(|read| read.colors.len()), Some(1));
    }

    #[test]
    fn bands_are_split_removed_and_swapped() {
        let mut bands = three([0.8, 1.4], 0.0);
        bands.split(1);
        assert_eq!((bands.colors.len(), bands.edges.clone()), (4, vec![0.8, 1.1, 1.4]));
        bands.remove(0);
        assert_eq!(bands.edges, [1.1, 1.4], "the next band begins at the light");
        bands.remove(2);
        assert_eq!(bands.edges, [1.1], "the band before goes on to the end");
        bands.swap(0, 1);
        assert_eq!(bands.colors[1], vec![0.5; 3]);
        bands.move_edge(0, -4.0);
        assert_eq!(bands.edges, [0.0]);
        bands.remove(0);
        bands.remove(0);
        assert_eq!(bands.colors.len(), 1, "one is left");
        for _ in 0..20 {
            bands.split(0);
        }
        assert_eq!(bands.colors.len(), Bands::MOST);
        bands.softness = 0.01;
        assert!(bands.ramp().stops.len() <= Ramp::MAX_STOPS);
    }

    #[test]
    fn other_ramps_are_no_bands_and_become_some() {
        let stops = |colors: &[f64]| -> Vec<RampStop> {
            let last = (colors.len() - 1).max(1) as f64;
            let each = colors.iter().enumerate();
            each.map(|(at, gray)| RampStop { at: at as f64 / last, color: vec![*gray; 3] })
                .collect()
        };
        for (colors, interpolation) in [
            (&[0.0, 0.4, 1.0][..], Interpolation::Linear),
            (&[0.0, 0.3, 0.4, 1.0], Interpolation::Linear),
            (&[0.0, 1.0], Interpolation::Smooth),
        ] {
            let ramp = Ramp { stops: stops(colors), interpolation };
            assert_eq!(Bands::of(&ramp), None, "{ramp:?}");
            let made = Bands::nearest(&ramp);
            assert_eq!((made.colors.len(), made.edges.len()), (colors.len(), colors.len() - 1));
        }
        assert_eq!(
            Bands::of(&Ramp { stops: Vec::new(), interpolation: Interpolation::Stepped }),
            None
        );
    }
}
