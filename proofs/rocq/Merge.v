(** * Merge: the account of a log from the accounts of its pieces (TH-MERGE).

    A stretch of intervals keeps the sum of what they add, the least value of that sum and after how many
    intervals it was first reached, the least of other energies, the first interval of a kind, and what the
    last one hands on to the next. [join] makes of those of two stretches those of both. It is associative,
    the empty stretch changes nothing, and what it makes is what one pass over all intervals finds.

    The definitions are those of [passivity_core::course], with [R] for its numbers: [reach], [c_step],
    [c_append] of [Course]; [l_keep], [l_append] of [Least]; [f_keep], [f_append] of [First]; [h_append] of
    [Last]. *)

From Coq Require Import Reals Lra Lia List.
Import ListNotations.
Open Scope R_scope.
Local Arguments Nat.ltb : simpl never.

(** ** The sum and its least value *)

Record course := Course { c_sum : R; c_least : R; c_at : nat }.

Definition no_steps : course := Course 0 0 0.

Definition reach (c : course) (sum : R) (h : nat) : course :=
  if Rlt_dec sum (c_least c) then Course sum sum h else Course sum (c_least c) (c_at c).

Definition c_step (c : course) (x : R) (h : nat) : course := reach c (c_sum c + x) h.

Definition c_append (a : course) (n : nat) (b : course) : course :=
  let lowest := c_sum a + c_least b in
  if Rlt_dec lowest (c_least a) then Course (c_sum a + c_sum b) lowest (n + c_at b)
  else Course (c_sum a + c_sum b) (c_least a) (c_at a).

(** What every course is that was made of steps. *)
Definition is_course (c : course) : Prop :=
  c_least c <= 0 /\ c_least c <= c_sum c /\ (c_least c = 0 -> c_at c = O).

(** ** The least of other energies, the first interval of a kind, the last that hands something on *)

Definition l_keep (o : option (R * nat)) (v : R) (h : nat) : option (R * nat) :=
  match o with
  | None => Some (v, h)
  | Some (l, _) => if Rlt_dec v l then Some (v, h) else o
  end.

Definition l_append (a : option (R * nat)) (sum : R) (n : nat) (b : option (R * nat)) :=
  match b with
  | None => a
  | Some (v, h) => l_keep a (sum + v) (n + h)
  end.

Definition f_keep (o : option nat) (h : nat) : option nat :=
  match o with
  | None => Some h
  | Some f => if Nat.ltb h f then Some h else o
  end.

Definition f_append (a : option nat) (n : nat) (b : option nat) : option nat :=
  match b with
  | None => a
  | Some h => f_keep a (n + h)
  end.

Definition h_append {T : Type} (a b : option T) : option T :=
  match b with
  | None => a
  | Some _ => b
  end.

(** ** The account of a stretch *)

Section Stretches.

(** What an interval hands on, the force of the program beyond the wall's own. *)
Variable T : Type.

(** What an interval adds to the sum, what stands beside the sum as long as the log ends there, whether the
    interval is of the kind, and what it hands on. *)
Record interval := Interval { i_step : R; i_beside : R; i_kind : bool; i_on : option T }.

Record account := Account {
  steps : nat;
  net : course;
  lowest : option (R * nat);
  first : option nat;
  last : option T
}.

Definition empty : account := Account 0 no_steps None None None.

(** One more interval. *)
Definition enter (a : account) (i : interval) : account :=
  let h := S (steps a) in
  let net := c_step (net a) (i_step i) h in
  Account h net (l_keep (lowest a) (c_sum net + i_beside i) h)
    (if i_kind i then f_keep (first a) h else first a) (h_append (last a) (i_on i)).

Definition account_of (s : list interval) : account := fold_left enter s empty.

(** Two stretches, one after the other. *)
Definition join (a b : account) : account :=
  Account (steps a + steps b) (c_append (net a) (steps a) (net b))
    (l_append (lowest a) (c_sum (net a)) (steps a) (lowest b))
    (f_append (first a) (steps a) (first b)) (h_append (last a) (last b)).

Ltac split_courses :=
  unfold c_step, reach, c_append in *; cbn in *;
  repeat match goal with
  | |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y); cbn in *
  end.

Ltac same := try (f_equal; (lra || lia)); try (exfalso; lra); try reflexivity.

Lemma c_append_assoc : forall a n b m c,
  c_append (c_append a n b) (n + m) c = c_append a n (c_append b m c).
Proof. intros [sa la ka] n [sb lb kb] m [sc lc kc]. split_courses; same. Qed.

Lemma c_append_step : forall a n b x h,
  c_step (c_append a n b) x (n + h) = c_append a n (c_step b x h).
Proof. intros [sa la ka] n [sb lb kb] x h. split_courses; same. Qed.

Lemma c_append_none : forall a n, is_course a -> c_append a n no_steps = a.
Proof. intros [s l k] n (? & ? & ?). split_courses; same. Qed.

Lemma c_none_append : forall a, is_course a -> c_append no_steps 0 a = a.
Proof.
  intros [s l k] (N & B & Z). split_courses.
  - f_equal; lra.
  - assert (E : l = 0) by lra. rewrite (Z E). f_equal; lra.
Qed.

Lemma l_append_assoc : forall a s n b t m c,
  l_append (l_append a s n b) (s + t) (n + m) c = l_append a s n (l_append b t m c).
Proof.
  intros [[va ka]|] s n [[vb kb]|] t m [[vc kc]|]; cbn;
    repeat match goal with
    | |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y); cbn
    end; try reflexivity; try (exfalso; lra); repeat (f_equal; try lra; try lia).
Qed.

Lemma l_append_keep : forall a s n b v h,
  l_keep (l_append a s n b) (s + v) (n + h) = l_append a s n (l_keep b v h).
Proof.
  intros [[va ka]|] s n [[vb kb]|] v h; cbn;
    repeat match goal with
    | |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y); cbn
    end; try reflexivity; exfalso; lra.
Qed.

Lemma f_append_assoc : forall a n b m c,
  f_append (f_append a n b) (n + m) c = f_append a n (f_append b m c).
Proof.
  intros [fa|] n [fb|] m [fc|]; cbn;
    repeat match goal with
    | |- context [Nat.ltb ?x ?y] => destruct (Nat.ltb_spec x y); cbn
    end; try reflexivity; try (exfalso; lia); f_equal; lia.
Qed.

Lemma f_append_keep : forall a n b h,
  f_keep (f_append a n b) (n + h) = f_append a n (f_keep b h).
Proof.
  intros [fa|] n [fb|] h; cbn;
    repeat match goal with
    | |- context [Nat.ltb ?x ?y] => destruct (Nat.ltb_spec x y); cbn
    end; try reflexivity; try (exfalso; lia); f_equal; lia.
Qed.

Lemma h_append_assoc : forall a b c : option T,
  h_append (h_append a b) c = h_append a (h_append b c).
Proof. intros a b []; reflexivity. Qed.

(** ** It does not matter which are joined first, and the empty stretch changes nothing *)

Theorem TH_MERGE_associative : forall a b c, join (join a b) c = join a (join b c).
Proof.
  intros a b c. unfold join; cbn. f_equal.
  - lia.
  - apply c_append_assoc.
  - replace (c_sum (c_append (net a) (steps a) (net b))) with (c_sum (net a) + c_sum (net b)).
    + apply l_append_assoc.
    + unfold c_append. destruct Rlt_dec; reflexivity.
  - apply f_append_assoc.
  - apply h_append_assoc.
Qed.

Lemma is_course_step : forall c x h, is_course c -> is_course (c_step c x (S h)).
Proof.
  intros [s l k] x h (? & ? & ?). unfold is_course. split_courses; repeat split; try lra; auto.
Qed.

Lemma is_course_fold : forall s a, is_course (net a) -> is_course (net (fold_left enter s a)).
Proof. induction s as [| i s IH]; intros a C; cbn; [exact C |]. apply IH. now apply is_course_step. Qed.

Lemma is_course_of : forall s, is_course (net (account_of s)).
Proof. intros s. apply is_course_fold. repeat split; cbn; lra || auto. Qed.

Theorem TH_MERGE_empty : forall s,
  join empty (account_of s) = account_of s /\ join (account_of s) empty = account_of s.
Proof.
  intros s. pose proof (is_course_of s) as C.
  destruct (account_of s) as [n c l f h]; unfold join; cbn in *. split.
  - rewrite c_none_append by exact C. f_equal.
    + destruct l as [[]|]; cbn; [do 2 f_equal; lra | reflexivity].
    + now destruct f.
    + now destruct h.
  - rewrite c_append_none by exact C. f_equal. lia.
Qed.

(** ** What is joined is what one pass finds *)

Lemma join_enter : forall a b i, enter (join a b) i = join a (enter b i).
Proof.
  intros a b i. unfold enter, join; cbn. replace (S (steps a + steps b)) with (steps a + S (steps b))%nat by lia.
  rewrite c_append_step. f_equal.
  - replace (c_sum (c_append (net a) (steps a) (c_step (net b) (i_step i) (S (steps b)))) + i_beside i)
      with (c_sum (net a) + (c_sum (c_step (net b) (i_step i) (S (steps b))) + i_beside i)).
    + apply l_append_keep.
    + unfold c_append. destruct Rlt_dec; cbn; lra.
  - destruct (i_kind i); [apply f_append_keep | reflexivity].
  - apply h_append_assoc.
Qed.

Lemma join_fold : forall s a b, fold_left enter s (join a b) = join a (fold_left enter s b).
Proof. induction s as [| i s IH]; intros a b; cbn; [reflexivity |]. now rewrite join_enter, IH. Qed.

Theorem TH_MERGE : forall s t, join (account_of s) (account_of t) = account_of (s ++ t).
Proof.
  intros s t. unfold account_of at 3. rewrite fold_left_app. fold (account_of s).
  rewrite <- (proj2 (TH_MERGE_empty s)) at 2. now rewrite join_fold.
Qed.

(** Pieces, joined in pairs in any way. *)
Inductive pieces := Piece (s : list interval) | Joined (a b : pieces).

Fixpoint whole (p : pieces) : list interval :=
  match p with
  | Piece s => s
  | Joined a b => whole a ++ whole b
  end.

Fixpoint merged (p : pieces) : account :=
  match p with
  | Piece s => account_of s
  | Joined a b => join (merged a) (merged b)
  end.

Theorem TH_MERGE_pieces : forall p, merged p = account_of (whole p).
Proof. induction p as [s | a IHa b IHb]; cbn; [reflexivity |]. now rewrite IHa, IHb, TH_MERGE. Qed.

(** ** What is handed on from one piece to the next *)

(** An interval that depends on what those before it handed on. *)
Variable Sample : Type.
Variable of : option T -> Sample -> interval.

Fixpoint intervals (before : option T) (s : list Sample) : list interval :=
  match s with
  | nil => nil
  | x :: rest => of before x :: intervals (h_append before (i_on (of before x))) rest
  end.

Definition carried (before : option T) (s : list Sample) : option T :=
  h_append before (last (account_of (intervals before s))).

Lemma last_fold : forall s a, last (fold_left enter s a) = h_append (last a) (last (account_of s)).
Proof.
  unfold account_of. induction s as [| i s IH]; intros a; cbn; [reflexivity |].
  rewrite IH, (IH (enter empty i)). cbn. rewrite <- h_append_assoc. now destruct (i_on i).
Qed.

Lemma last_cons : forall i s,
  last (account_of (i :: s)) = h_append (i_on i) (last (account_of s)).
Proof.
  intros i s. change (account_of (i :: s)) with (fold_left enter s (enter empty i)).
  rewrite last_fold. cbn. now destruct (i_on i).
Qed.

Lemma intervals_app : forall s before t,
  intervals before (s ++ t) = intervals before s ++ intervals (carried before s) t.
Proof.
  induction s as [| x s IH]; intros before t; [reflexivity |]. cbn [intervals app].
  rewrite IH. unfold carried. cbn [intervals]. now rewrite last_cons, h_append_assoc.
Qed.

(** The second piece is read with what the first handed on. *)
Theorem TH_MERGE_carried : forall before s t,
  account_of (intervals before (s ++ t))
  = join (account_of (intervals before s)) (account_of (intervals (carried before s) t)).
Proof. intros before s t. now rewrite TH_MERGE, intervals_app. Qed.

(** ** What is found *)

Definition sum_after (s : list interval) (k : nat) : R :=
  fold_right Rplus 0 (map i_step (firstn k s)).

Lemma sum_after_app : forall s i k, (k <= length s)%nat -> sum_after (s ++ [i]) k = sum_after s k.
Proof.
  intros s i k K. unfold sum_after. rewrite firstn_app.
  replace (k - length s)%nat with O by lia. cbn. now rewrite app_nil_r.
Qed.

Lemma sum_after_last : forall s i,
  sum_after (s ++ [i]) (length (s ++ [i])) = sum_after s (length s) + i_step i.
Proof.
  intros s i. unfold sum_after. rewrite !firstn_all, map_app, fold_right_app. cbn.
  generalize (map i_step s) as l. induction l as [| x l IH]; cbn; lra.
Qed.

(** The least value of the sum, its start included, and the first place where it is that. *)
Theorem TH_MERGE_least : forall s,
  let a := account_of s in
  steps a = length s /\
  c_sum (net a) = sum_after s (length s) /\
  (c_at (net a) <= length s)%nat /\
  c_least (net a) = sum_after s (c_at (net a)) /\
  (forall k, (k <= length s)%nat -> c_least (net a) <= sum_after s k) /\
  (forall k, (k < c_at (net a))%nat -> c_least (net a) < sum_after s k).
Proof.
  intros s. cbn zeta. induction s as [| i s (N & S' & A & L & M & F)] using rev_ind.
  - unfold sum_after; cbn. repeat split; try lra; try lia. intros k K. destruct k; [cbn; lra | lia].
  - unfold account_of in *. rewrite fold_left_app. cbn. set (a := fold_left enter s empty) in *.
    assert (E : length (s ++ [i]) = S (length s)) by (rewrite app_length; cbn; lia).
    pose proof (sum_after_last s i) as Z. unfold c_step, reach. rewrite E in *.
    destruct (Rlt_dec (c_sum (net a) + i_step i) (c_least (net a))) as [Y | Y]; cbn;
      rewrite S' in Y |- *; rewrite N.
    + repeat split; auto.
      * intros k K. destruct (Nat.eq_dec k (S (length s))) as [-> | Q]; [lra |].
        rewrite sum_after_app by lia. specialize (M k ltac:(lia)). lra.
      * intros k K. rewrite sum_after_app by lia. specialize (M k ltac:(lia)). lra.
    + repeat split; auto.
      * change (c_least (net a) = sum_after (s ++ [i]) (c_at (net a))). now rewrite sum_after_app.
      * intros k K. destruct (Nat.eq_dec k (S (length s))) as [-> | Q]; [lra |].
        rewrite sum_after_app by lia. apply M. lia.
      * intros k K. rewrite sum_after_app by lia. now apply F.
Qed.

End Stretches.
