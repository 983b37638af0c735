(** docs/error_bounds.md, theorem 1: the exact result y of an operation that is not exceptional is
    its computed result times a number in [1 - u, 1 + u] or [1, 1 + 2u]. With `inputs = N` it holds
    for the rounding of an operand to N digits: [a] is then the lane's arithmetic with the precision
    N. *)
From Coq Require Import ZArith Reals Lia Lra.
From Flocq Require Import Core Relative.
From mixcmp Require Import arithmetic bounds.

Open Scope R_scope.

Section OneRounding.

Variable a : arithmetic.
Notation P := (precision a).
Notation u := (u a).
Notation fl := (fl a).
Notation exceptional := (exceptional a).

Lemma u_is_positive : 0 < u.
Proof. apply bpow_gt_0. Qed.

Lemma two_u_is_one_ulp : two_to (- P + 1) = 2 * u.
Proof. rewrite bpow_plus. unfold arithmetic.u. change (two_to 1) with 2. ring. Qed.

Lemma nearest_error_in_computed y :
  mode a = nearest -> Rabs (rounded a y - y) <= u * Rabs (rounded a y).
Proof.
  intros is_nearest.
  pose proof (relative_error_N_FLX_round radix2 P (precision_positive a)
                (fun n => negb (Z.even n)) y) as error.
  rewrite two_u_is_one_ulp in error.
  unfold rounded, to_integer. rewrite is_nearest. lra.
Qed.

Lemma toward_zero_error_in_computed y :
  mode a = toward_zero ->
  0 <= y -> rounded a y <= y <= rounded a y * (1 + 2 * u).
Proof.
  intros is_toward_zero sign.
  pose proof (rounded_toward_zero a y _ is_toward_zero sign (rounded_has_digits a 0)) as [below _].
  split; auto.
  destruct (Req_dec y 0) as [-> | nonzero]; [rewrite rounded_zero; lra|].
  pose proof (relative_error_FLX_round radix2 P (precision_positive a) (to_integer a) y nonzero)
    as error.
  rewrite two_u_is_one_ulp in error.
  change (round radix2 (FLX_exp P) (to_integer a) y) with (rounded a y) in error.
  pose proof (rounded_nonnegative a y sign).
  rewrite (Rabs_pos_eq (rounded a y)) in error by assumption.
  apply Rabs_lt_inv in error. lra.
Qed.

(** What the proof shows of y rounded to P digits with unbounded exponent. *)
Lemma rounded_within_bound y : exists t, y = rounded a y * t /\ within (rounding_bound a) t.
Proof.
  pose proof u_is_positive as positive.
  destruct (Req_dec (rounded a y) 0) as [zero | nonzero].
  - exists 1. split; [|unfold within, rounding_bound; destruct (mode a); simpl; lra].
    rewrite zero, Rmult_0_l. apply eq_0_round_0_FLX with (3 := zero); auto with typeclass_instances.
  - exists (y / rounded a y). split; [field; auto|].
    unfold within, rounding_bound. destruct (mode a) eqn:is_mode; simpl.
    + pose proof (nearest_error_in_computed y is_mode) as error.
      assert (relative : Rabs (1 - y / rounded a y) <= u).
      { replace (1 - y / rounded a y) with ((rounded a y - y) / rounded a y) by (field; auto).
        unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
        apply (Rmult_le_reg_r (Rabs (rounded a y))); [now apply Rabs_pos_lt|].
        rewrite Rmult_assoc, Rinv_l, Rmult_1_r; auto. now apply Rabs_no_R0. }
      apply Rabs_le_inv in relative. lra.
    + assert (above : forall z, mode a = toward_zero -> 0 <= z -> rounded a z <> 0 ->
                        1 <= z / rounded a z <= 1 + 2 * u).
      { intros z _ sign other.
        pose proof (toward_zero_error_in_computed z is_mode sign).
        pose proof (rounded_nonnegative a z sign).
        assert (0 < rounded a z) by lra.
        split; apply (Rmult_le_reg_r (rounded a z)); auto;
          unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra. }
      destruct (Rle_dec 0 y) as [sign | sign]; [now apply above|].
      replace (y / rounded a y) with (- y / rounded a (- y)).
      * apply above; auto; rewrite ?rounded_opposite; lra.
      * rewrite rounded_opposite. field. auto.
Qed.

(** Theorem 1. *)
Theorem one_rounding y :
  ~ exceptional y ->
  exists t, y = fl y * t /\
    match mode a with
    | nearest => 1 - u <= t <= 1 + u
    | toward_zero => 1 <= t <= 1 + 2 * u
    end.
Proof.
  intros ordinary. pose proof u_is_positive.
  destruct (not_exceptional_is_exact_or_rounded a y ordinary) as [same | same]; rewrite same.
  - exists 1. split; [ring|]. destruct (mode a); lra.
  - destruct (rounded_within_bound y) as (t & equal & inside).
    exists t. split; auto. unfold within, rounding_bound in inside.
    destruct (mode a); exact inside.
Qed.

(** The same with the interval as a value. *)
Corollary one_rounding_within y :
  ~ exceptional y -> exists t, y = fl y * t /\ within (rounding_bound a) t.
Proof.
  intros ordinary. destruct (one_rounding y ordinary) as (t & equal & inside).
  exists t. split; auto. unfold within, rounding_bound. destruct (mode a); exact inside.
Qed.

(** "Some operations round nothing, so that t = 1": negate, absolute, minimum and maximum. *)
Theorem selections_round_nothing x y :
  has_digits a x -> has_digits a y ->
  (~ exceptional (- x) -> fl (- x) = - x) /\
  (~ exceptional (Rabs x) -> fl (Rabs x) = Rabs x) /\
  (~ exceptional (Rmin x y) -> fl (Rmin x y) = Rmin x y) /\
  (~ exceptional (Rmax x y) -> fl (Rmax x y) = Rmax x y).
Proof.
  intros first second.
  repeat split; apply fl_of_digits_is_exact.
  - now apply generic_format_opp.
  - now apply generic_format_abs.
  - unfold Rmin; destruct Rle_dec; auto.
  - unfold Rmax; destruct Rle_dec; auto.
Qed.

(** A number of p digits. *)
Definition of_digits (p : Z) (x : R) : Prop :=
  exists f : float radix2, x = F2R f /\ (Z.abs (Fnum f) < 2 ^ p)%Z.

Lemma of_digits_has_digits p x : (0 <= p <= P)%Z -> of_digits p x -> has_digits a x.
Proof.
  intros size (f & -> & short). apply generic_format_FLX.
  exists f; auto. apply Z.lt_le_trans with (1 := short).
  change (radix_val radix2) with 2%Z. apply Z.pow_le_mono_r; lia.
Qed.

(** A conversion to at least as many digits. *)
Theorem conversion_to_more_digits_rounds_nothing p x :
  (0 <= p <= P)%Z -> of_digits p x -> ~ exceptional x -> fl x = x.
Proof. intros; apply fl_of_digits_is_exact; auto; now apply of_digits_has_digits with p. Qed.

(** A product or square whose operands have at most P/2 digits. *)
Theorem short_product_rounds_nothing p x y :
  (0 <= p)%Z -> (2 * p <= P)%Z -> of_digits p x -> of_digits p y ->
  ~ exceptional (x * y) -> fl (x * y) = x * y.
Proof.
  intros size short (f & -> & first) (g & -> & second) ordinary.
  apply fl_of_digits_is_exact; auto.
  apply of_digits_has_digits with (2 * p)%Z; [lia|].
  exists (Float radix2 (Fnum f * Fnum g) (Fexp f + Fexp g)). split.
  - unfold F2R; simpl. rewrite mult_IZR, bpow_plus. ring.
  - cbn [Fnum]. rewrite Z.abs_mul. replace (2 * p)%Z with (p + p)%Z by ring.
    rewrite Z.pow_add_r by lia. apply Z.mul_lt_mono_nonneg; lia.
Qed.

(** A product with a constant power of two, if the operand has at most P digits. *)
Theorem product_with_power_of_two_rounds_nothing x e sign :
  sign = 1 \/ sign = -1 ->
  has_digits a x -> ~ exceptional (x * (sign * two_to e)) ->
  fl (x * (sign * two_to e)) = x * (sign * two_to e).
Proof.
  intros unit digits ordinary. apply fl_of_digits_is_exact; auto.
  assert (scaled : has_digits a (x * two_to e)).
  { apply FLX_format_generic in digits; [|apply precision_positive].
    destruct digits as [f -> short]. apply generic_format_FLX.
    exists (Float radix2 (Fnum f) (Fexp f + e)); auto.
    unfold F2R; simpl. rewrite bpow_plus. ring. }
  destruct unit as [-> | ->].
  - now rewrite Rmult_1_l.
  - replace (x * (-1 * two_to e)) with (- (x * two_to e)) by ring. now apply generic_format_opp.
Qed.

(** A quotient by a constant power of two. *)
Theorem quotient_by_power_of_two_rounds_nothing x e sign :
  sign = 1 \/ sign = -1 ->
  has_digits a x -> ~ exceptional (x / (sign * two_to e)) ->
  fl (x / (sign * two_to e)) = x / (sign * two_to e).
Proof.
  intros unit digits.
  replace (x / (sign * two_to e)) with (x * (sign * two_to (- e))).
  - now apply product_with_power_of_two_rounds_nothing.
  - rewrite bpow_opp. pose proof (bpow_gt_0 radix2 e).
    destruct unit as [-> | ->]; field; lra.
Qed.

End OneRounding.
