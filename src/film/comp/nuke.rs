//! Nuke: a script of nodes as text.
//!
//! A node takes its inputs off a stack, the first one from the top, and lays itself on it; `set`
//! names what lies on top, and `push` lays it there again. Columns stand from left to right: what
//! is in no layer, then each layer; they are written from the right, so that each sum finds the one
//! before on top and its layer below.

use std::fmt::Write as _;

use super::{Comp, LayerSpace};
use crate::diag::Diagnostic;
use crate::exr::SampleType;

/// Distance of columns and of rows, in Nuke's units.
const COLUMN: i32 = 160;
const ROW: i32 = 60;

/// Half of a node's size less that of a dot, so that wires are straight.
const DOT: [i32; 2] = [34, 4];

/// Curves of sRGB (IEC 61966-2-1) as expressions of a channel, `x`.
const DECODED: &str = "x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4)";
const ENCODED: &str = "x <= 0.0031308 ? x * 12.92 : 1.055 * pow(x, 1 / 2.4) - 0.055";

/// Colors of backdrops.
const OF_READING: u32 = 0x3a44_4cff;
const OF_GAINS: u32 = 0x4c44_3aff;
const OF_RESULT: u32 = 0x3a4c_3fff;

pub(super) fn write(comp: &Comp) -> Result<String, Diagnostic> {
    let mut script = Script::default();
    let rows = Rows::of(comp.parts.space);
    head(&mut script, comp);
    backdrops(&mut script, comp, &rows);
    reading(&mut script, comp, &rows);
    let parts = comp.parts.parts.len();
    for (at, part) in comp.parts.parts.iter().enumerate().rev() {
        if at + 1 < parts {
            script.push(&dot_of(at));
        }
        let column = column(at + 1);
        shuffle(&mut script, &part.layer, &format!("{}_layer", part.layer), [column, rows.layer]);
        gain(&mut script, &part.label, &format!("gain_{}", part.label), [column, rows.gain]);
    }
    rest(&mut script, comp, &rows);
    for (at, part) in comp.parts.parts.iter().enumerate() {
        let name = format!("plus_{}", part.label);
        let knobs = [("operation", "plus".to_owned()), ("output", "rgb".to_owned())];
        script.node("Merge2", 2, &knobs, &name, [0, rows.sum + ROW * at as i32]);
    }
    result(&mut script, comp, &rows);
    mattes(&mut script, comp, &rows);
    Ok(script.text)
}

/// Places of rows of nodes.
struct Rows {
    read: i32,
    dots: i32,
    layer: i32,
    gain: i32,
    sum: i32,
}

impl Rows {
    fn of(space: LayerSpace) -> Self {
        // The way into the space of the layers is three nodes.
        let into = if space == LayerSpace::Display { 3 * ROW } else { 0 };
        let (read, dots) = (-3 * ROW, 0);
        let layer = dots + ROW + into;
        Self { read, dots, layer, gain: layer + 2 * ROW, sum: layer + 4 * ROW }
    }
}

fn column(at: usize) -> i32 {
    COLUMN * at as i32
}

fn dot_of(at: usize) -> String {
    format!("dot{at}")
}

/// Name of the picture on the stack.
const PICTURE: &str = "picture";

/// A script as it is written.
#[derive(Default)]
struct Script {
    text: String,
}

impl Script {
    fn node(
        &mut self,
        class: &str,
        inputs: usize,
        knobs: &[(&str, String)],
        name: &str,
        [x, y]: [i32; 2],
    ) {
        let _ = writeln!(self.text, "{class} {{");
        if inputs != 1 {
            let _ = writeln!(self.text, " inputs {inputs}");
        }
        for (knob, value) in knobs {
            let _ = writeln!(self.text, " {knob} {value}");
        }
        let _ = writeln!(self.text, " name {name}\n xpos {x}\n ypos {y}\n}}");
    }

    /// Names what lies on top of the stack.
    fn set(&mut self, name: &str) {
        let _ = writeln!(self.text, "set N_{name} [stack 0]");
    }

    fn push(&mut self, name: &str) {
        let _ = writeln!(self.text, "push $N_{name}");
    }

    /// Makes a layer known before a node names it.
    fn layer(&mut self, name: &str, channels: &[&str]) {
        let channels: Vec<String> = channels.iter().map(|one| format!("{name}.{one}")).collect();
        let _ = writeln!(self.text, "add_layer {{{name} {}}}", channels.join(" "));
    }
}

/// A text as a value: quoted, with nothing in it that is evaluated as it is read.
fn text(value: &str) -> String {
    let mut quoted = String::from('"');
    for c in value.chars() {
        match c {
            '\n' => quoted.push_str("\\n"),
            '"' | '\\' | '[' | ']' | '{' | '}' | '$' => quoted.extend(['\\', c]),
            c if c.is_control() => {}
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// A text that is no expression either when it is shown or opened.
fn plain(value: &str) -> String {
    text(&value.replace('\\', "/").replace('[', "\\[").replace(']', "\\]"))
}

/// Settings of the script, and the layers that its nodes name.
fn head(script: &mut Script, comp: &Comp) {
    let [first, last] = comp.frames.unwrap_or([1, 1]);
    let [width, height] = comp.size;
    let rate = f64::from(comp.rate.frames) / f64::from(comp.rate.seconds);
    let _ = writeln!(script.text, "# {}", comp.about().replace(char::is_control, " "));
    let _ = writeln!(script.text, "version 13.0 v1\nRoot {{\n inputs 0");
    if comp.is_relative() {
        let folder = text("[python {nuke.script_directory()}]");
        let _ = writeln!(script.text, " project_directory {folder}");
    }
    let format = text(&format!("{width} {height} 0 0 {width} {height} 1 chiaro_{width}x{height}"));
    let _ = writeln!(
        script.text,
        " frame {first}\n first_frame {first}\n last_frame {last}\n lock_range true\n fps \
         {rate}\n format {format}\n colorManagement Nuke\n workingSpaceLUT linear\n monitorLut \
         sRGB\n floatLut linear\n}}"
    );
    let parts = comp.parts.parts.iter().map(|part| part.layer.as_str());
    for layer in parts.chain([comp.parts.whole.as_str()]) {
        script.layer(layer, &["red", "green", "blue"]);
    }
    for matte in &comp.mattes {
        for level in 0..3 {
            script.layer(&format!("{matte}{level:02}"), &["red", "green", "blue", "alpha"]);
        }
    }
}

fn backdrops(script: &mut Script, comp: &Comp, rows: &Rows) {
    let parts = comp.parts.parts.len();
    let (left, across) = (-COLUMN - 40, column(parts) + 100);
    let end = rows.sum + ROW * (parts as i32 + 6);
    let mut backdrop = |label: &str, color: u32, [left, top, right, bottom]: [i32; 4]| {
        let name = format!("Backdrop_{top}").replace('-', "_");
        let knobs = [
            ("tile_color", format!("0x{color:08x}")),
            ("label", plain(label)),
            ("note_font_size", "24".to_owned()),
            ("bdwidth", (right - left).to_string()),
            ("bdheight", (bottom - top).to_string()),
        ];
        script.node("BackdropNode", 0, &knobs, &name, [left, top]);
    };
    let space = match comp.parts.space {
        LayerSpace::Display => "as shown (sRGB), in which the looks blend",
        LayerSpace::Linear => "as light, in which the looks blend",
    };
    let read = format!("{}: the picture with its layers, raw", comp.name);
    backdrop(&read, OF_READING, [left, rows.read - ROW, across, rows.dots - 20]);
    let gains = format!("Gains of {}: change the values of Multiply\n{space}", comp.parts.whole);
    backdrop(&gains, OF_GAINS, [left, rows.dots - 10, across, rows.sum - ROW / 2]);
    let sum = "The sum, back to premultiplied light";
    backdrop(sum, OF_RESULT, [left, rows.sum - ROW / 2 + 10, across, end]);
}

/// The picture, and a row of dots from which the columns hang.
fn reading(script: &mut Script, comp: &Comp, rows: &Rows) {
    let [width, height] = comp.size;
    let format = text(&format!("{width} {height} 0 0 {width} {height} 1 chiaro_{width}x{height}"));
    let mut knobs =
        vec![("file_type", "exr".to_owned()), ("file", plain(&comp.file)), ("format", format)];
    if let Some([first, last]) = comp.frames {
        for (knob, frame) in
            [("first", first), ("last", last), ("origfirst", first), ("origlast", last)]
        {
            knobs.push((knob, frame.to_string()));
        }
        knobs.push(("origset", "true".to_owned()));
    }
    knobs.push(("raw", "true".to_owned()));
    script.node("Read", 0, &knobs, "Read_picture", [0, rows.read]);
    script.set(PICTURE);
    for at in 0..comp.parts.parts.len() {
        let place = [column(at + 1) + DOT[0], rows.dots + DOT[1]];
        script.node("Dot", 1, &[], &format!("Dot_{}", at + 1), place);
        script.set(&dot_of(at));
    }
}

/// A layer as the color; its alpha is nothing, for that of the picture stays.
fn shuffle(script: &mut Script, layer: &str, name: &str, place: [i32; 2]) {
    let colors = [("red", 0), ("green", 1), ("blue", 2)];
    let mappings: Vec<String> = colors
        .iter()
        .map(|(color, at)| format!("{layer}.{color} 0 {at} rgba.{color} 0 {at}"))
        .collect();
    let mappings = format!("\"4 {} black -1 -1 rgba.alpha 0 3\"", mappings.join(" "));
    let knobs = [
        ("fromInput1", "{{0} B}".to_owned()),
        ("in1", layer.to_owned()),
        ("fromInput2", "{{0} B}".to_owned()),
        ("mappings", mappings),
    ];
    script.node("Shuffle2", 1, &knobs, name, place);
}

fn gain(script: &mut Script, label: &str, name: &str, place: [i32; 2]) {
    let knobs = [
        ("channels", "rgb".to_owned()),
        ("value", "{1 1 1 1}".to_owned()),
        ("label", plain(&format!("gain of {label}"))),
        ("note_font_size", "14".to_owned()),
    ];
    script.node("Multiply", 1, &knobs, name, place);
}

/// Rest that is in no layer: the picture in the space of the layers, less their sum.
fn rest(script: &mut Script, comp: &Comp, rows: &Rows) {
    script.push(PICTURE);
    let whole = &comp.parts.whole;
    shuffle(script, whole, &format!("{whole}_layer"), [-COLUMN, rows.layer]);
    script.push(PICTURE);
    if comp.parts.space == LayerSpace::Display {
        curve(script, "as_shown", "light to as shown", ENCODED, [0, rows.dots + ROW]);
    }
    let knobs = [
        ("operation", "from".to_owned()),
        ("output", "rgb".to_owned()),
        ("label", text("what is in no layer")),
    ];
    script.node("Merge2", 2, &knobs, "rest", [0, rows.layer]);
    gain(script, "backdrop and outlines", "gain_rest", [0, rows.gain]);
}

/// A curve of colors that are not premultiplied, with the way there and back.
fn curve(script: &mut Script, name: &str, label: &str, curve: &str, [x, y]: [i32; 2]) {
    let channels = ("channels", "rgb".to_owned());
    let unpremult = format!("{name}_unpremult");
    script.node("Unpremult", 1, std::slice::from_ref(&channels), &unpremult, [x, y]);
    let of = |channel: &str| text(&curve.replace('x', channel));
    let knobs =
        [("expr0", of("r")), ("expr1", of("g")), ("expr2", of("b")), ("label", text(label))];
    script.node("Expression", 1, &knobs, name, [x, y + ROW]);
    script.node("Premult", 1, &[channels], &format!("{name}_premult"), [x, y + 2 * ROW]);
}

/// The sum as light, and the pictures that are written.
fn result(script: &mut Script, comp: &Comp, rows: &Rows) {
    let mut at = rows.sum + ROW * comp.parts.parts.len() as i32;
    if comp.parts.space == LayerSpace::Display {
        curve(script, "as_light", "as shown to light", DECODED, [0, at]);
        at += 3 * ROW;
    }
    let samples = match comp.samples {
        SampleType::Half => "16 bit half",
        SampleType::Float => "32 bit float",
    };
    let knobs = [
        ("channels", "rgba".to_owned()),
        ("file", plain(&comp.output)),
        ("file_type", "exr".to_owned()),
        ("raw", "true".to_owned()),
        ("datatype", text(samples)),
        ("create_directories", "true".to_owned()),
    ];
    script.node("Write", 1, &knobs, "Write_result", [0, at + ROW]);
}

/// A node for each matte, to pick from.
fn mattes(script: &mut Script, comp: &Comp, rows: &Rows) {
    for (at, matte) in comp.mattes.iter().enumerate() {
        script.push(PICTURE);
        let knobs = [
            ("matteOutput", "alpha".to_owned()),
            ("lastSelectedCryptoLayerName", matte.clone()),
            ("label", plain(matte)),
        ];
        let place = [-COLUMN * (at as i32 + 2), rows.dots];
        script.node("Cryptomatte", 1, &knobs, &format!("Cryptomatte_{matte}"), place);
    }
}
