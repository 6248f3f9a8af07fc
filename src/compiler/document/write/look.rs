//! Writing a look.

use super::value::{value, values};
use super::{part, top};
use crate::document::json::{Layout, Writer};
use crate::document::shape::{
    BOOKMARK, DEFINITION, DIRECTION_KEY, DIRECTION_KEYS, EXPOSED, FRAME, INTERFACE_PORT, LIGHT,
    LOOK, NODE, NOTE, TIME_KEY, TIME_KEYS, WIRE,
};
use crate::document::{
    Definition, DirectionKey, DirectionKeys, Driver, Graph, Interpolation, KeyDirection, KeyScheme,
    Light, Look, Node, Note, Tier, TimeKeys, Unknown,
};
use crate::ids::{LightId, NodeId};
use indexmap::IndexMap;

pub(super) fn look(w: &mut Writer, look: &Look) {
    let unknown = &look.unknown;
    w.shaped(Layout::Lines, &LOOK, Some(unknown), |w| {
        top(w, "look", unknown);
        w.text_unless_empty("name", &look.name);
        w.text_unless_empty("about", &look.about);
        w.word_unless("color_space", look.color_space, Default::default());
        w.word_unless("tier", look.tier, Tier::default());
        w.text_unless_empty("tuned", &look.tuned);
        lights(w, &look.lights, unknown);
        graph(w, &look.graph, unknown);
        if !look.definitions.is_empty() {
            w.member("definitions", |w| {
                w.object(Layout::Lines, |w| {
                    for (id, of_id) in &look.definitions {
                        w.member(id.as_str(), |w| definition(w, of_id));
                    }
                });
            });
        }
        w.lines("exposed", &look.exposed, |w, exposed| {
            w.shaped(
                Layout::Inline,
                &EXPOSED,
                part(Some(unknown), "exposed", Some(exposed.name.as_str())),
                |w| {
                    w.member("name", |w| w.string(exposed.name.as_str()));
                    w.member("target", |w| w.string(&exposed.target.to_string()));
                    w.text_unless_empty("label", &exposed.label);
                },
            );
        });
        w.lines("direction_keys", &look.direction_keys, direction_keys);
        w.lines("time_keys", &look.time_keys, time_keys);
    });
}

/// The member `lights`, if there are any.
pub(super) fn lights(w: &mut Writer, lights: &IndexMap<LightId, Light>, unknown: &Unknown) {
    if lights.is_empty() {
        return;
    }
    w.member("lights", |w| {
        w.object(Layout::Lines, |w| {
            for (id, of_id) in lights {
                let extras = part(Some(unknown), "lights", Some(id.as_str()));
                w.member(id.as_str(), |w| light(w, of_id, extras));
            }
        });
    });
}

fn light(w: &mut Writer, light: &Light, unknown: Option<&Unknown>) {
    let normal = Light::default();
    w.shaped(Layout::Inline, &LIGHT, unknown, |w| {
        w.text_unless_empty("name", &light.name);
        w.word_unless("type", light.kind, normal.kind);
        w.word_unless("space", light.space, normal.space);
        w.numbers_unless("direction", &light.direction, &normal.direction);
        w.numbers_unless("position", &light.position, &normal.position);
        w.numbers_unless("aim", &light.aim, &normal.aim);
        w.number_unless("inner", light.inner, normal.inner);
        w.number_unless("outer", light.outer, normal.outer);
        w.numbers_unless("color", &light.color, &normal.color);
        w.number_unless("intensity", light.intensity, normal.intensity);
        w.number_unless("half_distance", light.half_distance, normal.half_distance);
        w.number_unless("range", light.range, normal.range);
    });
}

fn graph(w: &mut Writer, graph: &Graph, unknown: &Unknown) {
    if !graph.nodes.is_empty() {
        w.member("nodes", |w| {
            w.list(Layout::Lines, &graph.nodes, |w, (id, of_id)| node(w, id, of_id));
        });
    }
    w.lines("wires", &graph.wires, |w, wire| {
        let to = wire.to.to_string();
        w.shaped(Layout::Inline, &WIRE, part(Some(unknown), "wires", Some(&to)), |w| {
            w.member("from", |w| w.string(&wire.from.to_string()));
            w.member("to", |w| w.string(&to));
        });
    });
    frames(w, graph, unknown);
    notes(w, graph, unknown);
    w.lines("bookmarks", &graph.bookmarks, |w, bookmark| {
        let extras = part(Some(unknown), "bookmarks", Some(&bookmark.key.to_string()));
        w.shaped(Layout::Inline, &BOOKMARK, extras, |w| {
            w.member("key", |w| w.number(f64::from(bookmark.key)));
            w.numbers_unless("at", &bookmark.position, &[0.0; 2]);
            w.number_unless("zoom", bookmark.zoom, 1.0);
        });
    });
}

fn notes(w: &mut Writer, graph: &Graph, unknown: &Unknown) {
    if graph.notes.is_empty() {
        return;
    }
    w.member("notes", |w| {
        w.object(Layout::Lines, |w| {
            for (id, note) in &graph.notes {
                w.member(id.as_str(), |w| {
                    w.shaped(
                        Layout::Inline,
                        &NOTE,
                        part(Some(unknown), "notes", Some(id.as_str())),
                        |w| {
                            w.text_unless_empty("text", &note.text);
                            w.numbers_unless("at", &note.position, &[0.0; 2]);
                            w.number_unless("width", note.width, Note::WIDTH);
                            w.numbers_unless("color", &note.color, &[]);
                        },
                    );
                });
            }
        });
    });
}

fn frames(w: &mut Writer, graph: &Graph, unknown: &Unknown) {
    if graph.frames.is_empty() {
        return;
    }
    w.member("frames", |w| {
        w.object(Layout::Lines, |w| {
            for (id, frame) in &graph.frames {
                w.member(id.as_str(), |w| {
                    w.shaped(
                        Layout::Inline,
                        &FRAME,
                        part(Some(unknown), "frames", Some(id.as_str())),
                        |w| {
                            w.text_unless_empty("title", &frame.title);
                            w.numbers_unless("color", &frame.color, &[]);
                            if !frame.nodes.is_empty() {
                                w.member("nodes", |w| {
                                    w.list(Layout::Inline, &frame.nodes, |w, id| {
                                        w.string(id.as_str());
                                    });
                                });
                            }
                        },
                    );
                });
            }
        });
    });
}

fn node(w: &mut Writer, id: &NodeId, node: &Node) {
    w.shaped(Layout::Inline, &NODE, Some(&node.unknown), |w| {
        w.member("id", |w| w.string(id.as_str()));
        w.member("kind", |w| w.string(&node.kind));
        w.text_unless_empty("name", &node.name);
        w.numbers_unless("at", &node.position, &[0.0; 2]);
        values(w, &node.values, &node.unknown);
        w.word_if("tier", node.tier);
        if node.muted {
            w.member("muted", |w| w.bool(true));
        }
        if node.collapsed {
            w.member("collapsed", |w| w.bool(true));
        }
    });
}

fn definition(w: &mut Writer, definition: &Definition) {
    let unknown = &definition.unknown;
    w.shaped(Layout::Lines, &DEFINITION, Some(unknown), |w| {
        w.text_unless_empty("label", &definition.label);
        w.text_unless_empty("help", &definition.help);
        for (name, ports) in [("inputs", &definition.inputs), ("outputs", &definition.outputs)] {
            w.lines(name, ports, |w, port| {
                let extras = part(Some(unknown), name, Some(port.name.as_str()));
                w.shaped(Layout::Inline, &INTERFACE_PORT, extras, |w| {
                    w.member("name", |w| w.string(port.name.as_str()));
                    for (name, text) in [("label", &port.label), ("help", &port.help)] {
                        if let Some(text) = text {
                            w.member(name, |w| w.string(text));
                        }
                    }
                    if let Some(default) = &port.default {
                        w.member("default", |w| value(w, default, part(extras, "default", None)));
                    }
                    for (name, number) in [("min", port.min), ("max", port.max)] {
                        if let Some(number) = number {
                            w.member(name, |w| w.number(number));
                        }
                    }
                });
            });
        }
        graph(w, &definition.graph, unknown);
    });
}

fn direction_keys(w: &mut Writer, keys: &DirectionKeys) {
    w.shaped(Layout::Lines, &DIRECTION_KEYS, Some(&keys.unknown), |w| {
        w.text_unless_empty("name", &keys.name);
        w.member("by", |w| match &keys.by {
            KeyDirection::View => w.string("view"),
            KeyDirection::Light(id) => {
                w.object(Layout::Inline, |w| w.member("light", |w| w.string(id.as_str())));
            }
            KeyDirection::Drivers(drivers) => {
                w.object(Layout::Inline, |w| {
                    w.member("drivers", |w| w.list(Layout::Inline, drivers, driver));
                });
            }
        });
        w.word_unless("scheme", keys.scheme, KeyScheme::default());
        w.lines("keys", &keys.keys, |w, key| direction_key(w, key, keys.by.axes()));
    });
}

fn driver(w: &mut Writer, driver: &Driver) {
    let named = |w: &mut Writer, kind: &'static str, id: &str| {
        w.object(Layout::Inline, |w| w.member(kind, |w| w.string(id)));
    };
    match driver {
        Driver::Distance => w.string("distance"),
        Driver::Facing => w.string("facing"),
        Driver::Height(light) => named(w, "height", light.as_str()),
        Driver::Near(object) => named(w, "near", object.as_str()),
        Driver::Wire(output) => named(w, "wire", &output.to_string()),
    }
}

fn direction_key(w: &mut Writer, key: &DirectionKey, axes: Option<usize>) {
    let unknown = Some(&key.unknown);
    w.shaped(Layout::Inline, &DIRECTION_KEY, unknown, |w| {
        match axes {
            Some(axes) => w.member("at", |w| w.numbers(&key.direction[..axes.min(3)])),
            None => w.member("direction", |w| w.numbers(&key.direction)),
        }
        if key.values.is_empty() {
            return;
        }
        w.member("values", |w| {
            w.object(Layout::Inline, |w| {
                for (target, of_target) in &key.values {
                    let target = target.to_string();
                    w.member(&target, |w| {
                        value(w, of_target, part(unknown, "values", Some(&target)));
                    });
                }
            });
        });
    });
}

fn time_keys(w: &mut Writer, keys: &TimeKeys) {
    w.shaped(Layout::Lines, &TIME_KEYS, Some(&keys.unknown), |w| {
        w.member("target", |w| w.string(&keys.target.to_string()));
        w.lines("keys", &keys.keys, |w, key| {
            let unknown = Some(&key.unknown);
            w.shaped(Layout::Inline, &TIME_KEY, unknown, |w| {
                w.member("time", |w| w.number(key.time));
                w.member("value", |w| value(w, &key.value, part(unknown, "value", None)));
                w.word_unless("interpolation", key.interpolation, Interpolation::default());
            });
        });
    });
}
