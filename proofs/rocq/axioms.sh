#!/usr/bin/env bash
# Prints one line for each `Theorem` of the files in _CoqProject: its name, and the names of the
# axioms that `Print Assumptions` finds under it.
set -euo pipefail
cd "$(dirname "$0")"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for file in $(grep '\.v$' _CoqProject); do
  module=${file%.v}
  echo "Require Passivity.$module."
  sed -nE "s/^ *Theorem +([A-Za-z0-9_']+).*/\1/p" "$file" | while read -r name; do
    echo "Locate Passivity.$module.$name. Print Assumptions Passivity.$module.$name."
  done
done > "$work/Assumptions.v"
coqc -w -ambiguous-paths -Q . Passivity "$work/Assumptions.v" > "$work/out"
awk '
  /^Constant /                  { if (line != "") print line; line = $2 ":"; next }
  /^Closed under the global/    { line = line " no axioms"; next }
  /^[A-Za-z_][A-Za-z0-9_.'"'"']*( :|$)/ { if ($1 != "Axioms:") { n = split($1, p, "."); line = line " " p[n] } }
  END                           { print line }
' "$work/out"
