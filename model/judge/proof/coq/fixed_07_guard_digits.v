(** docs/fixed_point.md, theorem 7: guard digits and the common cut. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import fixed_06_blocks.

Open Scope R_scope.

(** An affine node: the real number z, its integer n, unit u and the enclosure of its error. *)
Record affine := { z : R; n : Z; u : R; l : R; h : R }.

Definition is_enclosed (node : affine) : Prop :=
  0 < u node /\ l node <= IZR (n node) * u node - z node <= h node.

(** Its integer with c low bits cut off, floor(2^-c n). *)
Definition cut (c : Z) (node : affine) : Z := n node / 2 ^ c.

(** The errors for which the lane must be right: [min(l, T l - (1 - T) u), max(h, T h)], with
    T = 2^-C. *)
Definition within_cut_error (C : Z) (node : affine) (error : R) : Prop :=
  let T := bpow radix2 (- C) in
  Rmin (l node) (T * l node - (1 - T) * u node) <= error <= Rmax (h node) (T * h node).

(** "floor(t n) u = t z' - r with 0 <= r <= (1 - t) u, as t n is a multiple of t." *)
Lemma cut_is_rounded_down c node :
  0 < u node -> (0 <= c)%Z ->
  let t := bpow radix2 (- c) in
  exists r, 0 <= r <= (1 - t) * u node /\
    IZR (cut c node) * u node = t * (IZR (n node) * u node) - r.
Proof.
  intros positive whole t. unfold cut.
  assert (size : (0 < 2 ^ c)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (Z.div_mod (n node) (2 ^ c)) as parts.
  pose proof (Z.mod_pos_bound (n node) (2 ^ c) size) as rest.
  assert (inverse : t * IZR (2 ^ c) = 1).
  { change 2%Z with (radix_val radix2). rewrite IZR_Zpower by auto. unfold t.
    rewrite <- bpow_plus, Z.add_opp_diag_l. reflexivity. }
  assert (t_positive : 0 < t) by apply bpow_gt_0.
  exists (t * IZR (n node mod 2 ^ c) * u node).
  assert (0 <= IZR (n node mod 2 ^ c)) by (apply (IZR_le 0); lia).
  assert (IZR (n node mod 2 ^ c) <= IZR (2 ^ c) - 1) by (rewrite <- minus_IZR; apply IZR_le; lia).
  split.
  - split; [repeat apply Rmult_le_pos; lra|]. apply Rmult_le_compat_r; [lra|]. nra.
  - rewrite parts at 2 by lia. rewrite plus_IZR, mult_IZR.
    replace (IZR (n node / 2 ^ c)) with (t * IZR (2 ^ c) * IZR (n node / 2 ^ c)) at 1
      by (rewrite inverse; ring).
    ring.
Qed.

Lemma linear_between_ends p q T t :
  T <= t <= 1 -> Rmin (p + q) (T * p + q) <= t * p + q <= Rmax (p + q) (T * p + q).
Proof.
  intros inside.
  pose proof (Rmin_l (p + q) (T * p + q)). pose proof (Rmin_r (p + q) (T * p + q)).
  pose proof (Rmax_l (p + q) (T * p + q)). pose proof (Rmax_r (p + q) (T * p + q)).
  destruct (Rle_lt_dec 0 p); split; nra.
Qed.

(** The error of the cut integer against t z. "Both ends are linear in t, so they lie between those
    for t = 1 and those for t = T." *)
Theorem cut_error c C node :
  is_enclosed node -> (0 <= c <= C)%Z ->
  within_cut_error C node (IZR (cut c node) * u node - bpow radix2 (- c) * z node).
Proof.
  intros [positive enclosure] [whole most].
  destruct (cut_is_rounded_down c node positive whole) as (r & r_size & ->).
  unfold within_cut_error.
  assert (T_t : bpow radix2 (- C) <= bpow radix2 (- c)) by (apply bpow_le; lia).
  assert (t_one : bpow radix2 (- c) <= 1) by (change 1 with (bpow radix2 0); apply bpow_le; lia).
  pose proof (bpow_gt_0 radix2 (- C)) as T_positive.
  set (t := bpow radix2 (- c)) in *. set (T := bpow radix2 (- C)) in *.
  set (error := IZR (n node) * u node - z node) in *.
  replace (t * (IZR (n node) * u node) - r - t * z node) with (t * error - r)
    by (unfold error; ring).
  assert (below : t * l node <= t * error) by (apply Rmult_le_compat_l; lra).
  assert (above : t * error <= t * h node) by (apply Rmult_le_compat_l; lra).
  pose proof (linear_between_ends (l node + u node) (- u node) T t ltac:(lra)) as [lower _].
  pose proof (linear_between_ends (h node) 0 T t ltac:(lra)) as [_ upper].
  replace (l node + u node + - u node) with (l node) in lower by ring.
  replace (T * (l node + u node) + - u node) with (T * l node - (1 - T) * u node) in lower by ring.
  rewrite !Rplus_0_r in upper. lra.
Qed.

(** The common cut: c is the least number from 0 on with -2^W <= floor(2^-c n_k) < 2^W for all k. *)
Definition fits (W c : Z) (node : affine) : Prop := (- 2 ^ W <= cut c node < 2 ^ W)%Z.

(** "C the most that it can be: no n_k has more than W + C magnitude bits." Then c is at most C. *)
Theorem common_cut_is_at_most_C W C nodes c :
  (0 <= W)%Z -> (0 <= C)%Z ->
  Forall (fun node => (- 2 ^ (W + C) <= n node < 2 ^ (W + C))%Z) nodes ->
  (forall c', (0 <= c')%Z -> Forall (fits W c') nodes -> (c <= c')%Z) ->
  (c <= C)%Z.
Proof.
  intros W_whole C_whole bits least. apply least; auto.
  apply Forall_impl with (2 := bits). intros node [above below].
  unfold fits, cut. rewrite Z.pow_add_r in above, below by lia.
  assert (0 < 2 ^ C)%Z by (apply Z.pow_pos_nonneg; lia).
  split; [apply Z.div_le_lower_bound|apply Z.div_lt_upper_bound]; lia.
Qed.

(** Theorem 7. The lane sees integers of W bits; it is right for all real numbers from which these
    are off by errors within the enclosures of cuts. *)
Theorem decision_behind_cut_is_right d f g (decide : list Z -> option comparison) W C c nodes
    answer :
  homogeneous d f -> homogeneous d g ->
  Forall is_enclosed nodes -> (0 <= c <= C)%Z -> Forall (fits W c) nodes ->
  (forall integers reals answer,
     Forall (fun integer => (- 2 ^ W <= integer < 2 ^ W)%Z) integers ->
     Forall2 (fun node pair => within_cut_error C node (IZR (fst pair) * u node - snd pair))
       nodes (combine integers reals) ->
     length integers = length nodes -> length reals = length nodes ->
     decide integers = Some answer -> Rcompare (f reals) (g reals) = answer) ->
  decide (map (cut c) nodes) = Some answer ->
  Rcompare (f (map z nodes)) (g (map z nodes)) = answer.
Proof.
  intros f_degree g_degree enclosed size fitting lane_is_right decided.
  rewrite <- (scaled_operands_have_the_order d f g (bpow radix2 (- c)) (map z nodes))
    by (auto; apply bpow_gt_0).
  apply lane_is_right with (map (cut c) nodes); auto; unfold scaled; rewrite ?map_length; auto.
  - now apply Forall_map.
  - clear - enclosed size. induction enclosed as [|node others is_in enclosed IH]; simpl.
    + constructor.
    + constructor; auto. cbn [fst snd]. now apply cut_error.
Qed.
