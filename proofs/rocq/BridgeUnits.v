(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics ControllerTactics.
Open Scope R_scope.

(** [Loop::friction] *)
Definition kernel_loop_beta (b K T : R) : R :=
  (b / (K * T)).
Lemma bridge_loop_beta : forall b K T,
  kernel_loop_beta b K T = beta_of b K T.
Proof. unfold kernel_loop_beta. bridge. Qed.

(** [Loop::friction] *)
Definition kernel_loop_sigma (c K Delta : R) : R :=
  (c / (K * Delta)).
Lemma bridge_loop_sigma : forall c K Delta,
  kernel_loop_sigma c K Delta = sigma_of c K Delta.
Proof. unfold kernel_loop_sigma. bridge. Qed.

(** [Loop::dimensionless_speed] *)
Definition kernel_dimensionless_speed (v T Delta : R) : R :=
  ((v * T) / Delta).
Lemma bridge_dimensionless_speed : forall v T Delta,
  kernel_dimensionless_speed v T Delta = v * T / Delta.
Proof. unfold kernel_dimensionless_speed. bridge. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_inertia (x K T Delta : R) : R :=
  (x / ((((1 * K) * T) * T) / 1)).
Lemma bridge_dimensionless_inertia : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_inertia x K T Delta = mu_of x K T.
Proof. unfold kernel_dimensionless_inertia. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_viscous_friction (x K T Delta : R) : R :=
  (x / (((1 * K) * T) / 1)).
Lemma bridge_dimensionless_viscous_friction : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_viscous_friction x K T Delta = beta_of x K T.
Proof. unfold kernel_dimensionless_viscous_friction. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_Coulomb_friction (x K T Delta : R) : R :=
  (x / (((1 * K) * Delta) / 1)).
Lemma bridge_dimensionless_Coulomb_friction : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_Coulomb_friction x K T Delta = sigma_of x K Delta.
Proof. unfold kernel_dimensionless_Coulomb_friction. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_virtual_damping (x K T Delta : R) : R :=
  (x / (((1 * K) * T) / 1)).
Lemma bridge_dimensionless_virtual_damping : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_virtual_damping x K T Delta = beta_of x K T.
Proof. unfold kernel_dimensionless_virtual_damping. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_largest_force (x K T Delta : R) : R :=
  (x / (((1 * K) * Delta) / 1)).
Lemma bridge_dimensionless_largest_force : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_largest_force x K T Delta = sigma_of x K Delta.
Proof. unfold kernel_dimensionless_largest_force. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_force_step (x K T Delta : R) : R :=
  (x / (((1 * K) * Delta) / 1)).
Lemma bridge_dimensionless_force_step : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_force_step x K T Delta = sigma_of x K Delta.
Proof. unfold kernel_dimensionless_force_step. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_amplifier_time_constant (x K T Delta : R) : R :=
  (x / ((1 * T) / 1)).
Lemma bridge_dimensionless_amplifier_time_constant : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_amplifier_time_constant x K T Delta = x / T.
Proof. unfold kernel_dimensionless_amplifier_time_constant. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_speed_bound (x K T Delta : R) : R :=
  (x / ((1 * Delta) / (1 * T))).
Lemma bridge_dimensionless_speed_bound : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_speed_bound x K T Delta = x * T / Delta.
Proof. unfold kernel_dimensionless_speed_bound. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_force_of_the_operator (x K T Delta : R) : R :=
  (x / (((1 * K) * Delta) / 1)).
Lemma bridge_dimensionless_force_of_the_operator : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_force_of_the_operator x K T Delta = sigma_of x K Delta.
Proof. unfold kernel_dimensionless_force_of_the_operator. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_mass_of_the_arm (x K T Delta : R) : R :=
  (x / ((((1 * K) * T) * T) / 1)).
Lemma bridge_dimensionless_mass_of_the_arm : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_mass_of_the_arm x K T Delta = mu_of x K T.
Proof. unfold kernel_dimensionless_mass_of_the_arm. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_damping_of_the_arm (x K T Delta : R) : R :=
  (x / (((1 * K) * T) / 1)).
Lemma bridge_dimensionless_damping_of_the_arm : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_damping_of_the_arm x K T Delta = beta_of x K T.
Proof. unfold kernel_dimensionless_damping_of_the_arm. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_stiffness_of_the_arm (x K T Delta : R) : R :=
  (x / ((1 * K) / 1)).
Lemma bridge_dimensionless_stiffness_of_the_arm : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_stiffness_of_the_arm x K T Delta = x / K.
Proof. unfold kernel_dimensionless_stiffness_of_the_arm. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_position_at_the_start (x K T Delta : R) : R :=
  (x / ((1 * Delta) / 1)).
Lemma bridge_dimensionless_position_at_the_start : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_position_at_the_start x K T Delta = x / Delta.
Proof. unfold kernel_dimensionless_position_at_the_start. bridge_units. Qed.

(** [Loop::dimensionless] *)
Definition kernel_dimensionless_velocity_at_the_start (x K T Delta : R) : R :=
  (x / ((1 * Delta) / (1 * T))).
Lemma bridge_dimensionless_velocity_at_the_start : forall x K T Delta,
  K <> 0 -> T <> 0 -> Delta <> 0 -> kernel_dimensionless_velocity_at_the_start x K T Delta = x * T / Delta.
Proof. unfold kernel_dimensionless_velocity_at_the_start. bridge_units. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_viscous (b K T B : R) : R :=
  (b - (((K * T) * ((1 / 2) + 2)) + B)).
Lemma bridge_loop_viscous : forall b K T B,
  kernel_loop_viscous b K T B = viscous_si b K T 2 B.
Proof. unfold kernel_loop_viscous. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb (c K T Delta B F : R) : R :=
  (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2))).
Lemma bridge_loop_coulomb : forall c K T Delta B F,
  kernel_loop_coulomb c K T Delta B F = coulomb_si c K T Delta B F.
Proof. unfold kernel_loop_coulomb. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_viscous_plain (b K T : R) : R :=
  (b - ((K * T) * ((1 / 2) + 0))).
Lemma bridge_loop_viscous_plain : forall b K T,
  kernel_loop_viscous_plain b K T = viscous_si b K T 0 0.
Proof. unfold kernel_loop_viscous_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb_plain (c K Delta T : R) : R :=
  (c - ((K * Delta) / 2)).
Lemma bridge_loop_coulomb_plain : forall c K Delta T,
  kernel_loop_coulomb_plain c K Delta T = coulomb_si c K T Delta 0 0.
Proof. unfold kernel_loop_coulomb_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_loop_coulomb_smooth (c F : R) : R :=
  (c - (0 + (F / 2))).
Lemma bridge_loop_coulomb_smooth : forall c F,
  kernel_loop_coulomb_smooth c F = coulomb_si_smooth c F.
Proof. unfold kernel_loop_coulomb_smooth. bridge. Qed.

(** [Loop::dimensionless_criterion] *)
Definition kernel_dimensionless_viscous (b K T : R) : R :=
  ((b - ((K * T) * ((1 / 2) + 0))) / (K * T)).
Lemma bridge_dimensionless_viscous : forall b K T,
  K <> 0 -> T <> 0 -> kernel_dimensionless_viscous b K T = viscous_surplus (beta_of b K T) 0 0.
Proof. unfold kernel_dimensionless_viscous. bridge. Qed.

(** [Loop::dimensionless_criterion] *)
Definition kernel_dimensionless_coulomb (c K Delta : R) : R :=
  ((c - ((K * Delta) / 2)) / (K * Delta)).
Lemma bridge_dimensionless_coulomb : forall c K Delta,
  K <> 0 -> Delta <> 0 -> kernel_dimensionless_coulomb c K Delta = coulomb_surplus (sigma_of c K Delta) 0 0.
Proof. unfold kernel_dimensionless_coulomb. bridge. Qed.

(** [stiffness::viscous_limit] *)
Definition kernel_viscous_limit (b K T B : R) : R :=
  ((b - (((0 * T) * ((1 / 2) + 2)) + B)) / ((1 * T) * ((1 / 2) + 2))).
Lemma bridge_viscous_limit : forall b K T B,
  kernel_viscous_limit b K T B = viscous_limit b T 2 B.
Proof. unfold kernel_viscous_limit. bridge. Qed.

(** [stiffness::limit_at_speed] *)
Definition kernel_limit_at_speed (b c K T Delta v B F : R) : R :=
  ((((b - (((0 * T) * ((1 / 2) + 2)) + B)) * v) + (c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2)))) / ((((1 * T) * ((1 / 2) + 2)) * v) + ((1 * Delta) / 2))).
Lemma bridge_limit_at_speed : forall b c K T Delta v B F,
  kernel_limit_at_speed b c K T Delta v B F = stiffness_limit b c T Delta v 2 B F.
Proof. unfold kernel_limit_at_speed. bridge. Qed.

(** [stiffness::limit_at_all_speeds] *)
Definition kernel_limit_at_all_speeds (b c K T Delta v B F : R) : R :=
  (Rmin ((b - (((0 * T) * ((1 / 2) + 2)) + B)) / ((1 * T) * ((1 / 2) + 2))) ((c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / ((1 * Delta) / 2))).
Lemma bridge_limit_at_all_speeds : forall b c K T Delta v B F,
  kernel_limit_at_all_speeds b c K T Delta v B F = Rmin (viscous_limit b T 2 B) (coulomb_limit c T Delta B F).
Proof. unfold kernel_limit_at_all_speeds. intros; apply f_equal2; bridge. Qed.

(** [stiffness::limit_up_to_speed] *)
Definition kernel_limit_up_to_speed (b c K T Delta v B F : R) : R :=
  (Rmin ((((b - (((0 * T) * ((1 / 2) + 2)) + B)) * v) + (c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2)))) / ((((1 * T) * ((1 / 2) + 2)) * v) + ((1 * Delta) / 2))) ((c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / ((1 * Delta) / 2))).
Lemma bridge_limit_up_to_speed : forall b c K T Delta v B F,
  kernel_limit_up_to_speed b c K T Delta v B F = Rmin (stiffness_limit b c T Delta v 2 B F) (coulomb_limit c T Delta B F).
Proof. unfold kernel_limit_up_to_speed. intros; apply f_equal2; bridge. Qed.

(** [stiffness::limit_at_speed] *)
Definition kernel_limit_at_speed_plain (b c K T Delta v : R) : R :=
  ((((b - ((0 * T) * ((1 / 2) + 0))) * v) + (c - ((0 * Delta) / 2))) / ((((1 * T) * ((1 / 2) + 0)) * v) + ((1 * Delta) / 2))).
Lemma bridge_limit_at_speed_plain : forall b c K T Delta v,
  kernel_limit_at_speed_plain b c K T Delta v = stiffness_limit b c T Delta v 0 0 0.
Proof. unfold kernel_limit_at_speed_plain. bridge. Qed.

(** [stiffness::viscous_limit] *)
Definition kernel_viscous_limit_smooth (b K T : R) : R :=
  ((b - ((0 * T) * ((1 / 2) + 2))) / ((1 * T) * ((1 / 2) + 2))).
Lemma bridge_viscous_limit_smooth : forall b K T,
  kernel_viscous_limit_smooth b K T = viscous_limit b T 2 0.
Proof. unfold kernel_viscous_limit_smooth. bridge. Qed.

(** [stiffness::viscous_needed] *)
Definition kernel_viscous_needed (b K T B : R) : R :=
  (b - (b - (((K * T) * ((1 / 2) + 2)) + B))).
Lemma bridge_viscous_needed : forall b K T B,
  kernel_viscous_needed b K T B = b - viscous_si b K T 2 B.
Proof. unfold kernel_viscous_needed. bridge. Qed.

(** [stiffness::viscous_needed_at_speed] *)
Definition kernel_viscous_needed_at_speed (b c K T Delta v B F : R) : R :=
  (b - ((((b - (((K * T) * ((1 / 2) + 2)) + B)) * v) + (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2)))) / v)).
Lemma bridge_viscous_needed_at_speed : forall b c K T Delta v B F,
  kernel_viscous_needed_at_speed b c K T Delta v B F = b - margin (viscous_si b K T 2 B) (coulomb_si c K T Delta B F) v / v.
Proof. unfold kernel_viscous_needed_at_speed. bridge_limit. Qed.

(** [stiffness::coulomb_needed] *)
Definition kernel_coulomb_needed (c K T Delta B F : R) : R :=
  (c - (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2)))).
Lemma bridge_coulomb_needed : forall c K T Delta B F,
  kernel_coulomb_needed c K T Delta B F = c - coulomb_si c K T Delta B F.
Proof. unfold kernel_coulomb_needed. bridge. Qed.

(** [stiffness::coulomb_needed_up_to_speed] *)
Definition kernel_coulomb_needed_up_to_speed (b c K T Delta v B F : R) : R :=
  (c - (Rmin (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2))) (((b - (((K * T) * ((1 / 2) + 2)) + B)) * v) + (c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2)))))).
Lemma bridge_coulomb_needed_up_to_speed : forall b c K T Delta v B F,
  kernel_coulomb_needed_up_to_speed b c K T Delta v B F = c - Rmin (coulomb_si c K T Delta B F)
    (margin (viscous_si b K T 2 B) (coulomb_si c K T Delta B F) v).
Proof. unfold kernel_coulomb_needed_up_to_speed. intros; apply f_equal2; [reflexivity | apply f_equal2; bridge]. Qed.

(** [stiffness::longest_period] *)
Definition kernel_longest_period (b K B : R) : R :=
  ((b - (((0 * 1) * ((1 / 2) + 2)) + B)) / (((1 * 1) * ((1 / 2) + 2)) * K)).
Lemma bridge_longest_period : forall b K B,
  kernel_longest_period b K B = longest_period b K 2 B.
Proof. unfold kernel_longest_period. bridge_limit. Qed.

(** [stiffness::longest_period_at_speed] *)
Definition kernel_longest_period_at_speed (b c K T Delta v F : R) : R :=
  (T + ((((b - ((K * T) * ((1 / 2) + 2))) * v) + (c - (((K * Delta) / 2) + (F / 2)))) / ((((1 * 1) * ((1 / 2) + 2)) * K) * v))).
Lemma bridge_longest_period_at_speed : forall b c K T Delta v F,
  K <> 0 -> v <> 0 -> kernel_longest_period_at_speed b c K T Delta v F = 2 * best_period b c K Delta v 2 0 F.
Proof. unfold kernel_longest_period_at_speed. bridge_limit. Qed.

(** [stiffness::best_period_at_speed] *)
Definition kernel_best_period_at_speed (b c K Delta v B F : R) : R :=
  (((c - (((K * Delta) / 2) + (F / 2))) + ((b - B) * v)) / ((((K * 1) * ((1 / 2) + 2)) * v) + (((K * 1) * ((1 / 2) + 2)) * v))).
Lemma bridge_best_period_at_speed : forall b c K Delta v B F,
  kernel_best_period_at_speed b c K Delta v B F = best_period b c K Delta v 2 B F.
Proof. unfold kernel_best_period_at_speed. bridge_limit. Qed.

(** [stiffness::coulomb_limit] *)
Definition kernel_coulomb_limit (c K T Delta B F : R) : R :=
  ((c - ((((0 * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / ((1 * Delta) / 2)).
Lemma bridge_coulomb_limit : forall c K T Delta B F,
  kernel_coulomb_limit c K T Delta B F = coulomb_limit c T Delta B F.
Proof. unfold kernel_coulomb_limit. bridge_limit. Qed.

(** [stiffness::shortest_period] *)
Definition kernel_shortest_period (c K Delta B F : R) : R :=
  ((B * Delta) / (c - (((K * Delta) / 2) + (F / 2)))).
Lemma bridge_shortest_period : forall c K Delta B F,
  kernel_shortest_period c K Delta B F = shortest_period c K Delta B F.
Proof. unfold kernel_shortest_period. bridge_limit. Qed.

(** [stiffness::coarsest_resolution] *)
Definition kernel_coarsest_resolution (c K T Delta B F : R) : R :=
  (Delta + ((c - ((((K * Delta) / 2) + (B * (Delta / T))) + (F / 2))) / (((((K * 1) / 2) + (B * (1 / T))) + (F / 2)) - ((((K * 0) / 2) + (B * (0 / T))) + (F / 2))))).
Lemma bridge_coarsest_resolution : forall c K T Delta B F,
  T <> 0 -> K / 2 + B / T <> 0 -> kernel_coarsest_resolution c K T Delta B F = coarsest_resolution c K T B F.
Proof. unfold kernel_coarsest_resolution. bridge_coarsest. Qed.
