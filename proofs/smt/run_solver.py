"""Runs a solver on SMT-LIB files: run_solver.py z3|cvc5 SECONDS, or run_solver.py z3|cvc5 --version.

Reads the names of files from standard input, a line each. What the solver says to a file is followed by
the line "end". To load a solver takes longer than most answers do, so it is loaded once; each file has a
solver of its own. Where one takes more than SECONDS, all of it ends.
"""

import signal
import sys


def cvc5_says(path):
    solver = cvc5.Solver()
    parser = cvc5.InputParser(solver)
    parser.setFileInput(cvc5.InputLanguage.SMT_LIB_2_6, path)
    symbols = parser.getSymbolManager()
    said = ""
    while not (command := parser.nextCommand()).isNull():
        said += command.invoke(solver, symbols)
    return said


def z3_says(path):
    context = z3.Context()
    with open(path, encoding="utf-8") as file:
        return z3.Z3_eval_smtlib2_string(context.ref(), file.read())


def serve(says, seconds):
    for line in sys.stdin:
        # The solver runs outside of Python: only the signal's default action, the end, stops it.
        signal.alarm(seconds)
        try:
            said = says(line.rstrip("\n"))
        except Exception as error:
            said = f"error: {error}"
        signal.alarm(0)
        print(said.removesuffix("\n"), "end", sep="\n", flush=True)


name, what = sys.argv[1:]
if name == "cvc5":
    import cvc5

    says, version = cvc5_says, cvc5.__version__
else:
    import z3

    says, version = z3_says, z3.get_version_string()
if what == "--version":
    print(name, version)
else:
    serve(says, int(what))
