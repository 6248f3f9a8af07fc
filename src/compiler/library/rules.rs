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

use std::fmt::Write as _;

use crate::diag::Diagnostic;
use crate::document::Tier;
use crate::wgsl::{Declaration, DeclarationKind, LinkedSource, Scan};

/// Form that a function comes to where facts hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Facts about the arguments; all must hold.
    pub facts: Vec<Fact>,
    /// Name of the function that has the form as its body.
    pub function: String,
    /// Greatest difference that the form makes; `None` for none but rounding.
    pub bound: Option<f64>,
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
    AtLeast(usize, RuleLimit),
    /// Numbers are no more than a limit.
    AtMost(usize, RuleLimit),
    /// Numbers are less than a limit.
    Below(usize, RuleLimit),
    /// Numbers are no farther from 0 than this.
    Within(usize, f64),
    /// All numbers are this one.
    Is(usize, f64),
}

/// Limit of a fact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RuleLimit {
    /// A number.
    Number(f64),
    /// Another parameter, by index.
    Parameter(usize),
}

/// Tag of a rule's line.
const TAG: &str = "@where ";

/// Reads the rules of all functions of a linked source, and appends a function for each form to
/// its text.
///
/// # Errors
/// A diagnostic for every line that is no rule, with its file.
pub(super) fn read_rules(
    linked: &mut LinkedSource,
    scan: &Scan,
) -> Result<Vec<(String, Vec<Rule>)>, Vec<Diagnostic>> {
    let mut rules = Vec::new();
    let mut problems = Vec::new();
    let mut text = String::new();
    let functions = scan.declarations.iter().filter(|d| d.kind == DeclarationKind::Function);
    for declaration in functions {
        let mut own: Vec<Rule> = Vec::new();
        for line in rule_lines(&declaration.doc) {
            let line = line.as_str();
            let function = format!("{}_where_{}", declaration.name, own.len() + 1);
            match read_rule(line, declaration) {
                Ok((facts, form, bound)) => {
                    let parameters: Vec<String> = declaration
                        .fields
                        .iter()
                        .map(|field| format!("{}: {}", field.name, field.ty))
                        .collect();
                    let _ = writeln!(
                        text,
                        "fn {function}({}) -> {} {{ return {form}; }}",
                        parameters.join(", "),
                        declaration.result.as_deref().unwrap_or_default()
                    );
                    own.push(Rule { facts, function, bound });
                }
                Err(message) => {
                    let problem = Diagnostic::error(
                        "bad-rule",
                        format!("`{}`: `{TAG}{line}`: {message}", declaration.name),
                    );
                    let place = linked.locate(declaration.span.start);
                    problems.push(match place {
                        Some((file, at)) => problem.in_file(file).at(at),
                        None => problem,
                    });
                }
            }
        }
        if !own.is_empty() {
            rules.push((declaration.name.clone(), own));
        }
    }
    linked.text.push_str(&text);
    if problems.is_empty() { Ok(rules) } else { Err(problems) }
}

/// The rules of a doc comment, each on one line: lines that are indented by two spaces or more go on
/// with the one before.
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
    let (facts, form) =
        line.split_once(" : ").ok_or("` : ` and the form are missing after the facts")?;
    let (form, bound) = match form.split_once(" ~ ") {
        Some((form, bound)) => {
            let bound = bound.trim().parse::<f64>();
            (form, Some(bound.map_err(|_| "the bound after `~` is no number")?))
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
        index.ok_or_else(|| format!("there is no parameter `{name}`"))
    };
    let limit = |text: &str| match text.parse::<f64>() {
        Ok(number) => Ok(RuleLimit::Number(number)),
        Err(_) => parameter(text).map(RuleLimit::Parameter),
    };
    let words: Vec<&str> = text.split_whitespace().collect();
    match words.as_slice() {
        ["tier", "is", "balanced"] => Ok(Fact::Tier(Tier::Balanced)),
        ["tier", "is", "fast"] => Ok(Fact::Tier(Tier::Fast)),
        [name, "is", "finite"] => Ok(Fact::Finite(parameter(name)?)),
        [name, "is", "unit"] => Ok(Fact::Unit(parameter(name)?)),
        [name, "=", number] => {
            let number = number.parse::<f64>().map_err(|_| format!("`{number}` is no number"))?;
            Ok(Fact::Is(parameter(name)?, number))
        }
        [name, "<=", number] if name.starts_with('|') => {
            let name = name.trim_matches('|');
            let number = number.parse::<f64>().map_err(|_| format!("`{number}` is no number"))?;
            Ok(Fact::Within(parameter(name)?, number))
        }
        [name, ">=", least] => Ok(Fact::AtLeast(parameter(name)?, limit(least)?)),
        [name, "<=", most] => Ok(Fact::AtMost(parameter(name)?, limit(most)?)),
        [name, "<", most] => Ok(Fact::Below(parameter(name)?, limit(most)?)),
        _ => Err(format!(
            "`{text}` is no fact: `x is finite`, `v is unit`, `x = 1`, `x >= 0`, `x <= y`, \
             `x < y`, `|x| <= 1e6`, `tier is balanced`"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wgsl::{NamedSource, link, scan};

    fn read(text: &str) -> Result<(String, Vec<(String, Vec<Rule>)>), String> {
        let mut linked = link(&[NamedSource { name: "f.wgsl", text }]).expect("no imports");
        let scan = scan(&linked.text);
        let rules = read_rules(&mut linked, &scan);
        rules.map(|rules| (linked.text, rules)).map_err(|problems| problems[0].to_string())
    }

    #[test]
    fn a_rule_becomes_a_function() {
        let (text, rules) = read(
            "/// x.\n/// @where x is finite and low < x : x + low ~ 0.5\n\
             fn f(x: f32, low: f32) -> f32 { return x; }",
        )
        .expect("it is one");
        assert!(text.ends_with("fn f_where_1(x: f32, low: f32) -> f32 { return x + low; }\n"));
        let facts = vec![Fact::Finite(0), Fact::Below(1, RuleLimit::Parameter(0))];
        let rule = Rule { facts, function: "f_where_1".to_owned(), bound: Some(0.5) };
        assert_eq!(rules, [("f".to_owned(), vec![rule])]);
    }

    #[test]
    fn what_is_no_rule_is_told_with_its_line() {
        for (line, wanted) in [
            ("y is finite : x", "there is no parameter `y`"),
            ("x is nice : x", "`x is nice` is no fact"),
            ("x is finite", "the form are missing"),
            ("x is finite : x ~ much", "no number"),
        ] {
            let text = format!("\n/// x.\n/// @where {line}\nfn f(x: f32) -> f32 {{ return x; }}");
            let problem = read(&text).expect_err("it is none");
            assert!(problem.starts_with("f.wgsl:2:1"), "{problem}");
            assert!(problem.contains(wanted), "{problem}");
        }
    }
}
