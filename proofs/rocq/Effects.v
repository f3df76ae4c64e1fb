(** * Effects: TH-LAW, TH-UNI, TH-DAC, TH-DELAY, TH-DAMP, TH-SMOOTH, and all of them at once,
    as runs on the paper's clock 0, 1, 2, ... *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws.
Open Scope R_scope.

(** A force is drawn passively when the operator's energy covers the growth of storage [E]. *)
Definition passive_run (vel hand : R -> R) (E0 Et t : R) : Prop :=
  ex_RInt (fun u => hand u * vel u) 0 t /\ Et - E0 <= operator_energy vel hand 0 t.

(** (8) with the terms of the effects, at every instant up to [t]. *)
Definition criterion_holds (viscous coulomb : R) (vel : R -> R) (t : R) : Prop :=
  forall u, 0 <= u <= t -> vel u <> 0 -> 0 <= margin_8 viscous coulomb (vel u).

Section Effects.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Hypothesis P : physical mu beta sigma.

(** The measured position j samples before sample h. *)
Let q (h j : nat) : R := measured (sample INR pos past h j).

(** What the operator may draw from extra storage left by the history before the start. *)
Definition start_extra (k : nat) (B : R) : R := extra k B (step INR pos past 0).

(** TH-COMBINED (encoder): a law [f], virtual damping [B] on positions [k] samples late, and
    a D/A converter within [delta]/2, with criterion
    (beta - 1/2 - k - B) v + (sigma - (1 + delta)/2 - B) >= 0. *)
Theorem TH_COMBINED_encoder : forall f V B delta k F,
  lipschitz f -> 0 <= B -> 0 <= delta -> potential f V ->
  (forall h, commands f B delta (q h k) (q h (S k)) (F h)) ->
  obeys mu beta sigma INR (fun h => - F h) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta (INR k) B) (coulomb_surplus sigma delta B) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0) + start_extra k B)
                       (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros f V B delta k F Lf HB Hd HV HF O t Ht H8.
  assert (W : wall f V B delta (1 / 2)) by (split; try assumption; lra).
  assert (D : rendered f B delta (1 / 2) k INR pos past (fun h => - F h)).
  { intro h. exists (q h k), (q h (S k)).
    split; [apply encoder_error |]. split; [apply encoder_error |].
    rewrite Ropp_involutive. apply HF. }
  destruct (INR_covers t Ht) as (N & HN).
  destruct (TH_COMBINED mu beta sigma f V B delta (1 / 2) k INR _ past pos vel friction hand
    P INR_increasing INR_on_time W O D N t HN) as (I & E).
  - simpl (INR 0). intros u Hu Hv. specialize (H8 u Hu Hv).
    rewrite viscous_need_surplus, coulomb_need_surplus in H8. exact H8.
  - pose proof (extra_nonneg k B (push (pos t - pos (INR N)) (step INR pos past N)) HB).
    unfold extra_towards, extra_at in E. simpl (INR 0) in *.
    split; [exact I |]. unfold start_extra. lra.
Qed.

(** TH-LAW: any 1-Lipschitz force law with a potential; the criterion is unchanged. *)
Theorem TH_LAW : forall f V, lipschitz f -> potential f V ->
  obeys mu beta sigma INR (fun h => - f (measured (pos (INR h)))) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0)) (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros f V Lf HV O t Ht H8.
  pose proof (TH_COMBINED_encoder f V 0 0 0
    (fun h => f (measured (pos (INR h)))) Lf (Rle_refl 0) (Rle_refl 0) HV) as C.
  unfold start_extra in C. rewrite no_extra, Rplus_0_r in C. apply C; try assumption.
  intro h. unfold q, commands. rewrite sample_now.
  replace (_ - f _) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

(** TH-UNI: the unilateral wall, force 0 when the sample is outside; the criterion is unchanged. *)
Theorem TH_UNI :
  obeys mu beta sigma INR (fun h => - clipped_below 0 (measured (pos (INR h)))) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + Rmax (pos 0) 0 ^ 2 / 2)
                       (kinetic mu (vel t) + Rmax (pos t) 0 ^ 2 / 2) t.
Proof.
  intros O t Ht H8.
  assert (E : forall x, law_potential_of x (clipped_below 0 x) = Rmax x 0 ^ 2 / 2).
  { intro x. unfold law_potential_of, clipped_below, Rmax. destruct (Rle_dec x 0); field. }
  rewrite <- !E. apply (TH_LAW _ _ (lipschitz_below 0) (potential_below 0 (Rle_refl 0)) O t Ht H8).
Qed.

(** TH-LAW (saturation): a wall whose force is clipped; the criterion is unchanged. *)
Theorem TH_LAW_saturation : forall lo hi, lo <= 0 <= hi ->
  obeys mu beta sigma INR (fun h => - clipped lo hi (measured (pos (INR h)))) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + law_potential_of (pos 0) (clipped lo hi (pos 0)))
                       (kinetic mu (vel t) + law_potential_of (pos t) (clipped lo hi (pos t))) t.
Proof.
  intros lo hi Hl O. exact (TH_LAW _ _ (lipschitz_clipped lo hi) (potential_clipped lo hi Hl) O).
Qed.

(** TH-DAC: a force rounded to steps of [delta]; sigma has delta/2 less to spare. *)
Theorem TH_DAC : forall delta, 0 < delta ->
  obeys mu beta sigma INR (fun h => - rounded_force (measured (pos (INR h))) delta)
        pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta 0 0) (coulomb_surplus sigma delta 0) vel t ->
  passive_run vel hand (storage mu (pos 0) (vel 0)) (storage mu (pos t) (vel t)) t.
Proof.
  intros delta Hd O t Ht H8.
  pose proof (TH_COMBINED_encoder (fun x => x) linear_potential 0 delta 0
    (fun h => rounded_force (measured (pos (INR h))) delta) lipschitz_id
    (Rle_refl 0) (Rlt_le _ _ Hd) potential_linear) as C.
  unfold start_extra in C. rewrite no_extra, Rplus_0_r in C. apply C; try assumption.
  intro h. unfold q, commands. rewrite sample_now, Rmult_0_l, Rplus_0_l. apply rounding_error, Hd.
Qed.

(** TH-DELAY: the force [k] samples late; beta has k less to spare, and the storage at the
    start includes the last k displacements. *)
Theorem TH_DELAY : forall k,
  obeys mu beta sigma INR (fun h => - measured (sample INR pos past h k)) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta (INR k) 0) (coulomb_surplus sigma 0 0) vel t ->
  passive_run vel hand
    (storage mu (pos 0) (vel 0) + delay_storage k (step INR pos past 0))
    (storage mu (pos t) (vel t)) t.
Proof.
  intros k O t Ht H8.
  pose proof (TH_COMBINED_encoder (fun x => x) linear_potential 0 0 k
    (fun h => q h k) lipschitz_id (Rle_refl 0) (Rle_refl 0) potential_linear) as C.
  replace (start_extra k 0) with (delay_storage k (step INR pos past 0)) in C
    by (unfold start_extra, extra, damping_storage; field).
  apply C; try assumption. intro h. unfold commands.
  replace (q h k - q h k) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

(** TH-DAMP: virtual damping -B (q_h - q_(h-1)); beta and sigma have B less to spare, and the
    storage at the start includes B/2 of the last displacement squared. *)
Theorem TH_DAMP : forall B, 0 <= B ->
  obeys mu beta sigma INR (fun h => - (q h 0 + B * (q h 0 - q h 1))) pos vel friction hand ->
  forall t, 0 <= t ->
  criterion_holds (viscous_surplus beta 0 B) (coulomb_surplus sigma 0 B) vel t ->
  passive_run vel hand
    (storage mu (pos 0) (vel 0) + B * step INR pos past 0 1 ^ 2 / 2)
    (storage mu (pos t) (vel t)) t.
Proof.
  intros B HB O t Ht H8.
  pose proof (TH_COMBINED_encoder (fun x => x) linear_potential B 0 0
    (fun h => q h 0 + B * (q h 0 - q h 1)) lipschitz_id HB (Rle_refl 0)
    potential_linear) as C.
  replace (start_extra 0 B) with (B * step INR pos past 0 1 ^ 2 / 2) in C
    by (unfold start_extra, extra, delay_storage, damping_storage; simpl; field).
  apply C; try assumption. intro h. unfold commands.
  replace (_ - q h 0) with (B * (q h 0 - q h 1)) by ring.
  rewrite Rabs_mult, (Rabs_right B) by lra. lra.
Qed.

(** TH-SMOOTH: without an encoder the 1/2 of quantization goes: (beta - 1/2) v + sigma >= 0,
    which for sigma = 0 is Colgate's beta >= 1/2. *)
Theorem TH_SMOOTH :
  obeys mu beta sigma INR (fun h => - pos (INR h)) pos vel friction hand ->
  forall t, 0 <= t -> criterion_holds (beta - 1 / 2) sigma vel t ->
  passive_run vel hand (storage mu (pos 0) (vel 0)) (storage mu (pos t) (vel t)) t.
Proof.
  intros O t Ht H8.
  assert (W : wall (fun x => x) linear_potential 0 0 0)
    by (split; try lra; try apply lipschitz_id; exact potential_linear).
  assert (D : rendered (fun x => x) 0 0 0 0 INR pos past (fun h => - pos (INR h))).
  { intro h. exists (sample INR pos past h 0), (sample INR pos past h 1).
    unfold commands. rewrite sample_now.
    split; [| split]; (replace (_ - _) with 0 by ring); rewrite Rabs_R0; lra. }
  destruct (INR_covers t Ht) as (N & HN).
  destruct (TH_COMBINED mu beta sigma _ _ 0 0 0 0 INR _ past pos vel friction hand
    P INR_increasing INR_on_time W O D N t HN) as (I & E).
  - simpl (INR 0). intros u Hu Hv. specialize (H8 u Hu Hv).
    replace (beta - viscous_need 0 0) with (beta - 1 / 2) by (unfold viscous_need; ring).
    replace (sigma - coulomb_need 0 0 0) with sigma by (unfold coulomb_need; field). exact H8.
  - unfold extra_towards, extra_at in E. rewrite !no_extra in E. simpl (INR 0) in *.
    split; [exact I |]. unfold storage. lra.
Qed.

End Effects.

(** A device that rested before the start (all earlier samples at its starting position)
    carries no extra storage. *)
Theorem TH_DELAY_TH_DAMP_at_rest : forall pos past k B,
  (forall j, past j = pos 0) -> start_extra pos past k B = 0.
Proof.
  intros pos past k B H.
  assert (Z : forall j, step INR pos past 0 j = 0).
  { assert (S : forall j, sample INR pos past 0 j = pos 0).
    { intros [| j]; unfold sample; simpl; [reflexivity | apply H]. }
    intro j. unfold step. rewrite !S. ring. }
  unfold start_extra, extra. rewrite delay_storage_at_rest, damping_storage_at_rest by exact Z. ring.
Qed.
