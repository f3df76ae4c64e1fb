(** * Weighted: squares against a weight, for integrals of continuous functions. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus History.
Open Scope R_scope.

Lemma discriminant : forall A B C, 0 <= C ->
  (forall x, 0 <= A - 2 * x * B + x ^ 2 * C) -> B ^ 2 <= A * C.
Proof.
  intros A B C HC Q. destruct (Req_dec C 0) as [-> | N].
  - destruct (Req_dec B 0) as [-> | NB]; [lra |]. exfalso.
    specialize (Q ((A + 1) / (2 * B))).
    replace (A - 2 * ((A + 1) / (2 * B)) * B + ((A + 1) / (2 * B)) ^ 2 * 0) with (- 1) in Q
      by (field; exact NB). lra.
  - specialize (Q (B / C)).
    replace (A - 2 * (B / C) * B + (B / C) ^ 2 * C) with ((A * C - B ^ 2) / C) in Q
      by (field; exact N).
    apply (Rmult_le_compat_r C) in Q; [| exact HC].
    replace ((A * C - B ^ 2) / C * C) with (A * C - B ^ 2) in Q by (field; exact N). lra.
Qed.

(** A product of two roots is at most the mean of the products. *)
Lemma product_of_squares : forall X Y a b c d, 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d ->
  X ^ 2 <= a * b -> Y ^ 2 <= c * d -> X * Y <= (c * b + a * d) / 2.
Proof.
  intros X Y a b c d Ha Hb Hc Hd HX HY.
  assert (0 <= c * b) by (apply Rmult_le_pos; assumption).
  assert (0 <= a * d) by (apply Rmult_le_pos; assumption).
  apply Rsqr_incr_0_var; [| lra]. unfold Rsqr.
  pose proof (pow2_ge_0 X). pose proof (pow2_ge_0 Y). pose proof (pow2_ge_0 (c * b - a * d)).
  assert (X ^ 2 * Y ^ 2 <= (a * b) * (c * d)) by (apply Rmult_le_compat; assumption). nra.
Qed.

(** Continuous functions with a positive weight. *)
Lemma continuous_div : forall (f w : R -> R) x, continuous f x -> continuous w x -> w x <> 0 ->
  continuous (fun t => f t / w t) x.
Proof.
  intros f w x Cf Cw N. apply continuous_Rmult; [exact Cf |].
  apply (continuous_comp w Rinv); [exact Cw |]. apply continuous_Rinv. exact N.
Qed.

Lemma continuous_square : forall (f : R -> R) x, continuous f x -> continuous (fun t => f t ^ 2) x.
Proof.
  intros f x C. apply continuous_ext with (fun t => f t * f t); [intro; over_R; ring |].
  apply continuous_Rmult; exact C.
Qed.

Lemma continuous_sum_to : forall n (f : nat -> R -> R) x,
  (forall j, continuous (f j) x) -> continuous (fun t => sum_to n (fun j => f j t)) x.
Proof.
  intros n f x C. induction n as [| n IH]; simpl; [apply continuous_const |].
  apply continuous_Rplus; [exact IH | apply C].
Qed.

Lemma RInt_sum_to : forall n (f : nat -> R -> R) a b,
  (forall j, ex_RInt (f j) a b) ->
  is_RInt (fun t => sum_to n (fun j => f j t)) a b (sum_to n (fun j => RInt (f j) a b)).
Proof.
  intros n f a b E. induction n as [| n IH]; simpl.
  - evar_last; [apply (@is_RInt_const R_NormedModule) | apply Rmult_0_r].
  - apply (@is_RInt_plus R_NormedModule (fun t => sum_to n (fun j => f j t))); [exact IH |].
    apply RInt_is, E.
Qed.

(** Cauchy-Schwarz: (int r g)^2 <= (int r^2 g/w)(int g w). *)
Lemma weighted_squares : forall (r g w : R -> R) a b, a <= b ->
  (forall t, continuous r t) -> (forall t, continuous g t) -> (forall t, continuous w t) ->
  (forall t, 0 < w t) -> (forall t, a < t < b -> 0 <= g t) ->
  RInt (fun t => r t * g t) a b ^ 2
  <= RInt (fun t => r t ^ 2 * g t / w t) a b * RInt (fun t => g t * w t) a b.
Proof.
  intros r g w a b ab Cr Cg Cw Pw Pg.
  assert (C1 : forall t, continuous (fun t => r t * g t) t)
    by (intro; apply continuous_Rmult; auto).
  assert (C2 : forall t, continuous (fun t => r t ^ 2 * g t / w t) t).
  { intro t. apply continuous_div; [| auto | pose proof (Pw t); lra].
    apply continuous_Rmult; [apply continuous_square |]; auto. }
  assert (C3 : forall t, continuous (fun t => g t * w t) t)
    by (intro; apply continuous_Rmult; auto).
  apply discriminant.
  - apply RInt_ge_0; [exact ab | apply ex_RInt_cont, C3 |].
    intros t Ht. apply Rmult_le_pos; [apply Pg, Ht | apply Rlt_le, Pw].
  - intro x.
    assert (Q : is_RInt (fun t => r t ^ 2 * g t / w t
      + (- (2 * x) * (r t * g t) + x ^ 2 * (g t * w t))) a b
      (RInt (fun t => r t ^ 2 * g t / w t) a b
       + (- (2 * x) * RInt (fun t => r t * g t) a b + x ^ 2 * RInt (fun t => g t * w t) a b))).
    { apply (@is_RInt_plus R_NormedModule (fun t => r t ^ 2 * g t / w t));
        [apply RInt_is, ex_RInt_cont, C2 |].
      apply (@is_RInt_plus R_NormedModule (fun t => - (2 * x) * (r t * g t)));
        apply (@is_RInt_scal R_NormedModule); apply RInt_is, ex_RInt_cont; assumption. }
    apply is_RInt_ge_0 in Q; [lra | exact ab |].
    intros t Ht. pose proof (Pw t) as W0. specialize (Pg t Ht).
    replace (r t ^ 2 * g t / w t + (- (2 * x) * (r t * g t) + x ^ 2 * (g t * w t)))
      with (g t * ((r t - x * w t) ^ 2 / w t)) by (field; lra).
    apply Rmult_le_pos; [exact Pg |]. apply Rdiv_le_0_compat; [apply pow2_ge_0 | exact W0].
Qed.
