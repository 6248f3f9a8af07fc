//! The look's fragment shader as a function, which several entry points may call.

/// Function to linear light from colors as shown (IEC 61966-2-1).
const LINEAR_OF_SHOWN: &str = "\
fn linear_of_shown(color: vec3f) -> vec3f {
    let high = pow((color + 0.055) / 1.055, vec3f(2.4));
    return select(high, color / 12.92, color <= vec3f(0.04045));
}";

/// An entry point of fragments, taken apart.
pub(in super::super) struct FragmentEntry<'a> {
    /// Parameters, as an entry point has them.
    parameters: &'a str,
    /// The parameters as a function has them.
    plain: String,
    /// Names of the parameters.
    names: Vec<&'a str>,
    body: &'a str,
}

impl<'a> FragmentEntry<'a> {
    /// The entry point of a text that begins with it and ends with its body; `None` for another
    /// form than the compiler gives it.
    pub(in super::super) fn of(text: &'a str) -> Option<Self> {
        let rest = text.strip_prefix("fn fs_main(")?;
        let (parameters, body) = rest.split_once(") -> @location(0) vec4f {")?;
        let plain: Vec<&str> = parameters
            .split(", ")
            .map(|parameter| parameter.rsplit_once(") ").map_or(parameter, |(_, plain)| plain))
            .collect();
        let names = plain.iter().map(|it| it.split(':').next().unwrap_or_default()).collect();
        Some(Self { parameters, plain: plain.join(", "), names, body: body.trim_end() })
    }

    /// Name of the parameter that has what the vertex shader gives.
    pub(in super::super) fn surface(&self) -> Option<&'a str> {
        self.names.first().copied()
    }

    /// The function `look_color`.
    pub(in super::super) fn function(&self) -> String {
        let Self { plain, body, .. } = self;
        format!("/// The look's color: straight RGBA.\nfn look_color({plain}) -> vec4f {{{body}\n")
    }

    /// A text with the parameters of entry points, the arguments of the function and the function
    /// of colors in their places.
    pub(in super::super) fn fill(&self, text: &str) -> String {
        text.replace("PARAMETERS", self.parameters)
            .replace("ARGUMENTS", &self.names.join(", "))
            .replace("LINEAR_OF_SHOWN", LINEAR_OF_SHOWN)
    }
}
