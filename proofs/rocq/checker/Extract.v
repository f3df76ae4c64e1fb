(** The proved checker of Checker.v and the files after it as an OCaml program. *)

From Coq Require Import ZArith.
From Coq Require Extraction.
From Coq Require Import ExtrOcamlBasic.
From Passivity Require Import Checker CheckerFilter CheckerOnePole CheckerActuator
  CheckerGated CheckerLag.

Extraction Language OCaml.
Extraction "checker.ml" check check_damped check_filter late check_one_pole check_gated check_latency check_lag
  Z.add Z.mul Z.of_nat Z.compare.
