//! Declarations of HLSL as the exporter writes it, one by one.

/// A declaration: a struct, a function, a constant or a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct HlslDeclaration {
    /// Name of the declaration.
    pub(super) name: String,
    /// Text of the declaration with the comment before it, without empty lines around.
    pub(super) text: String,
}

/// The declarations of a text, in order.
pub(super) fn declarations(text: &str) -> Vec<HlslDeclaration> {
    let mut found = Vec::new();
    let (mut piece, mut depth) = (String::new(), 0_usize);
    for line in text.lines() {
        if line.is_empty() && depth == 0 {
            // A comment that stands alone belongs to what follows a line further, too.
            continue;
        }
        piece += line;
        piece.push('\n');
        let code = line.split("//").next().unwrap_or_default();
        depth += code.matches('{').count();
        depth = depth.saturating_sub(code.matches('}').count());
        if depth == 0 && code.trim_end().ends_with([';', '}']) {
            let text = std::mem::take(&mut piece).trim_end().to_owned();
            found.push(HlslDeclaration { name: name(&text), text });
        }
    }
    found
}

/// Name of what a declaration declares.
fn name(text: &str) -> String {
    let code = text.lines().find(|line| !line.starts_with("//")).unwrap_or_default();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if let Some(rest) = code.strip_prefix("struct ") {
        return rest.chars().take_while(|c| is_part(*c)).collect();
    }
    // `float3 f(float3 x)`, `static const float K = 1.0;`, `static View view;`
    let end = code.find(['(', '=', '[', ';']).unwrap_or(code.len());
    let head = code[..end].trim_end();
    head.rsplit(|c: char| !is_part(c)).next().unwrap_or_default().to_owned()
}

/// The declarations as a text: variables and constants a line each, all else apart.
pub(super) fn joined(declarations: &[HlslDeclaration]) -> String {
    let mut text = String::new();
    let mut was_line = true;
    for declaration in declarations {
        let is_line = declaration.text.ends_with(';') && !declaration.text.contains("\nstruct ");
        let is_line = is_line && !declaration.text.starts_with("struct ");
        if !(text.is_empty() || is_line && was_line) {
            text.push('\n');
        }
        text += &declaration.text;
        text.push('\n');
        was_line = is_line;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
/// Distance.
struct Look {
    float3 place;
};

static const float LONG = {1.0,
    2.0};
static Look look;

/// Far.
float far(Look look)
{
    if (look.place.x > 0.0) {
        return 1.0;
    }
    return 0.0;
}
";

    #[test]
    fn declarations_are_told_apart_and_joined_again() {
        let found = declarations(TEXT);
        let names: Vec<&str> = found.iter().map(|it| it.name.as_str()).collect();
        assert_eq!(names, ["Look", "LONG", "look", "far"]);
        assert_eq!(joined(&found), TEXT);
    }
}
