(** * GatedController: TH-LTI for a wall on one side, or saturated, with any finite response.

    The bound takes the absolute values of the tails: with k samples of delay it costs
    H(1)(1/2 + k) + |g_1| + ... + |g_n| of viscous friction, and of Coulomb friction what the
    wall without gate and saturation costs. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined
  Passivity Laws Effects Controller Angles ChargedRun LinearController FiniteResponse.
Open Scope R_scope.

(** |g_1| + ... + |g_n|. *)
Definition tails_norm (g : nat -> R) (n : nat) : R := sum_to n (fun j => Rabs (g j)).

(** Each tail remembers the squares up to its own displacement, k samples late. *)
Definition tails_storage (k : nat) (g : nat -> R) (n : nat) (s : nat -> R) : R :=
  sum_to n (fun j => damping_storage (k + pred j) (Rabs (g j)) s).

Definition gated_storage (H : R) (k : nat) (g : nat -> R) (n : nat) (s : nat -> R) : R :=
  H * delay_storage k s + tails_storage k g n s.

Lemma tails_storage_push : forall k g n d s,
  tails_storage k g n (push d s) - tails_storage k g n s
  = sum_to n (fun j => Rabs (g j) * (d ^ 2 - s (k + j)%nat ^ 2) / 2).
Proof.
  intros k g n d s. unfold tails_storage.
  rewrite (sum_to_ext n (fun j => damping_storage (k + pred j) (Rabs (g j)) (push d s))
    (fun j => damping_storage (k + pred j) (Rabs (g j)) s
              + Rabs (g j) * (d ^ 2 - s (k + j)%nat ^ 2) / 2)).
  - rewrite sum_to_plus. ring.
  - intros j Hj. pose proof (damping_storage_push (k + pred j) (Rabs (g j)) d s) as E.
    replace (S (k + pred j)) with (k + j)%nat in E by lia. lra.
Qed.

Lemma gated_storage_nonneg : forall H k g n s, 0 <= H -> 0 <= gated_storage H k g n s.
Proof.
  intros H k g n s H0. unfold gated_storage. pose proof (delay_storage_nonneg k s).
  assert (0 <= tails_storage k g n s).
  { apply sum_to_nonneg. intros j _. apply damping_storage_nonneg, Rabs_pos. }
  assert (0 <= H * delay_storage k s) by (apply Rmult_le_pos; assumption). lra.
Qed.

Lemma gated_storage_at_rest : forall H k g n s, (forall j, s j = 0) ->
  gated_storage H k g n s = 0.
Proof.
  intros H k g n s Z. unfold gated_storage, tails_storage.
  rewrite delay_storage_at_rest, sum_to_zero; [ring | | exact Z].
  intros. apply damping_storage_at_rest, Z.
Qed.

Lemma gated_storage_ext : forall H k g n s s', (forall j, (1 <= j)%nat -> s j = s' j) ->
  gated_storage H k g n s = gated_storage H k g n s'.
Proof.
  intros H k g n s s' E. unfold gated_storage, tails_storage, delay_storage, damping_storage.
  f_equal.
  - f_equal. apply sum_to_ext. intros j Hj. rewrite E by lia. reflexivity.
  - apply sum_to_ext. intros j _. do 2 f_equal. apply sum_to_ext.
    intros i Hi. rewrite E by lia. reflexivity.
Qed.

Section Law.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variables past held : nat -> R.
Variables (H : R) (g : nat -> R) (n k : nat) (coulomb : R) (f V : R -> R).
Hypothesis P : physical mu beta sigma.
Hypothesis O : obeys mu beta sigma INR held pos vel friction hand.
Hypothesis H_nonneg : 0 <= H.
Hypothesis parabola : forall x0 x1, V x1 - V x0 <= f x0 * (x1 - x0) + H * (x1 - x0) ^ 2 / 2.
(** How far the held force is from the law at the true position. *)
Hypothesis commanded : forall h,
  Rabs (held h + f (pos (INR h)))
  <= H * sum_to k (fun j => Rabs (step INR pos past h j))
     + sum_to n (fun j => Rabs (g j) * Rabs (step INR pos past h (k + j))) + coulomb.

Let need := H / 2 + H * INR k + tails_norm g n.
Let W (h : nat) : R := gated_storage H k g n (step INR pos past h).
Let X (h : nat) (t : R) : R := gated_storage H k g n (push (pos t - pos (INR h)) (step INR pos past h)).

Lemma law_arrives : forall h, X h (INR (S h)) = W (S h).
Proof.
  intro h. apply gated_storage_ext. intros j Hj. symmetry. apply step_next. exact Hj.
Qed.

Lemma law_charge : forall h t, INR h <= t <= INR (S h) ->
  generated (held h) (pos (INR h)) (pos t) (V (pos (INR h))) (V (pos t)) + X h t - W h
  <= need * (pos t - pos (INR h)) ^ 2 + coulomb * Rabs (pos t - pos (INR h)).
Proof.
  intros h t _. pose proof (parabola (pos (INR h)) (pos t)) as Pb.
  set (d := pos t - pos (INR h)) in *. set (s := step INR pos past h).
  unfold X, W. fold d s. unfold gated_storage.
  pose proof (delay_storage_push k d s) as D. pose proof (tails_storage_push k g n d s) as T.
  pose proof (path_by_squares k d s) as Ps. apply (Rmult_le_compat_l H) in Ps; [| exact H_nonneg].
  assert (Q : Rabs d * sum_to n (fun j => Rabs (g j) * Rabs (s (k + j)%nat))
    + sum_to n (fun j => Rabs (g j) * (d ^ 2 - s (k + j)%nat ^ 2) / 2) <= tails_norm g n * d ^ 2).
  { unfold tails_norm.
    rewrite <- sum_to_scal, <- sum_to_plus, (Rmult_comm _ (d ^ 2)), <- sum_to_scal.
    apply sum_to_le. intros j _. pose proof (Rabs_pos (g j)) as G0.
    pose proof (pow2_ge_0 (Rabs d - Rabs (s (k + j)%nat))) as Sq.
    pose proof (pow2_abs d) as P1. pose proof (pow2_abs (s (k + j)%nat)) as P2.
    assert (Rabs d * Rabs (s (k + j)%nat) <= (d ^ 2 + s (k + j)%nat ^ 2) / 2) by nra. nra. }
  assert (E : (held h + f (pos (INR h))) * d
    <= (H * sum_to k (fun j => Rabs (s j)) + sum_to n (fun j => Rabs (g j) * Rabs (s (k + j)%nat))
        + coulomb) * Rabs d).
  { eapply Rle_trans; [apply Rle_abs |]. rewrite Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos | apply commanded]. }
  unfold generated, need. fold d.
  set (path := sum_to k (fun j => Rabs (s j))) in *.
  set (far := sum_to n (fun j => Rabs (g j) * Rabs (s (k + j)%nat))) in *.
  set (sq := sum_to k (fun j => s j ^ 2)) in *.
  assert (HD : H * (delay_storage k (push d s) - delay_storage k s)
    = H * (INR k * d ^ 2 / 2 - sq / 2)) by (rewrite D; reflexivity).
  nra.
Qed.

Lemma law_run : forall t, 0 <= t ->
  criterion_holds (beta - need) (sigma - coulomb) vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + V (pos 0) + gated_storage H k g n (step INR pos past 0))
    (kinetic mu (vel t) + V (pos t)) t.
Proof.
  intros t Ht H8. destruct (INR_covers t Ht) as (N & HN).
  assert (N0 : 0 <= need).
  { unfold need, tails_norm. pose proof (pos_INR k).
    assert (0 <= sum_to n (fun j => Rabs (g j))) by (apply sum_to_nonneg; intros; apply Rabs_pos).
    assert (0 <= H * INR k) by (apply Rmult_le_pos; assumption). lra. }
  destruct (charged_run mu beta sigma need coulomb INR held pos vel friction hand V W X
    P INR_increasing O law_arrives law_charge INR_on_time N0 N t HN) as (I & E).
  - simpl (INR 0). exact H8.
  - assert (0 <= X N t) by (apply gated_storage_nonneg; exact H_nonneg).
    simpl (INR 0) in *. split; [exact I |].
    change (gated_storage H k g n (step INR pos past 0)) with (W 0%nat). lra.
Qed.

End Law.

(** How far the filter's output is from the spring H(1). *)
Lemma filter_far : forall c n x,
  Rabs (convolution c n x - tail c n 0 * x 0%nat)
  <= sum_to n (fun j => Rabs (tail c n j) * Rabs (x (pred j) - x j)).
Proof.
  intros c n x. rewrite (TH_LTI_tails c n n) by lia. unfold linear_command.
  replace (tail c n 0 * x 0%nat - sum_to n (fun j => tail c n j * (x (pred j) - x j))
           - tail c n 0 * x 0%nat)
    with (- sum_to n (fun j => tail c n j * (x (pred j) - x j))) by ring.
  rewrite Rabs_Ropp.
  assert (G : forall N, Rabs (sum_to N (fun j => tail c n j * (x (pred j) - x j)))
                        <= sum_to N (fun j => Rabs (tail c n j) * Rabs (x (pred j) - x j))).
  { induction N as [| N IH]; [simpl; rewrite Rabs_R0; lra |].
    rewrite !sum_to_S. eapply Rle_trans; [apply Rabs_triang |].
    apply Rplus_le_compat; [exact IH |]. rewrite Rabs_mult. lra. }
  apply G.
Qed.

(** The potential of a wall of stiffness [H], one-sided or saturated. *)
Definition scaled_potential (H : R) (one_sided : bool) (limit : option R) (x : R) : R :=
  controller_potential one_sided limit (H * x) / H.

Lemma scaled_parabola : forall H s l, 0 <= H -> limit_nonneg l -> forall x0 x1,
  scaled_potential H s l x1 - scaled_potential H s l x0
  <= controller_law s l (H * x0) * (x1 - x0) + H * (x1 - x0) ^ 2 / 2.
Proof.
  intros H s l H0 Hl x0 x1. unfold scaled_potential. destruct H0 as [H0 | <-].
  - pose proof (below_parabola _ _ (controller_law_lipschitz s l)
      (potential_derivative _ _ (controller_law_potential s l Hl)) (H * x0) (H * x1)) as B.
    cbv beta in B. apply Rmult_le_reg_l with H; [exact H0 |].
    set (p0 := controller_potential s l (H * x0)) in *.
    set (p1 := controller_potential s l (H * x1)) in *.
    replace (H * (p1 / H - p0 / H)) with (p1 - p0) by (field; lra). nra.
  - rewrite !Rmult_0_l, Rminus_diag_eq by reflexivity.
    assert (Z : controller_law s l 0 = 0).
    { destruct s, l as [L |]; simpl in *; unfold clipped, clipped_below, Rmin, Rmax;
        repeat destruct Rle_dec; lra. }
    rewrite Z. lra.
Qed.

Lemma scaled_derivative : forall H s l, 0 <= H -> limit_nonneg l -> forall x,
  is_derive (scaled_potential H s l) x (controller_law s l (H * x)).
Proof.
  intros H s l H0 Hl x. pose proof (controller_law_potential s l Hl) as [D _].
  assert (L : is_derive (fun x => H * x) x H) by (auto_derive; [exact I | ring]).
  pose proof (is_derive_comp _ _ x _ _ (D (H * x)) L) as C. destruct H0 as [H0 | <-].
  - pose proof (is_derive_scal _ x (/ H) _ C) as Sc.
    unfold scal in Sc. simpl in Sc. unfold mult in Sc. simpl in Sc.
    replace (controller_law s l (H * x)) with (/ H * (H * controller_law s l (H * x)))
      by (field; lra).
    apply is_derive_ext with (2 := Sc). intro v. unfold scaled_potential. over_R.
    unfold Rdiv. apply Rmult_comm.
  - assert (Z : controller_law s l (0 * x) = 0).
    { rewrite Rmult_0_l. destruct s, l as [b |]; simpl in *;
        unfold clipped, clipped_below, Rmin, Rmax; repeat destruct Rle_dec; lra. }
    rewrite Z. apply is_derive_ext with (fun _ : R => scaled_potential 0 s l x).
    + intro v. unfold scaled_potential. rewrite !Rmult_0_l. reflexivity.
    + apply (@is_derive_const R_AbsRing R_NormedModule).
Qed.

Lemma gated_scale : forall H s x, 0 <= H -> gated s (H * x) (H * x) = gated s x (H * x).
Proof.
  intros H [|] x H0; [| reflexivity]. unfold gated.
  destruct (Rlt_dec (H * x) 0), (Rlt_dec x 0); nra.
Qed.

Section Gated.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (c : nat -> R) (n k : nat) (one_sided : bool) (force_step limit : option R).
Variables (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
Hypothesis limit_ok : limit_nonneg limit.
(** With an encoder [measured] and 1/2; without one the identity and 0.  Either tells the side. *)
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
Hypothesis measure_side : forall x, measure x < 0 <-> x < 0.
Hypothesis sum_nonneg : 0 <= tail c n 0.

(** The held force of the program: k samples late, the filter's output is cut off where the
    measured position is outside a wall on one side, rounded, and limited. *)
Definition held_by_gated (h : nat) : R :=
  let q j := measure (sample INR pos past h (k + j)) in
  limited limit (stepped force_step (- gated one_sided (q 0%nat) (convolution c n q))).

Hypothesis O : obeys mu beta sigma INR held_by_gated pos vel friction hand.

Let H := tail c n 0.
Let V := scaled_potential H one_sided limit.
Let coulomb := e * response_norm c n + step_size force_step / 2.

(** What the gate makes of the filter's output is as far from the wall's force as the output. *)
Lemma gate_error : forall x0 xk y q path rest, (q < 0 <-> xk < 0) ->
  Rabs (x0 - xk) <= path -> Rabs (y - H * xk) <= rest ->
  Rabs (gated one_sided q y - gated one_sided x0 (H * x0)) <= H * path + rest.
Proof.
  intros x0 xk y q path rest Hq Hp Hy.
  assert (H0 : 0 <= H) by exact sum_nonneg.
  assert (A : H * Rabs (x0 - xk) <= H * path) by (apply Rmult_le_compat_l; assumption).
  assert (Plain : Rabs (y - H * x0) <= H * path + rest).
  { replace (y - H * x0) with ((y - H * xk) + - (H * (x0 - xk))) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp, Rabs_mult, (Rabs_right H) by lra.
    lra. }
  pose proof (Rabs_pos (y - H * xk)) as R0. pose proof (Rabs_pos (x0 - xk)) as R1.
  assert (R2 : 0 <= H * Rabs (x0 - xk)) by (apply Rmult_le_pos; assumption).
  unfold gated. destruct one_sided; [| exact Plain].
  destruct (Rlt_dec q 0) as [Q | Q]; destruct (Rlt_dec x0 0) as [X0 | X0].
  - replace (0 - 0) with 0 by ring. rewrite Rabs_R0. lra.
  - assert (xk < 0) by (apply Hq, Q).
    replace (0 - H * x0) with (- (H * x0)) by ring. rewrite Rabs_Ropp.
    rewrite Rabs_right by nra. rewrite Rabs_right in A by lra. nra.
  - assert (~ xk < 0) by (intro Z; apply Q, Hq, Z).
    rewrite Rminus_0_r. replace y with ((y - H * xk) + H * xk) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. rewrite (Rabs_right (H * xk)) by nra.
    rewrite Rabs_left1 in A by lra. nra.
  - exact Plain.
Qed.

Lemma gated_commanded : forall h,
  Rabs (held_by_gated h + controller_law one_sided limit (H * pos (INR h)))
  <= H * sum_to k (fun j => Rabs (step INR pos past h j))
     + sum_to n (fun j => Rabs (tail c n j) * Rabs (step INR pos past h (k + j))) + coulomb.
Proof.
  intro h. set (x := fun j => sample INR pos past h (k + j)). set (q := fun j => measure (x j)).
  set (s := step INR pos past h). set (x0 := pos (INR h)).
  set (far := sum_to n (fun j => Rabs (tail c n j) * Rabs (s (k + j)%nat))).
  assert (Y : Rabs (convolution c n q - H * x 0%nat) <= far + e * response_norm c n).
  { pose proof (TH_LTI_quantization c n q x e (fun j => measure_error (x j))) as Q.
    assert (F : Rabs (convolution c n x - H * x 0%nat) <= far).
    { eapply Rle_trans; [apply filter_far |]. apply sum_to_le. intros [| j] Hj; [lia |].
      simpl pred. unfold s, step, x. replace (k + S j)%nat with (S (k + j)) by lia.
      simpl pred. lra. }
    replace (convolution c n q - H * x 0%nat)
      with ((convolution c n q - convolution c n x) + (convolution c n x - H * x 0%nat)) by ring.
    eapply Rle_trans; [apply Rabs_triang | lra]. }
  pose proof (delayed_distance INR pos past h k) as Dk. fold s x0 in Dk.
  replace (sample INR pos past h k) with (x 0%nat) in Dk by (unfold x; f_equal; lia).
  pose proof (gate_error x0 (x 0%nat) _ (q 0%nat) _ _ (measure_side (x 0%nat)) Dk Y) as G.
  rewrite <- (undamped one_sided limit (H * x0) limit_ok), gated_scale by exact sum_nonneg.
  change (held_by_gated h) with (limited limit (stepped force_step
    (- gated one_sided (q 0%nat) (convolution c n q)))).
  set (g1 := gated one_sided (q 0%nat) (convolution c n q)) in *.
  set (g0 := gated one_sided x0 (H * x0)) in *.
  eapply Rle_trans; [apply limited_lipschitz |].
  pose proof (stepped_error force_step (- g1) step_ok) as R.
  replace (stepped force_step (- g1) - - g0)
    with ((stepped force_step (- g1) - - g1) + - (g1 - g0)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. unfold coulomb. lra.
Qed.

(** TH-LTI (one-sided, saturated): the criterion is
    (beta - H(1)(1/2 + k) - |g_1| - ... - |g_n|)|v| + (sigma - e|c|_1 - delta/2) >= 0. *)
Theorem TH_LTI_gated : forall t, 0 <= t ->
  criterion_holds (beta - (H / 2 + H * INR k + tails_norm (tail c n) n)) (sigma - coulomb) vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + V (pos 0) + gated_storage H k (tail c n) n (step INR pos past 0))
    (kinetic mu (vel t) + V (pos t)) t.
Proof.
  exact (law_run mu beta sigma pos vel friction hand past held_by_gated H (tail c n) n k coulomb
    (fun x => controller_law one_sided limit (H * x)) V P O sum_nonneg
    (scaled_parabola H one_sided limit sum_nonneg limit_ok) gated_commanded).
Qed.

End Gated.

(** TH-LTI (any law): a force that is a 1-Lipschitz law of the filter's output. *)
Section AnyLaw.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Variable past : nat -> R.
Variables (c : nat -> R) (n : nat) (force_step : option R) (f V : R -> R).
Variables (measure : R -> R) (e : R).
Hypothesis P : physical mu beta sigma.
Hypothesis step_ok : step_positive force_step.
Hypothesis measure_error : forall x, Rabs (measure x - x) <= e.
Hypothesis sum_positive : 0 < tail c n 0.
Hypothesis f_lipschitz : lipschitz f.
Hypothesis f_potential : potential f V.

Definition held_by_law (h : nat) : R :=
  stepped force_step (- f (convolution c n (fun j => measure (sample INR pos past h j)))).

Hypothesis O : obeys mu beta sigma INR held_by_law pos vel friction hand.

Let H := tail c n 0.
Let coulomb := e * response_norm c n + step_size force_step / 2.

Lemma law_parabola : forall x0 x1,
  V (H * x1) / H - V (H * x0) / H <= f (H * x0) * (x1 - x0) + H * (x1 - x0) ^ 2 / 2.
Proof.
  intros x0 x1. assert (H0 : 0 < H) by exact sum_positive.
  pose proof (below_parabola f V f_lipschitz (potential_derivative _ _ f_potential)
    (H * x0) (H * x1)) as B. cbv beta in B.
  apply Rmult_le_reg_l with H; [exact H0 |].
  set (p0 := V (H * x0)) in *. set (p1 := V (H * x1)) in *.
  replace (H * (p1 / H - p0 / H)) with (p1 - p0) by (field; lra). nra.
Qed.

Lemma law_commanded : forall h,
  Rabs (held_by_law h + f (H * pos (INR h)))
  <= H * sum_to 0 (fun j => Rabs (step INR pos past h j))
     + sum_to n (fun j => Rabs (tail c n j) * Rabs (step INR pos past h (0 + j))) + coulomb.
Proof.
  intro h. set (x := sample INR pos past h). set (q := fun j => measure (x j)).
  assert (X0 : x 0%nat = pos (INR h)) by apply sample_now. rewrite <- X0.
  unfold held_by_law. fold x. change (fun j => measure (x j)) with q.
  set (y := convolution c n q).
  assert (Y : Rabs (y - H * x 0%nat)
    <= sum_to n (fun j => Rabs (tail c n j) * Rabs (step INR pos past h (0 + j)))
       + e * response_norm c n).
  { pose proof (TH_LTI_quantization c n q x e (fun j => measure_error (x j))) as Q. fold y in Q.
    pose proof (filter_far c n x) as F.
    replace (y - H * x 0%nat) with ((y - convolution c n x) + (convolution c n x - H * x 0%nat)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. fold H in F. unfold step. fold x. simpl (0 + _)%nat. lra. }
  pose proof (f_lipschitz y (H * x 0%nat)) as L.
  pose proof (stepped_error force_step (- f y) step_ok) as R.
  replace (stepped force_step (- f y) + f (H * x 0%nat))
    with ((stepped force_step (- f y) - - f y) + - (f y - f (H * x 0%nat))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. simpl sum_to at 1. unfold coulomb. lra.
Qed.

Theorem TH_LTI_law : forall t, 0 <= t ->
  criterion_holds (beta - (H / 2 + tails_norm (tail c n) n)) (sigma - coulomb) vel t ->
  passive_run vel hand
    (kinetic mu (vel 0) + V (H * pos 0) / H + gated_storage H 0 (tail c n) n (step INR pos past 0))
    (kinetic mu (vel t) + V (H * pos t) / H) t.
Proof.
  intros t Ht H8.
  apply (law_run mu beta sigma pos vel friction hand past held_by_law H (tail c n) n 0 coulomb
    (fun x => f (H * x)) (fun x => V (H * x) / H) P O (Rlt_le _ _ sum_positive) law_parabola
    law_commanded t Ht).
  simpl (INR 0). rewrite Rmult_0_r, Rplus_0_r. exact H8.
Qed.

End AnyLaw.

(** Both kinds of measurement tell on which side of the wall's surface the device is. *)
Theorem TH_LTI_gated_side :
  (forall x, measured x < 0 <-> x < 0) /\ (forall x : R, x < 0 <-> x < 0).
Proof.
  split; [| reflexivity]. intro x. unfold measured. pose proof (floor_spec x) as F.
  split; intro L.
  - apply Rnot_le_lt. intro N. destruct (Rlt_dec (floor x) 0) as [Z | Z]; [| lra].
    unfold floor in *. apply lt_IZR in Z.
    assert (Int_part x <= -1)%Z by lia. apply IZR_le in H. lra.
  - assert (Z : floor x < 0) by lra. unfold floor in *. apply lt_IZR in Z.
    assert (Int_part x <= -1)%Z by lia. apply IZR_le in H. lra.
Qed.

(** After rest there is no extra storage. *)
Theorem TH_LTI_gated_rested : forall H k g n pos past, (forall j, past j = pos 0) ->
  gated_storage H k g n (step INR pos past 0) = 0.
Proof.
  intros H k g n pos past R. apply gated_storage_at_rest. intro j.
  assert (E : forall i, sample INR pos past 0 i = pos 0)
    by (intros [| i]; unfold sample; simpl; [reflexivity | apply R]).
  unfold step. rewrite !E. ring.
Qed.
