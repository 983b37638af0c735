(** A lane's numbers and roundings, as the words of docs/error_bounds.md and the golden model
    (model/judge/golden/arithmetic.hpp) define them. Everything here is about real numbers: NaNs
    and infinities make an operation exceptional, and no theorem speaks of their values. *)
From Coq Require Import ZArith Reals Lia Lra.
From Flocq Require Import Core.

Open Scope R_scope.

(** [two_to e] is the power of two 2^e. *)
Notation two_to := (bpow radix2).

Inductive rounding := nearest | toward_zero.
Inductive subnormals := flush | gradual.

(** P digits; normal numbers are 2^m and more in magnitude, and below 2^(M + 1). *)
Record arithmetic := {
  precision : Z;
  min_exponent : Z;
  max_exponent : Z;
  mode : rounding;
  below_normal : subnormals;
  precision_positive : Prec_gt_0 precision
}.
#[global] Existing Instance precision_positive.

Section Arithmetic.

Variable a : arithmetic.
Notation P := (precision a).
Notation m := (min_exponent a).
Notation M := (max_exponent a).

Definition u : R := two_to (- P).

(** Ties go to even. *)
Definition to_integer : R -> Z :=
  match mode a with nearest => ZnearestE | toward_zero => Ztrunc end.

#[global] Instance to_integer_is_rounding : Valid_rnd to_integer.
Proof. unfold to_integer; destruct (mode a); auto with typeclass_instances. Qed.

(** The numbers of P digits with unbounded exponent, and those of the format. *)
Definition has_digits (x : R) : Prop := generic_format radix2 (FLX_exp P) x.
Definition of_format (x : R) : Prop := generic_format radix2 (FLT_exp (m - P + 1) P) x.

(** y rounded to P digits with unbounded exponent. *)
Definition rounded (y : R) : R := round radix2 (FLX_exp P) to_integer y.

Definition below_normal_range (y : R) : Prop := Rabs (rounded y) < two_to m.

(** The computed result of an operation whose exact result is y. Where it overflows, the operation
    is exceptional and the value does not matter. *)
Definition fl (y : R) : R :=
  if Rlt_bool (Rabs (rounded y)) (two_to m) then
    match below_normal a with
    | flush => 0
    | gradual => round radix2 (FLT_exp (m - P + 1) P) to_integer y
    end
  else rounded y.

(** What makes an operation on numbers exceptional: overflow, or a result other than 0 below the
    normal range that is flushed or inexact. *)
Definition exceptional (y : R) : Prop :=
  two_to (M + 1) <= Rabs (rounded y) \/
  (y <> 0 /\ below_normal_range y /\ (below_normal a = flush \/ fl y <> y)).

Lemma rounded_zero : rounded 0 = 0.
Proof. apply round_0; auto with typeclass_instances. Qed.

Lemma fl_zero : fl 0 = 0.
Proof.
  unfold fl; rewrite rounded_zero.
  destruct Rlt_bool; auto.
  destruct (below_normal a); auto.
  apply round_0; auto with typeclass_instances.
Qed.

(** The two cases of theorem 1's proof. *)
Lemma not_exceptional_is_exact_or_rounded y :
  ~ exceptional y -> fl y = y \/ fl y = rounded y.
Proof.
  intros ordinary.
  destruct (Req_dec y 0) as [-> | nonzero]; [left; apply fl_zero|].
  destruct (Rlt_le_dec (Rabs (rounded y)) (two_to m)) as [low | high].
  - left. destruct (Req_dec (fl y) y) as [same | other]; auto.
    exfalso; apply ordinary; right; auto.
  - right. unfold fl. now rewrite Rlt_bool_false.
Qed.

Lemma rounded_keeps_digits x : has_digits x -> rounded x = x.
Proof. intros; apply round_generic; auto with typeclass_instances. Qed.

Lemma rounded_has_digits x : has_digits (rounded x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.

Lemma format_has_digits x : of_format x -> has_digits x.
Proof. apply generic_format_FLX_FLT. Qed.

(** An operation whose exact result has P digits rounds nothing. *)
Lemma fl_of_digits_is_exact y : has_digits y -> ~ exceptional y -> fl y = y.
Proof.
  intros digits ordinary.
  destruct (not_exceptional_is_exact_or_rounded y ordinary) as [-> | ->]; auto.
  now apply rounded_keeps_digits.
Qed.

Lemma rounded_monotone x y : x <= y -> rounded x <= rounded y.
Proof. intros; apply round_le; auto with typeclass_instances. Qed.

Lemma rounded_opposite y : rounded (- y) = - rounded y.
Proof.
  unfold rounded, to_integer; destruct (mode a).
  - apply round_NE_opp.
  - apply round_ZR_opp.
Qed.

(** Both roundings are odd functions. *)
Lemma fl_opposite y : fl (- y) = - fl y.
Proof.
  unfold fl. rewrite rounded_opposite, Rabs_Ropp.
  destruct Rlt_bool; auto.
  destruct (below_normal a); [ring|].
  unfold to_integer; destruct (mode a).
  - apply round_NE_opp.
  - apply round_ZR_opp.
Qed.

Lemma exceptional_opposite y : exceptional (- y) <-> exceptional y.
Proof.
  unfold exceptional, below_normal_range. rewrite rounded_opposite, Rabs_Ropp, fl_opposite.
  split; (intros [over | (nonzero & low & lossy)]; [now left|right]);
    (split; [intro; apply nonzero; lra|split; auto]);
    (destruct lossy as [|lossy]; [now left|right; intro; apply lossy; lra]).
Qed.

(** Rounding keeps signs. *)
Lemma rounded_nonnegative y : 0 <= y -> 0 <= rounded y.
Proof. intros; rewrite <- rounded_zero; now apply rounded_monotone. Qed.

Lemma fl_nonnegative y : 0 <= y -> 0 <= fl y.
Proof.
  intros sign. unfold fl.
  destruct Rlt_bool; [|now apply rounded_nonnegative].
  destruct (below_normal a); [apply Rle_refl|].
  rewrite <- (round_0 radix2 (FLT_exp (m - P + 1) P) to_integer).
  apply round_le; auto with typeclass_instances.
Qed.

Lemma fl_nonpositive y : y <= 0 -> fl y <= 0.
Proof.
  intros sign. assert (opposite : 0 <= fl (- y)) by (apply fl_nonnegative; lra).
  rewrite fl_opposite in opposite; lra.
Qed.

(** Rounding keeps order, whether results below the normal range are flushed or not. *)
Lemma fl_keeps_order x y : x <= y -> fl x <= fl y.
Proof.
  intros order. pose proof (rounded_monotone x y order) as rounded_order.
  assert (bound_has_digits : has_digits (two_to m))
    by (apply generic_format_bpow; unfold FLX_exp; pose proof (precision_positive a) as digits;
        unfold Prec_gt_0 in digits; lia).
  assert (bound_of_format : of_format (two_to m))
    by (apply generic_format_FLT_bpow; [apply precision_positive|];
        pose proof (precision_positive a) as digits; unfold Prec_gt_0 in digits; lia).
  assert (low_rounded : forall z, Rabs (rounded z) < two_to m ->
            - two_to m < z < two_to m).
  { intros z small. apply Rabs_lt_inv in small.
    split; apply Rnot_le_lt; intros beyond; apply rounded_monotone in beyond;
      rewrite ?rounded_opposite, (rounded_keeps_digits _ bound_has_digits) in beyond; lra. }
  assert (low_result : forall z, - two_to m < z < two_to m ->
            - two_to m <= match below_normal a with
              | flush => 0
              | gradual => round radix2 (FLT_exp (m - P + 1) P) to_integer z
              end <= two_to m).
  { intros z small. pose proof (bpow_ge_0 radix2 m).
    destruct (below_normal a); [lra|]. split.
    - apply round_ge_generic; auto with typeclass_instances; [now apply generic_format_opp|lra].
    - apply round_le_generic; auto with typeclass_instances; lra. }
  unfold fl.
  destruct (Rlt_bool_spec (Rabs (rounded x)) (two_to m)) as [x_low | x_high];
    destruct (Rlt_bool_spec (Rabs (rounded y)) (two_to m)) as [y_low | y_high].
  - destruct (below_normal a); [lra|]. apply round_le; auto with typeclass_instances.
  - pose proof (low_result x (low_rounded x x_low)). apply Rabs_lt_inv in x_low.
    unfold Rabs in y_high. destruct Rcase_abs; lra.
  - pose proof (low_result y (low_rounded y y_low)). apply Rabs_lt_inv in y_low.
    unfold Rabs in x_high. destruct Rcase_abs; lra.
  - lra.
Qed.

(** Rounding to nearest finds the nearest number of P digits. *)
Lemma rounded_is_nearest y n :
  mode a = nearest -> has_digits n -> Rabs (rounded y - y) <= Rabs (n - y).
Proof.
  intros is_nearest digits. unfold rounded, to_integer. rewrite is_nearest.
  apply round_N_pt; auto with typeclass_instances.
Qed.

(** Rounding toward zero finds the next number of P digits toward zero. *)
Lemma rounded_toward_zero y n :
  mode a = toward_zero -> 0 <= y -> has_digits n ->
  rounded y <= y /\ (n <= y -> n <= rounded y).
Proof.
  intros is_toward_zero sign digits. unfold rounded, to_integer. rewrite is_toward_zero.
  rewrite round_ZR_DN by auto with typeclass_instances.
  split; [|intros below].
  - apply round_DN_pt; auto with typeclass_instances.
  - apply round_ge_generic; auto with typeclass_instances.
Qed.

End Arithmetic.
