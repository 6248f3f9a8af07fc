//! The look as a graph of nodes that MaterialX brings along, for hosts that take no GLSL.
//!
//! The graph is not put together from a table: the look's own WGSL and its host work are followed
//! with symbols in place of numbers ([`follow`]), which makes terms of MaterialX's nodes
//! ([`terms`]), and the terms are written as XML ([`write`]). So no node has a second definition
//! that could differ from its own. What no node can express, such as an image, bits or the change
//! of a value from pixel to pixel, is the reason that a look has no graph.

mod evaluate;
mod follow;
mod intrinsics;
mod operations;
mod symbols;
mod terms;
mod write;

use self::follow::{Follower, Unfit};
use self::symbols::Symbol;
use self::terms::{Origin, TermId, Terms, Truth};
use super::super::PackageRequest;
use super::inputs::{NodeInput, fields};
use super::source::{PICTURE, Parts};
use crate::document::ColorSpace;
use crate::wgsl;

/// A look as a graph of MaterialX's nodes.
#[derive(Clone, Debug)]
pub(super) struct StandardGraph {
    /// Element of the document, with the indent of one within.
    pub(super) text: String,
    /// Number of nodes.
    pub(super) nodes: usize,
}

/// The graph of a look whose node is called `name`, or the reason why there is none: a sentence
/// without its end.
pub(super) fn graph(
    request: &PackageRequest<'_>,
    name: &str,
    inputs: &[NodeInput<'_>],
    parts: &Parts,
) -> Result<StandardGraph, String> {
    let module = wgsl::parse(&parts.wgsl).map_err(|error| error.to_string())?.module;
    let empty = naga::Function::default();
    let of_nodes = ["shade".to_owned()].into_iter().chain(parts.numbers.clone()).collect();
    let mut follower = Follower::new(&module, &empty, of_nodes);
    let found = picture(&mut follower, request, inputs, parts);
    let picture = found.map_err(|Unfit(reason)| reason)?;
    let Symbol::Number(picture) = picture else {
        return Err("the look's picture is no color".to_owned());
    };
    let terms = &mut follower.terms;
    terms.group.clear();
    let shown = [0, 1, 2].map(|place| terms.component(picture, place));
    let color = match request.look.color_space {
        ColorSpace::Display => shown.map(|channel| light_of_shown(terms, channel)),
        ColorSpace::Linear => shown,
    };
    let opacity = terms.component(picture, 3);
    let used = terms.used(&[&color[..], &[opacity]].concat());
    let asks_eye =
        used.iter().any(|id| matches!(terms.term(*id).origin, Origin::Given("eye" | "to_eye")));
    if asks_eye {
        return Err("the look asks how far the eye is, which no node tells".to_owned());
    }
    Ok(write::write(terms, name, inputs, color, opacity))
}

/// The look's color and opacity at a point of a surface.
fn picture(
    follower: &mut Follower<'_>,
    request: &PackageRequest<'_>,
    inputs: &[NodeInput<'_>],
    parts: &Parts,
) -> Result<Symbol, Unfit> {
    let eye = follower.terms.given("eye", 3);
    set(follower, "view", |terms| {
        let one = terms.number(1.0);
        let mut parts: Vec<TermId> = (0..3).map(|place| terms.component(eye, place)).collect();
        parts.push(one);
        Symbol::List(vec![Symbol::Number(terms.combine(&parts))])
    });
    if let Some(function) = &parts.numbers {
        let settings = settings(&mut follower.terms, request, inputs)?;
        let surroundings = surroundings(&mut follower.terms, eye);
        let numbers = follower.call_named(function, vec![settings, surroundings])?;
        set(follower, "look", |_| numbers);
    }
    let varyings = parts.varyings.iter().map(|name| varying(&mut follower.terms, name));
    let mut arguments = vec![Symbol::List(varyings.collect())];
    if parts.is_told_side {
        arguments.push(Symbol::Truth(Truth::Known(true)));
    }
    follower.call_named(PICTURE, arguments)
}

/// Sets a variable of the module, where it has one of this name.
fn set(follower: &mut Follower<'_>, name: &str, value: impl FnOnce(&mut Terms) -> Symbol) {
    let mut variables = follower.module.global_variables.iter();
    let found = variables.find(|(_, variable)| variable.name.as_deref() == Some(name));
    if let Some((handle, _)) = found {
        follower.memory[handle.index()] = value(&mut follower.terms);
    }
}

/// Settings of the host work: parameters, and lights.
fn settings(
    terms: &mut Terms,
    request: &PackageRequest<'_>,
    inputs: &[NodeInput<'_>],
) -> Result<Symbol, Unfit> {
    let mut values = Vec::new();
    for setting in &request.work.parameters {
        let name = setting.name.as_ref().map(|name| name.as_str());
        let is_it = |it: &NodeInput<'_>| it.light.is_none() && Some(it.name) == name;
        values.push(match inputs.iter().position(is_it) {
            Some(place) => input(terms, place, inputs[place].ty.0)?,
            None => Symbol::of_value(&setting.default, terms),
        });
    }
    for light in &request.work.lights {
        let mut own = Vec::new();
        for (field, numbers) in fields(&light.light) {
            let is_it = |it: &NodeInput<'_>| it.light == Some((&light.id, field));
            own.push(match inputs.iter().position(is_it) {
                Some(place) => input(terms, place, inputs[place].ty.0)?,
                None => Symbol::Number(terms.constant(&numbers)),
            });
        }
        values.push(Symbol::List(own));
    }
    if values.is_empty() {
        values.push(Symbol::Number(terms.number(0.0)));
    }
    Ok(Symbol::List(values))
}

/// An input of the node.
fn input(terms: &mut Terms, place: usize, ty: &str) -> Result<Symbol, Unfit> {
    let width = match ty {
        "vector2" => 2,
        "vector3" | "color3" => 3,
        "vector4" | "color4" => 4,
        _ => 1,
    };
    let input = terms.input(place, width);
    Ok(match ty {
        "boolean" => Symbol::Truth(Truth::Switch(input)),
        "integer" => Symbol::Whole(terms.converted(input, 1)),
        "color3" | "color4" => Symbol::Number(terms.converted(input, width)),
        "matrix33" => return Err(Unfit("the look is given a matrix".to_owned())),
        _ => Symbol::Number(input),
    })
}

/// Surroundings of the host work, as the function in GLSL has them.
fn surroundings(terms: &mut Terms, eye: TermId) -> Symbol {
    let mut axes = || {
        let mut column = |place: usize| {
            let mut numbers = [0.0; 3];
            numbers[place] = 1.0;
            Symbol::Number(terms.constant(&numbers))
        };
        Symbol::List((0..3).map(&mut column).collect())
    };
    let (illumination, camera, object) = (axes(), axes(), axes());
    let nowhere = Symbol::Number(terms.constant(&[0.0; 3]));
    let id = Symbol::Number(terms.number(0.0));
    let viewport = Symbol::Number(terms.constant(&[1.0; 2]));
    let time = Symbol::Number(terms.given("time", 1));
    let frame = Symbol::Number(terms.given("frame", 1));
    let eye = Symbol::Number(eye);
    Symbol::List(vec![
        illumination,
        camera,
        eye,
        nowhere.clone(),
        object,
        nowhere,
        id,
        viewport,
        time,
        frame,
    ])
}

/// A value that a vertex passes on.
fn varying(terms: &mut Terms, name: &str) -> Symbol {
    Symbol::Number(match name {
        "normal" => terms.given("normal", 3),
        "position_object" => terms.given("object_position", 3),
        "uv" => terms.given("uv", 2),
        "tangent" => {
            let normal = terms.given("normal", 3);
            let (tangent, bitangent) = (terms.given("tangent", 3), terms.given("bitangent", 3));
            let across = terms.node("crossproduct", &[normal, tangent], 3);
            let along = terms.node("dotproduct", &[across, bitangent], 1);
            let (zero, one, minus) = (terms.number(0.0), terms.number(1.0), terms.number(-1.0));
            let is_mirrored = terms.test("ifgreater", zero, along);
            let side = terms.choose(&is_mirrored, minus, one);
            let mut parts: Vec<TermId> =
                (0..3).map(|place| terms.component(tangent, place)).collect();
            parts.push(side);
            terms.combine(&parts)
        }
        _ => terms.given("position", 3),
    })
}

/// Linear light of a channel as it is shown, by the curve of sRGB.
fn light_of_shown(terms: &mut Terms, shown: TermId) -> TermId {
    let [zero, one, edge, slope, offset, scale, exponent] =
        [0.0, 1.0, 0.04045, 12.92, 0.055, 1.055, 2.4].map(|x| terms.number(x));
    let shown = terms.each("clamp", &[shown, zero, one]);
    let low = terms.each("divide", &[shown, slope]);
    let moved = terms.each("add", &[shown, offset]);
    let base = terms.each("divide", &[moved, scale]);
    let high = terms.each("power", &[base, exponent]);
    let is_high = terms.test("ifgreater", shown, edge);
    terms.choose(&is_high, high, low)
}
