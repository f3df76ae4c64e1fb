/* Calls every function of the library and checks what comes back. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "passivity.h"

static int failures = 0;

static void expect(const char *what, char *answer, const char *part) {
    if (answer == NULL || strstr(answer, part) == NULL) {
        fprintf(stderr, "%s: expected %s in %s\n", what, part, answer ? answer : "(null)");
        failures++;
    }
    passivity_free(answer);
}

int main(void) {
    const char *request = "{\"id\": 7, \"op\": \"interval\", \"xi0\": \"1\", \"xi1\": \"1/2\","
                          " \"beta\": \"3/5\", \"sigma\": \"3/5\", \"dtau\": \"1\"}";
    expect("answer", passivity_answer(request, strlen(request)), "\"margin\": \"3/10\"");
    expect("answer", passivity_answer(request, 3), "\"kind\": \"bad_json\"");
    expect("interval", passivity_interval("1", "0.5", "3/5", "0.6", NULL),
           "\"generated_quantized\": \"1/2\"");
    expect("interval", passivity_interval("1", "1/2", "3/5", "3/5", "1/2"),
           "\"dissipated_lower\": \"3/5\"");
    expect("interval", passivity_interval("1", "\xff", "3/5", "3/5", NULL), "\"at\": \"xi1\"");
    expect("counts", passivity_interval_of_counts(0, 1, "3/5", "3/5", NULL),
           "\"violates_linear\": false");
    expect("check", passivity_check("[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"\n"),
           "\"verdict\":\"passive\"");
    expect("check", passivity_check("[dimensionless]\nbeta = 1\n[nonsense]\n"), "\"error\"");
    expect("check of joints",
           passivity_check("[[joint]]\nviscous = \"1 N s/m\"\n[sampling]\nperiod = \"1 ms\"\n"
                           "[wall]\nstiffness = \"1 N/mm\"\ndirection = [\"1\"]\n"),
           "\"viscous_definite\":true");
    if (passivity_interval(NULL, "1", "1", "1", NULL) != NULL || passivity_check(NULL) != NULL ||
        passivity_answer(NULL, 5) != NULL || strlen(passivity_version()) < 5) {
        fprintf(stderr, "null arguments, or the version\n");
        failures++;
    }
    passivity_free(NULL);
    for (int i = 0; i < 10000; i++) {
        passivity_free(passivity_interval_of_counts(i, i + 1, "3/5", "3/5", NULL));
    }
    puts(failures ? "failed" : "ok");
    return failures ? EXIT_FAILURE : EXIT_SUCCESS;
}
