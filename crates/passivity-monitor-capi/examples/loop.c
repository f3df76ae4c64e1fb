/* A control loop that watches itself: a wall with virtual damping, at 1 kHz.
 *
 * Here the device is behind standard input and output: each line in is an encoder count, each line
 * out the force to hold until the next one, so that a simulator can be at the other end. On a real
 * device the two functions read the counter and set the amplifier, and the loop is the interrupt
 * of the 1 kHz timer. With a file name the loop writes a log for `passivity audit`, and at the end of the
 * input it says on standard error what the monitor said:
 *
 *     ANSWER LEAST MOST
 *
 * the answer, and the largest that the least and the most energy were at any sample after the first.
 */
#include <inttypes.h>
#include <stdio.h>

#include "passivity_monitor.h"

/* The unit of force is a thousandth of K D, the spring's force at one tick. */
enum { STIFFNESS = 1000, DAMPING = 300 };

static const passivity_monitor_config config = {
    .stiffness = STIFFNESS,
    .viscous = 2500,          /* b D / T of the device, at the least */
    .coulomb = 1200,          /* c of the device, at the least */
    .viscous_at_most = 2500,  /* here they are known exactly */
    .coulomb_at_most = 1200,
    .stored_at_start = PASSIVITY_STORED_BY_THE_SPRING,
};

static int read_counter(int32_t *count) {
    return scanf("%" SCNd32, count) == 1;
}

static void set_amplifier(int32_t force) {
    printf("%" PRId32 "\n", force);
    fflush(stdout);
}

/* What the amplifier can be told: a force beyond 32 bits is saturated, to either side alike. */
static int32_t held(int64_t force) {
    return (int32_t)(force > INT32_MAX ? INT32_MAX : force < -INT32_MAX ? -INT32_MAX : force);
}

/* In units of K D, exactly: a thousandth is three decimals. */
static void write_log(FILE *log, int32_t count, int32_t force) {
    int32_t size = force < 0 ? -force : force;
    fprintf(log, "%" PRId32 ",%s%" PRId32 ".%03" PRId32 "\n", count, force < 0 ? "-" : "", size / 1000,
            size % 1000);
}

int main(int argc, char **argv) {
    static passivity_monitor monitor;
    FILE *log = argc > 1 ? fopen(argv[1], "w") : NULL;
    int64_t highest_least = INT64_MIN, highest_most = INT64_MIN;
    int32_t answer = PASSIVITY_UNKNOWN, count, before = 0;
    int renders = 1;

    if (argc > 1 && log == NULL) {
        perror(argv[1]);
        return 1;
    }
    if (log) {
        fputs("count,f\n", log);
    }
    for (int started = 0; read_counter(&count); started = 1) {
        int64_t moved = started ? (int64_t)count - before : 0;
        /* The middle of the tick, as the count is its lower end. */
        int64_t wall = -(STIFFNESS * (int64_t)count + STIFFNESS / 2 + DAMPING * moved);
        int32_t force = renders ? held(wall) : 0;
        set_amplifier(force);
        before = count;
        if (log) {
            write_log(log, count, force);
        }
        if (!started) {
            if (passivity_monitor_start(&monitor, &config, count, force) != 0) {
                fputs("the configuration is out of range\n", stderr);
                return 1;
            }
            /* So far from where the wall begins that the stored energy does not fit: unknown for good. */
            renders = passivity_monitor_saturation(&monitor, NULL) != PASSIVITY_START_DOES_NOT_FIT;
            continue;
        }
        answer = passivity_monitor_sample(&monitor, count, force);
        if (answer == PASSIVITY_SURELY_ACTIVE) {
            /* Here a real loop lowers its stiffness, or switches the wall off. */
        }
        if (answer == PASSIVITY_UNKNOWN) {
            /* A number did not fit, and nothing shows any more that the wall is passive. A real loop
             * starts monitor and wall anew when the device rests where the wall begins. */
            renders = 0;
        }
        int64_t least, most;
        if (passivity_monitor_given(&monitor, &least, &most)) {
            highest_least = least > highest_least ? least : highest_least;
            highest_most = most > highest_most ? most : highest_most;
        }
    }
    fprintf(stderr, "%" PRId32 " %" PRId64 " %" PRId64 "\n", answer, highest_least, highest_most);
    return log && fclose(log) != 0;
}
