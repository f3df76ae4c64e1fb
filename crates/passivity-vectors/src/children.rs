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
        group::end(&self.process);
        // Where there are no process groups, or the group has gone already.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Ends every command that [`against`](crate::against) runs at present, with all that they started; nothing
/// where none runs. For a program that is interrupted.
pub fn end_children() {
    group::end_all();
}

#[cfg(unix)]
mod group {
    use std::process::Child;
    use std::sync::{Mutex, MutexGuard, PoisonError};

    use rustix::process::{Pid, Signal, kill_process_group};

    /// The process groups that run: several where several threads drive a command each.
    static RUNNING: Mutex<Vec<Pid>> = Mutex::new(Vec::new());

    fn running() -> MutexGuard<'static, Vec<Pid>> {
        RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn note(process: &Child) {
        running().push(Pid::from_child(process));
    }

    /// Ends the group of this process and no other.
    pub(super) fn end(process: &Child) {
        let own = Pid::from_child(process);
        let mut running = running();
        if let Some(at) = running.iter().position(|group| *group == own) {
            running.swap_remove(at);
            // It may have ended by itself.
            let _ = kill_process_group(own, Signal::KILL);
        }
    }

    pub(super) fn end_all() {
        for group in running().drain(..) {
            let _ = kill_process_group(group, Signal::KILL);
        }
    }
}

#[cfg(not(unix))]
mod group {
    pub(super) fn note(_: &std::process::Child) {}
    pub(super) fn end(_: &std::process::Child) {}
    pub(super) fn end_all() {}
}

#[cfg(test)]
mod tests {
    use std::io::{BufRead as _, BufReader};

    use super::Children;

    #[test]
    fn ending_a_command_leaves_the_others_alone() {
        let first = Children::start("sleep 60").expect("a shell");
        // The one that a single note of what runs would name.
        let mut second = Children::start("read line; echo \"$line\"").expect("a shell");
        drop(first);
        let input = second.process.stdin.take().expect("a pipe");
        std::io::Write::write_all(&mut &input, b"still here\n").expect("it listens");
        let output = second.process.stdout.take().expect("a pipe");
        let said = BufReader::new(output).lines().next();
        assert_eq!(said.expect("a line").expect("text"), "still here");
    }
}
