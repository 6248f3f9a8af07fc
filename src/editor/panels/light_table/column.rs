//! Columns of the light table: what a light is called and belongs to, what the mix does, and every
//! field that lights have.

use chiaro_locale::{spoken, tr};

use crate::document::{LightField, LightQuantity};

/// Column of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Column {
    /// Switch of the light: on, or muted.
    Shines,
    /// Switch of what shines alone.
    Solo,
    Name,
    Id,
    Kind,
    Groups,
    /// Frame of the light's vectors.
    Space,
    /// Exposure of a group's master.
    Exposure,
    Field(LightField),
}

/// Fields that stand before the others.
const FIRST: [LightField; 2] = [LightField::Intensity, LightField::Color];

impl Column {
    /// All columns, in the order of the table.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        let lead = [Self::Shines, Self::Solo, Self::Name];
        // Lights may come to have an exposure of their own, which groups then share the column of.
        let exposure = LightField::named("exposure").is_none().then_some(Self::Exposure);
        let others = LightField::ALL.into_iter().filter(|field| !FIRST.contains(field));
        lead.into_iter()
            .chain(FIRST.map(Self::Field))
            .chain(exposure)
            .chain([Self::Groups, Self::Kind])
            .chain(others.map(Self::Field))
            .chain([Self::Space, Self::Id])
    }

    /// True if the column stays at the left edge while the others are scrolled.
    pub(super) fn is_pinned(self) -> bool {
        matches!(self, Self::Shines | Self::Solo | Self::Name)
    }

    /// Field of lights that the column shows.
    pub(super) fn field(self) -> Option<LightField> {
        match self {
            Self::Field(field) => Some(field),
            _ => None,
        }
    }

    /// True if the column's cells are switches, which a click turns.
    pub(super) fn is_switch(self) -> bool {
        matches!(self, Self::Shines | Self::Solo)
    }

    /// True if the column shows colors.
    pub(super) fn is_color(self) -> bool {
        self.field().is_some_and(|field| field.quantity() == LightQuantity::Color)
    }

    /// True if numbers stand at the right edge of the column's cells.
    pub(super) fn is_number(self) -> bool {
        self == Self::Exposure || self.field().is_some_and(|field| field.range().is_some())
    }

    /// Number that Alt and an arrow key add or take away, as it is typed; `None` for a column
    /// without numbers.
    pub(super) fn nudge(self) -> Option<f64> {
        Some(match self {
            Self::Exposure => 0.25,
            Self::Field(field) => match field.quantity() {
                LightQuantity::Angle => 5.0,
                LightQuantity::Color => 0.05,
                _ => 0.1,
            },
            _ => return None,
        })
    }

    /// Word that settings keep the column by.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Shines => "shines",
            Self::Solo => "solo",
            Self::Name => "name",
            Self::Id => "id",
            Self::Kind => "type",
            Self::Groups => "groups",
            Self::Space => "space",
            Self::Exposure => "exposure of groups",
            Self::Field(field) => field.name(),
        }
    }

    /// Name of the column.
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Shines => tr!("Shines"),
            Self::Solo => tr!("Solo"),
            Self::Name => tr!("Light"),
            Self::Id => tr!("Id"),
            Self::Kind => tr!("Type"),
            Self::Groups => tr!("Groups"),
            Self::Space => tr!("light" => "Frame"),
            Self::Exposure => tr!("Exposure"),
            Self::Field(field) => field.label(),
        }
    }

    /// Text of the column's head, which is short where the column is narrow.
    pub(super) fn head(self) -> &'static str {
        match self {
            Self::Shines => tr!("On"),
            Self::Solo => tr!("S"),
            _ => self.label(),
        }
    }

    /// Help of the column, without what a click does.
    pub(super) fn help(self) -> &'static str {
        match self {
            Self::Shines => tr!("Whether it shines, or is muted"),
            Self::Solo => tr!("Whether it shines alone: a solo beats every mute"),
            Self::Name => tr!("What you call it; without a name it is called by its id"),
            Self::Id => tr!("What sets, looks and keys name it by"),
            Self::Kind => tr!("Directional lights are as far away as the sun"),
            Self::Groups => {
                tr!("Groups that it belongs to. Type +rim to add it to one, -rim to take it out")
            }
            Self::Space => tr!("What its direction and its position turn with"),
            Self::Exposure => tr!("Of a group's master, in stops: each doubles the intensity"),
            Self::Field(field) => field.help(),
        }
    }

    /// Width of the column, in points.
    pub(super) fn width(self) -> f32 {
        match self {
            Self::Shines | Self::Solo => 28.0,
            Self::Name => 146.0,
            Self::Id => 90.0,
            Self::Kind => 92.0,
            Self::Groups | Self::Space => 122.0,
            Self::Exposure => 84.0,
            Self::Field(field) => match field.quantity() {
                LightQuantity::Direction | LightQuantity::Position => 138.0,
                LightQuantity::Color => 96.0,
                _ => 94.0,
            },
        }
    }
}

/// Words within a sentence: small in English, where German keeps the capitals of its nouns.
pub(super) fn inside(words: &str) -> String {
    if spoken().is_none_or(|language| language.tag == "en") {
        words.to_lowercase()
    } else {
        words.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_has_a_column_and_no_column_stands_twice() {
        let all: Vec<Column> = Column::all().collect();
        for field in LightField::ALL {
            assert!(all.contains(&Column::Field(field)), "{}", field.name());
        }
        let mut labels: Vec<&str> = all.iter().map(|column| column.label()).collect();
        labels.sort_unstable();
        labels.dedup();
        assert_eq!(labels.len(), all.len(), "{labels:?}");
        assert!(all.iter().take(3).all(|column| column.is_pinned()), "pinned ones come first");
    }
}
