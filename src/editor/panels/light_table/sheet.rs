//! Rows and cells of the light table, read from the open look and the scene around it.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use chiaro_locale::{tr, trn};
use eframe::egui::Color32;

use super::column::Column;
use super::typed::NumberForm;
use crate::document::{GroupMaster, LightField, LightSet, MAX_EXPOSURE, Scene, SetTerm, Target};
use crate::fields::lighting::{OwnedKeys, OwnedLight, Owner};
use crate::fields::mark;
use crate::fields::mix::{MixedLights, SceneMix};
use crate::ids::{LightGroup, LightId};
use crate::panels::lights::{groups_text, kind_name, space_name, swatch};
use crate::state::keying::KeyedBy;
use crate::state::session::Session;
use crate::widgets::color;

/// Row of the table. Groups stand above lights.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Row {
    Group(LightGroup),
    Light(LightId),
}

impl Row {
    /// Term that stands for the row's lights in sets.
    pub(super) fn term(&self) -> SetTerm {
        match self {
            Self::Group(group) => SetTerm::Group(group.to_string()),
            Self::Light(id) => SetTerm::Id(id.to_string()),
        }
    }
}

/// Value of a cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum CellValue {
    Switch(bool),
    Text(String),
    Numbers(Vec<f64>, NumberForm),
    /// Straight RGB in the look's color space.
    Color([f64; 3]),
}

/// Origin of a cell's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// The document that edits go to has the value.
    Own,
    /// A look has the value, and the scene none in its place; or no master is there.
    Inherited,
    /// Keys move the value.
    Keyed,
}

/// Effect of the scene's mix, of this window's solos or of objects on a cell's value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Override {
    /// Cause of it, in words.
    pub(super) by: String,
    pub(super) effect: Effect,
}

/// Rest of a value that is overridden.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Effect {
    /// The light is out.
    Out,
    /// The mix leaves this of it.
    Left(CellValue),
    /// So many objects have values of their own in its place.
    Objects(usize),
}

/// Cell of the table. Without a value, lights of the kind have no such field.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) value: Option<CellValue>,
    pub(super) origin: Origin,
    pub(super) overridden: Option<Override>,
}

/// Lights of the window as a table.
#[derive(Clone, Copy)]
pub(super) struct Sheet<'s> {
    pub(super) session: &'s Session,
    pub(super) lights: &'s MixedLights,
}

impl CellValue {
    /// The value as a cell shows it, and as it is copied.
    pub(super) fn text(&self, session: &Session) -> String {
        match self {
            Self::Switch(is_on) => if *is_on { tr!("on") } else { tr!("off") }.to_owned(),
            Self::Text(text) => text.clone(),
            Self::Numbers(numbers, form) => form.text(numbers),
            Self::Color(color) => color::code(*color, session.look().color_space),
        }
    }

    fn order(&self, other: &Self) -> Ordering {
        match (self, other) {
            (Self::Numbers(a, _), Self::Numbers(b, _)) => {
                a.partial_cmp(b).unwrap_or(Ordering::Equal)
            }
            (Self::Color(a), Self::Color(b)) => a.partial_cmp(b).unwrap_or(Ordering::Equal),
            (Self::Switch(a), Self::Switch(b)) => a.cmp(b),
            (Self::Text(a), Self::Text(b)) => a.to_lowercase().cmp(&b.to_lowercase()),
            _ => Ordering::Equal,
        }
    }
}

impl<'s> Sheet<'s> {
    /// The open scene.
    pub(super) fn scene(self) -> Option<&'s Scene> {
        self.session.open_scene().map(|open_scene| open_scene.scene())
    }

    /// The mix of the open scene.
    pub(super) fn mix(self) -> Option<SceneMix<'s>> {
        SceneMix::of(self.session, self.lights)
    }

    /// Rows of the lights of a set, groups first; sorted by a column, or in the documents' order.
    pub(super) fn rows(self, filter: Option<&LightSet>, sort: Option<(Column, bool)>) -> Vec<Row> {
        let kept = filter.map(|filter| self.lights.members(filter));
        let is_kept = |id: &LightId| kept.as_ref().is_none_or(|kept| kept.contains(id));
        let groups = self.lights.groups(self.scene()).into_iter().map(Row::Group);
        let has_kept =
            |row: &Row| kept.is_none() || self.lights.of_term(&row.term()).iter().any(&is_kept);
        let mut rows: Vec<Row> = groups.filter(has_kept).collect();
        let lights = self.lights.lights().keys().filter(|id| is_kept(id));
        rows.extend(lights.cloned().map(Row::Light));
        if let Some((column, is_descending)) = sort {
            let key = |row: &Row| (matches!(row, Row::Light(_)), self.cell(row, column).value);
            rows.sort_by_cached_key(|row| SortKey(key(row), is_descending));
        }
        rows
    }

    /// Name of a row for people.
    pub(super) fn name(self, row: &Row) -> String {
        match row {
            Row::Light(id) => self.lights.name(id).to_owned(),
            Row::Group(group) => {
                let master = self.scene().and_then(|scene| scene.light_groups.get(group));
                let name = master.map(|master| master.name.as_str()).unwrap_or_default();
                if name.is_empty() { group.to_string() } else { name.to_owned() }
            }
        }
    }

    /// Name of a row that tells groups from lights.
    pub(super) fn full_name(self, row: &Row) -> String {
        match row {
            Row::Light(_) => self.name(row),
            Row::Group(_) => tr!("group {name}", name = self.name(row)),
        }
    }

    /// The light of a row: the scene's where it has one, else the open look's, else that of the
    /// first other look.
    pub(super) fn light(self, id: &'s LightId) -> Option<OwnedLight<'s>> {
        OwnedLight::lighting(self.session, id).or_else(|| {
            let light = &self.lights.shared().get(id)?.light;
            Some(OwnedLight { owner: Owner::Look, id, light })
        })
    }

    /// Target of a field of a light as keys name it, with the keys that move the field, or that
    /// would: those of the document that the light belongs to. `None` for a light of a look that is
    /// not open.
    pub(super) fn target(self, id: &LightId, field: LightField) -> Option<(OwnedKeys<'s>, Target)> {
        let target = Target::Light { light: id.clone(), field: field.name().to_owned() };
        let of = |owner: Owner| {
            let is_there = owner.lights(self.session).is_some_and(|all| all.contains_key(id));
            is_there.then_some(owner)
        };
        let own = || of(Owner::Scene).or_else(|| of(Owner::Look));
        let owner = Owner::of_keys(self.session, &target).or_else(own)?;
        Some((OwnedKeys::of(self.session, owner)?, target))
    }

    /// Target of a field that keys move, with those keys.
    pub(super) fn keyed(self, id: &LightId, field: LightField) -> Option<(OwnedKeys<'s>, Target)> {
        self.target(id, field)
            .filter(|(owned, target)| owned.keys.keyed_by(target) != KeyedBy::Nothing)
    }

    /// A cell of the table.
    pub(super) fn cell(self, row: &Row, column: Column) -> Cell {
        match row {
            Row::Light(id) => self.light_cell(id, column),
            Row::Group(group) => self.group_cell(group, column),
        }
    }

    /// A cell in words, for who cannot see how it looks.
    pub(super) fn words(self, cell: &Cell) -> String {
        let Some(value) = &cell.value else { return tr!("cell" => "none").to_owned() };
        let value = value.text(self.session);
        let told = match cell.origin {
            Origin::Own => value,
            Origin::Inherited => tr!("{value}, inherited"),
            Origin::Keyed => tr!("{value}, keyed"),
        };
        match cell.overridden.as_ref().map(|overridden| &overridden.effect) {
            None => told,
            Some(Effect::Out) => tr!("{told}, out"),
            Some(Effect::Left(left)) => {
                tr!("{told}, {left} by the mix", left = left.text(self.session))
            }
            Some(Effect::Objects(count)) => {
                let count = *count;
                trn!(count, "{told}, set by {count} object", "{told}, set by {count} objects")
            }
        }
    }

    fn light_cell(self, id: &LightId, column: Column) -> Cell {
        let none = Cell { value: None, origin: Origin::Own, overridden: None };
        let Some((id, _)) = self.lights.lights().get_key_value(id) else { return none };
        let Some(owned) = self.light(id) else { return none };
        let light = owned.light;
        let is_inherited = self.scene().is_some() && owned.owner == Owner::Look;
        let mut origin = if is_inherited { Origin::Inherited } else { Origin::Own };
        let mut overridden = None;
        let value = match column {
            Column::Shines | Column::Solo => {
                overridden = self.why_dark(id).filter(|_| column == Column::Shines);
                origin = Origin::Own;
                CellValue::Switch(self.is_switched(&SetTerm::Id(id.to_string()), column))
            }
            Column::Name => {
                overridden = self.why_dark(id);
                CellValue::Text(light.display_name(id).to_owned())
            }
            Column::Id => CellValue::Text(id.to_string()),
            Column::Kind => CellValue::Text(kind_name(light.kind).to_owned()),
            Column::Groups => CellValue::Text(groups_text(&light.groups)),
            Column::Space => CellValue::Text(space_name(light.space).to_owned()),
            Column::Exposure => return none,
            Column::Field(field) if !field.is_of(light.kind) => return none,
            Column::Field(field) => {
                let mut shown = std::borrow::Cow::Borrowed(light);
                if let Some((owned, target)) = self.keyed(id, field) {
                    origin = Origin::Keyed;
                    if let Some(value) = owned.keys.value_at(&target) {
                        crate::frame::set_light_field(shown.to_mut(), field.name(), &value);
                    }
                }
                let numbers = field.numbers(&shown).to_vec();
                overridden = self.overriding(id, field, &numbers).or_else(|| self.own(id, field));
                field_value(field, numbers)
            }
        };
        Cell { value: Some(value), origin, overridden }
    }

    fn group_cell(self, group: &LightGroup, column: Column) -> Cell {
        let none = Cell { value: None, origin: Origin::Own, overridden: None };
        let term = SetTerm::Group(group.to_string());
        let master = self.scene().map(|scene| scene.light_groups.get(group));
        let has_master = master.flatten().is_some();
        let master = master.map(|master| master.cloned().unwrap_or_default());
        let origin = if has_master { Origin::Own } else { Origin::Inherited };
        let value = match (column, master) {
            (Column::Shines | Column::Solo, _) => {
                let value = CellValue::Switch(self.is_switched(&term, column));
                return Cell { value: Some(value), ..none };
            }
            (Column::Name, _) => CellValue::Text(self.name(&Row::Group(group.clone()))),
            (Column::Id, _) => CellValue::Text(group.to_string()),
            (_, Some(master)) => match master_value(&master, column) {
                Some(value) => value,
                None => return none,
            },
            (_, None) => return none,
        };
        Cell { value: Some(value), origin, overridden: None }
    }

    /// State of the switch of a row's lights: whether they are not muted, or soloed.
    pub(super) fn is_switched(self, term: &SetTerm, column: Column) -> bool {
        let is_muting = column == Column::Shines;
        if let Some(scene) = self.scene() {
            let set = if is_muting { &scene.muted } else { &scene.soloed };
            return self.lights.has(set, term) != is_muting;
        }
        let solo = &self.session.view.solo;
        let set = if is_muting { &solo.muted } else { &solo.lights };
        let lights = self.lights.of_term(term);
        (!lights.is_empty() && lights.iter().all(|id| set.contains(id))) != is_muting
    }

    /// Override by what puts a light out.
    fn why_dark(self, id: &LightId) -> Option<Override> {
        let here = self.session.view.solo.is_dark(id).then(|| tr!("Out in this window").to_owned());
        let by = here.or_else(|| self.lights.told(id))?;
        Some(Override { by, effect: Effect::Out })
    }

    /// Override of a field by the mix.
    fn overriding(self, id: &LightId, field: LightField, numbers: &[f64]) -> Option<Override> {
        if !matches!(field, LightField::Intensity | LightField::Color) {
            return None;
        }
        if let Some(dark) = self.why_dark(id).filter(|_| field == LightField::Intensity) {
            return Some(dark);
        }
        let light = self.lights.lights().get(id)?;
        let scene = self.scene()?;
        let (factor, tint) = scene.master_factors(light)?;
        let left: Vec<f64> = match field {
            LightField::Intensity => numbers.iter().map(|number| number * factor).collect(),
            _ => numbers.iter().zip(tint).map(|(number, tint)| number * tint).collect(),
        };
        if left == numbers {
            return None;
        }
        let groups = light.groups.iter().filter(|group| scene.light_groups.contains_key(*group));
        let groups: Vec<&str> = groups.map(LightGroup::as_str).collect();
        let left = field_value(field, left);
        let by = trn!(
            count = groups.len(),
            "{text} in the scene: the master of group {groups} is on it",
            "{text} in the scene: the masters of groups {groups} are on it",
            text = left.text(self.session),
            groups = groups.join(", ")
        );
        Some(Override { by, effect: Effect::Left(left) })
    }

    /// Override of a field by objects that wear the open look: where it exposes the field, they may
    /// have values of their own.
    fn own(self, id: &LightId, field: LightField) -> Option<Override> {
        let target = Target::Light { light: id.clone(), field: field.name().to_owned() };
        let exposed =
            self.session.look().exposed.iter().find(|exposed| exposed.target == target)?;
        let open_scene = self.session.open_scene()?;
        let objects = open_scene.scene().objects.values();
        let own = objects
            .filter(|object| open_scene.wears_open(object))
            .filter(|object| object.values.contains_key(&exposed.name));
        let count = own.count();
        let name = if exposed.label.is_empty() { exposed.name.as_str() } else { &exposed.label };
        if count == 0 {
            return None;
        }
        let by = trn!(
            count,
            "{count} object has its own in its place: the parameter \"{name}\" in Objects",
            "{count} objects have their own in its place: the parameter \"{name}\" in Objects"
        );
        Some(Override { by, effect: Effect::Objects(count) })
    }

    /// Number of lights in a group, and of those that are out.
    pub(super) fn count(self, group: &LightGroup) -> (usize, usize) {
        let lights: BTreeSet<LightId> = self.lights.of_term(&SetTerm::Group(group.to_string()));
        let out = lights.iter().filter(|id| self.why_dark(id).is_some()).count();
        (lights.len(), out)
    }

    /// Color of a row's swatch, as seen.
    pub(super) fn swatch(self, row: &Row) -> Option<Color32> {
        let Row::Light(id) = row else { return None };
        Some(swatch(self.lights.lights().get(id)?, self.session.look().color_space))
    }

    /// Origin of a cell's value, in words.
    pub(super) fn origin_words(self, row: &Row, column: Column, cell: &Cell) -> String {
        let looks = |id: &LightId| self.lights.shared().get(id).map_or(0, |shared| shared.looks);
        match (row, cell.origin, column) {
            (_, _, Column::Id) => tr!("An id stays as it is: sets and looks name it").to_owned(),
            (_, _, Column::Shines | Column::Solo) => match self.scene() {
                Some(_) => tr!("Saved with the scene").to_owned(),
                None => tr!("Only in this window: nothing of it is saved").to_owned(),
            },
            (Row::Group(group), ..) => {
                let names = self.lights.names(&self.lights.of_term(&row.term()));
                match cell.origin {
                    Origin::Own => tr!("Set here, in the scene.\nLights of {group}: {names}"),
                    _ => tr!("The scene has no master of it yet: an edit makes one.\nLights of \
                              {group}: {names}"),
                }
            }
            (Row::Light(id), Origin::Keyed, Column::Field(field)) => self
                .target(id, field)
                .map_or_else(String::new, |(owned, target)| mark::help(owned.keys, &target)),
            (Row::Light(id), Origin::Inherited, _) => trn!(
                count = looks(id),
                "Inherited: a look has the light {id}. An edit puts a light of the scene in its \
                 place.",
                "Inherited: {count} looks have the light {id}. An edit puts a light of the scene \
                 in its place."
            ),
            (Row::Light(id), ..) if self.scene().is_some() => match looks(id) {
                0 => tr!("Set here, in the scene. No look has a light of this id.").to_owned(),
                _ => tr!("Set here, in the scene, in place of the look's light.").to_owned(),
            },
            (Row::Light(_), ..) => tr!("Set here, in the look.").to_owned(),
        }
    }
}

/// Value of a field's cell.
fn field_value(field: LightField, numbers: Vec<f64>) -> CellValue {
    match <[f64; 3]>::try_from(numbers.as_slice()) {
        Ok(color) if Column::Field(field).is_color() => CellValue::Color(color),
        _ => CellValue::Numbers(numbers, NumberForm::of(field)),
    }
}

/// Form of a master's exposure.
pub(super) fn exposure_form() -> NumberForm {
    NumberForm::plain([-MAX_EXPOSURE, MAX_EXPOSURE], " EV")
}

/// Part of a master that stands in a column.
pub(super) fn master_value(master: &GroupMaster, column: Column) -> Option<CellValue> {
    match column {
        Column::Field(LightField::Intensity) => {
            let form = NumberForm::of(LightField::Intensity);
            Some(CellValue::Numbers(vec![master.intensity], form))
        }
        Column::Field(LightField::Color) => Some(CellValue::Color(master.tint)),
        Column::Exposure => Some(CellValue::Numbers(vec![master.exposure], exposure_form())),
        Column::Field(field) if field.name() == "exposure" => {
            Some(CellValue::Numbers(vec![master.exposure], exposure_form()))
        }
        _ => None,
    }
}

/// Order of two rows by their cells; cells without a value come last either way.
#[derive(PartialEq)]
struct SortKey((bool, Option<CellValue>), bool);

impl Eq for SortKey {}

impl PartialOrd for SortKey {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for SortKey {
    fn cmp(&self, other: &Self) -> Ordering {
        let Self((is_light, value), is_descending) = self;
        let by_value = match (value, &other.0.1) {
            (Some(a), Some(b)) if *is_descending => b.order(a),
            (Some(a), Some(b)) => a.order(b),
            (a, b) => b.is_some().cmp(&a.is_some()),
        };
        is_light.cmp(&other.0.0).then(by_value)
    }
}
