#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| (passivity_fuzz::target("mcap").run)(data));
