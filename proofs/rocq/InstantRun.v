(** * InstantRun: a run that is charged by the integral of the squared velocity.

    What an actuator costs depends on how the device moves within an interval, so that the
    criterion is asked at the instantaneous speed, and friction pays it there. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model Effects.
Open Scope R_scope.

(** With enough friction at every speed the criterion holds whatever the motion. *)
Lemma enough_at_all_speeds : forall viscous coulomb vel t, 0 <= viscous -> 0 <= coulomb ->
  criterion_holds viscous coulomb vel t.
Proof.
  intros viscous coulomb vel t Hb Hc u _ Hv. unfold margin_8.
  assert (0 <= coulomb / Rabs (vel u))
    by (apply Rdiv_le_0_compat; [exact Hc | apply Rabs_pos_lt; exact Hv]).
  lra.
Qed.

(** The hand's share of the work that it does together with another force. *)
Lemma hand_apart : forall vel hand force a b,
  ex_RInt (fun u => force u * vel u) a b -> ex_RInt (fun u => (hand u + force u) * vel u) a b ->
  is_RInt (fun u => hand u * vel u) a b
    (operator_energy vel (fun u => hand u + force u) a b - RInt (fun u => force u * vel u) a b).
Proof.
  intros vel hand force a b Iw I.
  apply is_RInt_ext with (fun u => (hand u + force u) * vel u - force u * vel u);
    [over_R; ring |].
  apply (@is_RInt_minus R_NormedModule (fun u => (hand u + force u) * vel u));
    apply RInt_is; assumption.
Qed.

(** The squared velocity's integral. *)
Definition square_integral (vel : R -> R) (s t : R) : R := RInt (fun u => vel u ^ 2) s t.

Section Instant.

Variables beta sigma kappa coulomb : R.
Variables pos vel : R -> R.
Hypothesis K : kinematic pos vel.

Lemma instant_friction : forall s t, s <= t ->
  (forall u, s <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - kappa) (sigma - coulomb) (vel u)) ->
  kappa * square_integral vel s t + coulomb * RInt (fun u => Rabs (vel u)) s t
  <= dissipated beta sigma vel s t.
Proof.
  intros s t St H8. unfold square_integral.
  rewrite <- (EQ_23 pos vel K kappa coulomb s t). unfold dissipated.
  apply RInt_le; [exact St | | |].
  - apply (power_integrable pos vel K).
  - apply (power_integrable pos vel K).
  - intros u Hu. unfold friction_power. destruct (Req_dec (vel u) 0) as [Z | Z].
    + rewrite Z, Rabs_R0. lra.
    + specialize (H8 u ltac:(lra) Z). unfold margin_8 in H8.
      pose proof (Rabs_pos_lt _ Z) as A. rewrite <- (pow2_abs (vel u)).
      apply (Rmult_le_compat_l (Rabs (vel u) ^ 2)) in H8; [| apply pow2_ge_0].
      replace (Rabs (vel u) ^ 2 * (beta - kappa + (sigma - coulomb) / Rabs (vel u)))
        with ((beta - kappa) * Rabs (vel u) ^ 2 + (sigma - coulomb) * Rabs (vel u)) in H8
        by (field; lra).
      lra.
Qed.

Lemma way_at_least : forall s t, s <= t -> Rabs (pos t - pos s) <= RInt (fun u => Rabs (vel u)) s t.
Proof. intros s t St. pose proof (EQ_24 pos vel K 1 s t St ltac:(lra)). lra. Qed.

(** A displacement takes at least d^2 / tau of the squared velocity, tau >= t - s. *)
Lemma square_at_least : forall s t tau, s <= t -> t - s <= tau -> 0 < tau ->
  (pos t - pos s) ^ 2 / tau <= square_integral vel s t.
Proof.
  intros s t tau St Ht T0. destruct (Req_dec s t) as [<- | N].
  - replace (pos s - pos s) with 0 by ring. unfold square_integral. rewrite RInt_point.
    change zero with 0. unfold Rdiv. rewrite pow_i, Rmult_0_l by auto. lra.
  - eapply Rle_trans; [| apply (cauchy_schwarz pos vel K); lra].
    unfold Rdiv. apply Rmult_le_compat_l; [apply pow2_ge_0 |].
    apply Rinv_le_contravar; lra.
Qed.

(** Both together, for a displacement within [tau]. *)
Lemma instant_charge : forall s t tau, s <= t -> t - s <= tau -> 0 < tau -> 0 <= kappa ->
  0 <= coulomb ->
  (forall u, s <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - kappa) (sigma - coulomb) (vel u)) ->
  kappa * ((pos t - pos s) ^ 2 / tau) + coulomb * Rabs (pos t - pos s)
  <= dissipated beta sigma vel s t.
Proof.
  intros s t tau St Ht T0 K0 C0 H8.
  pose proof (instant_friction s t St H8).
  pose proof (Rmult_le_compat_l kappa _ _ K0 (square_at_least s t tau St Ht T0)).
  pose proof (Rmult_le_compat_l coulomb _ _ C0 (way_at_least s t St)). lra.
Qed.

End Instant.
