#!/bin/sh
# Builds the wheel and tests it from fresh virtual environments: by itself, with NumPy, and with all that it
# can work with. PYTHON names the interpreter; the wheel is the same for all versions from 3.11 on.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
python=${PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$here/tests" "$work/tests"
cd "$work/tests"

environment() {
    "$python" -m venv "$work/$1"
    bin=$work/$1/bin
    shift
    [ $# -eq 0 ] || "$bin/pip" install --quiet "$@"
    [ ! -d "$work/wheels" ] || "$bin/pip" install --quiet --no-index "$work"/wheels/*.whl
}

environment build 'maturin>=1.9,<2'
"$bin/maturin" build --quiet --release --manifest-path "$here/Cargo.toml" \
    --interpreter "$bin/python" --out "$work/wheels"

environment alone
"$bin/python" -W error::ResourceWarning -m unittest -q test_passivity test_given test_native
"$bin/python" test_docs.py
environment numpy numpy
"$bin/python" -m unittest -q test_passivity test_given test_native
environment all numpy pandas polars pyarrow matplotlib 'dask[distributed]' fsspec mypy pyright nbclient nbformat ipykernel
"$bin/python" -m unittest -q test_passivity test_given test_native test_plot test_distributed
"$bin/python" test_docs.py
bin_of_all=$bin
echo "== parts and sweeps in a store: an S3 server on this machine"
environment store numpy pyarrow 'dask[distributed]' s3fs 'moto[server]'
"$bin/python" -m unittest -q test_store
bin=$bin_of_all
echo "== mypy --strict, stubtest and pyright"
"$bin/mypy" --strict typed.py
"$bin/python" -m mypy.stubtest passivity --ignore-missing-stub
"$bin/pyright" --pythonpath "$bin/python" typed.py
echo "== the guide"
"$bin/python" "$here/guide.py" "$here/../../docs/z-width.ipynb"
echo "the wheel passes its tests: alone, with NumPy, and with all that it works with"
