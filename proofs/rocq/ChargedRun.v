(** * ChargedRun: a run in which every step is charged.

    Each interval generates, with what an extra storage grows by, at most need d^2 + coulomb |d|
    for its displacement d.  Then the operator has put in at least the growth of the storage, if
    friction pays the charges: at every length of interval (TH-JITTER), by (8) at every instant,
    or for displacements up to a bound.  The effects differ in the storage only. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model History Combined Passivity Effects.
Open Scope R_scope.

Section Charged.

Variables mu beta sigma need coulomb : R.
Variables ts held : nat -> R.
Variables pos vel friction hand : R -> R.
Variables (V : R -> R) (W : nat -> R) (X : nat -> R -> R).
Hypothesis P : physical mu beta sigma.
Hypothesis T : increasing ts.
Hypothesis O : obeys mu beta sigma ts held pos vel friction hand.
(** [W] is the extra storage at the samples, [X h] that on the way from sample h to the next. *)
Hypothesis arrives : forall h, X h (ts (S h)) = W (S h).
Hypothesis charge : forall h t, ts h <= t <= ts (S h) ->
  generated (held h) (pos (ts h)) (pos t) (V (pos (ts h))) (V (pos t)) + X h t - W h
  <= need * (pos t - pos (ts h)) ^ 2 + coulomb * Rabs (pos t - pos (ts h)).

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.

Lemma charged_run_jitter : forall N t, ts N <= t <= ts (S N) ->
  (forall h r, reached ts N t h r -> ts h < r ->
     0 <= jitter_surplus beta need (sigma - coulomb) (pos r - pos (ts h)) (r - ts h)) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + X N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + W 0%nat
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros N t Ht Hs.
  apply (EQ_14_run mu beta sigma ts held pos vel friction hand P O V W X T arrives N t Ht).
  intros h r Hr.
  assert (R1 : ts h <= r <= ts (S h)).
  { destruct Hr as [[_ ->] | [-> ->]]; [pose proof (T h); lra | lra]. }
  pose proof (charge h r R1) as C. destruct (Req_dec (ts h) r) as [E | E].
  - rewrite <- E in *. unfold dissipated. rewrite RInt_point. change zero with 0.
    replace (pos (ts h) - pos (ts h)) with 0 in C by ring. rewrite Rabs_R0 in C. lra.
  - specialize (Hs h r Hr ltac:(lra)).
    pose proof (EQ_26 pos vel K beta sigma (ts h) r ltac:(lra) (beta_nonneg _ _ _ P)
      (sigma_nonneg _ _ _ P)) as D.
    unfold jitter_surplus in Hs. unfold dissipated_lower in D.
    set (d := pos r - pos (ts h)) in *.
    replace (beta * d ^ 2 / (r - ts h)) with (beta / (r - ts h) * d ^ 2) in D by (field; lra).
    lra.
Qed.

Hypothesis J : on_time ts.
Hypothesis need_nonneg : 0 <= need.

(** By (8), with this need, at every instant. *)
Lemma charged_run : forall N t, ts N <= t <= ts (S N) ->
  (forall u, ts 0%nat <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - need) (sigma - coulomb) (vel u)) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + X N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + W 0%nat
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros N t Ht H8. apply charged_run_jitter; [exact Ht |]. intros h r Hr Hlt.
  destruct (reached_range ts T N t Ht h r Hr) as (R0 & R1 & R2). pose proof (J h) as Jh.
  eapply Rle_trans; [| apply TH_JITTER_on_time; [exact need_nonneg | lra]].
  apply (EQ_8_to_27 _ _ _ pos vel K); [exact Hlt |].
  intros u Hu. apply H8. lra.
Qed.

(** For displacements up to [Vmax] an interval. *)
Lemma charged_run_bounded : forall Vmax N t, ts N <= t <= ts (S N) ->
  0 <= sigma - coulomb -> 0 <= margin (beta - need) (sigma - coulomb) Vmax ->
  (forall h r, reached ts N t h r -> Rabs (pos r - pos (ts h)) <= Vmax) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + X N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + W 0%nat
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros Vmax N t Ht Hc Hm Hd. apply charged_run_jitter; [exact Ht |]. intros h r Hr Hlt.
  specialize (Hd h r Hr).
  destruct (reached_range ts T N t Ht h r Hr) as (_ & _ & R2). pose proof (J h) as Jh.
  unfold jitter_surplus, margin in *. set (d := pos r - pos (ts h)) in *.
  pose proof (Rabs_pos d) as D0. rewrite <- (pow2_abs d). set (w := Rabs d) in *.
  pose proof (beta_nonneg _ _ _ P) as B0.
  assert (B1 : beta <= beta / (r - ts h)).
  { apply Rmult_le_reg_r with (r - ts h); [lra |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
  replace ((beta / (r - ts h) - need) * w ^ 2 + (sigma - coulomb) * w)
    with (w * ((beta / (r - ts h) - need) * w + (sigma - coulomb))) by ring.
  apply Rmult_le_pos; [exact D0 |].
  destruct (Rle_lt_dec 0 (beta - need)) as [S | S].
  - assert (0 <= (beta / (r - ts h) - need) * w) by (apply Rmult_le_pos; lra). lra.
  - assert ((beta - need) * Vmax <= (beta - need) * w) by nra.
    assert ((beta - need) * w <= (beta / (r - ts h) - need) * w) by (apply Rmult_le_compat_r; lra).
    lra.
Qed.

End Charged.

(** No interval that a run up to [t] reaches moves the device by more than [Vmax]. *)
Definition steps_at_most (pos : R -> R) (Vmax t : R) : Prop :=
  forall N h r, INR N <= t <= INR (S N) -> reached INR N t h r ->
  Rabs (pos r - pos (INR h)) <= Vmax.
