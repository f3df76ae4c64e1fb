(** * Calculus: the integrals that the motion's energy needs, and induction over time. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer.
Open Scope R_scope.

(** Coquelicot states equalities in a normed module; over the reals they are plain ones. *)
Ltac over_R := intros; match goal with |- @eq _ ?x ?y => change (@eq R x y) end.

(** ** Continuous integrands *)

Lemma ex_RInt_cont : forall (f : R -> R) a b, (forall t, continuous f t) -> ex_RInt f a b.
Proof. intros f a b H. apply (@ex_RInt_continuous R_CompleteNormedModule). intros; apply H. Qed.

Lemma RInt_is : forall (f : R -> R) a b, ex_RInt f a b -> is_RInt f a b (RInt f a b).
Proof. intros f a b H. apply (@RInt_correct R_CompleteNormedModule). exact H. Qed.

Lemma RInt_split : forall (f : R -> R) a b c,
  ex_RInt f a b -> ex_RInt f b c -> RInt f a c = RInt f a b + RInt f b c.
Proof.
  intros f a b c H1 H2. symmetry. apply (@RInt_Chasles R_CompleteNormedModule); assumption.
Qed.

Lemma is_RInt_join : forall (f : R -> R) a b c x y,
  is_RInt f a b x -> is_RInt f b c y -> is_RInt f a c (x + y).
Proof. intros f a b c x y. apply (@is_RInt_Chasles R_NormedModule). Qed.

Lemma ex_RInt_part : forall (f : R -> R) a b s t,
  ex_RInt f a b -> a <= s <= t -> t <= b -> ex_RInt f s t.
Proof.
  intros f a b s t H H1 H2.
  apply (@ex_RInt_Chasles_1 R_CompleteNormedModule) with b; [lra |].
  apply (@ex_RInt_Chasles_2 R_CompleteNormedModule) with a; [lra | exact H].
Qed.

(** The fundamental theorem, on the real line. *)
Lemma is_RInt_primitive : forall (f df : R -> R) a b,
  (forall t, is_derive f t (df t)) -> (forall t, continuous df t) ->
  is_RInt df a b (f b - f a).
Proof.
  intros f df a b Hd Hc. apply (is_RInt_derive f df); intros; [apply Hd | apply Hc].
Qed.

Lemma RInt_primitive : forall (f df : R -> R) a b,
  (forall t, is_derive f t (df t)) -> (forall t, continuous df t) ->
  RInt df a b = f b - f a.
Proof. intros. apply is_RInt_unique, is_RInt_primitive; assumption. Qed.

Lemma continuous_Rmult : forall (f g : R -> R) x,
  continuous f x -> continuous g x -> continuous (fun t => f t * g t) x.
Proof. intros. apply (continuous_mult f g); assumption. Qed.

Lemma continuous_Rplus : forall (f g : R -> R) x,
  continuous f x -> continuous g x -> continuous (fun t => f t + g t) x.
Proof. intros. apply (continuous_plus f g); assumption. Qed.

Lemma continuous_Rabs : forall (f : R -> R) x,
  continuous f x -> continuous (fun t => Rabs (f t)) x.
Proof.
  intros. apply (continuous_comp f Rabs); [assumption |].
  apply continuity_pt_filterlim, Rcontinuity_abs.
Qed.

Lemma continuous_near : forall (f : R -> R) x eps, continuous f x -> 0 < eps ->
  exists r, 0 < r /\ forall u, Rabs (u - x) < r -> Rabs (f u - f x) < eps.
Proof.
  intros f x eps C He. destruct (C (fun y => Rabs (y - f x) < eps)) as (r & Hr).
  - exists (mkposreal eps He). intros y Hy. exact Hy.
  - exists r. split; [apply cond_pos |]. intros u Hu. apply Hr, Hu.
Qed.

Lemma continuous_friction_power : forall beta sigma (v : R -> R) x,
  continuous v x -> continuous (fun t => friction_power beta sigma (v t)) x.
Proof.
  intros. unfold friction_power. apply continuous_Rplus.
  - apply continuous_Rmult; [apply continuous_const |]. simpl.
    apply continuous_Rmult; [assumption |].
    apply continuous_Rmult; [assumption | apply continuous_const].
  - apply continuous_Rmult; [apply continuous_const | apply continuous_Rabs; assumption].
Qed.

(** ** Work of a force along a motion driven by it

    If [G] grows by the integral of a merely integrable [g], then the integral of
    [g * G] exists and is the growth of [G^2/2]: what turns (6) into energies. *)

Section Work.

Variables (g G : R -> R) (a b M : R).
Hypothesis ab : a < b.
Hypothesis g_int : ex_RInt g a b.
Hypothesis g_bound : forall t, a <= t <= b -> Rabs (g t) <= M.
Hypothesis G_grows : forall s t, a <= s <= t -> t <= b -> G t - G s = RInt g s t.

Lemma M_nonneg : 0 <= M.
Proof. apply Rle_trans with (Rabs (g a)); [apply Rabs_pos | apply g_bound; lra]. Qed.

Lemma g_sub : forall s t, a <= s <= t -> t <= b -> ex_RInt g s t.
Proof. intros s t. apply ex_RInt_part with (1 := g_int). Qed.

Lemma G_lipschitz : forall s t, a <= s <= t -> t <= b -> Rabs (G t - G s) <= (t - s) * M.
Proof.
  intros s t H1 H2. rewrite G_grows by assumption.
  apply abs_RInt_le_const; [lra | apply g_sub; assumption |].
  intros; apply g_bound; lra.
Qed.

(** The interval cut in [S n] equal pieces. *)
Definition cut (n i : nat) : R := a + INR i * ((b - a) / INR (S n)).

Lemma cut_step : forall n i, cut n (S i) - cut n i = (b - a) / INR (S n).
Proof. intros. unfold cut. rewrite (S_INR i). ring. Qed.

Lemma piece_pos : forall n, 0 < (b - a) / INR (S n).
Proof. intro n. apply Rdiv_lt_0_compat; [lra | apply lt_0_INR; lia]. Qed.

Lemma cut_last : forall n, cut n (S n) = b.
Proof. intro n. unfold cut. field. apply not_0_INR. lia. Qed.

Lemma cut_range : forall n i, (i <= S n)%nat -> a <= cut n i <= b.
Proof.
  intros n i Hi. pose proof (piece_pos n) as P. split.
  - unfold cut. pose proof (pos_INR i). nra.
  - rewrite <- (cut_last n). unfold cut. apply le_INR in Hi. nra.
Qed.

(** On each piece, the mean of [G] at its two ends. *)
Definition mean_at (n i : nat) : R := (G (cut n i) + G (cut n (S i))) / 2.

Definition piece_of (n : nat) (x : R) : nat :=
  Z.to_nat (Int_part ((x - a) / ((b - a) / INR (S n)))).

Lemma piece_of_inside : forall n i x, cut n i < x < cut n (S i) -> piece_of n x = i.
Proof.
  intros n i x [L U]. unfold piece_of. pose proof (piece_pos n) as P.
  set (e := (b - a) / INR (S n)) in *.
  assert (E : floor ((x - a) / e) = IZR (Z.of_nat i)).
  { apply floor_unique. rewrite <- INR_IZR_INZ. unfold cut in L, U. rewrite (S_INR i) in U.
    fold e in L, U. split.
    - apply Rmult_le_reg_r with e; [exact P |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - apply Rmult_lt_reg_r with e; [exact P |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  unfold floor in E. apply eq_IZR in E. rewrite E. apply Nat2Z.id.
Qed.

Lemma piece_of_spec : forall n x, a < x < b ->
  (piece_of n x <= n)%nat /\ cut n (piece_of n x) <= x <= cut n (S (piece_of n x)).
Proof.
  intros n x Hx. pose proof (piece_pos n) as P. pose proof (cut_last n) as CL.
  unfold piece_of. unfold cut in *.
  rewrite (S_INR (Z.to_nat _)). set (e := (b - a) / INR (S n)) in *.
  set (q := (x - a) / e).
  assert (Q : q * e = x - a) by (unfold q; field; lra).
  assert (Q0 : 0 < q) by (unfold q; apply Rdiv_lt_0_compat; lra).
  assert (Q1 : q < INR (S n)) by (apply Rmult_lt_reg_r with e; lra).
  pose proof (floor_spec q) as F. unfold floor in F.
  assert (Z0 : (0 <= Int_part q)%Z).
  { apply le_IZR. rewrite <- (floor_IZR 0). apply (floor_monotone 0 q). lra. }
  assert (I : INR (Z.to_nat (Int_part q)) = IZR (Int_part q)).
  { rewrite INR_IZR_INZ, Z2Nat.id by exact Z0. reflexivity. }
  fold q. rewrite I. split; [| nra].
  assert (Int_part q < Z.of_nat (S n))%Z; [| lia].
  apply lt_IZR. rewrite <- INR_IZR_INZ. lra.
Qed.

Definition inside (x : R) (y : R) : R :=
  if Rlt_dec a x then if Rlt_dec x b then y else 0 else 0.

Lemma inside_in : forall x y, a < x < b -> inside x y = y.
Proof. intros x y H. unfold inside. destruct Rlt_dec; [destruct Rlt_dec |]; lra. Qed.

Lemma step_integral : forall n i, (i <= n)%nat ->
  is_RInt (fun x => inside x (g x * mean_at n (piece_of n x))) (cut n i) (cut n (S i))
          ((G (cut n (S i)) ^ 2 - G (cut n i) ^ 2) / 2).
Proof.
  intros n i Hi. pose proof (cut_range n i) as R1. pose proof (cut_range n (S i)) as R2.
  pose proof (cut_step n i) as St. pose proof (piece_pos n) as P.
  apply is_RInt_ext with (fun x => mean_at n i * g x).
  - intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra.
    rewrite inside_in.
    + rewrite (piece_of_inside n i x Hx). apply Rmult_comm.
    + assert (i <= S n)%nat as L1 by lia. assert (S i <= S n)%nat as L2 by lia.
      specialize (R1 L1). specialize (R2 L2). lra.
  - replace ((G (cut n (S i)) ^ 2 - G (cut n i) ^ 2) / 2)
      with (mean_at n i * RInt g (cut n i) (cut n (S i))).
    + apply (is_RInt_scal g), RInt_is, g_sub;
        [specialize (R1 ltac:(lia)) | specialize (R2 ltac:(lia))]; lra.
    + rewrite <- G_grows; [unfold mean_at; field | |];
        [specialize (R1 ltac:(lia)) | specialize (R2 ltac:(lia))]; lra.
Qed.

Lemma steps_integral : forall n i, (i <= S n)%nat ->
  is_RInt (fun x => inside x (g x * mean_at n (piece_of n x))) a (cut n i)
          ((G (cut n i) ^ 2 - G a ^ 2) / 2).
Proof.
  intros n i. induction i as [| i IH]; intro Hi.
  - replace (cut n 0) with a by (unfold cut; simpl; ring).
    replace ((G a ^ 2 - G a ^ 2) / 2) with 0 by field.
    apply (@is_RInt_point R_NormedModule).
  - replace ((G (cut n (S i)) ^ 2 - G a ^ 2) / 2)
      with ((G (cut n i) ^ 2 - G a ^ 2) / 2
            + (G (cut n (S i)) ^ 2 - G (cut n i) ^ 2) / 2) by field.
    apply is_RInt_join with (cut n i); [apply IH; lia | apply step_integral; lia].
Qed.

Lemma steps_uniform : forall n x,
  Rabs (inside x (g x * mean_at n (piece_of n x)) - inside x (g x * G x))
  <= M * M * (b - a) / INR (S n).
Proof.
  intros n x. pose proof M_nonneg as M0. pose proof (piece_pos n) as P.
  replace (M * M * (b - a) / INR (S n)) with (M * (M * ((b - a) / INR (S n))))
    by (field; apply not_0_INR; lia).
  unfold inside. destruct Rlt_dec as [L |]; [destruct Rlt_dec as [U |] |];
    try (rewrite Rminus_0_r, Rabs_R0; apply Rmult_le_pos; nra).
  replace (g x * mean_at n (piece_of n x) - g x * G x)
    with (g x * (mean_at n (piece_of n x) - G x)) by ring.
  rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [apply g_bound; lra |].
  destruct (piece_of_spec n x) as (Hi & C1 & C2); [lra |].
  set (i := piece_of n x) in *. pose proof (cut_step n i) as St.
  pose proof (cut_range n i ltac:(lia)) as R1. pose proof (cut_range n (S i) ltac:(lia)) as R2.
  pose proof (G_lipschitz (cut n i) x) as L1. pose proof (G_lipschitz x (cut n (S i))) as L2.
  specialize (L1 ltac:(lra) ltac:(lra)). specialize (L2 ltac:(lra) ltac:(lra)).
  unfold mean_at. apply Rabs_le. apply Rabs_le_between in L1. apply Rabs_le_between in L2.
  split; nra.
Qed.

(** The work of [g] along [G]. *)
Lemma work_of_growth : is_RInt (fun x => g x * G x) a b ((G b ^ 2 - G a ^ 2) / 2).
Proof.
  destruct (@filterlim_RInt nat R_CompleteNormedModule
    (fun n x => inside x (g x * mean_at n (piece_of n x))) a b eventually _
    (fun x => inside x (g x * G x)) (fun _ => (G b ^ 2 - G a ^ 2) / 2)) as (I & L & H).
  - intro n. pose proof (steps_integral n (S n) (le_n _)) as H. rewrite cut_last in H. exact H.
  - apply filterlim_locally. intro eps.
    assert (K : 0 <= M * M * (b - a)) by (pose proof M_nonneg; nra).
    destruct (nfloor_ex (M * M * (b - a) / eps)) as (N & _ & HN).
    { apply Rdiv_le_0_compat; [exact K | apply cond_pos]. }
    exists N. intros n Hn x. apply Rle_lt_trans with (1 := steps_uniform n x).
    assert (INR N + 1 <= INR (S n)) by (rewrite <- S_INR; apply le_INR; lia).
    pose proof (pos_INR N). pose proof (cond_pos eps).
    apply Rmult_lt_reg_r with (INR (S n)); [lra |].
    unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rmult_lt_compat_r with (r := eps) in HN; [| assumption].
    unfold Rdiv in HN. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in HN by lra. nra.
  - assert (E : I = (G b ^ 2 - G a ^ 2) / 2).
    { eapply (filterlim_locally_unique (F := eventually)); [exact L | apply filterlim_const]. }
    rewrite <- E. apply is_RInt_ext with (2 := H).
    intros x Hx. rewrite Rmin_left, Rmax_right in Hx by lra. apply inside_in. exact Hx.
Qed.

End Work.
