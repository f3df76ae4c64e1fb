(** * CheckerFriction: what friction of a loop leaves for a cost that has to be computed.

    Coulomb friction is compared with what it is asked for, and what it has to spare at the bound on the
    speed goes to viscous friction.  Whether that is enough is what the other files of the checker
    decide, one for each kind of loop. *)

From Coq Require Import Reals QArith Qreals Lra Lia Psatz List Bool RMicromega.
From Passivity Require Definitions Quantizer.
From Passivity Require Import Passivity Effects Region Checker CheckerPolynomial.
Import ListNotations.
Open Scope Q_scope.

(** Friction with its tolerances, wall and period, encoder and force step where there are any, and a
    bound on the speed, none for every speed. *)
Record loop := {
  l_b : range; l_c : range; l_K : Q; l_T : Q; l_D : option Q; l_F : option Q; l_V : option Q
}.

(** A verdict, that there is none, or that the numbers are no loop. *)
Inductive outcome := Says (v : verdict) | Unknown | Invalid.

Definition number (o : option Q) : Q := match o with Some q => q | None => 0 end.

Definition above_zero (q : Q) : bool := negb (Qle_bool q 0).
Definition above_zero_if (o : option Q) : bool := match o with Some q => above_zero q | None => true end.

Section Friction.

Variable l : loop.
Let K := l_K l.
Let T := l_T l.
Let D := number (l_D l).
Let F := number (l_F l).

Definition loop_valid : bool :=
  ordered (l_b l) && ordered (l_c l) && above_zero K && above_zero T
  && above_zero_if (l_D l) && above_zero_if (l_F l) && above_zero_if (l_V l).

(** What a Coulomb friction [c] has to spare, [nu] being what an encoder asks of it in ticks. *)
Definition spared (nu c : Q) : Q := c - K * D * nu - F / 2.

(** The viscous friction in KT that there is, with what is spared at the bound. *)
Definition left_over (nu b c : Q) : Q :=
  (match l_V l with None => b | Some v => b + spared nu c / v end) / (K * T).

(** [decide] says whether a viscous friction in KT is enough. *)
Definition at_friction (nu : Q) (decide : Q -> answer) (b c : Q) : answer :=
  if Qle_bool 0 (spared nu c) then decide (Qred (left_over nu b c)) else Short.

(** With the least friction, and else with the most. *)
Definition over_friction (nu : Q) (decide : Q -> answer) : outcome :=
  if loop_valid then
    match at_friction nu decide (lo (l_b l)) (lo (l_c l)) with
    | Enough => Says Holds
    | least => match at_friction nu decide (hi (l_b l)) (hi (l_c l)), least with
               | Short, _ => Says Fails
               | Enough, Short => Says Depends
               | _, _ => Unknown
               end
    end
  else Invalid.

(** ** Soundness *)

Open Scope R_scope.

Let rK := Q2R K.
Let rT := Q2R T.
Let rD := Q2R D.
Let rF := Q2R F.
Let V := option_map Q2R (l_V l).

(** A friction within its tolerances. *)
Definition friction_in (rb rc : R) : Prop :=
  Q2R (lo (l_b l)) <= rb <= Q2R (hi (l_b l)) /\ Q2R (lo (l_c l)) <= rc <= Q2R (hi (l_c l)).

(** The criterion at the speeds asked for, where [lambda] of viscous friction is asked for. *)
Definition meets (nu rb rc lambda : R) : Prop :=
  criterion V (rb - rK * rT * lambda) (rc - rK * rD * nu - rF / 2).

(** Numbers that a [loop_valid] is made of. *)
Lemma above_zero_is : forall q, above_zero q = true -> 0 < Q2R q.
Proof.
  intros q H. unfold above_zero in H. apply negb_true_iff in H. apply Rnot_le_lt. intro N.
  rewrite <- Q2R_0 in N. apply le_bool in N. congruence.
Qed.

Lemma loop_valid_is : loop_valid = true ->
  (Q2R (lo (l_b l)) <= Q2R (hi (l_b l)) /\ Q2R (lo (l_c l)) <= Q2R (hi (l_c l))) /\
  0 < rK /\ 0 < rT /\ (forall d, l_D l = Some d -> 0 < Q2R d) /\ (forall v, l_V l = Some v -> 0 < Q2R v).
Proof.
  unfold loop_valid, ordered. rewrite !andb_true_iff, !le_bool.
  intros ((((((Hb & Hc) & HK) & HT) & HD) & _) & HV).
  repeat split; try assumption; try (apply above_zero_is; assumption).
  - intros d E. rewrite E in HD. apply above_zero_is, HD.
  - intros v E. rewrite E in HV. apply above_zero_is, HV.
Qed.

Lemma spared_is : forall nu c, Q2R (spared nu c) = Q2R c - rK * rD * Q2R nu - rF / 2.
Proof.
  intros. unfold spared. rewrite !Q2R_minus, Q2R_quotient, !Q2R_mult, Q2R_two. reflexivity.
Qed.

Lemma left_over_is : forall nu b c,
  Q2R (Qred (left_over nu b c))
  = (match V with None => Q2R b | Some v => Q2R b + Q2R (spared nu c) / v end) / (rK * rT).
Proof.
  intros. rewrite (Qeq_eqR _ _ (Qred_correct _)). unfold left_over, V.
  rewrite Q2R_quotient, Q2R_mult. destruct (l_V l); simpl; [| reflexivity].
  rewrite Q2R_plus, Q2R_quotient. reflexivity.
Qed.

(** What is met where more is asked for is met where less is. *)
Lemma meets_less : loop_valid = true -> forall nu rb rc x y, x <= y ->
  meets nu rb rc y -> meets nu rb rc x.
Proof.
  intros Ok nu rb rc x y L. destruct (loop_valid_is Ok) as (_ & HK & HT & _).
  assert (U : rK * rT * x <= rK * rT * y)
    by (apply Rmult_le_compat_l; [apply Rlt_le, Rmult_lt_0_compat |]; assumption).
  unfold meets, criterion. destruct V as [v |]; intros M w Hw; specialize (M w Hw);
    unfold Definitions.margin in *; nra.
Qed.

Section Decide.

(** [cost lambda]: that [lambda] of viscous friction is enough; [decide] tells. *)
Variables (nu : Q) (decide : Q -> answer) (cost : R -> Prop).
Hypothesis more_is_enough : forall x y, x <= y -> cost x -> cost y.
Hypothesis decide_enough : forall q, decide q = Enough -> cost (Q2R q).
Hypothesis decide_short : forall q, decide q = Short -> ~ cost (Q2R q).
Hypothesis valid : loop_valid = true.

Lemma unit_positive : 0 < rK * rT.
Proof. destruct (loop_valid_is valid) as (_ & HK & HT & _). apply Rmult_lt_0_compat; assumption. Qed.

Lemma bound_is_positive : match V with None => True | Some v => 0 < v end.
Proof.
  destruct (loop_valid_is valid) as (_ & _ & _ & _ & HV). unfold V. destruct (l_V l); simpl; [| exact I].
  apply HV. reflexivity.
Qed.

Lemma at_friction_enough : forall b c, at_friction nu decide b c = Enough ->
  forall rb rc, Q2R b <= rb -> Q2R c <= rc -> exists lambda, cost lambda /\ meets (Q2R nu) rb rc lambda.
Proof.
  intros b c H rb rc Hb Hc. unfold at_friction in H. destruct Qle_bool eqn:S; [| discriminate].
  apply le_bool in S. rewrite Q2R_0, spared_is in S. apply decide_enough in H.
  eexists. split; [exact H |]. rewrite left_over_is, spared_is.
  destruct (loop_valid_is valid) as (_ & HK & HT & _).
  pose proof unit_positive as U. pose proof bound_is_positive as Pv. unfold meets, criterion.
  set (m := rK * rD * Q2R nu) in *. destruct V as [v |].
  - apply (TH_REGION_bound _ _ _ Pv). split; [lra |]. unfold Definitions.margin.
    replace ((rb - rK * rT * ((Q2R b + (Q2R c - m - rF / 2) / v) / (rK * rT))) * v + (rc - m - rF / 2))
      with ((rb - Q2R b) * v + (rc - Q2R c)) by (field; repeat split; lra).
    nra.
  - apply TH_REGION_all. split; [| lra].
    replace (rb - rK * rT * (Q2R b / (rK * rT))) with (rb - Q2R b) by (field; repeat split; lra). lra.
Qed.

Lemma at_friction_short : forall b c, at_friction nu decide b c = Short ->
  forall rb rc, rb <= Q2R b -> rc <= Q2R c -> forall lambda, cost lambda -> ~ meets (Q2R nu) rb rc lambda.
Proof.
  intros b c H rb rc Hb Hc lambda L M. unfold at_friction in H.
  destruct (loop_valid_is valid) as (_ & HK & HT & _).
  pose proof unit_positive as U. pose proof bound_is_positive as Pv. unfold meets, criterion in M.
  set (m := rK * rD * Q2R nu) in *.
  assert (Split : 0 <= rc - m - rF / 2 /\
    rK * rT * lambda <= match V with None => rb | Some v => rb + (rc - m - rF / 2) / v end).
  { destruct V as [v |].
    - apply (TH_REGION_bound _ _ _ Pv) in M. unfold Definitions.margin in M. destruct M as [M1 M2].
      split; [exact M1 |]. apply Rmult_le_reg_r with v; [exact Pv |].
      replace ((rb + (rc - m - rF / 2) / v) * v) with (rb * v + (rc - m - rF / 2)) by (field; repeat split; lra). lra.
    - change Definitions.holds_at_all with Definitions.globally_stable in M.
      apply TH_REGION_all in M. lra. }
  destruct Split as [S1 S2]. destruct Qle_bool eqn:S.
  - apply decide_short in H. apply H. apply more_is_enough with (2 := L).
    rewrite left_over_is, spared_is. fold m. apply Rmult_le_reg_l with (rK * rT); [exact U |].
    eapply Rle_trans; [exact S2 |].
    replace (rK * rT * (match V with
      | Some v => Q2R b + (Q2R c - m - rF / 2) / v | None => Q2R b end / (rK * rT)))
      with (match V with Some v => Q2R b + (Q2R c - m - rF / 2) / v | None => Q2R b end)
      by (field; repeat split; lra).
    destruct V as [v |]; [| exact Hb]. apply Rplus_le_compat; [exact Hb |].
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, Pv | lra].
  - assert (N : Qle_bool 0 (spared nu c) = true); [| congruence].
    apply le_bool. rewrite Q2R_0, spared_is. fold m. lra.
Qed.

Lemma over_friction_holds : over_friction nu decide = Says Holds ->
  forall rb rc, friction_in rb rc -> exists lambda, cost lambda /\ meets (Q2R nu) rb rc lambda.
Proof.
  intros H rb rc [Ib Ic]. unfold over_friction in H. rewrite valid in H.
  destruct (at_friction nu decide (lo (l_b l)) (lo (l_c l))) eqn:E;
    [| destruct (at_friction nu decide (hi (l_b l)) (hi (l_c l))); discriminate ..].
  apply (at_friction_enough _ _ E); lra.
Qed.

Lemma over_friction_fails : over_friction nu decide = Says Fails ->
  forall rb rc, friction_in rb rc -> forall lambda, cost lambda -> ~ meets (Q2R nu) rb rc lambda.
Proof.
  intros H rb rc [Ib Ic]. unfold over_friction in H. rewrite valid in H.
  destruct (at_friction nu decide (lo (l_b l)) (lo (l_c l))); [discriminate | ..];
    destruct (at_friction nu decide (hi (l_b l)) (hi (l_c l))) eqn:E; try discriminate;
    apply (at_friction_short _ _ E); lra.
Qed.

Lemma over_friction_depends : over_friction nu decide = Says Depends ->
  (exists rb rc, friction_in rb rc /\ exists lambda, cost lambda /\ meets (Q2R nu) rb rc lambda) /\
  (exists rb rc, friction_in rb rc /\ forall lambda, cost lambda -> ~ meets (Q2R nu) rb rc lambda).
Proof.
  intro H. unfold over_friction in H. rewrite valid in H.
  destruct (loop_valid_is valid) as ((Ob & Oc) & _).
  destruct (at_friction nu decide (lo (l_b l)) (lo (l_c l))) eqn:E0; [discriminate | | ];
    destruct (at_friction nu decide (hi (l_b l)) (hi (l_c l))) eqn:E1; try discriminate.
  split; do 2 eexists; (split; [split |]).
  - split; [exact Ob | apply Rle_refl].
  - split; [exact Oc | apply Rle_refl].
  - apply (at_friction_enough _ _ E1); apply Rle_refl.
  - split; [apply Rle_refl | exact Ob].
  - split; [apply Rle_refl | exact Oc].
  - apply (at_friction_short _ _ E0); apply Rle_refl.
Qed.

End Decide.

Lemma outcome_valid : forall nu decide v, over_friction nu decide = Says v -> loop_valid = true.
Proof. intros nu decide v H. unfold over_friction in H. destruct loop_valid; [reflexivity | discriminate]. Qed.

(** ** To the criterion at every instant of a motion *)

(** Positions are in ticks of the encoder, and in any length [u] where there is none. *)
Definition length_unit (u : R) : Prop :=
  match l_D l with Some d => u = Q2R d | None => 0 < u end.

(** What the program knows of a position, and how far it may be off. *)
Definition measuring (x : R) : R := match l_D l with Some _ => Definitions.measured x | None => x end.
Definition measuring_error : R := match l_D l with Some _ => 1 / 2 | None => 0 end.

Definition slow_enough (u : R) (vel : R -> R) (t : R) : Prop :=
  match V with None => True | Some v => forall w, 0 <= w <= t -> Rabs (vel w) <= v * rT / u end.

Lemma measuring_off : forall x, Rabs (measuring x - x) <= measuring_error.
Proof.
  intro x. unfold measuring, measuring_error. destruct (l_D l); [apply encoder_error |].
  replace (x - x) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

Lemma measuring_side : forall x, measuring x < 0 <-> x < 0.
Proof.
  intro x. unfold measuring. destruct (l_D l); [| tauto]. unfold Definitions.measured.
  destruct (Quantizer.floor_spec x) as [L U]. destruct (Quantizer.floor_integer x) as (z & Z).
  rewrite Z in *. assert (N : (z < 0)%Z -> IZR z <= -1) by (intro; apply IZR_le; lia).
  split; intro H; specialize (N ltac:(apply lt_IZR; lra)); lra.
Qed.

Lemma meets_motion : loop_valid = true ->
  forall nu rb rc lambda, meets nu rb rc lambda ->
  forall u vel t need delta, length_unit u -> need = 2 * measuring_error * nu -> delta = rF / (rK * u) ->
  slow_enough u vel t ->
  criterion_holds (Definitions.beta_of rb rK rT - lambda)
                  (Definitions.sigma_of rc rK u - (need + delta / 2)) vel t.
Proof.
  intros Ok nu rb rc lambda M u vel t need delta Hu -> -> Slow w Hw Hv.
  destruct (loop_valid_is Ok) as (_ & HK & HT & HD & _).
  assert (U : 0 < u /\ rD * nu = u * (2 * measuring_error * nu)).
  { revert Hu HD. unfold rD, D, number, length_unit, measuring_error. case (l_D l).
    - intros d Hu HD. rewrite Hu. split; [apply HD; reflexivity | field].
    - intros Hu _. split; [exact Hu |]. rewrite Q2R_0. ring. }
  destruct U as [HU Du]. set (need := 2 * measuring_error * nu) in *.
  apply EQ_8_margin; [exact Hv |]. set (speed := Rabs (vel w) * u / rT).
  assert (W : 0 < speed)
    by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; [apply Rabs_pos_lt, Hv | exact HU] |
        apply Rinv_0_lt_compat, HT]).
  assert (E : 0 <= Definitions.margin (rb - rK * rT * lambda) (rc - rK * rD * nu - rF / 2) speed).
  { unfold meets, criterion in M. unfold slow_enough in Slow. destruct V as [v |]; apply M; [| exact W].
    split; [exact W |]. specialize (Slow w Hw). unfold speed.
    apply Rmult_le_reg_r with (rT / u); [apply Rmult_lt_0_compat; [exact HT | apply Rinv_0_lt_compat, HU] |].
    replace (Rabs (vel w) * u / rT * (rT / u)) with (Rabs (vel w)) by (field; repeat split; lra).
    unfold Rdiv in *. lra. }
  assert (KU : 0 < rK * u) by (apply Rmult_lt_0_compat; assumption).
  apply Rmult_le_reg_l with (rK * u); [exact KU |]. rewrite Rmult_0_r.
  replace (rK * rD * nu) with (rK * (u * need)) in E by (rewrite <- Du; ring).
  replace (rK * u * Definitions.margin (Definitions.beta_of rb rK rT - lambda)
    (Definitions.sigma_of rc rK u - (need + rF / (rK * u) / 2)) (Rabs (vel w)))
    with (Definitions.margin (rb - rK * rT * lambda) (rc - rK * (u * need) - rF / 2) speed); [exact E |].
  unfold Definitions.margin, Definitions.beta_of, Definitions.sigma_of, speed. field. lra.
Qed.

End Friction.
