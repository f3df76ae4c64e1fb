(** * Switching: a wall that is switched on and off (ERR-IV-C).

    Sec. IV-C: "the virtual force can be set to zero at any time without affecting the energy
    balance."  Set to zero it can be at any time; set back at a depth it has energy to give that
    nobody put in. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Generation Calculus Model Law Combined
  Passivity Effects Active.
Open Scope R_scope.

(** The wall (2), (5), on over the intervals at whose sample [on] is true, and no force else. *)
Definition switched_force (on : nat -> bool) (pos : R -> R) (h : nat) : R :=
  if on h then held_force (pos (INR h)) else 0.

(** What the wall stores: nothing while it is off. *)
Definition switched_potential (on : bool) (x : R) : R := if on then linear_potential x else 0.

(** What the switching at the samples 1 to N adds. *)
Fixpoint switched_in (on : nat -> bool) (pos : R -> R) (N : nat) : R :=
  match N with
  | O => 0
  | S p => switched_in on pos p
           + switching_energy (on p) (on (S p)) (linear_potential (pos (INR (S p))))
  end.

Section Runs.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable on : nat -> bool.
Hypothesis P : physical mu beta sigma.
Hypothesis O : obeys mu beta sigma INR (switched_force on pos) pos vel friction hand.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.

(** An interval pays, with the wall on (TH-INTERVAL) or off, where (8) holds at the speeds in it. *)
Lemma switched_interval_pays : forall h r, INR h <= r <= INR (S h) ->
  (forall u, INR h <= u <= r -> criterion_8 beta sigma (vel u)) ->
  generated (switched_force on pos h) (pos (INR h)) (pos r)
    (switched_potential (on h) (pos (INR h))) (switched_potential (on h) (pos r))
  <= dissipated beta sigma vel (INR h) r.
Proof.
  intros h r Hr H8. rewrite S_INR in Hr.
  destruct (Req_dec (INR h) r) as [<- | N].
  { unfold dissipated. rewrite RInt_point. change zero with 0. unfold generated. lra. }
  pose proof (EQ_26 pos vel K beta sigma (INR h) r ltac:(lra) (beta_nonneg _ _ _ P)
    (sigma_nonneg _ _ _ P)) as E.
  set (d := pos r - pos (INR h)) in *.
  assert (L : bound_22 d <= dissipated_lower beta sigma d (r - INR h)).
  { assert (Q : 0 <= surplus (beta - 1 / 2) (sigma - 1 / 2) d (r - INR h)).
    { apply (EQ_8_to_27 beta (1 / 2) (sigma - 1 / 2) pos vel K); [lra |]. intros u Hu Hv. specialize (H8 u Hu Hv).
      rewrite viscous_plain, coulomb_plain in H8. exact H8. }
    pose proof (TH_JITTER_on_time beta (1 / 2) (sigma - 1 / 2) ltac:(lra) d (r - INR h)) as J.
    specialize (J ltac:(lra)). unfold jitter_surplus in J. unfold bound_22, dissipated_lower.
    replace (beta * d ^ 2 / (r - INR h)) with (beta / (r - INR h) * d ^ 2) by (field; lra). lra. }
  assert (Z : 0 <= bound_22 d).
  { unfold bound_22. pose proof (Rabs_pos d). pose proof (pow2_ge_0 d). lra. }
  unfold switched_force, switched_potential. destruct (on h).
  - rewrite TH_LIN_by_definition. pose proof (TH_LIN (pos (INR h)) (pos r)) as G. fold d in G. lra.
  - unfold generated. fold d. lra.
Qed.

(** ERR-IV-C (account): where (8) holds at every instant the operator draws at most the storage at the
    start and what the switching added. *)
Theorem ERR_IV_C_account : forall N t, INR N <= t <= INR (S N) ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  ex_RInt (fun u => hand u * vel u) 0 t /\
  kinetic mu (vel t) + switched_potential (on N) (pos t)
  <= kinetic mu (vel 0) + switched_potential (on 0%nat) (pos 0) + switched_in on pos N
     + operator_energy vel hand 0 t.
Proof.
  intros N t Ht H8.
  set (W := fun h => switched_potential (on h) (pos (INR h)) - switched_in on pos h).
  set (X := fun h r => switched_potential (on h) (pos r) - switched_in on pos h).
  destruct (EQ_14_run mu beta sigma INR (switched_force on pos) pos vel friction hand P O
    (fun _ => 0) W X INR_increasing) with (N := N) (t := t) as (I & E); [| exact Ht | |].
  - intro h. unfold X, W. cbn [switched_in]. unfold switching_energy, switched_potential. ring.
  - intros h r Hr.
    assert (Range : INR h <= r <= INR (S h)).
    { destruct Hr as [[_ ->] | [-> ->]]; [rewrite S_INR; lra | exact Ht]. }
    destruct (reached_range INR INR_increasing N t Ht h r Hr) as (R0 & R1 & _). simpl (INR 0) in R0.
    assert (In : forall u, INR h <= u <= r -> criterion_8 beta sigma (vel u)).
    { intros u Hu. apply H8. lra. }
    pose proof (switched_interval_pays h r Range In) as Pay. unfold X, W.
    unfold generated in *. lra.
  - unfold X, W in E. simpl (INR 0) in *. simpl switched_in in E. split; [exact I |]. lra.
Qed.

(** Switching off only. *)
Definition only_off : Prop := forall h, on (S h) = true -> on h = true.

(** ERR-IV-C (off): a wall that is only ever switched off costs nothing, at whatever depths. *)
Theorem ERR_IV_C_off : only_off -> forall N t, INR N <= t <= INR (S N) ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  passive_run vel hand (kinetic mu (vel 0) + switched_potential (on 0%nat) (pos 0))
    (kinetic mu (vel t) + switched_potential (on N) (pos t)) t.
Proof.
  intros Off N t Ht H8. destruct (ERR_IV_C_account N t Ht H8) as [I E].
  split; [exact I |].
  assert (J : forall n, switched_in on pos n <= 0).
  { induction n as [| n IH]; [simpl; lra |]. cbn [switched_in].
    assert (switching_energy (on n) (on (S n)) (linear_potential (pos (INR (S n)))) <= 0); [| lra].
    unfold switching_energy, linear_potential. pose proof (pow2_ge_0 (pos (INR (S n)))).
    specialize (Off n). destruct (on (S n)); [rewrite Off by reflexivity | destruct (on n)]; lra. }
  specialize (J N). lra.
Qed.

End Runs.

(** Off at the first sample, on from the next one. *)
Definition on_from_1 (h : nat) : bool := match h with O => false | S _ => true end.

(** The straight way out from the depth n + 1, a tick a sample, and what the hand does on it: it gives
    way to the held force, less the friction c = beta + sigma. *)
Definition way_out (n : nat) (t : R) : R := INR (S n) - t.
Definition hand_on_way_out (c : R) (n : nat) (t : R) : R :=
  - c - switched_force on_from_1 (way_out n) (Z.to_nat (Int_part t)).

Lemma held_on_way_out : forall n h,
  switched_force on_from_1 (way_out n) (S h) = - (INR n - INR h + 1 / 2).
Proof.
  intros n h. unfold switched_force. cbn [on_from_1]. unfold held_force, measured, way_out.
  replace (INR (S n) - INR (S h)) with (IZR (Z.of_nat n - Z.of_nat h)).
  - rewrite floor_IZR, minus_IZR, <- !INR_IZR_INZ. ring.
  - rewrite minus_IZR, <- !INR_IZR_INZ, !S_INR. ring.
Qed.

Lemma hand_within : forall c n h t, INR h < t < INR (S h) ->
  hand_on_way_out c n t = - c - switched_force on_from_1 (way_out n) h.
Proof.
  intros c n h t Ht. rewrite S_INR in Ht. unfold hand_on_way_out.
  replace (Int_part t) with (Z.of_nat h); [rewrite Nat2Z.id; reflexivity |].
  apply eq_IZR. rewrite <- INR_IZR_INZ. symmetry. change (floor t = INR h).
  rewrite INR_IZR_INZ. apply floor_unique. rewrite <- INR_IZR_INZ. lra.
Qed.

Lemma hand_integral : forall c n h s t, INR h <= s <= t -> t <= INR (S h) ->
  is_RInt (hand_on_way_out c n) s t ((t - s) * (- c - switched_force on_from_1 (way_out n) h)).
Proof.
  intros c n h s t Hs Ht.
  apply is_RInt_ext with (fun _ => - c - switched_force on_from_1 (way_out n) h).
  - intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra. symmetry. apply hand_within. lra.
  - apply (@is_RInt_const R_NormedModule).
Qed.

Lemma hand_energy : forall c n h,
  is_RInt (fun u => hand_on_way_out c n u * - 1) (INR h) (INR (S h))
    (c + switched_force on_from_1 (way_out n) h).
Proof.
  intros c n h. pose proof (hand_integral c n h (INR h) (INR (S h))) as I.
  rewrite S_INR in *. specialize (I ltac:(lra) ltac:(lra)).
  apply (@is_RInt_scal R_NormedModule _ _ _ (- 1)) in I.
  replace (c + _) with (- 1 * ((INR h + 1 - INR h) * (- c - switched_force on_from_1 (way_out n) h)))
    by ring.
  apply is_RInt_ext with (2 := I). intros u _. apply Rmult_comm.
Qed.

Lemma way_out_obeys : forall mu beta sigma n, physical mu beta sigma ->
  obeys mu beta sigma INR (switched_force on_from_1 (way_out n)) (way_out n)
    (fun _ => - 1) (fun _ => - sigma) (hand_on_way_out (beta + sigma) n).
Proof.
  intros mu beta sigma n P. pose proof (sigma_nonneg _ _ _ P). split.
  - split; intro t; [| apply continuous_const]. unfold way_out. auto_derive; [exact I | ring].
  - intro t. rewrite Rabs_left by lra. ring.
  - intro t. rewrite Rabs_Ropp, Rabs_right; lra.
  - intro h. apply (@ex_RInt_const R_NormedModule).
  - intro h. pose proof (S_INR h). eexists. apply (hand_integral _ n h); lra.
  - intros h t Ht. symmetry. apply is_RInt_unique.
    set (F := switched_force on_from_1 (way_out n) h).
    apply is_RInt_ext with (fun _ => 0).
    + intros u Hu. rewrite Rmin_left, Rmax_right in Hu by lra.
      rewrite (hand_within _ n h u) by lra. fold F.
      match goal with |- ?a = ?b => change (@eq R a b) end. ring.
    + replace (mu * (- 1 - - 1)) with ((t - INR h) * 0) by ring.
      apply (@is_RInt_const R_NormedModule).
Qed.

Lemma way_out_energy : forall c n m,
  is_RInt (fun u => hand_on_way_out c n u * - 1) 1 (INR (S m))
    (INR m * c - INR m * (INR n + 3 / 2) + INR m * (INR m + 1) / 2).
Proof.
  intros c n. induction m as [| m IH].
  - simpl (INR 1). simpl (INR 0). replace (0 * c - _ + _) with 0 by field.
    apply (@is_RInt_point R_NormedModule).
  - pose proof (is_RInt_join _ _ _ _ _ _ IH (hand_energy c n (S m))) as J.
    replace (INR (S m) * c - _ + _) with
      (INR m * c - INR m * (INR n + 3 / 2) + INR m * (INR m + 1) / 2
       + (c + switched_force on_from_1 (way_out n) (S m))); [exact J |].
    rewrite held_on_way_out, (S_INR m). field.
Qed.

(** ERR-IV-C (on): whatever beta and sigma are, a device that moves out at a constant speed, a tick a
    sample, meets the wall, switched on at the depth n, and the operator draws n^2/2 + n less the
    friction n (beta + sigma) from there to the surface.  At beta = sigma = 1/2, where (8) holds at
    every speed, that is n^2/2: all of what the wall then stores. *)
Theorem ERR_IV_C_on : forall mu beta sigma n, physical mu beta sigma -> exists pos vel friction hand,
  obeys mu beta sigma INR (switched_force on_from_1 pos) pos vel friction hand /\
  (forall t, vel t = - 1) /\ pos 1 = INR n /\ pos (INR (S n)) = 0 /\
  is_RInt (fun u => hand u * vel u) 0 1 (beta + sigma) /\
  is_RInt (fun u => hand u * vel u) 1 (INR (S n))
    (- (INR n ^ 2 / 2 + INR n * (1 - beta - sigma))).
Proof.
  intros mu beta sigma n P.
  exists (way_out n), (fun _ => - 1), (fun _ => - sigma), (hand_on_way_out (beta + sigma) n).
  split; [apply way_out_obeys, P |]. split; [reflexivity |].
  split; [unfold way_out; rewrite S_INR; ring |]. split; [unfold way_out; ring |]. split.
  - pose proof (hand_energy (beta + sigma) n 0) as E. simpl (INR 0) in E. simpl (INR 1) in E.
    unfold switched_force in E. cbn [on_from_1] in E. rewrite Rplus_0_r in E. exact E.
  - pose proof (way_out_energy (beta + sigma) n n) as E.
    replace (- (INR n ^ 2 / 2 + INR n * (1 - beta - sigma)))
      with (INR n * (beta + sigma) - INR n * (INR n + 3 / 2) + INR n * (INR n + 1) / 2) by field.
    exact E.
Qed.

(** ERR-IV-C (negation): so of no device, however much friction it has, is it the case that a wall may be
    switched at any time without the operator drawing more than was stored at the start. *)
Theorem ERR_IV_C_negation : forall mu beta sigma, physical mu beta sigma ->
  ~ (forall on pos vel friction hand,
     obeys mu beta sigma INR (switched_force on pos) pos vel friction hand ->
     forall t, 0 <= t ->
     - (kinetic mu (vel 0) + switched_potential (on 0%nat) (pos 0)) <= operator_energy vel hand 0 t).
Proof.
  intros mu beta sigma P H. pose proof (mu_positive _ _ _ P). pose proof (beta_nonneg _ _ _ P).
  pose proof (sigma_nonneg _ _ _ P).
  destruct (INR_unbounded (2 * (beta + sigma) + mu + 2)) as (n & Hn).
  destruct (ERR_IV_C_on mu beta sigma n P) as (pos & vel & friction & hand & O & V & _ & _ & E0 & E1).
  specialize (H on_from_1 pos vel friction hand O (INR (S n)) (pos_INR (S n))).
  unfold operator_energy in H. rewrite (is_RInt_unique _ _ _ _ (is_RInt_join _ _ _ _ _ _ E0 E1)) in H.
  rewrite V in H. unfold kinetic, switched_potential in H. cbn [on_from_1] in H. nra.
Qed.
