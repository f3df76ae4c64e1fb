(** * CheckerOnePole: loops with virtual damping behind a one-pole filter, without a delay. *)

From Coq Require Import Reals QArith Qreals Lra Lia Psatz List Bool RMicromega.
From Passivity Require Definitions.
From Passivity Require Import Model Effects Controller OnePole Checker CheckerPolynomial CheckerFriction.
Open Scope Q_scope.

Section OnePole.

Variables (l : loop) (B tau : Q).

(** The damping in KT and the pole, from the damping and the time constant of its filter. *)
Definition q_damping : Q := B / (l_K l * l_T l).
Definition q_pole : Q := tau / (tau + l_T l).

(** What is asked of viscous friction in KT, and of Coulomb friction, of an encoder, in ticks. *)
Definition q_one_pole_viscous : Q := half + q_damping * ((1 - q_pole) / (1 + q_pole)).
Definition q_one_pole_coulomb : Q := half + q_damping * (1 - q_pole).

Definition one_pole_decides (beta : Q) : answer :=
  if Qle_bool q_one_pole_viscous beta then Enough else Short.

Definition check_one_pole : outcome :=
  if Qle_bool 0 B && Qle_bool 0 tau then over_friction l q_one_pole_coulomb one_pole_decides
  else Invalid.

(** ** Soundness *)

Open Scope R_scope.

Let damping := Q2R B / (Q2R (l_K l) * Q2R (l_T l)).
Let pole := Q2R tau / (Q2R tau + Q2R (l_T l)).
Let viscous := 1 / 2 + damping * filter_share pole.
Let coulomb := 1 / 2 + damping * (1 - pole).

Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R. simpl. field. Qed.

Lemma one_pole_viscous_is : Q2R q_one_pole_viscous = viscous.
Proof.
  unfold q_one_pole_viscous, q_damping, q_pole, viscous, damping, pole, filter_share.
  rewrite Q2R_plus, Q2R_mult, !Q2R_quotient, Q2R_minus, !Q2R_plus, !Q2R_quotient, Q2R_plus, Q2R_mult,
    Q2R_half, Q2R_one. reflexivity.
Qed.

Lemma one_pole_coulomb_is : Q2R q_one_pole_coulomb = coulomb.
Proof.
  unfold q_one_pole_coulomb, q_damping, q_pole, coulomb, damping, pole.
  rewrite Q2R_plus, Q2R_mult, Q2R_quotient, Q2R_minus, Q2R_quotient, Q2R_plus, Q2R_mult,
    Q2R_half, Q2R_one. reflexivity.
Qed.

Lemma one_pole_enough : forall beta, one_pole_decides beta = Enough -> viscous <= Q2R beta.
Proof.
  intros beta E. unfold one_pole_decides in E. destruct Qle_bool eqn:S; [| discriminate].
  apply le_bool in S. rewrite one_pole_viscous_is in S. exact S.
Qed.

Lemma one_pole_short : forall beta, one_pole_decides beta = Short -> ~ viscous <= Q2R beta.
Proof.
  intros beta E L. unfold one_pole_decides in E. rewrite <- one_pole_viscous_is in L.
  apply le_bool in L. rewrite L in E. discriminate.
Qed.

Lemma check_one_pole_is : forall v, check_one_pole = Says v ->
  over_friction l q_one_pole_coulomb one_pole_decides = Says v /\ loop_valid l = true /\
  0 <= Q2R B /\ 0 <= Q2R tau.
Proof.
  intros v H. unfold check_one_pole in H. destruct (_ && _) eqn:S; [| discriminate].
  rewrite andb_true_iff, !le_bool, Q2R_0 in S.
  repeat split; [exact H | exact (outcome_valid _ _ _ _ H) | apply S | apply S].
Qed.

(** CHECK (one pole, holds and fails): the criterion holds at every friction within its tolerances, or
    at none. *)
Theorem CHECK_one_pole_holds : check_one_pole = Says Holds ->
  forall rb rc, friction_in l rb rc -> meets l coulomb rb rc viscous.
Proof.
  intros H rb rc I. destruct (check_one_pole_is _ H) as (O & Ok & _).
  destruct (over_friction_holds l _ _ (fun x => viscous <= x) one_pole_enough Ok O rb rc I)
    as (lambda & A & M).
  rewrite one_pole_coulomb_is in M. exact (meets_less l Ok _ rb rc _ lambda A M).
Qed.

Theorem CHECK_one_pole_fails : check_one_pole = Says Fails ->
  forall rb rc, friction_in l rb rc -> ~ meets l coulomb rb rc viscous.
Proof.
  intros H rb rc I. destruct (check_one_pole_is _ H) as (O & Ok & _). rewrite <- one_pole_coulomb_is.
  apply (over_friction_fails l _ _ (fun x => viscous <= x) (fun x y L A => Rle_trans _ _ _ A L)
    one_pole_short Ok O rb rc I), Rle_refl.
Qed.

(** CHECK (one pole, motion): where the verdict is Holds, every motion is passive at the speeds asked
    for; the filter had rested until [m] samples before the start. *)
Theorem CHECK_one_pole_motion : check_one_pole = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  forall u mu pos vel friction hand past m step, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  physical mu beta sigma -> step_positive step ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  obeys mu beta sigma INR (held_by_one_pole pos past pole damping m step (measuring l))
    pos vel friction hand ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.storage mu (pos 0) (vel 0) + one_pole_memory pos past pole damping m)
    (Definitions.storage mu (pos t) (vel t)) t.
Proof.
  intros H rb rc I u mu pos vel friction hand past m step Hu beta sigma P S Es O t Ht Slow.
  destruct (check_one_pole_is _ H) as (_ & Ok & B0 & T0).
  destruct (loop_valid_is l Ok) as (_ & HK & HT & _).
  assert (Pole : 0 <= pole < 1).
  { unfold pole. split.
    - apply Rmult_le_pos; [exact T0 | apply Rlt_le, Rinv_0_lt_compat; lra].
    - apply Rmult_lt_reg_r with (Q2R tau + Q2R (l_T l)); [lra |].
      replace (Q2R tau / (Q2R tau + Q2R (l_T l)) * (Q2R tau + Q2R (l_T l))) with (Q2R tau)
        by (field; lra). lra. }
  assert (Damping : 0 <= damping).
  { apply Rmult_le_pos; [exact B0 |]. apply Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; assumption. }
  apply (TH_LTI_one_pole mu beta sigma pos vel friction hand past pole damping m step (measuring l)
    (measuring_error l) P Pole Damping S (measuring_off l) O t Ht).
  apply (meets_motion l Ok coulomb rb rc viscous (CHECK_one_pole_holds H rb rc I) u);
    [exact Hu | unfold coulomb; field | exact Es | exact Slow].
Qed.

End OnePole.
