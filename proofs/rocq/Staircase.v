(** * Staircase: the potential of a clipped law over the quantizer's ticks is the integral of
    the force that is held from the middle of each tick (16). *)

From Coq Require Import Reals Lra Lia Psatz ZArith.
From Passivity Require Import Definitions Quantizer.
Open Scope R_scope.

(** Whole numbers: one is not below another, or at least one below it. *)
Lemma whole_apart : forall a b : Z, IZR b <= IZR a \/ IZR a + 1 <= IZR b.
Proof.
  intros a b. destruct (Z_le_gt_dec b a) as [H | H]; [left; apply IZR_le, H | right].
  rewrite <- plus_IZR. apply IZR_le. lia.
Qed.

Lemma first_beyond_spec : forall limit, 0 <= limit -> exists m : Z,
  first_beyond limit = IZR m /\ 0 <= IZR m /\ IZR m - 1 < limit - 1 / 2 <= IZR m.
Proof.
  intros limit H. destruct (floor_integer (1 / 2 - limit)) as [z Hz].
  pose proof (floor_spec (1 / 2 - limit)) as S. rewrite Hz in S.
  assert (N : 0 <= IZR (- z)).
  { rewrite opp_IZR. destruct (whole_apart 0 z) as [A | A]; simpl in A; lra. }
  exists (- z)%Z. unfold first_beyond. rewrite Hz, <- opp_IZR, Rmax_left by exact N.
  rewrite opp_IZR in *. repeat split; lra.
Qed.

(** From one place of a tick to another, [beyond] grows by what the force is beyond the limit. *)
Lemma beyond_rises : forall limit tick rho rho',
  beyond limit tick rho' - beyond limit tick rho
  = Rmax (tick + 1 / 2 - limit) 0 * (rho' - rho).
Proof. intros. unfold beyond. ring. Qed.

(** At the end of a tick it is what it is at the start of the next. *)
Lemma beyond_next : forall limit (n : Z), 0 <= limit ->
  beyond limit (IZR n) 1 = beyond limit (IZR n + 1) 0.
Proof.
  intros limit n H. destruct (first_beyond_spec limit H) as (m & E & P & L & U).
  unfold beyond. rewrite E. destruct (whole_apart n m) as [A | A].
  - rewrite (Rmax_left (IZR n - IZR m)), (Rmax_left (IZR n + 1 - IZR m)),
      (Rmax_left (IZR n + 1 / 2 - limit)) by lra. field.
  - rewrite (Rmax_right (IZR n - IZR m)), (Rmax_right (IZR n + 1 / 2 - limit)) by lra.
    rewrite (Rmax_right (IZR n + 1 - IZR m)) by lra. ring.
Qed.

(** What a clipped law leaves of a spring, as the two parts beyond its limits. *)
Lemma clipped_parts : forall lo hi y, lo <= 0 <= hi ->
  clipped lo hi y = y - Rmax (y - hi) 0 + Rmax (lo - y) 0.
Proof. intros. unfold clipped, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.

Section Staircase.

Variables lo hi : R.
Hypothesis limits : lo <= 0 <= hi.

Let force (n : Z) : R := clipped lo hi (IZR n + 1 / 2).

(** Within a tick, the end of it included, the potential rises by the force at its middle. *)
Lemma rise : forall (n : Z) rho rho',
  (IZR n + rho') ^ 2 / 2 + (rho' - rho' ^ 2) / 2 - beyond hi (IZR n) rho'
    - beyond (- lo) (- (IZR n + 1)) (1 - rho')
  - ((IZR n + rho) ^ 2 / 2 + (rho - rho ^ 2) / 2 - beyond hi (IZR n) rho
    - beyond (- lo) (- (IZR n + 1)) (1 - rho))
  = force n * (rho' - rho).
Proof.
  intros n rho rho'. pose proof (beyond_rises hi (IZR n) rho rho') as U.
  pose proof (beyond_rises (- lo) (- (IZR n + 1)) (1 - rho) (1 - rho')) as L.
  unfold force. rewrite clipped_parts by exact limits.
  replace (- (IZR n + 1) + 1 / 2 - - lo) with (lo - (IZR n + 1 / 2)) in L by field.
  replace (1 - rho' - (1 - rho)) with (- (rho' - rho)) in L by ring. lra.
Qed.

Lemma potential_at : forall (n : Z) x, IZR n <= x < IZR n + 1 ->
  quantized_clipped_potential lo hi x
  = (IZR n + (x - IZR n)) ^ 2 / 2 + ((x - IZR n) - (x - IZR n) ^ 2) / 2
    - beyond hi (IZR n) (x - IZR n) - beyond (- lo) (- (IZR n + 1)) (1 - (x - IZR n)).
Proof.
  intros n x H. pose proof (floor_unique x n H) as E.
  unfold quantized_clipped_potential, quantized_potential, linear_potential,
    quantization_potential, residue. rewrite E.
  replace (IZR n + (x - IZR n)) with x by ring. reflexivity.
Qed.

(** TH-LAW (staircase): between two places of one tick the potential rises by the force that is
    held from a sample in it, times the way. *)
Theorem TH_LAW_staircase : forall x0 x1, floor x1 = floor x0 ->
  quantized_clipped_potential lo hi x1 - quantized_clipped_potential lo hi x0
  = clipped lo hi (measured x0) * (x1 - x0).
Proof.
  intros x0 x1 E. destruct (floor_integer x0) as [n Hn].
  pose proof (floor_spec x0) as S0. pose proof (floor_spec x1) as S1. rewrite E in S1.
  unfold measured. rewrite Hn in *. rewrite (potential_at n x0 S0), (potential_at n x1 S1).
  rewrite rise. unfold force. ring.
Qed.

(** TH-LAW (staircase, next tick): and so it does up to the start of the next tick; with
    nothing at 0, that makes it the integral of the staircase. *)
Theorem TH_LAW_staircase_next : forall x0,
  quantized_clipped_potential lo hi (floor x0 + 1) - quantized_clipped_potential lo hi x0
  = clipped lo hi (measured x0) * (floor x0 + 1 - x0).
Proof.
  intro x0. destruct (floor_integer x0) as [n Hn]. pose proof (floor_spec x0) as S0.
  unfold measured. rewrite Hn in *.
  assert (S1 : IZR (n + 1) <= IZR n + 1 < IZR (n + 1) + 1) by (rewrite plus_IZR; lra).
  rewrite (potential_at n x0 S0), (potential_at (n + 1) (IZR n + 1) S1).
  pose proof (rise n (x0 - IZR n) 1) as Rise. unfold force in Rise.
  replace (IZR n + 1 - x0) with (1 - (x0 - IZR n)) by ring. rewrite <- Rise.
  rewrite plus_IZR. replace (IZR n + 1 - (IZR n + 1)) with 0 by ring.
  pose proof (beyond_next hi n ltac:(lra)) as U.
  (* Seen from the other side the next tick is the one before. *)
  pose proof (beyond_next (- lo) (- (n + 2))%Z ltac:(lra)) as L.
  rewrite opp_IZR, plus_IZR in L.
  replace (- (IZR n + 1 + 1)) with (- (IZR n + 2)) by ring.
  replace (- (IZR n + 2) + 1) with (- (IZR n + 1)) in L by ring.
  replace (1 - 1) with 0 by ring. replace (1 - 0) with 1 by ring.
  rewrite U, L. lra.
Qed.

Theorem TH_LAW_staircase_origin : quantized_clipped_potential lo hi 0 = 0.
Proof.
  destruct (first_beyond_spec hi ltac:(lra)) as (m & E & P & _ & U).
  destruct (first_beyond_spec (- lo) ltac:(lra)) as (w & F & Q & _ & W).
  unfold quantized_clipped_potential, quantized_potential, linear_potential,
    quantization_potential, residue.
  replace (floor 0) with 0 by (symmetry; apply (floor_IZR 0)).
  unfold beyond. rewrite E, F.
  rewrite (Rmax_right (0 - IZR m)), (Rmax_right (- (0 + 1) - IZR w)) by lra.
  rewrite (Rmax_right (- (0 + 1) + 1 / 2 - - lo)) by lra. field.
Qed.

End Staircase.
