(** * CheckerLag: loops with the first-order lag of an amplifier, after a latency or not.

    The variance of what is late has exponentials in it (TH-LAG).  The partial sums of their series are
    above and below them in turn, and so the variance is between two rational numbers. *)

From Coq Require Import Reals ZArith QArith Qreals Qround Lra Lia Psatz List Bool RMicromega.
From Coquelicot Require Import Coquelicot.
From Passivity Require Definitions.
From Passivity Require Import Calculus Model Laws Effects Controller FiniteResponse GatedController ActuatorCost LagForm
  LagVariance LateActuator LateLag Checker CheckerPolynomial CheckerFriction CheckerFilter CheckerOnePole
  CheckerActuator.
Open Scope Q_scope.

(** The first n + 1 terms of exp (-p/q): their sum, the last one, and the denominator of both. *)
Fixpoint partial_sum (p : Z) (q : BinNums.positive) (n : nat) : Z * Z * Z :=
  match n with
  | O => (1, 1, 1)%Z
  | S before => let '(sum, term, d) := partial_sum p q before in
                let m := (Zpos q * Z.of_nat n)%Z in
                let term := (- (term * p))%Z in (sum * m + term, term, d * m)%Z
  end.

(** a/d from below and from above, 0 <= a and 0 < d, with fewer digits of both. *)
Definition digits : Z := 100.
Definition dropped (a : Z) : Z := Z.max 0 (Z.log2 a - digits).
Definition shorter_below (a d : Z) : Q :=
  let s := dropped a in Z.shiftr a s # Z.to_pos (Z.shiftr d s + 1).
Definition shorter_above (a d : Z) : Q :=
  let s := dropped a in Z.shiftr a s + 1 # Z.to_pos (Z.shiftr d s).

(** exp (-x) is between the two for x >= 0, however many terms; so many make them close. *)
Definition terms (x : Q) : nat := (15 + 2 * Z.to_nat (Qceiling x))%nat.

Definition exp_below (x : Q) : Q :=
  let '(sum, _, d) := partial_sum (Qnum x) (Qden x) (S (2 * terms x)) in
  if (sum <? 0)%Z then 0 else shorter_below sum d.

Definition exp_above (x : Q) : Q :=
  let '(sum, _, d) := partial_sum (Qnum x) (Qden x) (2 * terms x) in
  if (sum <=? d)%Z then shorter_above sum d else 1.

Section Check.

Variables (l : loop) (c : list Q) (k : nat) (f time_constant : Q).

Definition q_theta : Q := Qred (time_constant / l_T l).
Definition q_rate : Q := Qred (l_T l / time_constant).
Definition q_power_rate : Q := Qred ((1 - f) * q_rate).

(** The variance, from bounds of exp (-1/theta) and of exp (-(1 - f)/theta). *)
Definition q_variance (decay_of_lag decay_in_common power : Q) : Q :=
  f * (1 - f) + (q_theta / 2 * ((1 + decay_of_lag) / (1 - decay_of_lag)) - q_theta * q_theta)
  + 2 * q_theta * ((power - decay_in_common) / (1 - decay_in_common) - f).

Definition lag_decides (beta : Q) : answer :=
  let low := exp_below q_rate in
  let high := exp_above q_rate in
  if Qle_bool 1 high then Untold
  else actuator_decides c (inject_Z (Z.of_nat k) + f + q_theta)
    (q_variance low high (exp_below q_power_rate)) (q_variance high low (exp_above q_power_rate)) beta.

(** The verdict on a loop under the controller c_0, c_1, ..., whose command arrives [k] + [f] samples
    late at an amplifier with a first-order lag. *)
Definition check_lag : outcome :=
  if Qle_bool 0 (hd 0 (tails c)) && Qle_bool 0 f && above_zero (1 - f) && above_zero time_constant then
    over_friction l (norm c / 2) lag_decides
  else Invalid.

End Check.

(** ** Soundness: the series *)

Open Scope R_scope.

Fixpoint taylor (n : nat) (y : R) : R :=
  match n with
  | O => 1
  | S before => taylor before y + (- y) ^ n / INR (fact n)
  end.

Lemma taylor_derivative : forall n y, is_derive (taylor (S n)) y (- taylor n y).
Proof.
  induction n as [| n IH]; intro y.
  - simpl. auto_derive; [exact I | field].
  - apply (is_derive_ext (fun z => taylor (S n) z + (- z) ^ S (S n) / INR (fact (S (S n))))).
    { intro z. reflexivity. }
    change (- taylor (S n) y) with (- (taylor n y + (- y) ^ S n / INR (fact (S n)))).
    rewrite Ropp_plus_distr. apply (is_derive_plus (taylor (S n))); [apply IH |].
    change (fact (S (S n))) with (S (S n) * fact (S n))%nat. rewrite mult_INR.
    assert (F : INR (fact (S n)) <> 0) by apply INR_fact_neq_0.
    assert (N : INR (S (S n)) <> 0) by (apply not_0_INR; lia).
    set (d := INR (fact (S n))) in *. set (m := INR (S (S n))) in *.
    apply (is_derive_ext (fun z => / (m * d) * (- z) ^ S (S n))); [intro z; over_R; unfold Rdiv; ring |].
    replace (- ((- y) ^ S n / d)) with (/ (m * d) * (- 1 * (m * (- y) ^ S n)))
      by (field; split; assumption).
    apply (is_derive_scal (fun z => (- z) ^ S (S n))).
    replace (- 1 * (m * (- y) ^ S n)) with (INR (S (S n)) * (- 1) * (- y) ^ pred (S (S n)))
      by (cbn [pred]; fold m; ring).
    apply (is_derive_pow Ropp). auto_derive; [exact I | ring].
Qed.

Lemma taylor_start : forall n, taylor n 0 = 1.
Proof. induction n as [| n IH]; [reflexivity |]. cbn [taylor]. rewrite IH, Ropp_0, pow_i by lia. field. apply INR_fact_neq_0. Qed.

(** Above exp (-y) and below it in turn. *)
Lemma taylor_side : forall n y, 0 <= y -> 0 <= (- 1) ^ n * (taylor n y - exp (- y)).
Proof.
  induction n as [| n IH]; intros y Hy.
  - simpl. assert (exp (- y) <= exp 0); [| rewrite exp_0 in *; lra].
    destruct Hy as [Hy | <-]; [apply Rlt_le, exp_increasing; lra | rewrite Ropp_0; lra].
  - apply (grows_from_zero (fun y => (- 1) ^ S n * (taylor (S n) y - exp (- y)))
      (fun y => (- 1) ^ n * (taylor n y - exp (- y)))); [| | exact IH | exact Hy].
    + rewrite taylor_start, Ropp_0, exp_0. ring.
    + intro x. replace ((- 1) ^ n * (taylor n x - exp (- x)))
        with ((- 1) ^ S n * (- taylor n x - - exp (- x))) by (simpl; ring).
      apply (is_derive_scal (fun y => taylor (S n) y - exp (- y))).
      apply (is_derive_minus (taylor (S n)) (fun y => exp (- y))); [apply taylor_derivative |].
      auto_derive; [exact I | ring].
Qed.

Lemma partial_sum_is : forall p q n, let '(sum, term, d) := partial_sum p q n in
  (0 < d)%Z /\ IZR sum = IZR d * taylor n (IZR p / IZR (Zpos q)) /\
  IZR term = IZR d * ((- (IZR p / IZR (Zpos q))) ^ n / INR (fact n)).
Proof.
  intros p q n. induction n as [| n IH]; [simpl; repeat split; try lia; field |].
  cbn [partial_sum]. destruct (partial_sum p q n) as [[sum term] d]. destruct IH as (D0 & Es & Et).
  assert (Q0 : IZR (Zpos q) <> 0) by (apply not_0_IZR; discriminate).
  assert (F : INR (fact n) <> 0) by apply INR_fact_neq_0.
  assert (N : INR (S n) <> 0) by (apply not_0_INR; lia).
  set (m := (Zpos q * Z.of_nat (S n))%Z).
  assert (Em : IZR m = IZR (Zpos q) * INR (S n)) by (unfold m; rewrite mult_IZR, <- INR_IZR_INZ; reflexivity).
  set (y := IZR p / IZR (Zpos q)) in *.
  assert (Ep : IZR p = y * IZR (Zpos q)) by (unfold y; field; exact Q0).
  assert (T : IZR (- (term * p)) = IZR (d * m) * ((- y) ^ S n / INR (fact (S n)))).
  { rewrite opp_IZR, !mult_IZR, Et, Em, Ep. change (fact (S n)) with (S n * fact n)%nat.
    rewrite mult_INR. simpl pow. field. split; assumption. }
  repeat split; [unfold m; nia | | exact T].
  rewrite plus_IZR, T, !mult_IZR, Es. cbn [taylor]. ring.
Qed.

Lemma quotient_is : forall a d, (0 < d)%Z -> Q2R (a # Z.to_pos d) = IZR a / IZR d.
Proof. intros a d D0. unfold Q2R. cbn [Qnum Qden]. rewrite Z2Pos.id by exact D0. reflexivity. Qed.

(** What is left of a number without its last digits. *)
Lemma shifted : forall a s, (0 <= s)%Z ->
  (0 < 2 ^ s)%Z /\ (2 ^ s * Z.shiftr a s <= a < 2 ^ s * (Z.shiftr a s + 1))%Z.
Proof.
  intros a s Hs. assert (P : (0 < 2 ^ s)%Z) by (apply Z.pow_pos_nonneg; lia).
  rewrite Z.shiftr_div_pow2 by exact Hs. split; [exact P |].
  split; [apply Z.mul_div_le, P | apply Z.mul_succ_div_gt, P].
Qed.

Lemma dropped_nonneg : forall a, (0 <= dropped a)%Z.
Proof. intro a. unfold dropped. lia. Qed.

Lemma quotients_compare : forall a b x y, 0 < b -> 0 < y -> a * y <= x * b -> a / b <= x / y.
Proof.
  intros a b x y B Y L. apply Rmult_le_reg_r with (b * y); [apply Rmult_lt_0_compat; assumption |].
  replace (a / b * (b * y)) with (a * y) by (field; lra).
  replace (x / y * (b * y)) with (x * b) by (field; lra). exact L.
Qed.

Lemma shorter_below_is : forall a d, (0 <= a)%Z -> (0 < d)%Z ->
  Q2R (shorter_below a d) <= IZR a / IZR d.
Proof.
  intros a d A0 D0. unfold shorter_below. set (s := dropped a).
  destruct (shifted a s (dropped_nonneg a)) as (P & La & _).
  destruct (shifted d s (dropped_nonneg a)) as (_ & _ & Ud).
  assert (D1 : (0 < Z.shiftr d s + 1)%Z) by nia.
  assert (A1 : (0 <= Z.shiftr a s)%Z) by (apply Z.shiftr_nonneg, A0).
  rewrite quotient_is by exact D1.
  apply quotients_compare; [apply IZR_lt, D1 | apply IZR_lt, D0 |]. rewrite <- !mult_IZR.
  apply IZR_le. nia.
Qed.

Lemma shorter_above_is : forall a d, (0 <= a <= d)%Z -> (0 < d)%Z ->
  IZR a / IZR d <= Q2R (shorter_above a d).
Proof.
  intros a d [A0 Le] D0. unfold shorter_above. set (s := dropped a).
  destruct (shifted a s (dropped_nonneg a)) as (P & _ & Ua).
  destruct (shifted d s (dropped_nonneg a)) as (_ & Ld & Ud).
  assert (D1 : (0 < Z.shiftr d s)%Z).
  { assert (Pd : (2 ^ s <= d)%Z).
    { unfold s, dropped. destruct (Z.max_spec 0 (Z.log2 a - digits)) as [[M ->] | [M ->]].
      - apply Z.le_trans with (2 ^ Z.log2 a)%Z; [apply Z.pow_le_mono_r; unfold digits in *; lia |].
        apply Z.le_trans with a; [| exact Le]. apply Z.log2_spec. unfold digits in M.
        destruct (Z.eq_dec a 0) as [-> | N]; [simpl in M; lia | lia].
      - simpl. lia. }
    nia. }
  rewrite quotient_is by exact D1.
  apply quotients_compare; [apply IZR_lt, D0 | apply IZR_lt, D1 |]. rewrite <- !mult_IZR.
  apply IZR_le. nia.
Qed.

Lemma exp_between : forall x, 0 <= Q2R x -> Q2R (exp_below x) <= exp (- Q2R x) <= Q2R (exp_above x).
Proof.
  intros x Hx. unfold exp_below, exp_above.
  assert (E : (- 1) ^ (2 * terms x) = 1)
    by (rewrite pow_mult; replace ((- 1) ^ 2) with 1 by ring; apply pow1).
  pose proof (taylor_side (2 * terms x) (Q2R x) Hx) as A.
  pose proof (taylor_side (S (2 * terms x)) (Q2R x) Hx) as B.
  rewrite <- tech_pow_Rmult in B. rewrite E in *. pose proof (exp_pos (- Q2R x)) as X0.
  pose proof (partial_sum_is (Qnum x) (Qden x) (2 * terms x)) as SA.
  pose proof (partial_sum_is (Qnum x) (Qden x) (S (2 * terms x))) as SB.
  change (IZR (Qnum x) / IZR (Zpos (Qden x))) with (Q2R x) in *.
  destruct (partial_sum _ _ (2 * terms x)) as [[sa ta] da].
  destruct (partial_sum _ _ (S (2 * terms x))) as [[sb tb] db].
  destruct SA as (DA & EA & _). destruct SB as (DB & EB & _).
  assert (RA : IZR sa / IZR da = taylor (2 * terms x) (Q2R x))
    by (rewrite EA; field; apply not_0_IZR; lia).
  assert (RB : IZR sb / IZR db = taylor (S (2 * terms x)) (Q2R x))
    by (rewrite EB; field; apply not_0_IZR; lia).
  split.
  - destruct (Z.ltb_spec sb 0) as [N | N]; [rewrite Q2R_0; lra |].
    pose proof (shorter_below_is sb db N DB). lra.
  - destruct (Z.leb_spec sa da) as [N | N].
    + assert (S0 : (0 <= sa)%Z).
      { apply le_IZR. rewrite EA. apply Rmult_le_pos; [apply IZR_le; lia | lra]. }
      pose proof (shorter_above_is sa da (conj S0 N) DA). lra.
    + rewrite Q2R_one. apply Rle_trans with (exp 0); [| rewrite exp_0; lra].
      destruct (Req_dec (Q2R x) 0) as [-> | Nx]; [rewrite Ropp_0; lra |].
      apply Rlt_le, exp_increasing. lra.
Qed.

(** ** Soundness: the verdict *)

Section Lag.

Variables (l : loop) (c : list Q) (k : nat) (f time_constant : Q).
Let n := length c.
Let g := tail (coefficient c) n.
Let theta := Q2R time_constant / Q2R (l_T l).
Let mean := late_lag_mean k (Q2R f) theta.
Let Var := late_lag_variance (Q2R f) theta.
Let enough := kappa_enough mean Var.
Let nu := response_norm (coefficient c) n / 2.

Lemma check_lag_is : forall v, check_lag l c k f time_constant = Says v ->
  over_friction l (norm c / 2) (lag_decides l c k f time_constant) = Says v /\
  loop_valid l = true /\ 0 <= g 0%nat /\ 0 <= Q2R f < 1 /\ 0 < theta.
Proof.
  intros v H. unfold check_lag in H. destruct (_ && _ && _ && _) eqn:S; [| discriminate].
  rewrite !andb_true_iff in S. destruct S as [[[S F0] F1] A].
  apply le_bool in S, F0. rewrite Q2R_0 in *. rewrite at_one_is in S.
  apply above_zero_is in F1, A. rewrite Q2R_minus, Q2R_one in F1.
  pose proof (outcome_valid _ _ _ _ H) as Ok. destruct (loop_valid_is l Ok) as (_ & _ & HT & _).
  repeat split; try assumption; [lra |]. apply Rdiv_lt_0_compat; assumption.
Qed.

Hypothesis f_between : 0 <= Q2R f < 1.
Hypothesis theta_positive : 0 < theta.
Hypothesis T_positive : 0 < Q2R (l_T l).

Lemma theta_is : Q2R (q_theta l time_constant) = theta.
Proof. unfold q_theta, theta. rewrite Qred_is, Q2R_quotient. reflexivity. Qed.

Lemma rate_is : Q2R (q_rate l time_constant) = / theta.
Proof.
  unfold q_rate. rewrite Qred_is, Q2R_quotient. unfold theta in *.
  assert (Q2R time_constant <> 0).
  { intro Z. rewrite Z in theta_positive. unfold Rdiv in theta_positive. lra. }
  field. split; lra.
Qed.

Lemma decay_bounds :
  Q2R (exp_below (q_rate l time_constant)) <= lag_decay theta <= Q2R (exp_above (q_rate l time_constant)).
Proof.
  pose proof (Rinv_0_lt_compat _ theta_positive) as P.
  pose proof (exp_between (q_rate l time_constant)) as B. rewrite rate_is in B.
  unfold lag_decay. replace (- 1 / theta) with (- / theta) by (field; lra). apply B. lra.
Qed.

Lemma power_bounds :
  Q2R (exp_below (q_power_rate l f time_constant)) <= late_power (Q2R f) theta 1
  <= Q2R (exp_above (q_power_rate l f time_constant)).
Proof.
  pose proof (Rinv_0_lt_compat _ theta_positive) as P.
  pose proof (exp_between (q_power_rate l f time_constant)) as B.
  assert (E : Q2R (q_power_rate l f time_constant) = (1 - Q2R f) * / theta)
    by (unfold q_power_rate; rewrite Qred_is, Q2R_mult, Q2R_minus, Q2R_one, rate_is; reflexivity).
  rewrite E in B. unfold late_power.
  replace (- (1 - Q2R f) / theta) with (- ((1 - Q2R f) * / theta)) by (field; lra).
  apply B. apply Rmult_le_pos; lra.
Qed.

Lemma variance_is : forall a b p, Q2R (q_variance l f time_constant a b p)
  = Q2R f * (1 - Q2R f) + (theta / 2 * ((1 + Q2R a) / (1 - Q2R a)) - theta * theta)
    + 2 * theta * ((Q2R p - Q2R b) / (1 - Q2R b) - Q2R f).
Proof.
  intros. unfold q_variance.
  rewrite !Q2R_plus, Q2R_minus, !Q2R_mult, Q2R_minus, !Q2R_quotient, !Q2R_minus, Q2R_quotient, Q2R_plus,
    !Q2R_minus, Q2R_one, Q2R_two, theta_is. reflexivity.
Qed.

(** More of the decay makes the lag's part larger, and what the latency takes away too. *)
Lemma lag_part_grows : forall x y, x <= y < 1 -> (1 + x) / (1 - x) <= (1 + y) / (1 - y).
Proof.
  intros x y H. replace ((1 + x) / (1 - x)) with (2 / (1 - x) - 1) by (field; lra).
  replace ((1 + y) / (1 - y)) with (2 / (1 - y) - 1) by (field; lra).
  assert (/ (1 - x) <= / (1 - y)) by (apply Rinv_le_contravar; lra). unfold Rdiv. lra.
Qed.

Lemma common_part_falls : forall p x y, p <= 1 -> x <= y < 1 -> (p - y) / (1 - y) <= (p - x) / (1 - x).
Proof.
  intros p x y P H. replace ((p - x) / (1 - x)) with (1 - (1 - p) * / (1 - x)) by (field; lra).
  replace ((p - y) / (1 - y)) with (1 - (1 - p) * / (1 - y)) by (field; lra).
  assert (/ (1 - x) <= / (1 - y)) by (apply Rinv_le_contravar; lra). nra.
Qed.

Lemma variance_between : forall low high p0 p1, Q2R high < 1 ->
  Q2R low <= lag_decay theta <= Q2R high -> Q2R p0 <= late_power (Q2R f) theta 1 <= Q2R p1 ->
  Q2R (q_variance l f time_constant low high p0) <= Var
  <= Q2R (q_variance l f time_constant high low p1).
Proof.
  intros low high p0 p1 H1 [D0 D1] [Q0 Q1]. rewrite !variance_is.
  assert (P1 : late_power (Q2R f) theta 1 <= 1).
  { apply Rle_trans with (exp 0); [| rewrite exp_0; lra]. apply Rlt_le, exp_increasing.
    assert (0 < (1 - Q2R f) * / theta)
      by (apply Rmult_lt_0_compat; [apply Rlt_Rminus, f_between | apply Rinv_0_lt_compat, theta_positive]).
    unfold Rdiv. lra. }
  unfold Var, late_lag_variance, lag_variance, latency_variance.
  set (e := lag_decay theta) in *. set (a := late_power (Q2R f) theta 1) in *.
  pose proof (lag_part_grows (Q2R low) e ltac:(split; lra)) as L0.
  pose proof (lag_part_grows e (Q2R high) ltac:(split; lra)) as L1.
  pose proof (common_part_falls a e (Q2R high) P1 ltac:(split; lra)) as C0.
  pose proof (common_part_falls a (Q2R low) e P1 ltac:(split; lra)) as C1.
  assert (M0 : (Q2R p0 - Q2R high) / (1 - Q2R high) <= (a - Q2R high) / (1 - Q2R high))
    by (apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat |]; lra).
  assert (M1 : (a - Q2R low) / (1 - Q2R low) <= (Q2R p1 - Q2R low) / (1 - Q2R low))
    by (apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat |]; lra).
  split; nra.
Qed.

Lemma lag_mean_is : Q2R (inject_Z (Z.of_nat k) + f + q_theta l time_constant) = mean.
Proof.
  rewrite !Q2R_plus, theta_is. unfold mean, late_lag_mean. do 2 f_equal.
  unfold Q2R. simpl. rewrite INR_IZR_INZ. field.
Qed.

Lemma lag_mean_nonneg : 0 <= Q2R (inject_Z (Z.of_nat k) + f + q_theta l time_constant).
Proof. rewrite lag_mean_is. unfold mean, late_lag_mean. pose proof (pos_INR k). lra. Qed.

Hypothesis sum_nonneg : 0 <= g 0%nat.

Lemma lag_told : forall beta, lag_decides l c k f time_constant beta <> Untold ->
  exists least most, Q2R least <= Var <= Q2R most /\
  lag_decides l c k f time_constant beta
  = actuator_decides c (inject_Z (Z.of_nat k) + f + q_theta l time_constant) least most beta.
Proof.
  intros beta N. unfold lag_decides in *. destruct (Qle_bool 1 _) eqn:H; [tauto |].
  do 2 eexists. split; [| reflexivity]. apply variance_between; [| apply decay_bounds | apply power_bounds].
  apply Rnot_le_lt. intro L. rewrite <- Q2R_one in L. apply le_bool in L. congruence.
Qed.

Lemma lag_enough : forall beta, lag_decides l c k f time_constant beta = Enough ->
  asked_at_most c mean Var (Q2R beta).
Proof.
  intros beta E. destruct (lag_told beta) as (least & most & B & Eq); [congruence |].
  rewrite Eq in E. rewrite <- lag_mean_is.
  refine (actuator_enough c _ least most Var lag_mean_nonneg _ B sum_nonneg beta E).
  apply (TH_LAG_latency_variance (Q2R f) theta); assumption.
Qed.

Lemma lag_short : forall beta, lag_decides l c k f time_constant beta = Short ->
  ~ asked_at_most c mean Var (Q2R beta).
Proof.
  intros beta E. destruct (lag_told beta) as (least & most & B & Eq); [congruence |].
  rewrite Eq in E. rewrite <- lag_mean_is.
  exact (actuator_short c _ least most Var lag_mean_nonneg B sum_nonneg beta E).
Qed.

End Lag.

Section Verdict.

Variables (l : loop) (c : list Q) (k : nat) (f time_constant : Q).
Let n := length c.
Let theta := Q2R time_constant / Q2R (l_T l).
Let enough := kappa_enough (late_lag_mean k (Q2R f) theta) (late_lag_variance (Q2R f) theta).
Let nu := response_norm (coefficient c) n / 2.

(** CHECK (lag, holds): some kappa is enough with which the criterion holds. *)
Theorem CHECK_lag_holds : check_lag l c k f time_constant = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  exists kappa, enough kappa /\ meets l nu rb rc (actuator_asks c kappa).
Proof.
  intros H rb rc I. destruct (check_lag_is _ _ _ _ _ _ H) as (O & Ok & G & F & Th).
  destruct (loop_valid_is l Ok) as (_ & _ & HT & _). unfold nu, n. rewrite <- half_norm.
  destruct (over_friction_holds l _ _ _ (lag_enough l c k f time_constant F Th HT G) Ok O rb rc I)
    as (lambda & (kappa & E & A) & M).
  exists kappa. split; [exact E |]. exact (meets_less l Ok _ rb rc _ lambda A M).
Qed.

(** CHECK (lag, fails): at no friction within its tolerances does it hold with a kappa that is
    enough. *)
Theorem CHECK_lag_fails : check_lag l c k f time_constant = Says Fails ->
  forall rb rc, friction_in l rb rc ->
  forall kappa, enough kappa -> ~ meets l nu rb rc (actuator_asks c kappa).
Proof.
  intros H rb rc I kappa E. destruct (check_lag_is _ _ _ _ _ _ H) as (O & Ok & G & F & Th).
  destruct (loop_valid_is l Ok) as (_ & _ & HT & _). unfold nu, n. rewrite <- half_norm.
  apply (over_friction_fails l _ _ _ (asked_more c _ _) (lag_short l c k f time_constant F Th HT G) Ok O
    rb rc I).
  exists kappa. split; [exact E | apply Rle_refl].
Qed.

(** CHECK (lag, motion): where the verdict is Holds, every motion after rest is passive at the speeds
    asked for, one-sided and saturated or not. *)
Theorem CHECK_lag_motion : check_lag l c k f time_constant = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  forall u mu pos vel friction hand force past one_sided step limit, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  let at_one := tail (coefficient c) n 0 in
  physical mu beta sigma -> step_positive step -> limit_nonneg limit ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  (forall j, past j = pos 0) ->
  obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t) ->
  actuates (late_lag k (Q2R f) theta)
    (held_by_gated pos past (coefficient c) n 0 one_sided step limit (measuring l)) force ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + scaled_potential at_one one_sided limit (pos 0))
    (Definitions.kinetic mu (vel t) + scaled_potential at_one one_sided limit (pos t)) t.
Proof.
  intros H rb rc I u mu pos vel friction hand force past one_sided step limit Hu beta sigma at_one
    P S Hl Es Rest O A t Ht Slow.
  destruct (check_lag_is _ _ _ _ _ _ H) as (_ & Ok & G & F & Th).
  destruct (CHECK_lag_holds H rb rc I) as (kappa & [E1 E2] & M).
  apply (TH_LAG_latency mu beta sigma kappa pos vel friction hand force past (coefficient c) n
    k (Q2R f) theta one_sided step limit (measuring l) (measuring_error l) P F Th S Hl (measuring_off l)
    (measuring_side l) G E1 E2 Rest O A t Ht).
  apply (meets_motion l Ok _ rb rc _ M u); [exact Hu | unfold nu; field | exact Es | exact Slow].
Qed.

End Verdict.
