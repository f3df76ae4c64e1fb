"""Runs cvc5 on an SMT-LIB file: run_cvc5.py SECONDS FILE, or run_cvc5.py --version."""

import signal
import sys

import cvc5


def run(seconds, path):
    # The solver runs outside of Python: only the signal's default action, the end, stops it.
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(seconds)
    solver = cvc5.Solver()
    parser = cvc5.InputParser(solver)
    parser.setFileInput(cvc5.InputLanguage.SMT_LIB_2_6, path)
    symbols = parser.getSymbolManager()
    while not (command := parser.nextCommand()).isNull():
        sys.stdout.write(command.invoke(solver, symbols))
        sys.stdout.flush()


if sys.argv[1:] == ["--version"]:
    print("cvc5", cvc5.__version__)
else:
    run(int(sys.argv[1]), sys.argv[2])
