//! Edits of the list of layers, as edits of the graph.

use super::super::tests::{LOOK, setup};
use super::*;
use crate::library::Library;

/// Rows with their depth, such as `>b` for one in a folder.
fn rows(look: &Look, catalog: &Catalog) -> Vec<String> {
    let rows = LayerTree::of(look, catalog).rows(|_| false);
    rows.into_iter().map(|row| format!("{}{}", ">".repeat(row.depth), row.id)).collect()
}

fn problems(look: &Look) -> Vec<String> {
    let checked = crate::compile::check(look, Library::built_in(), None);
    checked.err().unwrap_or_default().iter().map(ToString::to_string).collect()
}

fn ids(names: &[&str]) -> Vec<NodeId> {
    names.iter().map(|name| NodeId::from(*name)).collect()
}

fn place(folder: Option<&str>, at: usize) -> LayerPlace {
    LayerPlace { folder: folder.map(NodeId::from), at }
}

/// Applies an edit that must compile and be undone. Returns the look after the edit.
fn step(look: &Look, edit: Edit) -> Look {
    let mut new = look.clone();
    let inverse = new.apply(edit).unwrap();
    assert_eq!(problems(&new), [""; 0]);
    let mut back = new.clone();
    back.apply(inverse).unwrap();
    assert_eq!(back, *look, "undone");
    new
}

/// The look of the tests with light everywhere, and its folder of `b` and `a`.
fn foldered() -> (Look, Catalog, NodeId) {
    let (look, catalog) = setup(LOOK);
    let tree = LayerTree::of(&look, &catalog);
    let (id, edit) = tree.group(&look, &ids(&["a", "b"])).unwrap();
    (step(&look, edit), catalog, id)
}

/// Every move of every layer gives the order of a list after the same move, keeps the same
/// positions in use, and is undone.
#[test]
fn every_move_is_that_of_a_list() {
    for from in 0..3 {
        for to in 0..3 {
            let (look, catalog) = setup(LOOK);
            let tree = LayerTree::of(&look, &catalog);
            let mut expected = rows(&look, &catalog);
            let places = |look: &Look| {
                let of = |id: &&str| look.graph.nodes[*id].position.map(|x| x as i64);
                let mut places: Vec<_> = ["a", "b", "c"].iter().map(of).collect();
                places.sort_unstable();
                places
            };
            let gap = if to > from { to + 1 } else { to };
            let moved = ids(&[&expected[from]]);
            let Some(edit) = tree.move_to(&look, &moved, &place(None, gap)) else {
                assert_eq!(from, to);
                continue;
            };
            let new = step(&look, edit);
            let moved = expected.remove(from);
            expected.insert(to, moved);
            assert_eq!(rows(&new, &catalog), expected, "{from} to {to}");
            assert_eq!(places(&new), places(&look));
            let offset = |look: &Look| {
                look.graph.nodes["tint"].position[0] - look.graph.nodes["b"].position[0]
            };
            assert_eq!(offset(&new), offset(&look), "what feeds a layer alone goes with it");
        }
    }
}

#[test]
fn layers_are_put_in_and_taken_out_anywhere() {
    for at in 0..4 {
        let (mut look, catalog) = setup(LOOK);
        let tree = LayerTree::of(&look, &catalog);
        let node = Node { kind: "light_layer".to_owned(), ..Node::default() };
        let edits = tree.insert(&look, &place(None, at), &"new".into(), node);
        look.apply(Edit::Group { edits }).unwrap();
        let mut expected = vec!["c", "b", "a"];
        expected.insert(at, "new");
        assert_eq!(rows(&look, &catalog), expected);
        let tree = LayerTree::of(&look, &catalog);
        let layers = &tree.own().layers;
        let xs: Vec<f64> =
            layers.iter().map(|layer| look.graph.nodes[&layer.id].position[0]).collect();
        assert!(xs.windows(2).all(|pair| pair[0] - pair[1] >= STEP), "room for each: {xs:?}");
        look.apply(tree.remove(&look, &ids(&["new", "b"]))).unwrap();
        assert_eq!(rows(&look, &catalog), ["c", "a"]);
        assert!(LayerTree::of(&look, &catalog).own().ground.is_some());
    }
}

#[test]
fn a_copy_lies_over_its_original_and_is_fed_by_the_same() {
    let (look, catalog) = setup(LOOK);
    let (copies, edit) = LayerTree::of(&look, &catalog).duplicate(&look, &ids(&["b"])).unwrap();
    let look = step(&look, edit);
    assert_eq!(rows(&look, &catalog), ["c", copies[0].as_str(), "b", "a"]);
    assert!(look.graph.wire_into(&copies[0], &"convex".into()).is_some());
    let x = |id: &str| look.graph.nodes[id].position[0];
    assert!(x("b") < x(copies[0].as_str()) && x(copies[0].as_str()) < x("c"));
}

/// A folder that passes through is specialized away: its layers are the same shader as without it.
#[test]
fn a_folder_of_layers_changes_nothing_and_is_taken_away_again() {
    let (look, catalog, folder) = foldered();
    assert_eq!(folder.as_str(), "folder");
    assert_eq!(rows(&look, &catalog), ["c", "folder", ">b", ">a"]);
    let (plain, _) = setup(LOOK);
    let shader = |look: &Look| {
        let mut look = look.clone();
        // The order of nodes in a document is that of making, and no matter of the picture.
        look.graph.nodes.sort_keys();
        let typed = crate::compile::check(&look, Library::built_in(), None).unwrap().value;
        typed.stack_parts().parts.into_iter().map(|part| part.id.path.to_string()).collect()
    };
    let parts: Vec<String> = shader(&look);
    assert_eq!(parts, shader(&plain), "layers of a film are told apart in it");
    let tree = LayerTree::of(&look, &catalog);
    let open = step(&look, tree.ungroup(&look, &ids(&["folder"])).unwrap());
    assert_eq!(rows(&open, &catalog), ["c", "b", "a"]);
    for (id, node) in &plain.graph.nodes {
        assert_eq!(open.graph.nodes[id].position, node.position, "{id} lies where it lay");
    }
}

#[test]
fn layers_go_into_out_of_and_between_folders() {
    let (look, catalog, _) = foldered();
    let to = |look: &Look, moved: &[&str], to: LayerPlace| {
        let tree = LayerTree::of(look, &catalog);
        step(look, tree.move_to(look, &ids(moved), &to).unwrap())
    };
    let inside = to(&look, &["c"], place(Some("folder"), 1));
    assert_eq!(rows(&inside, &catalog), ["folder", ">b", ">c", ">a"]);
    let out = to(&inside, &["b", "a"], place(None, 1));
    assert_eq!(rows(&out, &catalog), ["folder", ">c", "b", "a"]);
    let empty = to(&out, &["c"], place(None, 0));
    assert_eq!(rows(&empty, &catalog), ["c", "folder", "b", "a"], "an empty folder stays");
    let tree = LayerTree::of(&empty, &catalog);
    let (second, edit) = tree.group(&empty, &ids(&["folder", "b"])).unwrap();
    let nested = step(&empty, edit);
    assert_eq!(rows(&nested, &catalog), ["c", "folder_2", ">folder", ">b", "a"]);
    let deep = to(&nested, &["a"], place(Some("folder"), 0));
    assert_eq!(rows(&deep, &catalog), ["c", "folder_2", ">folder", ">>a", ">b"]);
    let tree = LayerTree::of(&deep, &catalog);
    assert_eq!(tree.folders_around(&"a".into()), ids(&["folder", "folder_2"]));
    let own = tree.move_to(&deep, std::slice::from_ref(&second), &place(Some("folder"), 0));
    assert!(own.is_none(), "no folder lies in itself");
    let gone = step(&deep, tree.remove(&deep, &ids(&["folder", "a"])));
    assert_eq!(rows(&gone, &catalog), ["c", "folder_2", ">b"]);
    let both = step(&deep, tree.ungroup(&deep, &ids(&["folder_2", "folder"])).unwrap());
    assert_eq!(rows(&both, &catalog), ["c", "a", "b"]);
}

#[test]
fn keys_move_layers_through_open_folders_and_past_closed_ones() {
    let (look, catalog, folder) = foldered();
    let tree = LayerTree::of(&look, &catalog);
    let beside = |id: &str, is_up, is_closed| tree.beside(&ids(&[id]), is_up, |_| is_closed);
    assert_eq!(beside("c", false, false), Some(place(Some("folder"), 0)));
    assert_eq!(beside("c", false, true), Some(place(None, 2)));
    assert_eq!(beside("c", true, false), None);
    assert_eq!(beside("b", true, false), Some(place(None, 1)), "out, over the folder");
    assert_eq!(beside("a", false, false), Some(place(None, 2)), "out, under the folder");
    assert_eq!(beside(folder.as_str(), false, false), None);
}

#[test]
fn a_mode_isolates_a_folder_over_nothing_and_passing_through_ends_that() {
    let (look, catalog, folder) = foldered();
    let tree = LayerTree::of(&look, &catalog);
    let isolated = step(&look, tree.set_mode(&look, &folder, Some("screen")).unwrap());
    assert_eq!(isolated.graph.nodes[&folder].kind, ISOLATED);
    let tree = LayerTree::of(&isolated, &catalog);
    let ground = tree.stack_in(Some(&folder)).unwrap().ground.clone().unwrap();
    let base = &isolated.graph.nodes[&ground.node];
    assert_eq!(base.values["color"], Value::Vector(vec![0.0; 4]), "nothing below");
    assert_eq!(rows(&isolated, &catalog), ["c", "folder", ">b", ">a"]);
    let (copy, edit) = tree.duplicate(&isolated, std::slice::from_ref(&folder)).unwrap();
    let two = step(&isolated, edit);
    let all = ["c", "folder_2", ">b_2", ">a_2", "folder", ">b", ">a"];
    assert_eq!(rows(&two, &catalog), all);
    let of_two = LayerTree::of(&two, &catalog);
    let own = of_two.stack_in(Some(&copy[0])).unwrap().ground.clone().unwrap();
    assert_ne!(own, ground, "a copy has a base of its own");
    let removed = step(&two, of_two.remove(&two, &copy));
    assert_eq!(removed.graph.nodes.len(), isolated.graph.nodes.len(), "all of the copy is gone");
    let passing = step(&isolated, tree.set_mode(&isolated, &folder, None).unwrap());
    assert_eq!(passing.graph.nodes, look.graph.nodes, "as it was");
    let open = step(&isolated, tree.ungroup(&isolated, std::slice::from_ref(&folder)).unwrap());
    assert_eq!(rows(&open, &catalog), ["c", "b", "a"]);
    assert!(!open.graph.nodes.contains_key(&ground.node));
}

#[test]
fn several_folders_are_isolated_at_once() {
    let (look, catalog, folder) = foldered();
    let tree = LayerTree::of(&look, &catalog);
    let (second, edit) = tree.group(&look, &ids(&["c"])).unwrap();
    let look = step(&look, edit);
    let edits = LayerTree::set_modes(&look, &catalog, &[&folder, &second], Some("alpha"));
    let both = step(&look, Edit::Group { edits });
    assert_eq!(rows(&both, &catalog), ["folder_2", ">c", "folder", ">b", ">a"]);
    let edits = LayerTree::set_modes(&both, &catalog, &[&second, &folder], None);
    assert_eq!(step(&both, Edit::Group { edits }).graph.nodes, look.graph.nodes);
}

#[test]
fn alone_are_layers_with_what_lies_in_them_and_the_folders_around() {
    let (look, catalog, folder) = foldered();
    let tree = LayerTree::of(&look, &catalog);
    let alone = |shown: &str| {
        let muted = tree.muted_alone(&|id| id.as_str() == shown);
        let mut muted: Vec<String> =
            muted.into_iter().map(|(id, muted)| format!("{id} {muted}")).collect();
        muted.sort();
        muted
    };
    assert_eq!(alone("a"), ["a false", "b true", "c true", "folder false"]);
    assert_eq!(alone(folder.as_str()), ["c true", "folder false"], "its layers as they are");
}

#[test]
fn a_ring_and_a_folder_that_lies_on_itself_end() {
    let ring = LOOK
        .replace(r#""from": "base", "to": "a.below""#, r#""from": "c", "to": "a.below""#)
        .replace(r#""kind": "blend""#, r#""kind": "pass_through""#)
        .replace(r#""wires": ["#, r#""wires": [{"from": "c", "to": "c.inside"}, "#);
    let (look, catalog) = setup(&ring);
    assert_eq!(rows(&look, &catalog), ["c", "b", "a"]);
}

/// Layers that add and cover, over a base of an alpha.
fn painted(alpha: f64) -> (Look, Catalog) {
    let text = r#"{"nodes": [
        {"id": "base", "kind": "base", "values": {"color": [0.3, 0.2, 0.1, ALPHA]}},
        {"id": "a", "kind": "blend", "values": {"color": [0.3, 0.1, 0.05], "tone": 0.5}},
        {"id": "b", "kind": "blend",
         "values": {"color": [0.2, 0.5, 0.9], "mode": "alpha", "opacity": 0.6}},
        {"id": "c", "kind": "blend", "values": {"color": [0.1, 0.2, 0.0], "mode": "add"}},
        {"id": "output", "kind": "output"}
      ], "wires": [{"from": "base", "to": "a.below"}, {"from": "a", "to": "b.below"},
        {"from": "b", "to": "c.below"}, {"from": "c", "to": "output.color"}]}"#;
    setup(&text.replace("ALPHA", &alpha.to_string()))
}

/// The stack as it is below the Output, premultiplied, in f64 and as written.
fn stack_value(look: &Look) -> [f64; 4] {
    use crate::compile::CompileOptions;
    use crate::frame::{Assets, EvalSample, SetupLook, eval_batches};
    let source = Look::read("{}", "test").source.into();
    let look = SetupLook { look: look.clone(), source, folder: Default::default() };
    let root = Some((crate::ids::NodePath::root("c".into()), BELOW.into()));
    let options = CompileOptions { root, unspecialized: true, ..CompileOptions::default() };
    let (library, samples) = (Library::built_in(), [EvalSample::default()]);
    let batches = eval_batches(&look, library, &samples, &options, &mut Assets::default()).unwrap();
    crate::reference::evaluate(&batches[0], crate::interp::Precision::F64).unwrap()[0]
}

/// Layers that add and cover look the same in an isolated folder in *Alpha* at full opacity, over
/// what is opaque, half transparent, and nothing; a pass-through folder mixes by its opacity.
#[test]
fn a_folder_is_seen_as_its_layers_are() {
    for alpha in [1.0, 0.4, 0.0] {
        let (look, catalog) = painted(alpha);
        let tree = LayerTree::of(&look, &catalog);
        let (folder, edit) = tree.group(&look, &ids(&["b", "a"])).unwrap();
        let passing = step(&look, edit);
        let tree = LayerTree::of(&passing, &catalog);
        let isolated = step(&passing, tree.set_mode(&passing, &folder, Some("alpha")).unwrap());
        let plain = stack_value(&look);
        let near = |look: &Look, wanted: [f64; 4], bound: f64| {
            let found = stack_value(look);
            let is_near = found.iter().zip(wanted).all(|(x, y)| (x - y).abs() <= bound);
            assert!(is_near, "alpha {alpha}: {found:?}, not {wanted:?}");
        };
        near(&passing, plain, 0.0);
        near(&isolated, plain, 2e-6);
        let mut half = passing.clone();
        let edit = Edit::SetValue {
            graph: GraphId::Look,
            id: folder.clone(),
            port: mask::OPACITY.into(),
            value: Value::Number(0.25),
            index: None,
        };
        half.apply(edit).unwrap();
        let mut hidden = look.clone();
        for id in ["a", "b"] {
            hidden.graph.nodes.get_mut(id).unwrap().muted = true;
        }
        let without = stack_value(&hidden);
        let mixed = std::array::from_fn(|k| without[k] + 0.25 * (plain[k] - without[k]));
        near(&half, mixed, 1e-12);
    }
}
