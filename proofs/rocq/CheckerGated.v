(** * CheckerGated: walls that are one-sided or saturated, under any controller whose response ends. *)

From Coq Require Import Reals QArith Qreals Lra List Bool RMicromega.
From Passivity Require Definitions.
From Passivity Require Import Model History Effects Controller FiniteResponse GatedController Checker
  CheckerPolynomial CheckerFriction CheckerFilter CheckerActuator.
Open Scope Q_scope.

Section Gated.

Variables (l : loop) (c : list Q) (k : nat).

(** H(1) (1/2 + k) + |g_1| + |g_2| + ... *)
Definition q_gated_viscous : Q :=
  hd 0 (tails c) * (half + inject_Z (Z.of_nat k)) + norm (tl (tails c)).

Definition gated_decides (beta : Q) : answer := if Qle_bool q_gated_viscous beta then Enough else Short.

(** The verdict on a loop under the controller c_0, c_1, ..., [k] samples late. *)
Definition check_gated : outcome :=
  if Qle_bool 0 (hd 0 (tails c)) then over_friction l (norm c / 2) gated_decides else Invalid.

(** ** Soundness *)

Open Scope R_scope.

Let n := length c.
Let g := tail (coefficient c) n.
Let viscous := g 0%nat / 2 + g 0%nat * INR k + tails_norm g n.
Let coulomb := response_norm (coefficient c) n / 2.

Lemma gated_viscous_is : Q2R q_gated_viscous = viscous.
Proof.
  unfold q_gated_viscous, viscous.
  rewrite Q2R_plus, Q2R_mult, Q2R_plus, Q2R_half, at_one_is, tails_norm_is.
  replace (Q2R (inject_Z (Z.of_nat k))) with (INR k)
    by (unfold Q2R; simpl; rewrite INR_IZR_INZ; field).
  fold n g. field.
Qed.

Lemma gated_enough : forall beta, gated_decides beta = Enough -> viscous <= Q2R beta.
Proof.
  intros beta E. unfold gated_decides in E. destruct Qle_bool eqn:S; [| discriminate].
  apply le_bool in S. rewrite gated_viscous_is in S. exact S.
Qed.

Lemma gated_short : forall beta, gated_decides beta = Short -> ~ viscous <= Q2R beta.
Proof.
  intros beta E L. unfold gated_decides in E. rewrite <- gated_viscous_is in L.
  apply le_bool in L. rewrite L in E. discriminate.
Qed.

Lemma check_gated_is : forall v, check_gated = Says v ->
  over_friction l (norm c / 2) gated_decides = Says v /\ loop_valid l = true /\ 0 <= g 0%nat.
Proof.
  intros v H. unfold check_gated in H. destruct Qle_bool eqn:S; [| discriminate].
  apply le_bool in S. rewrite Q2R_0, at_one_is in S.
  exact (conj H (conj (outcome_valid _ _ _ _ H) S)).
Qed.

(** CHECK (gated, holds and fails): the criterion holds at every friction within its tolerances, or at
    none. *)
Theorem CHECK_gated_holds : check_gated = Says Holds ->
  forall rb rc, friction_in l rb rc -> meets l coulomb rb rc viscous.
Proof.
  intros H rb rc I. destruct (check_gated_is _ H) as (O & Ok & _). unfold coulomb, n.
  rewrite <- half_norm.
  destruct (over_friction_holds l _ _ (fun x => viscous <= x) gated_enough Ok O rb rc I)
    as (lambda & A & M).
  exact (meets_less l Ok _ rb rc _ lambda A M).
Qed.

Theorem CHECK_gated_fails : check_gated = Says Fails ->
  forall rb rc, friction_in l rb rc -> ~ meets l coulomb rb rc viscous.
Proof.
  intros H rb rc I. destruct (check_gated_is _ H) as (O & Ok & _). unfold coulomb, n.
  rewrite <- half_norm.
  apply (over_friction_fails l _ _ (fun x => viscous <= x) (fun x y L A => Rle_trans _ _ _ A L)
    gated_short Ok O rb rc I), Rle_refl.
Qed.

(** CHECK (gated, motion): where the verdict is Holds, every motion is passive at the speeds asked for,
    whatever it was before the start. *)
Theorem CHECK_gated_motion : check_gated = Says Holds ->
  forall rb rc, friction_in l rb rc ->
  forall u mu pos vel friction hand past one_sided step limit, length_unit l u ->
  let beta := Definitions.beta_of rb (Q2R (l_K l)) (Q2R (l_T l)) in
  let sigma := Definitions.sigma_of rc (Q2R (l_K l)) u in
  physical mu beta sigma -> step_positive step -> limit_nonneg limit ->
  step_size step = Q2R (number (l_F l)) / (Q2R (l_K l) * u) ->
  obeys mu beta sigma INR
    (held_by_gated pos past (coefficient c) n k one_sided step limit (measuring l)) pos vel friction hand ->
  forall t, 0 <= t -> slow_enough l u vel t ->
  passive_run vel hand
    (Definitions.kinetic mu (vel 0) + scaled_potential (g 0%nat) one_sided limit (pos 0)
     + gated_storage (g 0%nat) k g n (History.step INR pos past 0))
    (Definitions.kinetic mu (vel t) + scaled_potential (g 0%nat) one_sided limit (pos t)) t.
Proof.
  intros H rb rc I u mu pos vel friction hand past one_sided step limit Hu beta sigma P S Hl Es O t Ht
    Slow.
  destruct (check_gated_is _ H) as (_ & Ok & G).
  apply (TH_LTI_gated mu beta sigma pos vel friction hand past (coefficient c) n k one_sided step limit
    (measuring l) (measuring_error l) P S Hl (measuring_off l) (measuring_side l) G O t Ht).
  apply (meets_motion l Ok coulomb rb rc viscous (CHECK_gated_holds H rb rc I) u);
    [exact Hu | unfold coulomb; field | exact Es | exact Slow].
Qed.

End Gated.
