//! Work on several cores: read in order by one of them, done by whichever is free, and taken back in order.

use std::any::Any;
use std::collections::{BTreeMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::channel;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// What was done, or why a core gave up on it.
type Done<D> = Result<D, Box<dyn Any + Send>>;

/// Work that no core has begun, with its number.
struct Queue<W> {
    waiting: Mutex<Waiting<W>>,
    changed: Condvar,
}

struct Waiting<W> {
    work: VecDeque<(u64, W)>,
    /// Whether no more of it is done.
    closed: bool,
}

impl<W> Queue<W> {
    const fn new() -> Self {
        let waiting = Waiting {
            work: VecDeque::new(),
            closed: false,
        };
        Self {
            waiting: Mutex::new(waiting),
            changed: Condvar::new(),
        }
    }

    fn lock(&self) -> MutexGuard<'_, Waiting<W>> {
        // Nothing that holds the lock can leave it half changed.
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn push(&self, number: u64, work: W) {
        self.lock().work.push_back((number, work));
        self.changed.notify_one();
    }

    /// What is to be done next, if there is any.
    fn pop(&self) -> Option<(u64, W)> {
        self.lock().work.pop_front()
    }

    /// The same, as soon as there is any; `None` once nothing more is done.
    fn wait(&self) -> Option<(u64, W)> {
        let mut waiting = self.lock();
        loop {
            if waiting.closed {
                return None;
            }
            if let Some(next) = waiting.work.pop_front() {
                return Some(next);
            }
            let woken = self.changed.wait(waiting);
            waiting = woken.unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Ends the work of all cores where it goes out of scope, in a panic too.
struct Closing<'a, W>(&'a Queue<W>);

impl<W> Drop for Closing<'_, W> {
    fn drop(&mut self) {
        self.0.lock().closed = true;
        self.0.changed.notify_all();
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
    // One that each core works on, and one more to go on with for each of the others.
    let ahead = 2 * others.len() as u64 + 1;
    let mut others = others.iter_mut();
    let queue = Queue::new();
    std::thread::scope(|scope| {
        let (queue, each) = (&queue, &each);
        let _closing = Closing(queue);
        let (send, came) = channel::<(u64, Done<D>)>();
        let mut done = BTreeMap::new();
        let (mut begun, mut taken, mut ended) = (0, 0, false);
        loop {
            while !ended && begun - taken < ahead {
                let Some(work) = read() else {
                    ended = true;
                    break;
                };
                queue.push(begun, work);
                begun += 1;
                // The first needs no other core than this.
                if begun > 1
                    && let Some(core) = others.next()
                {
                    let send = send.clone();
                    scope.spawn(move || {
                        while let Some((number, work)) = queue.wait() {
                            let done = catch_unwind(AssertUnwindSafe(|| each(work, core)));
                            if send.send((number, done)).is_err() {
                                break;
                            }
                        }
                    });
                }
            }
            done.extend(came.try_iter());
            while let Some(next) = done.remove(&taken) {
                taken += 1;
                if !take(next.unwrap_or_else(|panic| resume_unwind(panic)))? {
                    return Ok(());
                }
            }
            if ended && taken == begun {
                return Ok(());
            }
            if let Some((number, work)) = queue.pop() {
                done.insert(number, Ok(each(work, own)));
            } else if ended || begun - taken == ahead {
                done.extend(came.recv());
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
