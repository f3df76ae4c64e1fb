(** * Glue: a smooth motion made of one smooth piece for each interval [z, z + 1]. *)

From Coq Require Import Reals Lra Lia Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus.
Open Scope R_scope.

Lemma interval_of : forall t z, IZR z <= t < IZR z + 1 -> Int_part t = z.
Proof. intros t z H. apply eq_IZR, (floor_unique t z), H. Qed.

Lemma Int_part_spec : forall t, IZR (Int_part t) <= t < IZR (Int_part t) + 1.
Proof. exact floor_spec. Qed.

(** The motion that is [f z] on [z, z + 1). *)
Definition glued (f : Z -> R -> R) (t : R) : R := f (Int_part t) t.

Lemma glued_on : forall f z t, IZR z <= t < IZR z + 1 -> glued f t = f z t.
Proof. intros f z t H. unfold glued. rewrite (interval_of t z H). reflexivity. Qed.

Section Glue.

Variable f : Z -> R -> R.
Hypothesis meets : forall z, f z (IZR z + 1) = f (z + 1)%Z (IZR z + 1).

Lemma glued_at_end : forall z, glued f (IZR z + 1) = f z (IZR z + 1).
Proof.
  intro z. rewrite meets. apply glued_on. rewrite plus_IZR. lra.
Qed.

Lemma glued_on_closed : forall z t, IZR z <= t <= IZR z + 1 -> glued f t = f z t.
Proof.
  intros z t [L [U | ->]]; [apply glued_on; lra | apply glued_at_end].
Qed.

(** Near any instant the glued motion is one piece on the left and one on the right, both
    of which hold at the instant itself. *)
Lemma glued_near : forall t, exists zl zr r, 0 < r /\
  (forall u, t - r < u <= t -> glued f u = f zl u /\ IZR zl <= u <= IZR zl + 1) /\
  (forall u, t <= u < t + r -> glued f u = f zr u /\ IZR zr <= u < IZR zr + 1) /\
  zr = Int_part t /\ (zl = zr \/ (zr = (zl + 1)%Z /\ t = IZR zl + 1)).
Proof.
  intro t. pose proof (Int_part_spec t) as S. set (z := Int_part t) in *.
  destruct (Req_dec t (IZR z)) as [E | E].
  - exists (z - 1)%Z, z, 1. repeat split; try lra.
    + apply glued_on_closed. rewrite minus_IZR. lra.
    + rewrite minus_IZR. lra.
    + rewrite minus_IZR. lra.
    + apply glued_on. lra.
    + right. split; [lia | rewrite minus_IZR; lra].
  - exists z, z, (Rmin (t - IZR z) (IZR z + 1 - t)).
    pose proof (Rmin_l (t - IZR z) (IZR z + 1 - t)). pose proof (Rmin_r (t - IZR z) (IZR z + 1 - t)).
    repeat split; try lra; try (apply glued_on; lra); [apply Rmin_glb_lt; lra | left; reflexivity].
Qed.

Lemma glued_continuous : (forall z t, continuous (f z) t) -> forall t, continuous (glued f) t.
Proof.
  intros C t. destruct (glued_near t) as (zl & zr & r & Rp & Lf & Rt & _).
  apply continuity_pt_filterlim. intros eps He.
  destruct (continuous_near (f zl) t eps (C zl t) He) as (rl & Pl & Nl).
  destruct (continuous_near (f zr) t eps (C zr t) He) as (rr & Pr & Nr).
  exists (Rmin r (Rmin rl rr)). split; [repeat apply Rmin_glb_lt; assumption |].
  intros u [_ Hu]. change (Rabs (u - t) < Rmin r (Rmin rl rr)) in Hu.
  change (Rabs (glued f u - glued f t) < eps).
  pose proof (Rmin_l r (Rmin rl rr)). pose proof (Rmin_r r (Rmin rl rr)).
  pose proof (Rmin_l rl rr). pose proof (Rmin_r rl rr).
  destruct (Rle_lt_dec t u) as [S | S].
  - destruct (Rt u) as [-> _]; [apply Rabs_def2 in Hu; lra |].
    destruct (Rt t) as [-> _]; [lra |]. apply Nr. lra.
  - destruct (Lf u) as [-> _]; [apply Rabs_def2 in Hu; lra |].
    destruct (Lf t) as [-> _]; [lra |]. apply Nl. lra.
Qed.

Lemma glued_derive : forall df : Z -> R -> R,
  (forall z t, is_derive (f z) t (df z t)) ->
  (forall z, df z (IZR z + 1) = df (z + 1)%Z (IZR z + 1)) ->
  forall t, is_derive (glued f) t (glued df t).
Proof.
  intros df D M t. destruct (glued_near t) as (zl & zr & r & Rp & Lf & Rt & Zr & Side).
  apply is_derive_Reals. intros eps He.
  pose proof (proj1 (is_derive_Reals _ _ _) (D zl t) eps He) as (dl & Nl).
  pose proof (proj1 (is_derive_Reals _ _ _) (D zr t) eps He) as (dr & Nr).
  assert (Eq : df zl t = df zr t).
  { destruct Side as [-> | [-> ->]]; [reflexivity | apply M]. }
  assert (Dt : glued df t = df zr t) by (unfold glued; rewrite <- Zr; reflexivity).
  pose proof (cond_pos dl). pose proof (cond_pos dr).
  assert (Pm : 0 < Rmin r (Rmin dl dr)) by (repeat apply Rmin_glb_lt; assumption).
  exists (mkposreal _ Pm). intros h Hh Hs. simpl in Hs.
  pose proof (Rmin_l r (Rmin dl dr)). pose proof (Rmin_r r (Rmin dl dr)).
  pose proof (Rmin_l dl dr). pose proof (Rmin_r dl dr). rewrite Dt.
  destruct (Rle_lt_dec 0 h) as [S | S].
  - destruct (Rt (t + h)) as [-> _]; [apply Rabs_def2 in Hs; lra |].
    destruct (Rt t) as [-> _]; [lra |]. apply Nr; [exact Hh | lra].
  - destruct (Lf (t + h)) as [-> _]; [apply Rabs_def2 in Hs; lra |].
    destruct (Lf t) as [-> _]; [lra |]. rewrite <- Eq. apply Nl; [exact Hh | lra].
Qed.

End Glue.
