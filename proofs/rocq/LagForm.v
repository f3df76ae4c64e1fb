(** * LagForm: the quadratic form of TH-LAG, with one state.

    Over an interval with velocity v let D and Z be the integrals of v and of exp (-t/theta) v,
    and y what the actuator is behind at the sample; e = exp (-1/theta), and behind it is D + e y
    at the next one.  [lag_gram] is the least integral of v^2 with these D and Z. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import ActuatorCost.
Open Scope R_scope.

Definition lag_decay (theta : R) : R := exp (- 1 / theta).

(** (theta/2) coth (1/(2 theta)) - theta^2. *)
Definition lag_variance (theta : R) : R :=
  theta / 2 * ((1 + lag_decay theta) / (1 - lag_decay theta)) - theta ^ 2.

(** The Gram matrix of 1 and exp (-t/theta) over one period is [[1, alpha], [alpha, gamma]]. *)
Definition lag_alpha (theta : R) : R := theta * (1 - lag_decay theta).
Definition lag_gamma (theta : R) : R := theta * (1 - lag_decay theta ^ 2) / 2.
Definition lag_det (theta : R) : R := lag_gamma theta - lag_alpha theta ^ 2.

Definition lag_gram (theta D Z : R) : R :=
  (lag_gamma theta * D ^ 2 - 2 * lag_alpha theta * D * Z + Z ^ 2) / lag_det theta.

(** p of the storage p y^2. *)
Definition lag_memory (kappa theta : R) : R :=
  (1 - lag_decay theta ^ 2) / (2 * kappa)
  * (kappa ^ 2 - kappa * (1 / 2 + theta * lag_decay theta / (1 + lag_decay theta))
     + lag_det theta / (4 * (1 - lag_decay theta ^ 2))).

Section Form.

Variables kappa theta : R.
Hypothesis theta_positive : 0 < theta.

Let e := lag_decay theta.
Let Var := lag_variance theta.

Lemma decay_between : 0 < e < 1.
Proof.
  unfold e, lag_decay. split; [apply exp_pos |].
  rewrite <- exp_0. apply exp_increasing.
  assert (0 < / theta) by (apply Rinv_0_lt_compat; exact theta_positive).
  unfold Rdiv. lra.
Qed.

(** tanh x < x, at x = 1/(2 theta): the variance is positive. *)
Lemma decay_sum : 2 * theta * (1 - e) < 1 + e.
Proof.
  set (h := fun y => y * (1 + exp (- y)) - 2 * (1 - exp (- y))).
  set (dh := fun y => 1 - exp (- y) * (1 + y)).
  assert (Mean : forall a b, a <= b -> exists c, a <= c <= b /\ h b - h a = dh c * (b - a)).
  { intros a b Hab. destruct (MVT_gen h a b dh) as (c & Hc & E).
    - intros x _. unfold h, dh. auto_derive; [exact I | ring].
    - intros x _. apply continuity_pt_filterlim, (ex_derive_continuous h).
      unfold h. auto_derive. exact I.
    - rewrite Rmin_left, Rmax_right in Hc by lra. exists c. split; assumption. }
  assert (Up : forall c, 0 < c -> 0 < dh c).
  { intros c Hc. unfold dh. pose proof (exp_ineq1 c ltac:(lra)) as X.
    pose proof (exp_pos (- c)) as Y.
    assert (exp (- c) * exp c = 1) by (rewrite <- exp_plus, Rplus_opp_l; apply exp_0). nra. }
  assert (H0 : h 0 = 0) by (unfold h; rewrite Ropp_0, exp_0; ring).
  assert (D0 : dh 0 = 0) by (unfold dh; rewrite Ropp_0, exp_0; ring).
  assert (Pos : forall y, 0 < y -> 0 < h y).
  { intros y Hy. destruct (Mean 0 (y / 2) ltac:(lra)) as (c & Hc & E).
    destruct (Mean (y / 2) y ltac:(lra)) as (c' & Hc' & E').
    pose proof (Up c' ltac:(lra)).
    assert (0 <= dh c).
    { destruct (Req_dec c 0) as [-> | N]; [lra | apply Rlt_le, Up; lra]. }
    nra. }
  assert (Y : 0 < / theta) by (apply Rinv_0_lt_compat; exact theta_positive).
  specialize (Pos (/ theta) Y). unfold h in Pos.
  replace (exp (- / theta)) with e in Pos by (unfold e, lag_decay; f_equal; field; lra).
  apply (Rmult_lt_compat_l theta) in Pos; [| exact theta_positive].
  replace (theta * (/ theta * (1 + e) - 2 * (1 - e))) with (1 + e - 2 * theta * (1 - e)) in Pos
    by (field; lra). lra.
Qed.

Lemma variance_positive : 0 < Var.
Proof.
  pose proof decay_between as E. pose proof decay_sum as S. unfold Var, lag_variance. fold e.
  replace (theta / 2 * ((1 + e) / (1 - e)) - theta ^ 2)
    with (theta / 2 * ((1 + e - 2 * theta * (1 - e)) / (1 - e))) by (field; lra).
  apply Rmult_lt_0_compat; [lra |]. apply Rdiv_lt_0_compat; lra.
Qed.

Lemma det_variance : lag_det theta = (1 - e) ^ 2 * Var.
Proof.
  pose proof decay_between as E.
  unfold lag_det, lag_gamma, lag_alpha, Var, lag_variance. fold e. field. lra.
Qed.

Lemma det_positive : 0 < lag_det theta.
Proof.
  rewrite det_variance. pose proof variance_positive. pose proof decay_between.
  apply Rmult_lt_0_compat; [apply pow_lt; lra | assumption].
Qed.

Hypothesis enough_mean : 0 <= spare_mean kappa theta.
Hypothesis enough_square : 0 <= spare_square kappa theta Var.

Let p := lag_memory kappa theta.

Lemma lag_kappa_positive : 1 / 2 + theta <= kappa.
Proof. unfold spare_mean in enough_mean. lra. Qed.

(** The two factors that p and the discriminant have. *)
Let factor1 := 8 * (1 + e) * (kappa * (kappa - 1 / 2)) - 8 * kappa * e * theta + 2 * (1 - e) * Var.
Let factor2 := 8 * (1 + e) ^ 2 * (kappa * (kappa - 1 / 2)) + 8 * kappa * theta * (1 - e ^ 2)
               - 2 * (1 - e) ^ 2 * Var.

Lemma enough : kappa * theta + Var / 4 <= kappa * (kappa - 1 / 2).
Proof. unfold spare_square in enough_square. lra. Qed.

Lemma factor1_least : 8 * kappa * theta + 4 * Var <= factor1.
Proof.
  unfold factor1. pose proof enough as N. pose proof decay_between.
  apply (Rmult_le_compat_l (8 * (1 + e))) in N; [| lra]. lra.
Qed.

Lemma factor2_positive : 0 < factor2.
Proof.
  unfold factor2. pose proof enough as N. pose proof decay_between as E.
  pose proof variance_positive as V0. pose proof lag_kappa_positive as K0.
  apply (Rmult_le_compat_l (8 * (1 + e) ^ 2)) in N; [| pose proof (pow2_ge_0 (1 + e)); lra].
  assert (0 < kappa * theta) by (apply Rmult_lt_0_compat; lra).
  assert (8 * (1 + e) ^ 2 * (kappa * theta + Var / 4) + 8 * kappa * theta * (1 - e ^ 2)
    - 2 * (1 - e) ^ 2 * Var = 16 * (kappa * theta) * (1 + e) + 8 * (e * Var)) by field.
  assert (0 < 16 * (kappa * theta) * (1 + e)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < e * Var) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma lag_memory_factor : p = (1 - e) * factor1 / (16 * kappa).
Proof.
  pose proof lag_kappa_positive. pose proof decay_between as E.
  unfold p, lag_memory. rewrite det_variance. fold e. unfold factor1.
  field. repeat split; nra.
Qed.

Lemma lag_memory_positive : 0 < p.
Proof.
  rewrite lag_memory_factor. pose proof factor1_least. pose proof lag_kappa_positive.
  pose proof decay_between. pose proof variance_positive.
  assert (0 < kappa * theta) by (apply Rmult_lt_0_compat; lra).
  apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | lra].
Qed.

Let r := 4 * p * (1 - e ^ 2).
Let Q1 := r * kappa - lag_det theta.
Let Q2 := - r * kappa * lag_alpha theta - 2 * p * e * lag_det theta.
Let Q3 := r * (kappa * lag_gamma theta - (1 / 2 + p) * lag_det theta)
          - 4 * p ^ 2 * e ^ 2 * lag_det theta.

Lemma lag_leading : 0 < Q1.
Proof.
  unfold Q1, r. rewrite det_variance, lag_memory_factor.
  pose proof lag_kappa_positive as K0. pose proof decay_between as E.
  pose proof variance_positive as V0. pose proof factor1_least as F.
  replace (4 * ((1 - e) * factor1 / (16 * kappa)) * (1 - e ^ 2) * kappa - (1 - e) ^ 2 * Var)
    with ((1 - e) ^ 2 * ((1 + e) * factor1 / 4 - Var)) by (field; lra).
  apply Rmult_lt_0_compat; [apply pow_lt; lra |].
  apply (Rmult_le_compat_l (1 + e)) in F; [| lra].
  assert (0 < kappa * theta) by (apply Rmult_lt_0_compat; lra).
  assert (0 < (1 + e) * (kappa * theta)) by (apply Rmult_lt_0_compat; lra).
  assert (0 < e * Var) by (apply Rmult_lt_0_compat; lra). nra.
Qed.

Lemma lag_discriminant :
  Q1 * Q3 - Q2 ^ 2
  = lag_det theta * (spare_square kappa theta Var * (1 - e) ^ 3 * (1 + e) * p * factor2 / (8 * kappa)).
Proof.
  pose proof lag_kappa_positive as K0. pose proof decay_between as E.
  unfold Q1, Q2, Q3, r, spare_square, factor2. rewrite lag_memory_factor. unfold factor1.
  rewrite det_variance. unfold lag_gamma, lag_alpha. fold e. unfold Var, lag_variance. fold e.
  field. repeat split; lra.
Qed.

(** TH-LAG (form): what is behind, half the square of the way and the growth of the storage are
    paid by kappa times the least integral of the squared velocity. *)
Theorem TH_LAG_form : forall y D Z,
  y * Z + D ^ 2 / 2 + p * ((D + e * y) ^ 2 - y ^ 2) <= kappa * lag_gram theta D Z.
Proof.
  intros y D Z. pose proof lag_kappa_positive as K0. pose proof decay_between as E.
  pose proof det_positive as Dt. pose proof lag_memory_positive as P0.
  pose proof factor2_positive as F2. pose proof lag_leading as A0.
  assert (R0 : 0 < r).
  { unfold r. apply Rmult_lt_0_compat; [lra | nra]. }
  assert (Disc : 0 <= Q1 * Q3 - Q2 ^ 2).
  { rewrite lag_discriminant. apply Rmult_le_pos; [lra |].
    apply Rdiv_le_0_compat; [| lra].
    apply Rmult_le_pos; [| lra]. apply Rmult_le_pos; [| lra].
    apply Rmult_le_pos; [| lra]. apply Rmult_le_pos; [exact enough_square | apply pow_le; lra]. }
  assert (Inner : 0 <= Q1 * Z ^ 2 + 2 * Q2 * D * Z + Q3 * D ^ 2).
  { apply Rmult_le_reg_l with Q1; [exact A0 |]. rewrite Rmult_0_r.
    replace (Q1 * (Q1 * Z ^ 2 + 2 * Q2 * D * Z + Q3 * D ^ 2))
      with ((Q1 * Z + Q2 * D) ^ 2 + (Q1 * Q3 - Q2 ^ 2) * D ^ 2) by ring.
    pose proof (pow2_ge_0 (Q1 * Z + Q2 * D)).
    assert (0 <= (Q1 * Q3 - Q2 ^ 2) * D ^ 2)
      by (apply Rmult_le_pos; [exact Disc | apply pow2_ge_0]).
    lra. }
  assert (Id : r * lag_det theta * (kappa * lag_gram theta D Z
      - (y * Z + D ^ 2 / 2 + p * ((D + e * y) ^ 2 - y ^ 2)))
    = lag_det theta * (2 * p * (1 - e ^ 2) * y - Z - 2 * p * e * D) ^ 2
      + (Q1 * Z ^ 2 + 2 * Q2 * D * Z + Q3 * D ^ 2)).
  { unfold lag_gram, Q1, Q2, Q3, r. field. lra. }
  assert (0 <= lag_det theta * (2 * p * (1 - e ^ 2) * y - Z - 2 * p * e * D) ^ 2)
    by (apply Rmult_le_pos; [lra | apply pow2_ge_0]).
  assert (RD : 0 < r * lag_det theta) by (apply Rmult_lt_0_compat; assumption).
  apply Rminus_le. apply Rmult_le_reg_l with (r * lag_det theta); [exact RD |]. lra.
Qed.

End Form.
