#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| c2warp_attacks::drawings::attack(bytes));
