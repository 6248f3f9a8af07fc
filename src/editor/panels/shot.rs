//! Shot over the scene: its frames and its step, what lies under it, and every value that it
//! changes.

use chiaro_locale::{Text, text, tr, trn};
use eframe::egui::{
    Align, Button, ComboBox, Id, Label, Layout, Popup, RichText, Role, ScrollArea, Sense, TextEdit,
    Ui, WidgetInfo,
};

use crate::commands::{Command, PanelId, SceneCommand, ShotCommand, ViewCommand, table};
use crate::document::{FrameRate, Override, ShotEdit, Target, value_address};
use crate::fields::row::{self, labelled};
use crate::fields::scene_names;
use crate::fields::shot::{self, ChangedValue};
use crate::frame::ValueChange;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::session::Session;
use crate::state::session::shot::change_text;
use crate::state::shot::{LostChange, OpenShot, ShotAddress};
use crate::widgets::menu::scrolling;
use crate::widgets::number::number_field;
use crate::widgets::text::hint;
use crate::widgets::text::is_typed;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::SHOT,
    text!("Shot"),
    text!("The open shot: its frames, what it lies over, and every value that it changes"),
    PanelPlace::WITH_DOCUMENT.closed(),
    |_, ui, context| show(ui, context.session),
);

/// Rates that are offered.
const RATES: [&str; 6] = ["23.976", "24", "25", "29.97", "30", "60"];
/// Steps in the words of animators.
const STEPS: [(u32, Text); 3] = [(1, text!("ones")), (2, text!("twos")), (3, text!("threes"))];

/// Shows the panel.
fn show(ui: &mut Ui, session: &Session) -> Vec<Command> {
    let mut out = Vec::new();
    let Some(shot) = session.shot() else {
        hint(ui, tr!("No shot is open. A shot changes values of a scene for some frames."));
        let new = Command::Scene(SceneCommand::Shot(ShotCommand::New));
        let help = tr!("A shot over the open scene; over a look alone, a scene is made around it");
        if ui.button(tr!("New shot of this scene")).on_hover_text(help).clicked() {
            out.push(new);
        }
        hint(ui, tr!("Open shows one that is there."));
        return out;
    };
    ScrollArea::vertical().auto_shrink([false, false]).id_salt("shot").show(ui, |ui| {
        ui.set_max_width(ui.available_width() - 8.0);
        if !shot.has_file() {
            let under = shot.stack().shots.get(1).map(|under| &under.path);
            let under = under.unwrap_or(&shot.stack().scene_path);
            let under = under.file_name().unwrap_or_default().to_string_lossy();
            let text =
                tr!("A new shot over {under}, in no file yet: what you change is kept here, and \
                     {under} stays as it is.");
            hint(ui, &text);
        }
        about(ui, session, shot, &mut out);
        ui.separator();
        stack(ui, shot, &mut out);
        ui.separator();
        changes(ui, session, shot, &mut out);
    });
    out
}

fn push(out: &mut Vec<Command>, command: ShotCommand) {
    out.push(Command::Scene(SceneCommand::Shot(command)));
}

/// Shows the name, the frames, the rate, the size and the step.
fn about(ui: &mut Ui, session: &Session, shot: &OpenShot, out: &mut Vec<Command>) {
    labelled(ui, tr!("Shot name"), tr!("What you call this shot"), |ui, label| {
        let mut name = shot.shot().name.clone();
        let field = TextEdit::singleline(&mut name).desired_width(f32::INFINITY);
        let response = ui.add(field).labelled_by(label);
        if is_typed(ui, &response, &mut name) {
            push(out, ShotCommand::EditHeld(response.id, ShotEdit::SetShotName { name }));
        }
    });
    frames(ui, session, shot, out);
    rate(ui, shot, out);
    size(ui, shot, out);
    step(ui, shot, out);
    views(ui, session, out);
}

/// Shows a row of what a shot may leave to the documents under it. Said by the shot itself over a
/// sequence, it has the mark of a change, with the way back by `reset`.
pub(super) fn inherited(
    ui: &mut Ui,
    shot: &OpenShot,
    (label, help): (&str, &str),
    (is_own, reset): (bool, ShotEdit),
    out: &mut Vec<Command>,
    add: impl FnOnce(&mut Ui, Id, &mut Vec<Command>),
) {
    let is_over_shot = shot.stack().shots.len() > 1;
    let from = match (is_own, is_over_shot) {
        (true, true) => tr!("This shot says so itself, over the sequence; the bar resets it"),
        (true, false) => tr!("This shot says so itself"),
        (false, _) => tr!("As what lies under it says; a change is this shot's own"),
    };
    let help = if help.is_empty() { from.to_owned() } else { format!("{help}\n{from}") };
    let text = RichText::new(label).color(theme::of(ui).text);
    let mut is_reset = false;
    let slot = |ui: &mut Ui, size| {
        let is_marked = is_own && is_over_shot;
        let sense = if is_marked { Sense::click() } else { Sense::hover() };
        let (rect, response) = ui.allocate_exact_size(size, sense);
        if !is_marked {
            return;
        }
        let name = tr!("Changed by the shot: {label}");
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        shot::bar(ui, rect);
        Popup::menu(&response).show(|ui| {
            if ui.button(tr!("Reset to the sequence's")).clicked() {
                is_reset = true;
                ui.close();
            }
        });
        response.on_hover_text(&help);
    };
    row::with_slot(ui, text, &help, slot, |ui, id| {
        ui.horizontal_wrapped(|ui| add(ui, id, out));
    });
    if is_reset {
        push(out, ShotCommand::Edit(reset));
    }
}

fn frames(ui: &mut Ui, session: &Session, shot: &OpenShot, out: &mut Vec<Command>) {
    let [mut first, mut last] = shot.stack().frames();
    let before = [first, last];
    let own = (shot.shot().frames.is_some(), ShotEdit::SetFrames { frames: None });
    inherited(ui, shot, (tr!("Frames"), ""), own, out, |ui, _, out| {
        for (frame, name, is_first) in
            [(&mut first, tr!("First frame"), true), (&mut last, tr!("Last frame"), false)]
        {
            // Neither end moves the other: that would lose a number which nobody touched.
            let (range, word) = match is_first {
                true => (i32::MIN..=before[1], tr!("not after {last}", last = before[1])),
                false => (before[0]..=i32::MAX, tr!("not before {first}", first = before[0])),
            };
            let is_at_limit = before[0] == before[1];
            let response = ui.add(number_field(ui, frame).range(range).speed(0.2));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
            if is_at_limit && response.has_focus() {
                ui.label(RichText::new(&word).small().color(theme::of(ui).dim));
            }
            if response.changed() {
                let frames = if is_first { [*frame, before[1]] } else { [before[0], *frame] };
                let edit = ShotEdit::SetFrames { frames: Some(frames) };
                push(out, ShotCommand::EditHeld(response.id, edit));
            }
            response.on_hover_text(word);
        }
        let frame = shot.frame_at(session.view.time);
        let text = tr!("now {frame}");
        ui.label(RichText::new(text).color(theme::of(ui).dim))
            .on_hover_text(tr!("The frame at the playhead of the timeline"));
    });
}

fn rate(ui: &mut Ui, shot: &OpenShot, out: &mut Vec<Command>) {
    let own = (shot.shot().rate.is_some(), ShotEdit::SetRate { rate: None });
    inherited(ui, shot, (tr!("Rate"), ""), own, out, |ui, label, out| {
        let now = shot.rate();
        let combo = ComboBox::from_id_salt("rate").selected_text(tr!("{now} a second"));
        let combo = combo.show_ui(ui, |ui| {
            for rate in RATES.iter().filter_map(|rate| rate.parse::<FrameRate>().ok()) {
                if ui.selectable_label(rate == now, rate.to_string()).clicked() && rate != now {
                    push(out, ShotCommand::Edit(ShotEdit::SetRate { rate: Some(rate) }));
                }
            }
        });
        combo.response.labelled_by(label);
    });
}

/// Shows for how many frames shading is held.
fn step(ui: &mut Ui, shot: &OpenShot, out: &mut Vec<Command>) {
    let help =
        tr!("Looks and lights change only on every second frame (twos) or every third (threes), \
             as if drawn by hand, while the camera and objects move on each. Ones holds nothing.");
    let own = (shot.shot().step.is_some(), ShotEdit::SetStep { step: None });
    inherited(ui, shot, (tr!("Shading on"), help), own, out, |ui, _, out| {
        ui.spacing_mut().item_spacing.x = 2.0;
        let now = shot.stack().step();
        ui.spacing_mut().button_padding.x = 5.0;
        for (step, text) in STEPS {
            let is_it = now == step;
            let name = tr!("Shading on {text}");
            let response = ui.selectable_label(is_it, text.tr());
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            if response.on_hover_text(help).clicked() && !is_it {
                push(out, ShotCommand::Edit(ShotEdit::SetStep { step: Some(step) }));
            }
        }
        // A file may hold for longer.
        if STEPS.iter().all(|(step, _)| *step != now) {
            let _ = ui.selectable_label(true, now.to_string()).on_hover_text(help);
        }
    });
}

/// Shows the buttons that look through the shot's camera, keep the view, and render.
fn views(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        let follows = session.follows_shot();
        let help = tr!(
            "The picture as `chiaro render` draws it at this frame; a turn of the view leaves the \
             camera"
        );
        let look = ui.add_enabled(!follows, Button::new(tr!("Shot's camera")));
        look.widget_info(|| {
            WidgetInfo::labeled(Role::Button, !follows, tr!("Look through the shot's camera"))
        });
        if look.on_hover_text(help).on_disabled_hover_text(help).clicked() {
            out.push(Command::View(ViewCommand::Reset));
        }
        let help = tr!(
            "The camera of the picture becomes the shot's, and a backdrop that was chosen: at \
                 this frame where they are keyed. The lights stay the shot's: a turn of them is \
                 kept over the picture"
        );
        let keep = ui.add_enabled(!follows, Button::new(tr!("Keep view")));
        keep.widget_info(|| WidgetInfo::labeled(Role::Button, !follows, tr!("Keep this view")));
        if keep.on_hover_text(help).clicked() {
            out.push(Command::Scene(SceneCommand::KeepView));
        }
        let help = tr!("Its frames as files, here or on a farm");
        let render = ui.button(tr!("Render..."));
        render.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Render frames...")));
        if render.on_hover_text(help).clicked() {
            out.push(Command::ShowPanel(PanelId::FRAMES));
        }
    });
}

fn size(ui: &mut Ui, shot: &OpenShot, out: &mut Vec<Command>) {
    let help = tr!("Width and height of its pictures, in pixels");
    let own = (shot.shot().size.is_some(), ShotEdit::SetSize { size: None });
    inherited(ui, shot, (tr!("Size"), help), own, out, |ui, _, out| {
        let Some(mut size) = shot.stack().size() else {
            if ui
                .button(tr!("by the command"))
                .on_hover_text(tr!("Sets a size of its own"))
                .clicked()
            {
                let edit = ShotEdit::SetSize { size: Some([1920, 1080]) };
                push(out, ShotCommand::Edit(edit));
            }
            return;
        };
        for (index, name) in [tr!("Width"), tr!("Height")].into_iter().enumerate() {
            let drag = number_field(ui, &mut size[index]).range(1..=32_768).speed(2.0);
            let response = ui.add(drag);
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
            if response.changed() {
                let edit = ShotEdit::SetSize { size: Some(size) };
                push(out, ShotCommand::EditHeld(response.id, edit));
            }
        }
    });
}

/// Shows the documents under the shot in a line, the nearest first; a click opens one.
fn stack(ui: &mut Ui, shot: &OpenShot, out: &mut Vec<Command>) {
    let stack = shot.stack();
    let beneath = stack.shots.iter().skip(1).map(|file| &file.path).chain([&stack.scene_path]);
    ui.horizontal_wrapped(|ui| {
        for path in beneath {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            ui.label(RichText::new(tr!("over")).color(theme::of(ui).dim));
            let link = ui.link(&*name);
            link.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Open {name}")));
            let help = tr!("{path}\nOpens it in place of the shot", path = path.display());
            if link.on_hover_text(help).clicked() {
                out.push(Command::Open(Some(path.clone())));
            }
        }
        let new = ui.menu_button(RichText::new(tr!("New shot")).small(), |ui| {
            let scene = stack.scene_path.file_name().unwrap_or_default().to_string_lossy();
            let shot_name = shot.name();
            let over = shot.has_file().then(|| tr!("Over {shot_name}"));
            for (label, command) in [(Some(tr!("Of {scene}")), ShotCommand::New)]
                .into_iter()
                .chain([(over, ShotCommand::NewOver)])
            {
                let command = Command::Scene(SceneCommand::Shot(command));
                let Some(label) = label else { continue };
                if ui.button(label).on_hover_text(table::help_of(&command)).clicked() {
                    out.push(command);
                }
            }
        });
        new.response.widget_info(|| {
            WidgetInfo::labeled(Role::Button, true, tr!("New shot of the scene, or over this shot"))
        });
    });
}

/// Lists the shot's changes of values that are not there, with the ways out.
fn lost(ui: &mut Ui, session: &Session, shot: &OpenShot, out: &mut Vec<Command>) {
    let lost = shot.lost_changes();
    if lost.is_empty() {
        return;
    }
    let colors = theme::of(ui);
    let count = lost.len();
    let text = trn!(
        count,
        "{count} change is of what is not there, and keeps the shot from being rendered",
        "{count} changes are of what is not there, and keep the shot from being rendered"
    );
    ui.label(RichText::new(text).small().color(colors.error));
    for change in &lost {
        let address = value_address(change.change.look.as_deref(), &change.change.target);
        let name = lost_name(session, change.change);
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                lost_buttons(ui, (session, shot), change, &name, out);
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let text = RichText::new(&name).color(colors.text);
                    ui.add(Label::new(text).truncate()).on_hover_text(&address);
                });
            });
        });
        let why = RichText::new(format!("   {}", change.why)).small().color(colors.error);
        ui.add(Label::new(why).truncate()).on_hover_text(change.why);
        ui.add_space(2.0);
    }
    ui.separator();
}

/// Name of a value that is not there, with the labels that are still known.
fn lost_name(session: &Session, change: &Override) -> String {
    let Some(look) = &change.look else { return scene_names::of(&change.target).join(": ") };
    let value = match Target::parse(&change.target) {
        Some(target) => session.look_with_library().title_of_target(&target),
        None => change.target.clone(),
    };
    let look = std::path::Path::new(look).file_stem().unwrap_or_default().to_string_lossy();
    format!("{look}: {value}")
}

/// Shows the buttons of a change of what is not there: out of the shot, or to another object, light
/// or node.
fn lost_buttons(
    ui: &mut Ui,
    (session, shot): (&Session, &OpenShot),
    change: &LostChange<'_>,
    name: &str,
    out: &mut Vec<Command>,
) {
    let reset = ui.small_button(tr!("Reset"));
    reset.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Reset {name}")));
    if reset.on_hover_text(tr!("Takes the change out of the shot")).clicked() {
        push(out, ShotCommand::Edit(change.taken_back()));
    }
    let Some(from) = change.owner() else { return };
    let places = session.places_of_lost(from);
    let help = tr!(
        "All that the shot changes of {from}, with its keys, is of this from now on",
        from = from.id
    );
    let mut chosen = None;
    match places.as_slice() {
        [] => {}
        [(id, only)] => {
            let button = ui.small_button(tr!("Move to {only}"));
            let label = tr!("Move {name} to {only}");
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
            chosen = button.on_hover_text(&help).clicked().then_some(id);
        }
        several => {
            let menu = ui.menu_button(RichText::new(tr!("Move to...")).small(), |ui| {
                scrolling(ui, |ui| {
                    for (id, place) in several {
                        if ui.button(place).on_hover_text(&help).clicked() {
                            chosen = Some(id);
                        }
                    }
                });
            });
            let label = tr!("Move {name} to another place");
            menu.response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        }
    }
    if let Some(to) = chosen {
        push(out, ShotCommand::Edit(shot.moved(from, to)));
    }
}

/// Lists the values that the shots change.
fn changes(ui: &mut Ui, session: &Session, shot: &OpenShot, out: &mut Vec<Command>) {
    lost(ui, session, shot, out);
    let standing: Vec<&ValueChange> =
        shot.resolved().changes.iter().filter(|change| change.stands).collect();
    if standing.is_empty() {
        hint(
            ui,
            tr!("It changes nothing yet: set any value of a light, an object or the look, and it \
                 is listed here, to be keyed or reset."),
        );
        return;
    }
    let count = standing.iter().filter(|change| change.by == shot.path()).count();
    let farther = standing.len() - count;
    ui.label(
        RichText::new(tr!("{count} changed by this shot, {farther} by what lies under it"))
            .small()
            .color(theme::of(ui).dim),
    );
    // The nearest first.
    for change in standing.iter().rev().filter(|change| change.by == shot.path()) {
        row(ui, session, shot, change, out);
    }
    for change in standing.iter().rev().filter(|change| change.by != shot.path()) {
        row(ui, session, shot, change, out);
    }
}

/// Shows a change: where it is, with its buttons, and below what it was and is.
fn row(
    ui: &mut Ui,
    session: &Session,
    shot: &OpenShot,
    change: &ValueChange,
    out: &mut Vec<Command>,
) {
    let at = ShotAddress::of(change);
    let is_own = change.by == shot.path();
    let by = change.by.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let look = change.look.as_deref().map(std::path::Path::new);
    let look = look.and_then(std::path::Path::file_stem).map(|name| name.to_string_lossy());
    let address = match look {
        Some(look) => format!("{look}: {}", change.target),
        None => change.target.clone(),
    };
    let colors = theme::of(ui);
    let color = if is_own { colors.text } else { colors.dim };
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            buttons(ui, (session, shot), change, &address, out);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let name = ChangedValue::new(session, change).name();
                let text = RichText::new(name).color(color);
                let response = ui.add(Label::new(text).sense(Sense::click()).truncate());
                response
                    .widget_info(|| WidgetInfo::labeled(Role::Link, true, tr!("Show {address}")));
                let help = tr!("{address}\nA click shows it", address = at.text());
                if response.on_hover_text(help).clicked() {
                    push(out, ShotCommand::Show(at.clone()));
                }
            });
        });
    });
    let (from, to) = change_text(session, change);
    let (mut text, help) = match change.is_keyed {
        true => {
            (tr!("{from} before, keyed to {to}"), tr!("keyed by {by}: {from} before, {to} now"))
        }
        false => (tr!("{from} before, set to {to}"), tr!("set by {by}: {from} before, {to} now")),
    };
    if change.step > 1 {
        text = tr!("{text}, held for {step} frames", step = change.step);
    }
    let text = RichText::new(format!("   {text}")).small().color(colors.dim);
    ui.add(Label::new(text).truncate()).on_hover_text(help);
    ui.add_space(2.0);
}

/// Shows the buttons of a change: the way back, or to the file that makes it, and a key.
fn buttons(
    ui: &mut Ui,
    (session, shot): (&Session, &OpenShot),
    change: &ValueChange,
    address: &str,
    out: &mut Vec<Command>,
) {
    let at = ShotAddress::of(change);
    if change.by == shot.path() {
        let button = ui.small_button(tr!("Reset"));
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr!("Reset {address}")));
        if button.on_hover_text(tr!("The value is as before")).clicked() {
            push(out, ShotCommand::Reset(at.clone()));
        }
    } else {
        let by = change.by.file_name().unwrap_or_default().to_string_lossy();
        let help = tr!("{by} changes it, and takes it back: opens that file");
        let button = ui.small_button(tr!("Open"));
        button.widget_info(|| {
            WidgetInfo::labeled(Role::Button, true, tr!("Open {by} with {address}"))
        });
        if button.on_hover_text(help).clicked() {
            out.push(Command::Open(Some(change.by.clone())));
        }
    }
    let is_open = at.can_move() && (change.look.is_none() || change.look == shot.open_look());
    let key = ui.add_enabled(is_open, Button::new(tr!("Key")).small());
    key.widget_info(|| WidgetInfo::labeled(Role::Button, is_open, tr!("Key {address}")));
    let frame = shot.frame_at(session.view.time);
    if key.on_hover_text(tr!("A key at frame {frame}, with the present value")).clicked() {
        push(out, ShotCommand::Key(at));
    }
}
