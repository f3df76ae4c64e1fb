(** * PositiveKernel: Schur's test for a kernel that looks back, interval by interval.

    [late] n t is what the motion at phase t of an interval feels of the way n + 1 intervals before;
    [alpha] of the way since the sample itself.  A weight on the phases bounds what is drawn by
    kappa times the integral of v^2, with a storage that is given back sample by sample. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model History InstantRun Weighted Angles.
Open Scope R_scope.

(** The integral over a period's phases, against the weight. *)
Definition phase_mass (weight g : R -> R) : R := RInt (fun t => g t * weight t) 0 1.

(** The way of the device from [s] to [t]. *)
Definition way (vel : R -> R) (s t : R) : R := RInt (fun u => Rabs (vel u)) s t.

(** What the kernel makes of the ways before interval [h], at [t] in it. *)
Definition ways_before (vel : R -> R) (late : nat -> R -> R) (h : nat) (t : R) : R :=
  sum_to h (fun j => late (pred j) (t - INR h) * way vel (INR (h - j)) (INR (S (h - j)))).

Section Kernel.

Variables kappa alpha held_back : R.
Variables pos vel weight : R -> R.
Variable late : nat -> R -> R.
Hypothesis K : kinematic pos vel.
Hypothesis alpha_nonneg : 0 <= alpha.
Hypothesis late_continuous : forall n t, continuous (late n) t.
Hypothesis late_nonneg : forall n t, 0 <= t <= 1 -> 0 <= late n t.
Hypothesis weight_continuous : forall t, continuous weight t.
Hypothesis weight_positive : forall t, 0 < weight t.

Let total := phase_mass weight (fun _ => 1).
Let share (j : nat) : R := phase_mass weight (late (pred j)).
(** The shares of all samples are at most [held_back]. *)
Hypothesis shares : forall N, sum_to N share <= held_back.
(** Schur's test. *)
Hypothesis schur : forall N t, 0 <= t <= 1 ->
  total / 2 * (alpha + sum_to N (fun j => late (pred j) t)) + held_back / 2 <= kappa * weight t.

Let r (u : R) : R := Rabs (vel u).
Let full (i : nat) : R := way vel (INR i) (INR (S i)).
Let load (h : nat) (t : R) : R := RInt (fun u => r u ^ 2 * 1 / weight (u - INR h)) (INR h) t.
Let far (h : nat) (t : R) (j : nat) : R := RInt (fun u => r u * late (pred j) (u - INR h)) (INR h) t.
Let loads (h : nat) (t : R) (j : nat) : R :=
  RInt (fun u => r u ^ 2 * late (pred j) (u - INR h) / weight (u - INR h)) (INR h) t.

Lemma r_continuous : forall t, continuous r t.
Proof. intro t. apply continuous_Rabs, (velocity_continuous _ _ K). Qed.

Lemma shifted_continuous : forall (g : R -> R) h, (forall t, continuous g t) ->
  forall t, continuous (fun u => g (u - INR h)) t.
Proof.
  intros g h C t. apply (continuous_comp (fun u => u - INR h) g); [| apply C].
  apply (ex_derive_continuous (fun u => u - INR h)). auto_derive. exact I.
Qed.

Lemma shifted_positive : forall h u, 0 < weight (u - INR h).
Proof. intros. apply weight_positive. Qed.

Lemma loads_continuous : forall (g : R -> R) h, (forall t, continuous g t) ->
  forall t, continuous (fun u => r u ^ 2 * g (u - INR h) / weight (u - INR h)) t.
Proof.
  intros g h C t. apply continuous_div.
  - apply continuous_Rmult; [apply continuous_square, r_continuous | apply shifted_continuous, C].
  - apply shifted_continuous, weight_continuous.
  - pose proof (shifted_positive h t). lra.
Qed.

Lemma mass_nonneg : forall g, (forall t, continuous g t) -> (forall t, 0 <= t <= 1 -> 0 <= g t) ->
  0 <= phase_mass weight g.
Proof.
  intros g C N. apply RInt_ge_0; [lra | |].
  - apply ex_RInt_cont. intro t. apply continuous_Rmult; auto.
  - intros t Ht. apply Rmult_le_pos; [apply N; lra | apply Rlt_le, weight_positive].
Qed.

Lemma loads_nonneg : forall (g : R -> R) h t, (forall t, continuous g t) ->
  (forall t, 0 <= t <= 1 -> 0 <= g t) -> INR h <= t <= INR (S h) ->
  0 <= RInt (fun u => r u ^ 2 * g (u - INR h) / weight (u - INR h)) (INR h) t.
Proof.
  intros g h t C N Ht. rewrite S_INR in Ht.
  apply RInt_ge_0; [lra | apply ex_RInt_cont, (loads_continuous g h C) |].
  intros u Hu. apply Rdiv_le_0_compat; [| apply weight_positive].
  apply Rmult_le_pos; [apply pow2_ge_0 | apply N; lra].
Qed.

Lemma mass_shifted : forall (g : R -> R) h, (forall t, continuous g t) ->
  RInt (fun u => g (u - INR h) * weight (u - INR h)) (INR h) (INR h + 1) = phase_mass weight g.
Proof.
  intros g h C. apply is_RInt_unique.
  assert (I : is_RInt (fun t => g t * weight t) (1 * INR h + - INR h) (1 * (INR h + 1) + - INR h)
                (phase_mass weight g)).
  { replace (1 * INR h + - INR h) with 0 by ring.
    replace (1 * (INR h + 1) + - INR h) with 1 by ring.
    apply RInt_is, ex_RInt_cont. intro t. apply continuous_Rmult; auto. }
  apply is_RInt_comp_lin in I. apply is_RInt_ext with (2 := I).
  intros u _. unfold scal. simpl. unfold mult. simpl.
  replace (1 * u + - INR h) with (u - INR h) by ring. over_R. ring.
Qed.

(** The part of an interval weighs no more than the whole. *)
Lemma weighted_phase : forall (g : R -> R) h t, (forall t, continuous g t) ->
  (forall t, 0 <= t <= 1 -> 0 <= g t) -> INR h <= t <= INR (S h) ->
  RInt (fun u => r u * g (u - INR h)) (INR h) t ^ 2
  <= phase_mass weight g
     * RInt (fun u => r u ^ 2 * g (u - INR h) / weight (u - INR h)) (INR h) t.
Proof.
  intros g h t C N Ht. pose proof (loads_nonneg g h t C N Ht) as L0. rewrite S_INR in Ht.
  eapply Rle_trans.
  - apply (weighted_squares r (fun u => g (u - INR h)) (fun u => weight (u - INR h)));
      [lra | exact r_continuous | apply shifted_continuous, C
       | apply shifted_continuous, weight_continuous | apply shifted_positive |].
    intros u Hu. apply N. lra.
  - rewrite Rmult_comm. apply Rmult_le_compat_r; [exact L0 |].
    assert (C3 : forall u, continuous (fun u => g (u - INR h) * weight (u - INR h)) u).
    { intro u. apply continuous_Rmult; apply shifted_continuous; assumption. }
    rewrite <- (mass_shifted g h C), (RInt_split _ (INR h) t (INR h + 1)) by (apply ex_RInt_cont, C3).
    assert (0 <= RInt (fun u => g (u - INR h) * weight (u - INR h)) t (INR h + 1)).
    { apply RInt_ge_0; [lra | apply ex_RInt_cont, C3 |].
      intros u Hu. apply Rmult_le_pos; [apply N; lra | apply Rlt_le, weight_positive]. }
    lra.
Qed.

Lemma way_nonneg : forall s t, s <= t -> 0 <= way vel s t.
Proof.
  intros s t St. apply RInt_ge_0; [exact St | apply (speed_integrable pos vel K) |].
  intros. apply Rabs_pos.
Qed.

Lemma way_square : forall h t, INR h <= t <= INR (S h) -> way vel (INR h) t ^ 2 <= total * load h t.
Proof.
  intros h t Ht.
  pose proof (weighted_phase (fun _ => 1) h t (fun t => continuous_const 1 t)
    (fun _ _ => Rle_0_1) Ht) as W.
  replace (way vel (INR h) t) with (RInt (fun u => r u * 1) (INR h) t); [exact W |].
  apply RInt_ext. intros u _. apply Rmult_1_r.
Qed.

Lemma total_nonneg : 0 <= total.
Proof. apply mass_nonneg; [intro; apply continuous_const | intros; lra]. Qed.

Lemma load_nonneg : forall h t, INR h <= t <= INR (S h) -> 0 <= load h t.
Proof.
  intros h t Ht. apply (loads_nonneg (fun _ => 1) h t); [intro; apply continuous_const | | exact Ht].
  intros; lra.
Qed.

(** What the ways before weigh, sample by sample. *)
Lemma far_paid : forall h t j, INR h <= t <= INR (S h) ->
  full (h - j) * far h t j
  <= (share j * load (h - j) (INR (S (h - j))) + total * loads h t j) / 2.
Proof.
  intros h t j Ht.
  assert (Hf : INR (h - j) <= INR (S (h - j)) <= INR (S (h - j))) by (rewrite S_INR; lra).
  apply product_of_squares.
  - exact total_nonneg.
  - apply load_nonneg, Hf.
  - apply mass_nonneg; [apply late_continuous | intros; apply late_nonneg; assumption].
  - apply (loads_nonneg (late (pred j))); [apply late_continuous | | exact Ht].
    intros; apply late_nonneg; assumption.
  - apply way_square, Hf.
  - apply (weighted_phase (late (pred j))); [apply late_continuous | | exact Ht].
    intros; apply late_nonneg; assumption.
Qed.

(** Schur's test over an interval. *)
Lemma schur_interval : forall h t, INR h <= t <= INR (S h) ->
  total / 2 * (alpha * load h t + sum_to h (loads h t)) + held_back / 2 * load h t
  <= kappa * square_integral vel (INR h) t.
Proof.
  intros h t Ht. rewrite S_INR in Ht.
  assert (C1 : forall u, continuous (fun u => r u ^ 2 * 1 / weight (u - INR h)) u)
    by (intro u; apply (loads_continuous (fun _ => 1) h); intro; apply continuous_const).
  assert (Cj : forall j u, continuous
    (fun u => r u ^ 2 * late (pred j) (u - INR h) / weight (u - INR h)) u)
    by (intros j u; apply (loads_continuous (late (pred j)) h); apply late_continuous).
  assert (I : is_RInt (fun u => total / 2 * (alpha * (r u ^ 2 * 1 / weight (u - INR h))
      + sum_to h (fun j => r u ^ 2 * late (pred j) (u - INR h) / weight (u - INR h)))
      + held_back / 2 * (r u ^ 2 * 1 / weight (u - INR h))) (INR h) t
    (total / 2 * (alpha * load h t + sum_to h (loads h t)) + held_back / 2 * load h t)).
  { apply (@is_RInt_plus R_NormedModule (fun u => total / 2 * (alpha * (r u ^ 2 * 1 / weight (u - INR h))
      + sum_to h (fun j => r u ^ 2 * late (pred j) (u - INR h) / weight (u - INR h))))).
    - apply (@is_RInt_scal R_NormedModule).
      apply (@is_RInt_plus R_NormedModule (fun u => alpha * (r u ^ 2 * 1 / weight (u - INR h)))).
      + apply (@is_RInt_scal R_NormedModule). apply RInt_is, ex_RInt_cont, C1.
      + apply RInt_sum_to. intro j. apply ex_RInt_cont, Cj.
    - apply (@is_RInt_scal R_NormedModule). apply RInt_is, ex_RInt_cont, C1. }
  assert (J : is_RInt (fun u => kappa * vel u ^ 2) (INR h) t (kappa * square_integral vel (INR h) t)).
  { apply (@is_RInt_scal R_NormedModule), RInt_is, (square_integrable pos vel K). }
  apply (is_RInt_le _ _ _ _ _ _ (proj1 Ht) I J).
  intros u Hu. pose proof (shifted_positive h u) as W0.
  pose proof (schur h (u - INR h) ltac:(lra)) as Sc.
  assert (Sum : sum_to h (fun j => r u ^ 2 * late (pred j) (u - INR h) / weight (u - INR h))
                = r u ^ 2 / weight (u - INR h) * sum_to h (fun j => late (pred j) (u - INR h))).
  { rewrite <- sum_to_scal. apply sum_to_ext. intros j _. field. lra. }
  rewrite Sum.
  replace (total / 2 * (alpha * (r u ^ 2 * 1 / weight (u - INR h))
      + r u ^ 2 / weight (u - INR h) * sum_to h (fun j => late (pred j) (u - INR h)))
      + held_back / 2 * (r u ^ 2 * 1 / weight (u - INR h)))
    with (r u ^ 2 / weight (u - INR h)
      * (total / 2 * (alpha + sum_to h (fun j => late (pred j) (u - INR h))) + held_back / 2))
    by (field; lra).
  replace (kappa * vel u ^ 2)
    with (r u ^ 2 / weight (u - INR h) * (kappa * weight (u - INR h)))
    by (unfold r; rewrite pow2_abs; field; lra).
  apply Rmult_le_compat_l; [| exact Sc].
  apply Rdiv_le_0_compat; [apply pow2_ge_0 | exact W0].
Qed.

Definition kernel_held (h : nat) : R :=
  sum_to h (fun j => load (h - j) (INR (S (h - j))) * (held_back - sum_to (pred j) share)) / 2.
Definition kernel_towards (h : nat) (t : R) : R :=
  (held_back * load h t
   + sum_to h (fun j => load (h - j) (INR (S (h - j))) * (held_back - sum_to j share))) / 2.

Lemma kernel_arrives : forall h, kernel_towards h (INR (S h)) = kernel_held (S h).
Proof.
  intro h. unfold kernel_held, kernel_towards. rewrite sum_to_first. f_equal.
  replace (S h - 1)%nat with h by lia. simpl pred. simpl (sum_to 0 share).
  rewrite Rminus_0_r. ring_simplify. f_equal.
Qed.

Lemma kernel_grows : forall h t,
  kernel_towards h t - kernel_held h
  = held_back / 2 * load h t
    - sum_to h (fun j => share j * load (h - j) (INR (S (h - j)))) / 2.
Proof.
  intros h t. unfold kernel_held, kernel_towards.
  rewrite (sum_to_ext h (fun j => load (h - j) (INR (S (h - j))) * (held_back - sum_to (pred j) share))
    (fun j => load (h - j) (INR (S (h - j))) * (held_back - sum_to j share)
              + share j * load (h - j) (INR (S (h - j))))).
  - rewrite sum_to_plus. field.
  - intros [| j] Hj; [lia |]. simpl pred. rewrite sum_to_S. ring.
Qed.

Lemma kernel_nonneg : forall h t, INR h <= t <= INR (S h) -> 0 <= kernel_towards h t.
Proof.
  intros h t Ht. unfold kernel_towards.
  assert (0 <= held_back) by (apply (shares 0)).
  pose proof (load_nonneg h t Ht).
  assert (0 <= held_back * load h t) by (apply Rmult_le_pos; assumption).
  assert (0 <= sum_to h (fun j => load (h - j) (INR (S (h - j))) * (held_back - sum_to j share))).
  { apply sum_to_nonneg. intros j _. pose proof (shares j).
    apply Rmult_le_pos; [apply load_nonneg; rewrite S_INR; lra | lra]. }
  lra.
Qed.

(** What is drawn from the ways before. *)
Lemma ways_before_work : forall h t, INR h <= t <= INR (S h) ->
  is_RInt (fun u => r u * ways_before vel late h u) (INR h) t
          (sum_to h (fun j => full (h - j) * far h t j)).
Proof.
  intros h t Ht.
  assert (C : forall j u, continuous (fun u => r u * late (pred j) (u - INR h)) u).
  { intros j u. apply continuous_Rmult; [apply r_continuous | apply shifted_continuous, late_continuous]. }
  apply is_RInt_ext with (fun u => sum_to h (fun j => full (h - j) * (r u * late (pred j) (u - INR h)))).
  - intros u _. over_R. unfold ways_before. rewrite <- sum_to_scal. apply sum_to_ext.
    intros j _. unfold full. ring.
  - rewrite (sum_to_ext h (fun j => full (h - j) * far h t j)
      (fun j => RInt (fun u => full (h - j) * (r u * late (pred j) (u - INR h))) (INR h) t)).
    + apply RInt_sum_to. intro j. apply ex_RInt_cont. intro u.
      apply continuous_Rmult; [apply continuous_const | apply C].
    + intros j _. symmetry. apply is_RInt_unique. apply (@is_RInt_scal R_NormedModule).
      apply RInt_is, ex_RInt_cont, C.
Qed.

(** Way since the sample, ways before and the growth of the storage: at most kappa. *)
Lemma kernel_paid : forall h t, INR h <= t <= INR (S h) ->
  alpha * (way vel (INR h) t ^ 2 / 2)
  + RInt (fun u => r u * ways_before vel late h u) (INR h) t
  + (kernel_towards h t - kernel_held h)
  <= kappa * square_integral vel (INR h) t.
Proof.
  intros h t Ht. rewrite (is_RInt_unique _ _ _ _ (ways_before_work h t Ht)).
  pose proof (schur_interval h t Ht) as Sc.
  pose proof (way_square h t Ht) as Wq. pose proof (kernel_grows h t) as Hg.
  apply (Rmult_le_compat_l alpha) in Wq; [| exact alpha_nonneg].
  assert (Q : sum_to h (fun j => full (h - j) * far h t j)
    <= sum_to h (fun j => share j * load (h - j) (INR (S (h - j)))) / 2
       + total / 2 * sum_to h (loads h t)).
  { eapply Rle_trans; [apply sum_to_le; intros j _; apply (far_paid h t j Ht) |].
    rewrite (sum_to_ext h _ (fun j => / 2 * (share j * load (h - j) (INR (S (h - j))))
      + total / 2 * loads h t j)) by (intros; field).
    rewrite sum_to_plus, !sum_to_scal. change (fun j => loads h t j) with (loads h t). lra. }
  lra.
Qed.

End Kernel.
