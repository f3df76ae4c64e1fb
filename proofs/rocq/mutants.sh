#!/usr/bin/env bash
# Changes one definition at a time by adding 1 to it; the bridge must then fail to compile.
# A definition that can change without the bridge noticing is one nobody compares with the code.
set -euo pipefail
cd "$(dirname "$0")"

# Quantizer.v is there for `floor`, which has a specification instead of a formula of the kernel.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
files=(Definitions.v Quantizer.v BridgeTactics.v ControllerTactics.v BridgePaper.v BridgeEffects.v
  BridgeUnits.v BridgeController.v)
cp "${files[@]}" "$work"

compiles() { # stops at the first file that does not
  for file in "${files[@]}"; do
    (cd "$work" && coqc -w -ambiguous-paths -Q . Passivity "$file" > "$work/log" 2>&1) || return 1
  done
}

compiles || { echo "the bridge does not compile as it is"; cat "$work/log"; exit 1; }
caught=0
survived=0
# The definitions of numbers: `Definition name ... : R := body.`
for name in $(tr '\n' ' ' < Definitions.v |
  grep -oE 'Definition [a-zA-Z0-9_]+ \([^)]*\)( \([^)]*\))* : R :=' |
  awk '{print $2}'); do
  if [ "$name" = margin_8 ]; then continue; fi # as printed; the kernel has it multiplied out
  awk -v name="$name" '
    BEGIN { RS = ""; ORS = "\n\n" }
    {
      at = index($0, "Definition " name " ")
      if (at > 0) {
        head = substr($0, 1, at - 1); rest = substr($0, at)
        colon = index(rest, ":="); body = substr(rest, colon + 2)
        stop = match(body, /\.(\n|$)/)
        $0 = head substr(rest, 1, colon + 1) " (" substr(body, 1, stop - 1) ") + 1" substr(body, stop)
      }
      print
    }' Definitions.v > "$work/Definitions.v"
  if cmp -s Definitions.v "$work/Definitions.v"; then echo "not changed: $name"; exit 1; fi
  if compiles; then
    echo "survived: $name"
    survived=$((survived + 1))
  else
    # It must be the bridge that fails, not the changed definition.
    if ! (cd "$work" && coqc -w -ambiguous-paths -Q . Passivity Definitions.v > /dev/null 2>&1); then
      echo "the changed $name is not a definition"
      exit 1
    fi
    caught=$((caught + 1))
  fi
done
echo "mutants of Definitions.v: $caught caught by the bridge, $survived survived"
[ "$survived" = 0 ] && [ "$caught" -gt 40 ]
