#!/usr/bin/env bash
# Installs Rocq (Debian: coq 8.16), Coquelicot and OCaml, for the extracted checker, where they are missing.
# Exit codes: 0 they are there, 3 they are not and could not be installed.
set -euo pipefail

there() {
  command -v coqc > /dev/null && command -v coq_makefile > /dev/null &&
    command -v ocamlfind > /dev/null && command -v ocamlopt > /dev/null &&
    [ -d "$(coqc -where)/user-contrib/Coquelicot" ]
}

if there; then exit 0; fi
if command -v apt-get > /dev/null; then
  root=""
  if [ "$(id -u)" != 0 ]; then root="sudo -n"; fi
  echo "installing coq, libcoq-coquelicot and ocaml"
  { $root apt-get update -qq && $root apt-get install -y -qq --no-install-recommends \
      coq libcoq-coquelicot ocaml-nox ocaml-findlib; } > install.log 2>&1 || tail -n 5 install.log
  rm -f install.log
fi
if there; then exit 0; fi
echo "rocq: not run here (coq, libcoq-coquelicot and ocaml are not installed and could not be)" >&2
exit 3
