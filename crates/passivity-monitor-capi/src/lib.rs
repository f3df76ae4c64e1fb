//! The passivity monitor for control loops in C; see `include/passivity_monitor.h`.
//!
//! The one place with unsafe code: monitors cross the border as pointers to memory of the caller. Each
//! function looks at its pointers once and does its work in safe Rust, in which nothing panics.
#![no_std]
#![allow(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

use core::mem::MaybeUninit;

use passivity_monitor::{Answer, Config, ConfigError, Monitor};

/// Without an operating system a panic has nowhere to go. None of these functions panics, so this is
/// never called, and a linker that drops unused sections leaves it out.
#[cfg(not(feature = "std"))]
#[panic_handler]
fn never(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}

/// What the first word of a monitor is once it was started.
const STARTED: u64 = 0x7061_7373_6976_6974;

/// How many words a C program keeps for a monitor besides the first.
const WORDS: usize = 39;

/// `passivity_monitor`: memory of the caller, in which a monitor is.
#[repr(C)]
pub struct Memory {
    started: u64,
    monitor: MaybeUninit<Monitor<i64>>,
    // The rest of it is not touched.
}

const _: () = assert!(size_of::<Memory>() <= (1 + WORDS) * size_of::<u64>());
const _: () = assert!(align_of::<Memory>() == align_of::<u64>());

/// `passivity_monitor_config`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Parameters {
    stiffness: i64,
    viscous: i64,
    coulomb: i64,
    viscous_at_most: i64,
    coulomb_at_most: i64,
    stored_at_start: i64,
}

/// `PASSIVITY_STORED_BY_THE_SPRING`.
const STORED_BY_THE_SPRING: i64 = -1;

/// `PASSIVITY_NULL`.
const NULL: i32 = -1;

/// The configuration of these parameters, or the number of the one that is wrong.
fn config(parameters: &Parameters) -> Result<Config, i32> {
    let number = |error: ConfigError| error.parameter() as i32;
    let config = Config::new(parameters.stiffness, parameters.viscous, parameters.coulomb);
    let (viscous, coulomb) = (parameters.viscous_at_most, parameters.coulomb_at_most);
    let config = config
        .and_then(|config| config.with_friction_at_most(viscous, coulomb))
        .map_err(number)?;
    match parameters.stored_at_start {
        STORED_BY_THE_SPRING => Ok(config),
        energy => config.with_stored_at_start(energy).map_err(number),
    }
}

/// Whether a monitor was started at a pointer.
///
/// # Safety
///
/// The pointer is null or points at a `passivity_monitor` that nothing else writes meanwhile: one that
/// [`passivity_monitor_start`] was called for, or whose first word was written and is another than [`STARTED`], as of
/// memory that is zero.
unsafe fn is_started(memory: *const Memory) -> bool {
    // SAFETY: null or valid, as the caller vouches. The rest of the memory need not have been written.
    let first = unsafe { memory.cast::<u64>().as_ref() };
    first == Some(&STARTED)
}

/// The monitor at a pointer, if one was started there, to read.
///
/// # Safety
///
/// As of [`is_started`].
unsafe fn started<'a>(memory: *const Memory) -> Option<&'a Monitor<i64>> {
    // SAFETY: as the caller vouches; where the first word is there, so is a monitor.
    unsafe { is_started(memory).then(|| (*memory).monitor.assume_init_ref()) }
}

/// Starts a monitor in the memory of the caller: 0, the number of the parameter that is out of range, or
/// [`NULL`].
///
/// # Safety
///
/// `memory` is null or points at room for a `passivity_monitor`, which need not have been written and which nothing else
/// uses meanwhile; `parameters` is null or points at a `passivity_monitor_config`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_monitor_start(
    memory: *mut Memory,
    parameters: *const Parameters,
    count: i32,
    force: i32,
) -> i32 {
    if memory.is_null() {
        return NULL;
    }
    // SAFETY: null or valid, as the caller vouches.
    let parameters = unsafe { parameters.as_ref() };
    match parameters.map_or(Err(NULL), config) {
        Ok(config) => {
            let memory_of_a_monitor = Memory {
                started: STARTED,
                monitor: MaybeUninit::new(Monitor::start(config, count, force)),
            };
            // SAFETY: not null, and as large and as aligned as it has to be.
            unsafe { memory.write(memory_of_a_monitor) };
            0
        }
        Err(number) => {
            // SAFETY: the same; what was there is no monitor any more.
            unsafe { memory.cast::<u64>().write(0) };
            number
        }
    }
}

/// Takes a sample, and answers; [`Answer::Unknown`] of a monitor that was not started.
///
/// # Safety
///
/// `memory` is as of [`is_started`], and nothing else uses what it points at meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_monitor_sample(
    memory: *mut Memory,
    count: i32,
    force: i32,
) -> i32 {
    // SAFETY: as the caller vouches.
    if !unsafe { is_started(memory) } {
        return Answer::Unknown as i32;
    }
    // SAFETY: started, and nothing else uses it meanwhile.
    let monitor = unsafe { (*memory).monitor.assume_init_mut() };
    monitor.sample(count, force) as i32
}

/// The least and the most that was given, and 1; 0, and neither, where they are not known.
///
/// # Safety
///
/// `memory` is as of [`is_started`]; the others are null or point at a number that nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_monitor_given(
    memory: *const Memory,
    least: *mut i64,
    most: *mut i64,
) -> i32 {
    // SAFETY: as the caller vouches.
    let Some(given) = unsafe { started(memory) }.and_then(|monitor| monitor.given()) else {
        return 0;
    };
    for (to, energy) in [(least, given.least), (most, given.most)] {
        // SAFETY: null or valid, as the caller vouches.
        if let Some(to) = unsafe { to.as_mut() } {
            *to = energy;
        }
    }
    1
}

/// Which number did not fit, and at which sample; 0 where all did.
///
/// # Safety
///
/// `memory` is as of [`is_started`]; `sample` is null or points at a number that nothing else uses meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn passivity_monitor_saturation(
    memory: *const Memory,
    sample: *mut u64,
) -> i32 {
    // SAFETY: as the caller vouches.
    let Some(saturation) = unsafe { started(memory) }.and_then(|monitor| monitor.saturation())
    else {
        return 0;
    };
    // SAFETY: null or valid, as the caller vouches.
    if let Some(sample) = unsafe { sample.as_mut() } {
        *sample = saturation.sample;
    }
    saturation.quantity as i32
}
