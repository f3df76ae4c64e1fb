(** * Passivity: the paper's theorem about motions, repaired.

    The wall is (2): bilateral, one encoder, no further effect; the sampling instants are
    0, 1, 2, ... *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Generation Calculus Model History Law Combined.
Open Scope R_scope.

Lemma INR_increasing : increasing INR.
Proof. intro h. rewrite S_INR. lra. Qed.

Lemma INR_on_time : on_time INR.
Proof. intro h. rewrite S_INR. lra. Qed.

Lemma INR_covers : forall t, 0 <= t -> exists N, INR N <= t <= INR (S N).
Proof.
  intros t Ht. destruct (nfloor_ex t Ht) as (N & HN). exists N. rewrite S_INR. lra.
Qed.

(** The wall (2) held by (5): what a motion of the paper's device obeys. *)
Definition paper_motion (mu beta sigma : R) (pos vel friction hand : R -> R) : Prop :=
  obeys mu beta sigma INR (fun h => held_force (pos (INR h))) pos vel friction hand.

(** (8) at a velocity: nothing is asked of a device at rest. *)
Definition criterion_8 (beta sigma v : R) : Prop :=
  v <> 0 -> 0 <= margin_8 (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) v.

Lemma viscous_plain : forall beta, viscous_surplus beta 0 0 = beta - 1 / 2.
Proof. intro. unfold viscous_surplus. ring. Qed.

Lemma coulomb_plain : forall sigma, coulomb_surplus sigma 0 0 = sigma - 1 / 2.
Proof. intro. unfold coulomb_surplus. field. Qed.

Lemma paper_wall : wall (fun x => x) linear_potential 0 0 (1 / 2).
Proof.
  split; try lra; try apply lipschitz_id. exact potential_linear.
Qed.

Lemma viscous_surplus_plain : forall beta,
  viscous_surplus beta 0 0 = beta - viscous_need (INR 0) 0.
Proof. intro. apply viscous_need_surplus. Qed.

Lemma coulomb_surplus_plain : forall sigma,
  coulomb_surplus sigma 0 0 = sigma - coulomb_need (1 / 2) 0 0.
Proof. intro. apply coulomb_need_surplus. Qed.

Lemma storage_nonneg : forall mu x v, 0 < mu -> 0 <= storage mu x v.
Proof.
  intros mu x v M. unfold storage, kinetic, linear_potential.
  pose proof (pow2_ge_0 x). pose proof (pow2_ge_0 v). nra.
Qed.

Lemma encoder_error : forall x, Rabs (measured x - x) <= 1 / 2.
Proof. intro x. pose proof (measured_error x). apply Rabs_le. lra. Qed.

Lemma paper_rendered : forall pos past,
  rendered (fun x => x) 0 0 (1 / 2) 0 INR pos past
           (fun h => held_force (pos (INR h))).
Proof.
  intros pos past h.
  exists (measured (sample INR pos past h 0)), (measured (sample INR pos past h 1)).
  split; [apply encoder_error |]. split; [apply encoder_error |].
  unfold commands, held_force. rewrite sample_now.
  replace (_ - _) with 0 by ring. rewrite Rabs_R0. lra.
Qed.

(** Without delay and damping there is no extra storage. *)
Lemma no_extra : forall d, extra 0 0 d = 0.
Proof. intro d. unfold extra, delay_storage, damping_storage. simpl. field. Qed.

(** TH-INTERVAL: the criterion at a step's mean speed orders generated energy, the bound
    (22), the bound (26) and dissipated energy, for every step that starts at a sampling
    instant and ends within its interval. *)
Theorem TH_INTERVAL : forall mu beta sigma pos vel friction hand,
  physical mu beta sigma -> paper_motion mu beta sigma pos vel friction hand ->
  forall h t, INR h < t <= INR (S h) ->
  let d := pos t - pos (INR h) in
  let dtau := t - INR h in
  0 <= margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) (mean_speed d dtau) ->
  generated_linear (pos (INR h)) (pos t) <= bound_22 d /\
  bound_22 d <= dissipated_lower beta sigma d dtau /\
  dissipated_lower beta sigma d dtau <= dissipated beta sigma vel (INR h) t.
Proof.
  intros mu beta sigma pos vel friction hand P O h t Ht d dtau M. rewrite S_INR in Ht.
  split; [apply TH_LIN |]. split.
  - assert (Q : 0 <= surplus (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) d dtau).
    { rewrite EQ_27 by (unfold dtau; lra). apply Rmult_le_pos; [apply Rabs_pos | exact M]. }
    rewrite viscous_plain, coulomb_plain in Q.
    pose proof (TH_JITTER_on_time beta (1 / 2) (sigma - 1 / 2) ltac:(lra) d dtau) as J.
    specialize (J ltac:(unfold dtau; lra)). unfold jitter_surplus in J.
    unfold bound_22, dissipated_lower.
    replace (beta * d ^ 2 / dtau) with (beta / dtau * d ^ 2) by (field; unfold dtau; lra). lra.
  - apply EQ_26; [exact (is_kinematic _ _ _ _ _ _ _ _ _ O) | lra
      | exact (beta_nonneg _ _ _ P) | exact (sigma_nonneg _ _ _ P)].
Qed.

Section Run.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Hypothesis P : physical mu beta sigma.
Hypothesis O : paper_motion mu beta sigma pos vel friction hand.

(** TH-RUN (12): over any number of intervals, ending anywhere, if (8) holds at every
    instant then the operator has put in at least the growth of the storage S. *)
Theorem TH_RUN : forall t, 0 <= t ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  ex_RInt (fun u => hand u * vel u) 0 t /\
  storage mu (pos t) (vel t) - storage mu (pos 0) (vel 0) <= operator_energy vel hand 0 t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  destruct (TH_COMBINED mu beta sigma (fun x => x) linear_potential 0 0 (1 / 2) 0
    INR _ (fun _ => 0) pos vel friction hand P INR_increasing INR_on_time paper_wall O
    (paper_rendered pos _) N t HN) as (I & E).
  - simpl (INR 0). intros u Hu. specialize (H8 u Hu). unfold criterion_8 in H8.
    rewrite viscous_surplus_plain, coulomb_surplus_plain in H8. exact H8.
  - unfold extra_towards, extra_at in E. rewrite !no_extra in E. simpl (INR 0) in *.
    split; [exact I |]. unfold storage. lra.
Qed.

(** TH-RUN (more friction): a friction force beyond sigma and beta that opposes the motion, or holds
    the device at rest, is a force like the operator's, and takes energy: what the operator draws
    is still covered. *)
Theorem TH_RUN_more_friction : forall more operator : R -> R,
  (forall t, hand t = operator t - more t) -> (forall t, 0 <= more t * vel t) ->
  forall t, 0 <= t ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  ex_RInt (fun u => operator u * vel u) 0 t ->
  storage mu (pos t) (vel t) - storage mu (pos 0) (vel 0) <= operator_energy vel operator 0 t.
Proof.
  intros more operator E M t Ht H8 I. destruct (TH_RUN t Ht H8) as [J R].
  eapply Rle_trans; [exact R |]. unfold operator_energy.
  apply RInt_le; [exact Ht | exact J | exact I |].
  intros u _. rewrite E. specialize (M u). nra.
Qed.

(** TH-RUN (mean speeds): it is enough that the criterion holds at the mean speed of each
    interval reached, the last one up to where the run ends. *)
Theorem TH_RUN_mean : forall N t, INR N <= t <= INR (S N) ->
  (forall h r, reached INR N t h r -> INR h < r ->
     0 <= margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0)
                 (mean_speed (pos r - pos (INR h)) (r - INR h))) ->
  storage mu (pos t) (vel t) - storage mu (pos 0) (vel 0) <= operator_energy vel hand 0 t.
Proof.
  intros N t Ht M.
  destruct (TH_COMBINED_jitter mu beta sigma (fun x => x) linear_potential 0 0 (1 / 2) 0
    INR _ (fun _ => 0) pos vel friction hand P INR_increasing paper_wall O
    (paper_rendered pos _) N t Ht) as [_ E].
  - intros h r Hr Hlt. specialize (M h r Hr Hlt).
    destruct (reached_range INR INR_increasing N t Ht h r Hr) as (_ & _ & R2). rewrite S_INR in R2.
    rewrite viscous_surplus_plain, coulomb_surplus_plain in M.
    eapply Rle_trans; [| apply TH_JITTER_on_time; [unfold viscous_need; simpl (INR 0); lra | lra]].
    rewrite EQ_27 by lra. apply Rmult_le_pos; [apply Rabs_pos | exact M].
  - unfold extra_towards, extra_at in E. rewrite !no_extra in E. simpl (INR 0) in *.
    unfold storage. lra.
Qed.

(** TH-RUN (extracted): the energy drawn by the operator never exceeds S at the start. *)
Theorem TH_RUN_extracted : forall t, 0 <= t ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  - operator_energy vel hand 0 t <= storage mu (pos 0) (vel 0).
Proof.
  intros t Ht H8. destruct (TH_RUN t Ht H8) as [_ E].
  pose proof (storage_nonneg mu (pos t) (vel t)) as S.
  specialize (S (mu_positive _ _ _ P)). lra.
Qed.

(** TH-RUN (the paper's storage): with H_T of (17) it stands up to 1/8 in all. *)
Theorem TH_RUN_quantized : forall t, 0 <= t ->
  (forall u, 0 <= u <= t -> criterion_8 beta sigma (vel u)) ->
  quantized_storage mu (pos t) (vel t) - quantized_storage mu (pos 0) (vel 0) - 1 / 8
  <= operator_energy vel hand 0 t.
Proof.
  intros t Ht H8. destruct (TH_RUN t Ht H8) as [_ E].
  unfold storage, quantized_storage, quantized_potential in *.
  pose proof (TH_TELESCOPE_bounds (pos t)). pose proof (TH_TELESCOPE_bounds (pos 0)). lra.
Qed.

(** TH-RUN (every operator): beta and sigma of at least 1/2 make the display passive
    whatever the operator does. *)
Theorem TH_RUN_all_speeds : 1 / 2 <= beta -> 1 / 2 <= sigma -> forall t, 0 <= t ->
  - operator_energy vel hand 0 t <= storage mu (pos 0) (vel 0).
Proof.
  intros Hb Hs t Ht. apply TH_RUN_extracted; [exact Ht |]. intros u _ Hv.
  rewrite viscous_plain, coulomb_plain. unfold margin_8.
  assert (0 <= (sigma - 1 / 2) / Rabs (vel u)).
  { apply Rdiv_le_0_compat; [lra | apply Rabs_pos_lt; exact Hv]. }
  lra.
Qed.

End Run.
