//! Formats of pictures, by the endings of their files.

use std::path::Path;

use crate::diag::Diagnostic;
use crate::files::{OutputKind, png};
use crate::film::exr::{self, ExrEncoding, ExrHeader, LosslessCompression, SampleType};
use crate::film::{DisplayView, DrawnLayers, PLAN_NOTE};

/// Format of a picture's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PictureFormat {
    /// Straight alpha as shown, 8 bits a channel.
    Png,
    /// Premultiplied light.
    Exr(ExrEncoding),
}

impl PictureFormat {
    /// The format of a path; `None` where its ending is of no known one.
    pub(super) fn of(path: &Path, encoding: ExrEncoding) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "png" => Some(Self::Png),
            "exr" => Some(Self::Exr(encoding)),
            _ => None,
        }
    }

    pub(super) fn kind(self) -> OutputKind<'static> {
        match self {
            Self::Png => OutputKind::PICTURE,
            Self::Exr(_) => exr::EXR,
        }
    }

    /// The bytes of a file. A PNG holds of the header the plan alone, and what a view shows.
    pub(super) fn encode(
        self,
        drawn: &DrawnLayers,
        header: &ExrHeader,
        view: Option<&DisplayView>,
    ) -> Result<Vec<u8>, Diagnostic> {
        match self {
            Self::Png => {
                let bytes = match view {
                    Some(view) => view.show(&drawn.picture).to_png()?,
                    None => drawn.picture.to_png()?,
                };
                let plan = &header.plan;
                Ok(if plan.is_empty() { bytes } else { png::with_note(&bytes, PLAN_NOTE, plan) })
            }
            Self::Exr(encoding) => {
                exr::encode(drawn.picture.size, &drawn.exr_layers(), header, encoding)
            }
        }
    }

    /// The plan that a whole file was drawn of; `None` for a file that is not as Chiaro wrote it.
    pub(super) fn plan_of(self, bytes: &[u8]) -> Option<String> {
        match self {
            Self::Png => {
                let note = png::note(bytes, PLAN_NOTE);
                note.filter(|_| (OutputKind::PICTURE.is_own)(bytes))
            }
            Self::Exr(_) => {
                let content = exr::decode(bytes).ok()?;
                content.plan.filter(|_| content.is_sealed)
            }
        }
    }
}

pub(super) fn parse_depth(text: &str) -> Result<SampleType, String> {
    match text {
        "half" => Ok(SampleType::Half),
        "float" => Ok(SampleType::Float),
        _ => Err("it is half or float".to_owned()),
    }
}

pub(super) fn parse_compression(text: &str) -> Result<LosslessCompression, String> {
    let found = LosslessCompression::ALL.iter().find(|(name, _)| *name == text);
    let names = LosslessCompression::ALL.map(|(name, _)| name).join(", ");
    found.map(|(_, compression)| *compression).ok_or_else(|| format!("it is one of {names}"))
}
