(** * InfiniteResponse: TH-LTI for a response c_0, c_1, ... that never ends (IIR).

    The device had rested until [m] samples before the start, so that what is held is a finite
    sum and a multiple of the oldest position; the response need only be absolutely summable, and
    so must its tails be for the cost at each frequency to exist. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller Angles ChargedRun LinearController FiniteResponse.
Open Scope R_scope.

(** g_j = c_j + c_(j+1) + ... *)
Definition infinite_tail (c : nat -> R) (j : nat) : R := Series (fun i => c (j + i)%nat).

(** The cost at one frequency. *)
Definition infinite_symbol (c : nat -> R) (theta : R) : R :=
  infinite_tail c 0 / 2 + Series (fun j => infinite_tail c (S j) * cos (INR (S j) * theta)).

Lemma infinite_tail_step : forall c j, ex_series c ->
  infinite_tail c j - infinite_tail c (S j) = c j.
Proof.
  intros c j E. unfold infinite_tail.
  rewrite (Series_incr_1 (fun i => c (j + i)%nat)).
  - rewrite Nat.add_0_r. rewrite (Series_ext (fun k => c (j + S k)%nat) (fun i => c (S j + i)%nat))
      by (intro i; f_equal; lia). ring.
  - apply (ex_series_incr_n c j) in E.
    apply ex_series_ext with (2 := E). intro i. f_equal.
Qed.

(** A sum to n as a sum from 0. *)
Lemma sum_to_series : forall n f, sum_to (S n) f = sum_n (fun j => f (S j)) n.
Proof.
  intros n f. induction n as [| n IH].
  - rewrite sum_O. simpl. ring.
  - rewrite sum_Sn, <- IH, sum_to_S. reflexivity.
Qed.

(** If the tails are absolutely summable and the cost is at most lambda at every frequency,
    truncations exceed lambda by as little as one likes, at all frequencies alike. *)
Theorem TH_LTI_symbol_limit : forall c lambda,
  ex_series (fun j => Rabs (infinite_tail c (S j))) ->
  (forall theta, infinite_symbol c theta <= lambda) ->
  symbol_at_most (infinite_tail c 0) (infinite_tail c) lambda.
Proof.
  intros c lambda A B eps n He. set (g := infinite_tail c) in *.
  assert (Cauchy : exists M, forall k, (M <= k)%nat ->
    Series (fun j => Rabs (g (S (S k + j)))) <= eps).
  { pose proof (Series_correct _ A) as L.
    apply is_series_Reals in L. destruct (L eps He) as (M & HM). exists M. intros k Hk.
    specialize (HM k Hk).
    rewrite (Series_incr_n (fun j => Rabs (g (S j))) (S k)) in HM by (try lia; exact A).
    unfold R_dist in HM. simpl pred in HM.
    match type of HM with Rabs (?a - (?a + ?b)) < _ =>
      replace (a - (a + b)) with (- b) in HM by ring; rewrite Rabs_Ropp in HM;
      apply Rle_trans with (2 := Rlt_le _ _ HM); apply Rle_abs end. }
  destruct Cauchy as (M & HM). exists (S (n + M)). split; [lia |]. intro theta.
  specialize (B theta). unfold infinite_symbol in B. fold g in B. unfold symbol.
  set (t := fun j => g (S j) * cos (INR (S j) * theta)) in *.
  assert (Bound : forall j, Rabs (t j) <= Rabs (g (S j))).
  { intro j. unfold t. rewrite Rabs_mult. pose proof (COS_bound (INR (S j) * theta)) as C.
    pose proof (Rabs_pos (g (S j))).
    assert (Rabs (cos (INR (S j) * theta)) <= 1) by (apply Rabs_le; exact C). nra. }
  assert (At : ex_series (fun j => Rabs (t j))).
  { apply (ex_series_le (K := R_AbsRing) (V := R_CompleteNormedModule) _ (fun j => Rabs (g (S j)))).
    - intro j. change (Rabs (Rabs (t j)) <= Rabs (g (S j))). rewrite Rabs_Rabsolu. apply Bound.
    - exact A. }
  rewrite sum_to_series. rewrite sum_n_Reals.
  rewrite (Series_incr_n t (S (n + M))) in B by (try lia; apply ex_series_Rabs, At).
  simpl pred in B.
  assert (Rest : - eps <= Series (fun k => t (S (n + M) + k)%nat)).
  { assert (Ar : ex_series (fun k => Rabs (t (S (n + M) + k)%nat)))
      by (apply (ex_series_incr_n (fun j => Rabs (t j))); exact At).
    pose proof (Series_Rabs _ Ar) as S1.
    assert (S2 : Series (fun k => Rabs (t (S (n + M) + k)%nat))
                 <= Series (fun j => Rabs (g (S (S (n + M) + j))))).
    { apply Series_le; [intro k; split; [apply Rabs_pos | apply Bound] |].
      apply (ex_series_incr_n (fun j => Rabs (g (S j)))). exact A. }
    specialize (HM (n + M)%nat ltac:(lia)).
    apply Rabs_le_between in S1. lra. }
  change (sum_f_R0 (fun j => g (S j) * cos (INR (S j) * theta)) (n + M))
    with (sum_f_R0 t (n + M)). fold g. lra.
Qed.

Section Iir.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (c : nat -> R) (m : nat) (lambda : R) (force_step : option R).
Variables (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
(** The response is absolutely summable, and so are its tails: a stable H(z). *)
Hypothesis summable : ex_series (fun j => Rabs (c j)).
Hypothesis tails_summable : ex_series (fun j => Rabs (infinite_tail c (S j))).
(** H(1) is not negative. *)
Hypothesis sum_nonneg : 0 <= infinite_tail c 0.
(** The cost at no frequency is more than lambda. *)
Hypothesis cost : forall theta, infinite_symbol c theta <= lambda.
(** The device had rested until [m] samples before the start. *)
Hypothesis rested : forall j, (m < j)%nat -> step INR pos past 0 j = 0.

(** The held force of the program: the whole convolution. *)
Definition held_by_response (h : nat) : R :=
  stepped force_step (- Series (fun j => c j * measure (sample INR pos past h j))).

Hypothesis O : obeys mu beta sigma INR held_by_response pos vel friction hand.

Let g := infinite_tail c.
Let H := g 0%nat.
Let norm := Series (fun j => Rabs (c j)).
Let V := spring_potential H.
Let viscous := beta - lambda.
Let coulomb := sigma - (e * norm + step_size force_step / 2).

Lemma response_summable : ex_series c.
Proof. apply ex_series_Rabs, summable. Qed.

(** Positions that do not change from the L-th on. *)
Lemma convolution_rested : forall x L, (forall j, (L < j)%nat -> x (pred j) - x j = 0) ->
  is_series (fun j => c j * x j) (linear_command H g L (x 0%nat) (fun j => x (pred j) - x j)).
Proof.
  intros x L Z.
  assert (Const : forall i, x (L + i)%nat = x L).
  { induction i as [| i IH]; [f_equal; lia |].
    specialize (Z (L + S i)%nat ltac:(lia)).
    replace (pred (L + S i)) with (L + i)%nat in Z by lia. lra. }
  assert (S1 : is_series (fun i => c (L + i)%nat * x (L + i)%nat) (g L * x L)).
  { apply is_series_ext with (fun i => c (L + i)%nat * x L).
    - intro i. rewrite Const. reflexivity.
    - assert (Q : is_series (fun i => c (L + i)%nat) (g L)).
      { apply Series_correct. apply (ex_series_incr_n c L), response_summable. }
      apply (is_series_scal (x L)) in Q. rewrite Rmult_comm.
      apply is_series_ext with (2 := Q). intro i. apply Rmult_comm. }
  destruct L as [| L].
  - unfold linear_command. simpl sum_to. rewrite Rminus_0_r. exact S1.
  - apply (is_series_decr_n (fun j => c j * x j) (S L)); [lia |]. simpl pred.
    rewrite sum_n_Reals.
    replace (plus _ _) with (g (S L) * x (S L)); [exact S1 |].
    change (g (S L) * x (S L)
            = linear_command H g (S L) (x 0%nat) (fun j => x (pred j) - x j)
              + - sum_f_R0 (fun j => c j * x j) L).
    rewrite (sum_eq _ (fun j => (g j - g (S j)) * x j))
      by (intros j _; unfold g; rewrite infinite_tail_step by exact response_summable; reflexivity).
    rewrite sum_by_parts. unfold linear_command. rewrite sum_to_S. simpl pred. unfold H. ring.
Qed.

Lemma response_commanded : forall h,
  Rabs (held_by_response h
        + linear_command H g (h + m) (pos (INR h)) (step INR pos past h))
  <= e * norm + step_size force_step / 2.
Proof.
  intro h. set (x := sample INR pos past h). set (q := fun j => measure (x j)).
  assert (X : is_series (fun j => c j * x j)
    (linear_command H g (h + m) (pos (INR h)) (step INR pos past h))).
  { rewrite <- (sample_now INR pos past h). apply convolution_rested.
    intros j Hj. apply (still_rested pos past m rested h j Hj). }
  assert (Xe : ex_series (fun j => c j * x j)) by (eexists; exact X).
  rewrite <- (is_series_unique _ _ X). unfold held_by_response. fold x.
  assert (E : forall j, Rabs (c j * (q j - x j)) <= Rabs (c j) * e).
  { intro j. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos | apply measure_error]. }
  assert (Es : ex_series (fun j => Rabs (c j) * e)) by (apply ex_series_scal_r, summable).
  assert (Ea : ex_series (fun j => Rabs (c j * (q j - x j)))).
  { apply (ex_series_le (K := R_AbsRing) (V := R_CompleteNormedModule) _ (fun j => Rabs (c j) * e)).
    - intro j. change (Rabs (Rabs (c j * (q j - x j))) <= Rabs (c j) * e).
      rewrite Rabs_Rabsolu. apply E.
    - exact Es. }
  assert (D : Series (fun j => c j * q j)
              = Series (fun j => c j * x j) + Series (fun j => c j * (q j - x j))).
  { rewrite <- Series_plus; [| exact Xe | apply ex_series_Rabs, Ea].
    apply Series_ext. intro j. ring. }
  assert (N : Rabs (Series (fun j => c j * (q j - x j))) <= e * norm).
  { eapply Rle_trans; [apply Series_Rabs, Ea |]. unfold norm. rewrite Rmult_comm, <- Series_scal_r.
    apply Series_le; [intro j; split; [apply Rabs_pos | apply E] | exact Es]. }
  change (fun j => c j * measure (x j)) with (fun j => c j * q j).
  set (y := Series (fun j => c j * q j)) in *.
  pose proof (stepped_error force_step (- y) step_ok) as R.
  replace (stepped force_step (- y) + Series (fun j => c j * x j))
    with ((stepped force_step (- y) - - y) + - (y - Series (fun j => c j * x j))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp.
  replace (y - Series (fun j => c j * x j)) with (Series (fun j => c j * (q j - x j))) by lra. lra.
Qed.

(** What the controller remembers of the last [m] displacements before the start. *)
Definition response_memory : R :=
  linear_memory H g lambda m (step INR pos past 0).

(** TH-LTI (IIR): the criterion is (beta - lambda)|v| + (sigma - e|c|_1 - delta/2) >= 0. *)
Theorem TH_LTI_iir : forall t, 0 <= t ->
  criterion_holds viscous coulomb vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0) + response_memory)
                       (kinetic mu (vel t) + V (pos t)) t.
Proof.
  exact (linear_run mu beta sigma pos vel friction hand past held_by_response H g lambda _ m P O
    sum_nonneg (TH_LTI_symbol_limit c lambda tails_summable cost) rested response_commanded).
Qed.

(** The memory is not negative, and zero for a device that had rested at its starting position. *)
Theorem TH_LTI_iir_memory : 0 <= response_memory /\
  ((forall j, past j = pos 0) -> response_memory = 0).
Proof.
  split.
  - apply linear_memory_nonneg; [| exact rested].
    exact (TH_LTI_symbol_limit c lambda tails_summable cost).
  - intro R. apply linear_memory_at_rest. intro i.
    assert (E : forall j, sample INR pos past 0 j = pos 0)
      by (intros [| j]; unfold sample; simpl; [reflexivity | apply R]).
    unfold step. rewrite !E. ring.
Qed.

(** The same for displacements of at most [Vmax] an interval. *)
Theorem TH_LTI_iir_bounded : forall Vmax t, 0 <= t ->
  0 <= coulomb -> 0 <= margin viscous coulomb Vmax -> steps_at_most pos Vmax t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0) + response_memory)
                       (kinetic mu (vel t) + V (pos t)) t.
Proof.
  exact (linear_run_bounded mu beta sigma pos vel friction hand past held_by_response H g lambda _ m
    P O (TH_LTI_symbol_limit c lambda tails_summable cost) rested response_commanded).
Qed.

(** TH-LTI (IIR, every operator). *)
Theorem TH_LTI_iir_all_speeds : lambda <= beta -> 0 <= coulomb -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t <= kinetic mu (vel 0) + V (pos 0) + response_memory.
Proof.
  intros Hb Hc. unfold coulomb in Hc.
  apply (linear_run_all_speeds mu beta sigma pos vel friction hand past held_by_response H g lambda
    _ m P O sum_nonneg (TH_LTI_symbol_limit c lambda tails_summable cost) rested
    response_commanded Hb). lra.
Qed.

End Iir.
