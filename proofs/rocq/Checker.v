(** * Checker: a second decision over a box of loops, on rationals, proved and then extracted.

    It has nothing of the kernel in it: three numbers are compared with 0 at a handful of loops.
    `checker/compare` runs it beside the kernel's [Loop::decide]. *)

From Coq Require Import Reals QArith Qreals Lra Lia Psatz List Bool RMicromega.
From Coquelicot Require Import Coquelicot.
From Passivity Require Definitions.
From Passivity Require Import Model Law Combined Passivity Laws Effects Controller Region Box.
Import ListNotations.
Open Scope Q_scope.

(** A closed interval. *)
Record range := { lo : Q; hi : Q }.

(** What is parsed of a scene: friction, wall, period, encoder, damping and force step as intervals,
    none for what is absent, and the delay in whole samples. *)
Record parsed := {
  p_b : option range; p_c : option range; p_K : range; p_T : range;
  p_D : option range; p_B : option range; p_F : option range; p_k : nat
}.

(** Every speed, or those up to a bound with a tolerance. *)
Inductive speeds := AtAll | UpTo (V : range).

Inductive verdict := Holds | Fails | Depends.

(** What is absent is 0. *)
Definition range_of (o : option range) : range :=
  match o with Some r => r | None => {| lo := 0; hi := 0 |} end.

Definition half : Q := 1 # 2.

(** What friction has to spare, (11) with the terms of the effects. *)
Definition q_viscous (b K T k B : Q) : Q := b - K * T * (half + k) - B.
Definition q_coulomb (c K T D B F : Q) : Q := c - K * D / 2 - B * D / T - F / 2.

(** Whether the criterion holds at every speed, or at every speed up to a bound. *)
Definition q_holds (bound : option Q) (viscous coulomb : Q) : bool :=
  Qle_bool 0 coulomb &&
  match bound with
  | None => Qle_bool 0 viscous
  | Some V => Qle_bool 0 (viscous * V + coulomb)
  end.

Section Check.

Variable x : parsed.
Let b := range_of (p_b x).
Let c := range_of (p_c x).
Let K := p_K x.
Let T := p_T x.
Let D := range_of (p_D x).
Let B := range_of (p_B x).
Let F := range_of (p_F x).
Let k := inject_Z (Z.of_nat (p_k x)).

(** The loops in which all but the period is at its hardest, and at its easiest. *)
Definition hardest (bound : option Q) (t : Q) : bool :=
  q_holds bound (q_viscous (lo b) (hi K) t k (hi B)) (q_coulomb (lo c) (hi K) t (hi D) (hi B) (hi F)).
Definition easiest (bound : option Q) (t : Q) : bool :=
  q_holds bound (q_viscous (hi b) (lo K) t k (lo B)) (q_coulomb (hi c) (lo K) t (lo D) (lo B) (lo F)).

(** The periods at which the easiest loop is looked at (TH-REGION, Box.v). *)
Definition q_near_rest : Q := lo B * lo D / (hi c - lo K * lo D / 2 - lo F / 2).
Definition q_at_bound (V : Q) : Q :=
  (hi c - lo K * lo D / 2 - lo F / 2 + (hi b - lo B) * V) / (2 * (lo K * (half + k) * V)).

Definition periods (bound : option Q) : list Q :=
  [lo T; hi T; q_near_rest] ++ match bound with None => [] | Some V => [q_at_bound V] end.

Definition ordered (r : range) : bool := Qle_bool (lo r) (hi r).
Definition positive (r : range) : bool := negb (Qle_bool (lo r) 0).
Definition nonnegative (r : range) : bool := Qle_bool 0 (lo r).

(** What is asked of the intervals. *)
Definition valid (s : speeds) : bool :=
  ordered b && ordered c && ordered K && ordered T && ordered D && ordered B && ordered F
  && positive K && positive T && nonnegative D && nonnegative B
  && match s with AtAll => true | UpTo V => ordered V && positive V end.

Definition at_most (s : speeds) : option Q := match s with AtAll => None | UpTo V => Some (hi V) end.
Definition at_least (s : speeds) : option Q := match s with AtAll => None | UpTo V => Some (lo V) end.

(** The verdict; none for intervals that are not valid. *)
Definition check (s : speeds) : option verdict :=
  if valid s then
    Some (if hardest (at_most s) (hi T) && hardest (at_most s) (lo T) then Holds
          else if existsb (fun t => Qle_bool (lo T) t && Qle_bool t (hi T)
                                    && easiest (at_least s) t) (periods (at_least s))
               then Depends else Fails)
  else None.

(** ** Soundness *)

Open Scope R_scope.

(** A loop in the box, and what is asked of it. *)
Definition in_box : R -> R -> R -> R -> R -> R -> R -> Prop :=
  inside (Q2R (lo b)) (Q2R (hi b)) (Q2R (lo c)) (Q2R (hi c)) (Q2R (lo K)) (Q2R (hi K))
    (Q2R (lo T)) (Q2R (hi T)) (Q2R (lo D)) (Q2R (hi D)) (Q2R (lo B)) (Q2R (hi B))
    (Q2R (lo F)) (Q2R (hi F)).

Definition in_speeds (s : speeds) (V : option R) : Prop :=
  match s, V with
  | AtAll, None => True
  | UpTo r, Some v => Q2R (lo r) <= v <= Q2R (hi r)
  | _, _ => False
  end.

Definition criterion (V : option R) (viscous coulomb : R) : Prop :=
  match V with
  | None => Definitions.holds_at_all viscous coulomb
  | Some v => Definitions.holds_up_to viscous coulomb v
  end.

Definition loop_holds (V : option R) (rb rc rK rT rD rB rF : R) : Prop :=
  criterion V (Definitions.viscous_si rb rK rT (INR (p_k x)) rB)
              (Definitions.coulomb_si rc rK rT rD rB rF).

Lemma Q2R_quotient : forall p q, Q2R (p / q) = Q2R p / Q2R q.
Proof.
  intros p q. unfold Qdiv. rewrite Q2R_mult. unfold Rdiv. f_equal. rewrite Q2R_inv_ext.
  destruct (Qeq_bool q 0) eqn:E; [| reflexivity].
  apply Qeq_true in E. rewrite E, Q2R_0, Rinv_0. reflexivity.
Qed.

Lemma Q2R_two : Q2R 2 = 2.
Proof. unfold Q2R. simpl. field. Qed.

Lemma Q2R_half : Q2R half = 1 / 2.
Proof. unfold Q2R. simpl. field. Qed.

Lemma Q2R_k : Q2R k = INR (p_k x).
Proof. unfold k, Q2R. simpl. rewrite INR_IZR_INZ. field. Qed.

Lemma viscous_is : forall rb rK rT rB,
  Q2R (q_viscous rb rK rT k rB) = Definitions.viscous_si (Q2R rb) (Q2R rK) (Q2R rT) (INR (p_k x)) (Q2R rB).
Proof.
  intros. unfold q_viscous, Definitions.viscous_si.
  rewrite !Q2R_minus, !Q2R_mult, Q2R_plus, Q2R_half, Q2R_k. reflexivity.
Qed.

Lemma coulomb_is : forall rc rK rT rD rB rF,
  Q2R (q_coulomb rc rK rT rD rB rF)
  = Definitions.coulomb_si (Q2R rc) (Q2R rK) (Q2R rT) (Q2R rD) (Q2R rB) (Q2R rF).
Proof.
  intros. unfold q_coulomb, Definitions.coulomb_si.
  rewrite !Q2R_minus, !Q2R_quotient, !Q2R_mult, Q2R_two. reflexivity.
Qed.

Lemma le_bool : forall p q, Qle_bool p q = true <-> Q2R p <= Q2R q.
Proof.
  intros. rewrite Qle_bool_iff. split; [apply Qle_Rle | apply Rle_Qle].
Qed.

Definition real_bound (bound : option Q) : option R :=
  match bound with None => None | Some V => Some (Q2R V) end.

Lemma q_holds_is : forall bound viscous coulomb,
  match bound with None => True | Some V => 0 < Q2R V end ->
  (q_holds bound viscous coulomb = true
   <-> criterion (real_bound bound) (Q2R viscous) (Q2R coulomb)).
Proof.
  intros [V |] viscous coulomb HV; unfold q_holds, criterion, real_bound;
    rewrite andb_true_iff, !le_bool, Q2R_0.
  - rewrite (TH_REGION_bound _ _ _ HV). unfold Definitions.margin.
    rewrite Q2R_plus, Q2R_mult. tauto.
  - change Definitions.holds_at_all with Definitions.globally_stable. rewrite TH_REGION_all. tauto.
Qed.

(** What [valid] says. *)
Lemma valid_is : forall s, valid s = true ->
  (Q2R (lo b) <= Q2R (hi b) /\ Q2R (lo c) <= Q2R (hi c) /\ Q2R (lo K) <= Q2R (hi K) /\
   Q2R (lo T) <= Q2R (hi T) /\ Q2R (lo D) <= Q2R (hi D) /\ Q2R (lo B) <= Q2R (hi B) /\
   Q2R (lo F) <= Q2R (hi F)) /\
  (0 < Q2R (lo K) /\ 0 < Q2R (lo T) /\ 0 <= Q2R (lo D) /\ 0 <= Q2R (lo B)) /\
  match s with AtAll => True | UpTo V => 0 < Q2R (lo V) /\ Q2R (lo V) <= Q2R (hi V) end.
Proof.
  intros s H. unfold valid, ordered, positive, nonnegative in H.
  assert (Pos : forall q, negb (Qle_bool q 0) = true -> 0 < Q2R q).
  { intros q Hq. apply negb_true_iff in Hq. apply Rnot_le_lt. intro N.
    rewrite <- Q2R_0 in N. apply le_bool in N. congruence. }
  rewrite !andb_true_iff in H. rewrite !le_bool, Q2R_0 in H.
  destruct s as [| V].
  - decompose [and] H. repeat split; try assumption; apply Pos; assumption.
  - rewrite andb_true_iff, le_bool in H. decompose [and] H.
    repeat split; try assumption; apply Pos; assumption.
Qed.

Lemma k_nonneg : 0 <= INR (p_k x).
Proof. apply pos_INR. Qed.

Definition bound_positive (bound : option Q) : Prop :=
  match bound with None => True | Some V => 0 < Q2R V end.

Lemma hardest_is : forall bound t, bound_positive bound ->
  (hardest bound t = true <->
   loop_holds (real_bound bound) (Q2R (lo b)) (Q2R (lo c)) (Q2R (hi K)) (Q2R t) (Q2R (hi D))
     (Q2R (hi B)) (Q2R (hi F))).
Proof.
  intros bound t HV. unfold hardest, loop_holds. rewrite q_holds_is by exact HV.
  rewrite viscous_is, coulomb_is. tauto.
Qed.

Lemma easiest_is : forall bound t, bound_positive bound ->
  (easiest bound t = true <->
   loop_holds (real_bound bound) (Q2R (hi b)) (Q2R (hi c)) (Q2R (lo K)) (Q2R t) (Q2R (lo D))
     (Q2R (lo B)) (Q2R (lo F))).
Proof.
  intros bound t HV. unfold easiest, loop_holds. rewrite q_holds_is by exact HV.
  rewrite viscous_is, coulomb_is. tauto.
Qed.

Lemma bounds_positive : forall s, valid s = true ->
  bound_positive (at_most s) /\ bound_positive (at_least s).
Proof.
  intros s H. apply valid_is in H. destruct H as (_ & _ & H).
  destruct s as [| V]; simpl in *; [tauto | lra].
Qed.

(** CHECK (holds): the criterion holds for every loop of the box at every speed asked for. *)
Theorem CHECK_holds : forall s, check s = Some Holds ->
  forall rb rc rK rT rD rB rF V, in_box rb rc rK rT rD rB rF -> in_speeds s V ->
  loop_holds V rb rc rK rT rD rB rF.
Proof.
  intros s H rb rc rK rT rD rB rF V I HV. unfold check in H.
  destruct (valid s) eqn:Ok; [| discriminate].
  destruct (hardest (at_most s) (hi T) && hardest (at_most s) (lo T)) eqn:E;
    [| destruct existsb; discriminate].
  destruct (bounds_positive s Ok) as [Pm _]. apply valid_is in Ok as (_ & (HK & HT & HD & HB) & _).
  apply andb_true_iff in E. destruct E as [E1 E0].
  apply (hardest_is _ _ Pm) in E1. apply (hardest_is _ _ Pm) in E0.
  unfold loop_holds in *. destruct s as [| r]; destruct V as [v |]; simpl in *; try tauto.
  - exact (TH_REGION_box_holds_at_all _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HK HT HD HB k_nonneg
      E1 E0 _ _ _ _ _ _ _ I).
  - exact (TH_REGION_box_holds _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HK HT HD HB k_nonneg
      _ E1 E0 _ _ _ _ _ _ _ _ I (proj2 HV)).
Qed.

Lemma near_rest_is :
  Q2R q_near_rest = near_rest (Q2R (hi c)) (Q2R (lo K)) (Q2R (lo D)) (Q2R (lo B)) (Q2R (lo F)).
Proof.
  unfold q_near_rest, near_rest, Definitions.shortest_period.
  rewrite Q2R_quotient, !Q2R_minus, !Q2R_quotient, !Q2R_mult, Q2R_two. reflexivity.
Qed.

Lemma at_bound_is : forall V,
  Q2R (q_at_bound V) = at_bound (Q2R (hi b)) (Q2R (hi c)) (Q2R (lo K)) (Q2R (lo D)) (Q2R (lo B))
    (Q2R (lo F)) (INR (p_k x)) (Q2R V).
Proof.
  intro V. unfold q_at_bound, at_bound, Definitions.best_period.
  rewrite Q2R_quotient, Q2R_plus, !Q2R_minus, !Q2R_mult, !Q2R_quotient, Q2R_minus, Q2R_plus, Q2R_mult,
    Q2R_two, Q2R_half, Q2R_k. reflexivity.
Qed.

(** CHECK (fails): it holds for no loop of the box, up to no bound of the tolerance. *)
Theorem CHECK_fails : forall s, check s = Some Fails ->
  forall rb rc rK rT rD rB rF V, in_box rb rc rK rT rD rB rF -> in_speeds s V ->
  ~ loop_holds V rb rc rK rT rD rB rF.
Proof.
  intros s H rb rc rK rT rD rB rF V I HV Hold. unfold check in H.
  destruct (valid s) eqn:Ok; [| discriminate].
  destruct (hardest _ _ && hardest _ _); [discriminate |].
  destruct existsb eqn:E; [discriminate |]. clear H.
  destruct (bounds_positive s Ok) as [_ Pl].
  pose proof (valid_is s Ok) as (_ & (HK & HT & HD & HB) & HVs).
  assert (None_of : forall t, In t (periods (at_least s)) -> Q2R (lo T) <= Q2R t <= Q2R (hi T) ->
    ~ loop_holds (real_bound (at_least s)) (Q2R (hi b)) (Q2R (hi c)) (Q2R (lo K)) (Q2R t) (Q2R (lo D))
        (Q2R (lo B)) (Q2R (lo F))).
  { intros t Ht [R0 R1] L. apply (easiest_is _ _ Pl) in L.
    apply le_bool in R0. apply le_bool in R1.
    assert (X : existsb (fun t => Qle_bool (lo T) t && Qle_bool t (hi T)
                                  && easiest (at_least s) t) (periods (at_least s)) = true).
    { apply existsb_exists. exists t. split; [exact Ht |]. rewrite R0, R1, L. reflexivity. }
    congruence. }
  unfold loop_holds in *. destruct s as [| r]; destruct V as [v |]; simpl in HV; try tauto.
  - destruct (TH_REGION_box_fails_at_all _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HK HT HD HB k_nonneg
      _ _ _ _ _ _ _ I Hold) as (t & [-> | ->] & Ht & L).
    + apply (None_of (lo T)); [left; reflexivity | exact Ht | exact L].
    + rewrite <- near_rest_is in *.
      apply (None_of q_near_rest); [right; right; left; reflexivity | exact Ht | exact L].
  - destruct HVs as [V0 _].
    destruct (TH_REGION_box_fails _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ HK HT HD HB k_nonneg
      _ V0 _ _ _ _ _ _ _ _ I (proj1 HV) Hold) as (t & [-> | [-> | [-> | ->]]] & Ht & L).
    + apply (None_of (lo T)); [left; reflexivity | exact Ht | exact L].
    + apply (None_of (hi T)); [right; left; reflexivity | exact Ht | exact L].
    + rewrite <- near_rest_is in *.
      apply (None_of q_near_rest); [right; right; left; reflexivity | exact Ht | exact L].
    + rewrite <- at_bound_is in *.
      apply (None_of (q_at_bound (lo r))); [right; right; right; left; reflexivity | exact Ht | exact L].
Qed.

(** CHECK (depends): some loop of the box meets it at a bound of the tolerance, and some does not. *)
Theorem CHECK_depends : forall s, check s = Some Depends ->
  (exists rb rc rK rT rD rB rF V, in_box rb rc rK rT rD rB rF /\ in_speeds s V /\
     loop_holds V rb rc rK rT rD rB rF) /\
  (exists rb rc rK rT rD rB rF V, in_box rb rc rK rT rD rB rF /\ in_speeds s V /\
     ~ loop_holds V rb rc rK rT rD rB rF).
Proof.
  intros s H. unfold check in H. destruct (valid s) eqn:Ok; [| discriminate].
  destruct (bounds_positive s Ok) as [Pm Pl].
  pose proof (valid_is s Ok) as (Or & _ & HVs).
  destruct (hardest _ _ && hardest _ _) eqn:Hd; [discriminate |].
  destruct existsb eqn:E; [| discriminate]. clear H. split.
  - apply existsb_exists in E. destruct E as (t & _ & E). rewrite !andb_true_iff in E.
    destruct E as [[R0 R1] L]. apply le_bool in R0. apply le_bool in R1.
    apply (easiest_is _ _ Pl) in L.
    exists (Q2R (hi b)), (Q2R (hi c)), (Q2R (lo K)), (Q2R t), (Q2R (lo D)), (Q2R (lo B)), (Q2R (lo F)),
      (real_bound (at_least s)).
    split; [split; lra |]. split; [destruct s; simpl in *; [exact I | lra] | exact L].
  - assert (Bad : exists t, Q2R (lo T) <= Q2R t <= Q2R (hi T) /\ hardest (at_most s) t = false).
    { apply andb_false_iff in Hd. destruct Hd as [Hd | Hd];
        [exists (hi T) | exists (lo T)]; (split; [lra | exact Hd]). }
    destruct Bad as (t & Ht & Hf).
    exists (Q2R (lo b)), (Q2R (lo c)), (Q2R (hi K)), (Q2R t), (Q2R (hi D)), (Q2R (hi B)), (Q2R (hi F)),
      (real_bound (at_most s)).
    split; [split; lra |]. split; [destruct s; simpl in *; [exact I | lra] |].
    intro L. apply (hardest_is _ _ Pm) in L. congruence.
Qed.

End Check.

(** ** From the verdict to motions *)

Open Scope R_scope.

(** CHECK (motion): where the verdict is Holds, every motion of every loop of the box with an encoder
    is passive, at the speeds asked for: of the control law with the effects that the loop has,
    one-sided and saturated or not.  Positions are in ticks, times in sampling periods. *)
Theorem CHECK_motion : forall x s, check x s = Some Holds ->
  forall rb rc rK rT rD rB rF V, in_box x rb rc rK rT rD rB rF -> in_speeds s V -> 0 < rD ->
  forall mu pos vel friction hand past one_sided step limit,
  physical mu (Definitions.beta_of rb rK rT) (Definitions.sigma_of rc rK rD) ->
  step_positive step -> step_size step = rF / (rK * rD) -> limit_nonneg limit ->
  obeys mu (Definitions.beta_of rb rK rT) (Definitions.sigma_of rc rK rD) INR
    (held_by_controller pos past one_sided (rB / (rK * rT)) step limit (p_k x) Definitions.measured)
    pos vel friction hand ->
  forall t, 0 <= t ->
  match V with None => True | Some v => forall u, 0 <= u <= t -> Rabs (vel u) <= v * rT / rD end ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + Definitions.controller_potential one_sided limit (pos 0)
     + start_extra pos past (p_k x) (rB / (rK * rT)))
    (Definitions.kinetic mu (vel t) + Definitions.controller_potential one_sided limit (pos t)) t.
Proof.
  intros x s H rb rc rK rT rD rB rF V I HV HD mu pos vel friction hand past one_sided step limit
    P Hs Es Hl O t Ht Slow.
  pose proof (CHECK_holds x s H _ _ _ _ _ _ _ V I HV) as L.
  assert (Ok : valid x s = true) by (unfold check in H; destruct (valid x s); [reflexivity | discriminate]).
  apply valid_is in Ok. destruct Ok as (_ & (K0 & T0 & _ & B0) & _).
  pose proof (K_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IK.
  pose proof (T_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IT.
  pose proof (B_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IB. clear I.
  assert (HK : 0 < rK) by lra. assert (HT : 0 < rT) by lra.
  assert (KT : 0 < rK * rT) by (apply Rmult_lt_0_compat; assumption).
  assert (KD : 0 < rK * rD) by (apply Rmult_lt_0_compat; assumption).
  assert (HB : 0 <= rB / (rK * rT)) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, KT]).
  apply (TH_COMBINED_controller mu _ _ pos vel friction hand past one_sided (rB / (rK * rT)) step limit
    (p_k x) Definitions.measured (1 / 2) P HB Hs Hl encoder_error O t Ht).
  destruct (TH_COMBINED_with_encoder (Definitions.beta_of rb rK rT) (Definitions.sigma_of rc rK rD)
    (p_k x) (step_size step) (rB / (rK * rT))) as (_ & -> & ->).
  intros u Hu Hv. apply EQ_8_margin; [exact Hv |].
  pose proof (EQ_11 rb rc rK rT rD (Rabs (vel u) * rD / rT) (INR (p_k x)) rB rF HK HT HD) as E.
  replace (Rabs (vel u) * rD / rT * rT / rD) with (Rabs (vel u)) in E by (field; lra).
  rewrite Es. apply Rmult_le_reg_l with (rK * rD); [exact KD |]. rewrite Rmult_0_r, <- E.
  assert (W : 0 < Rabs (vel u) * rD / rT)
    by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rabs_pos_lt, Hv | exact HD] | exact HT]).
  unfold loop_holds, criterion in L. destruct V as [v |]; apply L; [| exact W].
  split; [exact W |]. specialize (Slow u Hu).
  apply Rmult_le_reg_r with (rT / rD); [apply Rdiv_lt_0_compat; assumption |].
  replace (Rabs (vel u) * rD / rT * (rT / rD)) with (Rabs (vel u)) by (field; lra).
  unfold Rdiv in *. lra.
Qed.

(** CHECK (motion, no encoder): the same for a loop that knows its position exactly; positions are
    in any length [u]. *)
Theorem CHECK_motion_smooth : forall x s, check x s = Some Holds ->
  forall rb rc rK rT rB rF V, in_box x rb rc rK rT 0 rB rF -> in_speeds s V ->
  forall u mu pos vel friction hand past one_sided step limit, 0 < u ->
  physical mu (Definitions.beta_of rb rK rT) (Definitions.sigma_of rc rK u) ->
  step_positive step -> step_size step = rF / (rK * u) -> limit_nonneg limit ->
  obeys mu (Definitions.beta_of rb rK rT) (Definitions.sigma_of rc rK u) INR
    (held_by_controller pos past one_sided (rB / (rK * rT)) step limit (p_k x) (fun y => y))
    pos vel friction hand ->
  forall t, 0 <= t ->
  match V with None => True | Some v => forall w, 0 <= w <= t -> Rabs (vel w) <= v * rT / u end ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + Definitions.controller_potential one_sided limit (pos 0)
     + start_extra pos past (p_k x) (rB / (rK * rT)))
    (Definitions.kinetic mu (vel t) + Definitions.controller_potential one_sided limit (pos t)) t.
Proof.
  intros x s H rb rc rK rT rB rF V I HV u mu pos vel friction hand past one_sided step limit HU
    P Hs Es Hl O t Ht Slow.
  pose proof (CHECK_holds x s H _ _ _ _ _ _ _ V I HV) as L.
  assert (Ok : valid x s = true) by (unfold check in H; destruct (valid x s); [reflexivity | discriminate]).
  apply valid_is in Ok. destruct Ok as (_ & (K0 & T0 & _ & B0) & _).
  pose proof (K_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IK.
  pose proof (T_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IT.
  pose proof (B_in _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ I) as IB. clear I.
  assert (HK : 0 < rK) by lra. assert (HT : 0 < rT) by lra.
  assert (KT : 0 < rK * rT) by (apply Rmult_lt_0_compat; assumption).
  assert (KD : 0 < rK * u) by (apply Rmult_lt_0_compat; assumption).
  assert (HB : 0 <= rB / (rK * rT)) by (apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat, KT]).
  destruct (TH_COMBINED_without_encoder (Definitions.sigma_of rc rK u) (step_size step) (rB / (rK * rT)))
    as (Exact & Spare).
  apply (TH_COMBINED_controller mu _ _ pos vel friction hand past one_sided (rB / (rK * rT)) step limit
    (p_k x) (fun y => y) 0 P HB Hs Hl Exact O t Ht).
  rewrite Spare. intros w Hw Hv. apply EQ_8_margin; [exact Hv |].
  rewrite Es. apply Rmult_le_reg_l with (rK * u); [exact KD |]. rewrite Rmult_0_r.
  set (speed := Rabs (vel w) * u / rT).
  assert (W : 0 < speed)
    by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rabs_pos_lt, Hv | exact HU] | exact HT]).
  replace (rK * u * Definitions.margin _ _ (Rabs (vel w)))
    with (Definitions.margin (Definitions.viscous_si rb rK rT (INR (p_k x)) rB)
            (Definitions.coulomb_si rc rK rT 0 rB rF) speed).
  - unfold loop_holds, criterion in L. destruct V as [v |]; apply L; [| exact W].
    split; [exact W |]. specialize (Slow w Hw). unfold speed.
    apply Rmult_le_reg_r with (rT / u); [apply Rdiv_lt_0_compat; assumption |].
    replace (Rabs (vel w) * u / rT * (rT / u)) with (Rabs (vel w)) by (field; lra).
    unfold Rdiv in *. lra.
  - unfold Definitions.margin, Definitions.viscous_si, Definitions.coulomb_si, Definitions.beta_of,
      Definitions.sigma_of, viscous_need, speed. field. lra.
Qed.
