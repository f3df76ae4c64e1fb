(** * Stability: the recursion that decides whether one or two poles are inside the unit circle (TH-LTI).

    A root z = x + iy of d0 z + d1, or of d0 z^2 + d1 z + d2, is inside where x^2 + y^2 < 1. *)

From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

Definition pole_inside (d0 d1 : R) : Prop :=
  forall x y, d0 * x + d1 = 0 -> d0 * y = 0 -> x ^ 2 + y ^ 2 < 1.

(** The real and the imaginary part of d0 z^2 + d1 z + d2 are zero. *)
Definition root_of_two (d0 d1 d2 x y : R) : Prop :=
  d0 * (x ^ 2 - y ^ 2) + d1 * x + d2 = 0 /\ y * (2 * d0 * x + d1) = 0.

Definition poles_inside (d0 d1 d2 : R) : Prop :=
  forall x y, root_of_two d0 d1 d2 x y -> x ^ 2 + y ^ 2 < 1.

Lemma square_below_1 : forall x, x ^ 2 < 1 <-> Rabs x < 1.
Proof.
  intro x. rewrite <- (pow2_abs x). pose proof (Rabs_pos x). split; intro H1; nra.
Qed.

(** TH-LTI (one pole): its root is inside exactly where |d1| < |d0|. *)
Theorem TH_LTI_stable_one : forall d0 d1, d0 <> 0 ->
  (pole_inside d0 d1 <-> 0 < Rabs d0 - Rabs d1).
Proof.
  intros d0 d1 N. pose proof (Rabs_pos_lt d0 N) as Pos. split.
  - intro H. specialize (H (- d1 / d0) 0 ltac:(field; exact N) ltac:(ring)).
    assert (E : Rabs (- d1 / d0) < 1) by (apply square_below_1; lra).
    unfold Rdiv in E. rewrite Rabs_mult, Rabs_Ropp, Rabs_inv in E.
    assert (Rabs d1 * / Rabs d0 * Rabs d0 = Rabs d1) by (field; lra). nra.
  - intros H x y Hx Hy. assert (y = 0) as -> by (apply Rmult_integral in Hy; tauto).
    assert (E : Rabs d0 * Rabs x = Rabs d1).
    { rewrite <- Rabs_mult. replace d1 with (- (d0 * x)) by lra. rewrite Rabs_Ropp. reflexivity. }
    assert (Rabs x < 1) by (pose proof (Rabs_pos x); nra).
    assert (x ^ 2 < 1) by (apply square_below_1; assumption). lra.
Qed.

(** Two poles with the leading coefficient 1. *)
Lemma monic_inside : forall a b, Rabs b < 1 -> Rabs a < 1 + b -> poles_inside 1 a b.
Proof.
  intros a b Hb Ha x y [Re Im]. apply Rabs_def2 in Hb. apply Rabs_def2 in Ha.
  apply Rmult_integral in Im. destruct Im as [-> | L].
  - apply Rnot_le_lt. intro G. assert (1 <= x \/ x <= -1) as [G1 | G1].
    { destruct (Rlt_le_dec x 0); [right | left]; nra. }
    + assert (0 <= (x - 1) * (x - b)) by (apply Rmult_le_pos; lra). nra.
    + assert (0 <= (- x - 1) * (- x - b)) by (apply Rmult_le_pos; lra). nra.
  - assert (a = -2 * x) by lra. subst a. nra.
Qed.

Lemma inside_monic : forall a b, poles_inside 1 a b -> Rabs b < 1 /\ Rabs a < 1 + b.
Proof.
  intros a b H. destruct (Rlt_le_dec (a ^ 2 - 4 * b) 0) as [D | D].
  - set (s := sqrt (4 * b - a ^ 2)).
    assert (S : s * s = 4 * b - a ^ 2) by (apply sqrt_sqrt; lra).
    assert (I := H (- a / 2) (s / 2)). unfold root_of_two in I.
    assert (b < 1) by (enough ((- a / 2) ^ 2 + (s / 2) ^ 2 < 1) by nra; apply I; split; nra).
    split; [apply Rabs_def1; nra |]. apply Rabs_def1; nra.
  - set (s := sqrt (a ^ 2 - 4 * b)).
    assert (S : s * s = a ^ 2 - 4 * b) by (apply sqrt_sqrt; lra).
    set (p := (- a + s) / 2). set (q := (- a - s) / 2).
    assert (A : a = - (p + q)) by (unfold p, q; field).
    assert (B : b = p * q) by (unfold p, q; nra).
    assert (Rp : p ^ 2 + 0 ^ 2 < 1) by (apply H; split; [rewrite A, B |]; ring).
    assert (Rq : q ^ 2 + 0 ^ 2 < 1) by (apply H; split; [rewrite A, B |]; ring).
    assert (Ip : -1 < p < 1) by nra. assert (Iq : -1 < q < 1) by nra.
    assert (0 < (1 - p) * (1 - q)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (1 + p) * (1 + q)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (1 - p) * (1 + q)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (1 + p) * (1 - q)) by (apply Rmult_lt_0_compat; lra).
    split; apply Rabs_def1; nra.
Qed.

Lemma poles_scaled : forall d0 d1 d2, d0 <> 0 ->
  (poles_inside d0 d1 d2 <-> poles_inside 1 (d1 / d0) (d2 / d0)).
Proof.
  intros d0 d1 d2 N.
  assert (E : forall x y, root_of_two d0 d1 d2 x y <-> root_of_two 1 (d1 / d0) (d2 / d0) x y).
  { intros x y. unfold root_of_two. split; intros [R I]; split.
    - apply Rmult_eq_reg_l with d0; [| exact N]. rewrite Rmult_0_r, <- R. field. exact N.
    - apply Rmult_eq_reg_l with d0; [| exact N]. rewrite Rmult_0_r, <- I. field. exact N.
    - apply (f_equal (Rmult d0)) in R. rewrite Rmult_0_r in R. rewrite <- R. field. exact N.
    - apply (f_equal (Rmult d0)) in I. rewrite Rmult_0_r in I. rewrite <- I. field. exact N. }
  split; intros H x y R; apply H, E, R.
Qed.

(** TH-LTI (two poles): their roots are inside exactly where the two rows of the recursion say so. *)
Theorem TH_LTI_stable_two : forall d0 d1 d2, d0 <> 0 ->
  (poles_inside d0 d1 d2 <->
   0 < Rabs d0 - Rabs d2 /\ 0 < Rabs (d0 - d2 / d0 * d2) - Rabs (d1 - d2 / d0 * d1)).
Proof.
  intros d0 d1 d2 N. rewrite (poles_scaled d0 d1 d2 N). pose proof (Rabs_pos_lt d0 N) as Pos.
  set (a := d1 / d0). set (b := d2 / d0).
  replace (d0 - b * d2) with (d0 * (1 - b * b)) by (unfold b; field; exact N).
  replace (d1 - b * d1) with (d0 * (a * (1 - b))) by (unfold a; field; exact N).
  replace d2 with (d0 * b) at 1 by (unfold b; field; exact N).
  rewrite !Rabs_mult.
  assert (Rows : Rabs b < 1 /\ Rabs a < 1 + b <->
    0 < Rabs d0 - Rabs d0 * Rabs b /\
    0 < Rabs d0 * Rabs (1 - b * b) - Rabs d0 * (Rabs a * Rabs (1 - b))).
  { assert (First : Rabs b < 1 <-> 0 < Rabs d0 - Rabs d0 * Rabs b) by (split; intro; nra).
    split; intros [H1 H2]; (split; [apply First, H1 |]).
    - apply Rabs_def2 in H1. rewrite (Rabs_right (1 - b * b)), (Rabs_right (1 - b)) by nra.
      assert (0 < (1 - b) * (1 + b - Rabs a)) by (apply Rmult_lt_0_compat; lra).
      assert (0 < Rabs d0 * ((1 - b) * (1 + b - Rabs a))) by (apply Rmult_lt_0_compat; lra). nra.
    - apply First in H1. apply Rabs_def2 in H1.
      rewrite (Rabs_right (1 - b * b)), (Rabs_right (1 - b)) in H2 by nra.
      assert (0 < Rabs d0 * ((1 - b) * (1 + b - Rabs a))) by nra.
      apply Rnot_le_lt. intro G.
      assert (0 <= Rabs d0 * ((1 - b) * (Rabs a - (1 + b)))).
      { apply Rmult_le_pos; [lra |]. apply Rmult_le_pos; lra. }
      nra. }
  rewrite <- Rows. split; [apply inside_monic | intros [H1 H2]; apply monic_inside; assumption].
Qed.
