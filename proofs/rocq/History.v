(** * History: the samples before the current one, and the extra storage they carry. *)

From Coq Require Import Reals Lra Lia Psatz.
From Passivity Require Import Definitions.
Open Scope R_scope.

Lemma sum_to_ext : forall n f g, (forall j, (1 <= j <= n)%nat -> f j = g j) ->
  sum_to n f = sum_to n g.
Proof.
  intros n f g. induction n as [| n IH]; intro H; simpl; [reflexivity |].
  rewrite IH, H; [reflexivity | lia | intros; apply H; lia].
Qed.

Lemma sum_to_S : forall n f, sum_to (S n) f = sum_to n f + f (S n).
Proof. reflexivity. Qed.

Lemma sum_to_plus : forall n f g, sum_to n (fun j => f j + g j) = sum_to n f + sum_to n g.
Proof. intros. induction n as [| n IH]; simpl; [| rewrite IH]; ring. Qed.

Lemma sum_to_half : forall n f, sum_to n (fun j => f j / 2) = sum_to n f / 2.
Proof. intros. induction n as [| n IH]; simpl; [| rewrite IH]; field. Qed.

Lemma sum_to_nonneg : forall n f, (forall j, (1 <= j <= n)%nat -> 0 <= f j) -> 0 <= sum_to n f.
Proof.
  intros n f. induction n as [| n IH]; intro H; simpl; [lra |].
  assert (0 <= sum_to n f) by (apply IH; intros; apply H; lia).
  assert (0 <= f (S n)) by (apply H; lia). lra.
Qed.

Lemma sum_to_zero : forall n f, (forall j, (1 <= j <= n)%nat -> f j = 0) -> sum_to n f = 0.
Proof.
  intros n f. induction n as [| n IH]; intro H; simpl; [reflexivity |].
  rewrite IH, H; [ring | lia | intros; apply H; lia].
Qed.

Lemma sum_to_first : forall n f, sum_to (S n) f = f 1%nat + sum_to n (fun i => f (S i)).
Proof.
  intros n f. induction n as [| n IH]; [simpl; ring |].
  change (sum_to (S (S n)) f) with (sum_to (S n) f + f (S (S n))). rewrite IH. simpl. ring.
Qed.

(** A new displacement [d] in front of the earlier ones [s]. *)
Definition push (d : R) (s : nat -> R) (j : nat) : R :=
  match j with
  | S (S i) => s (S i)
  | _ => d
  end.

Lemma delay_storage_nonneg : forall k s, 0 <= delay_storage k s.
Proof.
  intros k s. apply sum_to_nonneg. intros j [_ Hj]. apply le_INR in Hj.
  pose proof (pow2_ge_0 (s j)). nra.
Qed.

Lemma damping_storage_nonneg : forall k B s, 0 <= B -> 0 <= damping_storage k B s.
Proof.
  intros k B s HB. unfold damping_storage.
  assert (0 <= sum_to (S k) (fun j => s j ^ 2))
    by (apply sum_to_nonneg; intros; apply pow2_ge_0).
  nra.
Qed.

(** A device that rested before the start carries no extra storage. *)
Lemma delay_storage_at_rest : forall k s, (forall j, s j = 0) -> delay_storage k s = 0.
Proof. intros k s H. apply sum_to_zero. intros. rewrite H. field. Qed.

Lemma damping_storage_at_rest : forall k B s, (forall j, s j = 0) -> damping_storage k B s = 0.
Proof.
  intros k B s H. unfold damping_storage. rewrite sum_to_zero; [field |].
  intros. rewrite H. ring.
Qed.

(** TH-DELAY (storage): a step adds k/2 d^2 and pays half of each of the last k squares. *)
Lemma delay_storage_push : forall k d s,
  delay_storage k (push d s) - delay_storage k s
  = INR k * d ^ 2 / 2 - sum_to k (fun j => s j ^ 2) / 2.
Proof.
  intros [| n] d s; [unfold delay_storage; simpl; field |].
  unfold delay_storage. rewrite sum_to_first. simpl (push d s 1).
  assert (E : sum_to (S n) (fun j => (INR (S n) - INR j + 1) * s j ^ 2 / 2)
      = sum_to n (fun i => (INR (S n) - INR (S i) + 1) * push d s (S i) ^ 2 / 2)
        + sum_to (S n) (fun j => s j ^ 2) / 2).
  { change (sum_to (S n) (fun j => (INR (S n) - INR j + 1) * s j ^ 2 / 2))
      with (sum_to n (fun j => (INR (S n) - INR j + 1) * s j ^ 2 / 2)
            + (INR (S n) - INR (S n) + 1) * s (S n) ^ 2 / 2).
    change (sum_to (S n) (fun j => s j ^ 2))
      with (sum_to n (fun j => s j ^ 2) + s (S n) ^ 2).
    assert (T : sum_to n (fun j => (INR (S n) - INR j + 1) * s j ^ 2 / 2)
      = sum_to n (fun i => (INR (S n) - INR (S i) + 1) * push d s (S i) ^ 2 / 2)
        + sum_to n (fun j => s j ^ 2 / 2)).
    { rewrite <- sum_to_plus. apply sum_to_ext. intros j Hj. destruct j as [| j]; [lia |].
      simpl (push d s (S (S j))). rewrite (S_INR (S j)). field. }
    rewrite T, (sum_to_half n (fun j => s j ^ 2)). field. }
  rewrite E. simpl (INR 1). field.
Qed.

(** TH-DAMP (storage): a step adds B/2 d^2 and pays B/2 of the square k + 1 steps ago. *)
Lemma damping_storage_push : forall k B d s,
  damping_storage k B (push d s) - damping_storage k B s = B * (d ^ 2 - s (S k) ^ 2) / 2.
Proof.
  intros k B d s. unfold damping_storage. rewrite sum_to_first. simpl (push d s 1).
  rewrite (sum_to_ext k (fun i => push d s (S i) ^ 2) (fun j => s j ^ 2)).
  - simpl. field.
  - intros [| j] Hj; [lia | reflexivity].
Qed.

(** |d| times the path of the last k steps is paid by squares. *)
Lemma path_by_squares : forall k d s,
  Rabs d * sum_to k (fun j => Rabs (s j))
  <= INR k * d ^ 2 / 2 + sum_to k (fun j => s j ^ 2) / 2.
Proof.
  intros k d s. induction k as [| k IH]; [simpl; lra |].
  rewrite S_INR, !sum_to_S. cbv beta.
  pose proof (pow2_ge_0 (Rabs d - Rabs (s (S k)))) as Q.
  assert (A : forall x, Rabs x ^ 2 = x ^ 2) by (intro; apply pow2_abs).
  pose proof (A d). pose proof (A (s (S k))). nra.
Qed.

(** Positions at samples: [sample h j] is the position j samples before sample h; before the
    start it is what [past] says, any history at all. *)
Section Samples.

Variables (ts : nat -> R) (pos : R -> R) (past : nat -> R).

Definition sample (h j : nat) : R :=
  if Nat.leb j h then pos (ts (h - j)%nat) else past (j - h)%nat.

(** Displacement over the interval that ended j - 1 samples before sample h. *)
Definition step (h j : nat) : R := sample h (pred j) - sample h j.

Lemma sample_now : forall h, sample h 0 = pos (ts h).
Proof. intro h. unfold sample. simpl. rewrite Nat.sub_0_r. reflexivity. Qed.

Lemma sample_next : forall h j, sample (S h) (S j) = sample h j.
Proof. reflexivity. Qed.

Lemma step_next : forall h j, (1 <= j)%nat ->
  step (S h) j = push (pos (ts (S h)) - pos (ts h)) (step h) j.
Proof.
  intros h [| [| j]] Hj; [lia | |]; unfold step.
  - simpl pred. rewrite sample_next, !sample_now. reflexivity.
  - reflexivity.
Qed.

(** The delayed sample is no farther than the path of the steps since. *)
Lemma delayed_distance : forall h k,
  Rabs (pos (ts h) - sample h k) <= sum_to k (fun j => Rabs (step h j)).
Proof.
  intros h k. induction k as [| k IH].
  - rewrite sample_now. replace (_ - _) with 0 by ring. rewrite Rabs_R0. simpl. lra.
  - simpl sum_to.
    replace (pos (ts h) - sample h (S k)) with (pos (ts h) - sample h k + step h (S k))
      by (unfold step; simpl pred; ring).
    eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

End Samples.
