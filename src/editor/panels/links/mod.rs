//! Links: lights at the left, objects at the right, and which of them light which. What is selected
//! on one side marks the other: select lights and see what they light, select objects and see what
//! lights them, each with the rule that decides. Buttons change the links of the selected objects.
//! An object unfolds to the layers of its looks that are about lights, which are marked alike.

mod layer;
mod list;
mod matrix;
mod relation;

use std::collections::BTreeSet;

use chiaro_locale::{text, tr};
use eframe::egui;
use eframe::egui::{
    Button, Id, Label, Layout, RichText, Role, TextEdit, Ui, UiBuilder, WidgetInfo, vec2,
};

use crate::commands::{Command, PanelId, SceneCommand};
use crate::document::{ColorSpace, LightSet, SceneEdit, SetTerm};
use crate::fields::layer::light_at_hand;
use crate::fields::mix::{MixedLights, SceneMix};
use crate::ids::{LightGroup, LightId, ObjectId};
use crate::panels::table::{PanelPlace, PanelRow, Presence};
use crate::state::scene::OpenScene;
use crate::state::session::Session;
use crate::widgets::text::hint;
use crate::widgets::theme;
use layer::LayerRow;
use matrix::{LinkMatrix, MatrixSource};
use relation::{LinkChange, Relation};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::LINKS,
    text!("Links"),
    text!(
        "Which lights light which objects and cast their shadows, by which rule: link and unlink \
         them"
    ),
    PanelPlace::BELOW_GRAPH,
    |bench, ui, context| bench.links.show(ui, context.session),
)
.with_each_frame(|bench, _, session, presence| {
    let pointed = bench.viewport.hovered().cloned();
    bench.links.follow(session, pointed, presence);
    Vec::new()
})
.with_jobs(|bench| &bench.links.source);

/// Row of the lights' pane. Groups stand above lights.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum LightRow {
    Group(LightGroup),
    Light(LightId),
}

impl LightRow {
    /// Term that stands for the row in sets.
    fn term(&self) -> SetTerm {
        match self {
            Self::Group(group) => SetTerm::Group(group.to_string()),
            Self::Light(id) => SetTerm::Id(id.to_string()),
        }
    }
}

/// Row of the objects' pane. Layers of an object stand below it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum ObjectRow {
    Object(ObjectId),
    Layer(ObjectId, LayerRow),
}

impl ObjectRow {
    /// The object, where the row is not a layer of one.
    fn object(&self) -> Option<&ObjectId> {
        match self {
            Self::Object(id) => Some(id),
            Self::Layer(..) => None,
        }
    }
}

/// The panel and its state.
pub(crate) struct Links {
    source: MatrixSource,
    lights: MixedLights,
    relation: Relation,
    /// Selected rows of the lights' pane.
    chosen_lights: BTreeSet<LightRow>,
    /// Selected rows of the objects' pane.
    chosen_objects: BTreeSet<ObjectRow>,
    /// Objects whose layers are listed.
    unfolded: BTreeSet<ObjectId>,
    /// Expression to append or to put in place; empty for the selected lights.
    expression: String,
    /// Object of the picture that the pointer was last at.
    pointed: Option<ObjectId>,
    /// Object that was selected in the picture when the panes last followed it.
    followed: Option<ObjectId>,
}

/// State that both panes show.
struct PaneContext<'s> {
    open_scene: &'s OpenScene,
    mix: SceneMix<'s>,
    matrix: &'s LinkMatrix,
    relation: Relation,
    space: ColorSpace,
}

impl Links {
    /// `wake` is called from another thread when links are resolved.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        Self {
            source: MatrixSource::new(wake),
            lights: MixedLights::default(),
            relation: Relation::default(),
            chosen_lights: BTreeSet::new(),
            chosen_objects: BTreeSet::new(),
            unfolded: BTreeSet::new(),
            expression: String::new(),
            pointed: None,
            followed: None,
        }
    }

    /// Notes the object under the pointer, and selects the one that is selected in the picture.
    fn follow(&mut self, session: &Session, pointed: Option<ObjectId>, presence: Presence) {
        let Some(open_scene) = session.open_scene() else { return };
        self.pointed = pointed.or(self.pointed.take());
        let objects = &open_scene.scene().objects;
        if self.pointed.as_ref().is_some_and(|id| !objects.contains_key(id)) {
            self.pointed = None;
        }
        let selected = open_scene.selected().map(|(id, _)| id.clone());
        if presence == Presence::Seen && self.followed != selected {
            if let Some(selected) = &selected {
                self.chosen_objects = BTreeSet::from([ObjectRow::Object(selected.clone())]);
            }
            self.followed = selected;
        }
    }

    /// Shows both panes, with what changes links above them.
    pub(crate) fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        self.lights.sync(session);
        let mut out = Vec::new();
        let Some(open_scene) = session.open_scene() else {
            hint(
                ui,
                tr!("A scene links its lights to its objects: add an object beside this one, and \
                     there is a scene. Until then every light lights the object."),
            );
            return out;
        };
        let matrix = self.source.matrix(session);
        let object_rows = self.object_rows(open_scene, &matrix);
        self.chosen_objects.retain(|row| object_rows.contains(row));
        let rows: Vec<LightRow> = self.rows(open_scene);
        self.chosen_lights.retain(|row| rows.contains(row));
        if matrix.is_too_large {
            let text = tr!("There are too many lights and objects to list what lights what here: \
                            chiaro lights --matrix does. Links can be changed.");
            ui.label(RichText::new(text).color(theme::of(ui).warning));
        } else if matrix.has_no_layers {
            hint(
                ui,
                tr!("With so many lights and objects chiaro lights --matrix lists their layers."),
            );
        }
        self.bar(ui, open_scene, &mut out);
        let Some(mix) = SceneMix::of(session, &self.lights) else { return out };
        let (relation, space) = (self.relation, session.look().color_space);
        let context = PaneContext { open_scene, mix, matrix: &matrix, relation, space };
        let room = ui.available_rect_before_wrap();
        let gap = 10.0;
        let half = ((room.width() - gap) / 2.0).max(40.0);
        let left = egui::Rect::from_min_size(room.min, vec2(half, room.height()));
        let right = left.translate(vec2(half + gap, 0.0));
        let mut marked = None;
        for (index, area) in [left, right].into_iter().enumerate() {
            let builder = UiBuilder::new().max_rect(area).id_salt(("pane", index));
            let mut ui = ui.new_child(builder.layout(Layout::top_down(egui::Align::LEFT)));
            ui.set_clip_rect(area.intersect(ui.clip_rect()));
            let change = match index {
                0 => list::lights(
                    &mut ui,
                    &context,
                    &rows,
                    &mut self.chosen_lights,
                    &self.chosen_objects,
                    &mut out,
                ),
                _ => list::objects(
                    &mut ui,
                    &context,
                    (&object_rows, &mut self.unfolded),
                    &self.chosen_lights,
                    &mut self.chosen_objects,
                    &mut out,
                ),
            };
            marked = marked.or(change);
        }
        ui.allocate_rect(room, egui::Sense::hover());
        if let Some((change, objects)) = marked {
            out.extend(self.change(open_scene, &change, objects.iter()));
        }
        out
    }

    fn rows(&self, open_scene: &OpenScene) -> Vec<LightRow> {
        let groups = self.lights.groups(Some(open_scene.scene())).into_iter().map(LightRow::Group);
        groups.chain(self.lights.lights().keys().cloned().map(LightRow::Light)).collect()
    }

    /// Rows of the objects' pane: the objects, those that are unfolded with their layers.
    fn object_rows(&self, open_scene: &OpenScene, matrix: &LinkMatrix) -> Vec<ObjectRow> {
        let has_layers = self.relation == Relation::Light;
        let objects = open_scene.scene().objects.keys();
        objects
            .flat_map(|id| {
                let is_open = has_layers && self.unfolded.contains(id);
                let layers = matrix.layers(id).filter(move |_| is_open);
                let layers = layers.map(|(row, _)| ObjectRow::Layer(id.clone(), row.clone()));
                std::iter::once(ObjectRow::Object(id.clone())).chain(layers)
            })
            .collect()
    }

    /// Selected objects, without their layers.
    fn objects_in_hand(&self) -> impl Iterator<Item = &ObjectId> {
        self.chosen_objects.iter().filter_map(ObjectRow::object)
    }

    /// Terms of the selected lights.
    fn terms(&self) -> Vec<SetTerm> {
        self.chosen_lights.iter().map(LightRow::term).collect()
    }

    /// Command that changes the links of objects, as one step; `None` where nothing changes.
    fn change<'o>(
        &self,
        open_scene: &OpenScene,
        change: &LinkChange,
        objects: impl Iterator<Item = &'o ObjectId>,
    ) -> Option<Command> {
        let mut edits: Vec<SceneEdit> = objects
            .filter_map(|id| {
                let now = self.relation.sets(open_scene.scene().objects.get(id)?);
                let new = change.of(&now, self.lights.lights());
                let edit = open_scene.change(id, |object| self.relation.set(object, new.clone()));
                edit.filter(|_| new != now)
            })
            .collect();
        let edit = match edits.len() {
            0 => return None,
            1 => edits.remove(0),
            _ => SceneEdit::Group { edits },
        };
        Some(Command::Scene(SceneCommand::Edit(edit)))
    }

    /// Commands that link the selected lights to the object under the pointer, or to the one that
    /// is selected in the picture, or that unlink them.
    pub(crate) fn link_pointed(&mut self, session: &Session, is_linked: bool) -> Vec<Command> {
        self.lights.sync(session);
        let tell = |text: &str| vec![Command::Tell(text.to_owned())];
        let Some(open_scene) = session.open_scene() else {
            return tell(tr!(
                "Lights are linked to objects of a scene: add an object to begin one"
            ));
        };
        let mut terms = self.terms();
        if terms.is_empty() {
            // The light at hand stands in for a selection.
            terms.extend(light_at_hand(session).map(|id| SetTerm::Id(id.to_string())));
        }
        if terms.is_empty() {
            let mut out =
                tell(tr!("Select lights in Links first: then this links them to the object"));
            out.push(Command::ShowPanel(PanelId::LINKS));
            return out;
        }
        let Some(object) = self.pointed_object(open_scene) else {
            return tell(tr!("Point at an object in the picture, or select one"));
        };
        let names: Vec<String> = terms.iter().map(ToString::to_string).collect();
        let text = self.relation.sentence(is_linked, &object, &names.join(", "));
        let change = match is_linked {
            true => LinkChange::Link(terms),
            false => LinkChange::Unlink(terms),
        };
        let edit = self.change(open_scene, &change, [&object].into_iter());
        edit.into_iter().chain([Command::Tell(text)]).collect()
    }

    /// Object that the pointer was last at in the picture, or else the one selected there.
    fn pointed_object(&self, open_scene: &OpenScene) -> Option<ObjectId> {
        let selected = || open_scene.selected().map(|(id, _)| id.clone());
        self.pointed.clone().or_else(selected)
    }

    fn bar(&mut self, ui: &mut Ui, open_scene: &OpenScene, out: &mut Vec<Command>) {
        let terms = self.terms();
        let is_ready = !terms.is_empty() && self.objects_in_hand().next().is_some();
        ui.horizontal_wrapped(|ui| {
            for relation in Relation::ALL {
                let response = ui.selectable_value(&mut self.relation, relation, relation.label());
                response.on_hover_text(relation.help());
            }
            ui.separator();
            let missing = tr!("Select lights at the left and objects at the right first");
            for (label, help, change) in [
                (
                    tr!("Link"),
                    tr!("Adds the selected lights to the sets of the selected objects"),
                    LinkChange::Link(terms.clone()),
                ),
                (
                    tr!("Unlink"),
                    tr!("Takes the selected lights out of the sets of the selected objects"),
                    LinkChange::Unlink(terms.clone()),
                ),
            ] {
                let button = ui.add_enabled(is_ready, Button::new(label));
                let button = button.on_hover_text(help).on_disabled_hover_text(missing);
                if button.clicked() {
                    out.extend(self.change(open_scene, &change, self.objects_in_hand()));
                }
            }
            ui.separator();
            self.expression(ui, open_scene, &terms, out);
            self.pointed_buttons(ui, open_scene, &terms, out);
        });
        ui.add_space(2.0);
    }

    /// Shows the field of an expression, and the buttons that append it and put it in place.
    fn expression(
        &mut self,
        ui: &mut Ui,
        open_scene: &OpenScene,
        terms: &[SetTerm],
        out: &mut Vec<Command>,
    ) {
        let of_terms: Vec<String> = terms.iter().map(ToString::to_string).collect();
        let of_terms = of_terms.join(" | ");
        let shown = if of_terms.is_empty() { "key | group:rim" } else { &of_terms };
        let typed = !self.expression.trim().is_empty();
        let text = if typed { self.expression.trim().to_owned() } else { of_terms.clone() };
        let set = LightSet::parse(&text);
        let colors = theme::of(ui);
        let ink = if set.is_ok() { colors.text } else { colors.error };
        let edit = TextEdit::singleline(&mut self.expression)
            .id(Id::unique("expression of links"))
            .hint_text(shown)
            .text_color(ink)
            .desired_width(130.0)
            .char_limit(400);
        let response = ui.add(edit);
        response.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, tr!("Set of lights")));
        response.on_hover_text(match &set {
            Err(why) => why.to_string(),
            Ok(_) => {
                tr!("A set of lights, for Append and Replace; without a text the selected lights. \
                     * is every light. key | group:rim - \"Sun\" says more.")
                .to_owned()
            }
        });
        let is_ready = self.objects_in_hand().next().is_some() && !text.is_empty();
        for (label, help, make) in [
            (
                tr!("Append"),
                tr!("Adds this expression to the sets of the selected objects, as it is written"),
                LinkChange::Append as fn(LightSet) -> LinkChange,
            ),
            (
                tr!("Replace"),
                tr!("Puts this expression in place of the sets of the selected objects, and of \
                     their exceptions"),
                LinkChange::Replace as fn(LightSet) -> LinkChange,
            ),
        ] {
            let button = ui.add_enabled(is_ready && set.is_ok(), Button::new(label));
            let missing = tr!("Select objects at the right, and lights at the left or a set here");
            let button = button.on_hover_text(help).on_disabled_hover_text(missing);
            if let (true, Ok(set)) = (button.clicked(), &set) {
                let change = make(set.clone());
                out.extend(self.change(open_scene, &change, self.objects_in_hand()));
            }
        }
    }

    /// Shows the object of the picture that was pointed at, with its buttons.
    fn pointed_buttons(
        &self,
        ui: &mut Ui,
        open_scene: &OpenScene,
        terms: &[SetTerm],
        out: &mut Vec<Command>,
    ) {
        let Some(object) = self.pointed_object(open_scene) else { return };
        ui.separator();
        let text = RichText::new(tr!("Picture: {object}")).color(theme::of(ui).dim);
        ui.add(Label::new(text).extend()).on_hover_text(tr!(
            "The object of the picture that the pointer was last at, or the selected one. Over the \
             picture J links the selected lights to it, Shift+J unlinks them."
        ));
        for (label, is_linked) in [(tr!("Link it"), true), (tr!("Unlink it"), false)] {
            let help = match is_linked {
                true => tr!("Links the selected lights to this object (J over the picture)"),
                false => {
                    tr!("Unlinks the selected lights from this object (Shift+J over the picture)")
                }
            };
            let button = ui.add_enabled(!terms.is_empty(), Button::new(label));
            let button = button.on_hover_text(help);
            if button.on_disabled_hover_text(tr!("Select lights at the left first")).clicked() {
                let change = match is_linked {
                    true => LinkChange::Link(terms.to_vec()),
                    false => LinkChange::Unlink(terms.to_vec()),
                };
                out.extend(self.change(open_scene, &change, [&object].into_iter()));
            }
        }
    }
}
