//! Tour of lights: three gray objects get a key, a rim and an eye light of their own; links, a
//! shadow that falls where it is wanted, and the mixer. As with every tour: the text of each step,
//! its target, the test of whether it is done, and the commands that do it.

use chiaro_locale::{text, trn};

use super::{Step, StepStart, Suggestion, TourRow, TourTexts};
use crate::commands::{Command, PanelId, SceneCommand, Switch};
use crate::document::{
    GroupMaster, Light, LightKind, LightSet, LightSpace, Object, Scene, SceneEdit,
};
use crate::fields::mix::SceneMix;
use crate::ids::{LightGroup, LightId, ObjectId};
use crate::state::session::Session;
use crate::widgets::spots::Spot;

/// The gray look, which runs for each light, and the scene of three objects that wear it.
const GRAY_LOOK: &str = include_str!("gray-look.json");
const GRAY_SCENE: &str = include_str!("gray-scene.json");

/// The tour.
pub(super) static TOUR: TourRow = TourRow {
    steps: &STEPS,
    texts: TourTexts {
        title: text!("This scene is lit"),
        made: |session| {
            let count = scene(session).map_or(0, |scene| scene.lights.len());
            trn!(
                count,
                "{count} light of the scene: each by itself, in groups, on the objects that it is \
                 for. Probe pixel and then Why lit so tells for any pixel which lights arrive \
                 there, and by which rule.",
                "{count} lights of the scene: each by itself, in groups, on the objects that it is \
                 for. Probe pixel and then Why lit so tells for any pixel which lights arrive \
                 there, and by which rule."
            )
        },
        more: text!(
            "Look through a light with O. Filters such as Blocker and Gobo have handles in the \
             picture. Shadows and outlines are values on wires: the graph draws them."
        ),
        next: &NEXT,
    },
    begin: |session| {
        let mut scene = Scene::read(GRAY_SCENE, "gray scene").value.unwrap_or_default();
        scene.name = "Three gray objects".to_owned();
        session.start_scene_around(scene, GRAY_LOOK, "gray");
    },
};

/// Suggestions at the end of the tour.
static NEXT: [Suggestion; 3] = [
    (
        text!("Probe pixel"),
        text!("Click on the picture, then open Why lit so"),
        Command::Probe(Switch::On),
    ),
    (
        text!("See the examples"),
        text!("A lit room and a comic street are among them"),
        Command::ShowStart(true),
    ),
    (text!("All shortcuts"), text!("What every key does (?)"), Command::OpenShortcuts),
];

/// Steps from gray objects to a lit scene.
static STEPS: [Step; 8] = [
    Step {
        title: text!("A light of the scene"),
        task: text!("In Lights, press Add scene light and choose In place of Key."),
        reason: text!(
            "A light of the scene shines in all of its looks. The three objects wear one gray \
             look, which runs once for each light."
        ),
        panels: &[PanelId::PICTURE, PanelId::LIGHTS],
        spots: |_| vec![Spot::AddSceneLight, Spot::Panel(PanelId::LIGHTS)],
        is_done: |session, _| light(session, "key").is_some(),
        show: |session| {
            let key = session.look().lights.get("key").cloned().unwrap_or_default();
            vec![add("key", key)]
        },
    },
    Step {
        title: text!("Where its highlight is"),
        task: text!("Press Place light above the picture, then click high on the ball."),
        reason: text!(
            "The light goes where it is brightest there. Its shadow or its terminator can say \
             where it stands, too (Shift+H, S, T over the picture). Esc leaves."
        ),
        panels: &[PanelId::PICTURE],
        spots: |_| vec![Spot::PlaceLight, Spot::Picture],
        is_done: |session, before| has_moved(session, before, "key"),
        show: |session| {
            let moved = |key: &mut Light| key.direction = [-0.35, 0.55, 0.75];
            change(session, "key", moved)
        },
    },
    Step {
        title: text!("A rim from behind"),
        task: text!(
            "Press Add scene light and choose Directional. Then double-click the end of its needle \
             in the picture: the light goes behind the figure."
        ),
        reason: text!(
            "Every directional light has a needle around what is lit, to be dragged; past the rim \
             and back it goes behind, too. Point and spot lights stand in the picture themselves, \
             with handles for cones and distances."
        ),
        panels: &[PanelId::PICTURE, PanelId::LIGHTS],
        spots: |session| match scene(session).is_some_and(|scene| scene.lights.len() > 1) {
            true => vec![Spot::Picture],
            false => vec![Spot::AddSceneLight, Spot::Panel(PanelId::LIGHTS)],
        },
        is_done: |session, _| {
            let eye = session.view.orbit.direction();
            let mut lights = scene(session).into_iter().flat_map(|scene| scene.lights.values());
            lights.any(|light| {
                light.kind == LightKind::Directional
                    && glam::DVec3::from(light.direction).dot(eye) < 0.0
            })
        },
        show: |session| {
            let rim = Light {
                name: "Rim".to_owned(),
                direction: [0.9, 0.45, -0.7],
                space: LightSpace::World,
                color: [0.55, 0.7, 1.0],
                ..Light::default()
            };
            let placed = |light: &mut Light| {
                (light.direction, light.space) = (rim.direction, rim.space);
            };
            // A light that the artist added is the one that goes behind.
            match added(session, |light| light.kind == LightKind::Directional) {
                Some(id) => change(session, id.as_str(), placed),
                None => vec![add("light", rim)],
            }
        },
    },
    Step {
        title: text!("A group, in the light table"),
        task: text!(
            "In Light table, click the new light's cell under Groups, type rim and press Enter."
        ),
        reason: text!(
            "Sets of lights name groups: group:rim is every light of it. Many cells can be \
             selected and changed at once: 0.5, *1.2, +0.1."
        ),
        panels: &[PanelId::PICTURE, PanelId::LIGHT_TABLE],
        spots: |_| vec![Spot::Panel(PanelId::LIGHT_TABLE)],
        is_done: |session, _| {
            let mut lights = scene(session).into_iter().flat_map(|scene| scene.lights.values());
            lights.any(|light| !light.groups.is_empty())
        },
        show: |session| {
            let grouped = |light: &mut Light| light.groups = vec![LightGroup::new("rim")];
            last_light(session).map_or_else(Vec::new, |id| change(session, id.as_str(), grouped))
        },
    },
    Step {
        title: text!("A light that goes along"),
        task: text!(
            "Add a scene light once more, a Point. Unfold it in Lights and choose Object as its \
             frame."
        ),
        reason: text!(
            "Each object then has it for itself, at the same place beside it: an eye light that \
             goes wherever the character goes."
        ),
        panels: &[PanelId::PICTURE, PanelId::LIGHTS],
        spots: |_| vec![Spot::AddSceneLight, Spot::Panel(PanelId::LIGHTS)],
        is_done: |session, _| own_light(session).is_some(),
        show: |session| {
            let eye = Light {
                name: "Eye".to_owned(),
                kind: LightKind::Point,
                space: LightSpace::Object,
                position: [0.2, 0.6, 1.3],
                half_distance: 0.6,
                range: 2.0,
                color: [1.0, 0.85, 0.6],
                ..Light::default()
            };
            let placed = |light: &mut Light| {
                (light.position, light.space) = (eye.position, eye.space);
                (light.half_distance, light.range) = (eye.half_distance, eye.range);
            };
            match added(session, |light| light.kind == LightKind::Point) {
                Some(id) => change(session, id.as_str(), placed),
                None => vec![add("eye", eye)],
            }
        },
    },
    Step {
        title: text!("For the figure alone"),
        task: text!(
            "In Links, choose that light at the left. Then click the dots of ball and floor: they \
             are not linked any more."
        ),
        reason: text!(
            "Links say which lights reach what, with the rule that decides. Over the picture J \
             links the chosen lights to the object at the pointer, Shift+J unlinks them."
        ),
        panels: &[PanelId::PICTURE, PanelId::LINKS],
        spots: |_| vec![Spot::Panel(PanelId::LINKS)],
        is_done: |session, before| {
            let links = |scene: &Scene| -> Vec<_> {
                scene.objects.values().map(Object::light_link).collect()
            };
            scene(session).zip(before.scene.as_ref()).is_some_and(|(a, b)| links(a) != links(b))
        },
        show: |session| {
            let id = own_light(session).unwrap_or_else(|| LightId::new("eye"));
            let unlinked =
                LightSet::parse(&format!("* - {id}")).unwrap_or_else(|_| LightSet::all());
            let objects = scene(session).into_iter().flat_map(|scene| &scene.objects).skip(1);
            let edit = |(id, object): (&ObjectId, &Object)| {
                let object = Object { linked: unlinked.clone(), ..object.clone() };
                SceneEdit::SetObject { id: id.clone(), object: Box::new(object) }
            };
            vec![edited(SceneEdit::Group { edits: objects.map(edit).collect() })]
        },
    },
    Step {
        title: text!("Its shadow, by pointing"),
        task: text!(
            "Choose Key in Lights. Press Shift+S over the picture, click on the ball, then on the \
             floor where its shadow shall fall."
        ),
        reason: text!(
            "The light goes on the line through both places. What casts shadows onto what is a \
             matter of links, too: Shadows in Links."
        ),
        panels: &[PanelId::PICTURE, PanelId::LIGHTS],
        spots: |_| vec![Spot::PlaceLight, Spot::Picture],
        is_done: |session, before| has_moved(session, before, "key"),
        show: |session| {
            let moved = |key: &mut Light| key.direction = [-0.75, 0.7, 0.25];
            change(session, "key", moved)
        },
    },
    Step {
        title: text!("The mixer"),
        task: text!("In Mixer, drag the fader of the group rim down, or solo it with S."),
        reason: text!(
            "Masters of groups multiply all of their lights: a mood is a few faders. They are the \
             scene's, and undo takes them back like anything else."
        ),
        panels: &[PanelId::PICTURE, PanelId::MIXER],
        spots: |_| vec![Spot::Panel(PanelId::MIXER)],
        is_done: |session, before| {
            let mix = |scene: &Scene| (scene.light_groups.clone(), scene.soloed.clone());
            scene(session).zip(before.scene.as_ref()).is_some_and(|(a, b)| mix(a) != mix(b))
        },
        show: |session| {
            let master = GroupMaster { intensity: 0.5, ..GroupMaster::default() };
            let mut lights = scene(session).into_iter().flat_map(|scene| scene.lights.values());
            let group = lights.find_map(|light| light.groups.first().cloned());
            let group = group.unwrap_or_else(|| LightGroup::new("rim"));
            vec![edited(SceneMix::mastering(&group, master))]
        },
    },
];

fn scene(session: &Session) -> Option<&Scene> {
    session.open_scene().map(|open_scene| open_scene.scene())
}

fn light<'s>(session: &'s Session, id: &str) -> Option<&'s Light> {
    scene(session)?.lights.get(id)
}

/// The light that was added last.
fn last_light(session: &Session) -> Option<LightId> {
    scene(session)?.lights.keys().last().cloned()
}

/// The light of a sort that was added last, besides the key.
fn added(session: &Session, is_it: impl Fn(&Light) -> bool) -> Option<LightId> {
    let lights = &scene(session)?.lights;
    let mut found = lights.iter().rev().filter(|(id, light)| id.as_str() != "key" && is_it(light));
    found.next().map(|(id, _)| id.clone())
}

/// The first light in the frame of the objects.
fn own_light(session: &Session) -> Option<LightId> {
    let mut lights = scene(session)?.lights.iter();
    lights.find(|(_, light)| light.space == LightSpace::Object).map(|(id, _)| id.clone())
}

/// True if a light stands elsewhere, or shines from elsewhere, than when the step began.
fn has_moved(session: &Session, before: &StepStart, id: &str) -> bool {
    let old = before.scene.as_ref().and_then(|scene| scene.lights.get(id));
    let place = |light: &Light| (light.direction, light.position);
    light(session, id).zip(old).is_some_and(|(now, old)| place(now) != place(old))
}

fn edited(edit: SceneEdit) -> Command {
    Command::Scene(SceneCommand::Edit(edit))
}

fn add(id: &str, light: Light) -> Command {
    edited(SceneEdit::AddLight { id: LightId::new(id), light, index: None })
}

/// Commands that change a light of the scene; none where it is not there.
fn change(session: &Session, id: &str, change: impl FnOnce(&mut Light)) -> Vec<Command> {
    let Some(mut light) = light(session, id).cloned() else { return Vec::new() };
    change(&mut light);
    vec![edited(SceneEdit::SetLight { id: LightId::new(id), light })]
}
