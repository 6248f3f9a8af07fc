//! Text of nodes: laid out for nodes in view, and kept while nothing changes.

use std::sync::Arc;

use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{Color32, FontId, Galley, Painter, Vec2, vec2};

use super::table::NodeRow;
use crate::catalog::values::{self, InputDisplay};
use crate::document::{Look, Node};
use crate::drawing::row_center;
use crate::drawing::{NODE_WIDTH, TITLE_HEIGHT};
use crate::state::revision::LookRevision;
use crate::widgets::theme::{self, Colors};

/// Text of a node, and all else that depends on the font size.
#[derive(Default)]
pub(crate) struct NodeText {
    /// State that the text was laid out for: the size in half points, the revision, true if rows
    /// are shown, the tag, and the value.
    key: Option<(i32, LookRevision, bool, &'static str, Option<String>)>,
    /// Lines of text, the title first: the offset from the node's corner in points of the graph,
    /// and the galley.
    pub(crate) lines: Vec<(Vec2, Arc<Galley>)>,
    /// Tag beside the title, such as the reason why the node adds nothing.
    pub(crate) tag: Option<(Vec2, Arc<Galley>)>,
    /// Names of outputs as passes, on grounds of their own: the left end of each, in its middle.
    pub(crate) passes: Vec<(Vec2, Arc<Galley>)>,
    /// Colors shown in rows: the center of each, and straight RGBA.
    pub(crate) swatches: Vec<(Vec2, [f64; 4])>,
}

/// Smallest font size of a title: below it titles no longer shrink with the view.
const LEAST_TITLE: f32 = 10.0;

/// Lays a node's text out anew where the size or the document changed.
pub(crate) fn lay_out(
    row: &mut NodeRow,
    (painter, colors): (&Painter, &Colors),
    (zoom, has_rows): (f32, bool),
    revision: LookRevision,
    look: &Look,
    node: &Node,
    (tag, value): (&'static str, Option<&str>),
) {
    // Sizes are rounded to half points: zooming would otherwise fill the font image.
    let half_points = (theme::TEXT_SIZE * zoom * 2.0).round() as i32;
    let has_rows = has_rows && !row.is_collapsed;
    let key = Some((half_points, revision, has_rows, tag, value.map(str::to_owned)));
    if row.text.key == key {
        return;
    }
    let size = half_points as f32 / 2.0;
    let mut text = NodeText { key, ..NodeText::default() };
    let line = |text: &str, width: f32, color| one_line(painter, text, size, width * zoom, color);
    let centered = |galley: &Galley, y: f32| y - galley.size().y / zoom / 2.0;

    let mut room = (NODE_WIDTH - 18.0) * zoom;
    if !tag.is_empty() {
        let tag =
            one_line(painter, tag, (size * 0.85).max(LEAST_TITLE - 1.0), room * 0.6, colors.dim);
        let width = tag.size().x;
        room -= width + 6.0 * zoom;
        text.tag =
            Some((vec2(NODE_WIDTH - 10.0 - width / zoom, centered(&tag, TITLE_HEIGHT / 2.0)), tag));
    }
    let title = one_line(painter, &row.title, size.max(LEAST_TITLE), room, colors.text);
    text.lines.push((vec2(10.0, centered(&title, TITLE_HEIGHT / 2.0)), title));
    if !has_rows {
        row.text = text;
        return;
    }
    for (index, port) in row.kind.outputs.iter().enumerate() {
        let label = line(row.shown(&port.label), NODE_WIDTH - 24.0, colors.text);
        let mut x = NODE_WIDTH - 12.0 - label.size().x / zoom;
        let label_x = x;
        if let Some((_, name)) = row.named.iter().find(|(named, _)| *named == index) {
            let room = ((x - 26.0) * zoom).max(1.0);
            let tag = one_line(painter, name.as_str(), size * 0.85, room, colors.panel);
            x -= tag.size().x / zoom + 13.0;
            text.passes.push((vec2(x, row_center(index)), tag));
        }
        if let Some(value) = value.filter(|_| index == 0 && x > 40.0) {
            let value = line(value, (x - 20.0).max(1.0), colors.second);
            text.lines.push((vec2(12.0, centered(&value, row_center(index))), value));
        }
        text.lines.push((vec2(label_x, centered(&label, row_center(index))), label));
    }
    for (index, port) in row.kind.inputs.iter().enumerate() {
        let y = row_center(row.kind.outputs.len() + index);
        let is_wired = row.is_wired[index];
        let shown = if is_wired { InputDisplay::Nothing } else { values::shown(port, node, look) };
        let mut room = NODE_WIDTH - 24.0;
        let color = if matches!(shown, InputDisplay::Source(_)) {
            colors.dim.gamma_multiply(0.7)
        } else {
            colors.text
        };
        match shown {
            InputDisplay::Nothing => {}
            InputDisplay::Color(color) => {
                text.swatches.push((vec2(NODE_WIDTH - 26.0, y), color));
                room -= 34.0;
            }
            InputDisplay::Source(value) | InputDisplay::Text(value) => {
                let value = line(&value, NODE_WIDTH * 0.5, color);
                let width = value.size().x / zoom;
                text.lines.push((vec2(NODE_WIDTH - 12.0 - width, centered(&value, y)), value));
                room -= width + 8.0;
            }
        }
        let color = if is_wired { colors.text } else { colors.dim };
        let label = line(row.shown(&port.label), room, color);
        text.lines.push((vec2(12.0, centered(&label, y)), label));
    }
    row.text = text;
}

/// Lays out one line, cut off with an ellipsis where the text is longer than `width`.
pub(super) fn one_line(
    painter: &Painter,
    text: &str,
    size: f32,
    width: f32,
    color: Color32,
) -> Arc<Galley> {
    let format = TextFormat { font_id: FontId::proportional(size), color, ..TextFormat::default() };
    let mut job = LayoutJob::single_section(text.replace(['\n', '\r'], " "), format);
    job.wrap = TextWrapping::truncate_at_width(width.max(1.0));
    painter.layout_job(job)
}
