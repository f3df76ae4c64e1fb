(** * Controller: the control law as a program computes it, every effect switched on or off.

    So TH-UNI with TH-DAMP, and saturation with TH-DAMP, are covered together, with the terms
    added up.  BridgeController.v compares [controller] with the kernel's text. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Start.
Open Scope R_scope.

Definition step_size (step : option R) : R := match step with Some delta => delta | None => 0 end.

Definition step_positive (step : option R) : Prop :=
  match step with Some delta => 0 < delta | None => True end.

Definition limit_nonneg (limit : option R) : Prop :=
  match limit with Some L => 0 <= L | None => True end.

Lemma controller_law_lipschitz : forall s l, lipschitz (controller_law s l).
Proof.
  intros [|] [L |]; [apply lipschitz_clipped | apply lipschitz_below | apply lipschitz_clipped
    | apply lipschitz_id].
Qed.

Lemma controller_law_potential : forall s l, limit_nonneg l ->
  potential (controller_law s l) (controller_potential s l).
Proof.
  intros [|] [L |] Hl; simpl in Hl.
  - apply potential_clipped. lra.
  - apply potential_below. lra.
  - apply potential_clipped. lra.
  - destruct potential_linear as [D N]. split; intro x.
    + apply is_derive_ext with linear_potential; [| apply D].
      intro y. unfold controller_potential, controller_law, law_potential_of, linear_potential.
      over_R. field.
    + unfold controller_potential, controller_law, law_potential_of. nra.
Qed.

Lemma limited_lipschitz : forall l, lipschitz (limited l).
Proof. intros [L |]; [apply lipschitz_clipped | apply lipschitz_id]. Qed.

Lemma stepped_error : forall step u, step_positive step ->
  Rabs (stepped step u - u) <= step_size step / 2.
Proof.
  intros [delta |] u H; simpl in *; [apply rounding_error, H |].
  replace (u - u) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

(** Without damping and step the controller is its law. *)
Lemma undamped : forall s l q, limit_nonneg l ->
  - limited l (- gated s q q) = controller_law s l q.
Proof.
  intros [|] [L |] q Hl; simpl in *; unfold clipped, clipped_below, Rmin, Rmax;
    repeat (destruct Rlt_dec || destruct Rle_dec); lra.
Qed.

(** The controller's force is one that the theorem covers. *)
Lemma controller_commands : forall s B step l q q', 0 <= B -> step_positive step ->
  limit_nonneg l ->
  commands (controller_law s l) B (step_size step) q q' (- controller s B step l q q').
Proof.
  intros s B step l q q' HB Hs Hl. unfold commands. rewrite <- (undamped s l q Hl).
  unfold controller. set (F := q + B * (q - q')).
  replace (- limited l (stepped step (- gated s q F)) - - limited l (- gated s q q))
    with (- (limited l (stepped step (- gated s q F)) - limited l (- gated s q q))) by ring.
  rewrite Rabs_Ropp. eapply Rle_trans; [apply limited_lipschitz |].
  replace (stepped step (- gated s q F) - - gated s q q)
    with ((gated s q q - gated s q F) + (stepped step (- gated s q F) - - gated s q F)) by ring.
  eapply Rle_trans; [apply Rabs_triang |].
  pose proof (stepped_error step (- gated s q F) Hs) as E.
  assert (G : Rabs (gated s q q - gated s q F) <= B * Rabs (q - q')).
  { assert (Pos : 0 <= B * Rabs (q - q')) by (apply Rmult_le_pos; [exact HB | apply Rabs_pos]).
    assert (Damp : Rabs (q - F) <= B * Rabs (q - q')).
    { unfold F. replace (q - (q + B * (q - q'))) with (- (B * (q - q'))) by ring.
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_right B) by lra. lra. }
    unfold gated. destruct s; [destruct Rlt_dec |]; try exact Damp.
    replace (0 - 0) with 0 by ring. rewrite Rabs_R0. exact Pos. }
  lra.
Qed.

Section Runs.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (s : bool) (B : R) (step limit : option R) (k : nat).
Variables (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis B_nonneg : 0 <= B.
Hypothesis step_ok : step_positive step.
Hypothesis limit_ok : limit_nonneg limit.
(** With an encoder [measured] and 1/2; without one the identity and 0. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.

Definition held_by_controller (h : nat) : R :=
  controller s B step limit (measure (sample INR pos past h k)) (measure (sample INR pos past h (S k))).

Hypothesis O : obeys mu beta sigma INR held_by_controller pos vel friction hand.

Let delta := step_size step.
Let viscous := beta - viscous_need (INR k) B.
Let coulomb := sigma - coulomb_need e delta B.

Lemma controller_wall : wall (controller_law s limit) (controller_potential s limit) B delta e.
Proof.
  split; [apply controller_law_lipschitz | exact B_nonneg | | |
    apply controller_law_potential, limit_ok].
  - unfold delta. destruct step; simpl in *; lra.
  - apply Rle_trans with (2 := measure_error 0), Rabs_pos.
Qed.

Lemma controller_rendered :
  rendered (controller_law s limit) B delta e k INR pos past held_by_controller.
Proof.
  intro h. eexists. eexists. split; [apply measure_error |]. split; [apply measure_error |].
  apply controller_commands; assumption.
Qed.

(** TH-COMBINED (controller): the control law with any of delay, virtual damping, wall on one
    side, D/A step and saturation, under the criterion with the terms of those it has. *)
Theorem TH_COMBINED_controller : forall t, 0 <= t ->
  criterion_holds viscous coulomb vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + controller_potential s limit (pos 0) + start_extra pos past k B)
    (kinetic mu (vel t) + controller_potential s limit (pos t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  destruct (TH_COMBINED mu beta sigma _ _ B delta e k INR _ past pos vel friction hand
    P INR_increasing INR_on_time controller_wall O controller_rendered N t HN) as (I & E).
  - simpl (INR 0). exact H8.
  - pose proof (extra_nonneg k B (push (pos t - pos (INR N)) (History.step INR pos past N)) B_nonneg).
    unfold extra_towards, extra_at in E. simpl (INR 0) in *.
    split; [exact I |]. unfold start_extra. lra.
Qed.

(** TH-START (controller): unforced, the same control law never lets the speed pass a W whose
    kinetic energy covers the storage at the start, what delay and damping remember included.
    The last premise leaves out only a start at rest with just enough Coulomb friction and too
    little viscous friction. *)
Theorem TH_START_controller : (forall t, hand t * vel t <= 0) -> 0 <= coulomb ->
  forall W, 0 <= W -> 0 <= margin viscous coulomb W ->
  kinetic mu (vel 0) + controller_potential s limit (pos 0) + start_extra pos past k B <= kinetic mu W ->
  0 < coulomb \/ 0 < W \/ 0 <= viscous ->
  forall t, 0 <= t -> Rabs (vel t) <= W.
Proof.
  intros Z C W HW M E ND t Ht. destruct (INR_covers t Ht) as (N & HN).
  exact (TH_START_combined mu beta sigma _ _ B delta e k INR _ past
    pos vel friction hand P INR_increasing INR_on_time controller_wall O controller_rendered Z W HW
    E C M ND N t HN).
Qed.

(** A wall that is one-sided or saturated stores no more than the linear spring. *)
Lemma controller_potential_at_most : forall x, controller_potential s limit x <= x ^ 2 / 2.
Proof.
  intro x. unfold controller_potential, law_potential_of.
  pose proof (pow2_ge_0 (x - controller_law s limit x)). nra.
Qed.

(** TH-START (memory): the W of the claim, W^2 = v(0)^2 + (xi(0)^2 + 2 E)/mu, with E the extra
    storage of delay and damping at the start. *)
Theorem TH_START_memory : (forall t, hand t * vel t <= 0) -> 0 <= coulomb ->
  forall W, 0 <= W -> 0 <= margin viscous coulomb W ->
  W ^ 2 = start_speed_squared_with_memory mu (pos 0) (vel 0) (start_extra pos past k B) ->
  0 < coulomb \/ 0 < W \/ 0 <= viscous ->
  forall t, 0 <= t -> Rabs (vel t) <= W.
Proof.
  intros Z C W HW M E. apply (TH_START_controller Z C W HW M).
  pose proof (controller_potential_at_most (pos 0)). pose proof (mu_positive _ _ _ P).
  unfold kinetic at 2. rewrite E. unfold start_speed_squared_with_memory, start_speed_squared, kinetic.
  replace (mu * (vel 0 ^ 2 + pos 0 ^ 2 / mu + 2 * start_extra pos past k B / mu) / 2)
    with (mu * vel 0 ^ 2 / 2 + pos 0 ^ 2 / 2 + start_extra pos past k B) by (field; lra).
  lra.
Qed.

(** TH-START (rested): with a controller that remembers rest at the starting position only, that
    is W^2 = v(0)^2 + xi(0)^2/mu. *)
Theorem TH_START_rested : (forall t, hand t * vel t <= 0) -> 0 <= coulomb ->
  (forall j, past j = pos 0) ->
  forall W, 0 <= W -> 0 <= margin viscous coulomb W ->
  W ^ 2 = start_speed_squared mu (pos 0) (vel 0) ->
  0 < coulomb \/ 0 < W \/ 0 <= viscous ->
  forall t, 0 <= t -> Rabs (vel t) <= W.
Proof.
  intros Z C R W HW M E. apply (TH_START_memory Z C W HW M).
  unfold start_speed_squared_with_memory. rewrite TH_DELAY_TH_DAMP_at_rest by exact R.
  rewrite E. unfold Rdiv. rewrite Rmult_0_r, Rmult_0_l. ring.
Qed.

End Runs.

(** The criterion of the two theorems above with an encoder, as the kernel computes it. *)
Theorem TH_COMBINED_with_encoder : forall beta sigma k delta B,
  (forall x, Rabs (measured x - x) <= 1 / 2) /\
  beta - viscous_need (INR k) B = viscous_surplus beta (INR k) B /\
  sigma - coulomb_need (1 / 2) delta B = coulomb_surplus sigma delta B.
Proof.
  intros. split; [apply encoder_error |]. split; symmetry;
    [apply viscous_need_surplus | apply coulomb_need_surplus].
Qed.

(** And without an encoder (TH-SMOOTH): neither the 1/2 nor the damping costs Coulomb friction. *)
Theorem TH_COMBINED_without_encoder : forall sigma delta B,
  (forall x : R, Rabs (x - x) <= 0) /\ sigma - coulomb_need 0 delta B = sigma - delta / 2.
Proof.
  intros. split; [| unfold coulomb_need; field].
  intro x. replace (x - x) with 0 by ring. rewrite Rabs_R0. lra.
Qed.
