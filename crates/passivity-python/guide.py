"""Runs a notebook from its start to its end: every cell must run, and its assertions must hold.

    python guide.py NOTEBOOK
"""

import sys

import nbformat
from nbclient import NotebookClient

notebook = nbformat.read(sys.argv[1], as_version=4)
nbformat.validate(notebook)
NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
shown = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
assert any("image/png" in output.get("data", {}) for output in shown), "the guide shows its map"
if "--show" in sys.argv:
    for output in shown:
        print(output.get("text") or output.get("data", {}).get("text/plain"))
print(f"{sys.argv[1]}: {len(notebook.cells)} cells, all run")
