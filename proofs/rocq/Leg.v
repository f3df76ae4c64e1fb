(** * Leg: the profile of one leg of the smooth cycle. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus.
Open Scope R_scope.

Section Profile.

Variable k : nat.
Let p : nat := S k.
Definition scale : R := (2 * INR p + 1) / (2 * INR p).
Definition wave (m : nat) (r : R) : R := (2 * r - 1) ^ m.

Definition leg (r : R) : R := scale * (r - (wave (S (2 * p)) r + 1) / (2 * (2 * INR p + 1))).
Definition dleg (r : R) : R := scale * (1 - wave (2 * p) r).
Definition ddleg (r : R) : R := - scale * (INR (2 * p) * 2 * wave (pred (2 * p)) r).

(** The integral of the square of [dleg]. *)
Definition qleg (r : R) : R :=
  scale ^ 2 * (r - wave (S (2 * p)) r / (2 * INR p + 1)
               + wave (S (2 * (2 * p))) r / (2 * (4 * INR p + 1))).

Lemma p_positive : 1 <= INR p.
Proof. unfold p. rewrite S_INR. pose proof (pos_INR k). lra. Qed.

Lemma INR_2p : INR (2 * p) = 2 * INR p.
Proof. rewrite mult_INR. simpl (INR 2). ring. Qed.

Lemma INR_4p : INR (2 * (2 * p)) = 4 * INR p.
Proof. rewrite mult_INR, INR_2p. simpl (INR 2). ring. Qed.

Lemma wave_derive : forall m r, is_derive (wave m) r (INR m * 2 * wave (pred m) r).
Proof.
  intros m r. unfold wave. auto_derive; [exact I |].
  change (2 * r + - (1)) with (2 * r - 1). generalize ((2 * r - 1) ^ pred m). over_R. ring.
Qed.

Lemma wave_continuous : forall m r, continuous (wave m) r.
Proof. intros. apply (ex_derive_continuous (wave m)). eexists. apply wave_derive. Qed.

Lemma waves_derive : forall a b m c n e r,
  is_derive (fun r => a * r + b * wave m r + c * wave n r + e) r
    (a + b * (INR m * 2 * wave (pred m) r) + c * (INR n * 2 * wave (pred n) r)).
Proof.
  intros. evar_last.
  { apply (@is_derive_plus R_AbsRing R_NormedModule); [| apply is_derive_const].
    apply (@is_derive_plus R_AbsRing R_NormedModule); [| apply is_derive_scal, wave_derive].
    apply (@is_derive_plus R_AbsRing R_NormedModule); [| apply is_derive_scal, wave_derive].
    apply is_derive_scal, is_derive_id. }
  unfold plus, zero, one; simpl. ring.
Qed.

(** Replaces a function and its derivative by equal ones. *)
Lemma derive_as : forall (f g : R -> R) (r df dg : R),
  is_derive f r df -> (forall x, f x = g x) -> df = dg -> is_derive g r dg.
Proof. intros f g r df dg D E <-. apply is_derive_ext with (2 := D). exact E. Qed.

Lemma leg_derive : forall r, is_derive leg r (dleg r).
Proof.
  intro r. pose proof p_positive. set (s := scale / (2 * (2 * INR p + 1))).
  apply (derive_as _ _ _ _ _ (waves_derive scale (- s) (S (2 * p)) 0 0 (- s) r)).
  - intro x. unfold leg, s. field. lra.
  - unfold dleg, s. rewrite S_INR, INR_2p. change (pred (S (2 * p))) with (2 * p)%nat. field. lra.
Qed.

Lemma dleg_derive : forall r, is_derive dleg r (ddleg r).
Proof.
  intro r.
  apply (derive_as _ _ _ _ _ (waves_derive 0 (- scale) (2 * p) 0 0 scale r)).
  - intro x. unfold dleg. ring.
  - unfold ddleg. ring.
Qed.

Lemma qleg_derive : forall r, is_derive qleg r (dleg r ^ 2).
Proof.
  intro r. pose proof p_positive. set (s := scale ^ 2).
  apply (derive_as _ _ _ _ _ (waves_derive s (- s / (2 * INR p + 1)) (S (2 * p))
    (s / (2 * (4 * INR p + 1))) (S (2 * (2 * p))) 0 r)).
  - intro x. unfold qleg. fold s. field. lra.
  - rewrite (S_INR (2 * p)), (S_INR (2 * (2 * p))), INR_4p, INR_2p.
    change (pred (S (2 * p))) with (2 * p)%nat. change (pred (S (2 * (2 * p)))) with (2 * (2 * p))%nat.
    unfold dleg. fold s. replace (wave (2 * (2 * p)) r) with (wave (2 * p) r ^ 2)
      by (unfold wave; rewrite <- pow_mult; f_equal; lia).
    unfold s. field. lra.
Qed.

Lemma ddleg_continuous : forall r, continuous ddleg r.
Proof.
  intro r. unfold ddleg. apply continuous_Rmult; [apply continuous_const |].
  apply continuous_Rmult; [apply continuous_const | apply wave_continuous].
Qed.

Lemma wave_ends : wave (2 * p) 0 = 1 /\ wave (2 * p) 1 = 1 /\
  wave (S (2 * p)) 0 = -1 /\ wave (S (2 * p)) 1 = 1 /\
  wave (S (2 * (2 * p))) 0 = -1 /\ wave (S (2 * (2 * p))) 1 = 1.
Proof.
  unfold wave. replace (2 * 0 - 1) with (-1) by ring. replace (2 * 1 - 1) with 1 by ring.
  rewrite !pow1, !pow_1_even, !pow_1_odd. repeat split; reflexivity.
Qed.

Lemma leg_ends : leg 0 = 0 /\ leg 1 = 1 /\ dleg 0 = 0 /\ dleg 1 = 0.
Proof.
  destruct wave_ends as (E0 & E1 & O0 & O1 & _). pose proof p_positive.
  unfold leg, dleg. rewrite E0, E1, O0, O1. unfold scale. repeat split; field; lra.
Qed.

Lemma qleg_ends : qleg 1 - qleg 0 = 1 + / (4 * INR p + 1).
Proof.
  destruct wave_ends as (_ & _ & O0 & O1 & Q0 & Q1). pose proof p_positive.
  unfold qleg. rewrite O0, O1, Q0, Q1. unfold scale. field. lra.
Qed.

Lemma dleg_nonneg : forall r, 0 <= r <= 1 -> 0 <= dleg r.
Proof.
  intros r Hr. pose proof p_positive. unfold dleg. apply Rmult_le_pos.
  - unfold scale. apply Rdiv_le_0_compat; lra.
  - assert (wave (2 * p) r <= 1); [| lra]. unfold wave. rewrite pow_mult.
    apply Rle_trans with (1 ^ p); [apply pow_incr; split; [apply pow2_ge_0 | nra] | rewrite pow1; lra].
Qed.

End Profile.
