#!/bin/sh
# Builds the wheel and tests it from a fresh virtual environment, with and without NumPy.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
venv=$(mktemp -d)
trap 'rm -rf "$venv"' EXIT
python3 -m venv "$venv"
"$venv/bin/pip" install --quiet 'maturin>=1.9,<2'
"$venv/bin/maturin" build --quiet --release --manifest-path "$here/Cargo.toml" \
    --interpreter "$venv/bin/python" --out "$venv/wheels"
"$venv/bin/pip" install --quiet --no-index "$venv"/wheels/*.whl
cd "$venv"
cp "$here/tests/test_passivity.py" .
"$venv/bin/python" -m unittest -q test_passivity
"$venv/bin/python" -c 'import doctest, passivity
tried = doctest.testmod(passivity)
assert tried.attempted >= 3 and not tried.failed, tried'
"$venv/bin/pip" install --quiet numpy
"$venv/bin/python" -m unittest -q test_passivity
echo "the wheel passes its tests, without and with NumPy"
