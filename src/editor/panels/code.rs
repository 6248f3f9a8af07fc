//! Generated WGSL, with syntax highlighting and marks on the lines of the selected nodes; a click
//! on a line selects its node.

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use std::ops::Range;
use std::sync::Arc;

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Color32, FontId, RichText, ScrollArea, Sense, TextStyle, Ui, vec2};

use crate::commands::{Command, PanelId};
use crate::compile::CompiledShader;
use crate::ids::{NodeId, NodePath};
use crate::panels::table::{PanelContext, PanelPlace, PanelRow};
use crate::state::session::Session;
use crate::viewport::solo_bar;
use crate::widgets::theme::{self, Colors};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::CODE,
    text!("Code"),
    text!("The generated WGSL"),
    PanelPlace::BELOW_PICTURE,
    |bench, ui, PanelContext { session, .. }| {
        let is_alone = !session.view.solo.layers.is_empty();
        let bar = is_alone.then(|| solo_bar::show(ui, session)).flatten();
        bench.memory.of::<Code>().show(ui, session).into_iter().chain(bar).collect()
    },
);

/// Least width of a word beside the button, in points.
const LEAST_WORD: f32 = 44.0;

/// The panel, with the shader that it shows.
#[derive(Default)]
pub(crate) struct Code {
    shader: Option<Arc<CompiledShader>>,
    lines: Vec<Range<usize>>,
    shown_for: Vec<NodeId>,
}

impl Code {
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.sync(session.compilation().baked());
        let mut commands = Vec::new();
        let Some(shader) = self.shader.clone() else {
            ui.label(
                RichText::new(tr!("The shader appears here once the look compiles"))
                    .color(theme::of(ui).dim),
            );
            return commands;
        };
        self.head(ui, &shader, &mut commands);
        let selected: Vec<NodeId> = session.selection.nodes().cloned().collect();
        let mut marked = self.marked_lines(&shader, &selected);
        marked.sort_unstable();
        let jump = (self.shown_for != selected).then(|| marked.first().copied()).flatten();
        self.shown_for = selected;
        let row = ui.text_style_height(&TextStyle::Monospace) + 2.0;
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut area = ScrollArea::both().auto_shrink([false, false]);
        if let Some(line) = jump {
            area = area.vertical_scroll_offset((line as f32 - 3.0).max(0.0) * row);
        }
        area.show_rows(ui, row, self.lines.len(), |ui, rows| {
            for line in rows {
                if let Some(node) =
                    self.show_line(ui, &shader, line, row, marked.binary_search(&line).is_ok())
                {
                    commands.push(Command::Show(crate::ids::NodePath::root(node)));
                }
            }
        });
        commands
    }

    fn sync(&mut self, shader: Option<&Arc<CompiledShader>>) {
        let is_same = match (&self.shader, shader) {
            (Some(old), Some(new)) => Arc::ptr_eq(old, new),
            (None, None) => true,
            _ => false,
        };
        if is_same {
            return;
        }
        self.shader = shader.cloned();
        let text = shader.map_or("", |shader| shader.wgsl.as_str());
        let mut start = 0;
        self.lines = text
            .split_inclusive('\n')
            .map(|line| {
                let range = start..start + line.trim_end().len();
                start += line.len();
                range
            })
            .collect();
    }

    fn head(&self, ui: &mut Ui, shader: &CompiledShader, commands: &mut Vec<Command>) {
        let about = |ui: &mut Ui| {
            ui.style_mut().wrap_mode = Some(egui::TextWrapMode::Truncate);
            // What has no room would lie over the button.
            if ui.available_width() < LEAST_WORD {
                return;
            }
            ui.label(RichText::new("WGSL").strong());
            if ui.available_width() < LEAST_WORD {
                return;
            }
            let what = trn!(count = self.lines.len(), "{count} line", "{count} lines");
            ui.label(RichText::new(what).color(theme::of(ui).dim));
            if !shader.removed.is_empty() && ui.available_width() > LEAST_WORD {
                let removed: Vec<String> = shader
                    .removed
                    .iter()
                    .take(20)
                    .map(|r| format!("{}: {}", r.path, r.reason))
                    .collect();
                let text = tr!("{count} left out", count = shader.removed.len());
                ui.label(RichText::new(text).color(theme::of(ui).dim))
                    .on_hover_text(removed.join("\n"));
            }
        };
        ui.horizontal(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button(tr!("Copy")).on_hover_text(tr!("Copies the whole shader")).clicked() {
                    commands.push(Command::Copy(shader.wgsl.clone()));
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), about);
            });
        });
    }

    /// Lines that were generated for the selected nodes.
    fn marked_lines(&self, shader: &CompiledShader, selected: &[NodeId]) -> Vec<usize> {
        let line_of = |offset: usize| {
            self.lines.partition_point(|line| line.start <= offset).saturating_sub(1)
        };
        let mut marked = Vec::new();
        for id in selected {
            let path = NodePath::root(id.clone());
            for span in shader.spans.spans_of(&path) {
                marked.extend(line_of(span.start)..=line_of(span.end.saturating_sub(1)));
            }
        }
        marked
    }

    fn show_line(
        &self,
        ui: &mut Ui,
        shader: &CompiledShader,
        line: usize,
        height: f32,
        is_marked: bool,
    ) -> Option<NodeId> {
        let range = self.lines[line].clone();
        let galley = ui.fonts_mut(|fonts| {
            fonts.layout_job(job(line + 1, &shader.wgsl[range.clone()], theme::of(ui)))
        });
        let width = galley.size().x.max(ui.available_width());
        let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
        let node = || range.clone().find_map(|offset| shader.spans.node_at(offset));
        if is_marked {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).accent_dim.gamma_multiply(0.55));
            let bar = egui::Rect::from_min_size(rect.min, vec2(3.0, height));
            ui.painter().rect_filled(bar, 0.0, theme::of(ui).accent);
        } else if response.hovered() && node().is_some() {
            ui.painter().rect_filled(rect, 0.0, theme::of(ui).field.gamma_multiply(0.6));
        }
        ui.painter().galley(rect.min + vec2(4.0, 1.0), galley, theme::of(ui).text);
        if response.clicked() { node().and_then(|path| path.outermost().cloned()) } else { None }
    }
}

/// Syntactic kind of a word of WGSL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word {
    Keyword,
    Type,
    Number,
    Comment,
    Function,
    Attribute,
    Other,
}

const KEYWORDS: &[&str] = &[
    "fn",
    "let",
    "var",
    "const",
    "return",
    "if",
    "else",
    "for",
    "loop",
    "while",
    "break",
    "continue",
    "struct",
    "switch",
    "case",
    "default",
    "true",
    "false",
    "override",
    "alias",
    "discard",
    "enable",
    "diagnostic",
];

/// Layout of a line with its number, with syntax highlighting.
fn job(number: usize, line: &str, colors: &Colors) -> LayoutJob {
    let font = FontId::monospace(12.0);
    let mut job = LayoutJob::default();
    let mut add = |text: &str, color| {
        job.append(text, 0.0, TextFormat { font_id: font.clone(), color, ..TextFormat::default() });
    };
    add(&format!("{number:>4}  "), colors.code.comment.gamma_multiply(0.7));
    for (text, word) in pieces(line) {
        add(text, color(word, colors));
    }
    job.wrap.max_width = f32::INFINITY;
    job
}

/// Line split into pieces of one kind each.
fn pieces(line: &str) -> Vec<(&str, Word)> {
    let mut pieces = Vec::new();
    let mut rest = line;
    while let Some(first) = rest.chars().next() {
        if rest.starts_with("//") {
            pieces.push((rest, Word::Comment));
            break;
        }
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        let length = if is_word(first) || first == '@' {
            let from = first.len_utf8();
            let is_number = first.is_ascii_digit();
            let more = |c: char| is_word(c) || is_number && c == '.';
            from + rest[from..].find(|c| !more(c)).unwrap_or(rest.len() - from)
        } else {
            rest.find(|c| is_word(c) || c == '@' || c == '/')
                .filter(|&at| at > 0)
                .unwrap_or(first.len_utf8())
        };
        let (word, after) = rest.split_at(length);
        pieces.push((word, kind(word, first, after)));
        rest = after;
    }
    pieces
}

fn kind(word: &str, first: char, after: &str) -> Word {
    const TYPES: &[&str] = &[
        "f32", "i32", "u32", "bool", "vec2f", "vec3f", "vec4f", "mat3x3f", "mat4x4f", "array",
        "vec2", "vec3", "vec4",
    ];
    if first == '@' {
        Word::Attribute
    } else if first.is_ascii_digit() {
        Word::Number
    } else if KEYWORDS.contains(&word) {
        Word::Keyword
    } else if TYPES.contains(&word) || first.is_ascii_uppercase() {
        Word::Type
    } else if after.starts_with('(') {
        Word::Function
    } else {
        Word::Other
    }
}

fn color(word: Word, colors: &Colors) -> Color32 {
    let code = &colors.code;
    match word {
        Word::Keyword => code.keyword,
        Word::Type => code.ty,
        Word::Number => code.number,
        Word::Comment => code.comment,
        Word::Function => code.function,
        Word::Attribute => code.attribute,
        Word::Other => colors.text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_make_up_the_line() {
        for line in [
            "let x = vec3f(1.0, 2e-3, y_1); // done",
            "@fragment fn main() -> vec4f {",
            "a/b",
            "ä + 光",
            "/",
            "",
        ] {
            let joined: String = pieces(line).iter().map(|(text, _)| *text).collect();
            assert_eq!(joined, line);
        }
        let of = |line: &'static str, word: &str| {
            pieces(line).iter().find(|(text, _)| *text == word).unwrap().1
        };
        assert_eq!(of("let x = 1.0;", "let"), Word::Keyword);
        assert_eq!(of("let x = 1.0;", "1.0"), Word::Number);
        assert_eq!(of("profile(a)", "profile"), Word::Function);
        assert_eq!(of("x // let", "// let"), Word::Comment);
    }
}
