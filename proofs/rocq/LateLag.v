(** * LateLag: TH-LAG and TH-LATENCY together, a first-order lag that starts k + f periods late.

    m = k + f + theta, and Var = f (1 - f) + Var(theta) + 2 theta ((a - e)/(1 - e) - f) with a =
    exp (-(1 - f)/theta) and e = exp (-1/theta), as the kernel's actuator has them. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ActuatorCost InstantRun LagForm LagVariance Lag
  Weighted FiniteResponse GatedController LateActuator.
Open Scope R_scope.

(** What has not yet come of a step, [x] periods after its sample. *)
Definition late_lag (k : nat) (f theta x : R) : R :=
  Rmin 1 (exp (- (x - (INR k + f)) / theta)).

Definition late_power (f theta t : R) : R := exp (- (t - f) / theta).

Definition late_lag_behind (k : nat) (f theta t : R) : R :=
  INR k + Rmin 1 (late_power f theta t)
  + late_power f theta t * (lag_decay theta / (1 - lag_decay theta)).

Definition late_lag_mean (k : nat) (f theta : R) : R := INR k + f + theta.

Definition late_lag_variance (f theta : R) : R :=
  latency_variance f + lag_variance theta
  + 2 * theta * ((late_power f theta 1 - lag_decay theta) / (1 - lag_decay theta) - f).

Lemma continuous_Rmin_one : forall (g : R -> R) x, continuous g x ->
  continuous (fun t => Rmin 1 (g t)) x.
Proof.
  intros g x C. apply continuous_ext with (fun t => / 2 * ((1 + g t) + -1 * Rabs (1 + -1 * g t))).
  - intro t. over_R. unfold Rmin, Rabs. destruct Rle_dec, Rcase_abs; lra.
  - apply continuous_Rmult; [apply continuous_const |].
    apply continuous_Rplus; [apply continuous_Rplus; [apply continuous_const | exact C] |].
    apply continuous_Rmult; [apply continuous_const |]. apply continuous_Rabs.
    apply continuous_Rplus; [apply continuous_const |].
    apply continuous_Rmult; [apply continuous_const | exact C].
Qed.

Section LateLag.

Variables (k : nat) (f theta : R).
Hypothesis f_between : 0 <= f < 1.
Hypothesis theta_positive : 0 < theta.

Let e := lag_decay theta.
Let late := late_lag k f theta.
Let X := late_power f theta.
Let behind := late_lag_behind k f theta.

Lemma late_decay : 0 < e < 1.
Proof. exact (decay_between theta theta_positive). Qed.

Lemma power_falls : forall x y, x <= y -> exp (- y / theta) <= exp (- x / theta).
Proof.
  intros x y H. assert (T : 0 < / theta) by (apply Rinv_0_lt_compat; exact theta_positive).
  destruct H as [H | ->]; [| lra]. apply Rlt_le, exp_increasing. unfold Rdiv. nra.
Qed.

Lemma power_continuous : forall t, continuous X t.
Proof.
  intro t. apply (ex_derive_continuous X). unfold X, late_power. auto_derive. exact I.
Qed.

Lemma late_lag_delays : only_delays late.
Proof.
  split.
  - intro x. apply continuous_Rmin_one.
    apply (ex_derive_continuous (fun x => exp (- (x - (INR k + f)) / theta))). auto_derive. exact I.
  - intros x y H. unfold late, late_lag. apply Rle_min_compat_l.
    apply power_falls. lra.
  - intro x. unfold late, late_lag. split; [| apply Rmin_l].
    apply Rmin_glb; [lra | apply Rlt_le, exp_pos].
Qed.

(** X 0 = exp (f/theta), X f = 1, and X 1 is e times the first. *)
Lemma power_points : X f = 1 /\ X 1 = e * X 0 /\ 0 < X 0.
Proof.
  unfold X, late_power, e, lag_decay. repeat split; [| | apply exp_pos].
  - replace (- (f - f) / theta) with 0 by (unfold Rdiv; ring). apply exp_0.
  - rewrite <- exp_plus. f_equal. field. lra.
Qed.

Lemma late_of : forall i t, 0 <= t -> late (INR (k + i) + t) <= X t * e ^ i.
Proof.
  intros i t Ht. unfold late, late_lag. eapply Rle_trans; [apply Rmin_r |]. apply Req_le.
  replace (- (INR (k + i) + t - (INR k + f)) / theta)
    with (- (t - f) / theta + INR i * (- 1 / theta)) by (rewrite plus_INR; field; lra).
  rewrite exp_plus. unfold X, late_power. f_equal.
  unfold e, lag_decay. clear. induction i as [| i IH]; [simpl; rewrite Rmult_0_l; apply exp_0 |].
  rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, exp_plus, IH. simpl. ring.
Qed.

Lemma late_sum : forall M t, 0 <= t <= 1 ->
  sum_to (k + S M) (fun j => late (INR (pred j) + t))
  <= INR k + Rmin 1 (X t) + X t * ((e - e ^ S M) / (1 - e)).
Proof.
  intros M t Ht. pose proof late_decay as E. induction M as [| M IH].
  - replace (k + 1)%nat with (S k) by lia. rewrite sum_to_S. simpl pred.
    assert (A : sum_to k (fun j => late (INR (pred j) + t)) <= INR k).
    { replace (INR k) with (sum_to k (fun _ => 1)) by (rewrite Angles.sum_to_const; ring).
      apply Angles.sum_to_le. intros j _. apply (late_share _ late_lag_delays). }
    assert (B : late (INR k + t) = Rmin 1 (X t)).
    { unfold late, late_lag, X, late_power. do 3 f_equal. ring. }
    rewrite B. replace ((e - e ^ 1) / (1 - e)) with 0 by (simpl; field; lra). lra.
  - replace (k + S (S M))%nat with (S (k + S M)) by lia. rewrite sum_to_S. simpl pred.
    pose proof (late_of (S M) t (proj1 Ht)) as L.
    replace ((e - e ^ S (S M)) / (1 - e)) with ((e - e ^ S M) / (1 - e) + e ^ S M)
      by (simpl; field; lra). lra.
Qed.

Lemma late_lag_covers : behind_covers late behind.
Proof.
  pose proof late_decay as E.
  assert (R0 : 0 < e / (1 - e)) by (apply Rdiv_lt_0_compat; lra).
  assert (X0 : forall t, 0 < X t) by (intro; apply exp_pos).
  split.
  - intro t. apply continuous_Rplus.
    + apply continuous_Rplus; [apply continuous_const |].
      apply continuous_Rmin_one, power_continuous.
    + apply continuous_Rmult; [apply power_continuous | apply continuous_const].
  - intro t. unfold behind, late_lag_behind. fold X e. specialize (X0 t).
    pose proof (pos_INR k). assert (0 <= Rmin 1 (X t)) by (apply Rmin_glb; lra).
    assert (0 < X t * (e / (1 - e))) by (apply Rmult_lt_0_compat; lra). fold (X t). lra.
  - intros N t Ht.
    assert (G : sum_to N (fun j => late (INR (pred j) + t))
                <= sum_to (k + S N) (fun j => late (INR (pred j) + t))).
    { replace (k + S N)%nat with (N + S k)%nat by lia. generalize (S k). intro i.
      induction i as [| i IH]; [rewrite Nat.add_0_r; lra |].
      replace (N + S i)%nat with (S (N + i)) by lia. rewrite sum_to_S.
      pose proof (late_share _ late_lag_delays (INR (pred (S (N + i))) + t)). lra. }
    eapply Rle_trans; [exact G |]. eapply Rle_trans; [apply late_sum, Ht |].
    unfold behind, late_lag_behind. fold e. fold (X t). apply Rplus_le_compat_l.
    apply Rmult_le_compat_l; [apply Rlt_le, X0 |].
    unfold Rdiv. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra |].
    assert (0 < e ^ S N) by (apply pow_lt; lra). lra.
Qed.

(** ** The moments *)

Lemma power_integral : forall p q s u,
  is_RInt (fun t => p + q * X t) s u (p * (u - s) + q * theta * (X s - X u)).
Proof.
  intros p q s u. replace (p * (u - s) + q * theta * (X s - X u))
    with ((p * u - q * theta * X u) - (p * s - q * theta * X s)) by ring.
  apply (is_RInt_primitive (fun t => p * t - q * theta * X t)).
  - intro t. unfold X, late_power. auto_derive; [exact I |].
    change (- (t + - f) * / theta) with (- (t - f) / theta).
    generalize (exp (- (t - f) / theta)). intro x. over_R. field. lra.
  - intro t. apply continuous_Rplus; [apply continuous_const |].
    apply continuous_Rmult; [apply continuous_const | apply power_continuous].
Qed.

Lemma power_square_integral : forall p q s u,
  is_RInt (fun t => (p + q * X t) ^ 2) s u
    (p ^ 2 * (u - s) + 2 * p * q * theta * (X s - X u) + q ^ 2 * theta / 2 * (X s ^ 2 - X u ^ 2)).
Proof.
  intros p q s u.
  replace (p ^ 2 * (u - s) + 2 * p * q * theta * (X s - X u)
           + q ^ 2 * theta / 2 * (X s ^ 2 - X u ^ 2))
    with ((p ^ 2 * u - 2 * p * q * theta * X u - q ^ 2 * theta / 2 * X u ^ 2)
          - (p ^ 2 * s - 2 * p * q * theta * X s - q ^ 2 * theta / 2 * X s ^ 2)) by field.
  apply (is_RInt_primitive
    (fun t => p ^ 2 * t - 2 * p * q * theta * X t - q ^ 2 * theta / 2 * X t ^ 2)).
  - intro t. unfold X, late_power. auto_derive; [exact I |].
    change (- (t + - f) * / theta) with (- (t - f) / theta).
    generalize (exp (- (t - f) / theta)). intro x. over_R. field. lra.
  - intro t. apply continuous_square. apply continuous_Rplus; [apply continuous_const |].
    apply continuous_Rmult; [apply continuous_const | apply power_continuous].
Qed.

Lemma behind_before : forall t, t <= f -> behind t = (INR k + 1) + e / (1 - e) * X t.
Proof.
  intros t Ht. unfold behind, late_lag_behind. fold e. fold (X t).
  assert (1 <= X t).
  { pose proof (power_falls (t - f) 0 ltac:(lra)) as F. unfold X, late_power.
    replace (- 0 / theta) with 0 in F by (unfold Rdiv; ring). rewrite exp_0 in F. exact F. }
  rewrite Rmin_left by assumption. ring.
Qed.

Lemma behind_after : forall t, f <= t -> behind t = INR k + 1 / (1 - e) * X t.
Proof.
  intros t Ht. unfold behind, late_lag_behind. fold e. fold (X t). pose proof late_decay as E.
  assert (X t <= 1).
  { pose proof (power_falls 0 (t - f) ltac:(lra)) as F. unfold X, late_power.
    replace (- 0 / theta) with 0 in F by (unfold Rdiv; ring). rewrite exp_0 in F. exact F. }
  rewrite Rmin_right by assumption. field. lra.
Qed.

Lemma late_lag_mean_is : mean_of behind = late_lag_mean k f theta.
Proof.
  pose proof late_decay as E. destruct power_points as (Xf & X1 & X0).
  apply is_RInt_unique.
  replace (late_lag_mean k f theta)
    with (((INR k + 1) * (f - 0) + e / (1 - e) * theta * (X 0 - X f))
          + (INR k * (1 - f) + 1 / (1 - e) * theta * (X f - X 1))).
  - apply is_RInt_join with f.
    + apply is_RInt_ext with (2 := power_integral (INR k + 1) (e / (1 - e)) 0 f).
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. symmetry. apply behind_before. lra.
    + apply is_RInt_ext with (2 := power_integral (INR k) (1 / (1 - e)) f 1).
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. symmetry. apply behind_after. lra.
  - rewrite Xf, X1. unfold late_lag_mean. field. lra.
Qed.

Lemma late_lag_variance_is : variance_of behind = late_lag_variance f theta.
Proof.
  pose proof late_decay as E. destruct power_points as (Xf & X1 & X0).
  unfold variance_of. rewrite late_lag_mean_is.
  rewrite (is_RInt_unique (fun t => behind t ^ 2) 0 1
    (((INR k + 1) ^ 2 * (f - 0) + 2 * (INR k + 1) * (e / (1 - e)) * theta * (X 0 - X f)
      + (e / (1 - e)) ^ 2 * theta / 2 * (X 0 ^ 2 - X f ^ 2))
     + (INR k ^ 2 * (1 - f) + 2 * INR k * (1 / (1 - e)) * theta * (X f - X 1)
        + (1 / (1 - e)) ^ 2 * theta / 2 * (X f ^ 2 - X 1 ^ 2)))).
  - unfold late_lag_variance, latency_variance, lag_variance, late_lag_mean. fold e. fold (X 1).
    rewrite Xf, X1. over_R. field. lra.
  - apply is_RInt_join with f.
    + apply is_RInt_ext with (2 := power_square_integral (INR k + 1) (e / (1 - e)) 0 f).
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. rewrite behind_before by lra. reflexivity.
    + apply is_RInt_ext with (2 := power_square_integral (INR k) (1 / (1 - e)) f 1).
      intros t Ht. rewrite Rmin_left, Rmax_right in Ht by lra. rewrite behind_after by lra. reflexivity.
Qed.

End LateLag.

(** TH-LAG (with latency): the product's controller, one-sided or not, rounded, saturated, behind a
    latency of k + f periods and a first-order lag; after rest. *)
Theorem TH_LAG_latency : forall mu beta sigma kappa pos vel friction hand force past c n k f theta
    one_sided force_step limit measure e,
  physical mu beta sigma -> 0 <= f < 1 -> 0 < theta ->
  step_positive force_step -> limit_nonneg limit ->
  (forall x, Rabs (measure x - x) <= e) -> (forall x, measure x < 0 <-> x < 0) ->
  0 <= tail c n 0 ->
  0 <= spare_mean kappa (late_lag_mean k f theta) ->
  0 <= spare_square kappa (late_lag_mean k f theta) (late_lag_variance f theta) ->
  (forall j, past j = pos 0) ->
  obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t) ->
  actuates (late_lag k f theta)
    (held_by_gated pos past c n 0 one_sided force_step limit measure) force ->
  forall t, 0 <= t ->
  criterion_holds (beta - (tail c n 0 * kappa + tails_norm (tail c n) n))
                  (sigma - (e * response_norm c n + step_size force_step / 2)) vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + scaled_potential (tail c n 0) one_sided limit (pos 0))
    (kinetic mu (vel t) + scaled_potential (tail c n 0) one_sided limit (pos t)) t.
Proof.
  intros mu beta sigma kappa pos vel friction hand force past c n k f theta one_sided force_step
    limit measure e P Hf Ht Hs Hl Hm Hd H0 K1 K2 R O A.
  rewrite <- (late_lag_mean_is k f theta Hf Ht) in K1, K2.
  rewrite <- (late_lag_variance_is k f theta Hf Ht) in K2.
  exact (TH_LAG_actuator mu beta sigma kappa pos vel friction hand force (late_lag k f theta)
    (late_lag_behind k f theta) past c n one_sided force_step limit measure e P Hs Hl Hm Hd H0
    (late_lag_delays k f theta Ht) (late_lag_covers k f theta Ht) K1 K2 R O A).
Qed.

(** TH-LAG (variance with latency): never above the bound that needs no exponential. *)
Theorem TH_LAG_latency_variance : forall f theta, 0 <= f < 1 -> 0 < theta ->
  0 <= late_lag_variance f theta <= latency_variance f + Rmin (theta / 2) (1 / 12).
Proof.
  intros f theta Hf Ht. pose proof (decay_between theta Ht) as E. split.
  - rewrite <- (late_lag_variance_is 0 f theta Hf Ht).
    apply (variance_nonneg (late_lag 0 f theta)), late_lag_covers; assumption.
  - pose proof (TH_LAG_variance theta Ht) as V. unfold late_lag_variance.
    set (e := lag_decay theta) in *. set (a := late_power f theta 1).
    assert (Convex : a <= e + f * (1 - e)).
    { set (z := - (1 - f) / theta). assert (Y : 0 < / theta) by (apply Rinv_0_lt_compat; exact Ht).
      assert (A0 : 0 < a) by apply exp_pos.
      assert (T : forall u, a * (1 + (u - z)) <= exp u).
      { intro u. replace (exp u) with (a * exp (u - z))
          by (unfold a, late_power; fold z; rewrite <- exp_plus; f_equal; ring).
        apply Rmult_le_compat_l; [lra |].
        destruct (Req_dec (u - z) 0) as [-> | N]; [rewrite exp_0; lra |].
        apply Rlt_le, exp_ineq1, N. }
      pose proof (T 0) as T0. rewrite exp_0 in T0. pose proof (T (- 1 / theta)) as T1.
      fold (lag_decay theta) in T1. fold e in T1.
      replace (a * (1 + (0 - z))) with (a * (1 + (1 - f) * / theta)) in T0
        by (unfold z, Rdiv; ring).
      replace (a * (1 + (- 1 / theta - z))) with (a * (1 - f * / theta)) in T1
        by (unfold z, Rdiv; ring).
      apply (Rmult_le_compat_l f) in T0; [| lra].
      apply (Rmult_le_compat_l (1 - f)) in T1; [| lra]. nra. }
    assert (C : (a - e) / (1 - e) - f <= 0).
    { apply Rle_minus. apply Rmult_le_reg_r with (1 - e); [lra |].
      replace ((a - e) / (1 - e) * (1 - e)) with (a - e) by (field; lra). lra. }
    assert (theta * ((a - e) / (1 - e) - f) <= 0) by nra. lra.
Qed.

(** ** Without latency: the amplifier of TH-LAG *)

Lemma lag_alone : forall theta x, 0 < theta -> 0 <= x ->
  late_lag 0 0 theta x = exp (- x / theta).
Proof.
  intros theta x Ht Hx. unfold late_lag. simpl (INR 0).
  replace (- (x - (0 + 0)) / theta) with (- x / theta) by (field; lra).
  apply Rmin_right. pose proof (power_falls theta Ht 0 x Hx) as F.
  replace (- 0 / theta) with 0 in F by (unfold Rdiv; ring). rewrite exp_0 in F. exact F.
Qed.

(** A first-order lag that had settled is the sum of its answers to the steps of the command. *)
Theorem TH_LAG_superposed : forall theta u force, 0 < theta ->
  lagging theta u force -> force 0 = u 0%nat -> actuates (late_lag 0 0 theta) u force.
Proof.
  intros theta u force Ht Lg F0. set (e := lag_decay theta).
  set (S' := fun h => sum_to h (fun j => e ^ pred j * (u (h - pred j)%nat - u (h - j)%nat))).
  assert (At : forall h, force (INR h) = u h - S' h).
  { induction h as [| h IH]; [simpl; rewrite F0; unfold S'; simpl; ring |].
    rewrite (Lg h (INR (S h))) by (rewrite S_INR; lra). rewrite lag_left_end. fold e. rewrite IH.
    assert (Sn : S' (S h) = (u (S h) - u h) + e * S' h).
    { unfold S'. rewrite sum_to_first. simpl pred. simpl (e ^ 0).
      replace (S h - 0)%nat with (S h) by lia. replace (S h - 1)%nat with h by lia.
      rewrite <- Angles.sum_to_scal.
      rewrite (sum_to_ext h (fun i => e ^ i * (u (S h - i)%nat - u (S h - S i)%nat))
        (fun j => e * (e ^ pred j * (u (h - pred j)%nat - u (h - j)%nat)))); [ring |].
      intros [| i] Hi; [lia |]. simpl pred. replace (S h - S i)%nat with (h - i)%nat by lia.
      replace (S h - S (S i))%nat with (h - S i)%nat by lia. simpl (e ^ S i). ring. }
    rewrite Sn. ring. }
  intros h t Hht. rewrite (Lg h t) by lra. rewrite At. unfold superposed.
  rewrite (sum_to_ext h _ (fun j => lag_left theta h t
    * (e ^ pred j * (u (h - pred j)%nat - u (h - j)%nat)))).
  - rewrite Angles.sum_to_scal. fold (S' h). ring.
  - intros j _. pose proof (pos_INR (pred j)). rewrite lag_alone by lra.
    assert (X : exp (- (INR (pred j) + (t - INR h)) / theta) = lag_left theta h t * e ^ pred j).
    { unfold lag_left. replace (- (INR (pred j) + (t - INR h)) / theta)
        with (- (t - INR h) / theta + INR (pred j) * (- 1 / theta)) by (field; lra).
      rewrite exp_plus. f_equal. unfold e, lag_decay. clear. generalize (pred j). intro i.
      induction i as [| i IH]; [simpl; rewrite Rmult_0_l; apply exp_0 |].
      rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, exp_plus, IH. simpl. ring. }
    rewrite X. ring.
Qed.

(** TH-LAG (any controller): the lag of the amplifier behind the product's controller, one-sided or
    not, rounded, saturated; device and amplifier had settled before the start. *)
Theorem TH_LAG_controller : forall mu beta sigma kappa pos vel friction hand force past c n theta
    one_sided force_step limit measure e,
  physical mu beta sigma -> 0 < theta ->
  step_positive force_step -> limit_nonneg limit ->
  (forall x, Rabs (measure x - x) <= e) -> (forall x, measure x < 0 <-> x < 0) ->
  0 <= tail c n 0 ->
  0 <= spare_mean kappa theta -> 0 <= spare_square kappa theta (lag_variance theta) ->
  (forall j, past j = pos 0) ->
  obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t) ->
  let u := held_by_gated pos past c n 0 one_sided force_step limit measure in
  lagging theta u force -> force 0 = u 0%nat ->
  forall t, 0 <= t ->
  criterion_holds (beta - (tail c n 0 * kappa + tails_norm (tail c n) n))
                  (sigma - (e * response_norm c n + step_size force_step / 2)) vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + scaled_potential (tail c n 0) one_sided limit (pos 0))
    (kinetic mu (vel t) + scaled_potential (tail c n 0) one_sided limit (pos t)) t.
Proof.
  intros mu beta sigma kappa pos vel friction hand force past c n theta one_sided force_step
    limit measure e P Ht Hs Hl Hm Hd H0 K1 K2 R O u Lg F0.
  pose proof (decay_between theta Ht) as E.
  assert (M : late_lag_mean 0 0 theta = theta) by (unfold late_lag_mean; simpl; ring).
  assert (V : late_lag_variance 0 theta = lag_variance theta).
  { unfold late_lag_variance, latency_variance, late_power.
    replace (exp (- (1 - 0) / theta)) with (lag_decay theta)
      by (unfold lag_decay; f_equal; field; lra).
    field. lra. }
  apply (TH_LAG_latency mu beta sigma kappa pos vel friction hand force past c n 0 0 theta one_sided
    force_step limit measure e P ltac:(lra) Ht Hs Hl Hm Hd H0); rewrite ?M, ?V; try assumption.
  apply TH_LAG_superposed; assumption.
Qed.
