/* The passivity monitor: one call a sample, in the control loop of a haptic device.
 *
 * Tell it the encoder's count and the force that you command; it answers whether the wall can have
 * given the operator more energy than was stored at the start, for every motion that the counts
 * allow. Any controller will do: only the force that was commanded counts. No allocation, no
 * floating point, no panic. Each sample: no loops, no divisions, a bounded number of instructions.
 * The start goes sixteen times around a loop with divisions; what was given takes one division.
 *
 * UNITS. Choose one unit of force for everything, fine enough that rounding to whole numbers does
 * not matter, such as a thousandth of the spring's force at one encoder tick. With tick D and
 * sampling period T:
 *
 *     stiffness        K D, the force of the wall's spring at one tick
 *     viscous          b D / T, the least force of viscous friction at one tick a sample, rounded down,
 *                      with the longest T
 *     coulomb          c, the least Coulomb friction, rounded down
 *     ..._at_most      the most that either can be, rounded up; viscous_at_most with the shortest T
 *     force            the commanded force, exact, positive in the direction of rising counts
 *     count            from where the wall begins: the spring has no energy at count 0; unwrapped
 *     energies         in halves of the unit of force times a tick
 *
 * COUNTERS THAT WRAP. Unwrap the count: add up the changes of the counter. A wrap of up to 32767
 * ticks is taken for a motion over all of them, and friction would take so much over it that it hides
 * what follows: an active wall is called surely passive.
 *
 * MEMORY. A monitor that may be asked before it is started is zero before, as static ones are: what was
 * never written must not be read.
 *
 * THREADS. Each monitor is used by one thread, or interrupt handler, at a time.
 */
#ifndef PASSIVITY_MONITOR_H
#define PASSIVITY_MONITOR_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Memory for a monitor: 320 bytes, wherever you like, aligned as a uint64_t is, which is mostly to 8
 * bytes. A variable of this type is; memory that you cut out of bytes has to be, which nothing checks.
 * What is in it is not for reading. */
typedef struct passivity_monitor {
    uint64_t opaque[40];
} passivity_monitor;

typedef struct passivity_monitor_config {
    int64_t stiffness;       /* each from 0 to 2^30, in the unit of force */
    int64_t viscous;
    int64_t coulomb;
    int64_t viscous_at_most; /* no less than viscous */
    int64_t coulomb_at_most; /* no less than coulomb */
    /* The energy that was stored at the start, from 0 to 2^62, for a wall that the device starts
     * outside of or a device that is moving; K D^2 / 8, rounded up to a whole one of these halves, is
     * allowed on top. Mostly: */
    int64_t stored_at_start;
} passivity_monitor_config;

/* stored_at_start: K x^2 / 2 at the first count. */
#define PASSIVITY_STORED_BY_THE_SPRING (-1)

/* Answers. */
enum {
    PASSIVITY_SURELY_PASSIVE = 0, /* no more was given at any sample so far */
    PASSIVITY_OPEN = 1,           /* the counts leave it open */
    PASSIVITY_SURELY_ACTIVE = 2,  /* more was given at one and the same sample, wherever between the
                                   * ticks the positions were */
    PASSIVITY_UNKNOWN = 3         /* a number did not fit, or the monitor was not started: until it
                                   * starts anew nothing shows that the wall is passive */
};

/* Which number did not fit. */
enum {
    PASSIVITY_START_DOES_NOT_FIT = 1,  /* the energy that the spring stores at the first count */
    PASSIVITY_STEP_DOES_NOT_FIT = 2,   /* the count changed by more than 32767 in one sample */
    PASSIVITY_ENERGY_DOES_NOT_FIT = 3  /* a sum of energies does not fit in 64 bits */
};

/* What passivity_monitor_start returns for a null pointer, to the monitor or to the configuration. */
#define PASSIVITY_NULL (-1)

/* Starts a monitor at the first sample, or anew: 0 when all is well, else which field of the
 * configuration is out of range, from 1 for stiffness to 6 for stored_at_start, or PASSIVITY_NULL; then
 * no monitor runs, nor does one that ran before: every sample is PASSIVITY_UNKNOWN. `force` is held
 * from now until the next sample. So far from count 0 that the stored energy does not fit, it returns
 * 0 too: passivity_monitor_saturation is PASSIVITY_START_DOES_NOT_FIT, and every sample
 * PASSIVITY_UNKNOWN. */
int32_t passivity_monitor_start(passivity_monitor *monitor,
                                const passivity_monitor_config *config, int32_t count,
                                int32_t force);

/* The next sample, one sampling period later: the count, and the force that is held from now until
 * the one after. The answer is about the motion up to this sample. */
int32_t passivity_monitor_sample(passivity_monitor *monitor, int32_t count, int32_t force);

/* The energy given up to the last sample beyond what was stored at the start: surely no less than
 * *least, surely no more than *most. 1, or 0 where that is not known. Either may be NULL. */
int32_t passivity_monitor_given(const passivity_monitor *monitor, int64_t *least, int64_t *most);

/* Which number did not fit, and in *sample, unless NULL, at which sample, from 0; 0 where all did. */
int32_t passivity_monitor_saturation(const passivity_monitor *monitor, uint64_t *sample);

#ifdef __cplusplus
}
#endif

#endif
