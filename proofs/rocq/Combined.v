(** * Combined: delay, damping, D/A step, quantizer and any 1-Lipschitz law at once.

    The general theorem; TH-RUN, TH-LAW, TH-UNI, TH-DAC, TH-DELAY, TH-DAMP and TH-SMOOTH
    are its instances (Effects.v). *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law.
Open Scope R_scope.

(** What a rendered wall is made of; see Law.v. *)
Record wall (f V : R -> R) (B delta e : R) : Prop := {
  law_lipschitz : lipschitz f;
  damping_nonneg : 0 <= B;
  step_nonneg : 0 <= delta;
  error_nonneg : 0 <= e;
  law_potential : potential f V
}.

(** The held forces are the wall's, from measured positions [k] samples late. *)
Definition rendered (f : R -> R) (B delta e : R) (k : nat)
    (ts : nat -> R) (pos : R -> R) (past : nat -> R) (held : nat -> R) : Prop :=
  forall h, exists q q',
    Rabs (q - sample ts pos past h k) <= e /\
    Rabs (q' - sample ts pos past h (S k)) <= e /\
    commands f B delta q q' (- held h).

(** Extra storage at sample [h], and on the way to the next one. *)
Definition extra (k : nat) (B : R) (d : nat -> R) : R :=
  delay_storage k d + damping_storage k B d.

Definition extra_at (ts : nat -> R) (pos : R -> R) (past : nat -> R) k B (h : nat) : R :=
  extra k B (step ts pos past h).

Definition extra_towards (ts : nat -> R) (pos : R -> R) (past : nat -> R) k B
    (h : nat) (t : R) : R :=
  extra k B (push (pos t - pos (ts h)) (step ts pos past h)).

Lemma extra_nonneg : forall k B d, 0 <= B -> 0 <= extra k B d.
Proof.
  intros. unfold extra. pose proof (delay_storage_nonneg k d).
  pose proof (damping_storage_nonneg k B d). lra.
Qed.

Lemma extra_ext : forall k B d d', (forall j, (1 <= j)%nat -> d j = d' j) ->
  extra k B d = extra k B d'.
Proof.
  intros k B d d' H. unfold extra, delay_storage, damping_storage.
  rewrite (sum_to_ext k _ (fun j => (INR k - INR j + 1) * d' j ^ 2 / 2)).
  - rewrite (sum_to_ext (S k) _ (fun j => d' j ^ 2)); [reflexivity |].
    intros j [Hj _]. rewrite H by exact Hj. reflexivity.
  - intros j [Hj _]. rewrite H by exact Hj. reflexivity.
Qed.

Lemma extra_arrives : forall ts pos past k B h,
  extra_towards ts pos past k B h (ts (S h)) = extra_at ts pos past k B (S h).
Proof.
  intros. unfold extra_towards, extra_at. apply extra_ext.
  intros j Hj. symmetry. apply step_next. exact Hj.
Qed.

Section Combination.

Variables mu beta sigma : R.
Variables (f V : R -> R) (B delta e : R) (k : nat).
Variables ts held past : nat -> R.
Variables pos vel friction hand : R -> R.
Hypothesis P : physical mu beta sigma.
Hypothesis T : increasing ts.
Hypothesis L : wall f V B delta e.
Hypothesis O : obeys mu beta sigma ts held pos vel friction hand.
Hypothesis D : rendered f B delta e k ts pos past held.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.

(** TH-JITTER (one interval): what friction takes, less what is generated and what the
    extra storage grows by, is at least the surplus, whatever the interval's length. *)
Theorem TH_JITTER_interval : forall h t, ts h < t ->
  jitter_surplus beta (viscous_need (INR k) B) (sigma - coulomb_need e delta B)
                 (pos t - pos (ts h)) (t - ts h)
  <= dissipated beta sigma vel (ts h) t
     - (generated (held h) (pos (ts h)) (pos t) (V (pos (ts h))) (V (pos t))
        + extra_towards ts pos past k B h t - extra_at ts pos past k B h).
Proof.
  intros h t Ht. destruct (D h) as (q & q' & Hq & Hq' & C).
  pose proof (generated_combined f V B delta e k (law_lipschitz _ _ _ _ _ L)
    (damping_nonneg _ _ _ _ _ L)
    (potential_derivative _ _ (law_potential _ _ _ _ _ L))
    (pos (ts h)) (pos t) _ _ q q' (- held h) (step ts pos past h) C Hq Hq'
    (delayed_distance ts pos past h k) eq_refl) as G.
  cbv zeta in G. rewrite Ropp_involutive in G.
  pose proof (EQ_26 pos vel K beta sigma (ts h) t Ht (beta_nonneg _ _ _ P) (sigma_nonneg _ _ _ P)) as E.
  unfold extra_towards, extra_at, extra. unfold jitter_surplus, dissipated_lower in *.
  set (d := pos t - pos (ts h)) in *.
  replace ((beta / (t - ts h) - viscous_need (INR k) B) * d ^ 2)
    with (beta * d ^ 2 / (t - ts h) - viscous_need (INR k) B * d ^ 2) by (field; lra).
  lra.
Qed.

(** At the sample itself nothing is generated and the extra storage does not grow. *)
Lemma at_sample : forall h,
  generated (held h) (pos (ts h)) (pos (ts h)) (V (pos (ts h))) (V (pos (ts h)))
  + extra_towards ts pos past k B h (ts h) - extra_at ts pos past k B h
  <= dissipated beta sigma vel (ts h) (ts h).
Proof.
  intro h. unfold dissipated. rewrite RInt_point. change zero with 0.
  unfold extra_towards, extra_at, extra, generated.
  pose proof (delay_storage_push k (pos (ts h) - pos (ts h)) (step ts pos past h)) as H1.
  pose proof (damping_storage_push k B (pos (ts h) - pos (ts h)) (step ts pos past h)) as H2.
  pose proof (damping_nonneg _ _ _ _ _ L).
  assert (0 <= sum_to k (fun j => step ts pos past h j ^ 2))
    by (apply sum_to_nonneg; intros; apply pow2_ge_0).
  assert (0 <= B * step ts pos past h (S k) ^ 2)
    by (apply Rmult_le_pos; [assumption | apply pow2_ge_0]).
  replace (pos (ts h) - pos (ts h)) with 0 in * by ring. lra.
Qed.

(** TH-JITTER (runs) and the combination of all effects: over any number of intervals of
    any length, ending anywhere, if every interval reached has a surplus, the operator has
    put in at least the growth of the storage. *)
Theorem TH_COMBINED_jitter : forall N t, ts N <= t <= ts (S N) ->
  (forall h r, reached ts N t h r -> ts h < r ->
     0 <= jitter_surplus beta (viscous_need (INR k) B) (sigma - coulomb_need e delta B)
                         (pos r - pos (ts h)) (r - ts h)) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + extra_towards ts pos past k B N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + extra_at ts pos past k B 0
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros N t Ht Hs.
  apply (EQ_14_run mu beta sigma ts held pos vel friction hand P O V
           (extra_at ts pos past k B) (extra_towards ts pos past k B) T
           (extra_arrives ts pos past k B) N t Ht).
  intros h r Hr. destruct (Req_dec (ts h) r) as [E | E].
  - rewrite <- E. apply at_sample.
  - assert (R1 : ts h < r).
    { destruct Hr as [[_ ->] | [-> ->]]; [apply T | lra]. }
    specialize (Hs h r Hr R1). pose proof (TH_JITTER_interval h r R1). lra.
Qed.

End Combination.

(** ** From the criterion (8) to the surplus of an interval *)

Section Criterion.

Variables beta need coulomb : R.
Variables pos vel : R -> R.
Hypothesis K : kinematic pos vel.
Hypothesis need_nonneg : 0 <= need.

(** EQ-27: the surplus of (27) is |d| times the margin of (8) at the mean speed. *)
Theorem EQ_27 : forall viscous d dtau, 0 < dtau ->
  surplus viscous coulomb d dtau = Rabs d * margin viscous coulomb (mean_speed d dtau).
Proof.
  intros. unfold surplus, margin, mean_speed.
  rewrite <- (pow2_abs d). field. lra.
Qed.

(** TH-JITTER (on time): for an interval of at most one period the criterion's surplus
    is no more than the interval's. *)
Theorem TH_JITTER_on_time : forall d dtau, 0 < dtau <= 1 ->
  surplus (beta - need) coulomb d dtau <= jitter_surplus beta need coulomb d dtau.
Proof.
  intros d dtau H. unfold surplus, jitter_surplus.
  replace ((beta - need) * d ^ 2 / dtau) with (beta / dtau * d ^ 2 - need * (d ^ 2 / dtau))
    by (field; lra).
  assert (d ^ 2 <= d ^ 2 / dtau).
  { pose proof (pow2_ge_0 d). apply Rmult_le_reg_r with dtau; [lra |].
    unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
  pose proof (Rmult_le_compat_l need _ _ need_nonneg H0). lra.
Qed.

(** (8) at every instant of an interval gives (27) for it (the mean-value step (28)). *)
Theorem EQ_8_to_27 : forall s t, s < t ->
  (forall u, s <= u <= t -> vel u <> 0 -> 0 <= margin_8 (beta - need) coulomb (vel u)) ->
  0 <= surplus (beta - need) coulomb (pos t - pos s) (t - s).
Proof.
  intros s t H H8. rewrite EQ_27 by lra.
  destruct (EQ_28 pos vel K s t H) as (u & Hu & Ed & Em & _). rewrite Em.
  destruct (Req_dec (vel u) 0) as [Z | Z].
  - rewrite Ed, Z, Rabs_R0. lra.
  - specialize (H8 u Hu Z). unfold margin_8 in H8. unfold margin.
    pose proof (Rabs_pos_lt _ Z). apply Rmult_le_pos; [apply Rabs_pos |].
    replace ((beta - need) * Rabs (vel u) + coulomb)
      with (Rabs (vel u) * (beta - need + coulomb / Rabs (vel u))) by (field; lra).
    apply Rmult_le_pos; lra.
Qed.

End Criterion.

(** TH-COMBINED: the operator puts in at least the growth of the storage, if the sampling
    is on time and (8), with the terms that the effects add, holds at every instant. *)
Theorem TH_COMBINED :
  forall mu beta sigma f V B delta e k ts held past pos vel friction hand,
  physical mu beta sigma -> increasing ts -> on_time ts ->
  wall f V B delta e ->
  obeys mu beta sigma ts held pos vel friction hand ->
  rendered f B delta e k ts pos past held ->
  forall N t, ts N <= t <= ts (S N) ->
  (forall u, ts 0%nat <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - viscous_need (INR k) B) (sigma - coulomb_need e delta B) (vel u)) ->
  ex_RInt (fun u => hand u * vel u) (ts 0%nat) t /\
  kinetic mu (vel t) + V (pos t) + extra_towards ts pos past k B N t
  <= kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + extra_at ts pos past k B 0
     + operator_energy vel hand (ts 0%nat) t.
Proof.
  intros mu beta sigma f V B delta e k ts held past pos vel friction hand
    P T J L O D N t Ht H8.
  apply (TH_COMBINED_jitter mu beta sigma f V B delta e k ts held past pos vel friction hand
    P T L O D N t Ht).
  intros h r Hr Hlt. pose proof (damping_nonneg _ _ _ _ _ L) as HB.
  pose proof (pos_INR k) as Hk.
  destruct (reached_range ts T N t Ht h r Hr) as (R0 & R1 & R2).
  eapply Rle_trans; [| apply TH_JITTER_on_time].
  - apply (EQ_8_to_27 _ _ _ pos vel (is_kinematic _ _ _ _ _ _ _ _ _ O)); [exact Hlt |].
    intros u Hu. apply H8. lra.
  - unfold viscous_need. lra.
  - specialize (J h). lra.
Qed.
