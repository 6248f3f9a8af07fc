//! Contexts (a fragment's surroundings) where a mesh is drawn: the WGSL expressions that their rows
//! give, and the inputs that these expressions read.

use crate::library::{Context, ContextSource, Stage, Type};

/// The expression of a context in a module of a stage; empty for what is known before the fragment.
pub(super) fn expression(context: Context, stage: Stage) -> String {
    match context.row().source {
        // An alpha cutoff may depend on a color that curvature tints; before the curvature pass
        // everything is flat.
        ContextSource::Pass { .. } | ContextSource::Fragment { is_derived: true, .. }
            if stage.draws_normals() =>
        {
            zero(&Type::from_wgsl(context.wgsl_type()))
        }
        ContextSource::Fragment { wgsl, .. } => wgsl.to_owned(),
        ContextSource::Pass { wgsl, .. } => {
            let map = context.pass().map(|pass| pass.row().map).unwrap_or_default();
            wgsl.replace("texel", &format!("textureLoad({map}, vec2i(in.clip.xy), 0)"))
        }
        ContextSource::Host { .. } | ContextSource::Light(_) | ContextSource::Scene { .. } => {
            String::new()
        }
    }
}

fn zero(ty: &Type) -> String {
    if *ty == Type::Float { "0.0".to_owned() } else { format!("{}(0.0)", ty.wgsl()) }
}

/// Inputs that an expression reads from the module around it.
#[derive(Debug, Default)]
pub(super) struct ExpressionInputs {
    /// The names of varyings, and `clip`.
    varyings: Vec<String>,
    /// True if the expression reads the unit `normal` toward the seen side, which is made of the
    /// varying of the same name.
    pub(super) normal: bool,
    /// True if the expression reads `view.screen`, the place of pixels in the picture.
    pub(super) screen: bool,
    /// Names of the functions that the expression calls, of the library and of WGSL itself.
    pub(super) functions: Vec<String>,
}

impl ExpressionInputs {
    /// Inputs of a context's expression where looks are drawn.
    pub(super) fn of(context: Context) -> Self {
        Self::at(context, Stage::default())
    }

    /// Inputs of a context's expression in a module of `stage`.
    pub(super) fn at(context: Context, stage: Stage) -> Self {
        Self::within(&expression(context, stage))
    }

    fn within(wgsl: &str) -> Self {
        let mut reads = Self::default();
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut rest = wgsl;
        // The word before, where a dot joins it to the next.
        let mut owner = "";
        while let Some(start) = rest.find(is_word) {
            if &rest[..start] != "." {
                owner = "";
            }
            let from = &rest[start..];
            let (word, after) = from.split_at(from.find(|c| !is_word(c)).unwrap_or(from.len()));
            match (owner, word) {
                ("", "normal") => reads.normal = true,
                ("", name) if after.starts_with('(') => reads.functions.push(name.to_owned()),
                ("in", name) => reads.varyings.push(name.to_owned()),
                ("view", "screen") => reads.screen = true,
                _ => {}
            }
            (owner, rest) = (word, after);
        }
        reads
    }

    /// True if the expression reads a varying, directly or through `normal`, which is made of one.
    pub(super) fn varying(&self, name: &str) -> bool {
        self.varyings.iter().any(|read| read == name) || (self.normal && name == "normal")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_an_expression_reads_is_known_by_its_words() {
        let reads =
            ExpressionInputs::within("cross(normal, in.tangent.xyz) * in.normal.w + view.screen.x");
        assert_eq!(reads.varyings, ["tangent", "normal"]);
        assert_eq!(reads.functions, ["cross"]);
        assert!(reads.normal && reads.screen && reads.varying("tangent"));
        let reads = ExpressionInputs::within("object.normal * f(in.uv)");
        assert!(!reads.normal && !reads.varying("normal") && reads.varying("uv"));
    }

    /// Names that an expression reads exist, and have the row's types: naga validates a module that
    /// reads it.
    #[test]
    fn varyings_of_rows_exist() {
        for context in Context::all() {
            for name in &ExpressionInputs::of(context).varyings {
                let mut known = super::super::attributes::VARYINGS.iter();
                let is_known = name == "clip" || known.any(|varying| varying.name == name);
                assert!(is_known, "{context:?} reads `in.{name}`");
            }
        }
    }
}
