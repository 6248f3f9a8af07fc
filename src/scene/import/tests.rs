//! Tests of the import: the tables, small graphs, hostile files.

use super::recipe::Recipe;
use super::twins::Twin;
use super::*;

/// Every recipe is one, and names kinds, ports, choices and outputs that there are.
#[test]
fn recipes_are_made_of_nodes_that_there_are() {
    let library = Library::built_in();
    let tables = [materialx_twins::TWINS, blender_twins::TWINS];
    for twin in tables.into_iter().flatten() {
        let recipe = Recipe::parse(twin.recipe).unwrap_or_else(|| panic!("{twin:?}"));
        check(twin, &recipe, library);
        let last = match &recipe {
            Recipe::Node { kind, .. } => library.nodes.get(*kind),
            _ => None,
        };
        for pair in twin.outputs.split_whitespace() {
            let port = pair.split_once('=').map(|(_, port)| port);
            let found = last.and_then(|def| def.output(port.unwrap_or_default()));
            assert!(found.is_some(), "{}: {pair}", twin.kind);
        }
    }
    for table in tables {
        let mut kinds: Vec<&str> = table.iter().map(|twin| twin.kind).collect();
        kinds.sort_unstable();
        let count = kinds.len();
        kinds.dedup();
        assert_eq!(kinds.len(), count, "one row a node");
    }
}

fn check(twin: &Twin, recipe: &Recipe<'_>, library: &Library) {
    let Recipe::Node { kind, inputs, output } = recipe else { return };
    let def = library.nodes.get(*kind);
    let def = def.unwrap_or_else(|| panic!("{}: no node {kind}", twin.kind));
    assert!(output.is_empty() || def.output(output).is_some(), "{}: {kind}.{output}", twin.kind);
    for (port, recipe) in inputs {
        let input = def.input(port).map(|index| &def.inputs[index]);
        let input = input.unwrap_or_else(|| panic!("{}: no input {kind}.{port}", twin.kind));
        if let Recipe::Value(crate::document::Value::Text(word)) = recipe
            && !input.options.is_empty()
        {
            let mut words = input.options.iter().map(|(word, _)| word.as_str());
            assert!(words.any(|it| it == word), "{}: {kind}.{port} {word}", twin.kind);
        }
        check(twin, recipe, library);
    }
}

fn materialx(body: &str) -> Result<WithWarnings<Look>, Vec<Diagnostic>> {
    let text = format!("<?xml version=\"1.0\"?>\n<materialx version=\"1.39\">{body}</materialx>");
    import_graph(&text, "graph.mtlx", GraphFile::MaterialX, Library::built_in())
}

/// The look compiles, and has no error.
fn compiles(look: &Look) {
    let read = Look::read(&look.to_text(), "look.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    let checked = crate::compile::check(look, Library::built_in(), None);
    assert!(checked.is_ok(), "{:?}\n{}", checked.err(), look.to_text());
}

#[test]
fn a_graph_with_an_interface_is_a_look_with_exposed_parameters() {
    let imported = materialx(
        r#"
        <nodegraph name="paint">
          <input name="tint" type="color3" value="0.8, 0.3, 0.1"/>
          <multiply name="shade" type="color3">
            <input name="in1" type="color3" interfacename="tint"/>
            <input name="in2" type="color3" nodename="noise"/>
          </multiply>
          <fractal3d name="noise" type="color3"><input name="octaves" type="integer" value="5"/>
          </fractal3d>
          <output name="out" type="color3" nodename="shade"/>
        </nodegraph>
        <surface_unlit name="flat" type="surfaceshader">
          <input name="emission_color" type="color3" nodegraph="paint" output="out"/>
        </surface_unlit>
        <surfacematerial name="Paint" type="material">
          <input name="surfaceshader" type="surfaceshader" nodename="flat"/>
        </surfacematerial>"#,
    )
    .unwrap();
    let look = imported.value;
    compiles(&look);
    assert_eq!(look.name, "Paint");
    assert_eq!(look.exposed[0].name.as_str(), "tint");
    let (_, note) = look.graph.notes.first().expect("a note");
    assert!(note.text.contains("fractal3d") && note.text.contains("octaves = 5"), "{note:?}");
    let codes: Vec<&str> = imported.warnings.iter().map(|it| it.code).collect();
    assert_eq!(codes, ["import-no-twin"]);
    assert!(look.graph.frames.values().any(|frame| frame.title == "paint"));
}

#[test]
fn a_surface_is_lit_by_a_light_of_the_look() {
    let imported = materialx(
        r#"<standard_surface name="S" type="surfaceshader">
          <input name="base_color" type="color3" value="0.5, 0.5, 0.5" colorspace="srgb_texture"/>
          <input name="coat" type="float" value="1"/>
        </standard_surface>"#,
    )
    .unwrap();
    compiles(&imported.value);
    assert!(imported.value.lights.contains_key("key"));
    let left = imported.warnings.iter().find(|it| it.code == "import-left-out").expect("a note");
    assert!(left.message.contains("coat") && left.place.at.is_some(), "{left:?}");
}

#[test]
fn broken_files_are_told_of_with_their_places() {
    let codes = |body: &str| materialx(body).unwrap_err()[0].code;
    assert_eq!(codes("<add"), "import-xml");
    assert_eq!(codes(""), "import-empty");
    let link = r#"<add name="a" type="float"><input name="in1" type="float" nodename="b"/></add>"#;
    let problems = materialx(&format!(r#"{link}<output name="o" nodename="a"/>"#)).unwrap_err();
    assert_eq!(problems[0].code, "import-link");
    assert!(problems[0].message.contains("`in1` of `a`") && problems[0].place.at.is_some());
    let circle = link.replace("\"b\"", "\"a\"");
    assert_eq!(codes(&format!(r#"{circle}<output name="o" nodename="a"/>"#)), "import-circle");
    let own = r#"<nodedef name="D" node="twice" type="float"/>
        <nodegraph name="G" nodedef="D"><twice name="t" type="float"/></nodegraph>
        <twice name="a" type="float"/><output name="o" nodename="a"/>"#;
    assert_eq!(codes(own), "import-deep");
    let json = |text: &str| {
        import_graph(text, "n.json", GraphFile::Blender, Library::built_in()).unwrap_err()[0].code
    };
    assert_eq!(json("{"), "import-json");
    assert_eq!(json(r#"{"nodes": []}"#), "import-empty");
    let deep = "[".repeat(100_000);
    assert_eq!(json(&deep), "import-json");
    let elements = "<a>".repeat(100_000);
    assert_eq!(codes(&elements), "import-xml");
    assert_eq!(codes(&"x".repeat(MAX_BYTES)), "too-large");
    let many = r#"<input name="i" type="float" value="1"/>"#.repeat(MAX_PORTS + 1);
    assert_eq!(codes(&format!("<add name=\"a\" type=\"float\">{many}</add>")), "too-many");
    assert_eq!(codes(&format!("<nodegraph name=\"g\">{many}</nodegraph>")), "too-many");
}

/// A chain as long as a file may have is no deep recursion.
#[test]
fn long_chains_are_read() {
    let mut body = String::from(r#"<constant name="n0" type="float"/>"#);
    for index in 1..9_000 {
        let before = index - 1;
        body += &format!(
            r#"<sin name="n{index}" type="float">
            <input name="in" type="float" nodename="n{before}"/></sin>"#
        );
    }
    body += r#"<output name="o" type="float" nodename="n8999"/>"#;
    let look = materialx(&body).unwrap().value;
    assert!(look.graph.nodes.len() > 9_000);
}

#[test]
fn nodes_of_blender_are_a_look() {
    let text = r#"{
      "material": "Toon", "links": [
        ["D", "BSDF", "S", "Shader"], ["S", "Color", "R", "Fac"], ["R", "Color", "G", "Color"],
        ["G", "Color", "O", "Surface"], ["N", "Fac", "M", "Value"], ["M", "Value", "G", "Amount"]
      ],
      "nodes": [
        {"name": "D", "kind": "ShaderNodeBsdfDiffuse", "inputs": [
          {"id": "Color", "type": "RGBA", "value": [0.8, 0.5, 0.2, 1]}],
          "outputs": [{"id": "BSDF", "type": "SHADER"}]},
        {"name": "S", "kind": "ShaderNodeShaderToRGB",
          "inputs": [{"id": "Shader", "type": "SHADER"}],
          "outputs": [{"id": "Color", "type": "RGBA"}]},
        {"name": "R", "kind": "ShaderNodeValToRGB",
          "ramp": {"interpolation": "CONSTANT", "stops": [
            {"at": 0, "color": [0.1, 0.1, 0.2, 1]}, {"at": 0.4, "color": [0.9, 0.8, 0.6, 1]}]},
          "inputs": [{"id": "Fac", "type": "VALUE", "value": 0.5}],
          "outputs": [{"id": "Color", "type": "RGBA"}, {"id": "Alpha", "type": "VALUE"}]},
        {"name": "N", "kind": "ShaderNodeTexNoise", "outputs": [{"id": "Fac", "type": "VALUE"}]},
        {"name": "M", "kind": "ShaderNodeMath",
          "settings": {"operation": "MULTIPLY", "use_clamp": true},
          "inputs": [{"id": "Value", "type": "VALUE", "value": 0.5},
                     {"id": "Value_001", "type": "VALUE", "value": 3}],
          "outputs": [{"id": "Value", "type": "VALUE"}]},
        {"name": "G", "label": "Tinted", "kind": "ShaderNodeGroup", "group": "Tint",
          "inputs": [{"id": "Color", "type": "RGBA"}, {"id": "Amount", "type": "VALUE"}],
          "outputs": [{"id": "Color", "type": "RGBA"}]},
        {"name": "O", "kind": "ShaderNodeOutputMaterial",
          "inputs": [{"id": "Surface", "type": "SHADER"}]}
      ],
      "groups": {"Tint": {"links": [
          ["in", "Color", "mix", "A_Color"], ["in", "Amount", "mix", "Factor_Float"],
          ["mix", "Result_Color", "out", "Color"]],
        "nodes": [
          {"name": "in", "kind": "NodeGroupInput", "outputs": [{"id": "Color", "type": "RGBA"}]},
          {"name": "mix", "kind": "ShaderNodeMix",
            "settings": {"data_type": "RGBA", "blend_type": "MULTIPLY", "clamp_factor": true},
            "inputs": [{"id": "Factor_Float", "type": "VALUE", "value": 0.5},
                       {"id": "A_Color", "type": "RGBA", "value": [0.5, 0.5, 0.5, 1]},
                       {"id": "B_Color", "type": "RGBA", "value": [1, 0.5, 0.5, 1]}],
            "outputs": [{"id": "Result_Color", "type": "RGBA"}]},
          {"name": "out", "kind": "NodeGroupOutput", "inputs": [{"id": "Color", "type": "RGBA"}]}
        ]}}
    }"#;
    let imported = import_graph(text, "t.json", GraphFile::Blender, Library::built_in()).unwrap();
    compiles(&imported.value);
    let look = &imported.value;
    assert_eq!(look.graph.notes.len(), 1);
    let kinds: Vec<&str> = look.graph.nodes.values().map(|node| node.kind.as_str()).collect();
    for kind in ["ramp", "reflectance", "clamp_range", "mix_values"] {
        assert!(kinds.contains(&kind), "{kinds:?}");
    }
    assert!(look.graph.frames.values().any(|frame| frame.title == "Tinted"));
}

/// The documentation lists every kind and operation.
#[test]
fn the_documentation_names_every_row() {
    let docs = include_str!("../../../docs/imports.md");
    let listed = |name: &str| {
        let part = docs.split("<!-- twins: ").find(|part| part.starts_with(name));
        let end = part.and_then(|part| part.split("<!-- end -->").next());
        end.expect("a list").to_owned()
    };
    for (name, twins) in [("materialx", materialx_twins::TWINS), ("blender", blender_twins::TWINS)]
    {
        let list = listed(name);
        for twin in twins {
            let kind = twin.kind.strip_prefix("ShaderNode").unwrap_or(twin.kind);
            let (kind, operation) = kind.split_once(':').unwrap_or((kind, ""));
            let kind = kind.split(['.', '>']).next().unwrap_or_default();
            let is_own = ["mean", "luminance"].contains(&kind) && name == "blender";
            assert!(is_own || list.contains(&format!("`{kind}`")), "{kind} in docs/imports.md");
            let is_told = name == "materialx" || list.contains(operation);
            assert!(is_told, "{kind}: {operation} in docs/imports.md");
        }
    }
}

/// A note never lies under a node, also where several stand-ins share a column.
#[test]
fn notes_have_room_above_their_nodes() {
    let noises: String = (0..3)
        .map(|index| {
            format!(
                "<noise3d name=\"cloud_{index}\" type=\"float\">\
                 <input name=\"amplitude\" type=\"float\" value=\"0.{index}\"/>\
                 <input name=\"pivot\" type=\"float\" value=\"0.5\"/></noise3d>"
            )
        })
        .collect();
    let imported = materialx(&format!(
        r#"{noises}
        <combine3 name="all" type="color3">
          <input name="in1" type="float" nodename="cloud_0"/>
          <input name="in2" type="float" nodename="cloud_1"/>
          <input name="in3" type="float" nodename="cloud_2"/>
        </combine3>
        <surface_unlit name="flat" type="surfaceshader">
          <input name="emission_color" type="color3" nodename="all"/>
        </surface_unlit>"#
    ));
    let look = imported.expect("a look").value;
    assert_eq!(look.graph.notes.len(), 3);
    for (id, note) in &look.graph.notes {
        let lines = note.text.lines().count() as f64;
        let end = note.position[1] + 15.0 * lines;
        assert!(look.graph.nodes[id.as_str()].position[1] >= end, "{note:?}");
        let above = look.graph.nodes.values().filter(|node| {
            node.position[0] == note.position[0] && node.position[1] < note.position[1]
        });
        let nearest = above.map(|node| node.position[1]).fold(f64::NEG_INFINITY, f64::max);
        assert!(nearest + 50.0 < note.position[1], "{note:?}");
    }
}

/// The mix of colors of old files is the mix.
#[test]
fn the_old_mix_of_blender_is_a_mix() {
    let text = r#"{"blender": "5.0", "material": "Old", "nodes": [
        {"name": "Mix", "kind": "ShaderNodeMixRGB", "settings": {"blend_type": "MULTIPLY",
         "use_clamp": false}, "inputs": [
          {"id": "Fac", "type": "VALUE", "value": 0.25},
          {"id": "Color1", "type": "RGBA", "value": [0.5, 0.25, 1, 1]},
          {"id": "Color2", "type": "RGBA", "value": [0.5, 0.5, 0.5, 1]}],
         "outputs": [{"id": "Color", "type": "RGBA"}]},
        {"name": "E", "kind": "ShaderNodeEmission", "inputs": [
          {"id": "Color", "type": "RGBA"}, {"id": "Strength", "type": "VALUE", "value": 1}],
         "outputs": [{"id": "Emission", "type": "SHADER"}]},
        {"name": "O", "kind": "ShaderNodeOutputMaterial",
         "inputs": [{"id": "Surface", "type": "SHADER"}]}],
      "links": [["Mix", "Color", "E", "Color"], ["E", "Emission", "O", "Surface"]]}"#;
    let imported = import_graph(text, "old.json", GraphFile::Blender, Library::built_in());
    let imported = imported.unwrap_or_else(|problems| panic!("{problems:?}"));
    assert!(imported.warnings.is_empty(), "{:?}", imported.warnings);
    compiles(&imported.value);
    let text = imported.value.to_text();
    assert!(text.contains("mix_values") && text.contains("0.25"), "{text}");
}
