(** * Bridge: each formula of the kernel is the definition that the theorems use.

    Generated from the kernel's code by `passivity-rocq-bridge`; do not edit. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions BridgeTactics ControllerTactics.
Open Scope R_scope.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_0 (beta B : R) : R :=
  (beta - (((1 * 1) * ((1 / 2) + 0)) + B)).
Lemma bridge_criterion_viscous_0 : forall beta B,
  kernel_criterion_viscous_0 beta B = viscous_surplus beta 0 B.
Proof. unfold kernel_criterion_viscous_0. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_0 (sigma delta B : R) : R :=
  (sigma - ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2))).
Lemma bridge_criterion_coulomb_0 : forall sigma delta B,
  kernel_criterion_coulomb_0 sigma delta B = coulomb_surplus sigma delta B.
Proof. unfold kernel_criterion_coulomb_0. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_viscous_0 (B : R) : R :=
  (((1 * 1) * ((1 / 2) + 0)) + B).
Lemma bridge_cost_viscous_0 : forall B,
  kernel_cost_viscous_0 B = - viscous_surplus 0 0 B.
Proof. unfold kernel_cost_viscous_0. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_coulomb_0 (delta B : R) : R :=
  ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)).
Lemma bridge_cost_coulomb_0 : forall delta B,
  kernel_cost_coulomb_0 delta B = - coulomb_surplus 0 delta B.
Proof. unfold kernel_cost_coulomb_0. bridge. Qed.

(** [Cost::bound] *)
Definition kernel_cost_bound_0 (d delta B : R) : R :=
  ((Rabs d) * (((((1 * 1) * ((1 / 2) + 0)) + B) * (Rabs d)) + ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)))).
Lemma bridge_cost_bound_0 : forall d delta B,
  kernel_cost_bound_0 d delta B = - (viscous_surplus 0 0 B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d).
Proof. unfold kernel_cost_bound_0. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_1 (beta B : R) : R :=
  (beta - (((1 * 1) * ((1 / 2) + 1)) + B)).
Lemma bridge_criterion_viscous_1 : forall beta B,
  kernel_criterion_viscous_1 beta B = viscous_surplus beta 1 B.
Proof. unfold kernel_criterion_viscous_1. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_1 (sigma delta B : R) : R :=
  (sigma - ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2))).
Lemma bridge_criterion_coulomb_1 : forall sigma delta B,
  kernel_criterion_coulomb_1 sigma delta B = coulomb_surplus sigma delta B.
Proof. unfold kernel_criterion_coulomb_1. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_viscous_1 (B : R) : R :=
  (((1 * 1) * ((1 / 2) + 1)) + B).
Lemma bridge_cost_viscous_1 : forall B,
  kernel_cost_viscous_1 B = - viscous_surplus 0 1 B.
Proof. unfold kernel_cost_viscous_1. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_coulomb_1 (delta B : R) : R :=
  ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)).
Lemma bridge_cost_coulomb_1 : forall delta B,
  kernel_cost_coulomb_1 delta B = - coulomb_surplus 0 delta B.
Proof. unfold kernel_cost_coulomb_1. bridge. Qed.

(** [Cost::bound] *)
Definition kernel_cost_bound_1 (d delta B : R) : R :=
  ((Rabs d) * (((((1 * 1) * ((1 / 2) + 1)) + B) * (Rabs d)) + ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)))).
Lemma bridge_cost_bound_1 : forall d delta B,
  kernel_cost_bound_1 d delta B = - (viscous_surplus 0 1 B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d).
Proof. unfold kernel_cost_bound_1. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_2 (beta B : R) : R :=
  (beta - (((1 * 1) * ((1 / 2) + 2)) + B)).
Lemma bridge_criterion_viscous_2 : forall beta B,
  kernel_criterion_viscous_2 beta B = viscous_surplus beta 2 B.
Proof. unfold kernel_criterion_viscous_2. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_2 (sigma delta B : R) : R :=
  (sigma - ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2))).
Lemma bridge_criterion_coulomb_2 : forall sigma delta B,
  kernel_criterion_coulomb_2 sigma delta B = coulomb_surplus sigma delta B.
Proof. unfold kernel_criterion_coulomb_2. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_viscous_2 (B : R) : R :=
  (((1 * 1) * ((1 / 2) + 2)) + B).
Lemma bridge_cost_viscous_2 : forall B,
  kernel_cost_viscous_2 B = - viscous_surplus 0 2 B.
Proof. unfold kernel_cost_viscous_2. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_coulomb_2 (delta B : R) : R :=
  ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)).
Lemma bridge_cost_coulomb_2 : forall delta B,
  kernel_cost_coulomb_2 delta B = - coulomb_surplus 0 delta B.
Proof. unfold kernel_cost_coulomb_2. bridge. Qed.

(** [Cost::bound] *)
Definition kernel_cost_bound_2 (d delta B : R) : R :=
  ((Rabs d) * (((((1 * 1) * ((1 / 2) + 2)) + B) * (Rabs d)) + ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)))).
Lemma bridge_cost_bound_2 : forall d delta B,
  kernel_cost_bound_2 d delta B = - (viscous_surplus 0 2 B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d).
Proof. unfold kernel_cost_bound_2. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_3 (beta B : R) : R :=
  (beta - (((1 * 1) * ((1 / 2) + 3)) + B)).
Lemma bridge_criterion_viscous_3 : forall beta B,
  kernel_criterion_viscous_3 beta B = viscous_surplus beta 3 B.
Proof. unfold kernel_criterion_viscous_3. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_3 (sigma delta B : R) : R :=
  (sigma - ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2))).
Lemma bridge_criterion_coulomb_3 : forall sigma delta B,
  kernel_criterion_coulomb_3 sigma delta B = coulomb_surplus sigma delta B.
Proof. unfold kernel_criterion_coulomb_3. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_viscous_3 (B : R) : R :=
  (((1 * 1) * ((1 / 2) + 3)) + B).
Lemma bridge_cost_viscous_3 : forall B,
  kernel_cost_viscous_3 B = - viscous_surplus 0 3 B.
Proof. unfold kernel_cost_viscous_3. bridge. Qed.

(** [Loop::cost] *)
Definition kernel_cost_coulomb_3 (delta B : R) : R :=
  ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)).
Lemma bridge_cost_coulomb_3 : forall delta B,
  kernel_cost_coulomb_3 delta B = - coulomb_surplus 0 delta B.
Proof. unfold kernel_cost_coulomb_3. bridge. Qed.

(** [Cost::bound] *)
Definition kernel_cost_bound_3 (d delta B : R) : R :=
  ((Rabs d) * (((((1 * 1) * ((1 / 2) + 3)) + B) * (Rabs d)) + ((((1 * 1) / 2) + (B * (1 / 1))) + (delta / 2)))).
Lemma bridge_cost_bound_3 : forall d delta B,
  kernel_cost_bound_3 d delta B = - (viscous_surplus 0 3 B * d ^ 2 + coulomb_surplus 0 delta B * Rabs d).
Proof. unfold kernel_cost_bound_3. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_plain (beta : R) : R :=
  (beta - ((1 * 1) * ((1 / 2) + 0))).
Lemma bridge_criterion_viscous_plain : forall beta,
  kernel_criterion_viscous_plain beta = viscous_surplus beta 0 0.
Proof. unfold kernel_criterion_viscous_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_plain (sigma : R) : R :=
  (sigma - ((1 * 1) / 2)).
Lemma bridge_criterion_coulomb_plain : forall sigma,
  kernel_criterion_coulomb_plain sigma = coulomb_surplus sigma 0 0.
Proof. unfold kernel_criterion_coulomb_plain. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_viscous_smooth (beta B : R) : R :=
  (beta - (((1 * 1) * ((1 / 2) + 1)) + B)).
Lemma bridge_criterion_viscous_smooth : forall beta B,
  kernel_criterion_viscous_smooth beta B = viscous_surplus beta 1 B.
Proof. unfold kernel_criterion_viscous_smooth. bridge. Qed.

(** [Loop::criterion] *)
Definition kernel_criterion_coulomb_smooth (sigma delta : R) : R :=
  (sigma - (0 + (delta / 2))).
Lemma bridge_criterion_coulomb_smooth : forall sigma delta,
  kernel_criterion_coulomb_smooth sigma delta = coulomb_si_smooth sigma delta.
Proof. unfold kernel_criterion_coulomb_smooth. bridge. Qed.

(** [extra_storage::delay_storage] *)
Definition kernel_delay_storage_1 (d1 : R) : R :=
  (0 + (((0 + 1) * (d1 * d1)) / 2)).
Lemma bridge_delay_storage_1 : forall d1,
  kernel_delay_storage_1 d1 = delay_storage 1 (fun j => match j with | 1%nat => d1 | _ => 0 end).
Proof. unfold kernel_delay_storage_1. bridge. Qed.

(** [extra_storage::delay_storage] *)
Definition kernel_delay_storage_2 (d1 d2 : R) : R :=
  ((0 + (((0 + 1) * (d2 * d2)) / 2)) + ((((0 + 1) + 1) * (d1 * d1)) / 2)).
Lemma bridge_delay_storage_2 : forall d1 d2,
  kernel_delay_storage_2 d1 d2 = delay_storage 2 (fun j => match j with | 1%nat => d1 | 2%nat => d2 | _ => 0 end).
Proof. unfold kernel_delay_storage_2. bridge. Qed.

(** [extra_storage::delay_storage] *)
Definition kernel_delay_storage_3 (d1 d2 d3 : R) : R :=
  (((0 + (((0 + 1) * (d3 * d3)) / 2)) + ((((0 + 1) + 1) * (d2 * d2)) / 2)) + (((((0 + 1) + 1) + 1) * (d1 * d1)) / 2)).
Lemma bridge_delay_storage_3 : forall d1 d2 d3,
  kernel_delay_storage_3 d1 d2 d3 = delay_storage 3 (fun j => match j with | 1%nat => d1 | 2%nat => d2 | 3%nat => d3 | _ => 0 end).
Proof. unfold kernel_delay_storage_3. bridge. Qed.

(** [extra_storage::damping_storage] *)
Definition kernel_damping_storage_0 (B d1 : R) : R :=
  ((B * (0 + (d1 * d1))) / 2).
Lemma bridge_damping_storage_0 : forall B d1,
  kernel_damping_storage_0 B d1 = damping_storage 0 B (fun j => match j with | 1%nat => d1 | _ => 0 end).
Proof. unfold kernel_damping_storage_0. bridge. Qed.

(** [extra_storage::damping_storage] *)
Definition kernel_damping_storage_1 (B d1 d2 : R) : R :=
  ((B * ((0 + (d1 * d1)) + (d2 * d2))) / 2).
Lemma bridge_damping_storage_1 : forall B d1 d2,
  kernel_damping_storage_1 B d1 d2 = damping_storage 1 B (fun j => match j with | 1%nat => d1 | 2%nat => d2 | _ => 0 end).
Proof. unfold kernel_damping_storage_1. bridge. Qed.

(** [extra_storage::damping_storage] *)
Definition kernel_damping_storage_2 (B d1 d2 d3 : R) : R :=
  ((B * (((0 + (d1 * d1)) + (d2 * d2)) + (d3 * d3))) / 2).
Lemma bridge_damping_storage_2 : forall B d1 d2 d3,
  kernel_damping_storage_2 B d1 d2 d3 = damping_storage 2 B (fun j => match j with | 1%nat => d1 | 2%nat => d2 | 3%nat => d3 | _ => 0 end).
Proof. unfold kernel_damping_storage_2. bridge. Qed.

(** [extra_storage::damping_storage] *)
Definition kernel_damping_storage_3 (B d1 d2 d3 d4 : R) : R :=
  ((B * ((((0 + (d1 * d1)) + (d2 * d2)) + (d3 * d3)) + (d4 * d4))) / 2).
Lemma bridge_damping_storage_3 : forall B d1 d2 d3 d4,
  kernel_damping_storage_3 B d1 d2 d3 d4 = damping_storage 3 B (fun j => match j with | 1%nat => d1 | 2%nat => d2 | 3%nat => d3 | 4%nat => d4 | _ => 0 end).
Proof. unfold kernel_damping_storage_3. bridge. Qed.

(** [controller::rounded] *)
Definition kernel_rounded (F delta : R) : R :=
  (((floor (((F * 1) / delta) + (1 / 2))) * delta) / 1).
Lemma bridge_rounded : forall F delta,
  kernel_rounded F delta = rounded_force F delta.
Proof. unfold kernel_rounded. intros; apply kernel_step. Qed.

(** [Law::bilateral::force] *)
Definition kernel_law_bilateral (x : R) : R :=
  x.
Lemma bridge_law_bilateral : forall x,
  kernel_law_bilateral x = x.
Proof. unfold kernel_law_bilateral. bridge. Qed.

(** [Law::bilateral::potential] *)
Definition kernel_law_bilateral_potential (x : R) : R :=
  ((x * x) - ((x * x) / 2)).
Lemma bridge_law_bilateral_potential : forall x,
  kernel_law_bilateral_potential x = linear_potential x.
Proof. unfold kernel_law_bilateral_potential. bridge. Qed.

(** [Law::unilateral::force] *)
Definition kernel_law_unilateral (x : R) : R :=
  (Rmax x 0).
Lemma bridge_law_unilateral : forall x,
  kernel_law_unilateral x = clipped_below 0 x.
Proof. unfold kernel_law_unilateral. bridge. Qed.

(** [Law::unilateral::potential] *)
Definition kernel_law_unilateral_potential (x : R) : R :=
  ((x * (Rmax x 0)) - (((Rmax x 0) * (Rmax x 0)) / 2)).
Lemma bridge_law_unilateral_potential : forall x,
  kernel_law_unilateral_potential x = law_potential_of x (clipped_below 0 x).
Proof. unfold kernel_law_unilateral_potential. bridge. Qed.

(** [Law::unilateral::held_force] *)
Definition kernel_law_unilateral_held (x : R) : R :=
  (- (Rmax ((floor x) + (1 / 2)) 0)).
Lemma bridge_law_unilateral_held : forall x,
  kernel_law_unilateral_held x = - clipped_below 0 (measured x).
Proof. unfold kernel_law_unilateral_held. bridge. Qed.

(** [Law::saturated::force] *)
Definition kernel_law_saturated (x hi : R) : R :=
  (Rmin (Rmax x (- hi)) hi).
Lemma bridge_law_saturated : forall x hi,
  kernel_law_saturated x hi = clipped (- hi) hi x.
Proof. unfold kernel_law_saturated. bridge. Qed.

(** [Law::saturated::potential] *)
Definition kernel_law_saturated_potential (x hi : R) : R :=
  ((x * (Rmin (Rmax x (- hi)) hi)) - (((Rmin (Rmax x (- hi)) hi) * (Rmin (Rmax x (- hi)) hi)) / 2)).
Lemma bridge_law_saturated_potential : forall x hi,
  kernel_law_saturated_potential x hi = law_potential_of x (clipped (- hi) hi x).
Proof. unfold kernel_law_saturated_potential. bridge. Qed.

(** [Law::saturated::force] *)
Definition kernel_law_unilateral_saturated (x hi : R) : R :=
  (Rmin (Rmax x (Rmax 0 (- hi))) hi).
Lemma bridge_law_unilateral_saturated : forall x hi,
  0 <= hi -> kernel_law_unilateral_saturated x hi = clipped 0 hi x.
Proof. unfold kernel_law_unilateral_saturated. intros; unfold clipped; rewrite (Rmax_left 0 (- hi)) by lra; reflexivity. Qed.

(** [Law::quantized_potential] *)
Definition kernel_law_quantized_potential (x lo hi : R) : R :=
  (((((x * x) / 2) + (((x - (floor x)) * (1 - (x - (floor x)))) / 2)) - (((Rmax ((floor x) - (Rmax (- (floor ((1 / 2) - hi))) 0)) 0) * (((Rmax (- (floor ((1 / 2) - hi))) 0) - hi) + ((Rmax ((floor x) - (Rmax (- (floor ((1 / 2) - hi))) 0)) 0) / 2))) + ((Rmax (((floor x) + (1 / 2)) - hi) 0) * (x - (floor x))))) - (((Rmax ((- ((floor x) + 1)) - (Rmax (- (floor ((1 / 2) - (- lo)))) 0)) 0) * (((Rmax (- (floor ((1 / 2) - (- lo)))) 0) - (- lo)) + ((Rmax ((- ((floor x) + 1)) - (Rmax (- (floor ((1 / 2) - (- lo)))) 0)) 0) / 2))) + ((Rmax (((- ((floor x) + 1)) + (1 / 2)) - (- lo)) 0) * (1 - (x - (floor x)))))).
Lemma bridge_law_quantized_potential : forall x lo hi,
  kernel_law_quantized_potential x lo hi = quantized_clipped_potential lo hi x.
Proof. unfold kernel_law_quantized_potential. intros; unfold quantized_clipped_potential, beyond, first_beyond, quantized_potential, linear_potential,
    quantization_potential, residue; field. Qed.

(** [Law::held_force] *)
Definition kernel_law_bilateral_held (x : R) : R :=
  (- ((floor x) + (1 / 2))).
Lemma bridge_law_bilateral_held : forall x,
  kernel_law_bilateral_held x = held_force x.
Proof. unfold kernel_law_bilateral_held. bridge. Qed.

(** [Law::switching_energy] *)
Definition kernel_switching_false_false (x : R) : R :=
  0.
Lemma bridge_switching_false_false : forall x,
  kernel_switching_false_false x = switching_energy false false (linear_potential x).
Proof. unfold kernel_switching_false_false. cbv beta iota delta [switching_energy]; bridge. Qed.

(** [Law::switching_energy] *)
Definition kernel_switching_false_true (x : R) : R :=
  ((x * x) - ((x * x) / 2)).
Lemma bridge_switching_false_true : forall x,
  kernel_switching_false_true x = switching_energy false true (linear_potential x).
Proof. unfold kernel_switching_false_true. cbv beta iota delta [switching_energy]; bridge. Qed.

(** [Law::switching_energy] *)
Definition kernel_switching_true_false (x : R) : R :=
  (- ((x * x) - ((x * x) / 2))).
Lemma bridge_switching_true_false : forall x,
  kernel_switching_true_false x = switching_energy true false (linear_potential x).
Proof. unfold kernel_switching_true_false. cbv beta iota delta [switching_energy]; bridge. Qed.

(** [Law::switching_energy] *)
Definition kernel_switching_true_true (x : R) : R :=
  0.
Lemma bridge_switching_true_true : forall x,
  kernel_switching_true_true x = switching_energy true true (linear_potential x).
Proof. unfold kernel_switching_true_true. cbv beta iota delta [switching_energy]; bridge. Qed.
