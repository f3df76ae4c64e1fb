(** * CheckerActuator: loops whose force arrives late within an interval, a latency among them.

    Such a force costs H(1) kappa + |g_1| + |g_2| + ... (TH-LATENCY, TH-LAG); kappa is decided by two
    squares from the mean and the variance of what is late, without a root.  The variance may be known
    between two numbers only. *)

From Coq Require Import Reals QArith Qreals Qabs Lra Lia Psatz List Bool RMicromega.
From Passivity Require Definitions.
From Passivity Require Import Model History Laws Effects Controller FiniteResponse GatedController ActuatorCost
  Latency LatencyController Checker CheckerPolynomial CheckerFriction CheckerFilter.
Import ListNotations.
Open Scope Q_scope.

Definition kappa_at_most (mean variance kappa : Q) : bool :=
  let over := kappa - half - mean in
  Qle_bool 0 over && Qle_bool 0 (4 * kappa * over - variance).

(** Whether [beta] is enough, the variance being from [least] to [most]. *)
Definition actuator_decides (c : list Q) (mean least most beta : Q) : answer :=
  let at_one := hd 0 (tails c) in
  let rest := beta - norm (tl (tails c)) in
  if Qle_bool at_one 0 then if Qle_bool 0 rest then Enough else Short
  else if kappa_at_most mean most (rest / at_one) then Enough
  else if kappa_at_most mean least (rest / at_one) then Untold else Short.

(** The verdict on a loop under the controller c_0, c_1, ..., whose force arrives [k] + [f] samples
    late. *)
Definition check_latency (l : loop) (c : list Q) (k : nat) (f : Q) : outcome :=
  let variance := f * (1 - f) in
  if Qle_bool 0 (hd 0 (tails c)) && above_zero f && above_zero (1 - f) then
    over_friction l (norm c / 2)
      (actuator_decides c (inject_Z (Z.of_nat k) + f) variance variance)
  else Invalid.

(** ** Soundness *)

Open Scope R_scope.

Lemma kappa_at_most_is : forall mean variance kappa, kappa_at_most mean variance kappa = true <->
  0 <= spare_mean (Q2R kappa) (Q2R mean) /\
  0 <= spare_square (Q2R kappa) (Q2R mean) (Q2R variance).
Proof.
  intros. unfold kappa_at_most, spare_mean, spare_square.
  rewrite andb_true_iff, !le_bool, !Q2R_minus, !Q2R_mult, !Q2R_minus, Q2R_half, Q2R_0.
  replace (Q2R 4) with 4 by (unfold Q2R; simpl; field).
  replace (Q2R kappa - 1 / 2 - Q2R mean) with (Q2R kappa - (1 / 2) - Q2R mean) by ring. tauto.
Qed.

Lemma norm_sum : forall l N, (length l <= N)%nat ->
  Q2R (norm l) = Definitions.sum_to N (fun i => Rabs (Q2R (nth (pred i) l 0%Q))).
Proof.
  induction l as [| q l IH]; intros N HN.
  - symmetry. simpl. rewrite Q2R_0. apply sum_to_zero. intros i _.
    destruct (pred i); rewrite Q2R_0, Rabs_R0; reflexivity.
  - destruct N as [| N]; [simpl in HN; lia |]. rewrite sum_to_first. cbn [norm].
    simpl in HN. rewrite Qred_is, Q2R_plus, Q2R_abs, (IH N) by lia. f_equal.
    apply sum_to_ext. intros [| i] Hi; [lia | reflexivity].
Qed.

Section Actuator.

Variable c : list Q.
Let n := length c.
Let g := tail (coefficient c) n.

Lemma tails_norm_is : Q2R (norm (tl (tails c))) = tails_norm g n.
Proof.
  unfold n. rewrite (norm_sum _ (length c)).
  - apply sum_to_ext. intros [| i] Hi; [lia |]. unfold g, n. rewrite <- tails_are. simpl pred.
    destruct (tails c); simpl; [destruct i |]; reflexivity.
  - assert (L : length (tails c) = length c)
      by (clear; induction c as [| a d IH]; [reflexivity | simpl; rewrite IH; reflexivity]).
    rewrite <- L. destruct (tails c); simpl; lia.
Qed.

(** [kappa] is enough for what is [mean] late with the variance [Var] (TH_LAG_kappa_squares). *)
Definition kappa_enough (mean Var kappa : R) : Prop :=
  0 <= spare_mean kappa mean /\ 0 <= spare_square kappa mean Var.

(** What is asked of viscous friction with it. *)
Definition actuator_asks (kappa : R) : R := g 0%nat * kappa + tails_norm g n.

Definition asked_at_most (mean Var lambda : R) : Prop :=
  exists kappa, kappa_enough mean Var kappa /\ actuator_asks kappa <= lambda.

Lemma asked_more : forall mean Var x y, x <= y -> asked_at_most mean Var x -> asked_at_most mean Var y.
Proof. intros mean Var x y L (kappa & E & A). exists kappa. split; [exact E | lra]. Qed.

Section Kappa.

Variables (mean least most : Q) (Var : R).
Hypothesis mean_nonneg : 0 <= Q2R mean.
Hypothesis Var_nonneg : 0 <= Var.
Hypothesis between : Q2R least <= Var <= Q2R most.
Hypothesis sum_nonneg : 0 <= g 0%nat.

Lemma rest_is : forall beta,
  Q2R (beta - norm (tl (tails c))) = Q2R beta - tails_norm g n.
Proof. intro beta. rewrite Q2R_minus, tails_norm_is. reflexivity. Qed.

Lemma actuator_enough : forall beta, actuator_decides c mean least most beta = Enough ->
  asked_at_most (Q2R mean) Var (Q2R beta).
Proof.
  intros beta E. unfold actuator_decides in E. set (rest := (beta - norm (tl (tails c)))%Q) in *.
  pose proof (rest_is beta) as Rs. fold rest in Rs. pose proof (at_one_is c) as G. fold n g in G.
  destruct (Qle_bool (hd 0%Q (tails c)) 0) eqn:Z.
  - apply le_bool in Z. rewrite Q2R_0, G in Z.
    destruct (Qle_bool 0 rest) eqn:S; [| discriminate]. apply le_bool in S. rewrite Q2R_0 in S.
    exists (1 / 2 + Q2R mean + Var). unfold kappa_enough, spare_mean, spare_square, actuator_asks.
    replace (g 0%nat) with 0 by lra. split; [split |]; nra.
  - assert (H0 : 0 < g 0%nat).
    { apply Rnot_le_lt. intro N. rewrite <- G, <- Q2R_0 in N. apply le_bool in N. congruence. }
    destruct (kappa_at_most mean most (rest / hd 0%Q (tails c))) eqn:K;
      [| destruct (kappa_at_most mean least (rest / hd 0%Q (tails c))); discriminate].
    apply kappa_at_most_is in K. rewrite Q2R_quotient, G in K.
    exists (Q2R rest / g 0%nat). split.
    + unfold kappa_enough, spare_square in *. split; [apply K | lra].
    + unfold actuator_asks. replace (g 0%nat * (Q2R rest / g 0%nat)) with (Q2R rest) by (field; lra). lra.
Qed.

Lemma actuator_short : forall beta, actuator_decides c mean least most beta = Short ->
  ~ asked_at_most (Q2R mean) Var (Q2R beta).
Proof.
  intros beta E (kappa & [K1 K2] & A). unfold actuator_decides in E. unfold actuator_asks in A.
  set (rest := (beta - norm (tl (tails c)))%Q) in *.
  pose proof (rest_is beta) as Rs. fold rest in Rs. pose proof (at_one_is c) as G. fold n g in G.
  destruct (Qle_bool (hd 0%Q (tails c)) 0) eqn:Z.
  - apply le_bool in Z. rewrite Q2R_0, G in Z.
    destruct (Qle_bool 0 rest) eqn:S; [discriminate |].
    assert (N : Qle_bool 0 rest = true); [| congruence].
    apply le_bool. rewrite Q2R_0. replace (g 0%nat) with 0 in A by lra. lra.
  - assert (H0 : 0 < g 0%nat).
    { apply Rnot_le_lt. intro N. rewrite <- G, <- Q2R_0 in N. apply le_bool in N. congruence. }
    destruct (kappa_at_most mean most (rest / hd 0%Q (tails c))); [discriminate |].
    destruct (kappa_at_most mean least (rest / hd 0%Q (tails c))) eqn:K; [discriminate |].
    assert (N : kappa_at_most mean least (rest / hd 0%Q (tails c)) = true); [| congruence].
    apply kappa_at_most_is. rewrite Q2R_quotient, G.
    apply (spare_monotone kappa); [exact mean_nonneg | | exact K1 | unfold spare_square in *; lra].
    apply Rmult_le_reg_l with (g 0%nat); [exact H0 |].
    replace (g 0%nat * (Q2R rest / g 0%nat)) with (Q2R rest) by (field; lra). lra.
Qed.

End Kappa.

(** ** Latency *)

Section Latency.

Variables (l : loop) (k : nat) (f : Q).

Let mean := INR k + Q2R f.
Let enough := kappa_enough mean (latency_variance (Q2R f)).
Let nu := response_norm (coefficient c) n / 2.

Lemma check_latency_is : forall v, check_latency l c k f = Says v ->
  over_friction l (norm c / 2) (actuator_decides c (inject_Z (Z.of_nat k) + f)
    (f * (1 - f)) (f * (1 - f))) = Says v /\
  loop_valid l = true /\ 0 <= g 0%nat /\ 0 < Q2R f < 1.
Proof.
  intros v H. unfold check_latency in H. destruct (_ && _ && _) eqn:S; [| discriminate].
  rewrite !andb_true_iff in S. destruct S as [[S F0] F1].
  apply le_bool in S. rewrite Q2R_0, at_one_is in S. apply above_zero_is in F0, F1.
  rewrite Q2R_minus in F1. replace (Q2R 1) with 1 in F1 by (unfold Q2R; simpl; field).
  repeat split; [exact H | exact (outcome_valid _ _ _ _ H) | exact S | exact F0 | lra].
Qed.

Lemma late_mean : Q2R (inject_Z (Z.of_nat k) + f) = mean.
Proof. rewrite Q2R_plus. unfold mean. f_equal. unfold Q2R. simpl. rewrite INR_IZR_INZ. field. Qed.

Lemma late_variance : Q2R (f * (1 - f)) = latency_variance (Q2R f).
Proof.
  rewrite Q2R_mult, Q2R_minus. unfold latency_variance. f_equal. f_equal. unfold Q2R. simpl. field.
Qed.

(** What the two lemmas about [actuator_decides] ask. *)
Lemma late_numbers : 0 < Q2R f < 1 -> 0 <= Q2R (inject_Z (Z.of_nat k) + f) /\
  0 <= latency_variance (Q2R f) /\
  Q2R (f * (1 - f)) <= latency_variance (Q2R f) <= Q2R (f * (1 - f)).
Proof.
  intro F. rewrite late_mean, late_variance. unfold mean, latency_variance.
  pose proof (pos_INR k). repeat split; nra.
Qed.

(** CHECK (latency, holds): some kappa is enough with which the criterion holds. *)
Theorem CHECK_latency_holds : check_latency l c k f = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  exists kappa, enough kappa /\ meets l nu rb rc (actuator_asks kappa).
Proof.
  intros H rb rc I. destruct (check_latency_is _ H) as (O & Ok & G & F).
  destruct (late_numbers F) as (M0 & V0 & V1). unfold nu. rewrite <- half_norm.
  destruct (over_friction_holds l _ _ _ (actuator_enough _ _ _ _ M0 V0 V1 G) Ok O rb rc I)
    as (lambda & (kappa & E & A) & M).
  rewrite late_mean in E. exists kappa. split; [exact E |].
  exact (meets_less l Ok _ rb rc _ lambda A M).
Qed.

(** CHECK (latency, fails): at no friction within its tolerances does it hold with a kappa that is
    enough. *)
Theorem CHECK_latency_fails : check_latency l c k f = Says Fails ->
  forall rb rc, friction_in l rb rc ->
  forall kappa, enough kappa -> ~ meets l nu rb rc (actuator_asks kappa).
Proof.
  intros H rb rc I kappa E. destruct (check_latency_is _ H) as (O & Ok & G & F).
  destruct (late_numbers F) as (M0 & V0 & V1). unfold nu. rewrite <- half_norm.
  apply (over_friction_fails l _ _ _ (asked_more _ _) (actuator_short _ _ _ _ M0 V1 G) Ok O rb rc I).
  exists kappa. rewrite late_mean. split; [exact E | apply Rle_refl].
Qed.

(** CHECK (latency, motion): where the verdict is Holds, every motion after rest is passive at the
    speeds asked for, one-sided and saturated or not. *)
Theorem CHECK_latency_motion : check_latency l c k f = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  forall u mu pos vel friction hand force past one_sided step limit, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  physical mu beta sigma -> step_positive step -> limit_nonneg limit ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  (forall j, past j = pos 0) ->
  obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t) ->
  acts_late k (Q2R f) (held_by_gated pos past (coefficient c) n 0 one_sided step limit (measuring l))
    force ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + scaled_potential (g 0%nat) one_sided limit (pos 0))
    (Definitions.kinetic mu (vel t) + scaled_potential (g 0%nat) one_sided limit (pos t)) t.
Proof.
  intros H rb rc I u mu pos vel friction hand force past one_sided step limit Hu beta sigma
    P S Hl Es Rest O A t Ht Slow.
  destruct (check_latency_is _ H) as (_ & Ok & G & F).
  destruct (CHECK_latency_holds H rb rc I) as (kappa & [E1 E2] & M).
  apply (TH_LATENCY_controller mu beta sigma kappa pos vel friction hand force past (coefficient c) n
    k (Q2R f) one_sided step limit (measuring l) (measuring_error l) P F S Hl (measuring_off l)
    (measuring_side l) G E1 E2 Rest O A t Ht).
  apply (meets_motion l Ok _ rb rc _ M u); [exact Hu | unfold nu; field | exact Es | exact Slow].
Qed.

End Latency.

End Actuator.

(** CHECK (latency, motion of the wall): the same for the wall alone, whatever the motion was before
    the start. *)
Theorem CHECK_latency_motion_wall : forall l k f, check_latency l [1%Q] k f = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  exists kappa, kappa_enough (INR k + Q2R f) (latency_variance (Q2R f)) kappa /\
  forall u mu pos vel friction hand past step, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  physical mu beta sigma -> step_positive step ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  obeys mu beta sigma (output_time (Q2R f)) (held_late pos past k step (measuring l))
    pos vel friction hand ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.storage mu (pos 0) (vel 0) + latency_extra pos past (Q2R f) k kappa)
    (Definitions.storage mu (pos t) (vel t)) t.
Proof.
  intros l k f H rb rc I. destruct (check_latency_is _ _ _ _ _ H) as (_ & Ok & _ & F).
  destruct (CHECK_latency_holds _ _ _ _ H rb rc I) as (kappa & E & M).
  assert (One : Q2R 1 = 1) by (unfold Q2R; simpl; field).
  assert (Asks : actuator_asks [1%Q] kappa = kappa).
  { unfold actuator_asks, tails_norm, tail, coefficient. simpl. rewrite One, Q2R_0, Rabs_R0. ring. }
  assert (Nu : response_norm (coefficient [1%Q]) 1 = 1).
  { unfold response_norm, coefficient. simpl. rewrite One, Q2R_0, Rabs_R0, Rabs_R1. ring. }
  cbn [length] in M. rewrite Asks, Nu in M. exists kappa. split; [exact E |].
  intros u mu pos vel friction hand past step Hu beta sigma P S Es O t Ht Slow.
  apply (TH_LATENCY mu beta sigma pos vel friction hand past (Q2R f) k kappa step (measuring l)
    (measuring_error l) P F S (measuring_off l) (proj1 E) (proj2 E) O t Ht).
  apply (meets_motion l Ok _ rb rc _ M u); [exact Hu | field | exact Es | exact Slow].
Qed.
