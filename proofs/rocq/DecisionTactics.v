(** * Decision tactics: what signs of coefficients say of the criterion. *)

From Coq Require Import Reals Lra.
From Passivity Require Import Definitions Region Stability.
Open Scope R_scope.

(** The margin at V from its sign, or from the sign of the difference of squares. *)
Lemma margin_from_squares : forall viscous coulomb V, viscous < 0 < coulomb -> 0 < V ->
  (0 <= margin viscous coulomb V <->
   0 <= coulomb * coulomb - viscous * viscous * V ^ 2).
Proof.
  intros viscous coulomb V H HV. rewrite TH_START_squares by lra.
  unfold margin_of_squares. simpl. rewrite !Rmult_1_r. reflexivity.
Qed.

Lemma Rmult_neg_pos : forall x y, x < 0 -> 0 < y -> x * y < 0.
Proof.
  intros x y Hx Hy. rewrite <- (Rmult_0_l y). apply Rmult_lt_compat_r; assumption.
Qed.

Ltac decide_signs :=
  intros;
  repeat match goal with E : _ ^ 2 = ?x |- _ => subst x end;
  match goal with
  | |- globally_stable _ _ => apply TH_REGION_all; lra
  | |- unstable _ _ => apply TH_REGION_none; repeat split; lra
  | |- locally_stable _ _ => apply TH_REGION_up_to; lra
  | |- limit_cycles _ _ => apply TH_REGION_from; lra
  | |- holds_at_all _ _ => apply TH_REGION_all; lra
  | |- ~ holds_at_all _ _ =>
      let H := fresh in intro H; apply TH_REGION_all in H; lra
  | |- holds_up_to ?v ?c ?V =>
      apply TH_REGION_bound; [assumption |]; split; [lra |];
      first [ assert (0 <= v * V) by (apply Rmult_le_pos; lra); unfold margin; lra
            | unfold margin; lra
            | apply margin_from_squares; lra ]
  | |- ~ holds_up_to ?v ?c ?V =>
      let H := fresh in let M := fresh in
      intro H; apply TH_REGION_bound in H; [| assumption]; destruct H as [H M];
      first [ lra | unfold margin in M; lra
            | assert (v * V < 0) by (apply Rmult_neg_pos; assumption); unfold margin in M; lra
            | apply margin_from_squares in M; lra ]
  end.

(** ** Tolerances *)

Lemma holds_up_to_less : forall viscous coulomb V W, W <= V ->
  holds_up_to viscous coulomb V -> holds_up_to viscous coulomb W.
Proof. intros viscous coulomb V W H P v Hv. apply P. lra. Qed.

(** Every loop of the box from the signs at its ends. *)
Ltac decide_box :=
  intros;
  match goal with
  | |- _ /\ _ => split; decide_signs
  | _ => decide_signs
  end.

(** Every bound of the tolerance from the signs at its ends. *)
Ltac decide_bound :=
  intros;
  match goal with
  | _ : 0 < ?lo, _ : ?lo <= ?hi |- _ => assert (0 < hi) by lra
  end;
  match goal with
  | _ : ?lo <= ?V <= ?hi |- holds_up_to _ _ ?V =>
      apply holds_up_to_less with hi; [lra | decide_signs]
  | _ : ?lo <= ?V <= ?hi |- ~ holds_up_to ?v ?c ?V =>
      let H := fresh in
      intro H; assert (~ holds_up_to v c lo) by decide_signs;
      apply (holds_up_to_less v c V lo) in H; [contradiction | lra]
  | |- _ /\ _ => split; decide_signs
  end.

(** ** Stability *)

(** The rows of the recursion are those of the theorems. *)
Ltac decide_stability :=
  intros;
  match goal with
  | |- pole_inside _ _ => apply TH_LTI_stable_one; assumption
  | |- poles_inside _ _ _ => apply TH_LTI_stable_two; [assumption | split; assumption]
  | |- ~ pole_inside _ _ =>
      let H := fresh in intro H; apply TH_LTI_stable_one in H; [lra | assumption]
  | |- ~ poles_inside _ _ _ =>
      let H := fresh in let G := fresh in
      intro H; apply TH_LTI_stable_two in H; [destruct H as [H G]; lra | assumption]
  end.
