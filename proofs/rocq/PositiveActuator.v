(** * PositiveActuator: a run under a force that looks back, with a 1-Lipschitz law or stiffer.

    At [t] in interval h the force is as far from the law at the present position as H times the
    way since the sample and the ways before, weighted (PositiveKernel.v), with something [extra]
    that is paid for elsewhere, and quantization. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Calculus Model History Law Combined
  Passivity Effects InstantRun Weighted Angles PositiveKernel.
Open Scope R_scope.

Section Positive.

Variables mu beta sigma H kappa more coulomb held_back : R.
Variables pos vel friction hand force f V weight : R -> R.
Variables late extra : nat -> R -> R.
Variables (extra_at_sample : nat -> R) (extra_to : nat -> R -> R).
Hypothesis P : physical mu beta sigma.
Hypothesis O : obeys mu beta sigma INR (fun _ => 0) pos vel friction (fun t => hand t + force t).
Hypothesis H_nonneg : 0 <= H.
Hypothesis f_continuous : forall x, continuous f x.
Hypothesis V_derivative : forall x, is_derive V x (f x).
Hypothesis late_continuous : forall n t, continuous (late n) t.
Hypothesis late_nonneg : forall n t, 0 <= t <= 1 -> 0 <= late n t.
Hypothesis weight_continuous : forall t, continuous weight t.
Hypothesis weight_positive : forall t, 0 < weight t.
Hypothesis shares : forall N, sum_to N (fun j => phase_mass weight (late (pred j))) <= held_back.
Hypothesis schur : forall N t, 0 <= t <= 1 ->
  phase_mass weight (fun _ => 1) / 2 * (1 + sum_to N (fun j => late (pred j) t)) + held_back / 2
  <= kappa * weight t.
Hypothesis work_integrable : forall h s t, INR h <= s <= t -> t <= INR (S h) ->
  ex_RInt (fun u => force u * vel u) s t.
(** What [extra] draws is paid by [more], with a storage of its own. *)
Hypothesis extra_integrable : forall h t, INR h <= t <= INR (S h) ->
  ex_RInt (fun u => Rabs (vel u) * extra h u) (INR h) t.
Hypothesis extra_paid : forall h t, INR h <= t <= INR (S h) ->
  RInt (fun u => Rabs (vel u) * extra h u) (INR h) t + (extra_to h t - extra_at_sample h)
  <= more * square_integral vel (INR h) t.
Hypothesis extra_arrives : forall h, extra_to h (INR (S h)) = extra_at_sample (S h).
Hypothesis extra_to_nonneg : forall h t, INR h <= t <= INR (S h) -> 0 <= extra_to h t.
Hypothesis extra_start : extra_at_sample 0 = 0.
Hypothesis close : forall h t, INR h < t < INR (S h) ->
  Rabs (force t + f (pos t))
  <= H * (way vel (INR h) t + ways_before vel late h t) + extra h t + coulomb.

Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.
Let r (u : R) : R := Rabs (vel u).

Lemma speed_continuous : forall t, continuous r t.
Proof. intro t. apply continuous_Rabs, (velocity_continuous _ _ K). Qed.

(** What the force draws in an interval. *)
Lemma force_work : forall h t, INR h <= t <= INR (S h) ->
  RInt (fun u => force u * vel u) (INR h) t + (V (pos t) - V (pos (INR h)))
  <= H * (way vel (INR h) t ^ 2 / 2 + RInt (fun u => r u * ways_before vel late h u) (INR h) t)
     + RInt (fun u => r u * extra h u) (INR h) t + coulomb * way vel (INR h) t.
Proof.
  intros h t Ht.
  assert (Cp : forall u, continuous (fun u => f (pos u) * vel u) u).
  { intro u. apply continuous_Rmult; [| apply (velocity_continuous _ _ K)].
    apply (continuous_comp pos f); [apply (pos_continuous _ _ K) | apply f_continuous]. }
  assert (Iv : is_RInt (fun u => f (pos u) * vel u) (INR h) t (V (pos t) - V (pos (INR h)))).
  { apply (is_RInt_primitive (fun u => V (pos u))); [| exact Cp].
    intro u. pose proof (is_derive_comp V pos u (f (pos u)) (vel u)
      (V_derivative (pos u)) (velocity_is_derivative _ _ K u)) as D.
    rewrite Rmult_comm. exact D. }
  assert (If : is_RInt (fun u => force u * vel u) (INR h) t
                 (RInt (fun u => force u * vel u) (INR h) t)).
  { apply RInt_is. apply (work_integrable h); lra. }
  assert (Dw : forall u, is_derive (way vel (INR h)) u (r u)).
  { intro u. apply (is_derive_RInt r (way vel (INR h)) (INR h)); [| apply speed_continuous].
    apply filter_forall. intro x. apply RInt_is, (speed_integrable pos vel K). }
  assert (Iw : is_RInt (fun u => r u * way vel (INR h) u) (INR h) t (way vel (INR h) t ^ 2 / 2)).
  { replace (way vel (INR h) t ^ 2 / 2)
      with (way vel (INR h) t ^ 2 / 2 - way vel (INR h) (INR h) ^ 2 / 2).
    - apply (is_RInt_primitive (fun u => way vel (INR h) u ^ 2 / 2)).
      + intro u. pose proof (Dw u) as Du. auto_derive.
        * exists (r u). exact Du.
        * replace (Derive (fun x => way vel (INR h) x) u) with (r u)
            by (symmetry; apply is_derive_unique; exact Du). field.
      + intro u. apply continuous_Rmult; [apply speed_continuous |].
        apply (ex_derive_continuous (way vel (INR h))). exists (r u). apply Dw.
    - unfold way at 2. rewrite RInt_point. change zero with 0. field. }
  assert (Is : is_RInt (fun u => r u * ways_before vel late h u) (INR h) t
                 (RInt (fun u => r u * ways_before vel late h u) (INR h) t)).
  { apply RInt_is. eexists. exact (ways_before_work pos vel late K late_continuous h t Ht). }
  assert (Ie : is_RInt (fun u => r u * extra h u) (INR h) t
                 (RInt (fun u => r u * extra h u) (INR h) t)).
  { apply RInt_is. exact (extra_integrable h t Ht). }
  assert (Ic : is_RInt (fun u => coulomb * r u) (INR h) t (coulomb * way vel (INR h) t)).
  { apply (@is_RInt_scal R_NormedModule), RInt_is, (speed_integrable pos vel K). }
  apply (is_RInt_le (fun u => force u * vel u + f (pos u) * vel u)
    (fun u => (H * (r u * way vel (INR h) u + r u * ways_before vel late h u)
       + r u * extra h u) + coulomb * r u)
    (INR h) t _ _ (proj1 Ht)).
  - apply (@is_RInt_plus R_NormedModule (fun u => force u * vel u)); [exact If | exact Iv].
  - apply (@is_RInt_plus R_NormedModule (fun u => H * (r u * way vel (INR h) u
       + r u * ways_before vel late h u) + r u * extra h u)); [| exact Ic].
    apply (@is_RInt_plus R_NormedModule (fun u => H * (r u * way vel (INR h) u
       + r u * ways_before vel late h u))); [| exact Ie].
    apply (@is_RInt_scal R_NormedModule).
    apply (@is_RInt_plus R_NormedModule (fun u => r u * way vel (INR h) u)); [exact Iw | exact Is].
  - intros u Hu. pose proof (close h u ltac:(lra)) as Cl.
    replace (force u * vel u + f (pos u) * vel u) with ((force u + f (pos u)) * vel u) by ring.
    eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult. fold (r u).
    apply (Rmult_le_compat_r (r u)) in Cl; [| apply Rabs_pos].
    eapply Rle_trans; [exact Cl |]. apply Req_le. ring.
Qed.

(** ** The run *)

Let held (h : nat) : R := H * kernel_held held_back vel weight late h + extra_at_sample h.
Let held_towards (h : nat) (t : R) : R :=
  H * kernel_towards held_back vel weight late h t + extra_to h t.

Let work (t : R) : R := RInt (fun u => force u * vel u) 0 t.

Lemma work_to : forall h t, INR h <= t <= INR (S h) -> ex_RInt (fun u => force u * vel u) 0 t.
Proof.
  induction h as [| h IH]; intros t Ht.
  - apply (work_integrable 0); simpl (INR 0) in *; lra.
  - apply (@ex_RInt_Chasles R_NormedModule) with (INR (S h)).
    + apply IH. rewrite S_INR. lra.
    + apply (work_integrable (S h)); lra.
Qed.

Lemma positive_charge : forall h t, INR h <= t <= INR (S h) ->
  (forall u, INR h <= u <= t -> vel u <> 0 ->
     0 <= margin_8 (beta - (H * kappa + more)) (sigma - coulomb) (vel u)) ->
  generated 0 (pos (INR h)) (pos t) (V (pos (INR h))) (V (pos t))
  + (held_towards h t + work t) - (held h + work (INR h)) <= dissipated beta sigma vel (INR h) t.
Proof.
  intros h t Ht H8.
  pose proof (instant_friction beta sigma (H * kappa + more) coulomb pos vel K (INR h) t
    (proj1 Ht) H8) as F.
  fold (way vel (INR h) t) in F. pose proof (force_work h t Ht) as G.
  pose proof (kernel_paid kappa 1 held_back pos vel weight late K Rle_0_1 late_continuous
    late_nonneg weight_continuous weight_positive schur h t Ht) as Kp.
  apply (Rmult_le_compat_l H) in Kp; [| exact H_nonneg].
  set (before := RInt (fun u => r u * ways_before vel late h u) (INR h) t) in *.
  set (besides := RInt (fun u => r u * extra h u) (INR h) t) in *.
  change (H * (1 * (way vel (INR h) t ^ 2 / 2) + before
    + (kernel_towards held_back vel weight late h t - kernel_held held_back vel weight late h))
    <= H * (kappa * square_integral vel (INR h) t)) in Kp.
  assert (Ep : besides + (extra_to h t - extra_at_sample h) <= more * square_integral vel (INR h) t)
    by exact (extra_paid h t Ht).
  assert (S1 : work t - work (INR h) = RInt (fun u => force u * vel u) (INR h) t).
  { unfold work. rewrite (RInt_split _ 0 (INR h) t); [ring | |].
    - apply (work_to h). lra.
    - apply (work_integrable h); lra. }
  unfold generated, held, held_towards. lra.
Qed.

Lemma positive_run : forall t, 0 <= t ->
  criterion_holds (beta - (H * kappa + more)) (sigma - coulomb) vel t ->
  passive_run vel hand (kinetic mu (vel 0) + V (pos 0)) (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  destruct (EQ_14_run mu beta sigma INR (fun _ => 0) pos vel friction (fun u => hand u + force u)
    P O V (fun h => held h + work (INR h)) (fun h t => held_towards h t + work t) INR_increasing)
    with (N := N) (t := t) as (I & E).
  - intro h. unfold held, held_towards.
    rewrite (kernel_arrives held_back vel weight late), extra_arrives. reflexivity.
  - exact HN.
  - intros h u Hr.
    destruct (reached_range _ INR_increasing N t HN h u Hr) as (R0 & R1 & R2).
    assert (R3 : INR h <= u).
    { destruct Hr as [[_ ->] | [-> ->]]; [rewrite S_INR; lra | lra]. }
    apply positive_charge; [lra |]. intros v Hv. apply H8. simpl (INR 0) in R0. lra.
  - simpl (INR 0) in *.
    assert (Iw : ex_RInt (fun u => force u * vel u) 0 t) by (apply (work_to N); exact HN).
    assert (Ih : is_RInt (fun u => hand u * vel u) 0 t
      (operator_energy vel (fun u => hand u + force u) 0 t - work t))
      by exact (hand_apart vel hand force 0 t Iw I).
    split; [eexists; exact Ih |].
    unfold operator_energy at 1. rewrite (is_RInt_unique _ _ _ _ Ih).
    assert (W0 : work 0 = 0) by (unfold work; rewrite RInt_point; reflexivity).
    assert (H0 : held 0 = 0) by (unfold held, kernel_held; rewrite extra_start; simpl; field).
    assert (0 <= H * kernel_towards held_back vel weight late N t).
    { apply Rmult_le_pos; [exact H_nonneg |].
      apply (kernel_nonneg held_back pos vel weight late K); assumption. }
    pose proof (extra_to_nonneg N t HN). unfold held_towards in E. rewrite W0, H0 in E. lra.
Qed.

End Positive.
