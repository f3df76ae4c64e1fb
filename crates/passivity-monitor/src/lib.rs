//! Is the virtual wall passive so far? An answer in the control loop itself, at every sample.
//!
//! A haptic device renders a virtual wall by a force that is computed from an encoder's count and
//! held until the next sample. Sampling and quantization generate energy, friction dissipates it; where
//! more is generated, the operator's hand is driven. A [`Monitor`] takes two integers a sample, the
//! count and the force that was commanded, and answers with what can be said for sure:
//!
//! | [`Answer`] | means |
//! | --- | --- |
//! | `SurelyPassive` | at no sample so far can the operator have drawn more than was stored at the start |
//! | `SurelyActive` | at one and the same sample more had been drawn, wherever between the ticks the positions were |
//! | `Open` | the counts leave it open |
//! | `Unknown` | a number did not fit: nothing is shown until the monitor starts anew; [`Monitor::saturation`] says which, and where |
//!
//! and with both bounds of the energy, [`Monitor::given`]. Any controller will do, linear or not:
//! only the force that was commanded counts.
//!
//! What it is **not**: it does not change the force (a passivity *controller* does), it knows no
//! units, and it allocates nothing, uses no floating point and no unsafe code, and does not panic. A sample has no
//! loops and no divisions; [`Config::new`], which may run when the program is compiled, has both, and
//! [`Monitor::given`] one division.
//!
//! # Units
//!
//! Choose one unit of force for everything, fine enough that rounding to whole numbers does not
//! matter. With the encoder's tick Δ and the sampling period T:
//!
//! | number | is | round |
//! | --- | --- | --- |
//! | `stiffness` | KΔ, the force of the wall's spring at one tick | to the nearest |
//! | `viscous` | bΔ/T, the device's viscous friction at one tick a sample | down; T the longest period |
//! | `coulomb` | c, its Coulomb friction | down |
//! | [`with_friction_at_most`](Config::with_friction_at_most) | the most that either can be | up; T the shortest period |
//! | force | the commanded force, positive towards rising counts | exact |
//! | count | from where the wall's spring is relaxed, and unwrapped | |
//! | energies | in halves of the unit of force times a tick | outward |
//!
//! # Example
//!
//! An encoder of 8192 counts per turn at 1 kHz, b = 9·10⁻⁶ N·m·s/rad, c = 2·10⁻³ N·m, and a wall of
//! K = 2 N·m/rad, in µN·m: KΔ = 1533.98, bΔ/T = 6.90, c = 2000.
//!
//! ```
//! use passivity_monitor::{Answer, Config, Monitor};
//!
//! const CONFIG: Config = match Config::new(1534, 6, 2000) {
//!     Ok(config) => config,
//!     Err(_) => panic!("a parameter is out of range"),
//! };
//!
//! // Stands for the encoder, the control law and the amplifier.
//! let read_counter = |sample: i32| [0, 0, 1, 2, 2, 2, 1, 1, 0][sample as usize];
//! let law = |count: i32| -(1534 * count + 767);
//!
//! let count = read_counter(0);
//! let mut monitor = Monitor::<i64>::start(CONFIG, count, law(count));
//! for sample in 1..9 {
//!     let count = read_counter(sample);
//!     let force = law(count);
//!     match monitor.sample(count, force) {
//!         Answer::SurelyPassive | Answer::Open => {}
//!         Answer::SurelyActive => unreachable!("here the loop would lower its stiffness"),
//!         Answer::Unknown => unreachable!("here it would stop rendering, and start anew"),
//!     }
//! }
//! let given = monitor.given().expect("all numbers fit");
//! assert!(given.least <= given.most);
//! ```
//!
//! # What is claimed
//!
//! Let the position at sample i be x_i, anywhere within the tick of its count, and U_h the energy
//! that the held forces gave up to sample h, less what friction takes at least, less what was stored at
//! the start. TH-MONITOR, as this crate has it:
//!
//! - **least ≤ U_h ≤ most** for all such positions; [`account`] has the proof.
//! - **least is exact**: some positions give it. So it is told when at one and the same sample more had been drawn,
//!   wherever between the ticks the positions were, and never by mistake. Where more had surely been drawn at one of
//!   several samples, and the positions decide at which, the answer stays `Open`.
//! - **A passive wall stays surely passive**: under the wall's own force, where b ≥ KT/2 and c ≥ KΔ/2, for
//!   ever.
//! - **Nothing wraps or panics**: what does not fit ends in `Unknown`. What was surely active before
//!   stays so.
//!
//! What the theory leaves open is settled like this:
//!
//! - *Kinetic energy* is in no count. The operator can take it at any time, so it counts as given.
//!   If the device moves at the start, say what it has with
//!   [`with_stored_at_start`](Config::with_stored_at_start).
//! - *The start* is any sample. K says no more than what is stored there, ½Kx² with x from where the
//!   spring is relaxed; the force may be of any law. For a wall that the device starts outside of,
//!   nothing is stored: `with_stored_at_start(0)`. K also shapes the upper bound, which is tightest for the
//!   stiffness that the wall has, and does not grow at rest under a force that stays the same where KΔ ≤ 2c. Give
//!   the K that the wall has: with a smaller one less counts as stored, and a passive wall that lets the device out is
//!   called surely active.
//! - *A count* n stands for n ≤ x < n + 1. The bounds are those of n ≤ x ≤ n + 1, which are the same:
//!   energy is continuous in the positions.
//! - *A counter that wraps* must be unwrapped first: add up its changes. A wrap is taken for a motion over all those
//!   ticks, up to 32767 in one sample with 64-bit sums and up to 2³¹ − 1 with 128-bit sums. Friction would take so much
//!   over it that it hides what follows: an active wall is called surely passive. Only a longer one is `Unknown`.
//! - *A force that comes late* by whole samples: give each call the force that is in effect from then
//!   on, not the one that was computed then. If the output changes within the period, read the encoder when it
//!   changes. A force that is known to within e only: take e from `coulomb`, and add it to the most.
//! - *A late sample*: the force was held, so the account goes on. Only viscous friction takes less
//!   over a longer time, which is why T is the longest period there. After samples that were lost for good,
//!   start anew.
//! - *Between samples* a device may go there and back. Friction then takes more than is counted, from
//!   what the operator put in; so `SurelyActive` is about the wall: with these counts, moved no
//!   farther than they show, it gives more than was stored.
//!
//! # Cost
//!
//! A sample has no loop and no division. On x86-64, the call included and as the workspace builds it, with 64-bit
//! sums it takes 74 to 92 instructions in the ways that `cargo bench -p passivity-monitor` counts under valgrind: at
//! rest, at a few and at many ticks a sample, outside of the wall, open, surely active, and as the answer changes.
//! That last one is the longest way through the machine code, and is taken at most once. With 128-bit sums it takes
//! 79 to 100: what samples change of the sums is kept in 64 bits. Samples that are too much for that take up to 320:
//! those with a force of 2⁴⁴ or more or a step of 2¹⁵ ticks or more, and the few others at which the 64 bits are
//! full.
#![no_std]
#![forbid(unsafe_code)]
#![deny(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::unreachable,
    clippy::indexing_slicing
)]

pub mod account;
pub mod kept;

mod config;
mod monitor;
mod width;

pub use config::{Config, ConfigError, Parameter};
pub use monitor::{Answer, Given, Monitor, Quantity, Saturation};
pub use width::{PARAMETER_MAX, Width};
