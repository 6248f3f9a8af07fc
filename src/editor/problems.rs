//! What is wrong, below the canvas; a click leads to the node.

use eframe::egui;
use eframe::egui::{RichText, ScrollArea, Sense, Ui};

use super::command::Command;
use super::theme;
use crate::diag::{Diagnostic, Severity};

/// As many problems are listed; mending those shows the others.
const MAX_LISTED: usize = 50;

/// A problem with what to do about it, for people.
pub(crate) fn sentence(problem: &Diagnostic) -> String {
    let mut text = problem.message.clone();
    for hint in &problem.hints {
        text += "\n";
        text += hint;
    }
    text
}

/// Lists problems, errors first.
pub(crate) fn show(ui: &mut Ui, problems: &[&Diagnostic]) -> Vec<Command> {
    let mut commands = Vec::new();
    let mut sorted: Vec<&Diagnostic> = problems.to_vec();
    sorted.sort_by_key(|problem| std::cmp::Reverse(problem.severity));
    ScrollArea::vertical().max_height(110.0).auto_shrink([false, true]).show(ui, |ui| {
        for problem in sorted.iter().take(MAX_LISTED) {
            let color = match problem.severity {
                Severity::Error => theme::of(ui).error,
                Severity::Warning => theme::of(ui).warning,
                Severity::Note => theme::of(ui).dim,
            };
            ui.horizontal_wrapped(|ui| {
                let (dot, _) = ui.allocate_exact_size(egui::vec2(8.0, 14.0), Sense::hover());
                ui.painter().circle_filled(dot.center(), 3.5, color);
                let node = problem.place.node.clone();
                if let Some(node) = node {
                    let text = problem.place.node.as_ref().map(ToString::to_string).unwrap_or_default();
                    if ui
                        .link(RichText::new(text).color(theme::of(ui).accent))
                        .on_hover_text("Shows this node")
                        .clicked()
                    {
                        commands.push(Command::Show(node));
                    }
                }
                if let Some(at) = problem.place.at {
                    ui.label(RichText::new(format!("line {}", at.line)).color(theme::of(ui).dim));
                }
                ui.label(problem.message.as_str());
                for hint in &problem.hints {
                    ui.label(RichText::new(hint).color(theme::of(ui).dim));
                }
            });
        }
        if sorted.len() > MAX_LISTED {
            ui.label(RichText::new(format!("and {} more", sorted.len() - MAX_LISTED)).color(theme::of(ui).dim));
        }
    });
    commands
}
