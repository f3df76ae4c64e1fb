//! The program `passivity`: see `passivity-command` for what it does.

fn main() -> std::process::ExitCode {
    passivity_command::run()
}
