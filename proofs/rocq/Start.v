(** * Start: TH-START, the bootstrap. *)

From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Passivity Require Import Definitions Quantizer Calculus Model History Law Combined Passivity.
Open Scope R_scope.

(** Induction along time: what holds at the start, persists for a while, and holds at the
    end of where it held before, holds throughout. *)
Lemma time_induction : forall (Q : R -> Prop) a b, a <= b ->
  (forall s, Q s \/ ~ Q s) ->
  Q a ->
  (forall s, a <= s < b -> (forall u, a <= u <= s -> Q u) ->
     exists eta, 0 < eta /\ forall u, s < u < s + eta -> u <= b -> Q u) ->
  (forall s, a < s <= b -> (forall u, a <= u < s -> Q u) -> Q s) ->
  forall s, a <= s <= b -> Q s.
Proof.
  intros Q a b ab dec Qa go close.
  set (E := fun s => a <= s <= b /\ forall u, a <= u <= s -> Q u).
  assert (Ea : E a) by (split; [lra | intros u Hu; replace u with a by lra; exact Qa]).
  destruct (completeness E) as (m & Hm & Hleast).
  - exists b. intros s [Hs _]. lra.
  - exists a. exact Ea.
  - assert (Hab : a <= m <= b).
    { split; [apply Hm, Ea | apply Hleast; intros s [Hs _]; lra]. }
    assert (Below : forall u, a <= u < m -> Q u).
    { intros u Hu. destruct (dec u) as [H | H]; [exact H | exfalso].
      assert (m <= u); [| lra]. apply Hleast. intros s [Hs Hall].
      destruct (Rle_lt_dec s u) as [L | L]; [exact L | exfalso; apply H, Hall; lra]. }
    assert (Qm : Q m).
    { destruct (Req_dec a m) as [-> | N]; [exact Qa | apply close; [lra | exact Below]]. }
    assert (All : forall u, a <= u <= m -> Q u).
    { intros u Hu. destruct (Req_dec u m) as [-> | N]; [exact Qm | apply Below; lra]. }
    destruct (Rlt_le_dec m b) as [L | L].
    + exfalso. destruct (go m ltac:(lra) All) as (eta & He & Hgo).
      set (n := m + Rmin (eta / 2) (b - m)).
      assert (0 < Rmin (eta / 2) (b - m)) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l (eta / 2) (b - m)). pose proof (Rmin_r (eta / 2) (b - m)).
      assert (En : E n).
      { split; [unfold n; lra |]. intros u Hu. destruct (Rle_lt_dec u m) as [H2 | H2].
        - apply All; lra.
        - apply Hgo; unfold n in Hu; lra. }
      apply Hm in En. unfold n in En. lra.
    + intros s Hs. apply All; lra.
Qed.

(** The surplus of an interval of any length is |d| times what is left at its mean speed. *)
Lemma jitter_surplus_at_speed : forall beta need coulomb d dtau, 0 < dtau ->
  jitter_surplus beta need coulomb d dtau
  = Rabs d * ((beta - need * dtau) * mean_speed d dtau + coulomb).
Proof.
  intros. unfold jitter_surplus, mean_speed. rewrite <- (pow2_abs d). field. lra.
Qed.

(** What is left when the speed is a little over the bound but the interval is not yet full. *)
Lemma spare_before_full : forall beta need coulomb W g,
  0 <= beta -> 0 < need -> 0 <= coulomb -> 0 <= W -> 0 < g <= 1 ->
  0 <= margin (beta - need) coulomb W -> (0 < coulomb \/ 0 < W) ->
  exists eps, 0 < eps /\ forall w dtau, 0 <= w <= W + eps -> 0 < dtau <= 1 - g ->
    0 <= (beta - need * dtau) * w + coulomb.
Proof.
  intros beta need coulomb W g Hb Hn Hc HW Hg Hm Hd. unfold margin in Hm.
  assert (Key : exists eps, 0 < eps /\
    0 <= (beta - need * (1 - g)) * (W + eps) + coulomb).
  { destruct (Rlt_le_dec 0 W) as [WP | WN].
    - exists (g * W). assert (0 < g * W) by (apply Rmult_lt_0_compat; lra). split; [assumption |].
      replace ((beta - need * (1 - g)) * (W + g * W) + coulomb)
        with ((beta - need) * W + coulomb + (beta + need * g) * (g * W)) by ring.
      assert (0 <= (beta + need * g) * (g * W)) by (apply Rmult_le_pos; [nra | lra]). lra.
    - assert (Cp : 0 < coulomb) by lra. exists (coulomb / need).
      assert (H : 0 < coulomb / need) by (apply Rdiv_lt_0_compat; lra). split; [exact H |].
      assert (E : need * (coulomb / need) = coulomb) by (field; lra).
      replace W with 0 by lra. assert (0 <= beta * (coulomb / need)) by (apply Rmult_le_pos; lra).
      assert (0 <= need * (coulomb / need) * g) by (rewrite E; apply Rmult_le_pos; lra).
      nra. }
  destruct Key as (eps & He & HK). exists eps. split; [exact He |].
  intros w dtau Hw Hdt.
  assert (L : (beta - need * (1 - g)) * w <= (beta - need * dtau) * w).
  { apply Rmult_le_compat_r; [lra |]. nra. }
  destruct (Rle_lt_dec 0 (beta - need * (1 - g))) as [S | S].
  - assert (0 <= (beta - need * (1 - g)) * w) by (apply Rmult_le_pos; lra). lra.
  - assert ((beta - need * (1 - g)) * (W + eps) <= (beta - need * (1 - g)) * w) by nra. lra.
Qed.

(** A force that never acts along the motion puts no energy in. *)
Lemma nothing_put_in : forall vel hand a b, a <= b ->
  ex_RInt (fun u => hand u * vel u) a b -> (forall u : R, hand u * vel u <= 0) ->
  operator_energy vel hand a b <= 0.
Proof.
  intros vel hand a b ab I H. unfold operator_energy.
  replace 0 with (RInt (fun _ => 0) a b) by (rewrite RInt_const; apply Rmult_0_r).
  apply RInt_le; [exact ab | exact I | apply (@ex_RInt_const R_NormedModule) |].
  intros u _. apply H.
Qed.

Section Bootstrap.

Variables mu beta sigma : R.
Variables (f V : R -> R) (B delta e : R) (k : nat).
Variables ts held past : nat -> R.
Variables pos vel friction hand : R -> R.
Hypothesis P : physical mu beta sigma.
Hypothesis T : increasing ts.
Hypothesis J : on_time ts.
Hypothesis L : wall f V B delta e.
Hypothesis O : obeys mu beta sigma ts held pos vel friction hand.
Hypothesis D : rendered f B delta e k ts pos past held.
(** Left alone: no outer force puts energy in.  More friction than sigma, at rest or not, may act. *)
Hypothesis unforced : forall t, hand t * vel t <= 0.

Let need := viscous_need (INR k) B.
Let coulomb := sigma - coulomb_need e delta B.
Let K : kinematic pos vel := is_kinematic _ _ _ _ _ _ _ _ _ O.

Variable W : R.
Hypothesis W_nonneg : 0 <= W.
Hypothesis W_energy :
  kinetic mu (vel (ts 0%nat)) + V (pos (ts 0%nat)) + extra_at ts pos past k B 0 <= kinetic mu W.
Hypothesis coulomb_holds : 0 <= coulomb.
Hypothesis margin_holds : 0 <= margin (beta - need) coulomb W.
Hypothesis not_degenerate : 0 < coulomb \/ 0 < W \/ 0 <= beta - need.

Lemma need_positive : 0 < need.
Proof.
  unfold need, viscous_need. pose proof (pos_INR k). pose proof (damping_nonneg _ _ _ _ _ L). lra.
Qed.

(** With the criterion up to W, an interval at speeds up to W pays. *)
Lemma interval_pays : forall h r, ts h < r <= ts (S h) ->
  (forall u, ts h <= u <= r -> Rabs (vel u) <= W) ->
  0 <= jitter_surplus beta need coulomb (pos r - pos (ts h)) (r - ts h).
Proof.
  intros h r Hr Hs. pose proof (J h) as Jh. pose proof need_positive as Np.
  rewrite jitter_surplus_at_speed by lra. apply Rmult_le_pos; [apply Rabs_pos |].
  destruct (EQ_28 pos vel K (ts h) r) as (u & Hu & _ & Em & _); [lra |]. rewrite Em.
  specialize (Hs u Hu). pose proof (Rabs_pos (vel u)) as Hv. set (w := Rabs (vel u)) in *.
  assert ((beta - need) * w <= (beta - need * (r - ts h)) * w)
    by (apply Rmult_le_compat_r; [exact Hv | nra]).
  unfold margin in margin_holds.
  destruct (Rle_lt_dec 0 (beta - need)) as [S | S].
  - assert (0 <= (beta - need) * w) by (apply Rmult_le_pos; lra). lra.
  - assert ((beta - need) * W <= (beta - need) * w) by nra. lra.
Qed.

(** With the criterion at every speed, every interval pays. *)
Lemma every_speed_pays : forall h r, 0 <= beta - need -> ts h < r <= ts (S h) ->
  0 <= jitter_surplus beta need coulomb (pos r - pos (ts h)) (r - ts h).
Proof.
  intros h r Enough Hr. pose proof (J h) as Jh. pose proof need_positive as Np.
  rewrite jitter_surplus_at_speed by lra. apply Rmult_le_pos; [apply Rabs_pos |].
  assert (0 <= mean_speed (pos r - pos (ts h)) (r - ts h)).
  { unfold mean_speed. apply Rmult_le_pos; [apply Rabs_pos |].
    apply Rlt_le, Rinv_0_lt_compat. lra. }
  assert (0 <= beta - need * (r - ts h)) by nra.
  assert (0 <= (beta - need * (r - ts h)) * mean_speed (pos r - pos (ts h)) (r - ts h))
    by (apply Rmult_le_pos; assumption).
  lra.
Qed.

(** If all intervals reached pay, the speed at the end is at most W. *)
Lemma paid_speed : forall N t, ts N <= t <= ts (S N) ->
  (forall h r, reached ts N t h r -> ts h < r ->
     0 <= jitter_surplus beta need coulomb (pos r - pos (ts h)) (r - ts h)) ->
  Rabs (vel t) <= W.
Proof.
  intros N t Ht Hp.
  destruct (TH_COMBINED_jitter mu beta sigma f V B delta e k ts held past pos vel friction hand
    P T L O D N t Ht Hp) as [I E].
  assert (Z : operator_energy vel hand (ts 0%nat) t <= 0).
  { apply nothing_put_in; [| exact I | exact unforced].
    pose proof (sample_order ts T 0 N ltac:(lia)). lra. }
  pose proof (potential_nonneg _ _ (law_potential _ _ _ _ _ L) (pos t)) as V0. cbv beta in V0.
  pose proof (extra_nonneg k B (push (pos t - pos (ts N)) (step ts pos past N))
    (damping_nonneg _ _ _ _ _ L)) as X0.
  unfold extra_towards in E. pose proof (mu_positive _ _ _ P) as M.
  assert (S : kinetic mu (vel t) <= kinetic mu W) by lra. unfold kinetic in S.
  apply Rsqr_incr_0_var; [| exact W_nonneg]. rewrite <- Rsqr_abs. unfold Rsqr. nra.
Qed.

(** TH-START (any effects): an unforced motion never passes a speed W whose kinetic energy
    covers the storage at the start, if the criterion holds up to W.  What delay and damping
    remember from before the start is part of that storage. *)
Theorem TH_START_combined : forall N t, ts N <= t <= ts (S N) -> Rabs (vel t) <= W.
Proof.
  destruct (Rle_lt_dec 0 (beta - need)) as [Enough | Short].
  { (* The criterion holds at every speed: every interval pays. *)
    intros N t Ht. apply (paid_speed N t Ht). intros h r [[_ ->] | [-> ->]] Hl.
    - apply every_speed_pays; [exact Enough |]. specialize (T h). lra.
    - apply every_speed_pays; [exact Enough | lra]. }
  assert (Moves : 0 < coulomb \/ 0 < W) by (destruct not_degenerate as [A | [A | A]]; lra).
  assert (Start : Rabs (vel (ts 0%nat)) <= W).
  { apply (paid_speed 0 (ts 0%nat)); [specialize (T 0%nat); lra |].
    intros h r [[H _] | [-> ->]] Hl; [lia | lra]. }
  assert (Past : forall N, (forall t, ts 0%nat <= t <= ts N -> Rabs (vel t) <= W) ->
                 forall t, ts N <= t <= ts (S N) -> Rabs (vel t) <= W).
  { intros N Before. pose proof (J N) as JN. pose proof (T N) as TN.
    assert (First : ts 0%nat <= ts N) by (apply sample_order; [exact T | lia]).
    assert (Earlier : forall h, (h < N)%nat ->
      0 <= jitter_surplus beta need coulomb (pos (ts (S h)) - pos (ts h)) (ts (S h) - ts h)).
    { intros h Hh. apply interval_pays; [specialize (T h); lra |]. intros u Hu. apply Before.
      pose proof (sample_order ts T 0 h ltac:(lia)). pose proof (sample_order ts T (S h) N Hh). lra. }
    apply (time_induction (fun t => Rabs (vel t) <= W)); [lra | | apply Before; lra | |].
    - intro s. destruct (Rle_dec (Rabs (vel s)) W); [left | right]; assumption.
    - intros s Hs Held. set (g := (ts (S N) - s) / 2).
      destruct (spare_before_full beta need coulomb W g) as (eps & He & Spare);
        try assumption; [apply P | apply need_positive | unfold g; lra |].
      destruct (continuous_near _ s eps (continuous_Rabs vel s (velocity_continuous _ _ K s)) He)
        as (r & Rp & Hr).
      exists (Rmin r g). split; [apply Rmin_glb_lt; [exact Rp | unfold g; lra] |].
      pose proof (Rmin_l r g) as Ml. pose proof (Rmin_r r g) as Mr.
      assert (Near : forall u, s <= u < s + Rmin r g -> Rabs (vel u) <= W + eps).
      { intros u Hu. specialize (Held s ltac:(lra)).
        assert (Bu : Rabs (Rabs (vel u) - Rabs (vel s)) < eps) by (apply Hr, Rabs_def1; lra).
        apply Rabs_def2 in Bu. lra. }
      intros u Hu Hb. apply (paid_speed N u); [lra |].
      intros h q [[Hh ->] | [-> ->]] Hl; [apply Earlier, Hh |].
      rewrite jitter_surplus_at_speed by lra. apply Rmult_le_pos; [apply Rabs_pos |].
      destruct (EQ_28 pos vel K (ts N) u Hl) as (c & Hc & _ & Em & _). rewrite Em.
      apply Spare; [| unfold g in *; lra]. split; [apply Rabs_pos |].
      destruct (Rle_lt_dec c s) as [Cs | Cs].
      + specialize (Held c ltac:(lra)). lra.
      + apply Near. lra.
    - intros s Hs Held. apply (paid_speed N s); [lra |].
      assert (Limit : Rabs (vel s) <= W).
      { destruct (Rle_lt_dec (Rabs (vel s)) W) as [Y | Y]; [exact Y | exfalso].
        assert (He : 0 < Rabs (vel s) - W) by lra.
        destruct (continuous_near _ s _ (continuous_Rabs vel s (velocity_continuous _ _ K s)) He)
          as (r & Rp & Hr).
        set (u := s - Rmin (r / 2) (s - ts N)).
        assert (M0 : 0 < Rmin (r / 2) (s - ts N)) by (apply Rmin_glb_lt; lra).
        pose proof (Rmin_l (r / 2) (s - ts N)). pose proof (Rmin_r (r / 2) (s - ts N)).
        assert (Bu : Rabs (Rabs (vel u) - Rabs (vel s)) < Rabs (vel s) - W)
          by (apply Hr; unfold u; apply Rabs_def1; lra).
        apply Rabs_def2 in Bu. specialize (Held u). unfold u in *. specialize (Held ltac:(lra)). lra. }
      intros h q [[Hh ->] | [-> ->]] Hl; [apply Earlier, Hh |].
      apply interval_pays; [lra |]. intros u Hu.
      destruct (Req_dec u s) as [-> | Ne]; [exact Limit | apply Held; lra]. }
  assert (All : forall N t, ts 0%nat <= t <= ts N -> Rabs (vel t) <= W).
  { induction N as [| N IH]; intros t Ht.
    - replace t with (ts 0%nat) by lra. exact Start.
    - destruct (Rle_lt_dec t (ts N)) as [C | C]; [apply IH; lra | apply (Past N IH); lra]. }
  intros N t Ht. apply (All (S N)).
  pose proof (sample_order ts T 0 N ltac:(lia)). lra.
Qed.

End Bootstrap.

Section Paper.

Variables mu beta sigma : R.
Variables pos vel friction hand : R -> R.
Hypothesis P : physical mu beta sigma.
Hypothesis O : paper_motion mu beta sigma pos vel friction hand.
(** Left alone: no outer force puts energy in.  More friction than sigma, at rest or not, may act. *)
Hypothesis unforced : forall t, hand t * vel t <= 0.

(** TH-START: unforced, with beta < 1/2 < sigma, if the criterion holds at the V with
    V^2 = v(0)^2 + xi(0)^2/mu then the speed never passes V. *)
Theorem TH_START : beta < 1 / 2 < sigma -> forall W, 0 <= W ->
  W ^ 2 = start_speed_squared mu (pos 0) (vel 0) ->
  0 <= margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) W ->
  forall t, 0 <= t -> Rabs (vel t) <= W.
Proof.
  intros Hbs W HW E M t Ht. destruct (INR_covers t Ht) as (N & HN).
  rewrite viscous_surplus_plain, coulomb_surplus_plain in M.
  apply (TH_START_combined mu beta sigma (fun x => x) linear_potential 0 0 (1 / 2) 0
    INR _ (fun _ => 0) pos vel friction hand P INR_increasing INR_on_time paper_wall O
    (paper_rendered pos _) unforced W HW) with (N := N); try exact M; try exact HN.
  - unfold extra_at. rewrite no_extra. simpl (INR 0). unfold kinetic, linear_potential.
    rewrite E. unfold start_speed_squared. pose proof (mu_positive _ _ _ P).
    right. field. lra.
  - unfold coulomb_need. lra.
  - left. unfold coulomb_need. lra.
Qed.

(** TH-START (consequence): then TH-RUN applies, and the storage never passes its start. *)
Theorem TH_START_storage : beta < 1 / 2 < sigma -> forall W, 0 <= W ->
  W ^ 2 = start_speed_squared mu (pos 0) (vel 0) ->
  0 <= margin (viscous_surplus beta 0 0) (coulomb_surplus sigma 0 0) W ->
  forall t, 0 <= t -> storage mu (pos t) (vel t) <= storage mu (pos 0) (vel 0).
Proof.
  intros Hbs W HW E M t Ht.
  destruct (TH_RUN mu beta sigma pos vel friction hand P O t Ht) as [I R].
  - intros u Hu Hv. pose proof (TH_START Hbs W HW E M u ltac:(lra)) as S.
    rewrite viscous_plain, coulomb_plain in *. unfold margin in M. unfold margin_8.
    pose proof (Rabs_pos_lt _ Hv) as Sp. set (w := Rabs (vel u)) in *.
    apply Rmult_le_reg_l with w; [exact Sp |]. rewrite Rmult_0_r.
    replace (w * (beta - 1 / 2 + (sigma - 1 / 2) / w))
      with ((beta - 1 / 2) * w + (sigma - 1 / 2)) by (field; lra). nra.
  - pose proof (nothing_put_in vel hand 0 t Ht I unforced). lra.
Qed.

(** EQ-10: started at xi(0) = 0, the criterion at the initial speed is enough. *)
Theorem EQ_10 : beta < 1 / 2 < sigma -> pos 0 = 0 -> criterion_8 beta sigma (vel 0) ->
  forall t, 0 <= t -> Rabs (vel t) <= Rabs (vel 0).
Proof.
  intros Hbs H0 C t Ht. apply (TH_START Hbs); [apply Rabs_pos | | | exact Ht].
  - unfold start_speed_squared. rewrite pow2_abs, H0. unfold Rdiv. ring.
  - unfold criterion_8 in C. rewrite viscous_plain, coulomb_plain in *. unfold margin.
    destruct (Req_dec (vel 0) 0) as [Z | Z].
    + rewrite Z, Rabs_R0. lra.
    + specialize (C Z). unfold margin_8 in C. pose proof (Rabs_pos_lt _ Z).
      replace ((beta - 1 / 2) * Rabs (vel 0) + (sigma - 1 / 2))
        with (Rabs (vel 0) * (beta - 1 / 2 + (sigma - 1 / 2) / Rabs (vel 0))) by (field; lra).
      apply Rmult_le_pos; lra.
Qed.

End Paper.
