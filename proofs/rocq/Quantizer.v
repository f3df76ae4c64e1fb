(** * The quantizer: what ⌊·⌋ and rho of (15) satisfy. *)

From Coq Require Import Reals Lra Lia ZArith.
From Passivity Require Import Definitions.
Open Scope R_scope.

Lemma floor_spec : forall x, floor x <= x < floor x + 1.
Proof.
  intro x. unfold floor. destruct (base_Int_part x). lra.
Qed.

Lemma floor_integer : forall x, exists z, floor x = IZR z.
Proof. intro x. exists (Int_part x). reflexivity. Qed.

(** Nothing but the floor satisfies the floor's specification. *)
Lemma floor_unique : forall x z, IZR z <= x < IZR z + 1 -> floor x = IZR z.
Proof.
  intros x z [Hl Hu]. destruct (floor_spec x) as [Fl Fu].
  destruct (floor_integer x) as [n Hn]. rewrite Hn in *. f_equal.
  assert (n < z + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
  assert (z < n + 1)%Z by (apply lt_IZR; rewrite plus_IZR; lra).
  lia.
Qed.

(** EQ-15: a position is its tick plus a residue in [0, 1). *)
Theorem EQ_15 : forall x, x = floor x + residue x /\ 0 <= residue x < 1.
Proof.
  intro x. unfold residue. pose proof (floor_spec x). lra.
Qed.

Lemma residue_bounds : forall x, 0 <= residue x < 1.
Proof. intro x. apply EQ_15. Qed.

(** The middle of the tick is within half a tick of the position. *)
Lemma measured_error : forall x, - (1 / 2) < measured x - x <= 1 / 2.
Proof.
  intro x. unfold measured. pose proof (floor_spec x). lra.
Qed.

(** EQ-5: the force is commanded for a position that is within half a tick of the sampled one. *)
Theorem EQ_5_error : forall x, - (1 / 2) < measured x - x <= 1 / 2.
Proof. exact measured_error. Qed.

Lemma floor_IZR : forall z, floor (IZR z) = IZR z.
Proof. intro z. apply floor_unique. lra. Qed.

Lemma residue_IZR : forall z, residue (IZR z) = 0.
Proof. intro z. unfold residue. rewrite floor_IZR. lra. Qed.

Lemma floor_INR : forall n, floor (INR n) = INR n.
Proof. intro n. rewrite INR_IZR_INZ. apply floor_IZR. Qed.

Lemma floor_shift : forall x z, floor (x + IZR z) = floor x + IZR z.
Proof.
  intros x z. destruct (floor_integer x) as [n Hn].
  pose proof (floor_spec x) as H. rewrite Hn in *. rewrite <- plus_IZR.
  apply floor_unique. rewrite plus_IZR. lra.
Qed.

Lemma floor_monotone : forall x y, x <= y -> floor x <= floor y.
Proof.
  intros x y H. destruct (Rle_lt_dec (floor x) (floor y)) as [L | L]; [exact L | exfalso].
  pose proof (floor_spec x). pose proof (floor_spec y).
  destruct (floor_integer x) as [n Hn]. destruct (floor_integer y) as [p Hp].
  rewrite Hn, Hp in *. apply lt_IZR in L. assert (p + 1 <= n)%Z as L' by lia.
  apply IZR_le in L'. rewrite plus_IZR in L'. lra.
Qed.

(** Two integers less than one apart are equal; used to split a step by the ticks it crosses. *)
Lemma integer_gap : forall x y, exists z, floor x - floor y = IZR z.
Proof.
  intros x y. destruct (floor_integer x) as [n Hn]. destruct (floor_integer y) as [p Hp].
  exists (n - p)%Z. rewrite Hn, Hp, minus_IZR. reflexivity.
Qed.

Lemma integer_zero_or_one : forall z, -1 < IZR z < 2 -> IZR z = 0 \/ IZR z = 1.
Proof.
  intros z [L U]. assert (-1 < z)%Z by (apply lt_IZR; exact L).
  assert (z < 2)%Z by (apply lt_IZR; exact U).
  assert (z = 0 \/ z = 1)%Z as [-> | ->] by lia; lra.
Qed.

(** An integer's product with its neighbour is not negative. *)
Lemma integer_step : forall z, 0 <= IZR z * (IZR z - 1).
Proof.
  intro z. rewrite <- minus_IZR, <- mult_IZR. apply IZR_le. nia.
Qed.

Lemma integer_abs : forall z, Rabs (IZR z) <= IZR z * IZR z.
Proof.
  intro z. rewrite <- abs_IZR, <- mult_IZR. apply IZR_le. nia.
Qed.
