(** * What does not hold as printed, with rational counterexamples. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions Quantizer Generation.
Open Scope R_scope.

Lemma floor_half : floor (1 / 2) = 0.
Proof. apply (floor_unique _ 0). lra. Qed.

Lemma floor_one : floor 1 = 1.
Proof. apply (floor_unique _ 1). lra. Qed.

(** The step of the counterexample: from 1 to 1/2 the quantized counterpart generates 1/2. *)
Lemma step_1_half : generated_quantized 1 (1 / 2) = 1 / 2.
Proof.
  rewrite EQ_19_20_short. unfold ticks, residue. rewrite floor_half, floor_one. lra.
Qed.

(** ERR-21/22 (21): the equality |D|/2 = |d|/2 that ends (21) is false, and so is the
    bound of E_gq that it states. *)
Theorem ERR_21 : exists x0 x1,
  bound_21 (ticks x0 x1) <> Rabs (x1 - x0) / 2 /\
  Rabs (x1 - x0) / 2 < quantization_effect x0 x1.
Proof.
  exists 1, (1 / 2). unfold bound_21, quantization_effect, ticks, residue.
  rewrite floor_half, floor_one.
  replace (0 - 1) with (- (1)) by ring. replace (1 / 2 - 1) with (- (1 / 2)) by lra.
  rewrite !Rabs_Ropp, !Rabs_right by lra. lra.
Qed.

(** ERR-21/22 (where it holds): the equality of (21) holds when rho_0 = rho_1. *)
Theorem ERR_21_where_true : forall x0 x1,
  residue x0 = residue x1 -> bound_21 (ticks x0 x1) = Rabs (x1 - x0) / 2.
Proof.
  intros x0 x1 H. unfold bound_21. replace (ticks x0 x1) with (x1 - x0); [reflexivity |].
  unfold ticks. unfold residue in H. lra.
Qed.

(** ERR-21/22: (22) is false for the paper's own E_g: 1/2 against 3/8. *)
Theorem ERR_22 : exists x0 x1,
  generated_quantized x0 x1 = 1 / 2 /\ bound_22 (x1 - x0) = 3 / 8.
Proof.
  exists 1, (1 / 2). split; [exact step_1_half |].
  unfold bound_22. rewrite Rabs_left by lra. lra.
Qed.

(** ERR-21/22 (negation): it is not the case that (22) bounds E_g. *)
Theorem ERR_22_negation :
  ~ (forall x0 x1, generated_quantized x0 x1 <= bound_22 (x1 - x0)).
Proof.
  intro H. destruct ERR_22 as (x0 & x1 & G & B). specialize (H x0 x1). lra.
Qed.

(** ERR-21/22 (excess): E_g passes (22) by at most 1/8, and by that much when frac |d| = 1/2. *)
Theorem ERR_22_excess : forall x0 x1,
  generated_quantized x0 x1 <= bound_22 (x1 - x0) + 1 / 8.
Proof.
  intros. pose proof (TH_QUANT x0 x1) as H. unfold bound_quantized in H.
  set (f := residue (Rabs (x1 - x0))) in *. pose proof (pow2_ge_0 (f - 1 / 2)). nra.
Qed.

(** ERR-21/22 (excess, tight): a step back by a |d| with fractional part 1/2 passes (22) by 1/8. *)
Theorem ERR_22_excess_attained : forall z d, d <= 0 -> residue (Rabs d) = 1 / 2 ->
  generated_quantized (IZR z) (IZR z + d) = bound_22 d + 1 / 8.
Proof.
  intros z d Hd Hf. rewrite TH_QUANT_attained by exact Hd.
  unfold bound_quantized. rewrite Hf. lra.
Qed.

(** ERR-27: the criterion (8) holds with margin 3/10 at the mean speed 1/2, the step
    from 1 to 1/2 dissipates 9/20 at least, and yet generates 1/2. *)
Theorem ERR_27 : exists beta sigma x0 x1 dtau,
  margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0)
         (mean_speed (x1 - x0) dtau) = 3 / 20 /\
  0 <= surplus (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) (x1 - x0) dtau /\
  dissipated_lower beta sigma (x1 - x0) dtau = 9 / 20 /\
  generated_quantized x0 x1 = 1 / 2.
Proof.
  exists (3 / 5), (3 / 5), 1, (1 / 2), 1. rewrite step_1_half.
  unfold margin, surplus, viscous_surplus, coulomb_surplus, mean_speed, dissipated_lower.
  rewrite Rabs_left by lra. lra.
Qed.

(** ERR-27 (negation): (27) does not imply E_g <= E_d for the paper's own E_g. *)
Theorem ERR_27_negation :
  ~ (forall beta sigma x0 x1 dtau, 0 < dtau <= 1 ->
     0 <= surplus (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) (x1 - x0) dtau ->
     generated_quantized x0 x1 <= dissipated_lower beta sigma (x1 - x0) dtau).
Proof.
  intro H. specialize (H (3 / 5) (3 / 5) 1 (1 / 2) 1). rewrite step_1_half in H.
  unfold surplus, viscous_surplus, coulomb_surplus, dissipated_lower in H.
  rewrite Rabs_left in H by lra. lra.
Qed.

(** ERR-19-start: from the middle of an interval, E_g by (18) (the force held since the
    sample at 1/2, the move from 11/10 to 3/2) is 2/5 against a bound of 7/25. *)
Theorem ERR_19_start : exists sample x0 x1,
  floor sample <> floor x0 /\
  bound_22 (x1 - x0) = 7 / 25 /\
  generated (held_force sample) x0 x1 (quantized_potential x0) (quantized_potential x1)
  = 2 / 5 /\
  generated (held_force sample) x0 x1 (linear_potential x0) (linear_potential x1) = 8 / 25.
Proof.
  exists (1 / 2), (11 / 10), (3 / 2).
  assert (F1 : floor (11 / 10) = 1) by (apply (floor_unique _ 1); lra).
  assert (F2 : floor (3 / 2) = 1) by (apply (floor_unique _ 1); lra).
  unfold generated, held_force, measured, quantized_potential, quantization_potential,
    linear_potential, residue, bound_22.
  rewrite F1, F2, floor_half. rewrite Rabs_right by lra. lra.
Qed.

(** ERR-19-start (where it holds): (19) needs only that the floor at the start is the
    floor at the sample. *)
Theorem ERR_19_start_where_true : forall sample x0 x1,
  floor sample = floor x0 ->
  generated (held_force sample) x0 x1 (quantized_potential x0) (quantized_potential x1)
  = generated_quantized x0 x1.
Proof.
  intros sample x0 x1 H. rewrite <- EQ_19_20_by_definition.
  unfold held_force, measured. rewrite H. reflexivity.
Qed.
