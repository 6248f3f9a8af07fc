//! Bar above the tracks: play, frame rate, range, values to key. In a low panel the bar takes a few
//! rows alone, so that tracks have room below.

use chiaro_locale::tr;
use eframe::egui::{Button, ComboBox, RichText, Role, Ui, WidgetInfo};

use super::{Timeline, rows, shot_tracks, transport};
use crate::commands::Command;
use crate::document::Target;
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::state::keying::changes_in_time;
use crate::state::session::Session;
use crate::tools::PictureTools;
use crate::tools::onion::OnionSkin;
use crate::values;
use crate::widgets::menu::{self, MenuSearch};
use crate::widgets::number::{self, number_field_as};
use crate::widgets::overflow::overflowing;
use crate::widgets::text::hint;
use crate::widgets::theme;

const RATES: [f64; 7] = [8.0, 12.0, 15.0, 24.0, 25.0, 30.0, 60.0];

/// Part of a panel's height that the bar may take.
const MOST_HEIGHT: f32 = 0.34;
/// Least number of rows that the bar may take.
const LEAST_ROWS: usize = 2;

/// Part of the bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum BarPart {
    Play,
    Keys,
    Frame,
    Rate,
    Snap,
    Range,
    AddValue,
    LoopMode,
    Speed,
    WholeRange,
    Pace,
    Cache,
    Onion,
    Version,
}

impl BarPart {
    /// All parts, the most needed first.
    const ALL: [Self; 14] = [
        Self::Play,
        Self::Keys,
        Self::Frame,
        Self::Rate,
        Self::Snap,
        Self::Range,
        Self::AddValue,
        Self::LoopMode,
        Self::Speed,
        Self::WholeRange,
        Self::Pace,
        Self::Cache,
        Self::Onion,
        Self::Version,
    ];

    /// True if the bar has the part.
    fn is_there(self, timeline: &Timeline, session: &Session, can_draw: bool) -> bool {
        match self {
            // A shot has a rate of its own.
            Self::Rate => session.shot().is_none(),
            Self::WholeRange => timeline.clock.part.is_some(),
            Self::Pace | Self::Cache | Self::Onion | Self::Version => can_draw,
            _ => true,
        }
    }
}

/// Shows the buttons to play and step, the frame rate and the range.
pub(super) fn show(
    timeline: &mut Timeline,
    ui: &mut Ui,
    session: &Session,
    tools: &mut PictureTools,
    out: &mut Vec<Command>,
) {
    let can_draw = tools.playback().can_draw();
    let is_there = |part: &BarPart| part.is_there(timeline, session, can_draw);
    let parts: Vec<BarPart> = BarPart::ALL.into_iter().filter(is_there).collect();
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let rows = (ui.max_rect().height() * MOST_HEIGHT / row) as usize;
    overflowing(ui, "timeline", rows.max(LEAST_ROWS), &parts, |ui, part| match part {
        BarPart::Play => transport::buttons(timeline, ui, session, out),
        BarPart::Keys => neighbors(timeline, ui, session, out),
        BarPart::Frame => transport::frame(timeline, ui, session, out),
        BarPart::Rate => rate(timeline, ui),
        BarPart::Snap => {
            let help = tr!("Keys and the playhead stay on frames");
            ui.checkbox(&mut timeline.snaps, tr!("Snap")).on_hover_text(help);
        }
        BarPart::Range => range(timeline, ui, session),
        BarPart::AddValue => add_value(timeline, ui, session, out),
        BarPart::LoopMode => transport::mode(timeline, ui),
        BarPart::Speed => transport::speed(timeline, ui),
        BarPart::WholeRange => transport::whole_range(timeline, ui),
        BarPart::Pace => transport::pace(timeline, ui),
        BarPart::Cache => transport::cache(ui, tools.playback(), out),
        BarPart::Onion => {
            let keys = super::times(session);
            tools.of_mut::<OnionSkin>().form(ui, timeline.fps, keys);
        }
        BarPart::Version => transport::version(ui, tools),
    });
}

/// Shows the buttons that go to the keys before and after the playhead.
fn neighbors(timeline: &mut Timeline, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    for (text, name, help, way) in [
        ("⏮", tr!("Previous key"), tr!("To the key before the playhead"), -1.0),
        ("⏭", tr!("Next key"), tr!("To the key after the playhead"), 1.0),
    ] {
        let all = super::times(session).chain(shot_tracks::times(session));
        let found = timeline.neighbor(all, session, way);
        let response = ui.add_enabled(found.is_some(), Button::new(text)).on_hover_text(help);
        let is_there = found.is_some();
        response.widget_info(|| WidgetInfo::labeled(Role::Button, is_there, name));
        if let (true, Some(time)) = (response.clicked(), found) {
            timeline.go(time, out);
        }
    }
}

fn rate(timeline: &mut Timeline, ui: &mut Ui) {
    let text = |fps: f64| format!("{} fps", values::number_text(fps, 2));
    let combo = ComboBox::from_id_salt("fps").width(58.0);
    let response = menu::choice(ui, combo, text(timeline.fps), |ui| {
        for fps in RATES {
            ui.selectable_value(&mut timeline.fps, fps, text(fps));
        }
    });
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr!("Frame rate")));
    response.on_hover_text(tr!("Frames a second: what is played and snapped to"));
}

/// Shows the range that is played, and the button that brings it into view.
fn range(timeline: &mut Timeline, ui: &mut Ui, session: &Session) {
    let fps = timeline.fps;
    let before = timeline.range.map(|time| (time * fps * 100.0).round() / 100.0);
    let [mut first, mut last] = before;
    ui.label(RichText::new(tr!("timeline" => "Range")).color(theme::of(ui).dim))
        .on_hover_text(tr!("Frames that are played"));
    for (frame, name, help) in [
        (&mut first, tr!("Range from"), tr!("First frame that is played")),
        (&mut last, tr!("Range to"), tr!("Last frame that is played")),
    ] {
        // Whole frames are told without decimals.
        let text = |frame: f64, _| values::number_text(frame, 2);
        let drag = number_field_as(ui, frame, text, number::read).speed(0.2);
        let response = ui.add(drag);
        response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
        response.on_hover_text(help);
    }
    let is_range = first.is_finite() && last.is_finite() && last - first >= 1.0;
    if is_range && [first, last] != before {
        timeline.range = [first, last].map(|frame| frame / fps);
    }
    let help = tr!("Brings all keys and the range into view");
    if ui.button(tr!("timeline" => "Fit")).on_hover_text(help).clicked() {
        timeline.fit(session);
    }
}

/// Shows the menu of values that can be keyed: inputs of the selected nodes, and the lights.
fn add_value(timeline: &mut Timeline, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let texts = (tr!("Key a value"), tr!("Find a value"));
    let menu = menu::searching(ui, texts, &mut timeline.search, |ui, search| {
        for id in &session.selection.nodes {
            let kind =
                session.graph().nodes.get(id).and_then(|node| session.project.catalog.of(node));
            for port in kind.map(|kind| kind.inputs.as_slice()).unwrap_or_default() {
                if changes_in_time(&port.ty) && session.graph().wire_into(id, &port.name).is_none()
                {
                    let target = session.selection.target(id, &port.name);
                    entry((ui, search), OwnedKeys::of_look(session), &target, out);
                }
            }
        }
        if session.selection.nodes.is_empty() {
            hint(ui, tr!("Select a node to key its values."));
        }
        shot_tracks::menu((ui, search), session, out);
        // The scene's light first: it is what the picture shows.
        let owners = [Owner::Scene, Owner::Look];
        for owned in owners.into_iter().filter_map(|owner| OwnedKeys::of(session, owner)) {
            let lights = owned.look().lights.iter().filter(|(id, _)| !owned.is_replaced(id));
            for (id, light) in lights {
                for field in light.fields().map(|field| field.name().to_owned()) {
                    let target = Target::Light { light: id.clone(), field };
                    entry((ui, search), owned, &target, out);
                }
            }
        }
    });
    menu.on_hover_text(tr!("Begins a track with the value that is seen now, at the playhead"));
}

/// Shows an entry that begins a track of a value without one.
fn entry(
    (ui, search): (&mut Ui, &mut MenuSearch),
    owned: OwnedKeys<'_>,
    target: &Target,
    out: &mut Vec<Command>,
) {
    let is_new = owned.look().time_keys.iter().all(|track| track.target != *target);
    let Some(edit) = owned.keys.key_in_time(target).filter(|_| is_new) else { return };
    let [owner, what] = rows::names_of(owned, target);
    if search.entry(ui, &format!("{owner}: {what}")) {
        out.extend(owned.once(edit));
    }
}
