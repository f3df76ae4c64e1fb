//! A command and all that it starts, ended together.

use std::process::{Child, Command, Stdio};

/// A running command; dropped, it is ended with every process that it started and that did not leave
/// its process group.
pub(crate) struct Children {
    pub(crate) process: Child,
}

impl Children {
    /// Starts a command with the shell, its standard input and output in pipes.
    pub(crate) fn start(command: &str) -> std::io::Result<Self> {
        let mut shell = Command::new("sh");
        shell
            .args(["-c", command])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut shell, 0);
        let process = shell.spawn()?;
        group::note(&process);
        Ok(Self { process })
    }
}

impl Drop for Children {
    fn drop(&mut self) {
        end_children();
        // Where there are no process groups, or the group has gone already.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Ends the command that [`against`](crate::against) runs at present, with all that it started; nothing
/// where none runs. For a program that is interrupted.
pub fn end_children() {
    group::end();
}

#[cfg(unix)]
mod group {
    use std::process::Child;
    use std::sync::atomic::{AtomicI32, Ordering};

    use rustix::process::{Pid, Signal, kill_process_group};

    /// The process group that runs; 0 for none.
    static RUNNING: AtomicI32 = AtomicI32::new(0);

    pub(super) fn note(process: &Child) {
        if let Ok(id) = i32::try_from(process.id()) {
            RUNNING.store(id, Ordering::SeqCst);
        }
    }

    pub(super) fn end() {
        let id = RUNNING.swap(0, Ordering::SeqCst);
        if let Some(group) = Pid::from_raw(id) {
            // It may have ended by itself.
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
}

#[cfg(not(unix))]
mod group {
    pub(super) fn note(_: &std::process::Child) {}
    pub(super) fn end() {}
}
