//! Names of panels. A panel's own row is in the table of `panels`; here are the names of the panels
//! that commands open.

/// Name of a panel, as in a saved layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct PanelId(pub(crate) &'static str);

impl PanelId {
    pub(crate) const CODE: Self = Self("code");
    pub(crate) const COST: Self = Self("cost");
    pub(crate) const DIRECTIONS: Self = Self("directions");
    pub(crate) const EFFECTS: Self = Self("effects");
    pub(crate) const EXPORT: Self = Self("export");
    pub(crate) const FIT: Self = Self("fit");
    pub(crate) const GRAPH: Self = Self("graph");
    pub(crate) const HISTORY: Self = Self("history");
    pub(crate) const INSPECTOR: Self = Self("inspector");
    pub(crate) const KEYS: Self = Self("keys");
    pub(crate) const LAYERS: Self = Self("layers");
    pub(crate) const LIBRARY: Self = Self("library");
    pub(crate) const LIGHT_TABLE: Self = Self("light_table");
    pub(crate) const LIGHTS: Self = Self("lights");
    pub(crate) const LINKS: Self = Self("links");
    pub(crate) const MIXER: Self = Self("mixer");
    pub(crate) const OBJECTS: Self = Self("objects");
    pub(crate) const PAINT: Self = Self("paint");
    pub(crate) const PICTURE: Self = Self("picture");
    pub(crate) const PROBE: Self = Self("probe");
    pub(crate) const PROBLEMS: Self = Self("problems");
    pub(crate) const PROFILE: Self = Self("profile");
    pub(crate) const RULES: Self = Self("rules");
    pub(crate) const SAMPLES: Self = Self("samples");
    pub(crate) const SHEET: Self = Self("sheet");
    pub(crate) const SHOT: Self = Self("shot");
    pub(crate) const SNAPSHOTS: Self = Self("snapshots");
    pub(crate) const TIMELINE: Self = Self("timeline");
    pub(crate) const VARIATIONS: Self = Self("variations");
    pub(crate) const WEDGE: Self = Self("wedge");
}
