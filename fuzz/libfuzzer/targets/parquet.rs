#![no_main]

use std::sync::Once;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    // The library that reads Parquet asserts on some corrupt files, and the audit makes that an
    // error. libFuzzer would end at the panic: leave those of the library to the audit.
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let ours = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            let library = panic.location().is_some_and(|at| at.file().contains("/registry/"));
            if !library {
                ours(panic);
            }
        }));
    });
    (passivity_fuzz::target("parquet").run)(data);
});
