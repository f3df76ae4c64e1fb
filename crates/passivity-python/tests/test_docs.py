"""The examples in the documentation of the package."""

import doctest

import passivity
import passivity.adaptive
import passivity.results

for module, least in ((passivity, 15), (passivity.adaptive, 4), (passivity.results, 1)):
    tried = doctest.testmod(module)
    assert tried.attempted >= least and not tried.failed, (module, tried)
