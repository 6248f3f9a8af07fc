//! The material graph as the text that Unreal's material editor copies and pastes.
//!
//! Each node is an object with its expression inside. A link stands twice: in the expression that
//! takes it, and at the pins of both ends.

use std::fmt::Write as _;

use super::arguments::{Argument, ArgumentKind, shown_default};
use super::images::{self, UnrealImage};
use super::shader::UnrealShader;
use crate::export::package::PackageRequest;
use crate::export::package::stable_id::stable_id;

/// A node with what leaves it.
struct Source {
    /// Class of the expression, without `MaterialExpression`.
    class: &'static str,
    /// Word for ids: a parameter's name, or that of an input.
    id: String,
    /// Properties of the expression.
    properties: Vec<String>,
    /// The node that feeds this one, by index.
    fed_by: Option<usize>,
    /// Inputs of the Custom node that take an output.
    takers: Vec<Taker>,
}

/// An input of the Custom node.
struct Taker {
    name: String,
    output: Output,
}

/// An output of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Output {
    /// The only one.
    Whole,
    /// The first of a color's, its red, green and blue.
    Rgb,
    /// The fifth of a color's.
    Alpha,
}

impl Output {
    fn index(self) -> usize {
        if self == Self::Alpha { 4 } else { 0 }
    }

    /// Words of an input about the output beside its node.
    fn mask(self) -> &'static str {
        match self {
            Self::Whole => "",
            Self::Rgb => ",Mask=1,MaskR=1,MaskG=1,MaskB=1",
            Self::Alpha => ",OutputIndex=4,Mask=1,MaskA=1",
        }
    }
}

/// Nodes for members of the pixel that are inputs: names, classes and properties.
const NODES: [(&str, &str, &str); 9] = [
    ("WorldPosition", "WorldPosition", ""),
    (
        "LocalPosition",
        "TransformPosition",
        "TransformSourceType=TRANSFORMPOSSOURCE_World\n\
         TransformType=TRANSFORMPOSSOURCE_Local",
    ),
    ("VertexNormal", "VertexNormalWS", ""),
    ("TwoSidedSign", "TwoSidedSign", ""),
    ("TexCoord", "TextureCoordinate", ""),
    ("VertexColor", "VertexColor", ""),
    ("CameraPosition", "CameraPositionWS", ""),
    ("ObjectPosition", "ObjectPositionWS", ""),
    ("Time", "Time", ""),
];

/// The text for the clipboard.
pub(super) fn write(
    request: &PackageRequest<'_>,
    class: &str,
    arguments: &[Argument<'_>],
    shader: &UnrealShader<'_>,
) -> String {
    let mut sources: Vec<Source> = Vec::new();
    for (index, argument) in arguments.iter().enumerate() {
        sources.push(parameter(request, index, argument));
    }
    for image in &shader.images {
        sources.push(texture(request, image));
    }
    for input in &shader.inputs {
        let Some((name, class, properties)) = NODES.iter().find(|it| it.0 == input.name) else {
            continue;
        };
        let fed_by = (*name == "LocalPosition")
            .then(|| sources.iter().position(|it| it.class == "WorldPosition"))
            .flatten();
        let mut takers = vec![Taker { name: (*name).to_owned(), output: Output::Whole }];
        if *name == "VertexColor" {
            takers[0].output = Output::Rgb;
            takers.push(Taker { name: "VertexAlpha".to_owned(), output: Output::Alpha });
        }
        sources.push(Source {
            class,
            id: (*name).to_owned(),
            properties: properties.lines().map(str::to_owned).collect(),
            fed_by,
            takers,
        });
    }
    let mut text = custom(request, class, arguments, shader, &sources);
    for (index, source) in sources.iter().enumerate() {
        text += &node(request, index, source, &sources);
    }
    text
}

/// The node of a parameter.
fn parameter(request: &PackageRequest<'_>, index: usize, argument: &Argument<'_>) -> Source {
    let described = argument.described;
    let numbers = shown_default(argument, request.look.color_space);
    let mut properties = Vec::new();
    let class = if argument.kind.is_scalar() {
        properties.push(format!("DefaultValue={}", number(numbers[0])));
        let is_switch = argument.kind == ArgumentKind::Switch;
        let range = if is_switch { Some((0.0, 1.0)) } else { described.min.zip(described.max) };
        if let Some((least, most)) = range {
            properties.push(format!("SliderMin={}", number(least)));
            properties.push(format!("SliderMax={}", number(most)));
        }
        "ScalarParameter"
    } else {
        let [r, g, b, a] = numbers.map(number);
        properties.push(format!("DefaultValue=(R={r},G={g},B={b},A={a})"));
        "VectorParameter"
    };
    properties.push(format!("ParameterName={}", quoted(argument.name)));
    properties
        .push(format!("ExpressionGUID={}", id(request, &format!("parameter {}", argument.name))));
    if !described.group.is_empty() {
        properties.push(format!("Group={}", quoted(&described.group)));
    }
    properties.push(format!("SortPriority={index}"));
    properties.push(format!("Desc={}", quoted(&help(argument))));
    let mut takers = vec![Taker {
        name: argument.input.clone(),
        output: if argument.kind.is_scalar() { Output::Whole } else { Output::Rgb },
    }];
    if argument.kind.count() == 4 {
        takers.push(Taker { name: format!("{}A", argument.input), output: Output::Alpha });
    }
    Source { class, id: argument.name.to_owned(), properties, fed_by: None, takers }
}

/// The node of an image: a texture that instances of the material may change.
fn texture(request: &PackageRequest<'_>, image: &UnrealImage<'_>) -> Source {
    let (class, asset) = (image.asset_class(), image.asset());
    let sampler = match image.is_decoded(request.look.color_space) {
        true => "SAMPLERTYPE_Color",
        false => "SAMPLERTYPE_LinearColor",
    };
    let name = &image.texture;
    let properties = vec![
        format!("ParameterName={}", quoted(name)),
        format!("ExpressionGUID={}", id(request, &format!("parameter {name}"))),
        "Group=\"Images\"".to_owned(),
        format!("Texture=\"/Script/Engine.{class}'/Game/Chiaro/{asset}.{asset}'\""),
        format!("SamplerType={sampler}"),
    ];
    let takers = vec![Taker { name: name.clone(), output: Output::Whole }];
    Source { class: "TextureObjectParameter", id: name.clone(), properties, fed_by: None, takers }
}

/// Help of a parameter, with its unit.
fn help(argument: &Argument<'_>) -> String {
    let described = argument.described;
    let mut text =
        if described.help.is_empty() { &described.label } else { &described.help }.clone();
    if text.is_empty() {
        argument.name.clone_into(&mut text);
    }
    if !described.options.is_empty() {
        let options = described.options.iter().enumerate();
        let options: Vec<String> =
            options.map(|(index, option)| format!("{index} {option}")).collect();
        let _ = write!(text, " ({})", options.join(", "));
    }
    if !described.unit.is_empty() {
        let _ = write!(text, " ({})", described.unit);
    }
    text
}

/// The Custom node.
fn custom(
    request: &PackageRequest<'_>,
    class: &str,
    arguments: &[Argument<'_>],
    shader: &UnrealShader<'_>,
    sources: &[Source],
) -> String {
    let mut properties = vec![
        format!("Code={}", quoted(&code(class, arguments, shader))),
        "OutputType=CMOT_Float3".to_owned(),
        format!("Description={}", quoted(request.title)),
    ];
    let takers = || {
        sources.iter().enumerate().flat_map(|(index, source)| {
            source.takers.iter().map(move |taker| (index, source, taker))
        })
    };
    for (input, (index, source, taker)) in takers().enumerate() {
        properties.push(format!(
            "Inputs({input})=(InputName=\"{}\",Input=(Expression={}{}))",
            taker.name,
            expression_of(index, source),
            taker.output.mask()
        ));
    }
    properties.push("AdditionalOutputs(0)=(OutputName=\"Opacity\",OutputType=CMOT_Float1)".into());
    properties.push(format!("IncludeFilePaths(0)=\"{}\"", include_path(request)));
    let mut pins = String::new();
    for (index, _, taker) in takers() {
        let link = format!(
            "MaterialGraphNode_{index} {}",
            output_id(request, &sources[index], taker.output)
        );
        let own = id(request, &format!("input {}", taker.name));
        pins += &pin(&own, &taker.name, "PinType.PinCategory=\"required\"", &[link]);
    }
    for name in ["return", "Opacity"] {
        let own = id(request, &format!("output {name}"));
        pins += &pin(&own, name, "Direction=\"EGPD_Output\",PinType.PinCategory=\"\"", &[]);
    }
    object(request, "MaterialGraphNode_Custom", "Custom", 0, (-400, 0), &properties, &pins)
}

/// The path that the Custom node includes.
pub(super) fn include_path(request: &PackageRequest<'_>) -> String {
    format!("/Engine/Private/Chiaro/{}.ush", request.stem)
}

/// The code of the Custom node.
fn code(class: &str, arguments: &[Argument<'_>], shader: &UnrealShader<'_>) -> String {
    let mut text = format!("{class}::PixelInUnreal pixel;\n");
    for input in &shader.inputs {
        let _ = writeln!(text, "pixel.{} = {};", input.name, input.value);
    }
    let value = |argument: &Argument<'_>| match argument.kind.count() {
        2 => format!("{}.xy", argument.input),
        4 => format!("float4({0}, {0}A)", argument.input),
        _ => argument.input.clone(),
    };
    let values = arguments.iter().map(value).chain(images::arguments(&shader.images));
    let values: String = values.map(|value| value + ", ").collect();
    let _ = write!(
        text,
        "float4 color = {class}::Draw({values}pixel);\nOpacity = color.a;\nreturn color.rgb;"
    );
    text
}

/// A node that feeds the Custom node.
fn node(request: &PackageRequest<'_>, index: usize, source: &Source, sources: &[Source]) -> String {
    let mut properties = source.properties.clone();
    let mut pins = String::new();
    if let Some(feeding) = source.fed_by {
        let reference = expression_of(feeding, &sources[feeding]);
        properties.insert(0, format!("Input=(Expression={reference})"));
        let link = output_id(request, &sources[feeding], Output::Whole);
        let own = id(request, &format!("input of {}", source.id));
        let link = format!("MaterialGraphNode_{feeding} {link}");
        pins += &pin(&own, "Input", "PinType.PinCategory=\"required\"", &[link]);
    }
    let is_color = source.takers.iter().any(|taker| taker.output != Output::Whole);
    let count = if is_color { 5 } else { 1 };
    for output in 0..count {
        let mut links: Vec<String> = Vec::new();
        for taker in source.takers.iter().filter(|taker| taker.output.index() == output) {
            let own = id(request, &format!("input {}", taker.name));
            links.push(format!("MaterialGraphNode_Custom_0 {own}"));
        }
        for (fed, other) in sources.iter().enumerate() {
            if output == 0 && other.fed_by == Some(index) {
                let own = id(request, &format!("input of {}", other.id));
                links.push(format!("MaterialGraphNode_{fed} {own}"));
            }
        }
        let category = match (is_color, output) {
            (false, _) => "PinType.PinCategory=\"\"".to_owned(),
            (true, 0) => "PinType.PinCategory=\"mask\"".to_owned(),
            (true, _) => {
                let part = ["red", "green", "blue", "alpha"][output - 1];
                format!("PinType.PinCategory=\"mask\",PinType.PinSubCategory=\"{part}\"")
            }
        };
        let name = if output == 0 { "Output".to_owned() } else { format!("Output{}", output + 1) };
        let own = id(request, &format!("output {output} of {}", source.id));
        pins += &pin(&own, &name, &format!("Direction=\"EGPD_Output\",{category}"), &links);
    }
    let place = (-900, 112 * index as i32);
    object(request, "MaterialGraphNode", source.class, index, place, &properties, &pins)
}

/// A node with its expression.
fn object(
    request: &PackageRequest<'_>,
    node_class: &str,
    class: &str,
    index: usize,
    (x, y): (i32, i32),
    properties: &[String],
    pins: &str,
) -> String {
    let expression = format!("MaterialExpression{class}");
    let (name, own) = (format!("{node_class}_{index}"), format!("{expression}_{index}"));
    let mut text = format!(
        "Begin Object Class=/Script/UnrealEd.{node_class} Name=\"{name}\"\n   \
         Begin Object Class=/Script/Engine.{expression} Name=\"{own}\"\n   End Object\n   \
         Begin Object Name=\"{own}\"\n"
    );
    for property in properties {
        let _ = writeln!(text, "      {property}");
    }
    let _ = write!(
        text,
        "      MaterialExpressionEditorX={x}\n      MaterialExpressionEditorY={y}\n      \
         MaterialExpressionGuid={}\n   End Object\n   \
         MaterialExpression=\"/Script/Engine.{expression}'{own}'\"\n   \
         NodePosX={x}\n   NodePosY={y}\n   NodeGuid={}\n{pins}End Object\n",
        id(request, &format!("expression {own}")),
        id(request, &format!("node {name}")),
    );
    text
}

/// The expression of a node, as other expressions name it.
fn expression_of(index: usize, source: &Source) -> String {
    let class = format!("MaterialExpression{}", source.class);
    format!("\"/Script/Engine.{class}'MaterialGraphNode_{index}.{class}_{index}'\"")
}

/// The pin of an output.
fn output_id(request: &PackageRequest<'_>, source: &Source, output: Output) -> String {
    id(request, &format!("output {} of {}", output.index(), source.id))
}

fn pin(id: &str, name: &str, rest: &str, links: &[String]) -> String {
    let links: String = links.iter().map(|link| format!("{link},")).collect();
    let links = if links.is_empty() { links } else { format!("LinkedTo=({links}),") };
    format!("   CustomProperties Pin (PinId={id},PinName=\"{name}\",{rest},{links})\n")
}

/// An id, the same in every export.
fn id(request: &PackageRequest<'_>, name: &str) -> String {
    stable_id(request.stem, name).to_ascii_uppercase()
}

fn number(x: f64) -> String {
    format!("{x:.6}")
}

/// A text of the clipboard's.
fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\r\\n");
    format!("\"{}\"", text.replace(char::is_control, " "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_quoted() {
        assert_eq!(quoted("a \"b\"\nc\\d"), "\"a \\\"b\\\"\\r\\nc\\\\d\"");
        assert_eq!(number(0.5), "0.500000");
    }
}
