(** * Latency: TH-LATENCY, a force that reaches the device k + f periods after its sample.

    0 < f < 1; the held force changes at 0, f, 1, 1 + f, ..., and what is held from h + f on comes
    from the sample k before sample h.  kappa = ((1/2 + k + f) + sqrt ((1/2 + k + f)^2 +
    f (1 - f)))/2.  The storage is exact: p = f/2 + f (1 - f)/(4 kappa) leaves a square. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ActuatorCost InstantRun.
Open Scope R_scope.

(** When the held force may change. *)
Definition output_time (f : R) (i : nat) : R :=
  INR (Nat.div2 i) + (if Nat.odd i then f else 0).

Lemma even_or_odd : forall i, exists h, i = (2 * h)%nat \/ i = S (2 * h).
Proof.
  intro i. destruct (Nat.Even_or_Odd i) as [[h E] | [h E]]; exists h; [left | right]; lia.
Qed.

Lemma half_even : forall h, Nat.div2 (2 * h) = h /\ Nat.odd (2 * h) = false.
Proof. intro h. split; [apply Nat.div2_double | rewrite Nat.odd_mul; reflexivity]. Qed.

Lemma half_odd : forall h, Nat.div2 (S (2 * h)) = h /\ Nat.odd (S (2 * h)) = true.
Proof.
  intro h. split; [apply Nat.div2_succ_double |].
  rewrite Nat.odd_succ, Nat.even_mul. reflexivity.
Qed.

Lemma time_even : forall f h, output_time f (2 * h) = INR h.
Proof. intros. unfold output_time. destruct (half_even h) as [-> ->]. ring. Qed.

Lemma time_odd : forall f h, output_time f (S (2 * h)) = INR h + f.
Proof. intros. unfold output_time. destruct (half_odd h) as [-> ->]. ring. Qed.

Lemma time_next : forall f h, output_time f (S (S (2 * h))) = INR (S h).
Proof. intros. replace (S (S (2 * h))) with (2 * S h)%nat by lia. apply time_even. Qed.

Lemma time_increasing : forall f, 0 < f < 1 -> increasing (output_time f).
Proof.
  intros f Hf i. destruct (even_or_odd i) as (h & [-> | ->]).
  - rewrite time_even, time_odd. lra.
  - rewrite time_odd, time_next, S_INR. lra.
Qed.

Lemma time_covers : forall f, 0 < f < 1 -> forall t, 0 <= t ->
  exists N, output_time f N <= t <= output_time f (S N).
Proof.
  intros f Hf t Ht. destruct (INR_covers t Ht) as (h & Hh).
  destruct (Rle_lt_dec t (INR h + f)) as [L | L].
  - exists (2 * h)%nat. rewrite time_even, time_odd. lra.
  - exists (S (2 * h)). rewrite time_odd, time_next. lra.
Qed.

Section Latency.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (f : R) (k : nat) (kappa : R) (force_step : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis f_between : 0 < f < 1.
Hypothesis step_ok : step_positive force_step.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
(** [kappa] is enough (TH_LAG_kappa_squares). *)
Hypothesis enough_mean : 0 <= spare_mean kappa (INR k + f).
Hypothesis enough_square : 0 <= spare_square kappa (INR k + f) (latency_variance f).

Let q (h j : nat) : R := measure (sample INR pos past h j).

(** The held force before and after the output changes in interval [h]. *)
Definition held_late (i : nat) : R :=
  let h := Nat.div2 i in
  stepped force_step (- q h (if Nat.odd i then k else S k)).

Hypothesis O : obeys mu beta sigma (output_time f) held_late pos vel friction hand.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let coulomb := e + step_size force_step / 2.
Let p := latency_memory kappa f.
Let r := latency_first kappa f.
Let s (h : nat) : nat -> R := step INR pos past h.
Let moved (h : nat) (t : R) : R := pos t - pos (INR h).
(** How far the sample that is heard of in the second part of interval [h] is behind. *)
Let behind (h : nat) : R := pos (INR h) - sample INR pos past h k.

(** The extra storage in the first part, from what is remembered at the sample. *)
Let first_storage (h : nat) (a : R) : R :=
  extra k (2 * p) (s h) - behind h * a + r * a ^ 2 - p * s h (S k) ^ 2.
Let second_storage (h : nat) (D : R) : R := extra k (2 * p) (push D (s h)).

Let W (i : nat) : R :=
  let h := Nat.div2 i in
  if Nat.odd i then first_storage h (moved h (INR h + f)) else extra k (2 * p) (s h).
Let X (i : nat) (t : R) : R :=
  let h := Nat.div2 i in
  if Nat.odd i then second_storage h (moved h t) else first_storage h (moved h t).

Lemma kappa_positive : 0 < kappa.
Proof. unfold spare_mean in enough_mean. pose proof (pos_INR k). lra. Qed.

Lemma memory_positive : 0 < p.
Proof.
  unfold p, latency_memory. pose proof kappa_positive.
  assert (0 < f * (1 - f) / (4 * kappa)) by (apply Rdiv_lt_0_compat; nra). lra.
Qed.

Lemma coulomb_nonneg : 0 <= coulomb.
Proof.
  unfold coulomb. pose proof (measure_error 0). pose proof (Rabs_pos (measure 0 - 0)).
  assert (0 <= step_size force_step) by (destruct force_step; simpl in *; lra). lra.
Qed.

Lemma held_error : forall h j, Rabs (stepped force_step (- q h j) + sample INR pos past h j) <= coulomb.
Proof.
  intros h j. pose proof (stepped_error force_step (- q h j) step_ok) as A.
  pose proof (measure_error (sample INR pos past h j)) as B. fold (q h j) in B.
  replace (stepped force_step (- q h j) + sample INR pos past h j)
    with ((stepped force_step (- q h j) - - q h j) + - (q h j - sample INR pos past h j)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. unfold coulomb. lra.
Qed.

Lemma error_work : forall h j d,
  (stepped force_step (- q h j) + sample INR pos past h j) * d <= coulomb * Rabs d.
Proof.
  intros h j d. eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
  apply Rmult_le_compat_r; [apply Rabs_pos | apply held_error].
Qed.

Lemma late_arrives : forall i, X i (output_time f (S i)) = W (S i).
Proof.
  intro i. destruct (even_or_odd i) as (h & [-> | ->]).
  - unfold X, W. destruct (half_even h) as [-> ->]. destruct (half_odd h) as [-> ->].
    rewrite time_odd. reflexivity.
  - unfold X, W. destruct (half_odd h) as [-> ->].
    replace (S (S (2 * h))) with (2 * S h)%nat by lia.
    destruct (half_even (S h)) as [-> ->]. rewrite time_even.
    apply extra_ext. intros j Hj. symmetry. apply step_next. exact Hj.
Qed.

(** The first part of an interval. *)
Lemma first_charge : forall h t, let a := moved h t in
  generated (stepped force_step (- q h (S k))) (pos (INR h)) (pos t)
            (linear_potential (pos (INR h))) (linear_potential (pos t))
  + first_storage h a - extra k (2 * p) (s h)
  <= kappa * (a ^ 2 / f) + coulomb * Rabs a.
Proof.
  intros h t a. pose proof (latency_first_part kappa f (s h (S k)) a f_between kappa_positive) as L.
  fold p r in L. pose proof (error_work h (S k) a) as E.
  assert (Y : pos (INR h) - sample INR pos past h (S k) = behind h + s h (S k))
    by (unfold behind, s, step; simpl pred; ring).
  unfold generated, linear_potential, first_storage.
  replace (pos t) with (pos (INR h) + a) by (unfold a, moved; ring).
  replace (sample INR pos past h (S k)) with (pos (INR h) - behind h - s h (S k)) in E by lra.
  set (F := stepped force_step (- q h (S k))) in *. nra.
Qed.

(** The second part, after [a] in the first. *)
Lemma second_charge : forall h a b,
  b ^ 2 / 2 + (behind h + a) * b + second_storage h (a + b) - first_storage h a
  <= kappa * (b ^ 2 / (1 - f)).
Proof.
  intros h a b.
  pose proof (latency_second_part kappa f (INR k) a b f_between (pos_INR k) enough_mean
    enough_square) as L. fold p r in L.
  unfold second_storage, first_storage, extra.
  pose proof (delay_storage_push k (a + b) (s h)) as D1.
  pose proof (damping_storage_push k (2 * p) (a + b) (s h)) as D2.
  pose proof (path_by_squares k (a + b) (s h)) as Ps.
  assert (Z : behind h * (a + b) <= Rabs (a + b) * sum_to k (fun j => Rabs (s h j))).
  { eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat_l; [apply Rabs_pos | apply delayed_distance]. }
  set (sq := sum_to k (fun j => s h j ^ 2)) in *.
  set (path := Rabs (a + b) * sum_to k (fun j => Rabs (s h j))) in *. lra.
Qed.

Lemma late_end : forall i t, 0 <= X i t.
Proof.
  intros i t. pose proof memory_positive as P0.
  assert (S0 : forall h D, 0 <= second_storage h D) by (intros; apply extra_nonneg; lra).
  unfold X. destruct (Nat.odd i); [apply S0 |].
  set (h := Nat.div2 i). set (a := moved h t).
  pose proof (second_charge h a 0) as C. rewrite Rplus_0_r in C. specialize (S0 h a).
  replace (0 ^ 2 / (1 - f)) with 0 in C by (field; lra). lra.
Qed.

(** The pay of each part. *)
Lemma late_charge : forall i t, output_time f i <= t <= output_time f (S i) ->
  (forall u, output_time f i <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - kappa) (sigma - coulomb) (vel u)) ->
  generated (held_late i) (pos (output_time f i)) (pos t)
            (linear_potential (pos (output_time f i))) (linear_potential (pos t)) + X i t - W i
  <= dissipated beta sigma vel (output_time f i) t.
Proof.
  intros i t Ht H8. pose proof kappa_positive as K0. pose proof coulomb_nonneg as C0.
  destruct (even_or_odd i) as (h & [-> | ->]).
  - rewrite time_odd, time_even in Ht. rewrite time_even in *.
    unfold held_late, X, W. destruct (half_even h) as [-> ->].
    eapply Rle_trans; [apply first_charge |].
    apply (instant_charge beta sigma kappa coulomb pos vel K); lra || exact H8.
  - rewrite time_odd, time_next, S_INR in Ht. rewrite time_odd in *.
    unfold held_late, X, W. destruct (half_odd h) as [-> ->].
    eapply Rle_trans; [| apply (instant_charge beta sigma kappa coulomb pos vel K _ _ (1 - f));
      lra || exact H8].
    set (a := moved h (INR h + f)). set (b := pos t - pos (INR h + f)).
    pose proof (second_charge h a b) as C. pose proof (error_work h k b) as E.
    replace (moved h t) with (a + b) by (unfold a, b, moved; ring).
    unfold generated, linear_potential. set (F := stepped force_step (- q h k)) in *.
    replace (sample INR pos past h k) with (pos (INR h + f) - a - behind h) in E
      by (unfold a, behind, moved; ring).
    replace (pos t) with (pos (INR h + f) + b) by (unfold b; ring).
    replace (pos (INR h + f) + b - pos (INR h + f)) with b by ring. nra.
Qed.

(** What is remembered of the last k + 1 displacements before the start. *)
Definition latency_extra : R := extra k (2 * latency_memory kappa f) (step INR pos past 0).

(** TH-LATENCY: if (beta - kappa)|v| + (sigma - e - delta/2) >= 0 at every instant, the operator
    has put in at least the growth of the storage, over any number of intervals, ending anywhere. *)
Theorem TH_LATENCY : forall t, 0 <= t ->
  criterion_holds (beta - kappa) (sigma - coulomb) vel t ->
  passive_run vel hand (storage mu (pos 0) (vel 0) + latency_extra)
                       (storage mu (pos t) (vel t)) t.
Proof.
  intros t Ht H8. destruct (time_covers f f_between t Ht) as (N & HN).
  assert (T0 : output_time f 0 = 0) by apply (time_even f 0).
  pose proof (time_increasing f f_between) as T.
  destruct (EQ_14_run mu beta sigma (output_time f) held_late pos vel friction hand P O
    linear_potential W X T late_arrives N t HN) as (I & E).
  - intros i u Hr. destruct (reached_range _ T N t HN i u Hr) as (R0 & R1 & R2).
    assert (R3 : output_time f i <= u).
    { destruct Hr as [[_ ->] | [-> ->]]; [pose proof (T i); lra | lra]. }
    apply late_charge; [lra |]. intros w Hw. apply H8. lra.
  - rewrite T0 in *. pose proof (late_end N t). split; [exact I |].
    change (W 0%nat) with latency_extra in E. unfold storage. lra.
Qed.

(** TH-LATENCY (every operator): with beta >= kappa and sigma >= e + delta/2 the operator never
    draws more than the storage at the start. *)
Theorem TH_LATENCY_all_speeds : kappa <= beta -> coulomb <= sigma -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t <= storage mu (pos 0) (vel 0) + latency_extra.
Proof.
  intros Hb Hc t Ht.
  assert (C : criterion_holds (beta - kappa) (sigma - coulomb) vel t)
    by (apply enough_at_all_speeds; lra).
  destruct (TH_LATENCY t Ht C) as [_ E].
  pose proof (storage_nonneg mu (pos t) (vel t) (mu_positive _ _ _ P)). lra.
Qed.

(** After rest nothing is remembered. *)
Theorem TH_LATENCY_rested : (forall j, past j = pos 0) -> latency_extra = 0.
Proof. intro R. apply TH_DELAY_TH_DAMP_at_rest. exact R. Qed.

End Latency.
