/* Calls every function of the library and checks what comes back. Needs no operating system: it is also
 * linked without a C library, where `check` is the whole program. */
#include "passivity_monitor.h"

static int check(void) {
    static passivity_monitor monitor;
    const passivity_monitor *reading = &monitor;
    passivity_monitor_config config = {1000, 500, 500, 500, 500, PASSIVITY_STORED_BY_THE_SPRING};
    int64_t least = 7, most = 7;
    uint64_t sample = 7;

    if (passivity_monitor_sample(&monitor, 0, 0) != PASSIVITY_UNKNOWN ||
        passivity_monitor_start(0, &config, 0, 0) != PASSIVITY_NULL ||
        passivity_monitor_start(&monitor, 0, 0, 0) != PASSIVITY_NULL ||
        passivity_monitor_sample(0, 0, 0) != PASSIVITY_UNKNOWN ||
        passivity_monitor_given(&monitor, &least, &most) != 0 || least != 7 || most != 7) {
        return 1;
    }

    /* A passive wall, felt in and out. */
    static const int32_t counts[] = {2, 5, 9, 11, 8, 4, 0, -3};
    if (passivity_monitor_start(&monitor, &config, 0, -500) != 0) {
        return 2;
    }
    for (unsigned i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        int32_t force = -(1000 * counts[i] + 500);
        if (passivity_monitor_sample(&monitor, counts[i], force) != PASSIVITY_SURELY_PASSIVE) {
            return 3;
        }
    }
    if (passivity_monitor_given(reading, &least, &most) != 1 || least > most || most > 0 ||
        passivity_monitor_given(reading, 0, 0) != 1 ||
        passivity_monitor_saturation(reading, &sample) != 0 || sample != 7) {
        return 4;
    }

    /* A force along the motion, which no wall gives. */
    for (int32_t count = 0; count < 4; count++) {
        passivity_monitor_sample(&monitor, 20 * count, 100000);
    }
    if (passivity_monitor_sample(&monitor, 80, 0) != PASSIVITY_SURELY_ACTIVE ||
        passivity_monitor_given(&monitor, &least, &most) != 1 || least <= 0) {
        return 5;
    }

    /* What could not be started is no monitor, nor is what ran there before. */
    if (passivity_monitor_start(&monitor, &config, 0, -500) != 0 ||
        passivity_monitor_sample(&monitor, 1, -1500) != PASSIVITY_SURELY_PASSIVE ||
        passivity_monitor_start(&monitor, 0, 0, 0) != PASSIVITY_NULL ||
        passivity_monitor_sample(&monitor, 1, -1500) != PASSIVITY_UNKNOWN) {
        return 10;
    }

    /* A step that is too long. A counter that wraps within 32767 ticks is not noticed. */
    if (passivity_monitor_start(&monitor, &config, 0, 0) != 0 ||
        passivity_monitor_sample(&monitor, 40000, 0) != PASSIVITY_UNKNOWN ||
        passivity_monitor_saturation(&monitor, &sample) != PASSIVITY_STEP_DOES_NOT_FIT ||
        sample != 1 || passivity_monitor_given(&monitor, &least, &most) != 0) {
        return 6;
    }

    /* So far from where the wall begins that the stored energy does not fit: that is no error of the
     * configuration, but unknown from the start on. */
    if (passivity_monitor_start(&monitor, &config, INT32_MIN, 0) != 0 ||
        passivity_monitor_saturation(reading, &sample) != PASSIVITY_START_DOES_NOT_FIT ||
        sample != 0 || passivity_monitor_sample(&monitor, INT32_MIN, 0) != PASSIVITY_UNKNOWN) {
        return 9;
    }

    config.coulomb_at_most = 499;
    if (passivity_monitor_start(&monitor, &config, 0, 0) != 5 ||
        passivity_monitor_sample(&monitor, 0, 0) != PASSIVITY_UNKNOWN) {
        return 7;
    }
    config.coulomb_at_most = 500;
    config.stiffness = -1;
    if (passivity_monitor_start(&monitor, &config, 0, 0) != 1) {
        return 8;
    }
    return 0;
}

#ifdef BARE
/* What any C compiler asks of an environment without a C library. */
void *memcpy(void *restrict to, const void *restrict from, unsigned long size) {
    for (unsigned long i = 0; i < size; i++) {
        ((volatile unsigned char *)to)[i] = ((const unsigned char *)from)[i];
    }
    return to;
}

void *memset(void *to, int value, unsigned long size) {
    for (unsigned long i = 0; i < size; i++) {
        ((volatile unsigned char *)to)[i] = (unsigned char)value;
    }
    return to;
}

void bare(void) {
    int code = check();
    __asm__ volatile("syscall" : : "a"(60), "D"(code) : "rcx", "r11", "memory");
}

/* The stack is aligned here as it is before a call. */
__asm__(".globl _start\n_start:\n\tcall bare\n");
#else
int main(void) {
    return check();
}
#endif
