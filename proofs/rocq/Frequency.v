(** * Frequency: the cost of TH-LTI at one frequency, in Colgate's form and as a polynomial. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions History Angles FiniteResponse.
Open Scope R_scope.

(** The real part of (1 - exp (-i theta)) H (exp (i theta)), H(z) = c_0 + c_1/z + ... *)
Definition colgate_real (c : nat -> R) (n : nat) (theta : R) : R :=
  sum_f_R0 (fun j => c j * (cos (INR j * theta) - cos (INR (S j) * theta))) n.

Lemma cos_second_difference : forall j t,
  cos (INR (S (S j)) * t) + cos (INR j * t) = 2 * cos t * cos (INR (S j) * t).
Proof.
  intros j t. rewrite !S_INR.
  replace ((INR j + 1 + 1) * t) with ((INR j + 1) * t + t) by ring.
  replace (INR j * t) with ((INR j + 1) * t - t) by ring. rewrite cos_plus, cos_minus. ring.
Qed.

(** TH-LTI (frequency): the symbol is Colgate and Schenkel's
    Re[(1 - exp (-i theta)) H (exp (i theta))] / (2 (1 - cos theta)). *)
Theorem TH_LTI_colgate : forall c n theta,
  colgate_real c n theta
  = 2 * (1 - cos theta) * symbol (tail c n 0) (tail c n) n theta.
Proof.
  intros c n theta. unfold colgate_real, symbol.
  rewrite (sum_eq _ (fun j => (tail c n j - tail c n (S j))
    * (cos (INR j * theta) - cos (INR (S j) * theta))))
    by (intros j Hj; rewrite tail_step by lia; reflexivity).
  rewrite (sum_by_parts (tail c n) (fun j => cos (INR j * theta) - cos (INR (S j) * theta))).
  rewrite (tail_beyond c n (S n)) by lia.
  rewrite (sum_to_ext n _ (fun j => - 2 * (1 - cos theta) * (tail c n j * cos (INR j * theta)))).
  - rewrite sum_to_scal. simpl (INR 0). simpl (INR 1).
    rewrite Rmult_0_l, Rmult_1_l, cos_0. field.
  - intros [| j] Hj; [lia |]. simpl pred. pose proof (cos_second_difference j theta). nra.
Qed.

(** ** As a polynomial in x = cos theta *)

Fixpoint chebyshev (j : nat) (x : R) : R :=
  match j with
  | O => 1
  | S i => match i with O => x | S h => 2 * x * chebyshev i x - chebyshev h x end
  end.

Lemma chebyshev_cos : forall j t, chebyshev j (cos t) = cos (INR j * t).
Proof.
  intros j t. assert (G : chebyshev j (cos t) = cos (INR j * t)
                          /\ chebyshev (S j) (cos t) = cos (INR (S j) * t)); [| apply G].
  induction j as [| j [IH1 IH2]].
  - simpl. rewrite Rmult_0_l, Rmult_1_l, cos_0. split; reflexivity.
  - split; [exact IH2 |].
    change (chebyshev (S (S j)) (cos t)) with (2 * cos t * chebyshev (S j) (cos t) - chebyshev j (cos t)).
    rewrite IH1, IH2. pose proof (cos_second_difference j t). lra.
Qed.

Definition symbol_polynomial (H : R) (g : nat -> R) (n : nat) (x : R) : R :=
  H / 2 + sum_to n (fun j => g j * chebyshev j x).

(** TH-LTI (polynomial): what is decided is whether a polynomial is not negative on [-1, 1]. *)
Theorem TH_LTI_polynomial : forall H g n lambda,
  (forall theta, symbol H g n theta <= lambda)
  <-> (forall x, -1 <= x <= 1 -> 0 <= lambda - symbol_polynomial H g n x).
Proof.
  intros H g n lambda.
  assert (E : forall t, symbol_polynomial H g n (cos t) = symbol H g n t).
  { intro t. unfold symbol_polynomial, symbol. f_equal. apply sum_to_ext.
    intros j _. rewrite chebyshev_cos. reflexivity. }
  split; intro B.
  - intros x Hx. specialize (B (acos x)). rewrite <- E, cos_acos in B by exact Hx. lra.
  - intro t. specialize (B (cos t) (COS_bound t)). rewrite E in B. lra.
Qed.

(** ** One sample of delay with virtual damping B >= 1/4 *)

Definition late_damping (B : R) (j : nat) : R :=
  match j with 1%nat => 1 + B | 2%nat => - B | _ => 0 end.

(** TH-LTI (delay with damping): it costs 1/2 + B + 1/(8 B), 5/4 for B = 1/2 and 41/16 for B = 2,
    and no less; the sum of what the two cost alone is 3/2 + B. *)
Theorem TH_LTI_delay_with_damping : forall B, 1 / 4 <= B ->
  let cost := symbol (tail (late_damping B) 2 0) (tail (late_damping B) 2) 2 in
  (forall theta, cost theta <= 1 / 2 + B + 1 / (8 * B)) /\
  (exists theta, cost theta = 1 / 2 + B + 1 / (8 * B)).
Proof.
  intros B HB cost.
  assert (E : forall t, cost t = 1 / 2 + B + 1 / (8 * B) - 2 * B * (cos t - 1 / (4 * B)) ^ 2).
  { intro t. unfold cost, symbol, tail. simpl. rewrite Rmult_1_l.
    replace ((1 + 1) * t) with (2 * t) by ring. rewrite cos_2a_cos. field. lra. }
  split.
  - intro t. rewrite E. pose proof (pow2_ge_0 (cos t - 1 / (4 * B))). nra.
  - exists (acos (1 / (4 * B))). rewrite E, cos_acos; [ring |].
    assert (0 < 1 / (4 * B)) by (apply Rdiv_lt_0_compat; lra).
    assert (1 / (4 * B) <= 1).
    { apply Rmult_le_reg_r with (4 * B); [lra |].
      replace (1 / (4 * B) * (4 * B)) with 1 by (field; lra). lra. }
    lra.
Qed.
