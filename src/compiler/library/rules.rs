//! Reader of `@where` lines: forms that a function of the shader library comes to where facts about
//! its arguments hold.
//!
//! ```text
//! /// @where x is finite : x
//! /// @where v is unit : v
//! /// @where low < high : smoothstep(low, high, x)
//! /// @where |v| <= 1e15 and tier is balanced : normalize(v) ~ 1e-6
//! ```
//!
//! Facts are joined by `and`; all must hold for every number of the argument. The form is an
//! expression of the parameters that gives what the function gives, to the last digits, or in a
//! cheaper tier within the bound after `~`, relative above 1 and absolute below. The compiler puts
//! it in the place of a call wherever ranges prove the facts; tests run both side by side. The
//! first form whose facts hold is taken, so that the cheapest stands first. A rule may go on in
//! following lines that are indented by two spaces or more.

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::wgsl::{Declaration, DeclarationKind, LinkedSource};

/// Form that a function comes to where facts hold.
#[derive(Clone, Debug, PartialEq)]
pub struct FormRule {
    /// Facts about the arguments; all must hold.
    pub facts: Vec<Fact>,
    /// Name of the function that has the form as its body.
    pub function: String,
    /// Text of that function.
    pub text: String,
    /// Greatest difference that the form makes; `None` for none but rounding.
    pub bound: Option<f64>,
}

impl FormRule {
    /// True if the form stands for the function in the balanced tier and in cheaper ones alone.
    pub fn is_balanced(&self) -> bool {
        self.facts.contains(&Fact::Tier(Tier::Balanced))
    }
}

/// Fact about the arguments of a call, by the parameters' indices.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// The tier is this one, or a cheaper one.
    Tier(Tier),
    /// No number is NaN or infinite.
    Finite(usize),
    /// The vector's length is 1.
    Unit(usize),
    /// Numbers are no less than a limit.
    AtLeast(usize, FactLimit),
    /// Numbers are no more than a limit.
    AtMost(usize, FactLimit),
    /// Numbers are less than a limit.
    Below(usize, FactLimit),
    /// Numbers are no farther from 0 than this.
    Within(usize, f64),
    /// All numbers are this one.
    Is(usize, f64),
}

/// Limit of a fact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FactLimit {
    /// A number.
    Number(f64),
    /// Another parameter, by index.
    Parameter(usize),
}

/// Greatest difference that a form of the balanced tier may make.
const MAX_FORM_ERROR: f64 = 2e-3;

/// Tag of a rule's line.
const TAG: &str = "@where ";

/// Reads the rules of a function.
///
/// # Errors
/// A message for the first line that is no rule.
pub(super) fn read_rules(declaration: &Declaration) -> Result<Vec<FormRule>, String> {
    let mut rules: Vec<FormRule> = Vec::new();
    if declaration.kind != DeclarationKind::Function {
        return Ok(rules);
    }
    for line in rule_lines(&declaration.doc) {
        let function = format!("{}_where_{}", declaration.name, rules.len() + 1);
        let (facts, form, bound) = read_rule(&line, declaration)
            .map_err(|message| format!("`{}`: `{TAG}{line}`: {message}", declaration.name))?;
        let parameters: Vec<String> = declaration
            .fields
            .iter()
            .map(|field| format!("{}: {}", field.name, field.ty))
            .collect();
        let text = format!(
            "fn {function}({}) -> {} {{ return {form}; }}\n",
            parameters.join(", "),
            declaration.result.as_deref().unwrap_or_default()
        );
        let rule = FormRule { facts, function, text, bound };
        if rule.is_balanced() && bound.is_some_and(|bound| bound > MAX_FORM_ERROR) {
            return Err(tr!(
                "`{name}`: `{TAG}{line}`: a balanced form differs by at most {MAX_FORM_ERROR:e}; \
                 one that differs more is `tier is fast`",
                name = declaration.name
            ));
        }
        rules.push(rule);
    }
    Ok(rules)
}

/// Linked text with a function for the form of every rule in it, for naga.
///
/// # Errors
/// A diagnostic for every line that is no rule, with its file.
pub(super) fn with_forms(linked: &LinkedSource) -> Result<String, Vec<Diagnostic>> {
    let mut text = linked.text.clone();
    let mut problems = Vec::new();
    for file in &linked.files {
        for declaration in &file.scan.declarations {
            match read_rules(declaration) {
                Ok(rules) => rules.iter().for_each(|rule| text.push_str(&rule.text)),
                Err(message) => {
                    let problem = Diagnostic::error("bad-rule", message);
                    let place = linked.locate(file.span.start + declaration.span.start);
                    problems.push(match place {
                        Some((file, at)) => problem.in_file(file).at(at),
                        None => problem,
                    });
                }
            }
        }
    }
    if problems.is_empty() { Ok(text) } else { Err(problems) }
}

/// The rules of a doc comment, each on one line: lines that are indented by two spaces or more
/// go on with the one before.
fn rule_lines(doc: &[String]) -> Vec<String> {
    let mut rules: Vec<String> = Vec::new();
    let mut is_open = false;
    for line in doc {
        if let Some(rule) = line.strip_prefix(TAG) {
            rules.push(rule.to_owned());
            is_open = true;
        } else if let (Some(rule), true, true) = (rules.last_mut(), is_open, line.starts_with("  "))
        {
            rule.push(' ');
            rule.push_str(line.trim());
        } else {
            is_open = false;
        }
    }
    rules
}

type ReadRule<'t> = (Vec<Fact>, &'t str, Option<f64>);

fn read_rule<'t>(line: &'t str, declaration: &Declaration) -> Result<ReadRule<'t>, String> {
    let (facts, form) = line
        .split_once(" : ")
        .ok_or_else(|| tr!("` : ` and the form are missing after the facts"))?;
    let (form, bound) = match form.split_once(" ~ ") {
        Some((form, bound)) => {
            let bound = bound.trim().parse::<f64>();
            (form, Some(bound.map_err(|_| tr!("the bound after `~` is no number"))?))
        }
        None => (form, None),
    };
    let facts = facts
        .split(" and ")
        .map(|fact| read_fact(fact.trim(), declaration))
        .collect::<Result<Vec<_>, _>>()?;
    Ok((facts, form.trim(), bound))
}

fn read_fact(text: &str, declaration: &Declaration) -> Result<Fact, String> {
    let parameter = |name: &str| {
        let index = declaration.fields.iter().position(|field| field.name == name);
        index.ok_or_else(|| tr!("there is no parameter `{name}`"))
    };
    let limit = |text: &str| match text.parse::<f64>() {
        Ok(number) => Ok(FactLimit::Number(number)),
        Err(_) => parameter(text).map(FactLimit::Parameter),
    };
    let words: Vec<&str> = text.split_whitespace().collect();
    match words.as_slice() {
        ["tier", "is", "balanced"] => Ok(Fact::Tier(Tier::Balanced)),
        ["tier", "is", "fast"] => Ok(Fact::Tier(Tier::Fast)),
        [name, "is", "finite"] => Ok(Fact::Finite(parameter(name)?)),
        [name, "is", "unit"] => Ok(Fact::Unit(parameter(name)?)),
        [name, "=", number] => {
            let number = number.parse::<f64>().map_err(|_| tr!("`{number}` is no number"))?;
            Ok(Fact::Is(parameter(name)?, number))
        }
        [name, "<=", number] if name.starts_with('|') => {
            let name = name.trim_matches('|');
            let number = number.parse::<f64>().map_err(|_| tr!("`{number}` is no number"))?;
            Ok(Fact::Within(parameter(name)?, number))
        }
        [name, ">=", least] => Ok(Fact::AtLeast(parameter(name)?, limit(least)?)),
        [name, "<=", most] => Ok(Fact::AtMost(parameter(name)?, limit(most)?)),
        [name, "<", most] => Ok(Fact::Below(parameter(name)?, limit(most)?)),
        _ => Err(tr!(
            "`{text}` is no fact: `x is finite`, `v is unit`, `x = 1`, `x >= 0`, `x <= y`, \
             `x < y`, `|x| <= 1e6`, `tier is balanced`"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wgsl::{NamedSource, link, scan};

    #[test]
    fn a_rule_becomes_a_function() {
        let text = "/// x.\n/// @where x is finite and low < x : x\n///   + low ~ 0.5\n\
                    fn f(x: f32, low: f32) -> f32 { return x; }";
        let rules = read_rules(&scan(text).declarations[0]).expect("it is one");
        let facts = vec![Fact::Finite(0), Fact::Below(1, FactLimit::Parameter(0))];
        let text = "fn f_where_1(x: f32, low: f32) -> f32 { return x + low; }\n".to_owned();
        let function = "f_where_1".to_owned();
        assert_eq!(rules, [FormRule { facts, function, text, bound: Some(0.5) }]);
    }

    #[test]
    fn what_is_no_rule_is_told_with_its_line() {
        for (line, wanted) in [
            ("y is finite : x", "there is no parameter `y`"),
            ("x is nice : x", "`x is nice` is no fact"),
            ("x is finite", "the form are missing"),
            ("x is finite : x ~ much", "no number"),
            ("tier is balanced : x ~ 0.1", "at most 2e-3"),
        ] {
            let text = format!("\n/// x.\n/// @where {line}\nfn f(x: f32) -> f32 {{ return x; }}");
            let linked = link(&[NamedSource { name: "f.wgsl", text: &text }]).expect("no imports");
            let problem = with_forms(&linked).expect_err("it is none")[0].to_string();
            assert!(problem.starts_with("f.wgsl:2:1"), "{problem}");
            assert!(problem.contains(wanted), "{problem}");
        }
    }
}
