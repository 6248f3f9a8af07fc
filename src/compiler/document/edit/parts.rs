//! Edits of lights, groups, exposed parameters and keys.

use std::fmt::Display;
use std::hash::Hash;

use chiaro_locale::tr;
use indexmap::IndexMap;

use super::graph::drop_targets;
use super::{Edit, EditResult, group, impossible, missing};
use crate::diag::Diagnostic;
use crate::document::{Look, Target};
use crate::ids::{DefinitionId, LightId};

pub(super) fn apply(look: &mut Look, edit: Edit) -> EditResult<Edit> {
    match edit {
        Edit::AddLight { id, light, index } => {
            insert(&mut look.lights, tr!("part" => "light"), id.clone(), light, index)?;
            Ok(Edit::RemoveLight { id })
        }
        Edit::SetLight { id, light } => {
            let old =
                look.lights.get_mut(&id).ok_or_else(|| missing(tr!("part" => "light"), &id))?;
            let light = std::mem::replace(old, light);
            Ok(Edit::SetLight { id, light })
        }
        Edit::RemoveLight { id } => remove_light(look, id),
        Edit::AddDefinition { id, definition, index } => {
            insert(&mut look.definitions, tr!("part" => "group"), id.clone(), definition, index)?;
            Ok(Edit::RemoveDefinition { id })
        }
        Edit::SetInterface { id, label, help, inputs, outputs } => {
            let of = look
                .definitions
                .get_mut(&id)
                .ok_or_else(|| missing(tr!("part" => "group"), &id))?;
            let label = std::mem::replace(&mut of.label, label);
            let help = std::mem::replace(&mut of.help, help);
            let inputs = std::mem::replace(&mut of.inputs, inputs);
            let outputs = std::mem::replace(&mut of.outputs, outputs);
            Ok(Edit::SetInterface { id, label, help, inputs, outputs })
        }
        Edit::RemoveDefinition { id } => remove_definition(look, id),
        Edit::AddExposed { exposed, index } => {
            let index = insert_at(&mut look.exposed, exposed, index)?;
            Ok(Edit::RemoveExposed { index })
        }
        Edit::SetExposed { index, exposed } => {
            let exposed = std::mem::replace(at(&mut look.exposed, index)?, exposed);
            Ok(Edit::SetExposed { index, exposed })
        }
        Edit::RemoveExposed { index } => {
            at(&mut look.exposed, index)?;
            Ok(Edit::AddExposed { exposed: look.exposed.remove(index), index: Some(index) })
        }
        Edit::SetAovs { aovs } => {
            Ok(Edit::SetAovs { aovs: std::mem::replace(&mut look.aovs, aovs) })
        }
        keys => apply_keys(look, keys),
    }
}

fn apply_keys(look: &mut Look, edit: Edit) -> EditResult<Edit> {
    match edit {
        Edit::AddDirectionKeys { keys, index } => {
            let index = insert_at(&mut look.direction_keys, keys, index)?;
            Ok(Edit::RemoveDirectionKeys { index })
        }
        Edit::SetDirectionKeys { index, keys } => {
            let keys = std::mem::replace(at(&mut look.direction_keys, index)?, keys);
            Ok(Edit::SetDirectionKeys { index, keys })
        }
        Edit::RemoveDirectionKeys { index } => {
            at(&mut look.direction_keys, index)?;
            Ok(Edit::AddDirectionKeys {
                keys: look.direction_keys.remove(index),
                index: Some(index),
            })
        }
        Edit::AddTimeKeys { keys, index } => {
            let index = insert_at(&mut look.time_keys, keys, index)?;
            Ok(Edit::RemoveTimeKeys { index })
        }
        Edit::SetTimeKeys { index, keys } => {
            let keys = std::mem::replace(at(&mut look.time_keys, index)?, keys);
            Ok(Edit::SetTimeKeys { index, keys })
        }
        Edit::SetMarkers { markers } => {
            Ok(Edit::SetMarkers { markers: std::mem::replace(&mut look.markers, markers) })
        }
        Edit::RemoveTimeKeys { index } => {
            at(&mut look.time_keys, index)?;
            Ok(Edit::AddTimeKeys { keys: look.time_keys.remove(index), index: Some(index) })
        }
        other => {
            Err(impossible(tr!("nothing applies the edit \"{other}\"", other = other.label())))
        }
    }
}

fn remove_light(look: &mut Look, id: LightId) -> EditResult<Edit> {
    if !look.lights.contains_key(&id) {
        return Err(missing(tr!("part" => "light"), id));
    }
    let mut edits = drop_targets(
        look,
        |_, target| matches!(target, Target::Light { light, .. } if *light == id),
    );
    for (index, _) in look
        .direction_keys
        .iter()
        .enumerate()
        .rev()
        .filter(|(_, keys)| keys.by.lights().contains(&&id))
    {
        edits.push(Edit::RemoveDirectionKeys { index });
    }
    if edits.is_empty() {
        let (index, light) = remove_named(&mut look.lights, tr!("part" => "light"), &id)?;
        return Ok(Edit::AddLight { id, light, index: Some(index) });
    }
    edits.push(Edit::RemoveLight { id });
    group(look, edits, true)
}

fn remove_definition(look: &mut Look, id: DefinitionId) -> EditResult<Edit> {
    let (index, definition) = remove_named(&mut look.definitions, tr!("part" => "group"), &id)?;
    Ok(Edit::AddDefinition { id, definition, index: Some(index) })
}

/// Adds a new entry at an index, or last.
pub(super) fn insert<K: Hash + Eq + Display, V>(
    map: &mut IndexMap<K, V>,
    what: &str,
    id: K,
    value: V,
    index: Option<usize>,
) -> Result<(), Box<Diagnostic>> {
    if map.contains_key(&id) {
        return Err(impossible(tr!("there is a {what} `{id}` already")));
    }
    let index = index.unwrap_or(map.len());
    if index > map.len() {
        return Err(impossible(tr!("there is no place {index} among {count}", count = map.len())));
    }
    map.shift_insert(index, id, value);
    Ok(())
}

/// Removes an entry; the others keep their order.
pub(super) fn remove_named<K: Hash + Eq + Display, V>(
    map: &mut IndexMap<K, V>,
    what: &str,
    id: &K,
) -> Result<(usize, V), Box<Diagnostic>> {
    let index = map.get_index_of(id).ok_or_else(|| missing(what, id))?;
    let (_, value) = map.shift_remove_index(index).ok_or_else(|| missing(what, id))?;
    Ok((index, value))
}

pub(super) fn insert_at<T>(
    list: &mut Vec<T>,
    item: T,
    index: Option<usize>,
) -> Result<usize, Box<Diagnostic>> {
    let index = index.unwrap_or(list.len());
    if index > list.len() {
        return Err(impossible(tr!("there is no place {index} among {count}", count = list.len())));
    }
    list.insert(index, item);
    Ok(index)
}

pub(super) fn at<T>(list: &mut [T], index: usize) -> Result<&mut T, Box<Diagnostic>> {
    let count = list.len();
    list.get_mut(index).ok_or_else(|| impossible(tr!("there is no number {index} among {count}")))
}
