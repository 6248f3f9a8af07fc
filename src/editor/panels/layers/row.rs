//! Row of the stack of layers.

use chiaro_locale::{Text, text, tr, tr_in};
use eframe::egui::{
    Align, Color32, ComboBox, Id, Label, Layout, Rect, Response, RichText, Role, Sense, TextureId,
    Ui, UiBuilder, WidgetInfo, pos2, vec2,
};

use super::super::thumbs::ThumbObject;
use super::cost::LayerCost;
use super::{MODES, band_bar};
use crate::catalog::{NodeKind, Port};
use crate::commands::Command;
use crate::document::{Edit, GraphId, Node, Target, Value};
use crate::fields::shot::ChangedRow;
use crate::ids::{NodeId, NodePath, PortName};
use crate::library::Type;
use crate::state::session::Session;
use crate::state::stack::mask::{self, OPACITY};
use crate::state::stack::tree::{ISOLATED, LayerTree, TreeRow};
use crate::values;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::rows::{ICON, Icon, NameEdit, card_ground, icon, picture_frame, whole};
use crate::widgets::spots::{self, Spot};
use crate::widgets::theme;

/// Height of a row, in points.
pub(super) const ROW: f32 = 52.0;
/// Width below which a row shows no thumbnail, in points.
const NARROW: f32 = 230.0;
/// Greatest height of the list of blend modes, in points: room for all of them.
const MODE_LIST: f32 = 420.0;
/// Width of the number that is a layer's opacity, in points.
const NUMBER: f32 = 46.0;
/// Side of a thumbnail, in points.
pub(super) const PICTURE: f32 = 46.0;

/// Indent of what lies in a folder, in points.
const INDENT: f32 = 14.0;
/// Label of the mode of folders whose layers lie on what is below.
const PASS_LABEL: Text = text!("Pass through");
/// Explanation of the modes of folders.
const FOLDER_MODES: Text = text!(
    "Pass through: its layers lie on what is below as if they were not in a folder, and its \
     opacity and mask count for all of them.\nAny other: isolated. Its layers are blended among \
     themselves first, over nothing, and then laid over what is below as one layer in this mode."
);

/// Node shown as a row.
pub(super) struct Row<'a> {
    pub(super) session: &'a Session,
    pub(super) id: &'a NodeId,
    pub(super) node: &'a Node,
    pub(super) kind: &'a NodeKind,
    pub(super) tree: &'a LayerTree,
    /// Rows that are listed.
    pub(super) rows: &'a [TreeRow],
    /// Layers that what is done in the row is for.
    pub(super) acting: &'a [NodeId],
    /// Further parts of a folder's row; `None` for other layers.
    pub(super) folder: Option<FolderRow>,
    /// Cost of the layer in the picture that was just drawn.
    pub(super) cost: Option<LayerCost<'a>>,
}

/// Row of a folder.
#[derive(Clone, Copy)]
pub(super) struct FolderRow {
    /// True if its layers are not listed.
    pub(super) is_closed: bool,
}

/// Responses of a row's widgets.
pub(super) struct RowResponse {
    pub(super) whole: Response,
    pub(super) more: Response,
    /// True if the folder is to be closed or opened.
    pub(super) is_fold_toggled: bool,
}

/// Indent of a row in a list of some width, in points: less where deep folders leave no room.
pub(super) fn indent(depth: usize, width: f32) -> f32 {
    (INDENT * depth as f32).min((width - NARROW).max(width * 0.12))
}

/// Id by which a row has the focus, wherever the row lies.
pub(super) fn focus_id(id: &NodeId) -> Id {
    Id::unique("layer").with(id.as_str())
}

/// Name of a layer as it is shown.
pub(super) fn title_of(session: &Session, id: &NodeId) -> String {
    let node = session.look().graph.nodes.get(id);
    let known = node.and_then(|node| Some((node, session.project.catalog.of(node)?)));
    known.map(|(node, kind)| title(node, kind)).unwrap_or_default()
}

fn title(node: &Node, kind: &NodeKind) -> String {
    if node.name.is_empty() { tr_in("node", &kind.label).to_owned() } else { node.name.clone() }
}

impl Row<'_> {
    /// Word of the layer's blend mode.
    pub(super) fn mode(&self) -> Option<String> {
        let port = self.mode_port()?;
        match self.session.keys().value_at(&self.target(port)) {
            Some(Value::Text(word)) => Some(word),
            _ => None,
        }
    }

    pub(super) fn target(&self, port: &Port) -> Target {
        Target::Input { node: NodePath::root(self.id.clone()), port: port.name.clone() }
    }

    fn mode_port(&self) -> Option<&Port> {
        MODES.iter().find_map(|name| self.port(name)).filter(|port| port.ty == Type::Choice)
    }

    pub(super) fn port(&self, name: &str) -> Option<&Port> {
        self.kind.input(name).map(|index| &self.kind.inputs[index])
    }

    /// Values of the layer that the open shot changes.
    pub(super) fn changed_by_shot(&self) -> ChangedRow<'_> {
        ChangedRow::of_node(self.session, &NodePath::root(self.id.clone()))
    }

    pub(super) fn title(&self) -> String {
        title(self.node, self.kind)
    }

    /// Shows a layer.
    pub(super) fn show(
        &self,
        ui: &mut Ui,
        rect: Rect,
        texture: Option<TextureId>,
        is_dragged: bool,
        renaming: &mut Option<NameEdit<NodeId>>,
        out: &mut Vec<Command>,
    ) -> RowResponse {
        let title = self.title();
        let is_selected = super::is_selected(self.session, self.id);
        let whole = ui.interact(rect, focus_id(self.id), Sense::click_and_drag());
        let changed = self.changed_by_shot();
        whole.widget_info(|| {
            let name = tr!("Layer {title}") + changed.word();
            WidgetInfo::selected(Role::ListItem, true, is_selected, name)
        });
        spots::note(ui, Spot::Layer(self.id.clone()), rect);
        card_ground(ui, rect, &whole, is_selected || is_dragged);
        changed.bar(ui, rect);
        self.select(ui, &whole, out);
        // The buttons at the right end lie in the same column here as in the lists of lights and
        // objects.
        let inner = Rect::from_min_max(rect.min + vec2(4.0, 3.0), rect.max - vec2(0.0, 3.0));
        let builder = UiBuilder::new().id_salt(self.id).max_rect(inner);
        let mut child = ui.new_child(builder.layout(Layout::left_to_right(Align::Center)));
        let ui = &mut child;
        ui.spacing_mut().item_spacing.x = 4.0;
        self.eye(ui, &title, out);
        let is_faint = self.is_hidden();
        let is_fold_toggled = self.fold_button(ui, &title);
        // A narrow panel has room for the settings alone; a wide one also for the thumbnail.
        if rect.width() > NARROW {
            self.picture(ui, texture, is_faint);
        }
        let right = 2.0 * ICON + 4.0;
        let middle = Rect::from_min_max(
            ui.cursor().min,
            pos2(ui.max_rect().right(), ui.max_rect().bottom()),
        );
        let half = middle.height() / 2.0;
        let upper = Rect::from_min_size(middle.min, vec2(middle.width() - right - 4.0, half));
        let upper = band_bar::show(ui, upper, self, out);
        let upper = self.cost.map_or(upper, |cost| cost.show(ui, upper, &title));
        let lower = Rect::from_min_max(pos2(middle.left(), middle.top() + half), middle.max);
        let buttons = Rect::from_min_max(
            pos2(middle.right() - right, middle.top()),
            pos2(middle.right(), middle.top() + half),
        );
        self.name(&mut row_in(ui, upper, "name"), &title, is_faint, renaming, out);
        let mut ends = row_in(ui, buttons, "ends");
        self.solo(&mut ends, &title, out);
        let more = icon(
            &mut ends,
            Icon::More,
            true,
            &tr!("More of {title}"),
            tr!("Duplicate, move, delete"),
        );
        let mut below = row_in(ui, lower, "values");
        if self.tree.is_adjustment(self.id) {
            let text = tr!("changes all that lies below");
            let text = RichText::new(text).small().color(theme::of(&below).dim);
            below.add(Label::new(text).selectable(false).truncate());
        } else {
            self.blending(&mut below, &title, out);
            self.mask(&mut below, &title, out);
            self.opacity(&mut below, &title, out);
        }
        let mut help = changed.help();
        help += if help.is_empty() { "" } else { "\n" };
        help += tr!(
            "Click selects its node too, with Ctrl or Shift several · drag to reorder · right \
             click for more"
        );
        let whole = if whole.dragged() { whole } else { whole.on_hover_text(help) };
        RowResponse { whole, more, is_fold_toggled }
    }

    /// Shows the button that closes or opens a folder. Returns true if it was pressed.
    fn fold_button(&self, ui: &mut Ui, title: &str) -> bool {
        let Some(FolderRow { is_closed }) = self.folder else { return false };
        let (icon_of, label, help) = match is_closed {
            true => (Icon::Closed, tr!("Open {title}"), tr!("Lists its layers (Right)")),
            false => {
                (Icon::Opened, tr!("Close {title}"), tr!("Hides its layers in the list (Left)"))
            }
        };
        icon(ui, icon_of, true, &label, help).clicked()
    }

    /// Shows the ground that the lowest layer lies on.
    pub(super) fn show_ground(
        &self,
        ui: &mut Ui,
        rect: Rect,
        texture: Option<TextureId>,
        out: &mut Vec<Command>,
    ) {
        let title = self.title();
        let is_base = self.kind.id == "base";
        let is_selected = super::is_selected(self.session, self.id);
        let whole = ui.interact(rect, focus_id(self.id), Sense::click());
        let name = if is_base { tr!("Base {title}") } else { tr!("Branch {title}") };
        let changed = self.changed_by_shot();
        let name = name + changed.word();
        whole.widget_info(|| WidgetInfo::selected(Role::ListItem, true, is_selected, &name));
        spots::note(ui, Spot::Layer(self.id.clone()), rect);
        card_ground(ui, rect, &whole, is_selected);
        changed.bar(ui, rect);
        self.select(ui, &whole, out);
        let builder = UiBuilder::new().id_salt(self.id).max_rect(rect.shrink2(vec2(4.0, 3.0)));
        let mut child = ui.new_child(builder.layout(Layout::left_to_right(Align::Center)));
        child.spacing_mut().item_spacing.x = 4.0;
        child.add_space(ICON + 4.0);
        self.picture(&mut child, texture, false);
        child.vertical(|ui| {
            ui.add_space(5.0);
            ui.spacing_mut().item_spacing.y = 1.0;
            ui.add(Label::new(title).selectable(false).truncate());
            let text = if is_base {
                tr!("what is seen where no layer paints")
            } else {
                tr!("a node of the graph: layers end here")
            };
            ui.add(
                Label::new(RichText::new(text).small().color(theme::of(ui).dim))
                    .selectable(false)
                    .truncate(),
            );
        });
        let help = match is_base {
            true => tr!("What the lowest layer lies on. A click selects its node."),
            false => tr!(
                "Makes a color itself, or joins several: what feeds it is no single stack, and \
                 is edited on the canvas. A click selects the node, a double click shows it; \
                 with it selected, Add layer lays a layer over it."
            ),
        };
        if whole.double_clicked() && !is_base {
            out.push(Command::Show(NodePath::root(self.id.clone())));
        }
        whole.on_hover_text(help);
    }

    fn select(&self, ui: &Ui, whole: &Response, out: &mut Vec<Command>) {
        if !whole.clicked() {
            return;
        }
        whole.request_focus();
        let (adds, is_range) = ui.input(|input| (input.modifiers.command, input.modifiers.shift));
        if let Some(ids) = self.range().filter(|_| is_range) {
            super::select(self.session, ids, out);
            return;
        }
        let mut ids = if adds && self.session.selection.open_groups().is_empty() {
            self.session.selection.nodes().cloned().collect()
        } else {
            Vec::new()
        };
        let was_there = ids.iter().position(|id| id == self.id).map(|index| ids.remove(index));
        if was_there.is_none() || !adds {
            ids.push(self.id.clone());
        }
        super::select(self.session, ids, out);
    }

    /// Layers from the one that was selected first to this one, that one last.
    fn range(&self) -> Option<Vec<NodeId>> {
        let first = self.session.selection.nodes.last();
        let first = first.filter(|id| super::is_selected(self.session, id))?;
        let index = |id: &NodeId| self.rows.iter().position(|row| row.id == *id);
        let (from, to) = (index(first)?, index(self.id)?);
        let mut ids: Vec<NodeId> =
            self.rows[from.min(to)..=from.max(to)].iter().map(|row| row.id.clone()).collect();
        if from < to {
            ids.reverse();
        }
        Some(ids)
    }

    /// True for a layer that is not seen: it, or a folder around it, is hidden, or others are shown
    /// alone.
    fn is_hidden(&self) -> bool {
        let alone = &self.session.view.solo.layers;
        let around = self.tree.folders_around(self.id);
        let nodes = &self.session.look().graph.nodes;
        if alone.is_empty() || around.iter().any(|folder| alone.contains(folder)) {
            let is_muted = |id| nodes.get(id).is_some_and(|node| node.muted);
            return self.node.muted || around.iter().any(is_muted);
        }
        let has_alone = || alone.iter().any(|id| self.tree.folders_around(id).contains(self.id));
        !alone.contains(self.id) && !has_alone()
    }

    fn eye(&self, ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
        let help = match self.node.muted {
            false => {
                tr!("Leaves this layer out of the look: the node is muted, also in what is saved \
                     and exported")
            }
            true => tr!("Takes this layer in again"),
        };
        let response = icon(ui, Icon::Eye, !self.node.muted, &tr!("Show {title}"), help);
        if response.clicked() {
            let muted = !self.node.muted;
            let edit = |id: &NodeId| Edit::SetMuted { graph: GraphId::Look, id: id.clone(), muted };
            out.push(Command::Edit(one_step(self.acting.iter().map(edit))));
        }
    }

    fn solo(&self, ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
        let solo = &self.session.view.solo;
        let is_on = solo.layers.contains(self.id);
        let help =
            tr!("Solo: shows this layer alone over what the stack lies on; Ctrl-click adds to \
                 others.\nOnly in this window: nothing of it is saved.");
        if icon(ui, Icon::Solo, is_on, &tr!("Solo {title}"), help).clicked() {
            let adds = ui.input(|input| input.modifiers.command || input.modifiers.shift);
            out.push(Command::Solo(match self.acting.len() > 1 && !adds {
                true => solo.toggle_layers(self.acting.to_vec()),
                false => solo.toggle_layer(self.id, adds),
            }));
        }
    }

    /// Shows the layer's thumbnail, or its colors until the thumbnail is there.
    fn picture(&self, ui: &mut Ui, texture: Option<TextureId>, is_faint: bool) {
        let (rect, response) = ui.allocate_exact_size(vec2(PICTURE, PICTURE), Sense::hover());
        response.on_hover_ui(|ui| {
            let stand = ThumbObject::of(self.session).help();
            ui.label(tr!(
                "What it paints alone. What only adds a little is shown brighter than it is. \
                 {stand}"
            ));
        });
        let tint = if is_faint { Color32::WHITE.gamma_multiply(0.35) } else { Color32::WHITE };
        ui.painter().rect_filled(rect, 3.0, theme::of(ui).canvas);
        match texture {
            Some(texture) => drop(ui.painter().image(texture, rect.shrink(1.0), whole(), tint)),
            None => self.swatch(ui, rect.shrink(1.0), tint),
        }
        picture_frame(ui, rect);
    }

    fn swatch(&self, ui: &Ui, rect: Rect, tint: Color32) {
        let colors: Vec<Color32> =
            ["convex", "concave", "color"].iter().filter_map(|name| self.color(name)).collect();
        let width = rect.width() / colors.len().max(1) as f32;
        for (index, color) in colors.iter().enumerate() {
            let corner = pos2(rect.left() + index as f32 * width, rect.top());
            let color = color.gamma_multiply(f32::from(tint.a()) / 255.0);
            ui.painter().rect_filled(
                Rect::from_min_size(corner, vec2(width, rect.height())),
                2.0,
                color,
            );
        }
    }

    fn color(&self, name: &str) -> Option<Color32> {
        let port = self.port(name)?;
        if self.session.look().graph.wire_into(self.id, &port.name).is_some() {
            return None;
        }
        let value = values::current(port, self.node.values.get(&port.name))?;
        let [r, g, b, _] = value.color_in(crate::document::ColorSpace::Display)?;
        let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
        Some(Color32::from_rgb(byte(r), byte(g), byte(b)))
    }

    fn name(
        &self,
        ui: &mut Ui,
        title: &str,
        is_faint: bool,
        renaming: &mut Option<NameEdit<NodeId>>,
        out: &mut Vec<Command>,
    ) {
        if let Some(field) = renaming.as_mut().filter(|field| field.id == *self.id) {
            if let Some(name) =
                field.show(ui, tr_in("node", &self.kind.label), &tr!("New name of {title}"))
            {
                *renaming = None;
                let name = name.filter(|name| *name != self.node.name);
                let edit = |name| Edit::SetName { graph: GraphId::Look, id: self.id.clone(), name };
                out.extend(name.map(|name| Command::Edit(edit(name))));
                ui.memory_mut(|memory| memory.request_focus(focus_id(self.id)));
            }
            return;
        }
        let colors = theme::of(ui);
        let text = RichText::new(title).color(if is_faint { colors.dim } else { colors.text });
        let text = if self.node.muted { text.strikethrough() } else { text };
        let response = ui.add(Label::new(text).truncate().selectable(false).sense(Sense::click()));
        if response.double_clicked() {
            *renaming = Some(NameEdit::new(self.id.clone(), &self.node.name));
        } else if response.clicked() {
            self.select(ui, &response, out);
            ui.memory_mut(|memory| memory.request_focus(focus_id(self.id)));
        }
        response.on_hover_text(tr!("Double click to rename"));
    }

    /// Label and word of each mode that the layer can have; no word to pass through.
    fn modes(&self) -> Vec<(String, Option<String>)> {
        let of = |port: &Port| {
            let options = port.options.iter();
            options
                .map(|(word, label)| (tr_in("choice", label).to_owned(), Some(word.to_string())))
                .collect()
        };
        if self.folder.is_none() {
            return self.mode_port().map(of).unwrap_or_default();
        }
        let isolated = self.session.project.catalog.get(ISOLATED);
        let port = isolated.and_then(|kind| Some(&kind.inputs[kind.input(MODES[0])?]));
        let passes = [(PASS_LABEL.tr().to_owned(), None)];
        passes.into_iter().chain(port.map(of).unwrap_or_default()).collect()
    }

    fn blending(&self, ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
        let modes = self.modes();
        let word = self.mode();
        if modes.is_empty() || self.folder.is_none() && word.is_none() {
            return;
        }
        let known = modes.iter().find(|(_, known)| *known == word).map(|(label, _)| label.clone());
        let value = known.or(word.clone()).unwrap_or_default();
        let has_mask = mask::of(self.session.look(), self.id).is_some();
        let beside = NUMBER + if has_mask { ICON + 8.0 } else { 4.0 };
        let width = (ui.available_width() - beside).clamp(40.0, 82.0);
        let combo = ComboBox::from_id_salt("mode").width(width).height(MODE_LIST).truncate();
        let combo = combo.selected_text(&value).show_ui(ui, |ui| {
            for (label, known) in &modes {
                if ui.selectable_label(*known == word, label).clicked() && *known != word {
                    out.extend(self.set_mode(known.as_deref()).map(Command::Edit));
                }
            }
        });
        combo.response.widget_info(|| {
            let mut info = WidgetInfo::labeled(Role::ComboBox, true, tr!("Blending of {title}"));
            info.current_text_value = Some(value.clone());
            info
        });
        let help = match (self.folder.is_some(), self.mode_port()) {
            (true, _) => FOLDER_MODES.tr(),
            (false, Some(port)) => tr_in("node", &port.help),
            (false, None) => "",
        };
        combo.response.on_hover_text(help);
    }

    /// The edit that gives the acting layers a mode; without one, folders pass through.
    fn set_mode(&self, word: Option<&str>) -> Option<Edit> {
        let (look, catalog) = (self.session.look(), &self.session.project.catalog);
        let is_isolated =
            |id: &NodeId| look.graph.nodes.get(id).is_some_and(|node| node.kind == *ISOLATED);
        let is_changed =
            |id: &&NodeId| self.tree.is_folder(id) && (word.is_none() || !is_isolated(id));
        let (folders, others): (Vec<&NodeId>, Vec<&NodeId>) =
            self.acting.iter().partition(is_changed);
        let mut edits = LayerTree::set_modes(look, catalog, &folders, word);
        let value = |id: &&NodeId| {
            let node = NodePath::root((*id).clone());
            let target = Target::Input { node, port: self.mode_port_of(id)? };
            Some((target, Value::Text(word?.to_owned())))
        };
        let values: Vec<(Target, Value)> = others.iter().filter_map(value).collect();
        if !values.is_empty() {
            edits.push(self.session.keys().set_all_at(values));
        }
        (!edits.is_empty()).then(|| one_step(edits))
    }

    /// The input of a layer that holds its blend mode.
    fn mode_port_of(&self, id: &NodeId) -> Option<PortName> {
        let kind = self.session.project.catalog.of(self.session.look().graph.nodes.get(id)?)?;
        let ports = MODES.iter().filter_map(|name| Some(&kind.inputs[kind.input(name)?]));
        ports.filter(|port| port.ty == Type::Choice).map(|port| port.name.clone()).next()
    }

    /// Shows that the layer has a mask; a click selects it.
    fn mask(&self, ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
        let Some((id, _)) = mask::of(self.session.look(), self.id) else { return };
        let (look, catalog) = (self.session.look(), &self.session.project.catalog);
        // Found where somebody asks: what a layer is clipped to is read from the whole graph.
        let is_asked = ui.rect_contains_pointer(ui.max_rect());
        let clip = is_asked.then(|| self.tree.clip_of(look, catalog, self.id)).flatten();
        let help = match clip {
            Some(clip) => tr!(
                "Clipped: shown only where {name} is. A click selects the mask; the layer's menu \
                 frees it (Ctrl+Alt+G).",
                name = title_of(self.session, &clip.base)
            ),
            None => tr!(
                "Has a mask: white shows the layer, black hides it. A click selects the mask, to \
                 set it in the inspector; the layer's menu inverts it and takes it away."
            )
            .to_owned(),
        };
        if icon(ui, Icon::Mask, true, &tr!("Mask of {title}"), &help).clicked() {
            super::select(self.session, vec![id.clone()], out);
        }
    }

    /// The input that holds a layer's opacity: its own, or that of its mask.
    fn opacity_input<'l>(&'l self, layer: &'l NodeId) -> Option<(&'l NodeId, &'l Port)> {
        let look = self.session.look();
        let own = || look.graph.nodes.get_key_value(layer);
        let (id, node) = mask::of(look, layer).or_else(own)?;
        let kind = self.session.project.catalog.of(node)?;
        Some((id, &kind.inputs[kind.input(OPACITY)?]))
    }

    /// The opacities of the acting layers that no wire decides.
    fn opacities(&self) -> Vec<Target> {
        let target = |id: &NodeId| {
            let (holder, port) = self.opacity_input(id)?;
            let is_wired = self.session.look().graph.wire_into(holder, &port.name).is_some();
            let node = NodePath::root(holder.clone());
            (!is_wired).then(|| Target::Input { node, port: port.name.clone() })
        };
        self.acting.iter().filter_map(target).collect()
    }

    fn opacity(&self, ui: &mut Ui, title: &str, out: &mut Vec<Command>) {
        let Some((holder, port)) = self.opacity_input(self.id) else { return };
        if self.session.look().graph.wire_into(holder, &port.name).is_some() {
            let text = RichText::new(tr!("opacity by wire")).small().color(theme::of(ui).dim);
            ui.add(Label::new(text).truncate()).on_hover_text(tr!("A wire decides the opacity"));
            return;
        }
        // A keyed value is shown, and set, at the current direction key or at the playhead.
        let target =
            Target::Input { node: NodePath::root(holder.clone()), port: port.name.clone() };
        let mut percent = values::number(self.session.keys().value_at(&target).as_ref()) * 100.0;
        ui.spacing_mut().slider_width = (ui.available_width() - NUMBER - 6.0).max(20.0);
        let has_slider = ui.available_width() > NUMBER + 36.0;
        let slider = number_slider(ui, &mut percent, 0.0..=100.0).show_value(false);
        let name = tr!("Opacity of {title}");
        let on_slider = has_slider
            .then(|| ui.add(slider.trailing_fill(true)).on_hover_text(tr_in("node", &port.help)));
        let drag = number_field(ui, &mut percent).range(0.0..=100.0).clamp_existing_to_range(false);
        let drag = drag.max_decimals(0).suffix("%").speed(0.5);
        let on_number =
            ui.add_sized(vec2(NUMBER, 20.0), drag).on_hover_text(tr_in("node", &port.help));
        let slider = on_slider.iter().map(|response| (response, Role::Slider));
        for (response, role) in slider.chain([(&on_number, Role::SpinButton)]) {
            response.widget_info(|| {
                let mut info = WidgetInfo::labeled(role, true, &name);
                info.value = Some(percent);
                info
            });
            if response.changed() && percent.is_finite() {
                // Values are whole percents: nobody sees smaller steps, and files stay readable.
                let value = Value::Number(percent.round() / 100.0);
                let all = self.opacities().into_iter().map(|target| (target, value.clone()));
                out.push(Command::EditHeld(response.id, self.session.keys().set_all_at(all)));
            }
        }
    }
}

/// Several edits as one step.
fn one_step(edits: impl IntoIterator<Item = Edit>) -> Edit {
    let mut edits: Vec<Edit> = edits.into_iter().collect();
    if edits.len() == 1 { edits.remove(0) } else { Edit::Group { edits } }
}

/// Child of `ui` that lays out a row of widgets in `rect`.
fn row_in(ui: &mut Ui, rect: Rect, salt: &str) -> Ui {
    ui.new_child(
        UiBuilder::new().id_salt(salt).max_rect(rect).layout(Layout::left_to_right(Align::Center)),
    )
}
