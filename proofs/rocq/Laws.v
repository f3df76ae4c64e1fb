(** * Laws: the force laws of real walls are instances of TH-LAW. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Law Combined.
Open Scope R_scope.

(** A function with a tangent up to a parabola is differentiable. *)
Lemma derive_by_parabola : forall V f : R -> R,
  (forall x h, Rabs (V (x + h) - V x - f x * h) <= h ^ 2) ->
  forall x, is_derive V x (f x).
Proof.
  intros V f H x. apply is_derive_Reals. intros eps He.
  exists (mkposreal eps He). intros h Hh Hs. simpl in Hs.
  pose proof (Rabs_pos_lt h Hh) as Hp. apply Rle_lt_trans with (Rabs h); [| exact Hs].
  replace ((V (x + h) - V x) / h - f x) with ((V (x + h) - V x - f x * h) / h) by (field; exact Hh).
  unfold Rdiv. rewrite Rabs_mult, Rabs_inv. apply Rmult_le_reg_r with (Rabs h); [exact Hp |].
  rewrite Rmult_assoc, Rinv_l by lra. specialize (H x h). rewrite <- (pow2_abs h) in H. nra.
Qed.

Lemma lipschitz_below : forall lo, lipschitz (clipped_below lo).
Proof.
  intros lo x y. unfold clipped_below, Rmax.
  destruct (Rle_dec x lo), (Rle_dec y lo); unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma lipschitz_min : forall hi, lipschitz (fun x => Rmin x hi).
Proof.
  intros hi x y. unfold Rmin.
  destruct (Rle_dec x hi), (Rle_dec y hi); unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(** Clipping does not make a law stiffer: so saturation and a one-sided wall are covered. *)
Lemma lipschitz_clipped : forall lo hi, lipschitz (clipped lo hi).
Proof.
  intros lo hi x y. unfold clipped.
  eapply Rle_trans; [apply lipschitz_min | apply lipschitz_below].
Qed.

(** The potential of a one-sided wall, and of any wall clipped from below. *)
Lemma potential_below : forall lo, lo <= 0 ->
  potential (clipped_below lo) (fun x => law_potential_of x (clipped_below lo x)).
Proof.
  intros lo Hl. split.
  - apply derive_by_parabola. intros x h. unfold law_potential_of, clipped_below, Rmax.
    apply Rabs_le. destruct (Rle_dec x lo), (Rle_dec (x + h) lo); split; nra.
  - intro x. unfold law_potential_of, clipped_below, Rmax. destruct (Rle_dec x lo); nra.
Qed.

(** The potential of a clipped wall: saturation, one-sided or not. *)
Lemma potential_clipped : forall lo hi, lo <= 0 <= hi ->
  potential (clipped lo hi) (fun x => law_potential_of x (clipped lo hi x)).
Proof.
  intros lo hi Hl. split.
  - apply derive_by_parabola. intros x h. unfold law_potential_of, clipped, Rmax, Rmin.
    apply Rabs_le. destruct (Rle_dec x lo), (Rle_dec (x + h) lo);
      repeat destruct Rle_dec; split; nra.
  - intro x. unfold law_potential_of, clipped, Rmax, Rmin.
    destruct (Rle_dec x lo); destruct Rle_dec; nra.
Qed.

(** Any 1-Lipschitz law that never pulls away from the origin has the integral of its
    force as potential: softening springs, dead band. *)
Lemma potential_exists : forall f, lipschitz f -> (forall x, 0 <= x * f x) ->
  potential f (fun x => RInt f 0 x).
Proof.
  intros f L N.
  assert (C : forall x, continuous f x).
  { intro x. apply continuity_pt_filterlim. intros eps He. exists eps. split; [exact He |].
    intros y [_ Hy]. eapply Rle_lt_trans; [apply L | exact Hy]. }
  assert (Z : forall x, 0 <= x -> 0 <= f x).
  { intros x Hx. pose proof (N x) as Nx. destruct Hx as [Hx | <-]; [nra |].
    destruct (Rle_lt_dec 0 (f 0)) as [P | P]; [exact P | exfalso].
    specialize (L (- f 0 / 2) 0). specialize (N (- f 0 / 2)). cut False; [tauto |].
    revert L N. generalize (f (- f 0 / 2)). intros y L N'. unfold Rabs in L.
    repeat destruct Rcase_abs; nra. }
  assert (Zm : forall x, x <= 0 -> f x <= 0).
  { intros x Hx. pose proof (N x) as Nx. destruct Hx as [Hx | ->]; [nra |].
    destruct (Rle_lt_dec (f 0) 0) as [P | P]; [exact P | exfalso].
    specialize (L (- f 0 / 2) 0). specialize (N (- f 0 / 2)). cut False; [tauto |].
    revert L N. generalize (f (- f 0 / 2)). intros y L N'. unfold Rabs in L.
    repeat destruct Rcase_abs; nra. }
  split.
  - intro x. apply (@is_derive_RInt R_CompleteNormedModule _ _ 0); [| apply C].
    apply filter_forall. intro y. apply RInt_is, ex_RInt_cont, C.
  - intro x. destruct (Rle_lt_dec 0 x) as [H | H].
    + apply RInt_ge_0; [exact H | apply ex_RInt_cont, C | intros y Hy; apply Z; lra].
    + replace (RInt f 0 x) with (- RInt f x 0)
        by (apply (@opp_RInt_swap R_CompleteNormedModule), ex_RInt_cont, C).
      assert (0 <= RInt (fun y => - f y) x 0).
      { apply RInt_ge_0; [lra | | intros y Hy; specialize (Zm y); lra].
        apply (@ex_RInt_opp R_NormedModule), ex_RInt_cont, C. }
      replace (- RInt f x 0) with (RInt (fun y => - f y) x 0); [assumption |].
      apply (@RInt_opp R_CompleteNormedModule), ex_RInt_cont, C.
Qed.

(** A converter that rounds to the nearest step is off by at most half a step. *)
Lemma rounding_error : forall F delta, 0 < delta ->
  Rabs (rounded_force F delta - F) <= delta / 2.
Proof.
  intros F delta H. unfold rounded_force. set (q := F / delta).
  assert (E : F = q * delta) by (unfold q; field; lra). rewrite E at 1.
  pose proof (floor_spec (q + 1 / 2)). apply Rabs_le. nra.
Qed.
