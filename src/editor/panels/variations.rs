//! Sheet of variations: small pictures of a value from one to another, of colors and directions
//! around the present one, of all choices, or of meshes. A click takes one.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use chiaro_locale::{text, tr};
use eframe::egui::{
    Button, Color32, ComboBox, FontId, Rect, RichText, Role, ScrollArea, Sense, Stroke, StrokeKind,
    Ui, WidgetInfo, pos2, vec2,
};

use super::library::cards::columns;
use super::thumbs::{Shot, Thumbs, key_of};
use crate::commands::{Command, MESHES, PanelId, SceneCommand};
use crate::document::{LightField, Target};
use crate::fields::lighting::{Change, OwnedKeys, Owner};
use crate::fields::wedge::selected_values;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::crashes::DocumentOrigin;
use crate::state::session::Session;
use crate::state::snapshot::{RenderSnapshot, Stamp};
use crate::state::variations::{STEPS, Variation, VariationKind, VariationSheet, VariedSubject};
use crate::widgets::number::{number_field, number_slider};
use crate::widgets::rows::{picture_frame, whole};
use crate::widgets::text::{cell, hint};
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::VARIATIONS,
    text!("Variations"),
    text!(
        "Small pictures of a value, a color, a light or the mesh as it could be; a click takes one"
    ),
    PanelPlace::WITH_DOCUMENT.closed(),
    |bench, ui, context| bench.memory.of::<Variations>().show(ui, context.session, &bench.thumbs),
);

/// Least width of a picture, in points.
const CELL: f32 = 92.0;
/// Number of pictures across of a sheet around a color or a direction.
const AROUND: usize = 3;
/// Height of the words below a picture, in points.
const WORDS: f32 = 18.0;
/// Side of a picture as drawn, in pixels.
const SIDE: f32 = 200.0;

/// Cell of the sheet, with the key of its picture.
struct SheetCell {
    variation: Variation,
    label: String,
    key: u64,
}

/// The panel, with the sheet that was asked for last.
#[derive(Default)]
pub(crate) struct Variations {
    sheet: Option<VariationSheet>,
    cells: Vec<SheetCell>,
    /// State that the keys of the cells are of.
    of: Option<(Stamp, VariationSheet)>,
    /// Variation that was taken last.
    taken: Option<Variation>,
}

impl Variations {
    /// Shows variations of a subject from now on.
    pub(crate) fn begin(&mut self, subject: VariedSubject, session: &Session) {
        self.sheet = sheet_of(subject, session);
        (self.of, self.taken) = (None, None);
        self.cells.clear();
    }

    fn show(&mut self, ui: &mut Ui, session: &Session, thumbs: &Thumbs) -> Vec<Command> {
        let mut out = Vec::new();
        self.choice(ui, session);
        let Some(sheet) = &mut self.sheet else {
            hint(
                ui,
                tr!("Choose what to vary: a value of the selected node, a light, the mesh. A \
                     value's own menu has Variations too."),
            );
            return out;
        };
        if !is_there(session, &sheet.subject) {
            hint(ui, tr!("What was varied is not in the look or the scene any more."));
            return out;
        }
        controls(ui, sheet, self.taken.as_ref());
        let kind = sheet.kind;
        self.know_cells(session, thumbs);
        let mut clicked = None;
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("variations").show(ui, |ui| {
            let gap = 4.0;
            let width = ui.available_width() - 8.0;
            let (columns, side) = match kind {
                // Across and up and down mean something.
                VariationKind::Color | VariationKind::Direction => {
                    (AROUND, ((width + gap) / AROUND as f32 - gap).max(1.0))
                }
                _ => columns(width, CELL, gap),
            };
            ui.spacing_mut().item_spacing = vec2(gap, gap);
            for (row, cells) in self.cells.chunks(columns).enumerate() {
                ui.horizontal(|ui| {
                    for (column, cell) in cells.iter().enumerate() {
                        if self.picture(ui, session, thumbs, cell, side) {
                            clicked = Some(row * columns + column);
                        }
                    }
                });
            }
        });
        thumbs.look_again(ui);
        if let Some(found) = clicked.and_then(|index| self.cells.get(index)) {
            self.taken = Some(found.variation.clone());
            out.extend(
                self.sheet.as_ref().and_then(|sheet| take(session, sheet, &found.variation)),
            );
        }
        out
    }

    /// Shows the choice of what is varied.
    fn choice(&mut self, ui: &mut Ui, session: &Session) {
        let title = |subject: &VariedSubject| match subject {
            VariedSubject::Mesh => tr!("Mesh").to_owned(),
            VariedSubject::ObjectMesh(id) => format!("{id}: {}", tr!("Mesh")),
            VariedSubject::Value(owner, target) => {
                let owned = OwnedKeys::of(session, *owner);
                owned.map(|owned| owned.keys.base.title_of_target(target)).unwrap_or_default()
            }
        };
        let now = self.sheet.as_ref().map(|sheet| sheet.subject.clone());
        let text = now.as_ref().map_or_else(|| tr!("Choose").to_owned(), title);
        let mut chosen = None;
        ui.horizontal(|ui| {
            let label = ui.label(tr!("Vary"));
            let width = ui.available_width().min(150.0);
            let combo = ComboBox::from_id_salt("vary").width(width).truncate().selected_text(text);
            let combo = combo.height(320.0).show_ui(ui, |ui| {
                for subject in subjects(session) {
                    let is_it = now.as_ref() == Some(&subject);
                    if ui.selectable_label(is_it, title(&subject)).clicked() {
                        chosen = Some(subject);
                    }
                }
            });
            combo.response.labelled_by(label.id);
        });
        if let Some(subject) = chosen {
            self.begin(subject, session);
        }
    }

    /// Finds the cells anew where anything changed that they depend on, once the window rests.
    fn know_cells(&mut self, session: &Session, thumbs: &Thumbs) {
        let Some(sheet) = &self.sheet else { return };
        let stamp = session.stamp();
        let is_same = |(of, made): &(Stamp, VariationSheet)| *of == stamp && made == sheet;
        let is_other = !self.of.as_ref().is_some_and(|(_, made)| made == sheet);
        if self.of.as_ref().is_some_and(is_same) || !thumbs.rests() && !is_other {
            return;
        }
        let cell = |variation: Variation| {
            let drawn = drawn(session, sheet, &variation);
            let mut hasher = DefaultHasher::new();
            let RenderSnapshot { look, orbit, .. } = &drawn;
            key_of(look, Shot::Whole, SIDE).hash(&mut hasher);
            let keys = (&look.direction_keys, &look.time_keys, orbit);
            format!("{:?}", (keys, &sheet.subject, &variation)).hash(&mut hasher);
            (session.view.time.to_bits(), session.revisions().files).hash(&mut hasher);
            format!("{:?}", session.scene_revision()).hash(&mut hasher);
            SheetCell { label: sheet.label(&variation), variation, key: hasher.finish() }
        };
        self.cells = sheet.cells().into_iter().map(cell).collect();
        self.of = Some((stamp, sheet.clone()));
    }

    /// Shows a cell; true if it is clicked.
    fn picture(
        &self,
        ui: &mut Ui,
        session: &Session,
        thumbs: &Thumbs,
        of: &SheetCell,
        side: f32,
    ) -> bool {
        let (rect, response) = ui.allocate_exact_size(vec2(side, side + WORDS), Sense::click());
        if !ui.is_rect_visible(rect) {
            return false;
        }
        let name = tr!("Take {value}", value = of.label);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        if !thumbs.is_done(of.key)
            && let Some(sheet) = &self.sheet
        {
            let origin = || DocumentOrigin::new(&session.name(), session.path(), session.look());
            let snapshot = || drawn(session, sheet, &of.variation);
            thumbs.ask_in_view(of.key, origin, snapshot, SIDE);
        }
        let picture = Rect::from_min_size(rect.min, vec2(side, side));
        ui.painter().rect_filled(picture, 3.0, theme::of(ui).canvas);
        if let Some(texture) = thumbs.known(of.key) {
            ui.painter().image(texture, picture.shrink(1.0), whole(), Color32::WHITE);
        }
        picture_frame(ui, picture);
        let is_taken = self.taken.as_ref() == Some(&of.variation);
        let is_hot = response.hovered() || response.has_focus();
        if is_taken || is_hot {
            let stroke = Stroke::new(if is_hot { 2.5 } else { 1.5 }, theme::of(ui).accent);
            ui.painter().rect_stroke(picture, 3.0, stroke, StrokeKind::Inside);
        }
        let words = Rect::from_min_max(pos2(rect.left() + 2.0, picture.bottom()), rect.max);
        let font = FontId::proportional(theme::SMALL_TEXT);
        cell(ui, words, &of.label, font, theme::of(ui).text);
        let help = tr!("{value}: a click takes it, as one step", value = of.label);
        response.on_hover_text(help).clicked()
    }
}

/// Fields of lights that are offered.
const FIELDS: [LightField; 3] = [LightField::Direction, LightField::Color, LightField::Intensity];

/// Subjects that can be varied: values of the selected nodes, the lights of the look and of the
/// scene, and the mesh.
fn subjects(session: &Session) -> Vec<VariedSubject> {
    let selected = selected_values(session).into_iter().map(|target| (Owner::Look, target));
    let of_lights = OwnedKeys::all(session).flat_map(|owned| {
        let lights = owned.look().lights.iter();
        // A light of the scene stands in place of the look's.
        let is_covered =
            move |id| owned.owner == Owner::Look && session.keys().light_of_scene(id).is_some();
        let seen = lights.filter(move |(id, _)| !is_covered(id));
        seen.flat_map(move |(id, light)| {
            let fields = light.fields().filter(|field| FIELDS.contains(field));
            let target = move |field: LightField| {
                let field = field.name().to_owned();
                (owned.owner, Target::Light { light: id.clone(), field })
            };
            fields.map(target)
        })
    });
    let can_vary = |(owner, target): &(Owner, Target)| {
        let port = OwnedKeys::of(session, *owner).and_then(|owned| owned.keys.base.port_at(target));
        port.is_some_and(|port| VariationKind::of(target, &port).is_some())
    };
    let values = selected.chain(of_lights).filter(can_vary);
    let values = values.map(|(owner, target)| VariedSubject::Value(owner, target));
    let mesh = match session.open_scene() {
        None => Some(VariedSubject::Mesh),
        Some(open_scene) => open_scene.selected_or_worn().cloned().map(VariedSubject::ObjectMesh),
    };
    values.chain(mesh).collect()
}

/// Sheet around the present state of a subject; in a scene, a mesh is that of the object in
/// question. `None` where the subject is not there, or cannot be varied.
fn sheet_of(subject: VariedSubject, session: &Session) -> Option<VariationSheet> {
    let id = match (subject, session.open_scene()) {
        (VariedSubject::Value(owner, target), _) => {
            let keys = OwnedKeys::of(session, owner)?.keys;
            let now = keys.value_at(&target);
            return VariationSheet::of_value((owner, target), keys.base, now);
        }
        (VariedSubject::Mesh, None) => return Some(VariationSheet::of_shapes()),
        (VariedSubject::Mesh, Some(open_scene)) => open_scene.selected_or_worn()?.clone(),
        (VariedSubject::ObjectMesh(id), _) => id,
    };
    VariationSheet::of_object(session.open_scene()?, id, &**session.assets.source(), &MESHES)
}

/// True if the open documents have a subject.
fn is_there(session: &Session, subject: &VariedSubject) -> bool {
    let has_object =
        |id| session.open_scene().is_some_and(|of| of.scene().objects.contains_key(id));
    let (owner, target) = match subject {
        VariedSubject::Value(owner, target) => (owner, target),
        VariedSubject::Mesh => return session.open_scene().is_none(),
        VariedSubject::ObjectMesh(id) => return has_object(id),
    };
    let Some(owned) = OwnedKeys::of(session, *owner) else { return false };
    match target {
        Target::Light { light, .. } => owned.look().lights.contains_key(light),
        Target::Input { .. } => owned.keys.base.port_at(target).is_some(),
    }
}

/// Shows the controls of a sheet.
fn controls(ui: &mut Ui, sheet: &mut VariationSheet, taken: Option<&Variation>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        match sheet.kind {
            VariationKind::Number { .. } => {
                let (factor, suffix) =
                    if sheet.is_angle() { (1.0_f64.to_degrees(), "°") } else { (1.0, "") };
                let [least, most] = sheet.bounds();
                for (side, name) in [(0, tr!("From")), (1, tr!("To"))] {
                    let label = ui.label(name);
                    let mut shown = sheet.range[side] * factor;
                    let drag = number_field(ui, &mut shown).suffix(suffix).max_decimals(3);
                    let speed =
                        ((sheet.range[1] - sheet.range[0]).abs() * factor / 100.0).max(0.001);
                    let drag = drag.range(least * factor..=most * factor).speed(speed);
                    if ui.add(drag).labelled_by(label.id).changed() {
                        sheet.range[side] = shown / factor;
                    }
                }
                let label = ui.label(tr!("Steps"));
                let drag = number_field(ui, &mut sheet.steps).range(STEPS).speed(0.1);
                ui.add(drag).labelled_by(label.id);
            }
            VariationKind::Color | VariationKind::Direction => {
                let label = ui.label(tr!("How far"));
                let slider = number_slider(ui, &mut sheet.spread, 0.02..=1.0).show_value(false);
                ui.add(slider).labelled_by(label.id);
            }
            VariationKind::Choice | VariationKind::Mesh => {}
        }
        let can = matches!(
            sheet.kind,
            VariationKind::Number { .. } | VariationKind::Color | VariationKind::Direction
        );
        if can {
            let help = tr!("A finer sheet around the one that was taken");
            let button = ui.add_enabled(taken.is_some(), Button::new(tr!("Again around this one")));
            let button = button.on_hover_text(help).on_disabled_hover_text(tr!("Take one first"));
            if let Some(taken) = taken.filter(|_| button.clicked()) {
                sheet.again_around(taken);
            }
        }
    });
    let text = match sheet.kind {
        VariationKind::Color => tr!("Hues across, brighter above"),
        VariationKind::Direction => tr!("From the left to the right, from above to below"),
        _ => return,
    };
    ui.label(RichText::new(text).small().color(theme::of(ui).dim));
}

/// Command that takes a variation.
fn take(session: &Session, sheet: &VariationSheet, variation: &Variation) -> Option<Command> {
    match (&sheet.subject, variation) {
        (VariedSubject::Value(owner, target), Variation::Value(value)) => {
            let owned = OwnedKeys::of(session, *owner)?;
            owned.once(owned.keys.set_at(target, value.clone()))
        }
        (VariedSubject::Mesh, Variation::Mesh(name)) => Some(Command::ShowOn(Some(name.into()))),
        (_, variation) => {
            let edit = sheet.edit_of(session.open_scene()?, variation)?;
            Some(Command::Scene(SceneCommand::Edit(edit)))
        }
    }
}

/// The picture of a variation, as it is requested. A value that cannot be set leaves the picture
/// as it is.
fn drawn(session: &Session, sheet: &VariationSheet, variation: &Variation) -> RenderSnapshot {
    let mut look = session.look().clone();
    let mut of_scene = session.open_scene().and_then(|of| sheet.edit_of(of, variation));
    if let (VariedSubject::Value(owner, target), Variation::Value(value)) =
        (&sheet.subject, variation)
        && let Some(owned) = OwnedKeys::of(session, *owner)
    {
        match owner.change(session, owned.keys.set_at(target, value.clone())) {
            Some(Change::Look(edit)) => drop(look.apply(edit)),
            Some(Change::Scene(edit)) => of_scene = Some(edit),
            None => {}
        }
    }
    let mut snapshot = session.snapshot_of(Arc::new(look));
    if let (Some(edit), Some(scene)) = (of_scene, &mut snapshot.scene) {
        drop(Arc::make_mut(scene).scene.apply(edit));
    }
    if let (VariedSubject::Mesh, Variation::Mesh(name)) = (&sheet.subject, variation) {
        (snapshot.orbit.mesh, snapshot.orbit.z_is_up) = (name.clone(), false);
    }
    snapshot
}
