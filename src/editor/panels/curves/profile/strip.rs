//! Colors of a profile over the angle from left to right, from convex above to concave below:
//! computed by the functions of the library's own nodes, over the look's base.

use std::f64::consts::PI;
use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui;
use eframe::egui::ecolor::gamma_from_linear;
use eframe::egui::epaint::{Mesh, PathShape, Vertex};
use eframe::egui::{
    Color32, Pos2, Rect, Role, Sense, Shape as Drawn, Stroke, Ui, WidgetInfo, pos2, vec2,
};

use super::{Curve, ProfileNode};
use crate::document::{ColorSpace, Light, Target, Value};
use crate::interp::{Precision, Program, Value as Number};
use crate::library::NodeDef;
use crate::widgets::theme;

/// Height of the strip, in points.
pub(super) const HEIGHT: f32 = 34.0;

/// Convexities of the rows, from the top.
pub(super) const ROWS: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.0];

/// Number of colors over the angle.
const COLUMNS: usize = 90;

/// Profile at each of the convexities.
pub(super) type Rows = [Arc<Curve>; ROWS.len()];

/// The strip, with the inputs that it was computed from.
#[derive(Default)]
pub(super) struct Strip {
    known: Option<(Inputs, Rows, Vec<[f64; 4]>)>,
}

/// All inputs of the colors but the curves.
#[derive(Clone, Debug, PartialEq)]
struct Inputs {
    convex: [f64; 4],
    concave: [f64; 4],
    light: [f64; 4],
    below: [f64; 4],
    mode: String,
    opacity: f64,
    clamped: bool,
    space: ColorSpace,
}

impl Strip {
    /// Shows the strip under the part of the plot that has angles.
    pub(super) fn show(&mut self, ui: &mut Ui, layer: &ProfileNode<'_>, area: Rect, rows: &Rows) {
        let (rect, response) =
            ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
        response.widget_info(|| {
            WidgetInfo::labeled(Role::Image, true, tr!("Colors from convex to concave"))
        });
        let inputs = inputs(layer);
        let is_same = |own: &Rows| own.iter().zip(rows).all(|(a, b)| Arc::ptr_eq(a, b));
        if !self.known.as_ref().is_some_and(|(known, own, _)| *known == inputs && is_same(own)) {
            let colors = colors(layer, &inputs, rows).unwrap_or_default();
            self.known = Some((inputs.clone(), rows.clone(), colors));
        }
        let bar = Rect::from_x_y_ranges(area.x_range(), rect.y_range());
        let Some((_, _, colors)) = &self.known else { return };
        paint(ui, bar, colors, inputs.space);
        bow(ui, pos2(rect.left() + 12.0, rect.top() + 10.0), 1.0);
        bow(ui, pos2(rect.left() + 12.0, rect.bottom() - 10.0), -1.0);
        response.on_hover_text(tr!(
            "What the layer makes of the look's base color at each angle: above where the surface \
             bulges (convex), below where it is hollow (concave), with the warp that curvature \
             gives."
        ));
    }
}

/// Draws a bump, or a hollow where `way` is -1.
fn bow(ui: &Ui, at: Pos2, way: f32) {
    let points = (0..=8).map(|i| {
        let x = i as f32 / 4.0 - 1.0;
        at + vec2(7.0 * x, way * (5.0 * x * x - 2.5))
    });
    ui.painter().add(PathShape::line(points.collect(), Stroke::new(1.5, theme::of(ui).dim)));
}

fn inputs(layer: &ProfileNode<'_>) -> Inputs {
    let session = layer.session;
    let space = session.look().color_space;
    let color = |port: &str| {
        layer.kind.input(port)?;
        session.keys().value_now(&layer.target(port))?.color_in(space)
    };
    let word = |port: &str| match layer
        .kind
        .input(port)
        .and_then(|_| session.keys().value_now(&layer.target(port)))
    {
        Some(Value::Text(word)) => word,
        _ => String::new(),
    };
    let convex = color("convex").unwrap_or([1.0; 4]);
    let name = word("light");
    let lights = &session.keys().values().lights;
    let light = lights.get(name.as_str()).or_else(|| session.look().lights.get(name.as_str()));
    let light = light.cloned().unwrap_or_else(|| Light { intensity: 1.0, ..Light::default() });
    let [r, g, b] = light.color;
    let base = session.look().graph.nodes.iter().find(|(_, node)| node.kind == "base").and_then(
        |(id, _)| {
            let target = Target::Input {
                node: crate::ids::NodePath::root(id.clone()),
                port: "color".into(),
            };
            session.keys().value_now(&target)?.color_in(space)
        },
    );
    let is_layer = layer.kind.input("convex").is_some();
    let clamped = layer
        .kind
        .input("clamped")
        .and_then(|_| session.keys().value_now(&layer.target("clamped")));
    Inputs {
        convex,
        concave: color("concave").unwrap_or(convex),
        light: [r, g, b, light.intensity],
        below: base.filter(|_| is_layer).unwrap_or([0.0, 0.0, 0.0, 1.0]),
        mode: word("blend"),
        opacity: layer.number("opacity").unwrap_or(1.0),
        clamped: !matches!(clamped, Some(Value::Bool(false))),
        space,
    }
}

/// Functions of the library that turn a tone into a layer's color.
struct Functions {
    mix: Arc<Program>,
    lit: Arc<Program>,
    blend: Arc<Program>,
}

fn functions(layer: &ProfileNode<'_>, mode: &str) -> Option<Functions> {
    let node = |kind: &str| layer.session.project.library.nodes.get(kind);
    let program = |def: &NodeDef, function: &str| def.module.program(function).ok();
    let first = |kind: &str| {
        let def = node(kind)?;
        program(def, &def.variants.first()?.function)
    };
    let blend = node("blend")?;
    let is_it = |word: &str| {
        blend.variants.iter().find(|v| v.choice.as_ref().is_some_and(|(_, own)| own == word))
    };
    let variant = is_it(mode).or_else(|| is_it("add"))?;
    Some(Functions {
        mix: first("curvature_color")?,
        lit: first("light_apply")?,
        blend: program(blend, &variant.function)?,
    })
}

/// Colors row by row; premultiplied.
fn colors(layer: &ProfileNode<'_>, inputs: &Inputs, rows: &Rows) -> Option<Vec<[f64; 4]>> {
    let functions = functions(layer, &inputs.mode)?;
    let vec = |x: &[f64]| Number::vec(x);
    let [r, g, b, intensity] = inputs.light;
    let toward = vec(&[0.0, 0.0, 1.0]);
    let light =
        Number::Struct(vec![toward.clone(), toward, vec(&[r, g, b]), Number::Float(intensity)]);
    let [br, bg, bb, ba] = inputs.below;
    let below = vec(&[br * ba, bg * ba, bb * ba, ba]);
    let (mut lit, mut blend) =
        (functions.lit.machine(Precision::F64), functions.blend.machine(Precision::F64));
    let mut found = Vec::with_capacity(ROWS.len() * (COLUMNS + 1));
    for (convexity, curve) in ROWS.iter().zip(rows) {
        let arguments = [Number::Float(*convexity), vec(&inputs.convex), vec(&inputs.concave)];
        let color = functions.mix.call(&arguments, Precision::F64).ok()?;
        for column in 0..=COLUMNS {
            let u = column as f64 / COLUMNS as f64 * PI;
            let index = curve
                .angles
                .partition_point(|&known| known < u)
                .min(curve.angles.len().checked_sub(1)?);
            let tone = Number::Float(*curve.tones.get(index)?);
            let layer = lit.call(&[light.clone(), color.clone(), tone]).ok()?;
            let [color, tone] = <[Number; 2]>::try_from(layer.parts()?.to_vec()).ok()?;
            let arguments = [
                below.clone(),
                color,
                tone,
                Number::Float(inputs.opacity),
                Number::Bool(inputs.clamped),
            ];
            found.push(blend.call(&arguments).ok()?.as_vec::<4>()?);
        }
    }
    Some(found)
}

fn paint(ui: &Ui, bar: Rect, colors: &[[f64; 4]], space: ColorSpace) {
    let painter = ui.painter();
    painter.rect_filled(bar, 2.0, theme::of(ui).canvas);
    let mut mesh = Mesh::default();
    for (index, color) in colors.iter().enumerate() {
        let (row, column) = (index / (COLUMNS + 1), index % (COLUMNS + 1));
        let x = bar.left() + column as f32 / COLUMNS as f32 * bar.width();
        let y = bar.top() + row as f32 / (ROWS.len() - 1) as f32 * bar.height();
        mesh.vertices.push(Vertex::untextured(pos2(x, y), shown(*color, space)));
        if row > 0 && column > 0 {
            let (here, above) = (index as u32, (index - COLUMNS - 1) as u32);
            mesh.indices.extend_from_slice(&[above - 1, above, here - 1, here - 1, above, here]);
        }
    }
    painter.add(Drawn::mesh(mesh));
    painter.rect_stroke(
        bar,
        2.0,
        Stroke::new(1.0, theme::of(ui).swatch_edge),
        egui::StrokeKind::Inside,
    );
}

/// Converts a premultiplied color of the look's space to one of the screen.
fn shown([r, g, b, a]: [f64; 4], space: ColorSpace) -> Color32 {
    let straight = |x: f64| if a > 1e-6 { (x / a).clamp(0.0, 1.0) } else { 0.0 };
    let encoded = |x: f64| match space {
        ColorSpace::Display => straight(x),
        ColorSpace::Linear => f64::from(gamma_from_linear(straight(x) as f32)),
    };
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    Color32::from_rgba_unmultiplied(byte(encoded(r)), byte(encoded(g)), byte(encoded(b)), byte(a))
}
