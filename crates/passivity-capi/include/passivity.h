/* passivity: the exact energy ledger of a sampled virtual wall, and the verdict on a scene.
 *
 * Numbers are exact and go in and out as text: "3/8", "0.375", "3.75e-1". Every call gives a JSON
 * document as a string that ends in a zero byte, to be released with passivity_free; NULL only
 * when an argument that must be there is NULL. Calls may be made from any thread.
 *
 * Link with -lpassivity, or with libpassivity.a and -lpthread -ldl -lm.
 */
#ifndef PASSIVITY_H
#define PASSIVITY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The answer to a request of the line protocol, as `passivity oracle` gives it:
 * {"id": ..., "result": {...}} or {"id": ..., "error": {"kind", "message", "at"}}. */
char *passivity_answer(const char *request, size_t length);

/* The ledger row of one interval from xi0 to xi1 (encoder ticks) that takes dtau sampling periods
 * (NULL for 1), with friction beta = b/(KT) and sigma = c/(K Delta): {"result": {...}} as above. */
char *passivity_interval(const char *xi0, const char *xi1, const char *beta, const char *sigma,
                         const char *dtau);

/* The same for encoder counts: every figure an exact enclosure {"lo", "hi", "approx"}, every
 * answer true, false or null for "it depends". */
char *passivity_interval_of_counts(long long count0, long long count1, const char *beta,
                                   const char *sigma, const char *dtau);

/* The verdict on a scene, given as the text of a scene file (TOML): {"result": {...}} with the
 * fields of `passivity check --format json`, or {"error": {...}}. */
char *passivity_check(const char *scene_toml);

/* The version, such as "0.1.0"; not to be released. */
const char *passivity_version(void);

/* Releases a string that a call gave. NULL is allowed. */
void passivity_free(char *answer);

#ifdef __cplusplus
}
#endif

#endif
