//! Commands that this build leaves out: each names the feature that provides it.

/// Modules of verbs, each with the feature that it needs.
macro_rules! absent {
    ($($feature:literal: $($verb:ident)+;)+) => {$($(
        #[cfg(not(feature = $feature))]
        pub(crate) mod $verb {
            use crate::exit::{Exit, Failure};

            #[derive(Debug, clap::Args)]
            #[command(
                about = concat!("Not in this build: it needs the feature `", $feature, "`"),
                disable_help_flag = true
            )]
            pub(crate) struct Args {
                /// Whatever is typed: it makes no difference.
                #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
                _rest: Vec<std::ffi::OsString>,
            }

            pub(crate) fn run(_: &Args) -> Result<Exit, Failure> {
                Err(Failure::input(concat!(
                    "`passivity ", stringify!($verb), "` is not in this build: build it with the feature `",
                    $feature, "`, or all of it with `cargo install --path crates/passivity-cli`"
                )))
            }
        }
    )+)+};
}

absent! {
    "audit": audit;
    "case": case;
    "identify": identify;
    "oracle": oracle;
    "plot": plane;
    "simulate": accuracy simulate sweep;
    "vectors": vectors;
}

#[cfg(test)]
mod tests {
    use clap::Parser as _;

    use crate::args::Args;
    use crate::exit::Failure;

    /// What `passivity` says to `words`, and that it is said as bad usage, which exits with 2.
    fn refusal(words: &str) -> String {
        let args = Args::try_parse_from(words.split(' ')).map_err(|error| {
            assert_eq!(error.exit_code(), 2, "{words}");
            error.to_string()
        });
        match args.map(|args| crate::verbs::run(&args.command)) {
            Err(message) | Ok(Err(Failure::Input(message))) => message,
            Ok(other) => panic!("{words}: {other:?}"),
        }
    }

    #[test]
    #[cfg(not(feature = "vectors"))]
    fn a_verb_that_is_left_out_names_its_feature() {
        for words in [
            "passivity vectors",
            "passivity vectors --help",
            "passivity vectors --out a b",
        ] {
            let message = refusal(words);
            assert!(
                message.contains("the feature `vectors`"),
                "{words}: {message}"
            );
        }
    }

    #[test]
    #[cfg(all(feature = "simulate", not(feature = "plot")))]
    fn a_picture_that_cannot_be_drawn_names_its_feature() {
        let message = refusal("passivity simulate no-such.toml --plot motion.svg");
        assert!(message.contains("the feature `plot`"), "{message}");
    }
}
