(** docs/fixed_point.md, theorem 1: an operand in floating point becomes an integer whose error is
    between minus one unit and 0. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

Section Operand.

(** The operand's magnitude, below 2^W u, and its unit. *)
Variables m u : R.
Hypothesis unit_positive : 0 < u.
Hypothesis magnitude : 0 <= m.

(** k = floor(m / u); the lane takes k, or the ones' complement. *)
Definition k : Z := Zfloor (m / u).
Definition taken (sign_bit : bool) : Z := if sign_bit then - k - 1 else k.

(** The operand x; a minus zero is 0. *)
Definition operand (sign_bit : bool) : R := if sign_bit then - m else m.

Lemma k_is_below : IZR k * u <= m < IZR k * u + u.
Proof.
  pose proof (Zfloor_lb (m / u)) as lower. pose proof (Zfloor_ub (m / u)) as upper.
  fold k in lower, upper.
  apply (Rmult_le_compat_r u) in lower; [|lra]. apply (Rmult_lt_compat_r u) in upper; auto.
  replace (m / u * u) with m in lower, upper by (field; lra). lra.
Qed.

(** Theorem 1. *)
Theorem operand_error sign_bit :
  - u <= IZR (taken sign_bit) * u - operand sign_bit <= 0.
Proof.
  pose proof k_is_below. unfold taken, operand. destruct sign_bit; [|lra].
  rewrite minus_IZR, opp_IZR. lra.
Qed.

(** "A minus zero becomes -1 with e = -u." *)
Theorem minus_zero : m = 0 -> taken true = (-1)%Z /\ IZR (taken true) * u - operand true = - u.
Proof.
  intros zero. unfold taken, operand, k. rewrite zero. unfold Rdiv. rewrite Rmult_0_l, Zfloor_IZR.
  split; [reflexivity|]. simpl. ring.
Qed.

(** Such an integer has W bits and a sign. *)
Theorem operand_has_bits W sign_bit :
  (0 <= W)%Z -> m < bpow radix2 W * u -> (- 2 ^ W <= taken sign_bit < 2 ^ W)%Z.
Proof.
  intros whole below.
  assert (k_positive : (0 <= k)%Z).
  { apply Zfloor_lub. apply Rmult_le_pos; auto. now apply Rlt_le, Rinv_0_lt_compat. }
  assert (k_short : (k < 2 ^ W)%Z).
  { apply lt_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by auto.
    apply Rle_lt_trans with (m / u); [apply Zfloor_lb|].
    apply (Rmult_lt_reg_r u); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  unfold taken. destruct sign_bit; lia.
Qed.

End Operand.

(** "An operand below 2^t whose grid is 2^g, with t - g at most W, becomes the integer n = x / 2^g,
    with e = 0." *)
Theorem grid_operand_is_exact W t g n :
  (0 <= W)%Z -> (t - g <= W)%Z -> Rabs (IZR n * bpow radix2 g) < bpow radix2 t ->
  (- 2 ^ W < n < 2 ^ W)%Z.
Proof.
  intros whole short below.
  rewrite Rabs_mult, (Rabs_pos_eq (bpow radix2 g)) in below by apply bpow_ge_0.
  assert (bpow radix2 t <= bpow radix2 W * bpow radix2 g)
    by (rewrite <- bpow_plus; apply bpow_le; lia).
  assert (Rabs (IZR n) < bpow radix2 W)
    by (apply (Rmult_lt_reg_r (bpow radix2 g)); [apply bpow_gt_0|lra]).
  rewrite <- abs_IZR, <- IZR_Zpower in * by auto. apply lt_IZR in H0.
  change (radix_val radix2) with 2%Z in H0. lia.
Qed.

(** An operand that arrives as N units of v, and then counts units of u >= v, a multiple of v. *)
Theorem fixed_operand_error v ratio N :
  0 < v -> (1 <= ratio)%Z ->
  let u := IZR ratio * v in
  let n := (N / ratio)%Z in
  v - u <= IZR n * u - IZR N * v <= 0 /\ (ratio = 1%Z -> IZR n * u - IZR N * v = 0).
Proof.
  intros positive whole u n. unfold u, n.
  pose proof (Z.div_mod N ratio) as parts. pose proof (Z.mod_pos_bound N ratio) as rest.
  assert (lost : (IZR (N / ratio) * (IZR ratio * v) - IZR N * v = - IZR (N mod ratio) * v)).
  { rewrite parts at 2 by lia. rewrite plus_IZR, mult_IZR. ring. }
  rewrite lost.
  assert (0 <= IZR (N mod ratio)) by (apply (IZR_le 0); lia).
  assert (IZR (N mod ratio) <= IZR ratio - 1) by (rewrite <- minus_IZR; apply IZR_le; lia).
  split; [split; nra|]. intros ->. rewrite Z.mod_1_r. ring.
Qed.
