//! Text of the languages whose one file has both entry points, as people read it.

use std::fmt::Display;

use super::language::LanguageEntryPoint;
use super::modules::ShaderModule;
use super::readable::{SourceComments, WrittenText};
use crate::wgsl::ValidModule;

/// Text of a module as naga writes it, and the names of its entry points there.
pub(super) type NagaText<E> = Result<(String, Vec<Result<String, E>>), String>;

/// A module's text made readable, and its entry points as the language names them. `valid` is the
/// module as it is to be written, and `write` writes a module in the language; `written` mends that
/// text where naga's form is not wanted, and names what the text alone does not tell.
///
/// # Errors
/// The errors of both, and those of entry points.
pub(super) fn readable_text<'m, E: Display>(
    module: &ShaderModule,
    valid: &'m ValidModule,
    write: impl Fn(&ValidModule) -> NagaText<E>,
    written: impl FnOnce(String) -> Result<WrittenText<'m>, String>,
) -> Result<(String, Vec<LanguageEntryPoint>), String> {
    let (text, names) = write(valid)?;
    let point = |(point, name): (&super::reflect::EntryPoint, Result<String, E>)| {
        let name = name.map_err(|error| error.to_string())?;
        Ok(LanguageEntryPoint { stage: point.stage, name })
    };
    let points = module.entry_points.iter().zip(names).map(point);
    let points = points.collect::<Result<_, String>>()?;
    let written = written(text)?;
    let source = SourceComments::of(module.wgsl());
    let text = written.readable(&source, |valid| write(valid).map(|(text, _)| text))?;
    Ok((text, points))
}
