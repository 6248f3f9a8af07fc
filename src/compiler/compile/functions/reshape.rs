//! Statements of a function, put as people would write them once all is decided.

use std::collections::HashSet;

use super::code::{Code, Line, each_code};
use super::{MOST_INLINED, MOST_SELECTED};

/// The statements of a function with late declarations, and without variables and branches that it
/// can do without; `can_select` says whether WGSL selects between results of its type.
pub(super) fn reshaped(lines: Vec<Line>, can_select: bool) -> Vec<Line> {
    let lines = without_unread(with_declarations_late(lines));
    collapsed(if can_select { selected(lines) } else { lines })
}

/// The statements with variables declared where they are first set, if that is in the function's
/// outermost block.
fn with_declarations_late(lines: Vec<Line>) -> Vec<Line> {
    let count = lines.iter().take_while(|line| matches!(line, Line::Var(..))).count();
    let mut rest = lines;
    let declarations: Vec<Line> = rest.drain(..count).collect();
    for declaration in declarations.into_iter().rev() {
        let Line::Var(index, ty, init) = declaration else { continue };
        let mentions = |line: &Line| {
            let mut found = false;
            each_code(std::slice::from_ref(line), &mut |code| {
                found |= *code == Code::Local(index);
            });
            found
        };
        let Some(at) = rest.iter().position(mentions) else { continue };
        match (&rest[at], init) {
            (Line::Assign(Code::Local(place), value), None) if *place == index => {
                let mut reads_itself = false;
                value.each(&mut |code| reads_itself |= *code == Code::Local(index));
                if reads_itself {
                    rest.insert(at, Line::Var(index, ty, None));
                } else {
                    rest[at] = Line::Var(index, ty, Some(value.clone()));
                }
            }
            (_, init) => rest.insert(at, Line::Var(index, ty, init)),
        }
    }
    rest
}

/// The statements without variables that nothing reads.
fn without_unread(mut lines: Vec<Line>) -> Vec<Line> {
    loop {
        let mut read = HashSet::new();
        each_code(&lines, &mut |code| {
            if let Code::Local(index) = code {
                read.insert(*index);
            }
        });
        let before = count(&lines);
        lines = kept(lines, &read);
        if count(&lines) == before {
            return lines;
        }
    }
}

/// The statements without variables other than those that are read.
fn kept(lines: Vec<Line>, read: &HashSet<usize>) -> Vec<Line> {
    let is_kept = |line: &Line| match line {
        Line::Let(index, _) | Line::Var(index, ..) => read.contains(index),
        _ => true,
    };
    let inside = |line: Line| match line {
        Line::If(condition, accept, reject) => {
            Line::If(condition, kept(accept, read), kept(reject, read))
        }
        Line::Loop(body, continuing, end) => {
            Line::Loop(kept(body, read), kept(continuing, read), end)
        }
        Line::Switch(selector, cases) => Line::Switch(
            selector,
            cases.into_iter().map(|(value, body)| (value, kept(body, read))).collect(),
        ),
        other => other,
    };
    lines.into_iter().filter(is_kept).map(inside).collect()
}

/// Number of statements, with those within.
fn count(lines: &[Line]) -> usize {
    let inner = |line: &Line| match line {
        Line::If(_, accept, reject) => count(accept) + count(reject),
        Line::Loop(body, continuing, _) => count(body) + count(continuing),
        Line::Switch(_, cases) => cases.iter().map(|(_, body)| count(body)).sum(),
        _ => 0,
    };
    lines.len() + lines.iter().map(inner).sum::<usize>()
}

/// A function that returns one of two short results, by a selection in place of a branch: nothing
/// is shared across branches, and short results cost less than one.
fn selected(lines: Vec<Line>) -> Vec<Line> {
    match lines.as_slice() {
        [.., Line::If(condition, accept, reject), Line::Return(otherwise)] if reject.is_empty() => {
            let [Line::Return(value)] = accept.as_slice() else { return lines };
            let is_short = |code: &Code| code.size() <= MOST_SELECTED && !code.has_calls();
            if !is_short(value) || !is_short(otherwise) {
                return lines;
            }
            let select = Code::BuiltIn(
                "select".into(),
                vec![otherwise.clone(), value.clone(), condition.clone()],
            );
            let mut kept = lines[..lines.len() - 2].to_vec();
            kept.push(Line::Return(select));
            selected(kept)
        }
        _ => lines,
    }
}

/// A short function as one expression, where each of its names is read once.
fn collapsed(lines: Vec<Line>) -> Vec<Line> {
    let Some((Line::Return(result), lets)) = lines.split_last() else { return lines };
    let mut result = result.clone();
    for line in lets.iter().rev() {
        let Line::Let(index, value) = line else { return lines };
        let mut reads = 0;
        result.each(&mut |code| reads += usize::from(*code == Code::Local(*index)));
        if reads > 1 {
            return lines;
        }
        result = result.with_local(*index, value);
        if result.size() > MOST_INLINED {
            return lines;
        }
    }
    if result.size() <= MOST_INLINED { vec![Line::Return(result)] } else { lines }
}
