//! Actions of a simulated user by the names that everybody sees and that screen readers tell.

use chiaro::document::{DirectionKey, DirectionKeys, Edit, KeyDirection, Target, Value};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, pos2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::User;

/// Lower edge of the part of the window that can be clicked: below are the status bar and widgets
/// that it cuts off. In points.
const BOTTOM: f32 = 858.0;

impl User {
    /// Keys a number by the view: at the front and from aside, both times to the same.
    pub(crate) fn key_by_view(&mut self, target: &Target, number: f64) {
        let key = |direction: [f64; 3]| DirectionKey {
            direction,
            values: [(target.clone(), Value::Number(number))].into_iter().collect(),
            unknown: Default::default(),
        };
        let keys = DirectionKeys {
            name: "Seen from aside".to_owned(),
            by: KeyDirection::View,
            scheme: Default::default(),
            keys: vec![key([0.0, 0.0, 1.0]), key([1.0, 0.0, 0.0])],
            unknown: Default::default(),
        };
        let edit = Edit::AddDirectionKeys { keys, index: None };
        self.app_mut().session_mut().apply(edit, None).unwrap();
        self.settle();
    }

    /// Rectangle of the first widget of this name.
    #[track_caller]
    pub(crate) fn place(&self, label: &str) -> Rect {
        match self.harness.query_all_by_label(label).next() {
            Some(node) => node.rect(),
            None => panic!("there is no \"{label}\" among {:?}", self.names()),
        }
    }

    /// Rectangle of the first widget of this role and name.
    #[track_caller]
    pub(crate) fn place_of(&self, role: Role, label: &str) -> Rect {
        let found = self.harness.query_all_by_role_and_label(role, label).next();
        found
            .unwrap_or_else(|| panic!("there is no {role:?} \"{label}\" among {:?}", self.names()))
            .rect()
    }

    /// Names of all widgets, for a message.
    pub(crate) fn names(&self) -> Vec<String> {
        let all = self.harness.query_all(egui_kittest::kittest::by().predicate(|_| true));
        all.filter_map(|node| node.accesskit_node().label().or_else(|| node.value())).collect()
    }

    /// Rectangle of the first widget whose name contains this text.
    #[track_caller]
    pub(crate) fn place_like(&self, text: &str) -> Rect {
        match self.harness.query_all_by_label_contains(text).next() {
            Some(node) => node.rect(),
            None => panic!("nothing has \"{text}\" in its name among {:?}", self.names()),
        }
    }

    #[track_caller]
    pub(crate) fn press(&mut self, label: &str) {
        let at = self.place(label).center();
        self.click(at);
        self.settle();
    }

    #[track_caller]
    pub(crate) fn press_a(&mut self, role: Role, label: &str) {
        let at = self.place_of(role, label).center();
        self.click(at);
        self.settle();
    }

    pub(crate) fn has(&self, label: &str) -> bool {
        self.harness.query_all_by_label(label).next().is_some()
    }

    pub(crate) fn says(&self, text: &str) -> bool {
        self.harness.query_all_by_label_contains(text).next().is_some()
    }

    /// Brings a panel to the front by its tab.
    #[track_caller]
    pub(crate) fn tab(&mut self, panel: &str) {
        self.press_a(Role::Tab, panel);
    }

    /// Scrolls until the first widget of this role and name can be seen.
    #[track_caller]
    pub(crate) fn bring(&mut self, role: Role, label: &str) {
        let found = self.harness.query_all_by_role_and_label(role, label).next();
        found
            .unwrap_or_else(|| panic!("there is no {role:?} \"{label}\" among {:?}", self.names()))
            .scroll_to_me();
        self.settle();
    }

    /// Scrolls to what has this name, and presses it.
    #[track_caller]
    pub(crate) fn press_far(&mut self, label: &str) {
        let found = self.harness.query_all_by_label(label).next();
        found.unwrap_or_else(|| panic!("there is no \"{label}\"")).scroll_to_me();
        self.settle();
        self.press(label);
    }

    /// Chooses an entry from a list by the list's name.
    #[track_caller]
    pub(crate) fn choose(&mut self, list: &str, what: &str) {
        self.bring(Role::ComboBox, list);
        self.press_a(Role::ComboBox, list);
        let at = self.harness.query_all_by_label(what).last();
        let at = at.unwrap_or_else(|| panic!("\"{list}\" has no \"{what}\"")).rect().center();
        self.click(at);
        self.settle();
    }

    /// Replaces the text of a field by typing.
    pub(crate) fn type_over(&mut self, field: Rect, text: &str) {
        self.click(field.center());
        self.key_with(Modifiers::COMMAND, Key::A);
        self.type_text(text);
        self.key(Key::Enter);
        self.settle();
    }

    /// Types the name into the inspector's search, where the inspector has one, so that only values
    /// of this name are listed.
    fn find_value(&mut self, label: &str) {
        if self.has("Find a value") {
            let search = self.place("Find a value");
            self.type_over(search, label);
        }
    }

    /// Brings a value of the inspector into view, by its search and by the wheel. The row is found
    /// by the value's diamond.
    #[track_caller]
    fn row(&mut self, label: &str) -> Rect {
        self.find_value(label);
        let diamond = format!("Keys of {label}");
        for _ in 0..40 {
            let row = self.place(&diamond);
            if row.max.y < BOTTOM {
                return row;
            }
            self.wheel(pos2(row.center().x + 60.0, BOTTOM - 80.0), -60.0);
        }
        panic!("{label} does not come into view")
    }

    /// Chooses an entry of the menu of a value in the inspector.
    #[track_caller]
    pub(crate) fn menu_of(&mut self, label: &str, entry: &str) {
        let diamond = self.row(label);
        self.click(diamond.center());
        self.settle();
        self.press(entry);
    }

    /// Chooses a word for a value in the inspector.
    #[track_caller]
    pub(crate) fn set_word(&mut self, label: &str, word: &str) {
        self.row(label);
        self.choose(label, word);
    }

    /// The fields of a role in the row of a value, from left to right.
    fn fields(&self, role: Role, row: Rect) -> Vec<Rect> {
        let all = self.harness.query_all_by_role(role).map(|node| node.rect());
        let in_row =
            |rect: &Rect| (rect.center().y - row.center().y).abs() < 6.0 && rect.min.x > row.min.x;
        let mut found: Vec<Rect> = all.filter(in_row).collect();
        found.sort_by(|a, b| a.min.x.total_cmp(&b.min.x));
        found
    }

    /// Number fields of this name, from top to bottom.
    pub(crate) fn fields_called(&self, label: &str) -> Vec<Rect> {
        let all = self
            .harness
            .query_all_by_role_and_label(Role::SpinButton, label)
            .map(|node| node.rect());
        let mut found: Vec<Rect> = all.collect();
        found.sort_by(|a, b| a.min.y.total_cmp(&b.min.y));
        found
    }

    /// The first text field of this name.
    #[track_caller]
    pub(crate) fn text_field(&self, label: &str) -> Rect {
        self.place_of(Role::TextInput, label)
    }

    /// Types a number into the field of a value in the inspector; angles are in degrees.
    #[track_caller]
    pub(crate) fn set(&mut self, label: &str, number: &str) {
        let row = self.row(label);
        let field = self.fields(Role::SpinButton, row).first().copied();
        self.type_over(field.unwrap_or_else(|| panic!("{label} has no field")), number);
    }

    /// Types a color's hex code into its field in the inspector; a color that follows another color
    /// is first given a value of its own.
    #[track_caller]
    pub(crate) fn set_color(&mut self, label: &str, hex: &str) {
        let mut row = self.row(label);
        if self.fields(Role::TextInput, row).is_empty() {
            let buttons = self
                .harness
                .query_all_by_role_and_label(Role::Button, "Set")
                .map(|node| node.rect());
            let set =
                buttons.into_iter().find(|rect| (rect.center().y - row.center().y).abs() < 6.0);
            let set = set.unwrap_or_else(|| panic!("{label} can be set nowhere"));
            self.click(set.center());
            self.settle();
            row = self.row(label);
        }
        let field = self.fields(Role::TextInput, row)[0];
        self.type_over(field, hex);
    }

    /// The swatch of a color in the inspector, which opens its picker.
    #[track_caller]
    pub(crate) fn swatch(&mut self, label: &str) -> Rect {
        let row = self.row(label);
        let wells = [Role::ColorWell, Role::Button].map(|role| self.fields(role, row));
        wells.concat().first().copied().unwrap_or_else(|| panic!("{label} has no swatch"))
    }

    /// Ids of the selected nodes.
    pub(crate) fn selected(&self) -> Vec<String> {
        self.app().session().selection().nodes().map(ToString::to_string).collect()
    }

    /// Errors of the look, which keep it from being shown.
    pub(crate) fn errors(&self) -> Vec<String> {
        let problems = self.app().session().compilation().problems().iter();
        problems.filter(|problem| problem.is_error()).map(ToString::to_string).collect()
    }

    /// Number of steps that can be undone.
    pub(crate) fn steps(&self) -> usize {
        self.app().session().steps().done()
    }
}
