//! Measured errors against their bounds.

/// The largest error of a measurement, with its place.
pub struct Errors {
    name: String,
    bound: f64,
    largest: f64,
    place: String,
    count: usize,
}

impl Errors {
    /// A measurement without errors so far; errors may be up to `bound`.
    pub fn new(name: impl Into<String>, bound: f64) -> Self {
        Self { name: name.into(), bound, largest: 0.0, place: String::new(), count: 0 }
    }

    /// Notes one error; an error that is no finite number counts as infinite.
    pub fn note(&mut self, got: f64, wanted: f64, place: impl FnOnce() -> String) {
        let error = (got - wanted).abs();
        let error = if error.is_finite() { error } else { f64::INFINITY };
        self.count += 1;
        if error > self.largest {
            self.largest = error;
            self.place = format!("{got} for {wanted} at {}", place());
        }
    }

    /// True if any error was noted.
    pub fn has_any(&self) -> bool {
        self.count > 0
    }

    /// The largest error, if it keeps the bound.
    ///
    /// # Errors
    /// Where the error is beyond the bound, and where nothing was measured.
    pub fn verdict(&self) -> Result<f64, String> {
        if self.count == 0 {
            return Err(format!("{}: nothing was measured", self.name));
        }
        if self.largest > self.bound {
            return Err(format!(
                "{}: {:e} beyond {:e}: {}",
                self.name, self.largest, self.bound, self.place
            ));
        }
        Ok(self.largest)
    }

    /// Prints a row for the documentation, and fails beyond the bound.
    #[allow(
        clippy::print_stdout,
        reason = "the documentation's table is made of what `--nocapture` shows"
    )]
    pub fn finish(self) {
        println!("| {} | {} | {:.1e} | {:.0e} |", self.name, self.count, self.largest, self.bound);
        if let Err(wrong) = self.verdict() {
            panic!("{wrong}");
        }
    }
}
