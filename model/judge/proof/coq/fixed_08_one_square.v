(** docs/fixed_point.md, theorem 8: one square that decides. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import norms.

Open Scope R_scope.

Lemma one_square_is_at_most_sum x element : In element x -> element ^ 2 <= sum_of_squares x.
Proof.
  induction x as [|first others IH]; intros inside; [contradiction|].
  cbn [sum_of_squares fold_right]. fold (sum_of_squares others).
  pose proof (sum_of_squares_is_nonnegative others). pose proof (pow2_ge_0 first).
  destruct inside as [-> | later]; [lra|]. specialize (IH later). lra.
Qed.

(** Theorem 8: the computed elements are x_k', g' is at most G, every threshold of f > g at most H,
    and q^2 >= G + H. [greater] is what the lane's criterion of theorem 4 says. *)
Theorem one_square_decides x' g' G H q threshold (greater : Prop) :
  g' <= G -> threshold <= H -> 0 <= q -> G + H <= q ^ 2 ->
  (norm x' ^ 2 - g' >= threshold -> greater) ->
  (exists element, In element x' /\ q <= Rabs element) ->
  greater.
Proof.
  intros most largest q_sign enough criterion (element & inside & long).
  apply criterion. rewrite norm_squared.
  pose proof (one_square_is_at_most_sum x' element inside).
  assert (q ^ 2 <= element ^ 2) by (rewrite <- (pow2_abs element); apply pow_incr; lra). lra.
Qed.

(** "Let 2^m be the power of two at or above q: the bits from 2^m on are only compared with the
    sign. If they differ from it, the element is beyond its reach", for any low bits. The element is
    n units; [high] are its bits from 2^bits units on, which equal the sign where [high] is 0 or
    -1. *)
Theorem high_bits_tell_reach n bits unit q :
  0 < unit -> (0 <= bits)%Z -> q <= bpow radix2 bits * unit ->
  let high := (n / 2 ^ bits)%Z in
  high <> 0%Z -> high <> (-1)%Z -> q <= Rabs (IZR n * unit).
Proof.
  intros positive whole reach high not_zero not_minus_one.
  assert (size : (0 < 2 ^ bits)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (Z.div_mod n (2 ^ bits)) as parts.
  pose proof (Z.mod_pos_bound n (2 ^ bits) size) as rest.
  fold high in parts.
  assert (long : (2 ^ bits <= Z.abs n)%Z).
  { assert (1 <= high \/ high <= -2)%Z as [above | below] by lia; nia. }
  apply IZR_le in long. rewrite abs_IZR in long. change 2%Z with (radix_val radix2) in long.
  rewrite IZR_Zpower in long by auto.
  apply Rle_trans with (1 := reach). rewrite Rabs_mult, (Rabs_pos_eq unit) by lra.
  apply Rmult_le_compat_r; lra.
Qed.
