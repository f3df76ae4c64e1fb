(** * Bridge tactics: equality of a formula of the kernel with a definition, by algebra. *)

From Coq Require Import Reals Lra.
From Passivity Require Export Definitions.
Open Scope R_scope.

(** Everything down to sums, products, quotients, floors and magnitudes. *)
Ltac open_definitions :=
  unfold viscous_surplus, coulomb_surplus, margin, margin_8, surplus, jitter_surplus,
    critical_sigma, critical_speed, start_speed_squared_with_memory, start_speed_squared, margin_of_squares,
    cycle_gain, cycle_work, cycle_friction, bound_quantized, bound_22, bound_21,
    generated_quantized, quantization_effect, generated_linear, generated, ticks,
    quantized_storage, storage, quantized_potential, linear_potential, quantization_potential,
    kinetic, dissipated_lower, friction_power, mean_speed, delay_storage, damping_storage,
    clipped, clipped_below, law_potential_of, rounded_force, beta_of, sigma_of, mu_of,
    viscous_si, coulomb_si, coulomb_si_smooth, stiffness_limit, viscous_limit, coulomb_limit,
    longest_period, shortest_period, coarsest_resolution, best_period,
    held_force, measured, residue in *.

(** Squares as squares of magnitudes, where a magnitude of the same number occurs. *)
Ltac squares_of_magnitudes :=
  repeat match goal with
  | |- context [Rabs ?x] =>
      match goal with
      | |- context [x ^ 2] => rewrite <- (pow2_abs x)
      end
  end.

(** Inverses of what may be 0, as numbers of which nothing is known. *)
Ltac unknown_inverses :=
  repeat match goal with |- context [/ ?x] => is_var x; generalize (/ x); intro end.

Ltac bridge :=
  intros; open_definitions; try reflexivity;
  simpl sum_to; rewrite ?INR_IZR_INZ; simpl Z.of_nat;
  squares_of_magnitudes;
  first [ring | field; repeat split; lra | unfold Rdiv; ring | apply (f_equal2 Rdiv); ring
    | apply (f_equal2 Rdiv); unfold Rdiv; ring
    | unfold Rdiv; unknown_inverses; field].

(** Quotients that agree above and below. *)
Ltac bridge_limit :=
  intros; open_definitions; unfold Rdiv;
  first [reflexivity | ring | field; repeat split; lra | apply f_equal2; [ring | f_equal; ring]].

(** A number with its unit taken out. *)
Ltac bridge_units := intros; open_definitions; field; repeat split; assumption.

(** The coarsest encoder is where it is now and a quotient on from there, whose denominator is not
    zero, however it is written. *)
Lemma shifted_quotient : forall a p q s, s <> 0 -> a * s + p = q -> a + p / s = q / s.
Proof. intros a p q s H E. rewrite <- E. field. exact H. Qed.

Ltac bridge_coarsest :=
  intros; open_definitions;
  match goal with S : ?s <> 0, T : ?t <> 0 |- _ + _ / ?w = _ =>
    let E := fresh in
    assert (E : w = s) by (field; exact T); rewrite E; clear E;
    apply (shifted_quotient _ _ _ _ S); unfold Rdiv; unknown_inverses; field
  end.
