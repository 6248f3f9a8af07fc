//! Changes of many cells as edits: one of the scene, or of the look, and so one undo step.

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::column::{Column, inside};
use super::sheet::{CellValue, Row, Sheet, exposure_form};
use super::typed::{NumberForm, read_color, read_switch, read_word};
use crate::commands::{Command, SceneCommand};
use crate::document::{
    Edit, GroupMaster, Light, LightField, LightKind, LightSet, LightSpace, SceneEdit, Target, Value,
};
use crate::fields::lighting::{Change, Owner};
use crate::fields::mix::SceneMix;
use crate::ids::{LightGroup, LightId};
use crate::panels::lights::{keep_within, kind_name, read_groups, space_name};
use crate::state::solo::Solo;
use eframe::egui::Id;

/// New content of a cell.
#[derive(Clone, Debug)]
pub(super) enum Entry {
    /// A text that was typed or pasted.
    Text(String),
    /// A color that was picked, in the look's color space.
    Color([f64; 3]),
    /// A switch that was turned.
    Switch(bool),
    /// The value of the look's light, or the default.
    Reset,
}

/// Changes that are collected before they are applied.
pub(super) struct CellChanges<'s> {
    sheet: Sheet<'s>,
    lights: IndexMap<LightId, Light>,
    masters: IndexMap<LightGroup, GroupMaster>,
    /// Values that keys have, with the document of the keys.
    keyed: Vec<(Owner, Target, Value)>,
    muted: Option<LightSet>,
    soloed: Option<LightSet>,
    solo: Option<Solo>,
    /// Number of cells that took their entry.
    done: usize,
    /// Reasons of the cells that did not.
    refused: Vec<String>,
}

impl<'s> CellChanges<'s> {
    pub(super) fn new(sheet: Sheet<'s>) -> Self {
        Self {
            sheet,
            lights: IndexMap::new(),
            masters: IndexMap::new(),
            keyed: Vec::new(),
            muted: None,
            soloed: None,
            solo: None,
            done: 0,
            refused: Vec::new(),
        }
    }

    /// Sets a cell.
    pub(super) fn set(&mut self, row: &Row, column: Column, entry: &Entry) {
        let done = match (row, column) {
            (_, Column::Id) => Err(tr!("an id stays as it is").to_owned()),
            (_, Column::Shines | Column::Solo) => self.switch(row, column, entry),
            (Row::Light(id), _) => self.set_light(id, column, entry),
            (Row::Group(group), _) => self.set_master(group, column, entry),
        };
        match done {
            Ok(()) => self.done += 1,
            Err(why) => self.refused.push(why),
        }
    }

    fn switch(&mut self, row: &Row, column: Column, entry: &Entry) -> Result<(), String> {
        let is_on = match entry {
            Entry::Switch(is_on) => *is_on,
            Entry::Reset => column == Column::Shines,
            Entry::Text(text) => {
                read_switch(text).ok_or_else(|| tr!("\"{text}\" is neither on nor off"))?
            }
            Entry::Color(_) => return Err(tr!("a switch has no color").to_owned()),
        };
        let is_in = is_on == (column == Column::Solo);
        let term = row.term();
        if let Some(scene) = self.sheet.scene() {
            let (set, own) = match column {
                Column::Shines => (&mut self.muted, &scene.muted),
                _ => (&mut self.soloed, &scene.soloed),
            };
            let now = set.take().unwrap_or_else(|| own.clone());
            *set = Some(self.sheet.lights.switched(&now, &term, is_in));
            return Ok(());
        }
        let solo = self.solo.get_or_insert_with(|| self.sheet.session.view.solo.clone());
        for id in self.sheet.lights.of_term(&term) {
            let set = if column == Column::Shines { &mut solo.muted } else { &mut solo.lights };
            if is_in {
                set.insert(id);
            } else {
                set.shift_remove(&id);
            }
        }
        Ok(())
    }

    fn set_light(&mut self, id: &LightId, column: Column, entry: &Entry) -> Result<(), String> {
        let sheet = self.sheet;
        let cell = sheet.cell(&Row::Light(id.clone()), column);
        let Some((id, _)) = sheet.lights.lights().get_key_value(id) else {
            return Err(tr!("there is no light {id}"));
        };
        let owned = sheet.light(id).ok_or_else(|| tr!("there is no light {id}"))?;
        let Some(value) = cell.value else {
            let kind = inside(kind_name(owned.light.kind));
            return Err(tr!("{kind} lights have no {what}", what = inside(column.label())));
        };
        let is_reset = matches!(entry, Entry::Reset);
        let light = self.lights.entry(id.clone()).or_insert_with(|| owned.light.clone());
        if is_reset {
            let of_look = sheet.lights.shared().get(id).map(|shared| shared.light.clone());
            let source = of_look.filter(|_| owned.owner == Owner::Scene).unwrap_or_default();
            return reset(light, &source, column);
        }
        let Column::Field(field) = column else {
            let Entry::Text(text) = entry else { return Err(takes_text(column)) };
            return set_word(light, id, column, text);
        };
        let numbers = new_numbers(sheet, column, &value, entry)?;
        match sheet.keyed(id, field) {
            Some((owned, target)) => {
                let mut set = light.clone();
                set_field(&mut set, field, &numbers);
                self.keyed.push((owned.owner, target, field.get(&set)));
            }
            None => set_field(light, field, &numbers),
        }
        Ok(())
    }

    fn set_master(
        &mut self,
        group: &LightGroup,
        column: Column,
        entry: &Entry,
    ) -> Result<(), String> {
        let mix = self.sheet.mix().ok_or(tr!("groups have masters in scenes alone"))?;
        let value = self.sheet.cell(&Row::Group(group.clone()), column).value;
        let master = self.masters.entry(group.clone()).or_insert_with(|| mix.master(group));
        if matches!(entry, Entry::Reset) {
            let normal = GroupMaster::default();
            match column {
                Column::Name => master.name = normal.name,
                Column::Field(LightField::Color) => master.tint = normal.tint,
                Column::Field(LightField::Intensity) => master.intensity = normal.intensity,
                _ => master.exposure = normal.exposure,
            }
            return Ok(());
        }
        if column == Column::Name {
            let Entry::Text(text) = entry else { return Err(takes_text(column)) };
            let name = text.trim();
            master.name = if name == group.as_str() { String::new() } else { name.to_owned() };
            return Ok(());
        }
        let what = inside(column.label());
        let value = value.ok_or_else(|| tr!("a group has no {what}"))?;
        let numbers = new_numbers(self.sheet, column, &value, entry)?;
        match (column, numbers.as_slice()) {
            (Column::Field(LightField::Color), &[r, g, b]) => master.tint = [r, g, b],
            (Column::Field(LightField::Intensity), &[number]) => master.intensity = number,
            (_, &[number]) => master.exposure = number,
            _ => return Err(tr!("a group has no {what}")),
        }
        Ok(())
    }

    /// Commands that apply the changes; as part of the step that goes on for as long as `held` is
    /// held. Cells that took nothing are told.
    pub(super) fn commands(self, held: Option<Id>) -> Vec<Command> {
        let told = self.told();
        let mut out = Vec::new();
        if let Some(edit) = self.look_edit() {
            out.push(held.map_or_else(
                || Command::Edit(edit.clone()),
                |held| Command::EditHeld(held, edit.clone()),
            ));
        }
        if let Some(edit) = self.scene_edit() {
            out.push(Command::Scene(match held {
                Some(held) => SceneCommand::EditHeld(held, edit),
                None => SceneCommand::Edit(edit),
            }));
        }
        out.extend(self.solo.map(Command::Solo));
        out.extend(told.map(Command::Tell));
        out
    }

    fn told(&self) -> Option<String> {
        let why = self.refused.first()?;
        let mut reasons: Vec<&String> = self.refused.iter().collect();
        reasons.dedup();
        let has_others = reasons.len() > 1;
        let count = self.done + self.refused.len();
        Some(match (self.done, has_others) {
            (0, _) if count == 1 => why.clone(),
            (0, false) => tr!("None of {count} cells is changed: {why}"),
            (0, true) => tr!("None of {count} cells is changed: {why}, among others"),
            (done, false) => tr!("{done} of {count} cells are changed: {why}"),
            (done, true) => tr!("{done} of {count} cells are changed: {why}, among others"),
        })
    }

    fn look_edit(&self) -> Option<Edit> {
        let mut edits = Vec::new();
        if self.sheet.scene().is_none() {
            for (id, light) in &self.lights {
                if self.sheet.session.look().lights.get(id) != Some(light) {
                    edits.push(Edit::SetLight { id: id.clone(), light: light.clone() });
                }
            }
        }
        edits.extend(self.keyed_edit(Owner::Look));
        match edits.len() {
            0 => None,
            1 => edits.pop(),
            _ => Some(Edit::Group { edits }),
        }
    }

    /// Edit of the keyed values of a document, as of a look of its lights.
    fn keyed_edit(&self, owner: Owner) -> Option<Edit> {
        let of_owner = self.keyed.iter().filter(|(of, ..)| *of == owner);
        let mut values = of_owner.map(|(_, target, value)| (target.clone(), value.clone()));
        let first = values.next()?;
        Some(owner.keys(self.sheet.session)?.set_all_at(std::iter::once(first).chain(values)))
    }

    fn scene_edit(&self) -> Option<SceneEdit> {
        let scene = self.sheet.scene()?;
        let mut edits = Vec::new();
        for (id, light) in &self.lights {
            let (id, light) = (id.clone(), light.clone());
            match scene.lights.get(&id) {
                Some(old) if *old != light => edits.push(SceneEdit::SetLight { id, light }),
                Some(_) => {}
                // The look's own stays in place where nothing of it but keys is changed.
                None if self.sheet.lights.lights().get(&id) != Some(&light) => {
                    edits.push(SceneEdit::AddLight { id, light, index: None });
                }
                None => {}
            }
        }
        let keyed = self.keyed_edit(Owner::Scene);
        let keyed = keyed.and_then(|edit| Owner::Scene.change(self.sheet.session, edit));
        if let Some(Change::Scene(edit)) = keyed {
            edits.push(edit);
        }
        for (group, master) in &self.masters {
            edits.push(SceneMix::mastering(group, master.clone()));
        }
        if let Some(muted) = self.muted.clone().filter(|muted| *muted != scene.muted) {
            edits.push(SceneEdit::SetMutedLights { muted });
        }
        if let Some(soloed) = self.soloed.clone().filter(|soloed| *soloed != scene.soloed) {
            edits.push(SceneEdit::SetSoloedLights { soloed });
        }
        match edits.len() {
            0 => None,
            1 => edits.pop(),
            _ => Some(SceneEdit::Group { edits }),
        }
    }
}

fn takes_text(column: Column) -> String {
    tr!("{what} takes a text", what = inside(column.label()))
}

/// Numbers that a cell has after an entry.
fn new_numbers(
    sheet: Sheet<'_>,
    column: Column,
    now: &CellValue,
    entry: &Entry,
) -> Result<Vec<f64>, String> {
    let space = sheet.session.look().color_space;
    match (now, entry) {
        (CellValue::Color(now), Entry::Text(text)) => {
            read_color(text, *now, space).map(|color| color.to_vec())
        }
        (CellValue::Color(_), Entry::Color(color)) => Ok(color.to_vec()),
        (CellValue::Numbers(now, form), Entry::Text(text)) => form.read(text, now),
        _ => Err(tr!("{what} takes no such value", what = inside(column.label()))),
    }
}

/// Sets a field, and keeps those within it.
fn set_field(light: &mut Light, field: LightField, numbers: &[f64]) {
    field.set(light, numbers);
    if field.range().is_some() {
        keep_within(field, light);
        if let Some(around) = field.within() {
            let most = around.numbers(light).first().copied().unwrap_or(f64::MAX);
            field.numbers_mut(light).iter_mut().for_each(|number| *number = number.min(most));
        }
    }
}

/// Sets what is no field of numbers.
fn set_word(light: &mut Light, id: &LightId, column: Column, text: &str) -> Result<(), String> {
    match column {
        Column::Name => {
            let name = text.trim();
            light.name = if name == id.as_str() { String::new() } else { name.to_owned() };
        }
        Column::Kind => {
            light.kind = read_word(
                text,
                LightKind::ALL.iter().map(|kind| (*kind, [kind_name(*kind), kind.word()])),
            )?;
        }
        Column::Space => {
            let all = LightSpace::ALL.iter().map(|space| (*space, [space_name(*space); 2]));
            light.space = read_word(text, all)?;
        }
        Column::Groups => {
            let text = text.trim();
            if let Some(more) = text.strip_prefix('+') {
                for group in read_groups(more)? {
                    if !light.groups.contains(&group) {
                        light.groups.push(group);
                    }
                }
            } else if let Some(less) = text.strip_prefix('-') {
                let less = read_groups(less)?;
                light.groups.retain(|group| !less.contains(group));
            } else {
                light.groups = read_groups(text)?;
            }
        }
        _ => return Err(tr!("lights have no {what}", what = inside(column.label()))),
    }
    Ok(())
}

fn reset(light: &mut Light, source: &Light, column: Column) -> Result<(), String> {
    match column {
        Column::Name => light.name.clone_from(&source.name),
        Column::Kind => light.kind = source.kind,
        Column::Space => light.space = source.space,
        Column::Groups => light.groups.clone_from(&source.groups),
        Column::Field(field) => set_field(light, field, field.numbers(source)),
        _ => return Err(tr!("{what} has no default", what = inside(column.label()))),
    }
    Ok(())
}

/// Form of a column's numbers, for hints.
pub(super) fn form_of(column: Column) -> Option<NumberForm> {
    match column {
        Column::Exposure => Some(exposure_form()),
        Column::Field(field) => Some(NumberForm::of(field)),
        _ => None,
    }
}
