"""Runs cvc5 on SMT-LIB files: run_cvc5.py SECONDS, or run_cvc5.py --version.

Reads the names of files from standard input, a line each. What cvc5 says to a file is followed by the
line "end". To load cvc5 takes longer than most answers do, so it is loaded once; each file has a
process of its own, which may take SECONDS.
"""

import os
import signal
import sys

import cvc5


def answer(seconds, path):
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


def serve(seconds):
    for line in sys.stdin:
        child = os.fork()
        if child == 0:
            try:
                answer(seconds, line.rstrip("\n"))
            except Exception as error:
                print("error:", error, flush=True)
            os._exit(0)
        os.waitpid(child, 0)
        print("end", flush=True)


if sys.argv[1:] == ["--version"]:
    print("cvc5", cvc5.__version__)
else:
    serve(int(sys.argv[1]))
