(** * Region: the plane of (beta, sigma), SI units and the stiffness limits. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Model Law Combined.
Open Scope R_scope.

(** EQ-8/9: the criterion holds at a speed iff sigma is on or above the critical line (9). *)
Theorem EQ_9 : forall beta sigma v,
  0 <= margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) v
  <-> critical_sigma beta v <= sigma.
Proof.
  intros. unfold margin, viscous_surplus, coulomb_surplus, critical_sigma.
  split; intro; lra.
Qed.

(** EQ-8: for a moving device (8) as printed is the margin divided by the speed. *)
Theorem EQ_8_margin : forall viscous coulomb v, v <> 0 ->
  (0 <= margin_8 viscous coulomb v <-> 0 <= margin viscous coulomb (Rabs v)).
Proof.
  intros viscous coulomb v Hv. unfold margin_8, margin. pose proof (Rabs_pos_lt v Hv) as Hp.
  set (w := Rabs v) in *.
  replace (viscous * w + coulomb) with (w * (viscous + coulomb / w)) by (field; lra).
  split; intro H.
  - apply Rmult_le_pos; lra.
  - apply Rmult_le_reg_l with w; lra.
Qed.

Section Regions.

Variables viscous coulomb : R.

(** TH-REGION (all): the criterion holds at every speed v > 0 iff neither coefficient is
    negative: globally stable, the border lines included. *)
Theorem TH_REGION_all : globally_stable viscous coulomb <-> (0 <= viscous /\ 0 <= coulomb).
Proof.
  unfold globally_stable, holds_at_all, margin. split.
  - intro H. split.
    + destruct (Rle_lt_dec 0 viscous) as [| N]; [assumption | exfalso].
      set (v := (Rabs coulomb + 1) / - viscous).
      assert (E : - viscous * v = Rabs coulomb + 1) by (unfold v; field; lra).
      pose proof (Rabs_pos coulomb). pose proof (Rle_abs coulomb).
      assert (0 < v) by (unfold v; apply Rdiv_lt_0_compat; lra).
      specialize (H v H2). lra.
    + destruct (Rle_lt_dec 0 coulomb) as [| N]; [assumption | exfalso].
      set (v := - coulomb / (2 * (Rabs viscous + 1))).
      pose proof (Rabs_pos viscous). pose proof (Rle_abs viscous).
      assert (0 < v) by (unfold v; apply Rdiv_lt_0_compat; lra).
      assert (E : 2 * (Rabs viscous + 1) * v = - coulomb) by (unfold v; field; lra).
      specialize (H v H2). nra.
  - intros [Hv Hc] v V. assert (0 <= viscous * v) by (apply Rmult_le_pos; lra). lra.
Qed.

(** TH-REGION (none): it holds at no speed iff one coefficient is negative and the other
    not positive: unstable. *)
Theorem TH_REGION_none : unstable viscous coulomb
  <-> (viscous <= 0 /\ coulomb <= 0 /\ (viscous < 0 \/ coulomb < 0)).
Proof.
  unfold unstable, margin. split.
  - intro H.
    assert (V : viscous <= 0).
    { destruct (Rle_lt_dec viscous 0) as [| N]; [assumption | exfalso].
      set (v := (Rabs coulomb + 1) / viscous).
      assert (E : viscous * v = Rabs coulomb + 1) by (unfold v; field; lra).
      pose proof (Rabs_pos coulomb). pose proof (Rle_abs (- coulomb)) as A. rewrite Rabs_Ropp in A.
      assert (Hv : 0 < v) by (unfold v; apply Rdiv_lt_0_compat; lra).
      specialize (H v Hv). lra. }
    assert (C : coulomb <= 0).
    { destruct (Rle_lt_dec coulomb 0) as [| N]; [assumption | exfalso].
      set (v := coulomb / (2 * (Rabs viscous + 1))).
      pose proof (Rabs_pos viscous). pose proof (Rle_abs (- viscous)) as A. rewrite Rabs_Ropp in A.
      assert (Hv : 0 < v) by (unfold v; apply Rdiv_lt_0_compat; lra).
      assert (E : 2 * (Rabs viscous + 1) * v = coulomb) by (unfold v; field; lra).
      specialize (H v Hv). nra. }
    split; [exact V |]. split; [exact C |].
    destruct (Req_dec viscous 0); [right | left; lra].
    specialize (H 1 ltac:(lra)). lra.
  - intros (V & C & N) v Hv. assert (viscous * v <= 0) by nra.
    destruct N; [assert (viscous * v < 0) by nra |]; lra.
Qed.

(** TH-REGION (up to v_c): with viscous < 0 < coulomb it holds exactly up to v_c. *)
Theorem TH_REGION_up_to : viscous < 0 < coulomb -> locally_stable viscous coulomb.
Proof.
  intros [V C]. split.
  { unfold critical_speed. replace (- coulomb / viscous) with (coulomb / - viscous) by (field; lra).
    apply Rdiv_lt_0_compat; lra. }
  intros v Hv. unfold margin, critical_speed.
  assert (E : viscous * (- coulomb / viscous) = - coulomb) by (field; lra).
  set (vc := - coulomb / viscous) in *. split; intro H.
  - destruct (Rle_lt_dec v vc) as [| N]; [assumption | exfalso]. nra.
  - nra.
Qed.

(** TH-REGION (from v_c on): with coulomb < 0 < viscous it holds exactly from v_c on. *)
Theorem TH_REGION_from : coulomb < 0 < viscous -> limit_cycles viscous coulomb.
Proof.
  intros [C V]. split; [unfold critical_speed; apply Rdiv_lt_0_compat; lra |].
  intros v Hv. unfold margin, critical_speed.
  assert (E : viscous * (- coulomb / viscous) = - coulomb) by (field; lra).
  set (vc := - coulomb / viscous) in *. split; intro H.
  - destruct (Rle_lt_dec vc v) as [| N]; [assumption | exfalso]. nra.
  - nra.
Qed.

(** TH-START (squares): no root is needed to decide the margin at V. *)
Theorem TH_START_squares : viscous < 0 < coulomb -> forall W, 0 <= W ->
  (0 <= margin viscous coulomb W <-> 0 <= margin_of_squares viscous coulomb (W ^ 2)).
Proof.
  intros [V C] W HW. unfold margin, margin_of_squares.
  replace (coulomb ^ 2 - viscous ^ 2 * W ^ 2)
    with ((coulomb - viscous * W) * (viscous * W + coulomb)) by ring.
  assert (0 < coulomb - viscous * W) by nra. split; intro H1.
  - apply Rmult_le_pos; lra.
  - apply Rmult_le_reg_l with (coulomb - viscous * W); lra.
Qed.

(** TH-REGION (a bound): up to a speed V it is enough to look at rest and at V. *)
Theorem TH_REGION_bound : forall V, 0 < V ->
  (holds_up_to viscous coulomb V <-> 0 <= coulomb /\ 0 <= margin viscous coulomb V).
Proof.
  intros V HV. unfold holds_up_to, margin. split.
  - intro H. split; [| apply H; lra].
    destruct (Rle_lt_dec 0 coulomb) as [| N]; [assumption | exfalso].
    set (w := - coulomb / (2 * (Rabs viscous + 1))).
    pose proof (Rabs_pos viscous). pose proof (Rle_abs viscous).
    assert (0 < w) by (unfold w; apply Rdiv_lt_0_compat; lra).
    assert (E : 2 * (Rabs viscous + 1) * w = - coulomb) by (unfold w; field; lra).
    pose proof (Rmin_l w V). pose proof (Rmin_r w V).
    assert (0 < Rmin w V) by (apply Rmin_glb_lt; lra).
    specialize (H (Rmin w V) ltac:(lra)). nra.
  - intros [C M] v Hv. destruct (Rle_lt_dec 0 viscous); nra.
Qed.

End Regions.

(** EQ-11 with (3), (4), (7): the criterion in SI units at speed v is K * Delta times the
    dimensionless one at v T / Delta, with the terms of all effects. *)
Theorem EQ_11 : forall b c K T Delta v k B F, 0 < K -> 0 < T -> 0 < Delta ->
  margin (viscous_si b K T k B) (coulomb_si c K T Delta B F) v
  = K * Delta * margin (viscous_surplus (beta_of b K T) k (B / (K * T)))
                       (coulomb_surplus (sigma_of c K Delta) (F / (K * Delta)) (B / (K * T)))
                       (v * T / Delta).
Proof.
  intros. unfold margin, viscous_si, coulomb_si, viscous_surplus, coulomb_surplus, beta_of, sigma_of.
  field. repeat split; lra.
Qed.

(** TH-STIFF: K is admissible at speed v iff it is at most the limit; without effects the
    limit is 2 (b v + c) / (T v + Delta). *)
Theorem TH_STIFF : forall b c K T Delta v k B F, 0 < T -> 0 < Delta -> 0 <= v -> 0 <= k ->
  (0 <= margin (viscous_si b K T k B) (coulomb_si c K T Delta B F) v
   <-> K <= stiffness_limit b c T Delta v k B F).
Proof.
  intros b c K T Delta v k B F HT HD Hv Hk. unfold margin, viscous_si, coulomb_si, stiffness_limit.
  set (n := (b - B) * v + (c - B * Delta / T - F / 2)).
  set (s := T * (1 / 2 + k) * v + Delta / 2).
  assert (Hs : 0 < s).
  { unfold s. assert (0 <= T * (1 / 2 + k) * v) by (apply Rmult_le_pos; [nra | lra]). lra. }
  replace ((b - K * T * (1 / 2 + k) - B) * v + (c - K * Delta / 2 - B * Delta / T - F / 2))
    with (n - K * s) by (unfold n, s; field; lra).
  assert (E : n / s * s = n) by (field; lra). split; intro H.
  - apply Rmult_le_reg_r with s; lra.
  - apply Rmult_le_compat_r with (r := s) in H; lra.
Qed.

(** TH-STIFF (plain): the limit of the wall (2) is 2 (b v + c) / (T v + Delta). *)
Theorem TH_STIFF_plain : forall b c T Delta v, 0 < T -> 0 < Delta -> 0 <= v ->
  stiffness_limit b c T Delta v 0 0 0 = 2 * (b * v + c) / (T * v + Delta).
Proof.
  intros. unfold stiffness_limit. assert (0 <= T * v) by nra. field. lra.
Qed.

(** TH-STIFF (all speeds): K is admissible at every speed iff it is at most both limits;
    without effects they are 2b/T and 2c/Delta. *)
Theorem TH_STIFF_all : forall b c K T Delta k B F, 0 < T -> 0 < Delta -> 0 <= k ->
  (globally_stable (viscous_si b K T k B) (coulomb_si c K T Delta B F)
   <-> K <= Rmin (viscous_limit b T k B) (coulomb_limit c T Delta B F)).
Proof.
  intros b c K T Delta k B F HT HD Hk. rewrite TH_REGION_all.
  unfold viscous_si, coulomb_si, viscous_limit, coulomb_limit.
  set (s := T * (1 / 2 + k)). assert (Hs : 0 < s) by (unfold s; nra).
  set (n := c - B * Delta / T - F / 2).
  assert (E1 : (b - B) / s * s = b - B) by (field; lra).
  assert (E2 : n / (Delta / 2) * (Delta / 2) = n) by (field; lra).
  split.
  - intros [H1 H2]. apply Rmin_glb.
    + apply Rmult_le_reg_r with s; [exact Hs |]. unfold s in *. lra.
    + apply Rmult_le_reg_r with (Delta / 2); [lra |]. unfold n in *. lra.
  - intro H. pose proof (Rmin_l ((b - B) / s) (n / (Delta / 2))).
    pose proof (Rmin_r ((b - B) / s) (n / (Delta / 2))). split.
    + assert (K * s <= (b - B) / s * s) by (apply Rmult_le_compat_r; lra). unfold s in *. lra.
    + assert (K * (Delta / 2) <= n / (Delta / 2) * (Delta / 2)) by (apply Rmult_le_compat_r; lra).
      unfold n in *. lra.
Qed.

(** TH-STIFF (plain, all speeds): the limits of the wall (2) are 2b/T and 2c/Delta. *)
Theorem TH_STIFF_all_plain : forall b c T Delta, 0 < T -> 0 < Delta ->
  viscous_limit b T 0 0 = 2 * b / T /\ coulomb_limit c T Delta 0 0 = 2 * c / Delta.
Proof. intros. unfold viscous_limit, coulomb_limit. split; field; lra. Qed.

(** TH-STIFF (longest period): what viscous friction has to spare. *)
Theorem TH_STIFF_longest : forall b K T k B, 0 < K -> 0 <= k ->
  (0 <= viscous_si b K T k B <-> T <= longest_period b K k B).
Proof.
  intros b K T k B HK Hk. unfold viscous_si, longest_period.
  set (s := K * (1 / 2 + k)). assert (Hs : 0 < s) by (unfold s; nra).
  assert (E : (b - B) / s * s = b - B) by (field; lra).
  replace (b - K * T * (1 / 2 + k) - B) with (b - B - T * s) by (unfold s; ring). split; intro H.
  - apply Rmult_le_reg_r with s; lra.
  - apply Rmult_le_compat_r with (r := s) in H; lra.
Qed.

(** TH-STIFF (shortest period): with damping behind an encoder, what Coulomb friction has to
    spare grows with the period, from nothing at the shortest one. *)
Theorem TH_STIFF_shortest : forall c K T Delta B F, 0 < T -> 0 < c - K * Delta / 2 - F / 2 ->
  (0 <= coulomb_si c K T Delta B F <-> shortest_period c K Delta B F <= T).
Proof.
  intros c K T Delta B F HT Hs. unfold coulomb_si, shortest_period.
  set (s := c - K * Delta / 2 - F / 2) in *.
  assert (E : B * Delta / s * s = B * Delta) by (field; lra).
  assert (G : B * Delta / T * T = B * Delta) by (field; lra).
  replace (c - K * Delta / 2 - B * Delta / T - F / 2) with (s - B * Delta / T) by (unfold s; ring).
  split; intro H.
  - apply Rmult_le_reg_r with s; [exact Hs |].
    assert (B * Delta / T * T <= s * T) by (apply Rmult_le_compat_r; lra). lra.
  - assert (M : B * Delta / s * s <= T * s) by (apply Rmult_le_compat_r; lra).
    assert (B * Delta / T <= s); [| lra].
    apply Rmult_le_reg_r with T; [exact HT | lra].
Qed.

(** TH-STIFF (best period): at a speed the margin times the period is a parabola that opens
    downwards, with its peak at the best period. *)
Theorem TH_STIFF_best : forall b c K T Delta v k B F, 0 < T -> 0 < K * (1 / 2 + k) * v ->
  T * margin (viscous_si b K T k B) (coulomb_si c K T Delta B F) v
  = K * (1 / 2 + k) * v
      * (best_period b c K Delta v k B F ^ 2 - (T - best_period b c K Delta v k B F) ^ 2)
    - B * Delta.
Proof.
  intros b c K T Delta v k B F HT He. unfold margin, viscous_si, coulomb_si, best_period.
  set (e := K * (1 / 2 + k) * v) in *.
  replace ((b - K * T * (1 / 2 + k) - B) * v) with ((b - B) * v - T * e) by (unfold e; ring).
  field. lra.
Qed.

(** TH-STIFF (coarsest encoder). *)
Theorem TH_STIFF_coarsest : forall c K T Delta B F, 0 < T -> 0 < K / 2 + B / T ->
  (0 <= coulomb_si c K T Delta B F <-> Delta <= coarsest_resolution c K T B F).
Proof.
  intros c K T Delta B F HT Hs. unfold coulomb_si, coarsest_resolution.
  set (s := K / 2 + B / T) in *.
  assert (E : (c - F / 2) / s * s = c - F / 2) by (field; lra).
  replace (c - K * Delta / 2 - B * Delta / T - F / 2) with (c - F / 2 - Delta * s)
    by (unfold s; field; lra). split; intro H.
  - apply Rmult_le_reg_r with s; lra.
  - apply Rmult_le_compat_r with (r := s) in H; lra.
Qed.
