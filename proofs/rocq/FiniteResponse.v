(** * FiniteResponse: TH-LTI for a controller with a finite response c_0, ..., c_n. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller Angles ChargedRun LinearController.
Open Scope R_scope.

(** c_0 q_0 + ... + c_n q_n, q_j the position j samples ago. *)
Definition convolution (c : nat -> R) (n : nat) (q : nat -> R) : R :=
  sum_f_R0 (fun j => c j * q j) n.

(** |c_0| + ... + |c_n|. *)
Definition response_norm (c : nat -> R) (n : nat) : R := sum_f_R0 (fun j => Rabs (c j)) n.

(** g_j = c_j + ... + c_n; H(1) is g_0. *)
Definition tail (c : nat -> R) (n j : nat) : R :=
  if Nat.leb j n then sum_f_R0 (fun i => c (j + i)%nat) (n - j) else 0.

Lemma tail_beyond : forall c n j, (n < j)%nat -> tail c n j = 0.
Proof. intros c n j Hj. unfold tail. destruct (Nat.leb_spec j n); [lia | reflexivity]. Qed.

Lemma tail_last : forall c n, tail c n n = c n.
Proof.
  intros c n. unfold tail. rewrite Nat.leb_refl, Nat.sub_diag. simpl. f_equal. lia.
Qed.

Lemma tail_step : forall c n j, (j <= n)%nat -> tail c n j - tail c n (S j) = c j.
Proof.
  intros c n j Hj. destruct (Nat.eq_dec j n) as [-> | N].
  - rewrite tail_last, tail_beyond by lia. ring.
  - unfold tail. destruct (Nat.leb_spec j n), (Nat.leb_spec (S j) n); try lia.
    replace (n - j)%nat with (S (n - S j)) by lia.
    rewrite decomp_sum by lia. simpl pred.
    rewrite (sum_eq (fun i => c (j + S i)%nat) (fun i => c (S j + i)%nat))
      by (intros; f_equal; lia).
    replace (j + 0)%nat with j by lia. ring.
Qed.

(** A sum of c_j = g_j - g_(j+1) against positions is one of tails against displacements. *)
Lemma sum_by_parts : forall (g q : nat -> R) n,
  sum_f_R0 (fun j => (g j - g (S j)) * q j) n
  = g 0%nat * q 0%nat - sum_to n (fun j => g j * (q (pred j) - q j)) - g (S n) * q n.
Proof.
  intros g q n. induction n as [| n IH]; [simpl; ring |].
  rewrite tech5, IH, sum_to_S. simpl pred. ring.
Qed.

(** TH-LTI (tails): the controller is the spring H(1) and its tails against displacements. *)
Theorem TH_LTI_tails : forall c n L q, (n <= L)%nat ->
  convolution c n q
  = linear_command (tail c n 0) (tail c n) L (q 0%nat) (fun j => q (pred j) - q j).
Proof.
  intros c n L q HL. unfold convolution, linear_command.
  rewrite (sum_to_extend n L) by (try lia; intros j Hj; rewrite tail_beyond by lia; ring).
  rewrite (sum_eq _ (fun j => (tail c n j - tail c n (S j)) * q j))
    by (intros j Hj; rewrite tail_step by lia; reflexivity).
  rewrite sum_by_parts, (tail_beyond c n (S n)) by lia. ring.
Qed.

(** Measuring errors of at most [e] change the command by at most |c|_1 e. *)
Theorem TH_LTI_quantization : forall c n q x e, (forall j, Rabs (q j - x j) <= e) ->
  Rabs (convolution c n q - convolution c n x) <= e * response_norm c n.
Proof.
  intros c n q x e E. unfold convolution, response_norm. rewrite <- minus_sum.
  eapply Rle_trans; [apply (Rsum_abs (fun j => c j * q j - c j * x j)) |].
  rewrite scal_sum. apply sum_Rle. intros j _.
  replace (c j * q j - c j * x j) with (c j * (q j - x j)) by ring. rewrite Rabs_mult.
  apply Rmult_le_compat_l; [apply Rabs_pos | apply E].
Qed.

(** TH-LTI (account): the held forces' work over N steps of a motion x_0, ..., x_N after the
    displacements [s], in one sum: -W = H(1)(x_N^2 - x_0^2)/2 - the costs, quantization apart. *)
Definition history (x : nat -> R) (s : nat -> R) (h j : nat) : R :=
  if Nat.leb j h then x (S h - j)%nat - x (h - j)%nat else s (j - h)%nat.

Theorem TH_LTI_account : forall H g L x s N,
  - sum_to N (fun i => - linear_command H g L (x (pred i)) (history x s (pred i))
                        * (x i - x (pred i)))
  = H * (x N ^ 2 / 2 - x 0%nat ^ 2 / 2)
    - sum_to N (fun i => step_cost H g L (x i - x (pred i)) (history x s (pred i))).
Proof.
  intros H g L x s N. induction N as [| N IH]; [simpl; field |].
  rewrite !sum_to_S, Ropp_plus_distr, IH. simpl pred.
  pose proof (TH_LTI_work H g L (x N) (x (S N) - x N) (history x s N)) as W.
  unfold generated, spring_potential in W.
  replace (x N + (x (S N) - x N)) with (x (S N)) in W by ring. lra.
Qed.

(** With held forces [u] that are off by at most [k], the account is off by at most k times the
    way; [k] is e|c|_1 for measuring errors up to [e], and delta/2 more for a D/A step. *)
Theorem TH_LTI_account_quantized : forall H g L x s N u k,
  (forall h, Rabs (u h + linear_command H g L (x h) (history x s h)) <= k) ->
  Rabs (- sum_to N (fun i => u (pred i) * (x i - x (pred i)))
        - (H * (x N ^ 2 / 2 - x 0%nat ^ 2 / 2)
           - sum_to N (fun i => step_cost H g L (x i - x (pred i)) (history x s (pred i)))))
  <= k * sum_to N (fun i => Rabs (x i - x (pred i))).
Proof.
  intros H g L x s N u k E. rewrite <- TH_LTI_account.
  induction N as [| N IH]; [simpl; rewrite Ropp_0, Rminus_0_r, Rabs_R0; lra |].
  rewrite !sum_to_S. simpl pred in *. specialize (E N).
  set (a := sum_to N _) in *. set (b := sum_to N (fun i => - _ * _)) in *.
  set (F := linear_command H g L (x N) (history x s N)) in *. set (d := x (S N) - x N).
  replace (- (a + u N * d) - - (b + - F * d)) with ((- a - - b) + - ((u N + F) * d)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp, Rabs_mult, Rmult_plus_distr_l.
  apply Rplus_le_compat; [exact IH |].
  apply Rmult_le_compat_r; [apply Rabs_pos | exact E].
Qed.

(** The samples before the start that the controller still hears of, and rest before. *)
Definition heard (pos : R -> R) (past : nat -> R) (n j : nat) : R :=
  sample INR pos past 0 (Nat.min j n).

Lemma heard_sample : forall pos past n h j, (j <= h + n)%nat ->
  sample INR pos (heard pos past n) h j = sample INR pos past h j.
Proof.
  intros pos past n h j Hj. unfold sample. destruct (Nat.leb_spec j h); [reflexivity |].
  unfold heard. rewrite Nat.min_l by lia. unfold sample.
  destruct (Nat.leb_spec (j - h) 0); [lia |]. f_equal. lia.
Qed.

Lemma heard_rests : forall pos past n j, (n < j)%nat ->
  step INR pos (heard pos past n) 0 j = 0.
Proof.
  intros pos past n j Hj. unfold step.
  assert (E : forall i, (n <= i)%nat -> sample INR pos (heard pos past n) 0 i
                                        = sample INR pos past 0 n).
  { intros i Hi. destruct i as [| i].
    - replace n with 0%nat by lia. reflexivity.
    - unfold sample at 1. destruct (Nat.leb_spec (S i) 0); [lia |].
      unfold heard. do 2 f_equal. lia. }
  rewrite !E by lia. ring.
Qed.

Section Fir.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (c : nat -> R) (n : nat) (lambda : R) (force_step : option R).
Variables (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
(** H(1) is not negative. *)
Hypothesis sum_nonneg : 0 <= tail c n 0.
(** The cost at no frequency is more than lambda. *)
Hypothesis cost : forall theta, symbol (tail c n 0) (tail c n) n theta <= lambda.

(** The held force of the program, rounded to the D/A step if there is one. *)
Definition held_by_filter (h : nat) : R :=
  stepped force_step (- convolution c n (fun j => measure (sample INR pos past h j))).

Hypothesis O : obeys mu beta sigma INR held_by_filter pos vel friction hand.

Let H := tail c n 0.
Let V := spring_potential H.
Let viscous := beta - lambda.
Let coulomb := sigma - (e * response_norm c n + step_size force_step / 2).

(** What the controller remembers of the last [n] displacements before the start. *)
Definition filter_memory : R :=
  linear_memory H (tail c n) lambda n (step INR pos (heard pos past n) 0).

Lemma filter_bounded : symbol_at_most H (tail c n) lambda.
Proof. apply (symbol_at_most_finite H (tail c n) n); [apply tail_beyond | exact cost]. Qed.

Lemma filter_commanded : forall h,
  Rabs (held_by_filter h
        + linear_command H (tail c n) (h + n) (pos (INR h)) (step INR pos (heard pos past n) h))
  <= e * response_norm c n + step_size force_step / 2.
Proof.
  intro h. set (x := sample INR pos past h). set (q := fun j => measure (x j)).
  assert (E : linear_command H (tail c n) (h + n) (pos (INR h)) (step INR pos (heard pos past n) h)
              = convolution c n x).
  { rewrite (TH_LTI_tails c n (h + n)) by lia. unfold x at 1. rewrite sample_now.
    unfold linear_command. f_equal. apply sum_to_ext. intros j Hj. unfold step, x.
    rewrite !heard_sample by lia. reflexivity. }
  rewrite E. unfold held_by_filter. fold x. change (fun j => measure (x j)) with q.
  replace (stepped force_step (- convolution c n q) + convolution c n x)
    with ((stepped force_step (- convolution c n q) - - convolution c n q)
          + - (convolution c n q - convolution c n x)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp.
  pose proof (stepped_error force_step (- convolution c n q) step_ok).
  pose proof (TH_LTI_quantization c n q x e (fun j => measure_error (x j))). lra.
Qed.

(** TH-LTI: over any number of intervals, ending anywhere, if (beta - lambda)|v| +
    (sigma - e|c|_1 - delta/2) >= 0 at every instant then the operator has put in at least the
    growth of the storage, whatever the motion before the start. *)
Theorem TH_LTI_fir : forall t, 0 <= t ->
  criterion_holds viscous coulomb vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0) + filter_memory)
                       (kinetic mu (vel t) + V (pos t)) t.
Proof.
  exact (linear_run mu beta sigma pos vel friction hand (heard pos past n) held_by_filter H
    (tail c n) lambda _ n P O sum_nonneg filter_bounded (heard_rests pos past n) filter_commanded).
Qed.

(** The same for displacements of at most [Vmax] an interval, with (beta - lambda) Vmax +
    (sigma - e|c|_1 - delta/2) >= 0 and enough Coulomb friction. *)
Theorem TH_LTI_fir_bounded : forall Vmax t, 0 <= t ->
  0 <= coulomb -> 0 <= margin viscous coulomb Vmax -> steps_at_most pos Vmax t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0) + filter_memory)
                       (kinetic mu (vel t) + V (pos t)) t.
Proof.
  exact (linear_run_bounded mu beta sigma pos vel friction hand (heard pos past n) held_by_filter H
    (tail c n) lambda _ n P O filter_bounded (heard_rests pos past n) filter_commanded).
Qed.

(** The memory is not negative, and zero after rest. *)
Theorem TH_LTI_fir_memory : 0 <= filter_memory /\
  ((forall j, past j = pos 0) -> filter_memory = 0).
Proof.
  split; [apply linear_memory_nonneg; [exact filter_bounded | apply heard_rests] |].
  intro R. apply linear_memory_at_rest. intro i.
  assert (E : forall j, sample INR pos (heard pos past n) 0 j = pos 0).
  { assert (E0 : forall j, sample INR pos past 0 j = pos 0)
      by (intros [| j]; unfold sample; simpl; [reflexivity | apply R]).
    intros [| j]; unfold sample; simpl; [reflexivity | apply E0]. }
  unfold step. rewrite !E. ring.
Qed.

(** TH-LTI (every operator): with beta >= lambda and sigma >= e|c|_1 + delta/2 the operator never
    draws more than the storage at the start. *)
Theorem TH_LTI_fir_all_speeds : lambda <= beta -> 0 <= coulomb -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t <= kinetic mu (vel 0) + V (pos 0) + filter_memory.
Proof.
  intros Hb Hc. unfold coulomb in Hc.
  apply (linear_run_all_speeds mu beta sigma pos vel friction hand (heard pos past n)
    held_by_filter H (tail c n) lambda _ n P O sum_nonneg filter_bounded (heard_rests pos past n)
    filter_commanded Hb). lra.
Qed.

End Fir.
