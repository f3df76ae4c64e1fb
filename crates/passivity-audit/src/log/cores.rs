//! Work on several cores: read in order by one of them, done by whichever is free, and taken back in order.

use std::any::Any;
use std::collections::VecDeque;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// What was done, or why a core gave up on it.
type Done<D> = Result<D, Box<dyn Any + Send>>;

/// Work that no core has begun, and what was done, each with its number.
struct State<W, D> {
    work: VecDeque<(usize, W)>,
    done: Vec<(usize, Done<D>)>,
    /// Whether no more of it is done.
    closed: bool,
}

/// What the cores share.
struct Desk<W, D> {
    state: Mutex<State<W, D>>,
    /// Told to the other cores where there is work, and to the caller where some was done.
    work: Condvar,
    done: Condvar,
}

impl<W, D> Desk<W, D> {
    const fn new() -> Self {
        let state = State {
            work: VecDeque::new(),
            done: Vec::new(),
            closed: false,
        };
        Self {
            state: Mutex::new(state),
            work: Condvar::new(),
            done: Condvar::new(),
        }
    }

    fn lock(&self) -> MutexGuard<'_, State<W, D>> {
        // Nothing that holds the lock can leave it half changed.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn push(&self, number: usize, work: W) {
        self.lock().work.push_back((number, work));
        self.work.notify_one();
    }

    /// Does work with what one core keeps, until there is no more to be done.
    fn work<S>(&self, each: &impl Fn(W, &mut S) -> D, core: &mut S) {
        let is_idle = |state: &mut State<W, D>| state.work.is_empty() && !state.closed;
        loop {
            let waited = self.work.wait_while(self.lock(), is_idle);
            let mut state = waited.unwrap_or_else(PoisonError::into_inner);
            let (false, Some((number, work))) = (state.closed, state.work.pop_front()) else {
                return;
            };
            drop(state);
            let done = catch_unwind(AssertUnwindSafe(|| each(work, core)));
            self.lock().done.push((number, done));
            self.done.notify_one();
        }
    }
}

/// Keeps what was done in its place.
fn keep<D>(done: &mut VecDeque<Option<D>>, place: usize, found: D) {
    if let Some(slot) = done.get_mut(place) {
        *slot = Some(found);
    }
}

/// Ends the work of all cores where it goes out of scope, in a panic too.
struct Closing<'a, W, D>(&'a Desk<W, D>);

impl<W, D> Drop for Closing<'_, W, D> {
    fn drop(&mut self) {
        self.0.lock().closed = true;
        self.0.work.notify_all();
    }
}

/// Reads work, has `each` do it with what one core keeps, and takes what was done in the order of reading, up to where
/// `take` says `false`. The calling thread reads and takes, and does work itself where the others have enough: no more
/// is read ahead than twice as many as there are cores.
pub(crate) fn in_order<W: Send, D: Send, S: Send, E>(
    cores: &mut [S],
    mut read: impl FnMut() -> Option<W>,
    each: impl Fn(W, &mut S) -> D + Sync,
    mut take: impl FnMut(D) -> Result<bool, E>,
) -> Result<(), E> {
    let Some((own, others)) = cores.split_first_mut() else {
        return Ok(());
    };
    // One that each core works on, and one more for each to go on with: the others wait for none while this one works too.
    let ahead = 2 * (others.len() + 1);
    let mut others = others.iter_mut();
    let desk = Desk::new();
    std::thread::scope(|scope| {
        let (desk, each) = (&desk, &each);
        let _closing = Closing(desk);
        // Of what was begun and not taken yet, what was done.
        let mut done: VecDeque<Option<Done<D>>> = VecDeque::new();
        let (mut taken, mut ended) = (0, false);
        loop {
            while !ended && done.len() < ahead {
                let Some(work) = read() else {
                    ended = true;
                    break;
                };
                desk.push(taken + done.len(), work);
                done.push_back(None);
                // The first needs no other core than this.
                if done.len() > 1
                    && let Some(core) = others.next()
                {
                    let thread = std::thread::Builder::new();
                    // Where the system has no more threads, those that there are do the work.
                    let _ = thread.spawn_scoped(scope, move || desk.work(each, core));
                }
            }
            let mut state = desk.lock();
            if state.done.is_empty()
                && let Some((number, work)) = state.work.pop_front()
            {
                drop(state);
                let found = Ok(each(work, own));
                keep(&mut done, number - taken, found);
            } else if !done.is_empty() {
                let waited = desk.done.wait_while(state, |state| state.done.is_empty());
                state = waited.unwrap_or_else(PoisonError::into_inner);
                for (number, found) in state.done.drain(..) {
                    keep(&mut done, number - taken, found);
                }
                drop(state);
            }
            while let Some(Some(_)) = done.front()
                && let Some(Some(next)) = done.pop_front()
            {
                taken += 1;
                if !take(next.unwrap_or_else(|panic| resume_unwind(panic)))? {
                    return Ok(());
                }
            }
            if ended && done.is_empty() {
                return Ok(());
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::time::Duration;

    /// What is taken of 0 to `n` done by so many cores, up to `last`, and how many of them were read.
    fn taken(n: u64, cores: usize, last: u64) -> (Vec<u64>, u64) {
        let mut kept = vec![0_u64; cores];
        let (mut numbers, mut read) = (0..n, 0);
        let mut taken = Vec::new();
        let found: Result<(), ()> = in_order(
            &mut kept,
            || {
                let next = numbers.next();
                read += u64::from(next.is_some());
                next
            },
            |n, kept| {
                *kept += 1;
                // Some take longer than those that come after them.
                std::thread::sleep(Duration::from_micros(200 * (n % 3)));
                n
            },
            |n| {
                taken.push(n);
                Ok(n < last)
            },
        );
        assert_eq!(found, Ok(()));
        let done: u64 = kept.iter().sum();
        assert!((taken.len() as u64..=read).contains(&done));
        (taken, read)
    }

    #[test]
    fn what_was_done_comes_in_the_order_of_reading() {
        for cores in 1..5 {
            for n in [0, 1, 2, 3, 50] {
                assert_eq!(taken(n, cores, n), ((0..n).collect(), n));
            }
        }
    }

    #[test]
    fn nothing_is_taken_after_the_last_and_little_is_read() {
        for cores in 1..5 {
            let (taken, read) = taken(1000, cores, 7);
            assert_eq!(taken, (0..8).collect::<Vec<_>>());
            assert!(read < 8 + 2 * cores as u64, "{read} with {cores}");
        }
    }

    #[test]
    fn all_cores_work() {
        // Each waits for the other, which no single one could.
        let met = AtomicU64::new(0);
        let mut numbers = 0..2;
        let found: Result<(), ()> = in_order(
            &mut [(), ()],
            || numbers.next(),
            |_, ()| {
                met.fetch_add(1, Ordering::SeqCst);
                while met.load(Ordering::SeqCst) < 2 {
                    std::thread::yield_now();
                }
            },
            |()| Ok(true),
        );
        assert_eq!(found, Ok(()));
    }

    #[test]
    fn an_error_ends_the_work() {
        let found = in_order(
            &mut [(), (), ()],
            || Some(()),
            |(), ()| (),
            |()| Err("stop"),
        );
        assert_eq!(found, Err("stop"));
    }

    #[test]
    fn a_panic_on_any_core_reaches_the_caller() {
        let caller = std::thread::current().id();
        for own in [false, true] {
            let found = catch_unwind(|| {
                let each = |(), (): &mut ()| {
                    if (std::thread::current().id() == caller) == own {
                        std::panic::panic_any("broken");
                    }
                };
                in_order(&mut [(), (), ()], || Some(()), each, |()| Ok::<_, ()>(true))
            });
            let broken = found.map_err(|found| found.downcast_ref() == Some(&"broken"));
            assert_eq!(broken, Err(true));
        }
    }
}
