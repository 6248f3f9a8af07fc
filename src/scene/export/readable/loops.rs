//! Loops that count, as `for`.
//!
//! naga writes each loop of WGSL as one without end: a flag tells the first turn from the others,
//! which begin with the step, and a condition of its own leaves. Where the step is one assignment
//! and the condition comes first, that is a `for` of all languages here, `continue` included.

use super::brackets;
use super::word::words;

/// The text with a `for` in the place of each loop that counts.
pub(super) fn counted(text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut at = 0;
    while at < lines.len() {
        if let Some(found) = Loop::at(&lines, at) {
            at = found.write(&mut lines);
        }
        at += 1;
    }
    let mut text = lines.join("\n");
    text.push('\n');
    text
}

/// A loop of naga's that counts.
struct Loop {
    /// Line of the flag's declaration.
    start: usize,
    /// Comments between the flag and the loop.
    comments: Vec<String>,
    /// Lines of the body.
    body: std::ops::Range<usize>,
    /// Line of the closing bracket.
    end: usize,
    /// Spaces before the loop.
    indent: usize,
    /// Variable that counts.
    counter: String,
    /// Condition of another turn.
    condition: String,
    /// Step after each turn.
    step: String,
}

impl Loop {
    /// The loop whose flag is declared in a line.
    fn at(lines: &[String], start: usize) -> Option<Self> {
        let first = lines[start].trim_start();
        let flag = first.strip_prefix("bool ")?.strip_suffix(" = true;")?;
        let indent = lines[start].len() - first.len();
        let is_comment = |line: &&String| line.trim_start().starts_with("//");
        let comments: Vec<String> =
            lines[start + 1..].iter().take_while(is_comment).cloned().collect();
        let flag_at = start + comments.len();
        // A line by its number after the flag's and the levels by which it is further in.
        let line = |number: usize, levels: usize| {
            let line =
                lines.get(flag_at + number)?.strip_prefix(&" ".repeat(indent + 4 * levels))?;
            (!line.starts_with(' ')).then_some(line)
        };
        let is = |number, levels, wanted: &str| line(number, levels) == Some(wanted);
        if !is(1, 0, "while(true) {") || !is(2, 1, &format!("if (!{flag}) {{")) {
            return None;
        }
        let step = brackets::without_needless(line(3, 2)?);
        let step = step.strip_suffix(';')?;
        let (counter, value) = step.split_once(" = ")?;
        let is_plain = counter.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
        if !is_plain || !is(4, 1, "}") || !is(5, 1, &format!("{flag} = false;")) {
            return None;
        }
        let asked = brackets::without_needless(line(6, 1)?);
        let asked = asked.strip_prefix("if (")?.strip_suffix(") {")?;
        let (condition, body) = if is(7, 1, "} else {") && is(8, 2, "break;") && is(9, 1, "}") {
            (asked, flag_at + 10)
        } else if is(7, 2, "break;") && is(8, 1, "}") {
            let left = asked.strip_prefix("!(")?.strip_suffix(')')?;
            (is_whole(left).then_some(left)?, flag_at + 9)
        } else {
            return None;
        };
        let closing = " ".repeat(indent) + "}";
        let end = (body..lines.len()).find(|&number| lines[number] == closing)?;
        Some(Self {
            start,
            comments,
            body: body..end,
            end,
            indent,
            counter: counter.to_owned(),
            condition: without_casts(condition),
            step: stepped(counter, value).unwrap_or_else(|| step.to_owned()),
        })
    }

    /// Writes the loop as `for` in the place of its lines; returns the line of its head.
    fn write(&self, lines: &mut Vec<String>) -> usize {
        let space = " ".repeat(self.indent);
        let mut body: Vec<String> = lines[self.body.clone()].to_vec();
        let (open, close) = (format!("{space}    {{"), format!("{space}    }}"));
        let is_block = body.first() == Some(&open)
            && body.iter().position(|line| *line == close) == Some(body.len() - 1);
        if is_block {
            body = body[1..body.len() - 1].iter().map(|line| less_indented(line)).collect();
        }
        let mut start = self.start;
        let mut beginning = String::new();
        let before = start.checked_sub(1).map(|number| lines[number].as_str()).unwrap_or_default();
        let assigned = format!("{space}{} = ", self.counter);
        if let Some(value) = before.strip_prefix(&assigned).and_then(|it| it.strip_suffix(';')) {
            beginning = format!("{} = {}", self.counter, without_casts(value));
            start -= 1;
        }
        let mut comments = self.comments.clone();
        let mut removed = 0;
        if let Some((declared, number)) = self.own_declaration(lines, start) {
            let (ty, value) = declared;
            if beginning.is_empty() {
                beginning = format!("{} = {}", self.counter, without_casts(&value));
            }
            beginning = format!("{ty} {beginning}");
            // What is said of the counter is said of the loop.
            let mut first = number;
            while first > 0 && lines[first - 1].trim_start().starts_with("//") {
                first -= 1;
            }
            let about = lines[first..number].iter().map(|it| space.clone() + it.trim());
            comments.splice(0..0, about);
            lines.drain(first..=number);
            removed = number + 1 - first;
        }
        let head = format!("{space}for ({beginning}; {}; {}) {{", self.condition, self.step);
        let head_at = start - removed + comments.len();
        let written = comments.into_iter().chain([head]).chain(body).chain([space.clone() + "}"]);
        lines.splice(start - removed..=self.end - removed, written);
        head_at
    }

    /// Type and value of the counter's declaration, with its line, where the loop, whose lines
    /// begin at `start`, is all that the counter is for.
    fn own_declaration(&self, lines: &[String], start: usize) -> Option<((String, String), usize)> {
        let first =
            (0..start).rev().find(|&number| lines[number] == "{" || is_head(&lines[number]))?;
        let last = (self.end..lines.len()).find(|&number| lines[number] == "}")?;
        let reads = |line: &String| words(line).any(|word| line[word.span] == self.counter);
        let others: Vec<usize> = (first + 1..start)
            .chain(self.end + 1..last)
            .filter(|&number| reads(&lines[number]))
            .collect();
        let [number] = others[..] else { return None };
        // Within another loop the counter has its first value once only, unless it is assigned.
        let is_assigned = start < self.start;
        if number > start || (self.indent != 4 && !is_assigned) {
            return None;
        }
        let line = lines[number].trim_start().strip_suffix(';')?;
        let (declared, value) = line.split_once(" = ").unwrap_or((line, ""));
        let (ty, name) = declared.split_once(' ')?;
        let is_known = matches!(ty, "int" | "uint");
        let has_value = is_assigned || !value.is_empty();
        let is_own = is_known && name == self.counter && has_value;
        is_own.then(|| ((ty.to_owned(), value.to_owned()), number))
    }
}

/// True for a text whose brackets are all its own, unlike `a) || (b` of `(a) || (b)`.
fn is_whole(text: &str) -> bool {
    let mut depth = 0_i32;
    let is_open = text.chars().all(|c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth >= 0
    });
    is_open && depth == 0
}

/// True for a function's first line.
fn is_head(line: &str) -> bool {
    line.ends_with('{') && !line.starts_with(' ')
}

/// A line of an inner block, one level further out.
fn less_indented(line: &str) -> String {
    line.strip_prefix("    ").unwrap_or(line).to_owned()
}

/// `i++` or `i--` for a value that is the counter and 1. HLSL and MSL add integers that may
/// overflow as unsigned ones; a counter that another turn's condition held for does not.
fn stepped(counter: &str, value: &str) -> Option<String> {
    let plain = [("asint(asuint(", "asuint("), ("as_type<int>(as_type<uint>(", "as_type<uint>(")];
    let forms = plain.iter().map(|(open, again)| {
        let sum = value.strip_prefix(open)?.strip_prefix(counter)?.strip_prefix(") ")?;
        let (sign, one) = sum.split_once(' ')?;
        Some((sign, one.strip_prefix(again)?.strip_suffix("))")?))
    });
    let simple = value.strip_prefix(counter).and_then(|it| it.strip_prefix(' '));
    let simple = simple.and_then(|it| it.split_once(' '));
    let (sign, one) = forms.flatten().next().or(simple)?;
    match (sign, without_casts(one).trim_end_matches('u')) {
        ("+", "1") => Some(format!("{counter}++")),
        ("-", "1") => Some(format!("{counter}--")),
        _ => None,
    }
}

/// The text with `4` for `int(4)`, as HLSL's literals are written by naga.
fn without_casts(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("int(") {
        let (before, from) = rest.split_at(at);
        let inner = from["int(".len()..].split_once(')').map(|(inner, _)| inner);
        let is_word = before.ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let number = inner.filter(|it| !is_word && it.parse::<i32>().is_ok());
        written.push_str(before);
        let taken = match number {
            Some(number) => {
                written.push_str(number);
                "int()".len() + number.len()
            }
            None => {
                written.push_str("int(");
                "int(".len()
            }
        };
        rest = &from[taken..];
    }
    written + rest
}

#[cfg(test)]
mod tests {
    use super::counted;

    #[test]
    fn a_counter_of_its_own_is_declared_by_the_loop() {
        let written = "\
float sum(int count)
{
    // Each of them.
    int i = int(0);
    float sum = 0.0;
    bool loop_init = true;
    // No more than there are.
    while(true) {
        if (!loop_init) {
            i = asint((asuint(i) + asuint(int(1))));
        }
        loop_init = false;
        if ((i < count)) {
        } else {
            break;
        }
        {
            if (i == int(3)) {
                continue;
            }
            sum = sum + float(i);
        }
    }
    return sum;
}
";
        let wanted = "\
float sum(int count)
{
    float sum = 0.0;
    // Each of them.
    // No more than there are.
    for (int i = 0; i < count; i++) {
        if (i == int(3)) {
            continue;
        }
        sum = sum + float(i);
    }
    return sum;
}
";
        assert_eq!(counted(written), wanted);
    }

    #[test]
    fn loops_within_loops_begin_anew() {
        let written = "\
float f() {
    uint a = 0u;
    uint b = 0u;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            a = (a + 1u);
        }
        loop_init = false;
        if (!((a < 2u))) {
            break;
        }
        b = 1u;
        bool loop_init_1 = true;
        while(true) {
            if (!loop_init_1) {
                b = b * 2u;
            }
            loop_init_1 = false;
            if (!(b < 8u)) {
                break;
            }
            g(a, b);
        }
    }
    return 1.0;
}
";
        let wanted = "\
float f() {
    for (uint a = 0u; a < 2u; a++) {
        for (uint b = 1u; b < 8u; b = b * 2u) {
            g(a, b);
        }
    }
    return 1.0;
}
";
        assert_eq!(counted(written), wanted);
    }

    /// A value that is read after the loop is declared before it.
    #[test]
    fn a_counter_that_others_read_stays() {
        let written = "\
int f() {
    int i = 7;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            i = i - 1;
        }
        loop_init = false;
        if (i >= 0) {
        } else {
            break;
        }
        {
            g(i);
        }
    }
    return i;
}
";
        let wanted = "\
int f() {
    int i = 7;
    for (; i >= 0; i--) {
        g(i);
    }
    return i;
}
";
        assert_eq!(counted(written), wanted);
        let either = written.replace("if (i >= 0) {\n        } else {", "if (!(a) || (b)) {");
        assert_ne!(either, written);
        assert_eq!(counted(&either), either);
        // A step of two statements is no step of a `for`.
        let two = written.replace("i = i - 1;\n", "i = i - 1;\n            j = i;\n");
        assert_eq!(counted(&two), two);
    }
}
