(** * Counterparts: (16)-(20) as integrals, for the quantized and the linear spring, and
    the errata as motions. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Generation Errata Calculus Model
  Law Combined Passivity QuantizedWork.
Open Scope R_scope.

Lemma kinematic_line : forall c w, kinematic (fun t => c + w * t) (fun _ => w).
Proof.
  intros c w. split; intro t; [| apply continuous_const].
  auto_derive; [exact I | ring].
Qed.

(** EQ-16: H_e is the integral of the quantized spring's force, from 0 to any position. *)
Theorem EQ_16 : forall x,
  is_RInt (fun y => - (- measured y)) 0 x (quantized_potential x).
Proof.
  intro x. pose proof (kinematic_line 0 1) as K.
  assert (Z : quantized_potential 0 = 0).
  { unfold quantized_potential, linear_potential, quantization_potential.
    rewrite (residue_IZR 0). field. }
  assert (Any : forall a b, a <= b ->
    is_RInt (fun y => - (- measured y)) a b (quantized_potential b - quantized_potential a)).
  { intros a b ab. pose proof (EQ_16_along _ _ K a b ab) as W. cbv beta in W.
    replace (0 + 1 * b) with b in W by ring. replace (0 + 1 * a) with a in W by ring.
    apply is_RInt_ext with (2 := W). intros y _. unfold work.
    replace (0 + 1 * y) with y by ring. rewrite Ropp_involutive. apply Rmult_1_r. }
  destruct (Rle_lt_dec 0 x) as [H | H].
  - replace (quantized_potential x) with (quantized_potential x - quantized_potential 0)
      by (rewrite Z; ring). apply Any, H.
  - replace (quantized_potential x) with (- (quantized_potential 0 - quantized_potential x))
      by (rewrite Z; ring).
    apply (@is_RInt_swap R_NormedModule), Any. lra.
Qed.

(** EQ-17: the stored energy H_T is kinetic energy plus H_e. *)
Theorem EQ_17 : forall mu x v,
  quantized_storage mu x v
  = mu * v ^ 2 / 2 + (x ^ 2 + residue x - residue x ^ 2) / 2.
Proof.
  intros. unfold quantized_storage, quantized_potential, kinetic, linear_potential,
    quantization_potential. field.
Qed.

Section Integrals.

Variables pos vel : R -> R.
Hypothesis K : kinematic pos vel.

(** (18) from a sample [x] held since then, between any two instants. *)
Theorem EQ_18_held : forall x s t, s <= t ->
  is_RInt (fun u => (held_force x - - measured (pos u)) * vel u) s t
    (generated (held_force x) (pos s) (pos t)
       (quantized_potential (pos s)) (quantized_potential (pos t))).
Proof.
  intros x s t H. pose proof (EQ_16_along pos vel K s t H) as W.
  replace (generated _ _ _ _ _)
    with (held_force x * (pos t - pos s) + (quantized_potential (pos t) - quantized_potential (pos s)))
    by (unfold generated; ring).
  apply is_RInt_ext with (fun u => held_force x * vel u + work pos vel u).
  - intros u _. unfold work.
    replace ((held_force x - - measured (pos u)) * vel u)
      with (held_force x * vel u + measured (pos u) * vel u) by ring. reflexivity.
  - apply (@is_RInt_plus R_NormedModule (fun u => held_force x * vel u)); [| exact W].
    apply (@is_RInt_scal R_NormedModule), (vel_integral _ _ K).
Qed.

(** EQ-19/20: from a sampling instant [s] to any later instant of its interval, the integral
    (18) is (19) with (20). *)
Theorem EQ_19_20 : forall s t, s <= t ->
  is_RInt (fun u => (held_force (pos s) - - measured (pos u)) * vel u) s t
    (generated_quantized (pos s) (pos t)).
Proof.
  intros s t H. rewrite <- EQ_19_20_by_definition. apply EQ_18_held, H.
Qed.

(** TH-LIN (integral): against the linear spring the integral (18) is d^2/2 + (rho_0 - 1/2)d. *)
Theorem TH_LIN_integral : forall s t,
  is_RInt (fun u => (held_force (pos s) + pos u) * vel u) s t
    (generated_linear (pos s) (pos t)).
Proof.
  intros s t. rewrite <- TH_LIN_by_definition.
  set (c := held_force (pos s)).
  replace (generated _ _ _ _ _)
    with ((c * pos t + linear_potential (pos t)) - (c * pos s + linear_potential (pos s)))
    by (unfold generated; ring).
  apply (is_RInt_primitive (fun u => c * pos u + linear_potential (pos u))).
  - intro u. unfold linear_potential. pose proof (velocity_is_derivative _ _ K u) as D.
    auto_derive; [repeat split; exists (vel u); exact D |].
    change (Derive (fun x => pos x) u) with (Derive pos u). rewrite (is_derive_unique _ _ _ D).
    field.
  - intro u. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    apply continuous_Rplus; [apply continuous_const | apply (pos_continuous _ _ K)].
Qed.

End Integrals.

(** EQ-13 (the paper's counterpart): over any part of an interval from its sample, the
    operator's energy is the growth of H_T, plus E_d, less E_g. *)
Theorem EQ_13 : forall mu beta sigma pos vel friction hand,
  physical mu beta sigma -> paper_motion mu beta sigma pos vel friction hand ->
  forall h t, INR h <= t <= INR (S h) ->
  operator_energy vel hand (INR h) t
  = quantized_storage mu (pos t) (vel t) - quantized_storage mu (pos (INR h)) (vel (INR h))
    + (dissipated beta sigma vel (INR h) t - generated_quantized (pos (INR h)) (pos t)).
Proof.
  intros mu beta sigma pos vel friction hand P O h t Ht. rewrite <- EQ_19_20_by_definition.
  apply is_RInt_unique. unfold quantized_storage.
  exact (EQ_13_interval _ _ _ _ _ _ _ _ _ P O quantized_potential h t Ht).
Qed.

(** EQ-14: so over that part the display is passive in the paper's sense, (12), iff E_g is
    at most E_d. *)
Theorem EQ_14 : forall mu beta sigma pos vel friction hand,
  physical mu beta sigma -> paper_motion mu beta sigma pos vel friction hand ->
  forall h t, INR h <= t <= INR (S h) ->
  (quantized_storage mu (pos t) (vel t) - quantized_storage mu (pos (INR h)) (vel (INR h))
   <= operator_energy vel hand (INR h) t
   <-> generated_quantized (pos (INR h)) (pos t) <= dissipated beta sigma vel (INR h) t).
Proof.
  intros mu beta sigma pos vel friction hand P O h t Ht.
  rewrite (EQ_13 mu beta sigma pos vel friction hand P O h t Ht). split; intro; lra.
Qed.

(** ERR-21/22 and ERR-27 (motion): beta = sigma = 3/5, from 1 to 1/2 at constant speed over
    one interval: (8) holds at every instant, E_d = 9/20, and yet E_g by (18) is 1/2,
    more than (22)'s 3/8. *)
Theorem ERR_27_motion : exists pos vel : R -> R,
  kinematic pos vel /\
  (forall u, criterion_8 (3 / 5) (3 / 5) (vel u)) /\
  dissipated (3 / 5) (3 / 5) vel 0 1 = 9 / 20 /\
  is_RInt (fun u => (held_force (pos 0) - - measured (pos u)) * vel u) 0 1 (1 / 2) /\
  bound_22 (pos 1 - pos 0) = 3 / 8.
Proof.
  pose proof (kinematic_line 1 (- (1 / 2))) as K.
  exists (fun t => 1 + - (1 / 2) * t), (fun _ => - (1 / 2)).
  assert (A : Rabs (- (1 / 2)) = 1 / 2) by (rewrite Rabs_Ropp, Rabs_right; lra).
  split; [exact K |]. split; [| split; [| split]].
  - intros _ _. unfold margin_8, viscous_surplus, coulomb_surplus. rewrite A. lra.
  - unfold dissipated. rewrite RInt_const. unfold friction_power. rewrite A.
    unfold scal; simpl; unfold mult; simpl. field.
  - pose proof (EQ_19_20 _ _ K 0 1 ltac:(lra)) as E. cbv beta in E.
    replace (1 + - (1 / 2) * 0) with 1 in E by field.
    replace (1 + - (1 / 2) * 1) with (1 / 2) in E by field.
    rewrite step_1_half in E. replace (1 + - (1 / 2) * 0) with 1 by field. exact E.
  - unfold bound_22. replace (1 + - (1 / 2) * 1 - (1 + - (1 / 2) * 0)) with (- (1 / 2)) by field.
    rewrite A. field.
Qed.

(** ERR-19-start (motion): from the sample at 1/2 at speed 1, between 3/5 and 1 of the
    interval, (18) gives 2/5 against the bound 7/25. *)
Theorem ERR_19_start_motion : exists pos vel : R -> R,
  kinematic pos vel /\
  is_RInt (fun u => (held_force (pos 0) - - measured (pos u)) * vel u) (3 / 5) 1 (2 / 5) /\
  bound_22 (pos 1 - pos (3 / 5)) = 7 / 25.
Proof.
  pose proof (kinematic_line (1 / 2) 1) as K.
  exists (fun t => 1 / 2 + 1 * t), (fun _ => 1). split; [exact K |].
  pose proof (EQ_18_held _ _ K (1 / 2) (3 / 5) 1 ltac:(lra)) as E. cbv beta in E.
  replace (1 / 2 + 1 * 0) with (1 / 2) by field.
  replace (1 / 2 + 1 * 1) with (3 / 2) in * by field.
  replace (1 / 2 + 1 * (3 / 5)) with (11 / 10) in * by field.
  split.
  - replace (2 / 5) with (generated (held_force (1 / 2)) (11 / 10) (3 / 2)
      (quantized_potential (11 / 10)) (quantized_potential (3 / 2))); [exact E |].
    unfold generated, held_force, measured, quantized_potential, quantization_potential,
      linear_potential, residue.
    rewrite (floor_unique (11 / 10) 1), (floor_unique (3 / 2) 1), floor_half by lra. field.
  - unfold bound_22. rewrite Rabs_right by lra. field.
Qed.
