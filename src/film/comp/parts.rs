//! Parts of a picture: which layers of a file add up to it.
//!
//! Names say which layers are of lights and which of stacks, and not whether they are all, or each
//! once: a light and its share in a layer begin alike. So the numbers decide.

use chiaro_locale::tr;

use crate::diag::Diagnostic;
use crate::exr::ExrContent;
use crate::naming::LayerNaming;

/// Steps of 16 bits by which a sum may differ from the whole, beyond one for each layer.
const MORE_STEPS: f64 = 1.0;

/// Space in which layers add up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LayerSpace {
    /// Values as shown, by the curve of sRGB.
    Display,
    /// Linear light.
    Linear,
}

impl LayerSpace {
    /// The spaces, each with its name for people.
    pub const ALL: [(&str, Self); 2] = [("display", Self::Display), ("linear", Self::Linear)];
}

/// A layer that is a part of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PicturePart {
    /// Name of the layer.
    pub layer: String,
    /// Name for people, as the light's.
    pub label: String,
}

/// Layers that add up to a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PictureParts {
    /// The layers, in the order of the alphabet.
    pub parts: Vec<PicturePart>,
    /// Name of the layer that is their sum.
    pub whole: String,
    /// Space in which they add up.
    pub space: LayerSpace,
    /// True if nodes follow the sum that the layers do not know.
    pub is_stack: bool,
}

impl PictureParts {
    /// Sets of layers that are all parts of a picture, lights first: the layers that are named, or
    /// else each set that adds up.
    ///
    /// # Errors
    /// `no-parts` where no layers add up, `mixed-spaces` where they are in several spaces.
    pub fn all_of(
        content: &ExrContent,
        named: &[String],
        space: Option<LayerSpace>,
    ) -> Result<Vec<Self>, Diagnostic> {
        let layers = color_layers(content);
        let (naming, whole) = whole_of(&layers).ok_or_else(|| {
            no_parts(tr!("it has no layer that is the sum of the others, as `beauty` is"))
        })?;
        let space = space.map_or_else(|| space_of(content), Ok)?;
        let of = |layers: Vec<String>| Self {
            parts: layers.into_iter().map(|layer| part(layer, naming)).collect(),
            is_stack: whole != naming.of_whole(),
            whole: whole.clone(),
            space,
        };
        if let Some(missing) = named.iter().find(|name| !layers.contains(name)) {
            let message = tr!("it has no layer `{missing}` of three colors");
            return Err(Diagnostic::error("no-parts", message)
                .suggest(missing, layers.iter().map(String::as_str)));
        }
        if !named.is_empty() {
            return Ok(vec![of(named.to_vec())]);
        }
        let candidates = candidates(&layers, naming, &whole);
        if candidates.is_empty() {
            return Err(no_parts(&tr!("it has no layers beside `{whole}`")));
        }
        let whole_ones = candidates.into_iter().map(of).filter(|parts| parts.is_whole(content));
        let whole_ones: Vec<Self> = whole_ones.collect();
        if whole_ones.is_empty() {
            let message = tr!("no lights and no layers of it add up to `{whole}`");
            return Err(no_parts(&message).hint(tr!("say which do: --layers light_key,light_rim")));
        }
        Ok(whole_ones)
    }

    /// Steps of 16 bits, for each layer, by which the sum differs from the whole; infinite where a
    /// layer is missing.
    pub fn error(&self, content: &ExrContent) -> f64 {
        let count = self.parts.len() as f64;
        let mut worst = 0.0_f64;
        for color in ["R", "G", "B"] {
            let of = |layer: &str| channel(content, layer, color);
            let Some(whole) = of(&self.whole) else { return f64::INFINITY };
            let parts: Option<Vec<_>> = self.parts.iter().map(|part| of(&part.layer)).collect();
            let Some(parts) = parts else { return f64::INFINITY };
            for (pixel, whole) in whole.iter().map(|x| f64::from(*x)).enumerate() {
                let (mut sum, mut greatest) = (0.0, whole.abs());
                for part in &parts {
                    let number = f64::from(part[pixel]);
                    sum += number;
                    greatest = greatest.max(number.abs());
                }
                worst = worst.max((sum - whole).abs() / step_of(greatest));
            }
        }
        worst / count.max(1.0)
    }

    /// True if the layers add up to the whole.
    pub fn is_whole(&self, content: &ExrContent) -> bool {
        let count = self.parts.len() as f64;
        self.error(content) * count <= count + MORE_STEPS
    }
}

/// Distance of numbers of 16 bits at this one.
fn step_of(number: f64) -> f64 {
    let exponent = number.max(2.0_f64.powi(-14)).log2().floor();
    (exponent - 10.0).exp2()
}

fn no_parts(reason: &str) -> Diagnostic {
    Diagnostic::error("no-parts", tr!("the picture cannot be put together: {reason}"))
        .hint(tr!("draw it with what its lights add: chiaro render SCENE -o FILE.exr --aov lights"))
}

/// Names of the layers with red, green and blue, in the order of the alphabet.
fn color_layers(content: &ExrContent) -> Vec<String> {
    let layers = content.channels.iter().filter_map(|(name, _)| name.strip_suffix(".R"));
    let has = |layer: &str, color: &str| channel(content, layer, color).is_some();
    layers.filter(|layer| has(layer, "G") && has(layer, "B")).map(str::to_owned).collect()
}

fn channel<'c>(content: &'c ExrContent, layer: &str, color: &str) -> Option<&'c [f32]> {
    let is_it = |name: &str| {
        let rest = name.strip_prefix(layer);
        rest.is_some_and(|rest| rest.strip_prefix('.') == Some(color))
    };
    let found = content.channels.iter().find(|(name, _)| is_it(name));
    found.map(|(_, numbers)| numbers.as_slice())
}

/// The scheme of names, and the layer of the sum.
fn whole_of(layers: &[String]) -> Option<(LayerNaming, String)> {
    let of = |naming: LayerNaming| {
        let whole = naming.of_whole();
        let stack = format!("{whole}_stack");
        let found = [whole, stack].into_iter().find(|name| layers.contains(name));
        found.map(|name| (naming, name))
    };
    LayerNaming::all().find_map(|(_, naming)| of(naming))
}

fn space_of(content: &ExrContent) -> Result<LayerSpace, Diagnostic> {
    let spaces = || LayerSpace::ALL.into_iter();
    match &content.layers_in {
        Some(name) => {
            spaces().find(|(known, _)| known == name).map(|(_, space)| space).ok_or_else(|| {
                let message = tr!(
                    "the layers are in several spaces ({name}), so that no sum of them is the \
                     picture"
                );
                Diagnostic::error("mixed-spaces", message)
                    .hint(tr!("let all looks of the scene blend in one space, or draw them apart"))
            })
        }
        None => Err(no_parts(tr!("its header does not say in which space its layers add up"))
            .hint(tr!("say so: --layers-in display, or linear, as its looks blend"))),
    }
}

fn part(layer: String, naming: LayerNaming) -> PicturePart {
    let beginnings = [naming.of_light(""), naming.of_layer("")];
    let label = beginnings.iter().find_map(|begins| layer.strip_prefix(begins.as_str()));
    let label = label.filter(|label| !label.is_empty()).unwrap_or(&layer).to_owned();
    PicturePart { layer, label }
}

/// Sets of layers that may be all parts of the picture, lights first.
fn candidates(layers: &[String], naming: LayerNaming, whole: &str) -> Vec<Vec<String>> {
    let mut sets: Vec<Vec<String>> = Vec::new();
    for begins in [naming.of_light(""), naming.of_layer("")] {
        let is_one = |layer: &&String| layer.starts_with(&begins) && *layer != whole;
        let all: Vec<String> = layers.iter().filter(is_one).cloned().collect();
        // A light before its shares in layers, and the shares alone.
        let extends = |long: &str, short: &str| {
            long.strip_prefix(short).is_some_and(|rest| rest.starts_with('_'))
        };
        let few = all.iter().filter(|one| !all.iter().any(|other| extends(one, other)));
        let fine = all.iter().filter(|one| !all.iter().any(|other| extends(other, one)));
        let (few, fine) = (few.cloned().collect(), fine.cloned().collect());
        for set in [all, few, fine] {
            if !set.is_empty() && !sets.contains(&set) {
                sets.push(set);
            }
        }
    }
    sets
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exr::SampleType;

    fn content(layers: &[(&str, f32)], space: Option<&str>) -> ExrContent {
        let channels = layers.iter().flat_map(|(layer, number)| {
            ["B", "G", "R"].map(|color| (format!("{layer}.{color}"), vec![*number; 2]))
        });
        let channels: Vec<_> = channels.collect();
        ExrContent {
            size: [2, 1],
            samples: vec![SampleType::Half; channels.len()],
            channels,
            plan: None,
            is_sealed: true,
            layers_in: space.map(str::to_owned),
            rate: None,
        }
    }

    fn names(content: &ExrContent) -> Vec<String> {
        let parts = PictureParts::all_of(content, &[], None).unwrap().remove(0).parts;
        parts.into_iter().map(|part| part.label).collect()
    }

    #[test]
    fn the_layers_that_add_up_are_found() {
        let lights = [("beauty", 0.75), ("light_key", 0.5), ("light_rim", 0.25)];
        assert_eq!(names(&content(&lights, Some("display"))), ["key", "rim"]);
        // Shares of a light in layers beside it, and layers that add up by themselves.
        let more = [("light_key_top", 0.5), ("light_rim_top", 0.25), ("layer_top", 0.75)];
        let both = [&lights[..], &more].concat();
        assert_eq!(names(&content(&both, Some("display"))), ["key", "rim"]);
        let shares = [&lights[..1], &more].concat();
        assert_eq!(names(&content(&shares, Some("linear"))), ["key_top", "rim_top"]);
        let layers = [("beauty", 0.75), ("layer_top", 0.75), ("light_key", 0.5)];
        assert_eq!(names(&content(&layers, Some("display"))), ["top"]);
        let karma = [("C_stack", 0.75), ("C_key", 0.5), ("C_rim", 0.25)];
        let found =
            PictureParts::all_of(&content(&karma, Some("linear")), &[], None).unwrap().remove(0);
        assert!(found.is_stack && found.space == LayerSpace::Linear && found.whole == "C_stack");
    }

    #[test]
    fn what_does_not_add_up_is_refused_with_a_way_out() {
        let odd = [("beauty", 0.75), ("light_key", 0.5), ("light_rim", 0.2)];
        let refused = |layers: &[(&str, f32)], space: Option<&str>| {
            PictureParts::all_of(&content(layers, space), &[], None).unwrap_err().to_string()
        };
        assert!(refused(&odd, Some("display")).contains("--layers"));
        assert!(refused(&odd[1..], Some("display")).contains("--aov lights"));
        assert!(refused(&odd[..1], Some("display")).contains("no layers beside"));
        assert!(refused(&odd, None).contains("--layers-in"));
        assert!(refused(&odd, Some("display, linear")).contains("several spaces"));
        let picked = ["light_key".to_owned()];
        let content = content(&odd, None);
        let found = PictureParts::all_of(&content, &picked, Some(LayerSpace::Display)).unwrap();
        assert!(found[0].parts.len() == 1 && !found[0].is_whole(&content));
        let wrong = ["light_kye".to_owned()];
        let told = PictureParts::all_of(&content, &wrong, Some(LayerSpace::Display)).unwrap_err();
        assert!(told.to_string().contains("light_key"), "{told}");
    }
}
