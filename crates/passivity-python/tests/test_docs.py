"""The examples in the documentation of the package."""

import doctest
import importlib.metadata

import passivity
import passivity.adaptive
import passivity.results

for module, least in ((passivity, 15), (passivity.adaptive, 4), (passivity.results, 1)):
    tried = doctest.testmod(module)
    assert tried.attempted >= least and not tried.failed, (module, tried)

readme = importlib.metadata.metadata("passivity")["Description"]
examples = doctest.DocTestParser().get_doctest(
    readme.replace("```", "\n"), {}, "README.md", "README.md", 0
)
result = doctest.DocTestRunner().run(examples)
assert result.attempted >= 6 and not result.failed, result
