//! Long work that Python can follow and stop.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How often Python is asked whether it was interrupted.
const BETWEEN: Duration = Duration::from_millis(50);

/// How far some work is, and whether it is still wanted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watch {
    done: Arc<AtomicU64>,
    stopped: Arc<AtomicBool>,
}

impl Watch {
    /// Says how much is done; whether to go on.
    pub(crate) fn set(&self, done: u64) -> bool {
        self.done.store(done, Ordering::Relaxed);
        self.goes_on()
    }

    /// Says how much more is done; whether to go on.
    pub(crate) fn add(&self, more: u64) -> bool {
        self.done.fetch_add(more, Ordering::Relaxed);
        self.goes_on()
    }

    fn goes_on(&self) -> bool {
        !self.stopped.load(Ordering::Relaxed)
    }
}

/// Does some work on a thread of its own, without Python's lock. `progress` is called with how much is done,
/// a few times a second; what it raises, and an interrupt, end the call at once, and the work when it next
/// looks.
pub(crate) fn follow<T: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send + 'static,
) -> PyResult<T> {
    let watch = Watch::default();
    let (send, receive) = channel();
    let own = watch.clone();
    std::thread::Builder::new()
        .name("passivity".to_owned())
        .spawn(move || {
            // Who no longer waits does not want it.
            let _ = send.send(work(&own));
        })?;
    let mut told = None;
    let mut tell = || -> PyResult<()> {
        let done = watch.done.load(Ordering::Relaxed);
        if let (Some(progress), true) = (progress, told != Some(done)) {
            told = Some(done);
            progress.call1((done,))?;
        }
        py.check_signals()
    };
    let receive = std::sync::Mutex::new(receive);
    loop {
        let came = py.detach(|| match receive.lock() {
            Ok(receive) => receive.recv_timeout(BETWEEN),
            Err(_) => Err(RecvTimeoutError::Disconnected),
        });
        let looked = tell().inspect_err(|_| watch.stopped.store(true, Ordering::Relaxed));
        match came {
            Ok(result) => return looked.map(|()| result),
            Err(RecvTimeoutError::Timeout) => looked?,
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err(
                    "the work ended without a result: this is a mistake in passivity",
                ));
            }
        }
    }
}
