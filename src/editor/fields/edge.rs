//! Profile of a layer as one edge: where the tone falls, and how softly, in place of three angles
//! that hold one another.
//!
//! A profile is an edge where its fall-off is midway between offset and cut-off and these are at
//! most a quarter turn apart: a cartoon layer, hard or soft. Others, as Lambert's, have three
//! angles of their own. Both numbers are read from the three and written to them, so that the
//! document has one form.

use std::f64::consts::{FRAC_PI_2, PI};

use chiaro_locale::tr;
use eframe::egui::{self, Button, RichText, Ui, WidgetInfo};

use super::layer::SelectedLayer;
use super::shot::{self, ChangedValue};
use super::{mark, row};
use crate::catalog::NodeKind;
use crate::commands::{Command, PanelId, SceneCommand, ShotCommand};
use crate::document::{KeyDirection, ShotEdit, Target, Value};
use crate::fields::lighting::Owner;
use crate::ids::{NodeId, NodePath};
use crate::placing::terminator_angle;
use crate::state::keying::{KeyPlace, KeyedBy};
use crate::state::session::Session;
use crate::state::shot::ShotAddress;
use crate::values;
use crate::widgets::menu::scrolling;
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::theme;

/// Inputs that make up a profile, in order.
pub(crate) const PROFILE: [&str; 3] = ["offset", "falloff", "cutoff"];

/// True for a node with a profile.
pub(crate) fn has_profile(kind: &NodeKind) -> bool {
    let is_angle = |port: &str| kind.input(port).is_some_and(|at| kind.inputs[at].unit == "rad");
    PROFILE.iter().all(|port| is_angle(port))
}

/// Edge of a profile, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ProfileEdge {
    /// Middle of the edge, 0 to pi.
    pub(crate) at: f64,
    /// Width of the edge: 0 is hard.
    pub(crate) softness: f64,
}

impl ProfileEdge {
    /// Widest edge, in radians. A wider one could hardly be moved between 0 and pi.
    pub(crate) const WIDEST: f64 = FRAC_PI_2;
    /// Distance of the fall-off from the middle that rounding explains, in radians.
    const ROUNDING: f64 = 1.5e-4;

    /// Edge of a profile whose offset, fall-off and cut-off are these, in order; `None` where they
    /// are no edge.
    pub(crate) fn of([offset, falloff, cutoff]: [f64; 3]) -> Option<Self> {
        let softness = cutoff - offset;
        let is_edge = (falloff - 0.5 * (offset + cutoff)).abs() <= Self::ROUNDING
            && (-Self::ROUNDING..=Self::WIDEST + Self::ROUNDING).contains(&softness)
            && offset >= 0.0
            && cutoff <= PI;
        is_edge.then(|| Self { at: falloff, softness: softness.clamp(0.0, Self::WIDEST) })
    }

    /// Edge that is nearest to any profile: its tone is half where that of the profile is.
    pub(crate) fn nearest([offset, falloff, cutoff]: [f64; 3]) -> Self {
        let at = terminator_angle(offset, falloff, cutoff).unwrap_or(PI);
        Self { at, softness: 0.0 }.softened((cutoff - offset).clamp(0.0, Self::WIDEST))
    }

    /// Offset, fall-off and cut-off of the edge.
    pub(crate) fn angles(self) -> [f64; 3] {
        let half = 0.5 * self.softness;
        [(self.at - half).max(0.0), self.at, (self.at + half).min(PI)]
    }

    /// The edge elsewhere, as soft as before: within 0 and pi with its whole width.
    pub(crate) fn moved_to(self, at: f64) -> Self {
        let half = 0.5 * self.softness;
        if at.is_finite() { Self { at: at.clamp(half, PI - half), ..self } } else { self }
    }

    /// The edge where it is, with another softness: as wide as there is room between 0 and pi.
    pub(crate) fn softened(self, softness: f64) -> Self {
        let room = (2.0 * self.at.min(PI - self.at)).clamp(0.0, Self::WIDEST);
        if softness.is_finite() {
            Self { softness: softness.clamp(0.0, room), ..self }
        } else {
            self
        }
    }
}

/// Number of an edge that a field shows.
#[derive(Clone, Copy, PartialEq)]
enum EdgePart {
    At,
    Softness,
}

impl EdgePart {
    const BOTH: [Self; 2] = [Self::At, Self::Softness];

    fn label(self) -> &'static str {
        match self {
            Self::At => tr!("Edge"),
            Self::Softness => tr!("Softness"),
        }
    }

    fn help(self) -> &'static str {
        match self {
            Self::At => {
                tr!(
                    "Angle from the light at which the tone ends; sets offset, fall-off and cut-off"
                )
            }
            Self::Softness => tr!("How wide the edge is; 0 is hard. Sets offset and cut-off"),
        }
    }

    fn degrees(self, edge: ProfileEdge) -> f64 {
        match self {
            Self::At => edge.at.to_degrees(),
            Self::Softness => edge.softness.to_degrees(),
        }
    }

    /// Range in degrees that the other number leaves.
    fn range(self, edge: ProfileEdge) -> std::ops::RangeInclusive<f64> {
        let [low, high] = match self {
            Self::At => [edge.moved_to(0.0).at, edge.moved_to(PI).at],
            Self::Softness => [0.0, edge.softened(PI).softness],
        };
        low.to_degrees()..=high.to_degrees()
    }

    fn set(self, edge: ProfileEdge, degrees: f64) -> ProfileEdge {
        match self {
            Self::At => edge.moved_to(degrees.to_radians()),
            Self::Softness => edge.softened(degrees.to_radians()),
        }
    }
}

/// True for an angle of a profile of the open look that fields show as one edge.
pub(crate) fn is_of_edge(session: &Session, target: &Target) -> bool {
    let Target::Input { node, port } = target else { return false };
    let base = session.look_with_library();
    let kind = base.node_at(node).and_then(|found| base.catalog.of(found));
    if !PROFILE.contains(&port.as_str()) || !kind.is_some_and(|kind| has_profile(kind)) {
        return false;
    }
    let angle = |port: &str| {
        let target = Target::Input { node: node.clone(), port: port.into() };
        values::number(session.keys().value_at(&target).as_ref())
    };
    ProfileEdge::of(in_order(PROFILE.map(angle))).is_some()
}

/// Offset, fall-off and cut-off of a node, as one edge.
pub(crate) struct EdgeField<'a> {
    session: &'a Session,
    targets: [Target; 3],
    /// Values that an edit would change, in order.
    angles: [f64; 3],
    is_wired: bool,
}

impl<'a> EdgeField<'a> {
    /// The profile of a node of the open graph.
    pub(crate) fn of_node(session: &'a Session, id: &NodeId, kind: &NodeKind) -> Option<Self> {
        if !has_profile(kind) {
            return None;
        }
        let targets = PROFILE.map(|port| session.selection.target(id, &port.into()));
        let number = |target: &Target| values::number(session.keys().value_at(target).as_ref());
        let angles = in_order(targets.each_ref().map(number));
        let is_wired =
            PROFILE.iter().any(|port| session.graph().wire_into(id, &(*port).into()).is_some());
        Some(Self { session, targets, angles, is_wired })
    }

    /// The profile of the selected layer; `None` for a layer without one.
    pub(crate) fn of_layer(session: &'a Session, layer: &SelectedLayer) -> Option<Self> {
        let shape = layer.profile()?;
        Some(Self {
            session,
            targets: shape.each_ref().map(|setting| setting.target.clone()),
            angles: layer.angles_at_key(),
            is_wired: shape.iter().any(|setting| setting.is_wired),
        })
    }

    /// The edge that the profile is; `None` where it is none, or comes by wires.
    pub(crate) fn edge(&self) -> Option<ProfileEdge> {
        ProfileEdge::of(self.angles).filter(|_| !self.is_wired)
    }

    /// Values of the three angles for an edge.
    pub(crate) fn values_of(&self, edge: ProfileEdge) -> Vec<(Target, Value)> {
        let numbers = edge.angles().map(Value::Number);
        self.targets.iter().cloned().zip(numbers).collect()
    }

    /// The command that sets the edge, as part of the step of a widget that is held.
    pub(crate) fn set(&self, widget: egui::Id, edge: ProfileEdge) -> Command {
        let edit = self.session.keys().set_together(&self.values_of(edge));
        Command::EditHeld(widget, edit)
    }

    /// Lines that say what an edit changes where keys move the profile, and what the shot changes.
    fn keyed_help(&self) -> String {
        let keys = self.session.keys();
        let keyed = self.targets.iter().find(|it| keys.keyed_by(it) != KeyedBy::Nothing);
        let mut help = keyed.map_or(String::new(), |target| {
            tr!("\n{moved} All three angles are keyed together.", moved = mark::help(keys, target))
        });
        for changed in self.by_shot() {
            help += "\n";
            help += &changed.help();
        }
        help
    }

    /// Changes that the open shot makes of the three angles.
    fn by_shot(&self) -> impl Iterator<Item = ChangedValue<'a>> {
        let session = self.session;
        let of = move |target: &Target| ChangedValue::of(session, Owner::Look, &target.to_string());
        self.targets.iter().filter_map(of)
    }

    /// Paints the bar of values that the shot changes.
    fn bar(&self, ui: &Ui, area: egui::Rect) {
        if self.by_shot().next().is_some() {
            shot::bar(ui, area);
        }
    }

    /// Shows the entry that takes the shot's own changes of all three angles back, as one step.
    fn reset(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let Some((first, open)) = self.by_shot().next().zip(self.session.shot()) else { return };
        let own = self.by_shot().filter_map(|it| open.own(&ShotAddress::of(it.change)));
        let edits: Vec<ShotEdit> =
            own.map(|own| ShotEdit::take_back(own.look.clone(), own.target.clone())).collect();
        ui.separator();
        let button = ui.add_enabled(!edits.is_empty(), Button::new(first.reset_label()));
        if button.on_hover_text(first.help()).clicked() {
            let edit = ShotCommand::Edit(ShotEdit::Group { edits });
            out.push(Command::Scene(SceneCommand::Shot(edit)));
            ui.close();
        }
    }

    /// Shows both numbers side by side; `names` are their names for screen readers. Returns the
    /// ids of the fields.
    pub(crate) fn in_line(
        &self,
        ui: &mut Ui,
        names: [&str; 2],
        out: &mut Vec<Command>,
    ) -> Vec<egui::Id> {
        let Some(edge) = self.edge() else { return self.made_edge(ui, out) };
        let mut fields = Vec::new();
        for (part, name) in EdgePart::BOTH.into_iter().zip(names) {
            let mut degrees = part.degrees(edge);
            let field = number_field(ui, &mut degrees)
                .range(part.range(edge))
                .clamp_existing_to_range(false)
                .speed(0.5)
                .max_decimals(1)
                .prefix(format!("{} ", part.label()))
                .suffix("°");
            let response = ui.add(field);
            ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
            fields.push(response.id);
            if response.changed() {
                out.push(self.set(response.id, part.set(edge, degrees)));
            }
            response.on_hover_text(part.help().to_owned() + &self.keyed_help());
        }
        fields
    }

    /// Shows a button that makes an edge of the profile.
    fn made_edge(&self, ui: &mut Ui, out: &mut Vec<Command>) -> Vec<egui::Id> {
        if self.is_wired {
            return Vec::new();
        }
        let help =
            tr!("Makes the profile one edge, where its tone is half now: Edge and Softness in \
                 place of three angles");
        let response = ui.add(Button::new(tr!("As one edge")).small()).on_hover_text(help);
        if response.clicked() {
            let edge = ProfileEdge::nearest(self.angles);
            let edit = self.session.keys().set_together(&self.values_of(edge));
            out.push(Command::Edit(edit));
        }
        vec![response.id]
    }

    /// Shows both numbers as rows of an inspector, with one mark for the keys of all three angles.
    pub(crate) fn rows(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let Some(edge) = self.edge() else {
            let text = RichText::new(tr!("Profile")).color(theme::of(ui).dim);
            let help = tr!("Three angles of their own: not one edge");
            let mut made = Vec::new();
            row::with_slot(ui, text, help, |_, _| {}, |ui, _| drop(self.made_edge(ui, &mut made)));
            out.extend(made);
            return;
        };
        for part in EdgePart::BOTH {
            let text = RichText::new(part.label()).color(theme::of(ui).text);
            let help = part.help().to_owned() + &self.keyed_help();
            let mut keyed = Vec::new();
            let mark = |ui: &mut Ui, size: egui::Vec2| match part {
                EdgePart::At => self.diamond(ui, &mut keyed),
                EdgePart::Softness => {
                    let (rect, _) = ui.allocate_exact_size(size, egui::Sense::hover());
                    self.bar(ui, rect);
                }
            };
            let mut set = Vec::new();
            row::with_slot(ui, text, &help, mark, |ui, label| {
                let mut degrees = part.degrees(edge);
                ui.spacing_mut().slider_width = (ui.available_width() - 66.0).max(40.0);
                let whole = match part {
                    EdgePart::At => 0.0..=180.0,
                    EdgePart::Softness => 0.0..=ProfileEdge::WIDEST.to_degrees(),
                };
                let slider = number_slider(ui, &mut degrees, whole).suffix("°").max_decimals(1);
                let response = ui.add(slider);
                let response = response.labelled_by(label);
                if response.changed() && degrees.is_finite() {
                    set.push(self.set(response.id, part.set(edge, degrees)));
                }
            });
            out.extend(keyed);
            out.extend(set);
        }
    }

    /// Shows the mark of the three angles' keys, with a menu that keys them together.
    fn diamond(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let keys = self.session.keys();
        let keyed = self.targets.iter().find(|it| keys.keyed_by(it) != KeyedBy::Nothing);
        let response = mark::of(ui, keys, keyed.unwrap_or(&self.targets[1]), tr!("Keys of Edge"));
        self.bar(ui, response.rect);
        egui::Popup::menu(&response).show(|ui| scrolling(ui, |ui| self.menu(ui, out)));
        response.on_hover_text(match keyed {
            Some(target) => mark::help(keys, target),
            None => {
                tr!("Nothing moves the edge. Press to key it by a direction or in time.").to_owned()
            }
        });
    }

    fn menu(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let (keys, look) = (self.session.keys(), self.session.look());
        ui.set_min_width(190.0);
        if ui.button(tr!("Key here")).clicked() {
            out.push(Command::Edit(keys.key_together_in_time(&self.targets)));
            out.push(Command::ShowPanel(PanelId::TIMELINE));
        }
        for (index, set) in look.direction_keys.iter().enumerate() {
            if ui.button(tr!("Key in \"{set}\"", set = set.name)).clicked() {
                out.push(Command::Edit(keys.key_together_in_set(index, &self.targets)));
                out.push(Command::ShowPanel(PanelId::KEYS));
            }
        }
        let lights = look.lights.keys().map(|id| KeyDirection::Light(id.clone()));
        for by in lights.chain([KeyDirection::View]) {
            let text = match &by {
                KeyDirection::Light(id) => {
                    tr!("New keys by the light \"{light}\"", light = keys.base.light_name(id))
                }
                _ => tr!("New keys by the view").to_owned(),
            };
            let help = tr!("Begins keys with one where that is now");
            if ui.button(text).on_hover_text(help).clicked() {
                out.push(Command::Edit(keys.new_set_together(by, &self.targets)));
                let set = look.direction_keys.len();
                let place = KeyPlace { owner: Owner::Look, set, key: 0 };
                out.push(Command::SelectKey(Some(place)));
                out.push(Command::ShowPanel(PanelId::KEYS));
            }
        }
        let is_keyed = self.targets.iter().any(|it| keys.keyed_by(it) != KeyedBy::Nothing);
        if is_keyed && ui.button(tr!("Remove its keys")).clicked() {
            out.push(Command::Edit(keys.unkey_together(&self.targets)));
        }
        self.reset(ui, out);
    }
}

/// Switch that shows the three angles behind an edge.
pub(crate) struct AnglesToggle {
    pub(crate) is_open: bool,
    /// Id of the switch, where it is shown.
    pub(crate) widget: Option<egui::Id>,
}

/// Shows the switch of a node's three angles. Where the profile is no edge they are shown in any
/// case, and stay when it becomes one, as a drag of one of them may be under way.
pub(crate) fn angles_toggle(ui: &mut Ui, node: &NodePath, is_edge: bool) -> AnglesToggle {
    let id = egui::Id::unique(("three angles", node.to_string()));
    let mut is_open = ui.data(|data| data.get_temp::<bool>(id)).unwrap_or(!is_edge);
    if !is_edge {
        ui.data_mut(|data| data.insert_temp(id, true));
        return AnglesToggle { is_open: true, widget: None };
    }
    let response = ui.add(Button::new(tr!("3 angles")).small().selected(is_open));
    response.widget_info(|| {
        WidgetInfo::selected(egui::Role::Button, true, is_open, tr!("Show three angles"))
    });
    if response.clicked() {
        is_open = !is_open;
        ui.data_mut(|data| data.insert_temp(id, is_open));
    }
    let widget = Some(response.id);
    response.on_hover_text(tr!("Offset, fall-off and cut-off, which the edge sets"));
    AnglesToggle { is_open, widget }
}

/// Offset, fall-off and cut-off in order, 0 to pi, as the profile takes them (docs/math.md D2).
pub(crate) fn in_order(angles: [f64; 3]) -> [f64; 3] {
    let [offset, falloff, cutoff] = angles.map(|x| if x.is_finite() { x } else { 0.0 });
    let offset = offset.clamp(0.0, PI);
    let cutoff = cutoff.clamp(offset, PI);
    [offset, falloff.clamp(offset, cutoff), cutoff]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::Library;

    #[test]
    fn an_edge_is_read_from_the_angles_that_it_wrote() {
        for at in [0.0, 1e-3, 0.3, FRAC_PI_2, 3.0, PI] {
            for softness in [0.0, 1e-4, 0.2, 1.0, ProfileEdge::WIDEST] {
                let edge = ProfileEdge { at, softness: 0.0 }.softened(softness);
                let angles = edge.angles();
                assert_eq!(in_order(angles), angles, "in order, within 0 and pi");
                let read = ProfileEdge::of(angles).expect("it is an edge");
                assert!((read.at - edge.at).abs() < 1e-12, "{read:?} of {edge:?}");
                assert!((read.softness - edge.softness).abs() < 1e-12, "{read:?} of {edge:?}");
            }
        }
    }

    #[test]
    fn an_edge_moves_as_a_whole_and_stops_at_both_ends() {
        let soft = ProfileEdge::of([0.6, 0.8, 1.0]).expect("an edge");
        assert_eq!(soft.moved_to(1.8).angles().map(|x| (x * 1e9).round() / 1e9), [1.6, 1.8, 2.0]);
        let ends = [soft.moved_to(-9.0), soft.moved_to(9.0)].map(ProfileEdge::angles);
        assert_eq!((ends[0][0], ends[1][2]), (0.0, PI), "with its whole width");
        assert!((soft.moved_to(9.0).softness - 0.4).abs() < 1e-12);
        let hard = ProfileEdge::of([FRAC_PI_2 / 2.0; 3]).expect("a cartoon's is one");
        assert_eq!(hard.moved_to(0.0).angles(), [0.0; 3]);
        assert_eq!(hard.moved_to(PI).angles(), [PI; 3], "lit all over");
        assert_eq!(hard.moved_to(f64::NAN), hard);
        assert_eq!(hard.softened(f64::INFINITY), hard);
        assert_eq!(hard.moved_to(PI).softened(1.0).softness, 0.0, "no room is left there");
    }

    #[test]
    fn where_keys_move_one_angle_an_edge_keys_all_three() {
        let mut session = Session::new(std::sync::Arc::new(Library::built_in().clone()), || {});
        let targets = PROFILE.map(|port| session.selection.target(&"diffuse".into(), &port.into()));
        let edit = session.keys().new_set(KeyDirection::View, Some(&targets[2]));
        session.apply(edit, None).expect("keys");
        let edge = ProfileEdge { at: 0.9, softness: 0.2 };
        let kind = session.project.catalog.of(&session.look().graph.nodes["diffuse"]);
        let field = EdgeField::of_node(&session, &"diffuse".into(), kind.expect("a layer"));
        let set = field.expect("it has a profile").set(egui::Id::unique("edge"), edge);
        let Command::EditHeld(_, edit) = set else { panic!("{set:?}") };
        session.apply(edit, None).expect("one step");
        let key = session.look().direction_keys[0].keys[0].values.clone();
        for (target, angle) in targets.iter().zip(edge.angles()) {
            assert_eq!(key.get(target), Some(&Value::Number(angle)), "{target}");
        }
        let own = &session.look().graph.nodes["diffuse"].values;
        assert!(PROFILE.iter().all(|port| !own.contains_key(*port)), "the key alone was set");
        session.refresh_keys();
        session.apply(session.keys().unkey_together(&targets), None).expect("one step");
        assert!(session.look().direction_keys[0].keys[0].values.is_empty());
        assert_eq!(session.keys().value_now(&targets[1]), Some(Value::Number(0.9)), "it stays");
    }

    #[test]
    fn profiles_with_three_angles_of_their_own_are_no_edge_until_asked() {
        let lambert = [0.0, FRAC_PI_2, FRAC_PI_2];
        let half_lambert = [0.0, FRAC_PI_2, PI];
        for angles in [lambert, half_lambert, [0.0, 0.3, FRAC_PI_2], [0.6, 1.0, 1.3]] {
            assert_eq!(ProfileEdge::of(angles), None, "{angles:?}");
            let edge = ProfileEdge::nearest(angles);
            let read = ProfileEdge::of(edge.angles()).expect("an edge now");
            let apart = (read.at - edge.at).abs() + (read.softness - edge.softness).abs();
            assert!(apart < 1e-12, "{read:?} of {angles:?}");
        }
        let edge = ProfileEdge::nearest(lambert);
        assert!((edge.at - 60_f64.to_radians()).abs() < 1e-9, "half of its tone: {edge:?}");
        let ambient = ProfileEdge::nearest([PI; 3]);
        assert_eq!(ambient.angles(), [PI; 3]);
    }
}
