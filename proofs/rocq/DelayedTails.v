(** * DelayedTails: the tails of a controller behind an actuator that only delays.

    A tail that hears of the displacement j samples ago, behind the actuator, is a kernel that
    looks back and sums to at most 1 over samples and over phases: it costs its absolute value. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model History InstantRun Weighted Angles
  PositiveKernel.
Open Scope R_scope.

(** What of a step has come between n and n + 1 periods after its sample, at a phase. *)
Definition arriving (late : R -> R) (n : nat) (t : R) : R :=
  match n with O => 1 - late (INR 0 + t) | S m => late (INR m + t) - late (INR n + t) end.

(** The kernel of the tail of the displacement j samples ago. *)
Definition tail_kernel (late : R -> R) (j m : nat) (t : R) : R :=
  if Nat.ltb (S m) j then 0 else arriving late (S m - j) t.

(** The way that a tail hears of at sample [i], none before sample 0. *)
Definition heard_way (vel : R -> R) (i j : nat) : R :=
  if Nat.leb j i then way vel (INR (i - j)) (INR (S (i - j))) else 0.

Lemma sum_shift : forall (F : nat -> R) j M, (forall i, (i < j)%nat -> F i = 0) -> (1 <= j)%nat ->
  sum_to (M + j) F = F j + sum_to M (fun m => F (m + j)%nat).
Proof.
  intros F j M Z Hj. induction M as [| M IH].
  - simpl. rewrite (sum_to_single j j) by (try lia; intros; apply Z; lia). ring.
  - simpl (S M + j)%nat. rewrite !sum_to_S, IH. simpl (S M + j)%nat. ring.
Qed.

Section Tails.

Variable late : R -> R.
Hypothesis late_continuous : forall x, continuous late x.
Hypothesis late_falls : forall x y, x <= y -> late y <= late x.
Hypothesis late_share : forall x, 0 <= late x <= 1.

Lemma arriving_nonneg : forall n t, 0 <= arriving late n t.
Proof.
  intros [| n] t; unfold arriving.
  - pose proof (late_share (INR 0 + t)). lra.
  - pose proof (late_falls (INR n + t) (INR (S n) + t)) as F. rewrite S_INR in *.
    specialize (F ltac:(lra)). lra.
Qed.

Lemma arriving_continuous : forall n t, continuous (arriving late n) t.
Proof.
  assert (C : forall i t, continuous (fun t => late (INR i + t)) t).
  { intros i t. apply (continuous_comp (fun t => INR i + t) late); [| apply late_continuous].
    apply (ex_derive_continuous (fun t => INR i + t)). auto_derive. exact I. }
  intros [| n] t; unfold arriving;
    [apply (continuous_minus (fun _ => 1)); [apply continuous_const | apply (C 0%nat)]
    | apply (continuous_minus (fun t => late (INR n + t)) (fun t => late (INR (S n) + t))); apply C].
Qed.

Lemma arriving_sum : forall M t,
  arriving late 0 t + sum_to M (fun n => arriving late n t) = 1 - late (INR M + t).
Proof.
  intros M t. induction M as [| M IH]; [unfold arriving; simpl sum_to; ring |].
  rewrite sum_to_S, <- Rplus_assoc, IH. unfold arriving. ring.
Qed.

Lemma tail_kernel_nonneg : forall j m t, 0 <= tail_kernel late j m t.
Proof.
  intros j m t. unfold tail_kernel. destruct (Nat.ltb (S m) j); [lra | apply arriving_nonneg].
Qed.

Lemma tail_kernel_continuous : forall j m t, continuous (tail_kernel late j m) t.
Proof.
  intros j m t. unfold tail_kernel. destruct (Nat.ltb (S m) j);
    [apply continuous_const | apply arriving_continuous].
Qed.

Lemma tail_kernel_sum : forall j N t, (1 <= j)%nat ->
  sum_to N (fun i => tail_kernel late j (pred i) t) <= 1.
Proof.
  intros j N t Hj.
  assert (G : sum_to N (fun i => tail_kernel late j (pred i) t)
              <= sum_to (N + j) (fun i => tail_kernel late j (pred i) t)).
  { clear Hj. generalize j at 2. intro d. induction d as [| d IH]; [rewrite Nat.add_0_r; lra |].
    replace (N + S d)%nat with (S (N + d)) by lia. rewrite sum_to_S.
    pose proof (tail_kernel_nonneg j (pred (S (N + d))) t). lra. }
  eapply Rle_trans; [exact G |].
  rewrite (sum_to_ext (N + j) _ (fun i => if Nat.ltb i j then 0 else arriving late (i - j) t)).
  - rewrite sum_shift; [| intros i Hi; destruct (Nat.ltb_spec i j); [reflexivity | lia] | exact Hj].
    rewrite (sum_to_ext N _ (fun n => arriving late n t)).
    + rewrite Nat.ltb_irrefl, Nat.sub_diag. rewrite arriving_sum.
      pose proof (late_share (INR N + t)). lra.
    + intros m _. destruct (Nat.ltb_spec (m + j) j); [lia |].
      replace (m + j - j)%nat with m by lia. reflexivity.
  - intros i Hi. unfold tail_kernel. replace (S (pred i)) with i by lia. reflexivity.
Qed.

(** The steps of what a tail hears, each as far as it has come, are the kernel's ways before. *)
Lemma tail_ways : forall vel j h t, (1 <= j)%nat ->
  heard_way vel h j
  - sum_to h (fun i => late (INR (pred i) + (t - INR h))
                       * (heard_way vel (h - pred i) j - heard_way vel (h - i) j))
  = ways_before vel (tail_kernel late j) h t.
Proof.
  intros vel j h t Hj. set (p := t - INR h). set (y := fun m => heard_way vel (h - m) j).
  assert (Parts : forall M,
    y 0%nat - sum_to M (fun i => late (INR (pred i) + p) * (y (pred i) - y i))
    = arriving late 0 p * y 0%nat + sum_to M (fun m => arriving late m p * y m)
      + late (INR M + p) * y M).
  { induction M as [| M IH]; [unfold arriving; simpl sum_to; ring |].
    rewrite !sum_to_S. simpl pred.
    replace (y 0%nat - (sum_to M (fun i => late (INR (pred i) + p) * (y (pred i) - y i))
      + late (INR M + p) * (y M - y (S M))))
      with ((y 0%nat - sum_to M (fun i => late (INR (pred i) + p) * (y (pred i) - y i)))
            - late (INR M + p) * (y M - y (S M))) by ring.
    rewrite IH.
    change (arriving late (S M) p) with (late (INR M + p) - late (INR (S M) + p)). ring. }
  specialize (Parts h). unfold y at 1 in Parts. rewrite Nat.sub_0_r in Parts.
  unfold y at 1 2 in Parts. rewrite Parts.
  assert (Yh : y h = 0).
  { unfold y, heard_way. rewrite Nat.sub_diag. destruct (Nat.leb_spec j 0); [lia | reflexivity]. }
  rewrite Yh, Rmult_0_r, Rplus_0_r. unfold ways_before. fold p.
  destruct (Nat.le_gt_cases j h) as [L | L].
  - set (M := (h - j)%nat).
    rewrite (sum_to_extend M h); [| unfold M; lia |].
    2: { intros m Hm. unfold y, heard_way, M in *.
         destruct (Nat.leb_spec j (h - m)); [lia | ring]. }
    rewrite (sum_to_ext h _ (fun i => if Nat.ltb i j then 0
      else arriving late (i - j) p * way vel (INR (h - i)) (INR (S (h - i))))).
    2: { intros i Hi. unfold tail_kernel. replace (S (pred i)) with i by lia.
         destruct (Nat.ltb i j); ring. }
    set (F := fun i => if Nat.ltb i j then 0
      else arriving late (i - j) p * way vel (INR (h - i)) (INR (S (h - i)))).
    assert (Fs : sum_to h F = F j + sum_to M (fun m => F (m + j)%nat)).
    { rewrite <- sum_shift; [f_equal; unfold M; lia | | exact Hj].
      intros i Hi. unfold F. destruct (Nat.ltb_spec i j); [reflexivity | lia]. }
    rewrite Fs. unfold F at 1. rewrite Nat.ltb_irrefl, Nat.sub_diag. f_equal.
    + unfold y, heard_way. rewrite Nat.sub_0_r. destruct (Nat.leb_spec j h); [reflexivity | lia].
    + apply sum_to_ext. intros m Hm. unfold F. destruct (Nat.ltb_spec (m + j) j); [lia |].
      replace (m + j - j)%nat with m by lia. unfold y, heard_way.
      destruct (Nat.leb_spec j (h - m)); [| unfold M in Hm; lia].
      replace (h - m - j)%nat with (h - (m + j))%nat by lia. reflexivity.
  - assert (Y0 : forall m, y m = 0).
    { intro m. unfold y, heard_way. destruct (Nat.leb_spec j (h - m)); [lia | reflexivity]. }
    rewrite Y0, Rmult_0_r, Rplus_0_l, !sum_to_zero; [reflexivity | |].
    + intros i Hi. unfold tail_kernel. replace (S (pred i)) with i by lia.
      destruct (Nat.ltb_spec i j); [ring | lia].
    + intros m _. rewrite Y0. ring.
Qed.

(** ** What all tails together cost: the sum of their absolute values [a] *)

Variables pos vel : R -> R.
Variables (a : nat -> R) (n : nat).
Hypothesis K : kinematic pos vel.
Hypothesis a_nonneg : forall j, 0 <= a j.

Let one (_ : R) : R := 1.

Definition tails_extra (h : nat) (t : R) : R :=
  sum_to n (fun j => a j * ways_before vel (tail_kernel late j) h t).
Definition tails_held (h : nat) : R :=
  sum_to n (fun j => a j * kernel_held 1 vel one (tail_kernel late j) h).
Definition tails_towards (h : nat) (t : R) : R :=
  sum_to n (fun j => a j * kernel_towards 1 vel one (tail_kernel late j) h t).

Lemma one_mass : phase_mass one (fun _ => 1) = 1.
Proof.
  apply is_RInt_unique. evar_last.
  - apply is_RInt_ext with (fun _ : R => 1); [intros; unfold one; over_R; ring |].
    apply (@is_RInt_const R_NormedModule).
  - unfold scal. simpl. unfold mult. simpl. over_R. ring.
Qed.

Lemma tail_shares : forall j, (1 <= j)%nat -> forall N,
  sum_to N (fun i => phase_mass one (tail_kernel late j (pred i))) <= 1.
Proof.
  intros j Hj N.
  assert (C : forall i t, continuous (fun t => tail_kernel late j (pred i) t * one t) t).
  { intros i t. apply continuous_Rmult; [apply tail_kernel_continuous | apply continuous_const]. }
  unfold phase_mass.
  rewrite <- (is_RInt_unique _ _ _ _ (RInt_sum_to N (fun i t => tail_kernel late j (pred i) t * one t)
    0 1 (fun i => ex_RInt_cont _ 0 1 (C i)))).
  eapply Rle_trans; [| apply Req_le, one_mass]. unfold phase_mass.
  apply RInt_le; [lra | | |].
  - apply ex_RInt_cont. intro t. apply continuous_sum_to. intro i. apply C.
  - apply ex_RInt_cont. intro t. apply continuous_Rmult; apply continuous_const.
  - intros t _. unfold one.
    rewrite (sum_to_ext N _ (fun i => tail_kernel late j (pred i) t)) by (intros; ring).
    pose proof (tail_kernel_sum j N t Hj). lra.
Qed.

Lemma tail_paid : forall j h t, (1 <= j)%nat -> INR h <= t <= INR (S h) ->
  RInt (fun u => Rabs (vel u) * ways_before vel (tail_kernel late j) h u) (INR h) t
  + (kernel_towards 1 vel one (tail_kernel late j) h t - kernel_held 1 vel one (tail_kernel late j) h)
  <= square_integral vel (INR h) t.
Proof.
  intros j h t Hj Ht.
  pose proof (kernel_paid 1 0 1 pos vel one (tail_kernel late j) K (Rle_refl 0)
    (tail_kernel_continuous j) (fun m t _ => tail_kernel_nonneg j m t)
    (fun t => continuous_const 1 t) (fun _ => Rlt_0_1)) as Kp.
  assert (Sc : forall N t, 0 <= t <= 1 -> phase_mass one (fun _ => 1) / 2
    * (0 + sum_to N (fun i => tail_kernel late j (pred i) t)) + 1 / 2 <= 1 * one t).
  { intros N u _. rewrite one_mass. unfold one. pose proof (tail_kernel_sum j N u Hj). lra. }
  specialize (Kp Sc h t Ht). cbv beta in Kp. rewrite Rmult_0_l, Rplus_0_l, Rmult_1_l in Kp. exact Kp.
Qed.

Lemma tails_integrable : forall h t, INR h <= t <= INR (S h) ->
  is_RInt (fun u => Rabs (vel u) * tails_extra h u) (INR h) t
    (sum_to n (fun j => a j
      * RInt (fun u => Rabs (vel u) * ways_before vel (tail_kernel late j) h u) (INR h) t)).
Proof.
  intros h t Ht.
  assert (E : forall j, ex_RInt
    (fun u => Rabs (vel u) * ways_before vel (tail_kernel late j) h u) (INR h) t).
  { intro j. eexists. exact (ways_before_work pos vel (tail_kernel late j) K
      (tail_kernel_continuous j) h t Ht). }
  apply is_RInt_ext with (fun u => sum_to n (fun j =>
    a j * (Rabs (vel u) * ways_before vel (tail_kernel late j) h u))).
  - intros u _. over_R. unfold tails_extra. rewrite <- sum_to_scal. apply sum_to_ext. intros. ring.
  - rewrite (sum_to_ext n (fun j => a j * RInt _ _ _) (fun j => RInt (fun u =>
      a j * (Rabs (vel u) * ways_before vel (tail_kernel late j) h u)) (INR h) t)).
    + apply RInt_sum_to. intro j. apply (@ex_RInt_scal R_NormedModule), E.
    + intros j _. symmetry. apply is_RInt_unique.
      apply (@is_RInt_scal R_NormedModule), RInt_is, E.
Qed.

Lemma tails_paid : forall h t, INR h <= t <= INR (S h) ->
  RInt (fun u => Rabs (vel u) * tails_extra h u) (INR h) t + (tails_towards h t - tails_held h)
  <= sum_to n a * square_integral vel (INR h) t.
Proof.
  intros h t Ht. rewrite (is_RInt_unique _ _ _ _ (tails_integrable h t Ht)).
  unfold tails_towards, tails_held.
  rewrite (Rmult_comm (sum_to n a)), <- sum_to_scal.
  assert (D : forall F G : nat -> R, sum_to n F - sum_to n G = sum_to n (fun j => F j + - 1 * G j)).
  { intros F G. rewrite sum_to_plus, sum_to_scal. ring. }
  rewrite D, <- sum_to_plus. apply sum_to_le. intros j Hj.
  pose proof (tail_paid j h t (proj1 Hj) Ht) as T.
  apply (Rmult_le_compat_l (a j)) in T; [| apply a_nonneg]. lra.
Qed.

Lemma tails_arrive : forall h, tails_towards h (INR (S h)) = tails_held (S h).
Proof.
  intro h. apply sum_to_ext. intros j _. f_equal. apply kernel_arrives.
Qed.

Lemma tails_towards_nonneg : forall h t, INR h <= t <= INR (S h) -> 0 <= tails_towards h t.
Proof.
  intros h t Ht. apply sum_to_nonneg. intros j Hj. apply Rmult_le_pos; [apply a_nonneg |].
  apply (kernel_nonneg 1 pos vel one (tail_kernel late j) K).
  - intro u. apply continuous_const.
  - intro u. apply Rlt_0_1.
  - apply tail_shares, Hj.
  - exact Ht.
Qed.

Lemma tails_start : tails_held 0 = 0.
Proof.
  apply sum_to_zero. intros j _. unfold kernel_held. simpl. field.
Qed.

End Tails.
