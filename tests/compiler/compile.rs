//! Every example look compiles, for every stage and liveness, to WGSL that naga accepts and that
//! people can read.

use std::path::{Path, PathBuf};

use chiaro_compiler::compile::{
    CompileOptions, CompiledShader, Live, MAX_UNIFORM_BYTES, Stage, compile,
};
use chiaro_compiler::document::Look;
use chiaro_compiler::library::Library;

use crate::support;

fn looks() -> Vec<PathBuf> {
    let folders = ["looks", "shadows", "images", "hcbtf"]
        .map(|name| support::root().join("examples").join(name));
    let entries = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    files.sort();
    assert!(files.len() >= 10, "the example looks are gone");
    files
}

fn load(path: &Path) -> Look {
    let loaded = Look::load(&crate::support::chiaro_files::Disk, path);
    assert!(loaded.diagnostics.is_empty(), "{}: {:?}", path.display(), loaded.diagnostics);
    loaded.value.unwrap()
}

fn compiled(look: &Look, options: &CompileOptions) -> CompiledShader {
    compile(look, Library::built_in(), options)
        .unwrap_or_else(|problems| {
            let told: Vec<_> = problems.iter().map(ToString::to_string).collect();
            panic!("{} with {options:?}: {}", look.name, told.join("\n"))
        })
        .value
}

#[test]
fn the_library_has_no_problems() {
    let library = Library::built_in();
    assert!(library.problems.is_empty(), "{:?}", library.problems);
    assert!(library.nodes.len() >= 90 && library.groups.contains_key("light_layer"));
}

#[test]
fn every_look_compiles_in_every_way() {
    for path in looks() {
        let look = load(&path);
        for stage in [
            Stage::Draw,
            Stage::Normals,
            Stage::DetailNormals,
            Stage::Facets,
            Stage::HiddenFacets,
            Stage::Eval,
        ] {
            for live in [Live::Keyed, Live::Exposed, Live::All] {
                for unspecialized in [false, true] {
                    let options = CompileOptions {
                        live: live.clone(),
                        stage,
                        unspecialized,
                        ..CompileOptions::default()
                    };
                    compiled(&look, &options);
                }
            }
        }
    }
}

#[test]
fn generated_source_uses_the_artists_names() {
    let look =
        load(&looks().into_iter().find(|path| path.ends_with("figure1-layers.json")).unwrap());
    let source = compiled(&look, &CompileOptions::default()).wgsl;
    for name in ["look.key", "specular_tone", "back_light_", "fn shade(surface: Surface)"] {
        assert!(source.contains(name), "{name} is not in\n{source}");
    }
    assert!(!source.contains("@param"), "what only the editor reads is left out");
}

#[test]
fn a_byte_of_the_source_leads_to_its_node_and_back() {
    let look =
        load(&looks().into_iter().find(|path| path.ends_with("figure1-layers.json")).unwrap());
    let shader = compiled(&look, &CompileOptions::default());
    let path = chiaro_language::ids::NodePath::parse("specular/tone");
    let spans: Vec<_> = shader.spans.spans_of(&path).collect();
    assert!(!spans.is_empty());
    for span in spans {
        assert_eq!(shader.spans.node_at(span.start), Some(&path));
        assert!(shader.wgsl[span].starts_with("let specular_tone = "));
    }
}

/// A call that is read once stands where it is read, unless the artist named its node or the line
/// would become too long; each byte still leads to the node that it came from.
#[test]
fn calls_stand_where_they_are_read() {
    let look = |name: &str| {
        let text = format!(
            r#"{{"chiaro": "look", "version": 1, "name": "Sums", "nodes": [
                {{"id": "facing", "kind": "facing"}},
                {{"id": "part", "kind": "multiply", {name} "values": {{"b": 0.3}}}},
                {{"id": "sum", "kind": "add", "values": {{"b": 0.2}}}},
                {{"id": "square", "kind": "multiply"}},
                {{"id": "output", "kind": "output"}}],
              "wires": [
                {{"from": "facing", "to": "part.a"}}, {{"from": "part", "to": "sum.a"}},
                {{"from": "sum", "to": "square.a"}}, {{"from": "sum", "to": "square.b"}},
                {{"from": "square", "to": "output.color"}}]}}"#
        );
        let read = Look::read(&text, "sums.json");
        assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
        compiled(&read.value.unwrap(), &CompileOptions::default())
    };
    let shader = look("");
    let path = chiaro_language::ids::NodePath::parse;
    let text = |id: &str| -> Vec<&str> {
        let path = path(id);
        shader.spans.spans_of(&path).map(|span| &shader.wgsl[span]).collect()
    };
    assert!(!shader.wgsl.contains("let part"), "{}", shader.wgsl);
    let [part] = text("part")[..] else { panic!("{:?}", text("part")) };
    let [sum] = text("sum")[..] else { panic!("{:?}", text("sum")) };
    assert!(part.ends_with(" * 0.3") && sum == format!("let sum = {part} + 0.2;"), "{sum}");
    let whole = shader.spans.spans_of(&path("sum")).next().unwrap();
    let inner = shader.spans.spans_of(&path("part")).next().unwrap();
    assert_eq!(shader.spans.node_at(inner.end - 1), Some(&path("part")));
    assert_eq!(shader.spans.node_at(inner.start), Some(&path("facing")));
    assert_eq!(shader.spans.node_at(inner.end), Some(&path("sum")));
    assert_eq!(shader.spans.node_of(&(inner.start..inner.end + 4)), Some(&path("sum")));
    assert_eq!(shader.spans.node_of(&(whole.start..whole.end + 8)), None);
    // What several read has a name.
    assert!(shader.wgsl.contains("sum * sum"), "{}", shader.wgsl);
    let named = look(r#""name": "Half light","#).wgsl;
    assert!(named.contains("let half_light = "), "{named}");
}

/// Lines of what the looks compute are short enough to be read.
#[test]
fn lines_of_looks_are_short() {
    for path in looks() {
        let source = compiled(&load(&path), &CompileOptions::default()).wgsl;
        let shade = source.split_once("fn shade(").unwrap().1;
        let long: Vec<&str> = shade
            .lines()
            .filter(|line| line.len() > 110 && !line.trim_start().starts_with("//"))
            .collect();
        assert!(long.is_empty(), "{}: {long:?}", path.display());
    }
}

#[test]
fn what_changes_nothing_is_removed_with_its_reason() {
    let look =
        load(&looks().into_iter().find(|path| path.ends_with("figure4-color.json")).unwrap());
    let shader = compiled(&look, &CompileOptions::default());
    let reason = |path: &str| {
        let found = shader.removed.iter().find(|removal| removal.path.to_string() == path);
        found
            .unwrap_or_else(|| panic!("{path} is not removed: {:?}", shader.removed))
            .reason
            .clone()
    };
    assert_eq!(reason("diffuse/warp"), "its amount is 0");
    assert!(!shader.wgsl.contains("fn warp("), "a warp of 0 stays out of the source");
}

#[test]
fn a_look_with_many_values_keeps_its_uniform_small() {
    let mut look = Look::default();
    let mut json = String::from(
        r#"{"nodes": [{"id": "base", "kind": "base"}, {"id": "facing", "kind": "facing"}"#,
    );
    let mut wires = String::new();
    let mut from = "base".to_owned();
    for i in 0..800 {
        json += &format!(r#", {{"id": "mix{i}", "kind": "blend"}}"#);
        wires += &format!(r#"{{"from": "{from}", "to": "mix{i}.below"}}, "#);
        wires += &format!(r#"{{"from": "facing", "to": "mix{i}.tone"}}, "#);
        from = format!("mix{i}");
    }
    json += &format!(
        r#", {{"id": "output", "kind": "output"}}], "wires": [{wires}{{"from": "{from}",
            "to": "output.color"}}]}}"#
    );
    look.clone_from(Look::read(&json, "long.json").value.as_ref().unwrap());
    let shader = compiled(&look, &CompileOptions { live: Live::All, ..CompileOptions::default() });
    assert!(shader.host.size <= MAX_UNIFORM_BYTES, "{} bytes", shader.host.size);
    assert_ne!(shader.live, Live::All, "it says that fewer values are live");
}

/// A look with one broken custom node, wired to the output or not.
fn with_broken_node(is_wired: bool) -> Look {
    let from = if is_wired { "broken" } else { "base" };
    let json = format!(
        r#"{{"nodes": [{{"id": "base", "kind": "base"}},
            {{"id": "broken", "kind": "wgsl",
            "values": {{"code": "fn f() -> Color {{ return vec3f(1.0); }}"}}}},
            {{"id": "odd", "kind": "nonsense"}}, {{"id": "output", "kind": "output"}}],
            "wires": [{{"from": "{from}", "to": "output.color"}}]}}"#
    );
    Look::read(&json, "broken.json").value.unwrap()
}

#[test]
fn a_broken_node_stops_only_what_depends_on_it() {
    let look = with_broken_node(false);
    let warnings = compile(&look, Library::built_in(), &CompileOptions::default())
        .expect("it compiles")
        .warnings;
    let told = |code: &str| {
        let found = warnings.iter().find(|problem| problem.code == code);
        found.unwrap_or_else(|| panic!("{code} is not told: {warnings:?}"))
    };
    let broken = told("invalid-wgsl");
    assert!(
        broken.is_error() && broken.message.starts_with("line 1, column 11 of the code: "),
        "{broken}"
    );
    assert_eq!(broken.place.node.as_ref().map(ToString::to_string).as_deref(), Some("broken"));
    assert!(told("unknown-kind").is_error());
    let problems =
        compile(&with_broken_node(true), Library::built_in(), &CompileOptions::default())
            .unwrap_err();
    assert!(problems.iter().any(|problem| problem.code == "invalid-wgsl"), "{problems:?}");
}

#[test]
fn every_problem_is_told_at_once() {
    let json = r#"{"nodes": [
        {"id": "a", "kind": "add"}, {"id": "b", "kind": "multiply"},
        {"id": "p", "kind": "profile", "values": {"offset": "wide", "ofset": 1}},
        {"id": "x", "kind": "profil"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "a", "to": "b.a"}, {"from": "b", "to": "a.a"},
        {"from": "a", "to": "output.color"}]}"#;
    let look = Look::read(json, "wrong.json").value.unwrap();
    let problems = compile(&look, Library::built_in(), &CompileOptions::default()).unwrap_err();
    let codes: Vec<&str> = problems.iter().map(|problem| problem.code).collect();
    for code in ["cycle", "wrong-type", "unknown-port", "unknown-kind", "unwired"] {
        assert!(codes.contains(&code), "{code} is missing: {codes:?}");
    }
    let ring = problems.iter().find(|problem| problem.code == "cycle").unwrap();
    assert!(ring.message.contains("`a`, `b`"), "{ring}");
}

#[test]
fn an_exposed_input_that_reads_its_surroundings_is_told() {
    let json = r#"{"lights": {"key": {}}, "nodes": [{"id": "light", "kind": "light"},
        {"id": "angle", "kind": "parametrization"}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "light", "to": "angle.light"}, {"from": "angle", "to": "output.color"}],
        "exposed": [{"name": "normal", "target": "angle.normal"}]}"#;
    let json = json.replace(
        r#"{"from": "angle", "to": "output.color"}"#,
        r#"{"from": "tone", "to": "output.color"}"#,
    );
    let json =
        json.replace(r#"{"id": "output""#, r#"{"id": "tone", "kind": "profile"}, {"id": "output""#);
    let json =
        json.replace(r#""wires": ["#, r#""wires": [{"from": "angle", "to": "tone.angle"}, "#);
    let read = Look::read(&json, "exposed.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    let problems =
        compile(&read.value.unwrap(), Library::built_in(), &CompileOptions::default()).unwrap_err();
    assert_eq!(problems.iter().map(|problem| problem.code).collect::<Vec<_>>(), ["unset-target"]);
}

#[test]
fn images_keep_their_names() {
    let text = r#"{"chiaro": "look", "nodes": [
        {"id": "one", "name": "Image 2", "kind": "image", "values": {"image": "a.png"}},
        {"id": "two", "kind": "image", "values": {"image": "b.png", "scale": [2, 3]}},
        {"id": "both", "kind": "add"},
        {"id": "output", "kind": "output"}],
        "wires": [{"from": "one.color", "to": "both.a"}, {"from": "two.color", "to": "both.b"},
                  {"from": "both", "to": "output.color"}]}"#;
    let read = Look::read(text, "images.json");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    compiled(&read.value.unwrap(), &CompileOptions::default());
}
