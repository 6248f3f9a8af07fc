//! Outputs of the open look that have a name as a pass (AOV): found by output, named, renamed and
//! given up.

use chiaro_locale::tr;

use crate::compile::can_be_aov;
use crate::document::{Edit, NamedAov, OutputPort};
use crate::film::{Contributions, MatteKind};
use crate::ids::{PortName, is_slug, make_slug};
use crate::state::reading::of_library;
use crate::state::session::Session;

/// Words by which `--aov` asks for other layers than one named output.
const OTHER_LAYERS: [&str; 3] = ["named", "shadows", "beauty"];

/// The passes of the open look, around one output.
#[derive(Clone, Copy)]
pub(crate) struct OutputPass<'s> {
    session: &'s Session,
    output: &'s OutputPort,
}

impl<'s> OutputPass<'s> {
    /// The pass of an output, named or not.
    pub(crate) fn of(session: &'s Session, output: &'s OutputPort) -> Self {
        Self { session, output }
    }

    /// Index of the output among the outputs that the look names.
    fn index(self) -> Option<usize> {
        let place = place_of(self.session, self.output)?;
        let is_it = |aov: &NamedAov| {
            aov.from.node == self.output.node && place_of(self.session, &aov.from) == Some(place)
        };
        self.session.look().aovs.iter().position(is_it)
    }

    /// Name of the output as a pass, where it has one.
    pub(crate) fn name(self) -> Option<&'s PortName> {
        Some(&self.session.look().aovs[self.index()?].name)
    }

    /// A free name for the output, after its node and its label.
    pub(crate) fn suggested(self) -> String {
        let [node, output] = words_of(self.session, self.output, |label| label);
        let is_free = |name: &str| self.problem_of(name).is_none();
        make_slug(&format!("{node} {output}"), |slug| !is_free(slug))
    }

    /// Edit that gives the output this name; an empty one takes the name away. `None` where
    /// nothing changes.
    ///
    /// # Errors
    /// A sentence on what keeps it from being the name.
    pub(crate) fn named(self, text: &str) -> Result<Option<Edit>, String> {
        let name = text.trim();
        let (mut aovs, own) = (self.session.look().aovs.clone(), self.index());
        if name.is_empty() {
            let Some(own) = own else { return Ok(None) };
            aovs.remove(own);
            return Ok(Some(Edit::SetAovs { aovs }));
        }
        if let Some(problem) = self.problem_of(name) {
            return Err(problem);
        }
        match own {
            Some(own) if aovs[own].name.as_str() == name => return Ok(None),
            Some(own) => aovs[own].name = name.into(),
            None => aovs.push(NamedAov { name: name.into(), from: self.output.clone() }),
        }
        Ok(Some(Edit::SetAovs { aovs }))
    }

    /// Reason why a text cannot be the output's name.
    fn problem_of(self, name: &str) -> Option<String> {
        if !is_slug(name) || name.contains('-') {
            return Some(tr!(
                "\"{name}\" is no name for a pass: letters, digits and _, no digit at first, 64 at \
                 most"
            ));
        }
        let mattes = MatteKind::all().map(|(word, kind)| (word, kind.name()));
        let is_taken = OTHER_LAYERS.contains(&name)
            || Contributions::all().any(|(word, _)| word == name)
            || mattes.into_iter().any(|(word, layer)| word == name || layer == name);
        if is_taken {
            return Some(tr!("\"{name}\" is the name of other layers of a file"));
        }
        let own = self.index();
        let mut others = self.session.look().aovs.iter().enumerate();
        let (_, other) =
            others.find(|(index, aov)| Some(*index) != own && aov.name.as_str() == name)?;
        let other = title_of(self.session, &other.from);
        Some(tr!("\"{name}\" is another pass already: {other}"))
    }
}

/// Index of an output among those of its node.
fn place_of(session: &Session, output: &OutputPort) -> Option<usize> {
    let look = session.look_with_library();
    look.catalog.of(look.node_at(&output.node)?)?.output(output.port.as_str())
}

/// Labels of an output: of its node and of the output itself, which is empty for an only output;
/// `told` gives a label of the library in the language that is wanted.
fn words_of(session: &Session, output: &OutputPort, told: fn(&str) -> &str) -> [String; 2] {
    let look = session.look_with_library();
    let kind = look.node_at(&output.node).and_then(|node| look.catalog.of(node));
    let port = kind.filter(|kind| kind.outputs.len() > 1).and_then(|kind| {
        kind.outputs
            .get(kind.output(output.port.as_str())?)
            .map(|port| told(&port.label).to_owned())
    });
    [look.title_of_path_in(&output.node, told), port.unwrap_or_default()]
}

/// Title of an output, as the canvas labels its node.
pub(crate) fn title_of(session: &Session, output: &OutputPort) -> String {
    let [node, port] = words_of(session, output, of_library);
    if port.is_empty() { node } else { format!("{node}: {port}") }
}

/// True if an output of the open graph can have a name as a pass.
pub(crate) fn can_be_named(session: &Session, output: &OutputPort) -> bool {
    let look = session.look_with_library();
    let kind = look.node_at(&output.node).and_then(|node| look.catalog.of(node));
    let kind = kind.filter(|kind| !kind.is_reroute && !kind.is_missing);
    kind.is_some_and(|kind| {
        let port = kind.output(output.port.as_str()).and_then(|index| kind.outputs.get(index));
        port.is_some_and(|port| can_be_aov(&port.ty))
    })
}
