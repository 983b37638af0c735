(** docs/fixed_point.md, theorem 4: decided by the norm of the errors. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import norms.

Open Scope R_scope.

Section OneRadius.

(** f = |x|^2 and g = s^2. *)
Variable x : vector.
Variables s' error : R.
Notation s := (s' - error).
Notation f := (norm (real x) ^ 2).
Notation g := (s ^ 2).

Variables r l h c : R.
Hypothesis computed_radius_sign : 0 <= s'.
Hypothesis norm_of_errors : norm (errors x) <= r.
Hypothesis radius_error : l <= error <= h.

(** "Let c be -l where s >= 0 is certain, and the larger of -l and h elsewhere." *)
Hypothesis c_is : (0 <= s /\ c = - l) \/ c = Rmax (- l) h.

Notation a := (Rmax 0 (r + c)).
Notation b := (Rmax 0 (r + h)).
(** The squares and their sums are exact. *)
Notation D' := (norm (computed x) ^ 2 - s' ^ 2).

(** "So |s| <= s' + c." *)
Lemma real_radius_is_at_most : Rabs s <= s' + c.
Proof.
  destruct c_is as [[sign ->] | ->].
  - rewrite Rabs_pos_eq; lra.
  - pose proof (Rmax_l (- l) h). pose proof (Rmax_r (- l) h).
    unfold Rabs. destruct Rcase_abs; lra.
Qed.

Lemma norms_differ_by_at_most_r :
  norm (computed x) - r <= norm (real x) <= norm (computed x) + r.
Proof. pose proof (norms_are_near x) as near. apply Rabs_le_inv in near. lra. Qed.

Lemma squares_in_order p q : 0 <= p -> p < q -> p ^ 2 < q ^ 2.
Proof. intros. nra. Qed.

(** Theorem 4: "f > g if D' > 2 a s' + a^2". *)
Theorem norm_decides_greater : D' > 2 * a * s' + a ^ 2 -> f > g.
Proof.
  intros beyond. pose proof norms_differ_by_at_most_r. pose proof real_radius_is_at_most.
  pose proof (Rmax_l 0 (r + c)). pose proof (Rmax_r 0 (r + c)).
  assert (s' + a < norm (computed x)).
  { apply Rnot_le_lt. intros short. pose proof (norm_is_nonnegative (computed x)).
    assert (norm (computed x) ^ 2 <= (s' + a) ^ 2) by (apply pow_incr; lra). nra. }
  rewrite <- (pow2_abs s). apply squares_in_order; [apply Rabs_pos|lra].
Qed.

(** "f < g if D' < -2 b s'". *)
Theorem norm_decides_less : D' < -2 * b * s' -> f < g.
Proof.
  intros beyond. pose proof norms_differ_by_at_most_r.
  pose proof (Rmax_l 0 (r + h)). pose proof (Rmax_r 0 (r + h)).
  pose proof (norm_is_nonnegative (computed x)) as positive.
  assert (long : 2 * b < s') by (apply Rnot_le_lt; intros short; nra).
  assert (short : norm (computed x) < s' - b).
  { apply Rnot_le_lt. intros large.
    assert ((s' - b) ^ 2 <= norm (computed x) ^ 2) by (apply pow_incr; lra). nra. }
  apply squares_in_order; [apply norm_is_nonnegative|lra].
Qed.

End OneRadius.

(** "A negative s' needs no other proof: with abs(s') and abs(s) in place of s' and s, g is the
    same." *)
Theorem radius_may_be_negative s : Rabs s ^ 2 = s ^ 2.
Proof. apply pow2_abs. Qed.

Section TwoNorms.

(** f = |x|^2 and g = |y|^2; s' is a power of two above |y'|, or any such number. *)
Variables x y : vector.
Notation f := (norm (real x) ^ 2).
Notation g := (norm (real y) ^ 2).

Variables r q s' : R.
Hypothesis norm_of_errors : norm (errors x) <= r.
Hypothesis norm_of_other_errors : norm (errors y) <= q.
Hypothesis power_above : norm (computed y) < s'.

(** a = b = r + q. *)
Notation a := (r + q).
Notation D' := (norm (computed x) ^ 2 - norm (computed y) ^ 2).

Lemma both_norms_are_near :
  norm (computed x) - r <= norm (real x) <= norm (computed x) + r /\
  norm (computed y) - q <= norm (real y) <= norm (computed y) + q /\ 0 <= a.
Proof.
  pose proof (norms_are_near x) as near. pose proof (norms_are_near y) as near'.
  apply Rabs_le_inv in near. apply Rabs_le_inv in near'.
  pose proof (norm_is_nonnegative (errors x)). pose proof (norm_is_nonnegative (errors y)). lra.
Qed.

Theorem two_norms_decide_greater : D' > 2 * a * s' + a ^ 2 -> f > g.
Proof.
  intros beyond. destruct both_norms_are_near as (x_near & y_near & a_sign).
  pose proof (norm_is_nonnegative (computed y)) as positive.
  assert (norm (computed y) + a < norm (computed x)).
  { apply Rnot_le_lt. intros short. pose proof (norm_is_nonnegative (computed x)).
    assert (norm (computed x) ^ 2 <= (norm (computed y) + a) ^ 2) by (apply pow_incr; lra). nra. }
  apply Rlt_gt, squares_in_order; [apply norm_is_nonnegative|lra].
Qed.

Theorem two_norms_decide_less : D' < -2 * a * s' -> f < g.
Proof.
  intros beyond. destruct both_norms_are_near as (x_near & y_near & a_sign).
  pose proof (norm_is_nonnegative (computed y)) as y_sign.
  pose proof (norm_is_nonnegative (computed x)) as x_sign.
  assert (beyond_y : D' < -2 * a * norm (computed y)) by nra.
  assert (long : 2 * a < norm (computed y)) by (apply Rnot_le_lt; intros short; nra).
  assert (short : norm (computed x) < norm (computed y) - a).
  { apply Rnot_le_lt. intros large.
    assert ((norm (computed y) - a) ^ 2 <= norm (computed x) ^ 2) by (apply pow_incr; lra). nra. }
  apply squares_in_order; [apply norm_is_nonnegative|lra].
Qed.

End TwoNorms.

(** "Its exponent is half of the number of binary digits of |y'|^2, rounded up": N units squared
    have n digits. For N = 0 any power of two is above, and the lane takes 1. *)
Theorem power_above_norm N n :
  (0 <= N < 2 ^ n)%Z -> (0 <= n)%Z -> sqrt (IZR N) < bpow radix2 ((n + 1) / 2).
Proof.
  intros [sign below] whole. set (e := ((n + 1) / 2)%Z).
  pose proof (Z.div_mod (n + 1) 2). pose proof (Z.mod_pos_bound (n + 1) 2).
  assert (e_size : (n <= e + e)%Z) by (unfold e; lia).
  rewrite <- (sqrt_square (bpow radix2 e)) by apply bpow_ge_0.
  apply sqrt_lt_1; [now apply (IZR_le 0)|apply Rmult_le_pos; apply bpow_ge_0|].
  rewrite <- bpow_plus. apply Rlt_le_trans with (bpow radix2 n); [|now apply bpow_le].
  rewrite <- IZR_Zpower by auto. now apply IZR_lt.
Qed.

Theorem power_above_norm_is_least N n :
  (2 ^ (n - 1) <= N)%Z -> (1 <= n)%Z -> bpow radix2 ((n + 1) / 2 - 1) <= sqrt (IZR N).
Proof.
  intros above whole. set (e := ((n + 1) / 2 - 1)%Z).
  pose proof (Z.div_mod (n + 1) 2). pose proof (Z.mod_pos_bound (n + 1) 2).
  assert (e_size : (e + e <= n - 1)%Z) by (unfold e; lia).
  rewrite <- (sqrt_square (bpow radix2 e)) by apply bpow_ge_0.
  apply sqrt_le_1_alt. rewrite <- bpow_plus.
  apply Rle_trans with (bpow radix2 (n - 1)); [now apply bpow_le|].
  rewrite <- IZR_Zpower by lia. now apply IZR_le.
Qed.

(** "D' may lose low bits, from unit u to unit v": with D' = N u, v = 2^bits u and n v <= D' <
    (n + 1) v, a comparison of n with a threshold in units of v decides as one of D' would. *)
Theorem lost_bits_keep_thresholds u D' n k :
  0 < u -> IZR n * u <= D' < (IZR n + 1) * u ->
  ((n >= k)%Z -> D' >= IZR k * u) /\ ((n < - k)%Z -> D' < - IZR k * u).
Proof.
  intros positive [below above]. split; intros order.
  - apply Z.ge_le, IZR_le in order. nra.
  - assert (IZR n + 1 <= - IZR k) by (rewrite <- opp_IZR, <- plus_IZR; apply IZR_le; lia). nra.
Qed.

(** "In integers": the slope 2 a u_s / u_D rounded up, and the offset floor(a^2 / u_D) + 1, for
    s' = S units of u_s. *)
Theorem integer_threshold_is_enough a u_D u_s slope n S :
  0 < u_D -> 0 < u_s -> (0 <= S)%Z ->
  IZR slope >= 2 * a * u_s / u_D ->
  (n >= slope * S + (Zfloor (a ^ 2 / u_D) + 1))%Z ->
  IZR n * u_D > 2 * a * (IZR S * u_s) + a ^ 2.
Proof.
  intros D_positive s_positive S_sign steep reached.
  apply Z.ge_le, IZR_le in reached. rewrite !plus_IZR, mult_IZR in reached.
  pose proof (Zfloor_ub (a ^ 2 / u_D)) as offset. apply (IZR_le 0) in S_sign.
  assert (slope_part : IZR slope * IZR S * u_D >= 2 * a * (IZR S * u_s)).
  { replace (2 * a * (IZR S * u_s)) with (2 * a * u_s / u_D * IZR S * u_D) by (field; lra).
    apply Rle_ge. repeat apply Rmult_le_compat_r; lra. }
  apply (Rmult_lt_compat_r u_D) in offset; auto.
  replace (a ^ 2 / u_D * u_D) with (a ^ 2) in offset by (field; lra). nra.
Qed.

Theorem integer_threshold_is_enough_below b u_D u_s slope n S :
  0 < u_D -> 0 < u_s -> (0 <= S)%Z ->
  IZR slope >= 2 * b * u_s / u_D ->
  (n < - (slope * S))%Z ->
  IZR n * u_D < -2 * b * (IZR S * u_s).
Proof.
  intros D_positive s_positive S_sign steep reached.
  apply IZR_lt in reached. rewrite opp_IZR, mult_IZR in reached. apply (IZR_le 0) in S_sign.
  assert (slope_part : IZR slope * IZR S * u_D >= 2 * b * (IZR S * u_s)).
  { replace (2 * b * (IZR S * u_s)) with (2 * b * u_s / u_D * IZR S * u_D) by (field; lra).
    apply Rle_ge. repeat apply Rmult_le_compat_r; lra. }
  nra.
Qed.
