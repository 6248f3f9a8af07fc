//! Links between lights and objects: a light that is not linked to an object is dark there, and
//! costs it nothing.
#![cfg(feature = "gpu")]

use std::collections::BTreeSet;

use crate::support::eval::{look, renderer, scene_of, shape, told};
use crate::support::wait::block_on;
use chiaro::compile::Live;
use chiaro::document::{GroupMaster, LightLink, LightSet, Scene};
use chiaro::frame::{FramePlan, PlanOptions, Planner, Setup, SetupLook};
use chiaro::library::Library;
use glam::{DMat4, DVec3};
use serde_json::json;

/// A look of a layer for each of these lights, with the intensities; one light is keyed by time.
fn layers(intensities: [f64; 3]) -> SetupLook {
    let [key, fill, rim] = intensities;
    let layer = |id: &str, color: [f64; 3]| {
        json!({"id": id, "kind": "light_layer", "values": {"light": id, "blend": "add",
            "convex": color, "concave": color}})
    };
    look(&json!({"name": "layers",
        "lights": {
            "key": {"direction": [1, 2, 3], "intensity": key, "groups": ["set"]},
            "fill": {"direction": [-3, 0, 1], "intensity": fill, "groups": ["set"]},
            "rim": {"type": "point", "position": [0, 3, -1], "space": "world", "intensity": rim,
                "name": "Rim light"}},
        "nodes": [
            {"id": "base", "kind": "base", "values": {"color": [0.1, 0.05, 0.1, 1]}},
            layer("key", [0.5, 0.3, 0.1]), layer("fill", [0.1, 0.3, 0.5]),
            layer("rim", [0.9, 0.9, 0.9]), {"id": "output", "kind": "output"}],
        "wires": [
            {"from": "base", "to": "key.below"}, {"from": "key", "to": "fill.below"},
            {"from": "fill", "to": "rim.below"}, {"from": "rim", "to": "output.color"}]}))
}

/// Two spheres and a torus, side by side.
fn setup(looks: [SetupLook; 3]) -> Setup {
    let shapes = ["sphere", "torus", "sphere"].into_iter().zip([-1.0, 0.0, 1.0]);
    let parts = looks.into_iter().zip(shapes).map(|(look, (name, x))| {
        let (mesh, fitted) = shape(name);
        let at = DMat4::from_translation(1.1 * x * DVec3::X);
        (look, mesh, at * DMat4::from_scale(DVec3::splat(0.5)) * fitted)
    });
    scene_of(parts.collect(), Scene::default())
}

fn link(linked: &str, unlinked: &str) -> LightLink {
    let set = |text| LightSet::parse(text).unwrap();
    LightLink { linked: set(linked), unlinked: set(unlinked) }
}

fn plan(setup: &Setup, live: &Live) -> FramePlan {
    let options = PlanOptions { size: [240, 120], samples: 1, time: 0.0 };
    Planner::default()
        .plan(setup, Library::built_in(), live, &options)
        .unwrap_or_else(|problems| panic!("{}", told(&problems)))
        .value
}

fn pixels(plan: &FramePlan) -> Vec<[u32; 4]> {
    let picture = block_on(renderer().picture(plan)).unwrap_or_else(|error| panic!("{error}"));
    picture.rgba.iter().map(|pixel| pixel.map(f32::to_bits)).collect()
}

#[test]
fn a_light_that_is_not_linked_is_dark() {
    // One look on all three objects, each with its own lights, against looks without the others.
    let links = [link("key | \"Rim light\"", ""), link("*", "group:set - key"), link("", "")];
    let intensities = [[0.8, 0.0, 0.9], [0.8, 0.0, 0.9], [0.0; 3]];
    let mut linked = setup([[0.8, 0.6, 0.9]; 3].map(layers));
    let everything = pixels(&plan(&linked, &Live::Keyed));
    linked.looks.truncate(1);
    for (object, link) in linked.objects.iter_mut().zip(links) {
        object.light_link = link;
        object.looks = vec![Some(0); object.looks.len()];
    }
    // While a look is edited its values are uniforms, and nothing is left out.
    for (live, edited) in [(Live::Keyed, None), (Live::All, Some(0))] {
        linked.edited = edited;
        let together = pixels(&plan(&linked, &live));
        assert!(together != everything, "{live:?}");
        for (number, intensities) in intensities.into_iter().enumerate() {
            let mut alone = setup([intensities; 3].map(layers));
            alone.objects = vec![alone.objects[number].clone()];
            alone.edited = edited.map(|_| number);
            let alone = pixels(&plan(&alone, &live));
            let shown: Vec<_> =
                alone.iter().zip(&together).filter(|(own, _)| **own != alone[0]).collect();
            let differing = shown.iter().filter(|(own, together)| own != together).count();
            assert!(shown.len() > 1000, "{} pixels", shown.len());
            assert_eq!(differing, 0, "{live:?}, object {number}, of {} pixels", shown.len());
        }
    }
}

#[test]
fn a_light_that_is_not_linked_costs_nothing() {
    let mut linked = setup([[0.8, 0.6, 0.9]; 3].map(layers));
    linked.objects[0].light_link = link("key", "");
    linked.objects[1].light_link = link("*", "{source} - rim");
    let plan = plan(&linked, &Live::Keyed);
    let lights = |object: &str| {
        let draw = plan.draws.iter().find(|draw| draw.object.as_str() == object).unwrap();
        draw.look.host.lights().map(AsRef::as_ref).collect::<BTreeSet<&str>>()
    };
    assert_eq!(lights("object_0"), BTreeSet::from(["key"]));
    assert_eq!(lights("object_1"), BTreeSet::from(["rim"]));
    assert_eq!(lights("object_2"), BTreeSet::from(["key", "fill", "rim"]));
    let why = |what: &str| {
        let of = plan.dropped.iter().filter(|dropped| dropped.what == what);
        of.map(|dropped| dropped.why.clone()).collect::<Vec<_>>()
    };
    let words = "it does not reach the objects that wear the look: their";
    assert_eq!(
        why("light `fill`"),
        [
            format!("{words} `linked` (`key`) has it not"),
            format!("{words} `unlinked` (`{{source}} - rim`) has it")
        ]
    );
}

#[test]
fn many_links_of_one_look_are_no_more_modules_than_a_few() {
    let looks = std::array::from_fn(|_| layers([0.8, 0.6, 0.9]));
    let mut scene = setup(looks);
    let sets = ["key", "fill", "rim", "key | fill", "fill | rim", "key | rim", "*", ""];
    let first = scene.objects[0].clone();
    scene.objects = sets
        .iter()
        .enumerate()
        .map(|(number, set)| {
            let mut object = first.clone();
            object.id = format!("object_{number}").as_str().into();
            object.light_link = link(set, "");
            object.world_from_object =
                DMat4::from_translation(DVec3::X * (0.34 * number as f64 - 1.19))
                    * DMat4::from_scale(DVec3::splat(0.15));
            object
        })
        .collect();
    let together = plan(&scene, &Live::Keyed);
    let mut modules: Vec<&str> = together.draws.iter().map(|draw| &*draw.look.wgsl).collect();
    modules.sort_unstable();
    modules.dedup();
    assert!(modules.len() <= 4, "{} modules", modules.len());
    // Whether a light is left out of a module or its uniforms are 0 makes no difference.
    for (number, object) in scene.objects.iter().enumerate() {
        let mut alone = scene.clone();
        alone.objects = vec![object.clone()];
        let (own, all) = (pixels(&plan(&alone, &Live::Keyed)), pixels(&together));
        let is_own = own.iter().zip(&all).filter(|(own, _)| own[3] != 0);
        let background = own[0];
        let differing = is_own.filter(|(own, all)| **own != background && own != all).count();
        assert!(differing < 12, "{number}: {differing} pixels");
    }
}

#[test]
fn masters_mutes_and_solos_are_what_other_intensities_are() {
    let looks = |intensities| [intensities; 3].map(layers);
    let mixed = |change: &dyn Fn(&mut Scene)| {
        let mut setup = setup(looks([0.8, 0.6, 0.9]));
        change(&mut setup.scene);
        setup
    };
    let set = |text| LightSet::parse(text).unwrap();
    let master = |intensity, exposure, tint| {
        [("set".into(), GroupMaster { intensity, exposure, tint, ..GroupMaster::default() })].into()
    };
    type MixCase<'a> = (&'a dyn Fn(&mut Scene), [f64; 3]);
    let cases: [MixCase<'_>; 5] = [
        (&|scene| scene.muted = set("fill"), [0.8, 0.0, 0.9]),
        (&|scene| scene.soloed = set("\"Rim light\""), [0.0, 0.0, 0.9]),
        (&|scene| (scene.muted, scene.soloed) = (set("*"), set("group:set")), [0.8, 0.6, 0.0]),
        (&|scene| scene.light_groups = master(0.5, 1.0, [1.0; 3]), [0.8, 0.6, 0.9]),
        (&|scene| scene.light_groups = master(0.25, -1.0, [1.0; 3]), [0.1, 0.075, 0.9]),
    ];
    for (number, (change, intensities)) in cases.into_iter().enumerate() {
        for live in [Live::Keyed, Live::All] {
            let (got, wanted) = (mixed(change), setup(looks(intensities)));
            let [got, wanted] = [got, wanted].map(|setup| pixels(&plan(&setup, &live)));
            assert!(got == wanted, "case {number}, {live:?}");
        }
    }
    // A tint is of the color: what is left without red has none of it.
    let blue = mixed(&|scene| scene.light_groups = master(1.0, 0.0, [0.0, 0.0, 1.0]));
    let mut wanted = setup(looks([0.8, 0.6, 0.9]));
    for look in &mut wanted.looks {
        let lights = look.look.lights.values_mut().filter(|light| !light.groups.is_empty());
        lights.for_each(|light| light.color = [0.0, 0.0, 1.0]);
    }
    let [blue, wanted] = [blue, wanted].map(|setup| pixels(&plan(&setup, &Live::Keyed)));
    assert!(blue == wanted);
}

#[test]
fn what_is_out_costs_nothing() {
    let mut scene = setup(std::array::from_fn(|_| layers([0.8, 0.6, 0.9])));
    scene.scene.soloed = LightSet::parse("rim").unwrap();
    let plan = plan(&scene, &Live::Keyed);
    for draw in &plan.draws {
        let lights: BTreeSet<&str> = draw.look.host.lights().map(AsRef::as_ref).collect();
        assert_eq!(lights, BTreeSet::from(["rim"]));
    }
    let why = plan.dropped.iter().find(|dropped| dropped.what == "light `key`").unwrap();
    assert_eq!(why.why, "it is out: `soloed` (`rim`) has it not");
}
