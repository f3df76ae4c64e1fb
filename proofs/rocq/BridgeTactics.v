(** * Bridge tactics: equality of a formula of the kernel with a definition, by algebra. *)

From Coq Require Import Reals Lra.
From Passivity Require Export Definitions.
Open Scope R_scope.

(** Everything down to sums, products, quotients, floors and magnitudes. *)
Ltac open_definitions :=
  unfold viscous_surplus, coulomb_surplus, margin, margin_8, surplus, jitter_surplus,
    critical_sigma, critical_speed, start_speed_squared, margin_of_squares,
    cycle_gain, cycle_work, cycle_friction, bound_quantized, bound_22, bound_21,
    generated_quantized, quantization_effect, generated_linear, generated, ticks,
    quantized_storage, storage, quantized_potential, linear_potential, quantization_potential,
    kinetic, dissipated_lower, friction_power, mean_speed, delay_storage, damping_storage,
    clipped, clipped_below, law_potential_of, rounded_force, beta_of, sigma_of, mu_of,
    viscous_si, coulomb_si, coulomb_si_smooth, stiffness_limit, viscous_limit, coulomb_limit,
    held_force, measured, residue in *.

(** Squares as squares of magnitudes, where a magnitude of the same number occurs. *)
Ltac squares_of_magnitudes :=
  repeat match goal with
  | |- context [Rabs ?x] =>
      match goal with
      | |- context [x ^ 2] => rewrite <- (pow2_abs x)
      end
  end.

Ltac bridge :=
  intros; open_definitions; try reflexivity;
  simpl sum_to; rewrite ?INR_IZR_INZ; simpl Z.of_nat;
  squares_of_magnitudes;
  first [ring | field; repeat split; lra | unfold Rdiv; ring | apply (f_equal2 Rdiv); ring
    | apply (f_equal2 Rdiv); unfold Rdiv; ring].
