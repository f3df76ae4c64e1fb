(** * OnePole: TH-LTI for virtual damping behind a one-pole filter, by one square.

    The velocity is smoothed, w_(h+1) = a w_h + (1 - a) D_h, and the force is -(q_h + B w_h).
    Damping B then costs B rho of viscous friction, rho = (1 - a)/(1 + a), and with an encoder
    B (1 - a) of Coulomb friction. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller ChargedRun.
Open Scope R_scope.

Definition filtered_step (a w d : R) : R := a * w + (1 - a) * d.
Definition filter_share (a : R) : R := (1 - a) / (1 + a).
Definition filter_storage (a w : R) : R := w ^ 2 / (2 * (1 - a)).

(** TH-LTI (one pole): what a step has to spare is a square. *)
Theorem TH_LTI_one_pole_square : forall a w d, 0 <= a < 1 ->
  d * w + filter_share a * d ^ 2
  - (filter_storage a (filtered_step a w d) - filter_storage a w)
  = ((1 + a) * w + (1 - a) * d) ^ 2 / (2 * (1 + a)).
Proof.
  intros a w d Ha. unfold filter_share, filter_storage, filtered_step. field. lra.
Qed.

Theorem TH_LTI_one_pole_step : forall a w d, 0 <= a < 1 ->
  filter_storage a (filtered_step a w d) - filter_storage a w <= d * w + filter_share a * d ^ 2.
Proof.
  intros a w d Ha. pose proof (TH_LTI_one_pole_square a w d Ha) as E.
  assert (0 <= ((1 + a) * w + (1 - a) * d) ^ 2 / (2 * (1 + a))).
  { apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]. }
  lra.
Qed.

(** Summed over any motion of N steps. *)
Theorem TH_LTI_one_pole_sum : forall a (w d : nat -> R) N, 0 <= a < 1 ->
  (forall h, w (S h) = filtered_step a (w h) (d h)) ->
  - sum_to N (fun i => d (pred i) * w (pred i))
  <= filter_share a * sum_to N (fun i => d (pred i) ^ 2) + filter_storage a (w 0%nat)
     - filter_storage a (w N).
Proof.
  intros a w d N Ha E. induction N as [| N IH]; [simpl; lra |].
  rewrite !sum_to_S. simpl pred.
  pose proof (TH_LTI_one_pole_step a (w N) (d N) Ha) as St. rewrite <- E in St. lra.
Qed.

(** The smoothed velocity from the last [n] displacements of the positions [x] before, x j that j
    samples ago; the device rested before. *)
Fixpoint smoothed (a : R) (n : nat) (x : nat -> R) : R :=
  match n with
  | O => 0
  | S p => filtered_step a (smoothed a p (fun j => x (S j))) (x 0%nat - x 1%nat)
  end.

(** The response of 1 + B (1 - 1/z)(1 - a)/(1 - a/z): c_0 and c_1, c_2, ...; the absolute values
    of the first n + 1 terms. *)
Definition one_pole_response (a B : R) (j : nat) : R :=
  match j with O => 1 + B * (1 - a) | S i => - (B * (1 - a) ^ 2 * a ^ i) end.

Theorem TH_LTI_one_pole_norm : forall a B n, 0 <= a < 1 -> 0 <= B ->
  sum_f_R0 (fun j => Rabs (one_pole_response a B j)) n
  = 1 + 2 * (B * (1 - a)) - B * (1 - a) * a ^ n.
Proof.
  intros a B n Ha HB. induction n as [| n IH].
  - simpl. rewrite Rabs_right; [ring |]. assert (0 <= B * (1 - a)) by nra. lra.
  - rewrite tech5, IH. simpl one_pole_response. rewrite Rabs_Ropp, Rabs_right.
    + simpl. ring.
    + apply Rle_ge. apply Rmult_le_pos; [| apply pow_le; lra].
      apply Rmult_le_pos; [exact HB | apply pow2_ge_0].
Qed.

(** The command of the program is the response's, cut off at the oldest displacement. *)
Theorem TH_LTI_one_pole_response : forall a B n x,
  x 0%nat + B * smoothed a n x
  = sum_f_R0 (fun j => one_pole_response a B j * x j) n - B * (1 - a) * a ^ n * x n.
Proof.
  intros a B n x.
  assert (G : forall n x, B * smoothed a n x
    = sum_f_R0 (fun j => one_pole_response a B j * x j) n - x 0%nat - B * (1 - a) * a ^ n * x n).
  { clear n x. induction n as [| n IH]; intro x; [simpl; ring |].
    simpl smoothed. unfold filtered_step. rewrite Rmult_plus_distr_l.
    replace (B * (a * smoothed a n (fun j => x (S j))))
      with (a * (B * smoothed a n (fun j => x (S j)))) by ring.
    rewrite IH. rewrite (decomp_sum _ (S n)) by lia. simpl pred.
    rewrite (sum_eq (fun i => one_pole_response a B (S i) * x (S i))
      (fun i => (one_pole_response a B i * x (S i)) * a
        + (if Nat.eqb i 0 then - (B * (1 - a) + a) * x (S i) else 0))).
    - rewrite plus_sum, <- scal_sum.
      assert (Z : forall m, sum_f_R0 (fun i => if Nat.eqb i 0
        then - (B * (1 - a) + a) * x (S i) else 0) m = - (B * (1 - a) + a) * x 1%nat).
      { induction m as [| m IHm]; [reflexivity |]. rewrite tech5, IHm. simpl. ring. }
      rewrite Z. simpl. ring.
    - intros [| i] _; simpl; ring. }
  rewrite G. ring.
Qed.

(** TH-LTI (one pole, quantization): measuring errors of at most [e] change the command by at most
    e + 2 e B (1 - a), 1/2 + B (1 - a) with an encoder, however long the motion before. *)
Lemma smoothed_error : forall a n q x e, 0 <= a < 1 -> (forall j, Rabs (q j - x j) <= e) ->
  exists r, Rabs r <= e /\
  smoothed a n q - smoothed a n x = (1 - a) * ((q 0%nat - x 0%nat) - r).
Proof.
  intros a n. induction n as [| n IH]; intros q x e Ha E.
  - exists (q 0%nat - x 0%nat). split; [apply E | simpl; ring].
  - destruct (IH (fun j => q (S j)) (fun j => x (S j)) e Ha (fun j => E (S j))) as (r & Hr & Er).
    exists ((1 - a) * (q 1%nat - x 1%nat) + a * r). split.
    + eapply Rle_trans; [apply Rabs_triang |]. rewrite !Rabs_mult.
      rewrite (Rabs_right (1 - a)), (Rabs_right a) by lra.
      pose proof (E 1%nat). pose proof (Rabs_pos r). nra.
    + simpl smoothed. unfold filtered_step in *. cbv beta in Er.
      replace (a * smoothed a n (fun j => q (S j)) + (1 - a) * (q 0%nat - q 1%nat)
        - (a * smoothed a n (fun j => x (S j)) + (1 - a) * (x 0%nat - x 1%nat)))
        with (a * (smoothed a n (fun j => q (S j)) - smoothed a n (fun j => x (S j)))
          + (1 - a) * ((q 0%nat - x 0%nat) - (q 1%nat - x 1%nat))) by ring.
      rewrite Er. ring.
Qed.

Theorem TH_LTI_one_pole_quantization : forall a B n q x e, 0 <= a < 1 -> 0 <= B ->
  (forall j, Rabs (q j - x j) <= e) ->
  Rabs ((q 0%nat + B * smoothed a n q) - (x 0%nat + B * smoothed a n x))
  <= e + 2 * e * (B * (1 - a)).
Proof.
  intros a B n q x e Ha HB E. destruct (smoothed_error a n q x e Ha E) as (r & Hr & Er).
  replace (q 0%nat + B * smoothed a n q - (x 0%nat + B * smoothed a n x))
    with ((q 0%nat - x 0%nat) + B * (1 - a) * ((q 0%nat - x 0%nat) - r))
    by (replace (smoothed a n q)
      with (smoothed a n x + (1 - a) * ((q 0%nat - x 0%nat) - r)) by lra; ring).
  set (e0 := q 0%nat - x 0%nat). assert (E0 : Rabs e0 <= e) by apply E.
  assert (B1 : 0 <= B * (1 - a)) by nra.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite (Rabs_mult (B * (1 - a))), (Rabs_right (B * (1 - a)))
    by lra.
  assert (Rabs (e0 - r) <= 2 * e).
  { unfold Rminus. eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. lra. }
  nra.
Qed.

Section Run.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (a B : R) (m : nat) (force_step : option R) (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis pole : 0 <= a < 1.
Hypothesis B_nonneg : 0 <= B.
Hypothesis step_ok : step_positive force_step.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.

(** The held force of the program; the filter had rested until [m] samples before the start. *)
Definition held_by_one_pole (h : nat) : R :=
  let q j := measure (sample INR pos past h j) in
  stepped force_step (- (q 0%nat + B * smoothed a (h + m) q)).

Hypothesis O : obeys mu beta sigma INR held_by_one_pole pos vel friction hand.

Let need := 1 / 2 + B * filter_share a.
Let coulomb := e + 2 * e * (B * (1 - a)) + step_size force_step / 2.
Let w (h : nat) : R := smoothed a (h + m) (sample INR pos past h).
Let W (h : nat) : R := B * filter_storage a (w h).
Let X (h : nat) (t : R) : R := B * filter_storage a (filtered_step a (w h) (pos t - pos (INR h))).

(** What the filter remembers of the motion before the start. *)
Definition one_pole_memory : R := B * filter_storage a (smoothed a m (sample INR pos past 0)).

Lemma filter_storage_nonneg : forall v, 0 <= filter_storage a v.
Proof. intro v. apply Rdiv_le_0_compat; [apply pow2_ge_0 | lra]. Qed.

Lemma one_pole_arrives : forall h, X h (INR (S h)) = W (S h).
Proof.
  intro h. unfold X, W. do 2 f_equal. unfold w. simpl (S h + m)%nat. simpl smoothed.
  rewrite sample_now. change (sample INR pos past (S h) 1) with (sample INR pos past h 0).
  rewrite sample_now. reflexivity.
Qed.

Lemma one_pole_charge : forall h t, INR h <= t <= INR (S h) ->
  generated (held_by_one_pole h) (pos (INR h)) (pos t)
            (linear_potential (pos (INR h))) (linear_potential (pos t)) + X h t - W h
  <= need * (pos t - pos (INR h)) ^ 2 + coulomb * Rabs (pos t - pos (INR h)).
Proof.
  intros h t _. set (d := pos t - pos (INR h)). set (x := sample INR pos past h).
  set (q := fun j => measure (x j)).
  pose proof (TH_LTI_one_pole_step a (w h) d pole) as St.
  pose proof (TH_LTI_one_pole_quantization a B (h + m) q x e pole B_nonneg
    (fun j => measure_error (x j))) as Q.
  pose proof (stepped_error force_step (- (q 0%nat + B * smoothed a (h + m) q)) step_ok) as R.
  unfold held_by_one_pole. fold x. change (fun j => measure (x j)) with q.
  change (measure (x 0%nat)) with (q 0%nat).
  set (F := stepped force_step (- (q 0%nat + B * smoothed a (h + m) q))) in *.
  change (smoothed a (h + m) x) with (w h) in Q.
  assert (X0 : x 0%nat = pos (INR h)) by apply sample_now. rewrite X0 in Q.
  assert (E : (F + (pos (INR h) + B * w h)) * d <= coulomb * Rabs d).
  { eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos |].
    replace (F + (pos (INR h) + B * w h))
      with ((F - - (q 0%nat + B * smoothed a (h + m) q))
            + - (q 0%nat + B * smoothed a (h + m) q - (pos (INR h) + B * w h))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. unfold coulomb. lra. }
  unfold X, W. fold d. apply (Rmult_le_compat_l B) in St; [| exact B_nonneg].
  unfold generated, linear_potential, need. fold d.
  replace (pos t) with (pos (INR h) + d) by (unfold d; ring). lra.
Qed.

(** TH-LTI (one pole): with damping B behind the filter the criterion is
    (beta - 1/2 - B rho)|v| + (sigma - 1/2 - B (1 - a) - delta/2) >= 0. *)
Theorem TH_LTI_one_pole : forall t, 0 <= t ->
  criterion_holds (beta - need) (sigma - coulomb) vel t ->
  passive_run vel hand (storage mu (pos 0) (vel 0) + one_pole_memory)
                       (storage mu (pos t) (vel t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  assert (N0 : 0 <= need).
  { unfold need, filter_share. assert (0 <= (1 - a) / (1 + a)) by (apply Rdiv_le_0_compat; lra).
    assert (0 <= B * ((1 - a) / (1 + a))) by (apply Rmult_le_pos; assumption). lra. }
  destruct (charged_run mu beta sigma need coulomb INR held_by_one_pole pos vel friction hand
    linear_potential W X P INR_increasing O one_pole_arrives one_pole_charge INR_on_time N0 N t HN)
    as (I & E).
  - simpl (INR 0). exact H8.
  - assert (0 <= X N t) by (apply Rmult_le_pos; [exact B_nonneg | apply filter_storage_nonneg]).
    simpl (INR 0) in *. split; [exact I |]. unfold storage.
    change (W 0%nat) with one_pole_memory in E. lra.
Qed.

(** After rest the filter remembers nothing. *)
Theorem TH_LTI_one_pole_rested : (forall j, past j = pos 0) -> one_pole_memory = 0.
Proof.
  intro R. unfold one_pole_memory.
  assert (E : forall x, (forall j, x j = pos 0) -> forall n, smoothed a n x = 0).
  { intros x Hx n. revert x Hx. induction n as [| n IH]; intros x Hx; [reflexivity |].
    simpl. rewrite IH by (intro; apply Hx). rewrite !Hx. unfold filtered_step. ring. }
  rewrite E; [unfold filter_storage; field; lra |].
  intros [| j]; unfold sample; simpl; [reflexivity | apply R].
Qed.

End Run.
