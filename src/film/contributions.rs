//! Contributions of layers, lights and groups of lights to a picture, as layers of its file.

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use chiaro_locale::tr;

use crate::compile::{
    AovSource, BentLights, StackPart, StackParts, StepId, Transfer, TransferTable, check,
};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::Look;
use crate::frame::{AovRequest, Setup};
use crate::ids::{LightId, NodePath};
use crate::library::Library;
use crate::naming::{LayerNaming, free_name, legal_name};
use crate::tables::LayerTable;

/// Slices of a picture into contributions, of which each adds up to the whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contributions {
    /// By layer of the looks' stacks.
    Layers,
    /// By light.
    Lights,
    /// By group of lights.
    Groups,
    /// By light, and of each light by layer.
    LightsByLayer,
    /// By group of lights, and of each group by layer.
    GroupsByLayer,
}

/// Words of the slices, for people.
const SLICES: [(&str, Contributions); 5] = [
    ("layers", Contributions::Layers),
    ("lights", Contributions::Lights),
    ("groups", Contributions::Groups),
    ("lights-by-layer", Contributions::LightsByLayer),
    ("groups-by-layer", Contributions::GroupsByLayer),
];

/// Names for what comes of no light, of lights that cannot be told apart, and of lights that are
/// in no group.
const UNLIT: &str = "unlit";
const MIXED: &str = "mixed";
const UNGROUPED: &str = "ungrouped";

impl Contributions {
    /// The slices, each with its name for people.
    pub fn all() -> impl Iterator<Item = (&'static str, Self)> {
        SLICES.into_iter()
    }

    /// True if lights are told apart.
    fn is_by_light(self) -> bool {
        self != Self::Layers
    }

    /// The steps of a part of a stack that are told apart, each with its lights.
    fn steps<'p>(self, part: &'p StackPart) -> Vec<(StepId, &'p BTreeSet<LightId>)> {
        if !self.is_by_light() || part.shares.is_empty() {
            return vec![(part.id.clone(), &part.lights)];
        }
        let lit = |step: &'p StepId| Some((step.clone(), step.share.as_ref()?));
        part.shares.iter().filter_map(lit).collect()
    }

    /// Name of the layer that a part of a stack belongs to, by its lights and its layer.
    fn name(
        self,
        lights: &BTreeSet<LightId>,
        layer: &str,
        groups: &Groups,
        naming: LayerNaming,
    ) -> String {
        let light = match lights.iter().next() {
            None => UNLIT,
            Some(light) if lights.len() == 1 => light.as_str(),
            Some(_) => MIXED,
        };
        match self {
            Self::Layers => naming.of_layer(layer),
            Self::Lights => naming.of_light(light),
            Self::LightsByLayer => naming.of_light(&format!("{light}_{layer}")),
            Self::Groups => naming.of_group(groups.of(lights)),
            Self::GroupsByLayer => naming.of_group(&format!("{}_{layer}", groups.of(lights))),
        }
    }
}

/// Groups of a look's lights, by light.
struct Groups(HashMap<LightId, Vec<String>>);

impl Groups {
    fn new(setup: &Setup, look: &Look) -> Self {
        let lights = look.lights.iter().chain(&setup.scene.lights);
        let groups = lights.map(|(id, light)| {
            (id.clone(), light.groups.iter().map(ToString::to_string).collect())
        });
        Self(groups.collect())
    }

    /// The first group that all of these lights are in, or what stands for none.
    fn of(&self, lights: &BTreeSet<LightId>) -> &str {
        let mut lights =
            lights.iter().map(|light| self.0.get(light).map_or(&[][..], Vec::as_slice));
        let Some(first) = lights.next() else { return UNLIT };
        let rest: Vec<&[String]> = lights.collect();
        let is_of_all = |group: &&String| rest.iter().all(|groups| groups.contains(group));
        match first.iter().find(is_of_all) {
            Some(group) => group,
            None if first.is_empty() && rest.iter().all(|groups| groups.is_empty()) => UNGROUPED,
            None => MIXED,
        }
    }
}

/// Layers of contributions, with those of values that cannot be parted.
#[derive(Clone, Debug, Default)]
pub struct ContributionLayers {
    /// The sum of all contributions, each of them, and the values.
    pub layers: Vec<AovRequest>,
    /// Tables of what becomes of the values.
    pub tables: Vec<LayerTable>,
}

/// Number of a slice among those that are asked for, and a name of it: two slices may have one name
/// for two things, such as a light and a layer, which stay apart.
type SliceName = (usize, String);

/// Steps that contributions are the sums of, by the layers' names in their order and by look.
#[derive(Debug, Default)]
struct SlicedSteps {
    order: Vec<SliceName>,
    steps: HashMap<SliceName, BTreeMap<usize, BTreeSet<StepId>>>,
}

impl SlicedSteps {
    fn add(&mut self, name: SliceName, look: usize, step: StepId) {
        if !self.steps.contains_key(&name) {
            self.order.push(name.clone());
        }
        self.steps.entry(name).or_default().entry(look).or_default().insert(step);
    }

    fn requests(mut self) -> Vec<AovRequest> {
        let mut taken = HashSet::new();
        let request = |name: SliceName| {
            let of_looks = self.steps.remove(&name).unwrap_or_default();
            let source = |(look, steps)| (Some(look), AovSource::Steps(steps));
            let name = free_name(&name.1, &mut taken);
            AovRequest { name, sources: of_looks.into_iter().map(source).collect() }
        };
        std::mem::take(&mut self.order).into_iter().map(request).collect()
    }
}

/// The layers of contributions, and of their sum. Warns of looks whose stacks are followed by what
/// cannot be parted, and of sums of lights that cannot.
///
/// # Errors
/// Everything that is wrong with the looks.
pub fn contributions(
    setup: &Setup,
    library: &Library,
    time: f64,
    slices: &[Contributions],
    naming: LayerNaming,
) -> Result<WithWarnings<ContributionLayers>, Vec<Diagnostic>> {
    let mut warnings = Vec::new();
    let mut sliced = SlicedSteps::default();
    let mut found = ContributionLayers::default();
    let mut names_of_values = HashSet::new();
    let mut grades = LookGrades::default();
    for index in 0..setup.looks.len() {
        let Some(object) = setup.objects.iter().find(|object| object.looks.contains(&Some(index)))
        else {
            continue;
        };
        let look = setup.worn(index, object, library, time);
        let StackParts { parts, after, grade, bent } =
            check(&look, library, None)?.value.stack_parts();
        grades.add(&look, after.into_iter().next().zip(grade));
        if slices.iter().any(|slice| slice.is_by_light()) {
            for bent in &bent {
                let values = found.push_values(index, bent, &mut names_of_values);
                warnings.push(bends_lights(&look, bent, &values));
            }
        }
        let groups = Groups::new(setup, &look);
        let mut taken = HashSet::new();
        // Copies of a node for each light are one layer.
        let mut names: HashMap<&NodePath, String> = HashMap::new();
        // Below first, as people read a stack.
        for part in parts.iter().rev() {
            let name = names.entry(&part.id.path);
            let layer = name.or_insert_with(|| free_name(&part.name, &mut taken));
            for (number, slice) in slices.iter().enumerate() {
                for (step, lights) in slice.steps(part) {
                    let name = slice.name(lights, layer, &groups, naming);
                    sliced.add((number, name), index, step);
                }
            }
        }
    }
    let mut whole = naming.of_whole();
    if !grades.graded.is_empty() {
        whole = format!("{whole}_stack");
        found.tables.extend(grades.table(&whole));
        warnings.extend(grades.warnings(&whole));
    }
    let whole = AovRequest { name: whole, sources: vec![(None, AovSource::Stack)] };
    let values = std::mem::take(&mut found.layers);
    found.layers = std::iter::once(whole).chain(sliced.requests()).chain(values).collect();
    Ok(WithWarnings::new(found, warnings))
}

/// Layers of what goes into a node that bends the sum of lights.
struct BentValues {
    /// Names of the layers: of the one value of which all comes, or of several.
    layers: Vec<String>,
    /// The reason why there is no table.
    no_table: Option<String>,
}

impl ContributionLayers {
    /// Adds what goes into a node that bends the sum of lights of a look, with the table of one
    /// value.
    fn push_values(
        &mut self,
        look: usize,
        bent: &BentLights,
        taken: &mut HashSet<String>,
    ) -> BentValues {
        let mut push = |name: String, source: &AovSource| {
            let name = free_name(&legal_name(&name), taken);
            let sources = vec![(Some(look), source.clone())];
            self.layers.push(AovRequest { name: name.clone(), sources });
            name
        };
        let Some(source) = &bent.value else {
            let inputs = bent.inputs.iter();
            let layers = inputs
                .map(|(port, source)| push(format!("before_{}_{port}", bent.node), source))
                .collect();
            return BentValues { layers, no_table: None };
        };
        let layer = push(format!("before_{}", bent.node), source);
        let table = bent.transfer.as_ref().map_err(Clone::clone).and_then(Transfer::table);
        let table = table.map(|table| LayerTable { layer: layer.clone(), table });
        let no_table = table.map(|table| self.tables.push(table)).err();
        BentValues { layers: vec![layer], no_table }
    }
}

fn bends_lights(look: &Look, bent: &BentLights, values: &BentValues) -> Diagnostic {
    let node = &bent.node;
    let message = tr!(
        "`{node}` of `{look}` bends what several lights give together: their contributions cannot \
         be parted and stay one layer, `{MIXED}`",
        look = look.name
    );
    let hint = match (values.layers.as_slice(), &values.no_table) {
        ([], _) => tr!("let `{node}` run for each light, in a group that sums up after it"),
        ([value], None) if bent.value.is_some() => {
            tr!("the layer `{value}` is what goes into it, and {value}.cube what becomes of that")
        }
        ([value], Some(reason)) => {
            tr!("the layer `{value}` is what goes into it; it has no table, for {reason}")
        }
        (several, _) => tr!(
            "the layers `{layers}` are what goes into it; it has no table, for that is of one \
             value",
            layers = several.join("`, `")
        ),
    };
    Diagnostic::warning("not-parted", message).node(node.clone()).hint(hint)
}

/// Grades after the stacks of looks.
#[derive(Default)]
struct LookGrades {
    graded: Vec<LookGrade>,
    /// True if some look ends with its stack.
    has_plain: bool,
}

/// Grade after the stack of a look.
struct LookGrade {
    look: String,
    /// The last node of the grade.
    node: NodePath,
    /// Table of what becomes of the stack, or the reason why none says it.
    table: Result<TransferTable, String>,
}

impl LookGrades {
    fn add(&mut self, look: &Look, grade: Option<(NodePath, Result<Transfer, String>)>) {
        let Some((node, transfer)) = grade else {
            self.has_plain = true;
            return;
        };
        let table = transfer.and_then(|transfer| transfer.table());
        self.graded.push(LookGrade { look: look.name.clone(), node, table });
    }

    /// True if the looks of the picture have one grade.
    fn is_one(&self) -> bool {
        !self.has_plain && self.graded.windows(2).all(|pair| pair[0].table == pair[1].table)
    }

    /// The table of the layer that holds the stacks.
    fn table(&self, layer: &str) -> Option<LayerTable> {
        let table = self.graded.first().filter(|_| self.is_one())?.table.clone().ok()?;
        Some(LayerTable { layer: layer.to_owned(), table })
    }

    fn warnings(&self, layer: &str) -> impl Iterator<Item = Diagnostic> {
        let is_one = self.is_one();
        self.graded.iter().map(move |grade| grade.warning(layer, is_one))
    }
}

impl LookGrade {
    fn warning(&self, layer: &str, is_one: bool) -> Diagnostic {
        let Self { look, node, table } = self;
        let message =
            tr!("`{node}` changes the sum of the layers of `{look}` and cannot be parted: \
             contributions add up to what goes into it");
        let hint = match table {
            Ok(_) if is_one => tr!(
                "{layer}.cube is what becomes of `{layer}`, divided by `A`: look it up after the \
                 sum"
            ),
            Ok(_) => tr!(
                "`{layer}` has no table, for the looks of the picture are graded in different ways"
            ),
            Err(reason) => tr!("`{layer}` has no table, for {reason}"),
        };
        Diagnostic::warning("not-parted", message)
            .node(node.clone())
            .hint(hint)
            .hint(tr!("or grade the layers before they are laid over one another"))
    }
}

/// The contributions of lights by the lights' names, for a matte of them.
///
/// # Errors
/// As [`contributions`].
pub fn light_shares(
    setup: &Setup,
    library: &Library,
    time: f64,
) -> Result<Vec<AovRequest>, Vec<Diagnostic>> {
    let slices = [Contributions::Lights];
    let made = contributions(setup, library, time, &slices, LayerNaming::Bare)?.value.layers;
    // All but the sum, and values that cannot be parted.
    let is_light = |request: &AovRequest| {
        request.sources.iter().all(|(_, source)| matches!(source, AovSource::Steps(_)))
    };
    Ok(made.into_iter().filter(is_light).collect())
}
