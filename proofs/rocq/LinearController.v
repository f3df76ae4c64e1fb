(** * LinearController: TH-LTI, any linear digital controller with a response c_0, c_1, ...

    The command is -(c_0 q_h + c_1 q_(h-1) + ...), from measured positions q.  With H(1) the sum
    of the response and g_j = c_j + c_(j+1) + ... its tails, it is -(H(1) x_h - g_1 s_1 - g_2 s_2
    - ...) but for quantization, s_j the displacement that ended j - 1 samples ago. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller Angles ChargedRun InstantRun.
Open Scope R_scope.

(** What the controller commands from the position and the last [L] displacements. *)
Definition linear_command (H : R) (g : nat -> R) (L : nat) (x : R) (s : nat -> R) : R :=
  H * x - sum_to L (fun j => g j * s j).

(** What it may still give after the displacements [s], the last [L] of them not zero. *)
Definition linear_memory (H : R) (g : nat -> R) (lambda : R) (L : nat) (s : nat -> R) : R :=
  lambda * sum_of_squares L s - total_cost H g L L s.

Definition spring_potential (H x : R) : R := H * x ^ 2 / 2.

Lemma total_cost_ext : forall H g n L s s', (forall j, (1 <= j)%nat -> s j = s' j) ->
  total_cost H g n L s = total_cost H g n L s'.
Proof.
  intros H g n L s s' E. apply sum_to_ext. intros i Hi. unfold step_cost. rewrite E by lia.
  do 2 f_equal. apply sum_to_ext. intros j Hj. rewrite E by lia. reflexivity.
Qed.

Lemma linear_memory_ext : forall H g lambda L s s', (forall j, (1 <= j)%nat -> s j = s' j) ->
  linear_memory H g lambda L s = linear_memory H g lambda L s'.
Proof.
  intros H g lambda L s s' E. unfold linear_memory, sum_of_squares.
  rewrite (total_cost_ext H g L L s s' E).
  rewrite (sum_to_ext L (fun i => s i ^ 2) (fun i => s' i ^ 2)); [reflexivity |].
  intros i Hi. rewrite E by lia. reflexivity.
Qed.

Lemma linear_memory_nonneg : forall H g lambda L s, symbol_at_most H g lambda ->
  (forall i, (L < i)%nat -> s i = 0) -> 0 <= linear_memory H g lambda L s.
Proof.
  intros H g lambda L s B Z. unfold linear_memory.
  pose proof (TH_LTI_form_limit H g lambda L L s B (le_n L) Z). lra.
Qed.

Lemma linear_memory_at_rest : forall H g lambda L s, (forall i, s i = 0) ->
  linear_memory H g lambda L s = 0.
Proof.
  intros H g lambda L s Z. unfold linear_memory, sum_of_squares, total_cost, step_cost.
  rewrite !sum_to_zero; [ring | |]; intros i _; rewrite Z; unfold Rdiv; ring.
Qed.

Lemma linear_memory_push : forall H g lambda L d s, (forall i, (L < i)%nat -> s i = 0) ->
  linear_memory H g lambda (S L) (push d s) - linear_memory H g lambda L s
  = lambda * d ^ 2 - step_cost H g L d s.
Proof.
  intros H g lambda L d s Z. unfold linear_memory, sum_of_squares, total_cost at 1.
  rewrite !sum_to_first. simpl (push d s 1).
  rewrite (sum_to_ext L (fun i => push d s (S i) ^ 2) (fun i => s i ^ 2))
    by (intros [| i] Hi; [lia | reflexivity]).
  rewrite (sum_to_ext L (fun i => step_cost H g (S L) (push d s (S i)) _)
    (fun i => step_cost H g (S L) (s i) (fun j => s (i + j)%nat)))
    by (intros [| i] Hi; [lia | reflexivity]).
  change (sum_to L (fun i => step_cost H g (S L) (s i) (fun j => s (i + j)%nat)))
    with (total_cost H g (S L) L s).
  rewrite (total_cost_order H g (S L) L L s) by (try lia; exact Z).
  assert (E : step_cost H g (S L) d (fun j => push d s (1 + j)%nat) = step_cost H g L d s).
  { unfold step_cost. rewrite sum_to_S. simpl (push d s (1 + S L)). rewrite Z by lia.
    rewrite (sum_to_ext L _ (fun j => g j * s j))
      by (intros [| j] Hj; [lia | reflexivity]). ring. }
  rewrite E. ring.
Qed.

(** TH-LTI (work): what a step generates against the spring H(1), without quantization. *)
Theorem TH_LTI_work : forall H g L x d s,
  generated (- linear_command H g L x s) x (x + d) (spring_potential H x)
            (spring_potential H (x + d))
  = step_cost H g L d s.
Proof. intros. unfold generated, linear_command, spring_potential, step_cost. field. Qed.

Section Run.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past held : nat -> R.
Variables (H : R) (g : nat -> R) (lambda coulomb : R) (m : nat).
Hypothesis P : physical mu beta sigma.
Hypothesis O : obeys mu beta sigma INR held pos vel friction hand.
Hypothesis H_nonneg : 0 <= H.
Hypothesis B : symbol_at_most H g lambda.
(** The device rested until [m] samples before the start. *)
Hypothesis rested : forall j, (m < j)%nat -> step INR pos past 0 j = 0.
(** The held force is the linear command but for at most [coulomb]. *)
Hypothesis commanded : forall h,
  Rabs (held h + linear_command H g (h + m) (pos (INR h)) (step INR pos past h)) <= coulomb.

Let V := spring_potential H.
Let W (h : nat) : R := linear_memory H g lambda (h + m) (step INR pos past h).
Let X (h : nat) (t : R) : R :=
  linear_memory H g lambda (S (h + m)) (push (pos t - pos (INR h)) (step INR pos past h)).

Lemma still_rested : forall h j, (h + m < j)%nat -> step INR pos past h j = 0.
Proof.
  induction h as [| h IH]; intros j Hj; [apply rested; lia |].
  rewrite step_next by lia. destruct j as [| [| j]]; [lia | lia |]. simpl. apply IH. lia.
Qed.

Lemma linear_arrives : forall h, X h (INR (S h)) = W (S h).
Proof.
  intro h. unfold X, W. simpl (S h + m)%nat. apply linear_memory_ext.
  intros j Hj. symmetry. apply step_next. exact Hj.
Qed.

Lemma linear_charge : forall h t, INR h <= t <= INR (S h) ->
  generated (held h) (pos (INR h)) (pos t) (V (pos (INR h))) (V (pos t)) + X h t - W h
  <= lambda * (pos t - pos (INR h)) ^ 2 + coulomb * Rabs (pos t - pos (INR h)).
Proof.
  intros h t _. set (d := pos t - pos (INR h)). set (s := step INR pos past h).
  pose proof (linear_memory_push H g lambda (h + m) d s (still_rested h)) as M.
  pose proof (TH_LTI_work H g (h + m) (pos (INR h)) d s) as G.
  replace (pos (INR h) + d) with (pos t) in G by (unfold d; ring).
  unfold X, W. fold d s. unfold generated in *. unfold V. fold d. fold d in G.
  set (F := linear_command H g (h + m) (pos (INR h)) s) in *.
  assert (Q : (held h + F) * d <= coulomb * Rabs d).
  { eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos | apply commanded]. }
  replace (pos t - pos (INR h)) with d in G by reflexivity. lra.
Qed.

Lemma end_nonneg : forall h t, 0 <= X h t.
Proof.
  intros h t. apply linear_memory_nonneg; [exact B |].
  intros [| [| i]] Hi; [lia | lia |]. simpl. apply still_rested. lia.
Qed.

Let start := kinetic mu (vel 0) + V (pos 0) + linear_memory H g lambda m (step INR pos past 0).

Lemma linear_run : forall t, 0 <= t ->
  criterion_holds (beta - lambda) (sigma - coulomb) vel t ->
  passive_run vel hand start (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  pose proof (lambda_at_least H g lambda B) as L0.
  destruct (charged_run mu beta sigma lambda coulomb INR held pos vel friction hand V W X
    P INR_increasing O linear_arrives linear_charge INR_on_time ltac:(lra) N t HN) as (I & E).
  - simpl (INR 0). exact H8.
  - pose proof (end_nonneg N t). simpl (INR 0) in *. split; [exact I |].
    unfold start. unfold W in E. simpl (0 + m)%nat in E. lra.
Qed.

Lemma linear_run_bounded : forall Vmax t, 0 <= t ->
  0 <= sigma - coulomb -> 0 <= margin (beta - lambda) (sigma - coulomb) Vmax ->
  steps_at_most pos Vmax t ->
  passive_run vel hand start (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros Vmax t Ht Hc Hm Hd. destruct (INR_covers t Ht) as (N & HN).
  destruct (charged_run_bounded mu beta sigma lambda coulomb INR held pos vel friction hand V W X
    P INR_increasing O linear_arrives linear_charge INR_on_time Vmax N t HN Hc Hm) as (I & E).
  - intros h r. apply Hd. exact HN.
  - pose proof (end_nonneg N t). simpl (INR 0) in *. split; [exact I |].
    unfold start. unfold W in E. simpl (0 + m)%nat in E. lra.
Qed.

(** With enough friction at every speed the operator never draws more than the storage at the
    start. *)
Lemma linear_run_all_speeds : lambda <= beta -> coulomb <= sigma -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t <= start.
Proof.
  intros Hb Hc t Ht.
  assert (C : criterion_holds (beta - lambda) (sigma - coulomb) vel t)
    by (apply enough_at_all_speeds; lra).
  destruct (linear_run t Ht C) as [_ E].
  assert (0 <= kinetic mu (vel t)).
  { unfold kinetic. pose proof (mu_positive _ _ _ P). pose proof (pow2_ge_0 (vel t)). nra. }
  assert (0 <= V (pos t)).
  { unfold V, spring_potential. pose proof (pow2_ge_0 (pos t)).
    assert (0 <= H * pos t ^ 2) by (apply Rmult_le_pos; assumption). lra. }
  lra.
Qed.

End Run.
