//! A progress bar for work that takes more than a second, on standard error when that is a terminal.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar that shows itself after a second, and goes when it is dropped.
pub(crate) struct Progress {
    bar: ProgressBar,
    begin: Instant,
    shown: bool,
}

impl Progress {
    /// A bar of `total` things, named by their plural.
    pub(crate) fn new(total: u64, things: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        let template = format!("{{wide_bar}} {{pos}}/{{len}} {things}, {{eta}} to go {{msg}}");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        Self {
            bar,
            begin: Instant::now(),
            shown: false,
        }
    }

    #[cfg(feature = "simulate")]
    /// Says what was there before: it counts as done, not as fast work.
    pub(crate) fn start_at(&self, done: u64) {
        self.bar.set_position(done);
        self.bar.reset_eta();
    }

    /// Says how many more are done.
    pub(crate) fn advance(&mut self, more: u64) {
        self.bar.inc(more);
        if !self.shown && self.begin.elapsed() > Duration::from_secs(1) {
            self.shown = true;
            // Hidden where standard error is no terminal.
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }

    #[cfg(feature = "simulate")]
    /// Says what is being done.
    pub(crate) fn say(&self, what: String) {
        self.bar.set_message(what);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
