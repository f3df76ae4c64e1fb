#!/usr/bin/env bash
# Prints the full statement of each `Theorem` of the files in _CoqProject, hypotheses and all.
set -euo pipefail
cd "$(dirname "$0")"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
  for file in $(grep '\.v$' _CoqProject); do echo "Require Passivity.${file%.v}."; done
  echo "Set Printing Width 110. Set Printing Depth 1000. Open Scope R_scope."
  for file in $(grep '\.v$' _CoqProject); do
    module=${file%.v}
    sed -nE "s/^ *Theorem +([A-Za-z0-9_']+).*/\1/p" "$file" | while read -r name; do
      echo "Check Passivity.$module.$name."
    done
  done
} > "$work/Statements.v"
sed -i '1i From Coq Require Import Reals.' "$work/Statements.v"
coqc -w -ambiguous-paths -Q . Passivity "$work/Statements.v"
