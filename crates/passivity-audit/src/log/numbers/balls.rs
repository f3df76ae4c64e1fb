//! What is known of the numbers of a column after scaling, in doubles and how far off these are.

use super::all;
use crate::ball::Ball;
use crate::log::error::TraceError;

/// What is known of the numbers of a column, in doubles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Balls {
    pub(crate) middles: Vec<f64>,
    pub(crate) radii: Vec<f64>,
}

impl Balls {
    #[inline]
    pub(crate) fn push(&mut self, ball: Ball) {
        let (middle, radius) = ball.parts();
        self.middles.push(middle);
        self.radii.push(radius);
    }

    pub(super) const fn len(&self) -> usize {
        self.middles.len()
    }

    /// Appends the balls of numbers, from the first that has none on: those that `several` finds of all of them at once,
    /// with no number in the middle where it does not, or else those that `one` finds. Where one cannot be found, what
    /// comes before it is kept.
    #[inline]
    pub(crate) fn complete(
        &mut self,
        len: usize,
        several: impl FnOnce(usize, (&mut [f64], &mut [f64])),
        one: impl Fn(usize) -> Result<Ball, TraceError>,
    ) -> Result<(), (usize, TraceError)> {
        const SOME: usize = 64;
        let known = self.len();
        self.middles.resize(len, f64::NAN);
        self.radii.resize(len, 0.0);
        let parts = (self.middles.get_mut(known..), self.radii.get_mut(known..));
        if let (Some(middles), Some(radii)) = parts {
            several(known, (middles, radii));
        }
        for from in (known..len).step_by(SOME) {
            let some = from..len.min(from + SOME);
            let middles = self.middles.get(some.clone()).unwrap_or_default();
            if all(middles, |x| !x.is_nan()) {
                continue;
            }
            let parts = self.middles.iter_mut().zip(&mut self.radii).enumerate();
            for (i, (middle, radius)) in parts.take(some.end).skip(some.start) {
                if middle.is_nan() {
                    match one(i) {
                        Ok(ball) => (*middle, *radius) = ball.parts(),
                        Err(error) => {
                            self.truncate(i);
                            return Err((i, error));
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Copies those from `at` on, as many as there are and are asked for: how many that is.
    pub(crate) fn copy_to(
        &self,
        [middles, radii]: [&mut [f64]; 2],
        at: usize,
        most: usize,
    ) -> usize {
        let (from, off) = (self.middles.get(at..), self.radii.get(at..));
        let (from, off) = (from.unwrap_or_default(), off.unwrap_or_default());
        let len = most.min(from.len()).min(off.len());
        for (to, from) in [(middles, from), (radii, off)] {
            if let Some((to, from)) = to.get_mut(..len).zip(from.get(..len)) {
                to.copy_from_slice(from);
            }
        }
        len
    }

    pub(super) fn truncate(&mut self, len: usize) {
        self.middles.truncate(len);
        self.radii.truncate(len);
    }

    pub(super) fn append(&mut self, next: &mut Self) {
        self.middles.append(&mut next.middles);
        self.radii.append(&mut next.radii);
    }

    pub(super) fn split_off(&mut self, len: usize) -> Self {
        let len = len.min(self.middles.len());
        Self {
            middles: self.middles.split_off(len),
            radii: self.radii.split_off(len),
        }
    }
}
