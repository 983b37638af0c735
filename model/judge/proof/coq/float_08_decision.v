(** docs/error_bounds.md, theorem 8: if the computed difference exceeds A/l, it has the sign of the
    true one. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds encodings float_02_steps float_07_absolute_parts.

Open Scope R_scope.

Section Decision.

Variable a : arithmetic.
Notation P := (precision a).
Notation fl := (fl a).
Notation gamma := (gamma a).
Notation number := (number a).

(** E may be a number of the lane's format, or of fewer digits with the same exponents. *)
Lemma fewer_digits_are_digits w E :
  (w <= P)%Z -> generic_format radix2 (FLX_exp w) E -> has_digits a E.
Proof.
  intros fewer. apply generic_inclusion_mag. unfold FLX_exp. lia.
Qed.

(** "Rounding keeps order and E is a number of the format." *)
Lemma result_beyond_number y E :
  ~ exceptional a y -> has_digits a E -> Rabs (fl y) > E -> Rabs y > E.
Proof.
  intros ordinary digits beyond. apply Rnot_le_gt. intros below.
  apply (Rgt_not_le _ _ beyond).
  destruct (not_exceptional_is_exact_or_rounded a y ordinary) as [-> | ->]; auto.
  apply abs_round_le_generic; auto with typeclass_instances.
Qed.

Lemma result_has_sign y : ~ exceptional a y -> (0 < fl y -> 0 < y) /\ (fl y < 0 -> y < 0).
Proof.
  intros ordinary. split; intros sign; apply Rnot_le_lt; intros other.
  - pose proof (fl_nonpositive a y other). lra.
  - pose proof (fl_nonnegative a y other). lra.
Qed.

Variables (f g true_f true_g : R).
Variables (b : interval) (A : R).
Hypothesis difference_bound : mixed_bound b A (f - g) (true_f - true_g).
Hypothesis ordinary : ~ exceptional a (f - g).
Notation D := (fl (f - g)).

(** The sign of the true difference is that of D. *)
Definition decided : Prop := (D > 0 /\ true_f > true_g) \/ (D < 0 /\ true_f < true_g).

(** Theorem 8. *)
Theorem difference_beyond_bound_decides E :
  has_digits a E -> E >= A / low b -> Rabs D > E -> decided.
Proof.
  intros digits enough beyond.
  pose proof (result_beyond_number _ _ ordinary digits beyond) as exact_beyond.
  pose proof (absolute_part_is_nonnegative _ _ _ _ difference_bound) as A_positive.
  destruct difference_bound as (positive & t & e & inside & small & is_true).
  assert (scaled : A < Rabs (f - g) * low b).
  { apply (Rmult_lt_reg_r (/ low b)); [now apply Rinv_0_lt_compat|].
    rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in enough. lra. }
  unfold within in inside. apply Rabs_le_inv in small.
  destruct (result_has_sign _ ordinary) as [is_positive is_negative].
  assert (E_positive : 0 <= E).
  { apply Rge_le, Rge_trans with (1 := enough), Rle_ge, Rmult_le_pos; auto.
    now apply Rlt_le, Rinv_0_lt_compat. }
  destruct (Rtotal_order D 0) as [negative | [zero | above]].
  - right. pose proof (is_negative negative).
    rewrite Rabs_left in scaled by assumption. split; auto. nra.
  - rewrite zero, Rabs_R0 in beyond. lra.
  - left. pose proof (is_positive above).
    rewrite Rabs_pos_eq in scaled by lra. split; auto. nra.
Qed.

(** The guard: A = q B, the lane computes E >= B, and decides iff key(D) > key(E) + k with
    γ(k) >= q/l. *)
Theorem guarded_difference_decides q B E key_D key_E k :
  A = q * B -> 0 <= q ->
  E >= B -> E = number key_E -> (0 < key_E)%Z ->
  Rabs D = number key_D -> (0 <= k)%Z -> (key_D > key_E + k)%Z ->
  gamma k >= q / low b ->
  decided.
Proof.
  intros is_A q_positive covers is_E E_positive is_D k_positive distant guard.
  assert (low_positive : 0 < low b) by apply difference_bound.
  assert (number_E : 0 < number key_E) by now apply number_positive.
  apply difference_beyond_bound_decides with (number (key_E + k)).
  - apply format_has_digits, number_is_of_format. lia.
  - assert (steps : number (key_E + k) / number key_E >= gamma k).
    { rewrite <- !V_of_whole. apply steps_multiply; auto.
      - apply (IZR_le 0). lia.
      - now rewrite V_of_whole.
      - rewrite plus_IZR. lra. }
    assert (number (key_E + k) >= gamma k * number key_E).
    { apply Rle_ge. apply Rge_le, (Rmult_le_compat_r (number key_E)) in steps; [|lra].
      unfold Rdiv in steps. rewrite Rmult_assoc, Rinv_l, Rmult_1_r in steps; lra. }
    assert (q / low b * E >= q / low b * B).
    { apply Rle_ge, Rmult_le_compat_l; [|lra].
      apply Rmult_le_pos; auto. now apply Rlt_le, Rinv_0_lt_compat. }
    assert (gamma k * number key_E >= q / low b * E)
      by (rewrite is_E; apply Rle_ge, Rmult_le_compat_r; lra).
    replace (A / low b) with (q / low b * B) by (rewrite is_A; field; lra). lra.
  - rewrite is_D. apply number_increases. lia.
Qed.

(** "E = 0 only if B = 0, when any D not 0 serves." *)
Theorem any_difference_decides_without_error : A = 0 -> D <> 0 -> decided.
Proof.
  intros none nonzero. apply difference_beyond_bound_decides with 0.
  - apply generic_format_0.
  - rewrite none. unfold Rdiv. rewrite Rmult_0_l. apply Rle_refl.
  - now apply Rabs_pos_lt.
Qed.

End Decision.
