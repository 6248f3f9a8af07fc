//! Arrays of the host work, made once.
//!
//! The translator writes arrays as values, which C# makes anew at every call: garbage for each
//! camera of each frame. A game's collector should have nothing to do with a look, so arrays that
//! stay within their function become fields of the class. No function of host work calls itself and
//! Unity calls components from one thread, so that two calls never need one array at once.

use std::fmt::Write as _;

use crate::wgsl::rename_identifiers;

/// Members of a class of host work whose arrays are made once. `numbers` is the function that gives
/// the shader's numbers: it fills an array that it is given, whose length is the second value.
pub(super) fn without_garbage(text: &str, numbers: &str) -> (String, Option<usize>) {
    let mut functions: Vec<Function> = Vec::new();
    let mut result = String::with_capacity(text.len());
    let mut lines = text.lines();
    let mut fields = String::new();
    let mut count = None;
    while let Some(line) = lines.next() {
        let Some(name) = function_name(line) else {
            let _ = writeln!(result, "{line}");
            continue;
        };
        let mut own = vec![line.to_owned()];
        for line in lines.by_ref() {
            own.push(line.to_owned());
            if line == "}" {
                break;
            }
        }
        let name = name.to_owned();
        let _ = writeln!(result, "{}", mark(functions.len()));
        functions.push(Function { name, lines: own });
    }
    for at in 0..functions.len() {
        if functions[at].name == numbers {
            count = functions[at].fill_given();
        }
        functions[at].keep_constants(&mut fields);
        functions[at].keep_variables(&mut fields);
        if is_called_once(&functions, &functions[at].name) {
            functions[at].keep_result(&mut fields);
        }
    }
    // The fields stand before the first function and its comment.
    for (at, function) in functions.iter().enumerate() {
        result = result.replacen(&mark(at), &function.lines.join("\n"), 1);
    }
    if fields.is_empty() {
        return (result, count);
    }
    let fields =
        format!("// Arrays are made once: a look leaves no garbage while a game runs.\n{fields}\n");
    let head = functions.first().and_then(|first| result.find(&first.lines[0]));
    let at = head.map_or(0, |head| result[..head].rfind("\n\n").map_or(0, |at| at + 2));
    result.insert_str(at, &fields);
    (result, count)
}

/// The place of a function in a text.
fn mark(at: usize) -> String {
    format!("\u{1}{at}\u{1}")
}

/// The function that a line begins: `Bent` of `public static double Bent(double x)`.
fn function_name(line: &str) -> Option<&str> {
    let head = line.strip_prefix("public static ")?;
    let (before, _) = head.split_once('(')?;
    before.split(' ').nth(1).filter(|_| !line.ends_with(';') && !line.contains("=>"))
}

/// True if an array that the function returns is read by one caller, element by element.
fn is_called_once(functions: &[Function], name: &str) -> bool {
    let call = format!("{name}(");
    let calls = |function: &&Function| function.lines[1..].iter().any(|it| it.contains(&call));
    let mut callers = functions.iter().filter(calls);
    let (Some(caller), None) = (callers.next(), callers.next()) else { return false };
    let lines: Vec<&String> = caller.lines[1..].iter().filter(|it| it.contains(&call)).collect();
    let [line] = lines[..] else { return false };
    let taken = line.trim_start().split_once(" = ");
    taken.is_some_and(|(declared, value)| {
        let variable = declared.split(' ').nth(1).unwrap_or_default();
        declared.contains("[] ")
            && value.starts_with(&call)
            && line.matches(&call).count() == 1
            && caller.reads_elements_alone(variable)
    })
}

/// A function in C#.
struct Function {
    name: String,
    /// Lines from the head to the last bracket.
    lines: Vec<String>,
}

/// An array that a line declares, with the values that it begins with.
struct ArrayLine {
    indent: usize,
    /// Type of an element.
    ty: String,
    name: String,
    /// Elements; none for zeros.
    items: Vec<String>,
    count: usize,
}

impl ArrayLine {
    /// Reads `double[] raw = new double[] { 0.5, 0.5 };` or `double[] raw = new double[2];`.
    fn of(line: &str) -> Option<Self> {
        let trimmed = line.trim_start();
        let (declared, value) = trimmed.split_once(" = ")?;
        let (ty, name) = declared.split_once("[] ")?;
        let rest = value.strip_prefix("new ")?.strip_prefix(ty)?;
        let (items, count) = elements(rest)?;
        let indent = line.len() - trimmed.len();
        Some(Self { indent, ty: ty.to_owned(), name: name.to_owned(), items, count })
    }
}

/// Elements of `[] { 0.5, 0.5 };`, or how many zeros `[2];` has.
fn elements(text: &str) -> Option<(Vec<String>, usize)> {
    if let Some(list) = text.strip_prefix("[] { ").and_then(|it| it.strip_suffix(" };")) {
        let mut items = vec![String::new()];
        let mut depth = 0_usize;
        for c in list.chars() {
            match c {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.checked_sub(1)?,
                _ => {}
            }
            match items.last_mut() {
                Some(_) if c == ',' && depth == 0 => items.push(String::new()),
                Some(item) => item.push(c),
                None => {}
            }
        }
        let items: Vec<String> = items.iter().map(|item| item.trim().to_owned()).collect();
        let count = items.len();
        return Some((items, count));
    }
    let count = text.strip_prefix('[')?.strip_suffix("];")?.parse().ok()?;
    Some((Vec::new(), count))
}

impl Function {
    /// True if the array of a name is only read and written element by element.
    fn reads_elements_alone(&self, name: &str) -> bool {
        let mut is_alone = true;
        for line in self.lines[1..].iter().filter(|line| !is_declared(line, name)) {
            let marked =
                rename_identifiers(line, |word| (word == name).then(|| "\u{1}".to_owned()));
            is_alone &= marked.matches('\u{1}').count() == marked.matches("\u{1}[").count();
        }
        is_alone
    }

    /// True if an element of the array of a name is written.
    fn writes(&self, name: &str) -> bool {
        let start = format!("{name}[");
        self.lines.iter().any(|line| {
            let line = line.trim_start();
            line.starts_with(&start) && line.contains(" = ")
        })
    }

    /// Declarations of arrays that stay within the function, with the places of their lines.
    fn arrays(&self) -> Vec<(usize, ArrayLine)> {
        let lines = self.lines.iter().enumerate();
        let arrays = lines.filter_map(|(at, line)| Some((at, ArrayLine::of(line)?)));
        arrays.filter(|(_, array)| self.reads_elements_alone(&array.name)).collect()
    }

    /// Name of the field of an array.
    fn field(&self, array: &str) -> String {
        let (first, rest) = array.split_at(array.chars().next().map_or(0, char::len_utf8));
        format!("{}{}{rest}", self.name, first.to_ascii_uppercase())
    }

    /// Makes fields of arrays of constants.
    fn keep_constants(&mut self, fields: &mut String) {
        for (at, array) in self.arrays().into_iter().rev() {
            let is_constant = |item: &String| {
                let mut words = item.split(|c: char| !c.is_ascii_alphanumeric() && c != '.');
                let is_own = |word: &str| {
                    word.is_empty()
                        || word == "new"
                        || word.starts_with("Double")
                        || word.starts_with(|c: char| c.is_ascii_digit())
                };
                words.all(is_own)
            };
            if self.writes(&array.name) || !array.items.iter().all(is_constant) {
                continue;
            }
            let (field, ty) = (self.field(&array.name), &array.ty);
            let _ = writeln!(fields, "static readonly {ty}[] {field} = new {ty}[]\n{{");
            for item in &array.items {
                let _ = writeln!(fields, "    {item},");
            }
            fields.push_str("};\n");
            self.lines.remove(at);
            for line in &mut self.lines {
                *line =
                    rename_identifiers(line, |word| (word == array.name).then(|| field.clone()));
            }
        }
    }

    /// Makes fields of arrays that the function fills.
    fn keep_variables(&mut self, fields: &mut String) {
        for (at, array) in self.arrays().into_iter().rev() {
            let (field, name) = (self.field(&array.name), &array.name);
            let indent = " ".repeat(array.indent);
            let (ty, count) = (&array.ty, array.count);
            let _ = writeln!(fields, "static readonly {ty}[] {field} = new {ty}[{count}];");
            let mut lines = vec![format!("{indent}{ty}[] {name} = {field};")];
            if array.items.is_empty() {
                lines.push(format!("{indent}Array.Clear({name}, 0, {count});"));
            }
            for (index, item) in array.items.iter().enumerate() {
                lines.push(format!("{indent}{name}[{index}] = {item};"));
            }
            self.lines.splice(at..=at, lines);
        }
    }

    /// Makes a field of the array that the function returns.
    fn keep_result(&mut self, fields: &mut String) {
        let last = self.lines.len().saturating_sub(2);
        let line = self.lines[last].clone();
        let Some(value) = line.trim_start().strip_prefix("return new ") else { return };
        let Some((ty, rest)) = value.split_once('[') else { return };
        let Some((items, count)) = elements(&format!("[{rest}")) else { return };
        let returns = self.lines.iter().filter(|line| line.trim_start().starts_with("return "));
        if items.is_empty() || returns.count() != 1 {
            return;
        }
        let field = self.field("result");
        let _ = writeln!(fields, "static readonly {ty}[] {field} = new {ty}[{count}];");
        let lines =
            items.iter().enumerate().map(|(index, item)| format!("    {field}[{index}] = {item};"));
        let lines: Vec<String> = lines.chain([format!("    return {field};")]).collect();
        self.lines.splice(last..=last, lines);
    }

    /// Lets the function fill an array that it is given in the place of one that it returns. Length
    /// of the array; `None` for a function of another form.
    fn fill_given(&mut self) -> Option<usize> {
        let arrays = self.lines.iter().enumerate();
        let mut arrays = arrays.filter_map(|(at, line)| Some((at, ArrayLine::of(line)?)));
        let (declared, array) =
            arrays.find(|(_, array)| array.name == "numbers" && array.items.is_empty())?;
        let returned = self.lines.iter().position(|line| line == "    return numbers;")?;
        let start = format!("public static double[] {}(", self.name);
        let head = self.lines[0].strip_prefix(&start)?.strip_suffix(')')?;
        self.lines[0] = format!("public static void {}({head}, double[] numbers)", self.name);
        self.lines.remove(returned);
        self.lines.remove(declared);
        Some(array.count)
    }
}

/// True for the declaration of an array of a name.
fn is_declared(line: &str, name: &str) -> bool {
    let declared = line.trim_start().split_once(" = ");
    declared.is_some_and(|(declared, _)| declared.ends_with(&format!("[] {name}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
const double Pi = 3.0;

/// <summary>Weights.</summary>
public static double[] Weights(Double3 x)
{
    Double3[] centers = new Double3[] { new Double3(-0.5, 0.6, 1e-7), new Double3(x.x) };
    double[] shares = new double[] { 0.4, -0.4 };
    double[] raw = new double[] { 0.5, 0.5 };
    double[] sums = new double[2];
    raw[0] = shares[0] + centers[1].x;
    sums[1] = raw[1];
    return new double[] { raw[0], Max(sums[1], 2.0) };
}

public static double[] DrawNumbers(Settings settings, Surroundings around)
{
    double[] weights = Weights(around.eye);
    double[] numbers = new double[2];
    numbers[0] = weights[0];
    return numbers;
}
";

    #[test]
    fn arrays_are_made_once() {
        let wanted = "\
const double Pi = 3.0;

// Arrays are made once: a look leaves no garbage while a game runs.
static readonly double[] WeightsShares = new double[]
{
    0.4,
    -0.4,
};
static readonly double[] WeightsSums = new double[2];
static readonly double[] WeightsRaw = new double[2];
static readonly Double3[] WeightsCenters = new Double3[2];
static readonly double[] WeightsResult = new double[2];

/// <summary>Weights.</summary>
public static double[] Weights(Double3 x)
{
    Double3[] centers = WeightsCenters;
    centers[0] = new Double3(-0.5, 0.6, 1e-7);
    centers[1] = new Double3(x.x);
    double[] raw = WeightsRaw;
    raw[0] = 0.5;
    raw[1] = 0.5;
    double[] sums = WeightsSums;
    Array.Clear(sums, 0, 2);
    raw[0] = WeightsShares[0] + centers[1].x;
    sums[1] = raw[1];
    WeightsResult[0] = raw[0];
    WeightsResult[1] = Max(sums[1], 2.0);
    return WeightsResult;
}

public static void DrawNumbers(Settings settings, Surroundings around, double[] numbers)
{
    double[] weights = Weights(around.eye);
    numbers[0] = weights[0];
}
";
        let (text, count) = without_garbage(TEXT, "DrawNumbers");
        assert_eq!((text.as_str(), count), (wanted, Some(2)));
    }

    #[test]
    fn arrays_that_leave_their_function_stay() {
        let text = "\
public static double[] Sums(double x)
{
    double[] sums = new double[2];
    sums[0] = x;
    return sums;
}
public static double Both(double x)
{
    double[] a = Sums(x);
    double[] b = Sums(a[0]);
    return a[0] + b[0];
}
";
        assert_eq!(without_garbage(text, "DrawNumbers"), (text.to_owned(), None));
    }
}
