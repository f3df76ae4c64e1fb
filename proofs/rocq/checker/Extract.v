(** The proved checker of Checker.v as an OCaml program. *)

From Coq Require Import ZArith.
From Coq Require Extraction.
From Coq Require Import ExtrOcamlBasic.
From Passivity Require Import Checker.

Extraction Language OCaml.
Extraction "checker.ml" check Z.add Z.mul Z.of_nat Z.compare.
