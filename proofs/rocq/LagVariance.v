(** * LagVariance: the bound of TH-LAG's variance that needs no exponential. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import ActuatorCost LagForm.
Open Scope R_scope.

(** What is 0 at 0 and grows from there on is not negative. *)
Lemma grows_from_zero : forall h dh : R -> R, h 0 = 0 -> (forall x, is_derive h x (dh x)) ->
  (forall x, 0 <= x -> 0 <= dh x) -> forall x, 0 <= x -> 0 <= h x.
Proof.
  intros h dh Z D N x Hx. destruct (MVT_gen h 0 x dh) as (c & Hc & E).
  - intros u _. apply D.
  - intros u _. apply continuity_pt_filterlim, (ex_derive_continuous h). exists (dh u). apply D.
  - rewrite Rmin_left, Rmax_right in Hc by lra. specialize (N c ltac:(lra)). nra.
Qed.

(** y^2 (E - 1) - 6 y (E + 1) + 12 (E - 1) for E = exp y: its third derivative is y^2 E. *)
Lemma exponential_bound : forall y, 0 <= y ->
  0 <= y ^ 2 * (exp y - 1) - 6 * y * (exp y + 1) + 12 * (exp y - 1).
Proof.
  set (k := fun y => y ^ 2 * (exp y - 1) - 6 * y * (exp y + 1) + 12 * (exp y - 1)).
  set (k1 := fun y => y ^ 2 * exp y - 4 * y * exp y - 2 * y + 6 * exp y - 6).
  set (k2 := fun y => y ^ 2 * exp y - 2 * y * exp y + 2 * exp y - 2).
  set (k3 := fun y => y ^ 2 * exp y).
  assert (P2 : forall y, 0 <= y -> 0 <= k2 y).
  { apply (grows_from_zero k2 k3).
    - unfold k2. rewrite exp_0. ring.
    - intro x. unfold k2, k3. auto_derive; [exact I | ring].
    - intros x _. apply Rmult_le_pos; [apply pow2_ge_0 | apply Rlt_le, exp_pos]. }
  assert (P1 : forall y, 0 <= y -> 0 <= k1 y).
  { apply (grows_from_zero k1 k2); [| | exact P2].
    - unfold k1. rewrite exp_0. ring.
    - intro x. unfold k1, k2. auto_derive; [exact I | ring]. }
  change (forall y, 0 <= y -> 0 <= k y). apply (grows_from_zero k k1); [| | exact P1].
  - unfold k. rewrite exp_0. ring.
  - intro x. unfold k, k1. auto_derive; [exact I | ring].
Qed.

(** TH-LAG (variance): positive, and at most theta/2 and 1/12. *)
Theorem TH_LAG_variance : forall theta, 0 < theta ->
  0 < lag_variance theta <= Rmin (theta / 2) (1 / 12).
Proof.
  intros theta T0. split; [apply variance_positive, T0 |].
  pose proof (decay_between theta T0) as E0. unfold lag_variance.
  set (e := lag_decay theta) in *. set (y := / theta).
  assert (Y0 : 0 < y) by (apply Rinv_0_lt_compat; exact T0).
  assert (Ty : theta * y = 1) by (unfold y; field; lra).
  assert (Ee : e * exp y = 1).
  { unfold e, lag_decay, y. rewrite <- exp_plus. rewrite <- exp_0. f_equal. field. lra. }
  pose proof (exp_ineq1 y ltac:(lra)) as X. pose proof (exponential_bound y ltac:(lra)) as B.
  replace (theta / 2 * ((1 + e) / (1 - e)) - theta ^ 2)
    with (theta * (1 + e - 2 * theta * (1 - e)) / (2 * (1 - e))) by (field; lra).
  apply Rmin_glb.
  - apply Rmult_le_reg_r with (2 * (1 - e)); [lra |].
    replace (theta * (1 + e - 2 * theta * (1 - e)) / (2 * (1 - e)) * (2 * (1 - e)))
      with (theta * (1 + e - 2 * theta * (1 - e))) by (field; lra).
    assert (e * (1 + y) <= 1) by nra.
    assert (e * (theta + 1) <= theta).
    { replace (e * (theta + 1)) with (theta * (e * (1 + y)) + e * (1 - theta * y)) by ring.
      rewrite Ty. nra. }
    replace (theta / 2 * (2 * (1 - e))) with (theta * (1 - e)) by field.
    apply Rmult_le_compat_l; lra.
  - apply Rmult_le_reg_r with (2 * (1 - e)); [lra |].
    replace (theta * (1 + e - 2 * theta * (1 - e)) / (2 * (1 - e)) * (2 * (1 - e)))
      with (theta * (1 + e - 2 * theta * (1 - e))) by (field; lra).
    apply (Rmult_le_compat_l (theta ^ 2 * e)) in B.
    2: { apply Rmult_le_pos; [apply pow2_ge_0 | lra]. }
    replace (theta ^ 2 * e * (y ^ 2 * (exp y - 1) - 6 * y * (exp y + 1) + 12 * (exp y - 1)))
      with ((theta * y) ^ 2 * (e * exp y - e) - 6 * theta * (theta * y) * (e * exp y + e)
            + 12 * theta ^ 2 * (e * exp y - e)) in B by ring.
    rewrite Ty, Ee in B. nra.
Qed.

(** So a kappa that is enough for the bound is enough. *)
Theorem TH_LAG_variance_bound : forall kappa theta, 0 < theta ->
  0 <= spare_square kappa theta (Rmin (theta / 2) (1 / 12)) ->
  0 <= spare_square kappa theta (lag_variance theta).
Proof.
  intros kappa theta T0. unfold spare_square. pose proof (TH_LAG_variance theta T0). lra.
Qed.
