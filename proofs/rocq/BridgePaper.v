(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics ControllerTactics.
Open Scope R_scope.

(** [Quantized::of::tick] *)
Definition kernel_tick (x : R) : R :=
  (floor x).
Lemma bridge_tick : forall x,
  kernel_tick x = floor x.
Proof. unfold kernel_tick. bridge. Qed.

(** [Quantized::of::residue] *)
Definition kernel_residue (x : R) : R :=
  (x - (floor x)).
Lemma bridge_residue : forall x,
  kernel_residue x = residue x.
Proof. unfold kernel_residue. bridge. Qed.

(** [Quantized::measured] *)
Definition kernel_measured (x : R) : R :=
  ((floor x) + (1 / 2)).
Lemma bridge_measured : forall x,
  kernel_measured x = measured x.
Proof. unfold kernel_measured. bridge. Qed.

(** [quantizer::held_force] *)
Definition kernel_held_force (x : R) : R :=
  (- ((floor x) + (1 / 2))).
Lemma bridge_held_force : forall x,
  kernel_held_force x = held_force x.
Proof. unfold kernel_held_force. bridge. Qed.

(** [spring::linear_potential] *)
Definition kernel_linear_potential (x : R) : R :=
  ((x * x) / 2).
Lemma bridge_linear_potential : forall x,
  kernel_linear_potential x = linear_potential x.
Proof. unfold kernel_linear_potential. bridge. Qed.

(** [spring::quantization_potential] *)
Definition kernel_quantization_potential (x : R) : R :=
  (((x - (floor x)) * (1 - (x - (floor x)))) / 2).
Lemma bridge_quantization_potential : forall x,
  kernel_quantization_potential x = quantization_potential x.
Proof. unfold kernel_quantization_potential. bridge. Qed.

(** [spring::quantized_potential] *)
Definition kernel_quantized_potential (x : R) : R :=
  (((x * x) / 2) + (((x - (floor x)) * (1 - (x - (floor x)))) / 2)).
Lemma bridge_quantized_potential : forall x,
  kernel_quantized_potential x = quantized_potential x.
Proof. unfold kernel_quantized_potential. bridge. Qed.

(** [spring::kinetic] *)
Definition kernel_kinetic (mu v : R) : R :=
  ((mu * (v * v)) / 2).
Lemma bridge_kinetic : forall mu v,
  kernel_kinetic mu v = kinetic mu v.
Proof. unfold kernel_kinetic. bridge. Qed.

(** [spring::storage] *)
Definition kernel_storage (mu x v : R) : R :=
  (((mu * (v * v)) / 2) + ((x * x) / 2)).
Lemma bridge_storage : forall mu x v,
  kernel_storage mu x v = storage mu x v.
Proof. unfold kernel_storage. bridge. Qed.

(** [spring::quantized_storage] *)
Definition kernel_quantized_storage (mu x v : R) : R :=
  (((mu * (v * v)) / 2) + (((x * x) / 2) + (((x - (floor x)) * (1 - (x - (floor x)))) / 2))).
Lemma bridge_quantized_storage : forall mu x v,
  kernel_quantized_storage mu x v = quantized_storage mu x v.
Proof. unfold kernel_quantized_storage. bridge. Qed.

(** [Step::displacement] *)
Definition kernel_displacement (x0 x1 : R) : R :=
  (x1 - x0).
Lemma bridge_displacement : forall x0 x1,
  kernel_displacement x0 x1 = x1 - x0.
Proof. unfold kernel_displacement. bridge. Qed.

(** [Step::ticks] *)
Definition kernel_ticks (x0 x1 : R) : R :=
  ((floor x1) - (floor x0)).
Lemma bridge_ticks : forall x0 x1,
  kernel_ticks x0 x1 = ticks x0 x1.
Proof. unfold kernel_ticks. bridge. Qed.

(** [generation::generated] *)
Definition kernel_generated (held x0 x1 p0 p1 : R) : R :=
  (((held * (x1 - x0)) + p1) - p0).
Lemma bridge_generated : forall held x0 x1 p0 p1,
  kernel_generated held x0 x1 p0 p1 = generated held x0 x1 p0 p1.
Proof. unfold kernel_generated. bridge. Qed.

(** [generation::generated_linear] *)
Definition kernel_generated_linear (x0 x1 : R) : R :=
  (((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2).
Lemma bridge_generated_linear : forall x0 x1,
  kernel_generated_linear x0 x1 = generated_linear x0 x1.
Proof. unfold kernel_generated_linear. bridge. Qed.

(** [generation::quantization_effect] *)
Definition kernel_quantization_effect (x0 x1 : R) : R :=
  ((((x0 - (floor x0)) - (1 / 2)) * ((floor x1) - (floor x0))) - ((((x1 - (floor x1)) - (x0 - (floor x0))) * ((x1 - (floor x1)) - (x0 - (floor x0)))) / 2)).
Lemma bridge_quantization_effect : forall x0 x1,
  kernel_quantization_effect x0 x1 = quantization_effect x0 x1.
Proof. unfold kernel_quantization_effect. bridge. Qed.

(** [generation::generated_as_in_19] *)
Definition kernel_generated_as_in_19 (x0 x1 : R) : R :=
  ((((x1 - x0) * (x1 - x0)) / 2) + ((((x0 - (floor x0)) - (1 / 2)) * ((floor x1) - (floor x0))) - ((((x1 - (floor x1)) - (x0 - (floor x0))) * ((x1 - (floor x1)) - (x0 - (floor x0)))) / 2))).
Lemma bridge_generated_as_in_19 : forall x0 x1,
  kernel_generated_as_in_19 x0 x1 = generated_quantized x0 x1.
Proof. unfold kernel_generated_as_in_19. bridge. Qed.

(** [generation::generated_quantized] *)
Definition kernel_generated_quantized (x0 x1 : R) : R :=
  ((((floor x1) - (floor x0)) * ((((floor x1) - (floor x0)) + ((x1 - (floor x1)) + (x1 - (floor x1)))) - 1)) / 2).
Lemma bridge_generated_quantized : forall x0 x1,
  kernel_generated_quantized x0 x1 = generated_quantized x0 x1.
Proof. unfold kernel_generated_quantized. bridge. Qed.

(** [generation::bound_21] *)
Definition kernel_bound_21 (D : R) : R :=
  ((Rabs D) / 2).
Lemma bridge_bound_21 : forall D,
  kernel_bound_21 D = bound_21 D.
Proof. unfold kernel_bound_21. bridge. Qed.

(** [generation::bound_22] *)
Definition kernel_bound_22 (d : R) : R :=
  (((Rabs d) * ((Rabs d) + 1)) / 2).
Lemma bridge_bound_22 : forall d,
  kernel_bound_22 d = bound_22 d.
Proof. unfold kernel_bound_22. bridge. Qed.

(** [generation::bound_quantized] *)
Definition kernel_bound_quantized (d : R) : R :=
  ((((Rabs d) * ((Rabs d) + 1)) / 2) + ((((Rabs d) - (floor (Rabs d))) * (1 - ((Rabs d) - (floor (Rabs d))))) / 2)).
Lemma bridge_bound_quantized : forall d,
  kernel_bound_quantized d = bound_quantized d.
Proof. unfold kernel_bound_quantized. bridge. Qed.

(** [Friction::power] *)
Definition kernel_power (beta sigma v : R) : R :=
  ((Rabs v) * ((beta * (Rabs v)) + sigma)).
Lemma bridge_power : forall beta sigma v,
  kernel_power beta sigma v = friction_power beta sigma v.
Proof. unfold kernel_power. bridge. Qed.

(** [dissipation::mean_speed] *)
Definition kernel_mean_speed (d dtau : R) : R :=
  ((Rabs d) / dtau).
Lemma bridge_mean_speed : forall d dtau,
  kernel_mean_speed d dtau = mean_speed d dtau.
Proof. unfold kernel_mean_speed. bridge. Qed.

(** [Friction::dissipated_lower] *)
Definition kernel_dissipated_lower (beta sigma d dtau : R) : R :=
  ((Rabs d) * ((beta * ((Rabs d) / dtau)) + sigma)).
Lemma bridge_dissipated_lower : forall beta sigma d dtau,
  kernel_dissipated_lower beta sigma d dtau = dissipated_lower beta sigma d dtau.
Proof. unfold kernel_dissipated_lower. bridge. Qed.

(** [Friction::dissipated_at_constant_velocity] *)
Definition kernel_dissipated_at_constant_velocity (beta sigma v dtau : R) : R :=
  (((Rabs v) * ((beta * (Rabs v)) + sigma)) * dtau).
Lemma bridge_dissipated_at_constant_velocity : forall beta sigma v dtau,
  kernel_dissipated_at_constant_velocity beta sigma v dtau = friction_power beta sigma v * dtau.
Proof. unfold kernel_dissipated_at_constant_velocity. bridge. Qed.

(** [Criterion::of_friction] *)
Definition kernel_of_friction_viscous (beta : R) : R :=
  (beta - (1 / 2)).
Lemma bridge_of_friction_viscous : forall beta,
  kernel_of_friction_viscous beta = viscous_surplus beta 0 0.
Proof. unfold kernel_of_friction_viscous. bridge. Qed.

(** [Criterion::of_friction] *)
Definition kernel_of_friction_coulomb (sigma : R) : R :=
  (sigma - (1 / 2)).
Lemma bridge_of_friction_coulomb : forall sigma,
  kernel_of_friction_coulomb sigma = coulomb_surplus sigma 0 0.
Proof. unfold kernel_of_friction_coulomb. bridge. Qed.

(** [Criterion::margin] *)
Definition kernel_margin (viscous coulomb v : R) : R :=
  ((viscous * v) + coulomb).
Lemma bridge_margin : forall viscous coulomb v,
  kernel_margin viscous coulomb v = margin viscous coulomb v.
Proof. unfold kernel_margin. bridge. Qed.

(** [Criterion::margin_at_all_speeds] *)
Definition kernel_margin_at_all_speeds (viscous coulomb : R) : R :=
  (Rmin viscous coulomb).
Lemma bridge_margin_at_all_speeds : forall viscous coulomb,
  kernel_margin_at_all_speeds viscous coulomb = Rmin viscous coulomb.
Proof. unfold kernel_margin_at_all_speeds. bridge. Qed.

(** [Criterion::margin_up_to] *)
Definition kernel_margin_up_to (viscous coulomb v : R) : R :=
  (Rmin coulomb ((viscous * v) + coulomb)).
Lemma bridge_margin_up_to : forall viscous coulomb v,
  kernel_margin_up_to viscous coulomb v = Rmin coulomb (margin viscous coulomb v).
Proof. unfold kernel_margin_up_to. bridge. Qed.

(** [Criterion::surplus] *)
Definition kernel_surplus (viscous coulomb d dtau : R) : R :=
  ((Rabs d) * ((viscous * ((Rabs d) / dtau)) + coulomb)).
Lemma bridge_surplus : forall viscous coulomb d dtau,
  kernel_surplus viscous coulomb d dtau = surplus viscous coulomb d dtau.
Proof. unfold kernel_surplus. bridge. Qed.

(** [Criterion::critical_sigma] *)
Definition kernel_critical_sigma (beta v : R) : R :=
  ((1 / 2) - (v * (beta - (1 / 2)))).
Lemma bridge_critical_sigma : forall beta v,
  kernel_critical_sigma beta v = critical_sigma beta v.
Proof. unfold kernel_critical_sigma. bridge. Qed.

(** [region::critical_speed] *)
Definition kernel_critical_speed (viscous coulomb : R) : R :=
  ((- coulomb) / viscous).
Lemma bridge_critical_speed : forall viscous coulomb,
  kernel_critical_speed viscous coulomb = critical_speed viscous coulomb.
Proof. unfold kernel_critical_speed. bridge. Qed.

(** [start::speed_squared] *)
Definition kernel_speed_squared (mu x v : R) : R :=
  ((v * v) + ((x * x) / mu)).
Lemma bridge_speed_squared : forall mu x v,
  kernel_speed_squared mu x v = start_speed_squared mu x v.
Proof. unfold kernel_speed_squared. bridge. Qed.

(** [start::speed_squared_with_memory] *)
Definition kernel_speed_squared_with_memory (mu x v extra : R) : R :=
  (((v * v) + ((x * x) / mu)) + ((extra + extra) / mu)).
Lemma bridge_speed_squared_with_memory : forall mu x v extra,
  kernel_speed_squared_with_memory mu x v extra = start_speed_squared_with_memory mu x v extra.
Proof. unfold kernel_speed_squared_with_memory. bridge. Qed.

(** [start::margin_of_squares] *)
Definition kernel_margin_of_squares (viscous coulomb V2 : R) : R :=
  ((coulomb * coulomb) - ((viscous * viscous) * V2)).
Lemma bridge_margin_of_squares : forall viscous coulomb V2,
  kernel_margin_of_squares viscous coulomb V2 = margin_of_squares viscous coulomb V2.
Proof. unfold kernel_margin_of_squares. bridge. Qed.

(** [witness::gain] *)
Definition kernel_gain (from to beta sigma : R) : R :=
  ((((- ((floor from) + (1 / 2))) * (to - from)) - ((- ((floor to) + (1 / 2))) * (to - from))) - (((Rabs (to - from)) * ((beta * (Rabs (to - from))) + sigma)) + ((Rabs (to - from)) * ((beta * (Rabs (to - from))) + sigma)))).
Lemma bridge_gain : forall from to beta sigma,
  kernel_gain from to beta sigma = held_force from * (to - from) + held_force to * (from - to)
    - 2 * dissipated_lower beta sigma (to - from) 1.
Proof. unfold kernel_gain. bridge. Qed.

(** [witness::gain_formula] *)
Definition kernel_gain_formula (m a beta sigma : R) : R :=
  ((m + a) * ((m + 1) - (((beta * (m + a)) + sigma) + ((beta * (m + a)) + sigma)))).
Lemma bridge_gain_formula : forall m a beta sigma,
  kernel_gain_formula m a beta sigma = cycle_gain m a beta sigma.
Proof. unfold kernel_gain_formula. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_generated_linear (x0 x1 beta sigma dtau : R) : R :=
  ((((- ((floor x0) + (1 / 2))) - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + (((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2)).
Lemma bridge_row_generated_linear : forall x0 x1 beta sigma dtau,
  kernel_row_generated_linear x0 x1 beta sigma dtau = generated_linear x0 x1.
Proof. unfold kernel_row_generated_linear. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_generated_quantized (x0 x1 beta sigma dtau : R) : R :=
  ((((- ((floor x0) + (1 / 2))) - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + ((((floor x1) - (floor x0)) * ((((floor x1) - (floor x0)) + ((x1 - (floor x1)) + (x1 - (floor x1)))) - 1)) / 2)).
Lemma bridge_row_generated_quantized : forall x0 x1 beta sigma dtau,
  kernel_row_generated_quantized x0 x1 beta sigma dtau = generated_quantized x0 x1.
Proof. unfold kernel_row_generated_quantized. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_bound_22 (x0 x1 beta sigma dtau : R) : R :=
  (((Rabs (x1 - x0)) * ((Rabs (x1 - x0)) + 1)) / 2).
Lemma bridge_row_bound_22 : forall x0 x1 beta sigma dtau,
  kernel_row_bound_22 x0 x1 beta sigma dtau = bound_22 (x1 - x0).
Proof. unfold kernel_row_bound_22. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_bound_quantized (x0 x1 beta sigma dtau : R) : R :=
  ((((Rabs (x1 - x0)) * ((Rabs (x1 - x0)) + 1)) / 2) + ((((Rabs (x1 - x0)) - (floor (Rabs (x1 - x0)))) * (1 - ((Rabs (x1 - x0)) - (floor (Rabs (x1 - x0)))))) / 2)).
Lemma bridge_row_bound_quantized : forall x0 x1 beta sigma dtau,
  kernel_row_bound_quantized x0 x1 beta sigma dtau = bound_quantized (x1 - x0).
Proof. unfold kernel_row_bound_quantized. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_dissipated_lower (x0 x1 beta sigma dtau : R) : R :=
  ((Rabs (x1 - x0)) * ((beta * ((Rabs (x1 - x0)) / dtau)) + sigma)).
Lemma bridge_row_dissipated_lower : forall x0 x1 beta sigma dtau,
  kernel_row_dissipated_lower x0 x1 beta sigma dtau = dissipated_lower beta sigma (x1 - x0) dtau.
Proof. unfold kernel_row_dissipated_lower. bridge. Qed.

(** [ledger::row] *)
Definition kernel_row_net_linear (x0 x1 beta sigma dtau : R) : R :=
  (((Rabs (x1 - x0)) * ((beta * ((Rabs (x1 - x0)) / dtau)) + sigma)) - ((((- ((floor x0) + (1 / 2))) - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + (((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2))).
Lemma bridge_row_net_linear : forall x0 x1 beta sigma dtau,
  kernel_row_net_linear x0 x1 beta sigma dtau = dissipated_lower beta sigma (x1 - x0) dtau - generated_linear x0 x1.
Proof. unfold kernel_row_net_linear. intros; rewrite <- (bridge_row_dissipated_lower x0 x1),
  <- (bridge_row_generated_linear x0 x1 beta sigma dtau); reflexivity. Qed.

(** [ledger::row] *)
Definition kernel_row_net_quantized (x0 x1 beta sigma dtau : R) : R :=
  (((Rabs (x1 - x0)) * ((beta * ((Rabs (x1 - x0)) / dtau)) + sigma)) - ((((- ((floor x0) + (1 / 2))) - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + ((((floor x1) - (floor x0)) * ((((floor x1) - (floor x0)) + ((x1 - (floor x1)) + (x1 - (floor x1)))) - 1)) / 2))).
Lemma bridge_row_net_quantized : forall x0 x1 beta sigma dtau,
  kernel_row_net_quantized x0 x1 beta sigma dtau = dissipated_lower beta sigma (x1 - x0) dtau - generated_quantized x0 x1.
Proof. unfold kernel_row_net_quantized. intros; rewrite <- (bridge_row_dissipated_lower x0 x1),
  <- (bridge_row_generated_quantized x0 x1 beta sigma dtau); reflexivity. Qed.

(** [ledger::row] *)
Definition kernel_row_margin (x0 x1 beta sigma dtau : R) : R :=
  (((beta - ((1 * 1) * ((1 / 2) + 0))) * ((Rabs (x1 - x0)) / dtau)) + (sigma - ((1 * 1) / 2))).
Lemma bridge_row_margin : forall x0 x1 beta sigma dtau,
  kernel_row_margin x0 x1 beta sigma dtau = margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0)
    (mean_speed (x1 - x0) dtau).
Proof. unfold kernel_row_margin. bridge. Qed.

(** [ledger::jitter_bound] *)
Definition kernel_jitter_bound (beta sigma d dtau : R) : R :=
  (((Rabs d) * ((beta * ((Rabs d) / dtau)) + sigma)) - (((Rabs d) * ((Rabs d) + 1)) / 2)).
Lemma bridge_jitter_bound : forall beta sigma d dtau,
  kernel_jitter_bound beta sigma d dtau = jitter_surplus beta (1 / 2) (coulomb_surplus sigma 0 0) d dtau.
Proof. unfold kernel_jitter_bound. bridge. Qed.

(** [ledger::operator_work] *)
Definition kernel_operator_work (s0 s1 dissipated generated : R) : R :=
  (((s1 - s0) + dissipated) - generated).
Lemma bridge_operator_work : forall s0 s1 dissipated generated,
  kernel_operator_work s0 s1 dissipated generated = s1 - s0 + (dissipated - generated).
Proof. unfold kernel_operator_work. bridge. Qed.

(** [ledger::counterparts_differ_by] *)
Definition kernel_counterparts_differ_by (x0 x1 : R) : R :=
  ((((x1 - (floor x1)) * (1 - (x1 - (floor x1)))) / 2) - (((x0 - (floor x0)) * (1 - (x0 - (floor x0)))) / 2)).
Lemma bridge_counterparts_differ_by : forall x0 x1,
  kernel_counterparts_differ_by x0 x1 = generated_quantized x0 x1 - generated_linear x0 x1.
Proof. unfold kernel_counterparts_differ_by. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_wall (x0 x1 u : R) : R :=
  (((u - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + (((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2)).
Lemma bridge_any_row_wall : forall x0 x1 u,
  kernel_any_row_wall x0 x1 u = generated u x0 x1 (linear_potential x0) (linear_potential x1).
Proof. unfold kernel_any_row_wall. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_wall_quantized (x0 x1 u : R) : R :=
  (((u - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + ((((floor x1) - (floor x0)) * ((((floor x1) - (floor x0)) + ((x1 - (floor x1)) + (x1 - (floor x1)))) - 1)) / 2)).
Lemma bridge_any_row_wall_quantized : forall x0 x1 u,
  kernel_any_row_wall_quantized x0 x1 u = generated u x0 x1 (quantized_potential x0) (quantized_potential x1).
Proof. unfold kernel_any_row_wall_quantized. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_wall_net (x0 x1 u beta sigma dtau gain : R) : R :=
  ((((Rabs (x1 - x0)) * ((beta * ((Rabs (x1 - x0)) / dtau)) + sigma)) - (((u - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + (((x1 - x0) * (((x1 - x0) + ((x0 - (floor x0)) + (x0 - (floor x0)))) - 1)) / 2))) - gain).
Lemma bridge_any_row_wall_net : forall x0 x1 u beta sigma dtau gain,
  kernel_any_row_wall_net x0 x1 u beta sigma dtau gain = dissipated_lower beta sigma (x1 - x0) dtau - generated u x0 x1 (linear_potential x0) (linear_potential x1) - gain.
Proof. unfold kernel_any_row_wall_net. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_wall_net_quantized (x0 x1 u beta sigma dtau gain : R) : R :=
  ((((Rabs (x1 - x0)) * ((beta * ((Rabs (x1 - x0)) / dtau)) + sigma)) - (((u - (- ((floor x0) + (1 / 2)))) * (x1 - x0)) + ((((floor x1) - (floor x0)) * ((((floor x1) - (floor x0)) + ((x1 - (floor x1)) + (x1 - (floor x1)))) - 1)) / 2))) - gain).
Lemma bridge_any_row_wall_net_quantized : forall x0 x1 u beta sigma dtau gain,
  kernel_any_row_wall_net_quantized x0 x1 u beta sigma dtau gain = dissipated_lower beta sigma (x1 - x0) dtau - generated u x0 x1 (quantized_potential x0) (quantized_potential x1) - gain.
Proof. unfold kernel_any_row_wall_net_quantized. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_smooth (x0 x1 u : R) : R :=
  (((u - (- x0)) * (x1 - x0)) + (((x1 - x0) * (x1 - x0)) / 2)).
Lemma bridge_any_row_smooth : forall x0 x1 u,
  kernel_any_row_smooth x0 x1 u = generated u x0 x1 (linear_potential x0) (linear_potential x1).
Proof. unfold kernel_any_row_smooth. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_smooth_quantized (x0 x1 u : R) : R :=
  (((u - (- x0)) * (x1 - x0)) + (((x1 - x0) * (x1 - x0)) / 2)).
Lemma bridge_any_row_smooth_quantized : forall x0 x1 u,
  kernel_any_row_smooth_quantized x0 x1 u = generated u x0 x1 (linear_potential x0) (linear_potential x1).
Proof. unfold kernel_any_row_smooth_quantized. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_smooth_bound (x0 x1 : R) : R :=
  (((x1 - x0) * (x1 - x0)) / 2).
Lemma bridge_any_row_smooth_bound : forall x0 x1,
  kernel_any_row_smooth_bound x0 x1 = (x1 - x0) ^ 2 / 2.
Proof. unfold kernel_any_row_smooth_bound. bridge. Qed.

(** [ledger::row] *)
Definition kernel_any_row_effects (x0 x1 u L : R) : R :=
  (((u * (x1 - x0)) + ((x1 * (Rmin (Rmax x1 (Rmax 0 (- L))) L)) - (((Rmin (Rmax x1 (Rmax 0 (- L))) L) * (Rmin (Rmax x1 (Rmax 0 (- L))) L)) / 2))) - ((x0 * (Rmin (Rmax x0 (Rmax 0 (- L))) L)) - (((Rmin (Rmax x0 (Rmax 0 (- L))) L) * (Rmin (Rmax x0 (Rmax 0 (- L))) L)) / 2))).
Lemma bridge_any_row_effects : forall x0 x1 u L,
  0 <= L -> kernel_any_row_effects x0 x1 u L = generated u x0 x1 (controller_potential true (Some L) x0) (controller_potential true (Some L) x1).
Proof. unfold kernel_any_row_effects. intros; unfold generated, controller_potential, controller_law, law_potential_of, clipped;
  rewrite (Rmax_left 0) by lra; field. Qed.

(** [ledger::row] *)
Definition kernel_any_row_effects_margin (x0 x1 beta sigma dtau B delta : R) : R :=
  (((beta - (((1 * 1) * ((1 / 2) + 1)) + B)) * ((Rabs (x1 - x0)) / dtau)) + (sigma - ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)))).
Lemma bridge_any_row_effects_margin : forall x0 x1 beta sigma dtau B delta,
  kernel_any_row_effects_margin x0 x1 beta sigma dtau B delta = margin (viscous_surplus beta 1 B) (coulomb_surplus sigma delta B)
    (mean_speed (x1 - x0) dtau).
Proof. unfold kernel_any_row_effects_margin. bridge. Qed.
