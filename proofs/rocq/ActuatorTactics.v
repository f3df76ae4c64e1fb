(** * Actuator tactics: the kernel's formulas of latency, lag and filtered damping. *)

From Coq Require Import Reals.
From Passivity Require Import Definitions ActuatorCost OnePole LagForm LagVariance LateLag.
Open Scope R_scope.

(** By algebra, whatever the inverses are of. *)
Ltac bridge_actuator :=
  intros; subst;
  unfold spare_mean, spare_square, late_lag_variance, latency_variance, lag_variance, residue,
    filtered_step, filter_share, Rdiv in *;
  ring.
