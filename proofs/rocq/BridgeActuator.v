(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics ActuatorTactics ActuatorCost OnePole LagForm LateLag.
Open Scope R_scope.

(** [actuator::spare] *)
Definition kernel_spare_mean (beta m Var : R) : R :=
  ((beta - (1 / 2)) - m).
Lemma bridge_spare_mean : forall beta m Var,
  kernel_spare_mean beta m Var = spare_mean beta m.
Proof. unfold kernel_spare_mean. bridge_actuator. Qed.

(** [actuator::spare] *)
Definition kernel_spare_square (beta m Var : R) : R :=
  ((((beta * ((beta - (1 / 2)) - m)) + (beta * ((beta - (1 / 2)) - m))) + ((beta * ((beta - (1 / 2)) - m)) + (beta * ((beta - (1 / 2)) - m)))) - Var).
Lemma bridge_spare_square : forall beta m Var,
  kernel_spare_square beta m Var = spare_square beta m Var.
Proof. unfold kernel_spare_square. bridge_actuator. Qed.

(** [Actuator::mean_delay] *)
Definition kernel_mean_delay (s theta : R) : R :=
  (s + theta).
Lemma bridge_mean_delay : forall s theta,
  kernel_mean_delay s theta = s + theta.
Proof. unfold kernel_mean_delay. bridge. Qed.

(** [Actuator::variance_of_latency] *)
Definition kernel_variance_of_latency (s : R) : R :=
  ((s - (floor s)) * (1 - (s - (floor s)))).
Lemma bridge_variance_of_latency : forall s,
  kernel_variance_of_latency s = latency_variance (residue s).
Proof. unfold kernel_variance_of_latency. bridge_actuator. Qed.

(** [actuator::lag_variance] *)
Definition kernel_lag_variance (theta e : R) : R :=
  (((theta / 2) * ((1 + e) / (1 - e))) - (theta * theta)).
Lemma bridge_lag_variance : forall theta e,
  e = lag_decay theta -> kernel_lag_variance theta e = lag_variance theta.
Proof. unfold kernel_lag_variance. bridge_actuator. Qed.

(** [actuator::shared_variance] *)
Definition kernel_late_lag_variance (theta f power e : R) : R :=
  (((f * (1 - f)) + (((theta / 2) * ((1 + e) / (1 - e))) - (theta * theta))) + ((theta * (((power - e) / (1 - e)) - f)) + (theta * (((power - e) / (1 - e)) - f)))).
Lemma bridge_late_lag_variance : forall theta f power e,
  e = lag_decay theta -> power = late_power f theta 1 -> kernel_late_lag_variance theta f power e = late_lag_variance f theta.
Proof. unfold kernel_late_lag_variance. bridge_actuator. Qed.

(** [controller::Filter::next] *)
Definition kernel_filtered_command (B a w x0 x1 : R) : R :=
  ((1 * x1) + ((0 - ((- a) * (B * w))) + ((- (B * (1 - a))) * (x0 - x1)))).
Lemma bridge_filtered_command : forall B a w x0 x1,
  kernel_filtered_command B a w x0 x1 = x1 + B * filtered_step a w (x1 - x0).
Proof. unfold kernel_filtered_command. bridge_actuator. Qed.

(** [linear_part::filtered_cost] *)
Definition kernel_filtered_cost_viscous (B a : R) : R :=
  ((1 / 2) + (B * ((1 - a) / (1 + a)))).
Lemma bridge_filtered_cost_viscous : forall B a,
  kernel_filtered_cost_viscous B a = 1 / 2 + B * filter_share a.
Proof. unfold kernel_filtered_cost_viscous. bridge_actuator. Qed.

(** [linear_part::filtered_cost] *)
Definition kernel_filtered_cost_coulomb (B a : R) : R :=
  ((1 / 2) + (B * (1 - a))).
Lemma bridge_filtered_cost_coulomb : forall B a,
  kernel_filtered_cost_coulomb B a = 1 / 2 + B * (1 - a).
Proof. unfold kernel_filtered_cost_coulomb. bridge_actuator. Qed.
