(** * Law: force laws that are 1-Lipschitz, and what one interval can generate under one.

    The commanded force is F with |F - f q| <= B |q - q'| + delta/2, where
    - [f] is the force law, nowhere stiffer than K: 1-Lipschitz (TH-LAW), what the actuator's
      saturation leaves of it;
    - q and q' are two successive measured positions, [k] samples late (TH-DELAY),
      each within [e] of the true one: 1/2 with an encoder, 0 without (TH-SMOOTH);
    - [B] is the virtual damping (TH-DAMP): f q + B (q - q') is such a force, and so is what
      saturation or a wall on one side leave of it (Effects.v);
    - [delta] is the D/A step (TH-DAC), which may round before or after saturation. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus History.
Open Scope R_scope.

Definition lipschitz (f : R -> R) : Prop := forall x y, Rabs (f x - f y) <= Rabs (x - y).

(** [V] is the potential of [f]; it is bounded from below by 0. *)
Record potential (f V : R -> R) : Prop := {
  potential_derivative : forall x, is_derive V x (f x);
  potential_nonneg : forall x, 0 <= V x
}.

(** The wall pushes with - F, where F is the commanded force. *)
Definition commands (f : R -> R) (B delta q q' F : R) : Prop :=
  Rabs (F - f q) <= B * Rabs (q - q') + delta / 2.

(** What the terms of the effects add up to; with an encoder e = 1/2. *)
Definition viscous_need (k B : R) : R := 1 / 2 + k + B.
Definition coulomb_need (e delta B : R) : R := e + delta / 2 + 2 * e * B.

Lemma viscous_need_surplus : forall beta k B,
  viscous_surplus beta k B = beta - viscous_need k B.
Proof. intros. unfold viscous_surplus, viscous_need. ring. Qed.

Lemma coulomb_need_surplus : forall sigma delta B,
  coulomb_surplus sigma delta B = sigma - coulomb_need (1 / 2) delta B.
Proof. intros. unfold coulomb_surplus, coulomb_need. field. Qed.

(** TH-LAW (convexity): a 1-Lipschitz force's potential is below its tangent parabola. *)
Lemma below_parabola : forall f V, lipschitz f -> (forall x, is_derive V x (f x)) ->
  forall x0 x1, V x1 - V x0 <= f x0 * (x1 - x0) + (x1 - x0) ^ 2 / 2.
Proof.
  intros f V L D x0 x1.
  set (g := fun x => V x - (f x0 * (x - x0) + (x - x0) ^ 2 / 2)).
  set (dg := fun x => f x - (f x0 + (x - x0))).
  assert (Dg : forall x, is_derive g x (dg x)).
  { intro x. unfold g, dg. apply (@is_derive_minus R_AbsRing R_NormedModule V); [apply D |].
    auto_derive; [exact I | lra]. }
  destruct (MVT_gen g x0 x1 dg) as (c & Hc & E).
  - intros x _. apply Dg.
  - intros x _. apply continuity_pt_filterlim, (ex_derive_continuous g). exists (dg x). apply Dg.
  - assert (G0 : g x0 = V x0) by (unfold g; field).
    assert (dg c * (x1 - x0) <= 0).
    { unfold dg. pose proof (L c x0) as Lc. apply Rabs_le_between in Lc.
      destruct (Rle_lt_dec x0 x1) as [H | H].
      - rewrite Rmin_left, Rmax_right in Hc by lra. rewrite Rabs_right in Lc by lra. nra.
      - rewrite Rmin_right, Rmax_left in Hc by lra. rewrite Rabs_left1 in Lc by lra. nra. }
    rewrite G0 in E. unfold g in E. lra.
Qed.

Section Interval.

Variables (f V : R -> R) (B delta e : R) (k : nat).
Hypothesis f_lip : lipschitz f.
Hypothesis B_nonneg : 0 <= B.
Hypothesis V_der : forall x, is_derive V x (f x).

(** The commanded force is within these distances of the law at the true position [x0]:
    [s] are the displacements before, q and q' are measured [k] and [k + 1] samples ago. *)
Lemma command_error : forall x0 y y' q q' F s,
  commands f B delta q q' F ->
  Rabs (q - y) <= e -> Rabs (q' - y') <= e ->
  Rabs (x0 - y) <= sum_to k (fun j => Rabs (s j)) -> y - y' = s (S k) ->
  Rabs (F - f x0) <= sum_to k (fun j => Rabs (s j)) + B * Rabs (s (S k))
                     + coulomb_need e delta B.
Proof.
  intros x0 y y' q q' F s C Hq Hq' Hd Hy. unfold commands in C.
  pose proof (f_lip q x0) as A2.
  assert (A4 : Rabs (q - x0) <= e + sum_to k (fun j => Rabs (s j))).
  { replace (q - x0) with ((q - y) + - (x0 - y)) by ring.
    eapply Rle_trans; [apply Rabs_triang | rewrite Rabs_Ropp; lra]. }
  assert (A5 : Rabs (q - q') <= 2 * e + Rabs (s (S k))).
  { replace (q - q') with ((q - y) + ((y - y') + - (q' - y'))) by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    assert (Rabs ((y - y') + - (q' - y')) <= Rabs (y - y') + Rabs (- (q' - y'))) by apply Rabs_triang.
    rewrite Rabs_Ropp, Hy in *. lra. }
  assert (A6 : B * Rabs (q - q') <= B * (2 * e + Rabs (s (S k)))) by (apply Rmult_le_compat_l; lra).
  replace (F - f x0) with ((F - f q) + (f q - f x0)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. unfold coulomb_need. lra.
Qed.

(** TH-COMBINED (generated): what the interval generates, with what the extra storage
    grows by, is at most the need of all effects together. *)
Lemma generated_combined : forall x0 x1 y y' q q' F s,
  commands f B delta q q' F ->
  Rabs (q - y) <= e -> Rabs (q' - y') <= e ->
  Rabs (x0 - y) <= sum_to k (fun j => Rabs (s j)) -> y - y' = s (S k) ->
  let d := x1 - x0 in
  generated (- F) x0 x1 (V x0) (V x1)
  + (delay_storage k (push d s) - delay_storage k s)
  + (damping_storage k B (push d s) - damping_storage k B s)
  <= viscous_need (INR k) B * d ^ 2 + coulomb_need e delta B * Rabs d.
Proof.
  intros x0 x1 y y' q q' F s C Hq Hq' Hd Hy d.
  rewrite delay_storage_push, damping_storage_push.
  pose proof (command_error x0 y y' q q' F s C Hq Hq' Hd Hy) as E.
  pose proof (below_parabola f V f_lip V_der x0 x1) as Pb. simpl in Pb. fold d in Pb.
  pose proof (path_by_squares k d s) as Ps.
  set (p := sum_to k (fun j => Rabs (s j))) in *. set (sq := sum_to k (fun j => s j ^ 2)) in *.
  unfold generated. fold d. set (c := coulomb_need e delta B) in *.
  assert (W : (f x0 - F) * d <= Rabs (F - f x0) * Rabs d).
  { rewrite <- (Rabs_Ropp (F - f x0)), <- Rabs_mult.
    replace (- (F - f x0)) with (f x0 - F) by ring. apply Rle_abs. }
  assert (W2 : Rabs (F - f x0) * Rabs d <= (p + B * Rabs (s (S k)) + c) * Rabs d).
  { apply Rmult_le_compat_r; [apply Rabs_pos | exact E]. }
  assert (Q : B * (Rabs (s (S k)) * Rabs d) <= B * ((s (S k)) ^ 2 + d ^ 2) / 2).
  { pose proof (pow2_ge_0 (Rabs (s (S k)) - Rabs d)) as Sq.
    pose proof (pow2_abs (s (S k))) as P1. pose proof (pow2_abs d) as P2.
    assert (Rabs (s (S k)) * Rabs d <= (s (S k) ^ 2 + d ^ 2) / 2) by nra.
    unfold Rdiv. rewrite Rmult_assoc. apply Rmult_le_compat_l; lra. }
  unfold viscous_need. nra.
Qed.

End Interval.

(** ** The laws of the paper *)

(** The bilateral wall (2): the law is the identity. *)
Lemma lipschitz_id : lipschitz (fun x => x).
Proof. intros x y. lra. Qed.

Lemma potential_linear : potential (fun x => x) linear_potential.
Proof.
  split.
  - intro x. unfold linear_potential. auto_derive; [exact I | field].
  - intro x. unfold linear_potential. pose proof (pow2_ge_0 x). lra.
Qed.
