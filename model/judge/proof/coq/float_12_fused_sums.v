(** docs/error_bounds.md, theorem 12: the error of fused sums and comparisons. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core Relative.
From mixcmp Require Import arithmetic encodings float_01_one_rounding float_10_ranges.
Import ListNotations.

Open Scope R_scope.

(** A term is the product of two computed operands, or one operand times 1. *)
Definition term : Type := R * R.
Definition value (t : term) : R := fst t * snd t.

(** The exponent of a term is the sum of the exponents of its factors. *)
Definition exponent (t : term) : Z := (mag radix2 (fst t) - 1) + (mag radix2 (snd t) - 1).

(** s, and T. *)
Definition sum (values : list R) : R := fold_right Rplus 0 values.
Definition exact_sum (terms : list term) : R := sum (map value terms).
Definition magnitudes (terms : list term) : R := sum (map (fun t => Rabs (value t)) terms).

(** The largest exponent of a term that is not zero, at least [least] where there is one. *)
Fixpoint largest_exponent (least : option Z) (terms : list term) : option Z :=
  match terms with
  | nil => least
  | t :: others =>
      let rest := largest_exponent least others in
      if Req_bool (value t) 0 then rest
      else match rest with Some e => Some (Z.max e (exponent t)) | None => Some (exponent t) end
  end.

(** G = 5 + ceil(log2 n). *)
Definition guard_digits (terms : list term) : Z := 5 + Z.log2_up (Z.of_nat (length terms)).

Section FusedSums.

Variable a : arithmetic.
Notation P := (precision a).
Notation m := (min_exponent a).
Notation u := (u a).
Notation fl := (fl a).
(** η, the smallest subnormal number. *)
Notation eta := (smallest a).

Lemma half_eta : eta / 2 = u * two_to m.
Proof.
  unfold smallest, arithmetic.u. change (/ 2) with (two_to (-1)). unfold Rdiv.
  change (/ 2) with (two_to (-1)). rewrite <- !bpow_plus. f_equal. ring.
Qed.

(** "Rounding adds half a unit in the last place, at most u |S| or η/2." *)
Lemma last_rounding x :
  mode a = nearest -> below_normal a = gradual ->
  Rabs (fl x - x) <= Rmax (u * Rabs x) (eta / 2).
Proof.
  intros is_nearest is_gradual.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
  assert (in_range : Rabs (rounded a x - x) <= u * Rabs x).
  { pose proof (relative_error_N_FLX radix2 P digits (fun n => negb (Z.even n)) x) as error.
    rewrite two_u_is_one_ulp in error. unfold rounded, to_integer. rewrite is_nearest. lra. }
  unfold arithmetic.fl. rewrite is_gradual.
  destruct (Rlt_bool_spec (Rabs (rounded a x)) (two_to m)) as [low | normal].
  2: { apply Rle_trans with (1 := in_range), Rmax_l. }
  apply Rle_trans with (2 := Rmax_r _ _).
  assert (small : Rabs x < two_to m).
  { apply Rnot_le_lt. intros large. apply (Rlt_not_le _ _ low).
    apply abs_round_ge_generic; auto with typeclass_instances.
    apply generic_format_bpow. unfold FLX_exp. lia. }
  unfold to_integer. rewrite is_nearest.
  apply Rle_trans with (/ 2 * ulp radix2 (FLT_exp (m - P + 1) P) x).
  - apply error_le_half_ulp; auto with typeclass_instances.
  - rewrite ulp_FLT_small; auto with typeclass_instances.
    + unfold smallest. lra.
    + replace (m - P + 1 + P)%Z with (m + 1)%Z by ring.
      apply Rlt_le_trans with (1 := small). apply bpow_le. lia.
Qed.

Variable terms : list term.
Hypothesis two_or_more : (2 <= length terms)%nat.

Notation T := (magnitudes terms).
Notation s := (exact_sum terms).

(** E; where all terms are zero, with [flush], any number serves. *)
Definition E : Z :=
  match largest_exponent (match below_normal a with gradual => Some m | flush => None end) terms
  with
  | Some e => e
  | None => 0
  end.

Definition q : R := two_to (E - P - guard_digits terms).

(** A term cut toward zero to a multiple of q, and S. *)
Definition cut (x : R) : R := IZR (Ztrunc (x / q)) * q.
Definition cut_sum : R := sum (map (fun t => cut (value t)) terms).
Notation S := cut_sum.

Lemma q_is_positive : 0 < q.
Proof. apply bpow_gt_0. Qed.

Lemma term_reaches_exponent t : value t <> 0 -> two_to (exponent t) <= Rabs (value t).
Proof.
  intros nonzero. unfold value, exponent in *. rewrite bpow_plus, Rabs_mult.
  apply Rmult_le_compat; try apply bpow_ge_0; apply bpow_mag_le;
    intros zero; apply nonzero; rewrite zero; ring.
Qed.

Lemma magnitudes_are_nonnegative l : 0 <= magnitudes l.
Proof.
  induction l as [|t others IH]; unfold magnitudes in *; simpl; [lra|].
  pose proof (Rabs_pos (value t)). lra.
Qed.

(** "If E is a term's exponent then T >= 2^E; else E = m." *)
Lemma largest_exponent_is_reached least l e :
  largest_exponent least l = Some e -> two_to e <= magnitudes l \/ least = Some e.
Proof.
  revert e. induction l as [|t others IH]; simpl; intros e is_largest; [now right|].
  pose proof (magnitudes_are_nonnegative others) as positive.
  pose proof (Rabs_pos (value t)) as t_positive.
  change (magnitudes (t :: others)) with (Rabs (value t) + magnitudes others).
  destruct (Req_bool_spec (value t) 0) as [zero | nonzero].
  - destruct (IH e is_largest); [left; lra|now right].
  - pose proof (term_reaches_exponent t nonzero) as reached.
    destruct (largest_exponent least others) as [e'|] eqn:rest; injection is_largest as <-.
    + destruct (Z.max_spec e' (exponent t)) as [[_ ->] | [_ ->]]; [left; lra|].
      destruct (IH e' eq_refl); [left; lra|now right].
    + left. lra.
Qed.

Lemma no_exponent_means_zero l :
  largest_exponent None l = None -> forall t, In t l -> value t = 0.
Proof.
  induction l as [|t others IH]; simpl; intros none t' inside; [contradiction|].
  destruct (Req_bool_spec (value t) 0) as [zero | nonzero].
  - destruct inside as [<- | later]; auto.
  - destruct (largest_exponent None others); discriminate.
Qed.

(** A cut loses less than q, and makes no term larger. *)
Lemma cut_loses_less_than_q x : Rabs (cut x - x) < q /\ Rabs (cut x) <= Rabs x.
Proof.
  pose proof q_is_positive as positive. unfold cut.
  assert (is_x : x = x / q * q) by (field; lra).
  assert (split : Rabs (IZR (Ztrunc (x / q)) - x / q) < 1 /\
                  Rabs (IZR (Ztrunc (x / q))) <= Rabs (x / q)).
  { set (y := x / q). destruct (Rlt_le_dec y 0) as [negative | above].
    - rewrite Ztrunc_ceil by lra.
      pose proof (Zceil_ub y) as upper. pose proof (Zceil_lb y) as lower.
      assert (IZR (Zceil y) <= 0) by (apply (IZR_le _ 0), Zceil_glb; lra).
      rewrite (Rabs_left1 y), (Rabs_left1 (IZR (Zceil y))) by lra.
      split; [apply Rabs_lt|]; lra.
    - rewrite Ztrunc_floor by lra.
      pose proof (Zfloor_ub y) as upper. pose proof (Zfloor_lb y) as lower.
      assert (0 <= IZR (Zfloor y)) by (apply (IZR_le 0), Zfloor_lub; lra).
      rewrite (Rabs_pos_eq y), (Rabs_pos_eq (IZR (Zfloor y))) by lra.
      split; [apply Rabs_lt|]; lra. }
  destruct split as [near smaller]. split.
  - replace (IZR (Ztrunc (x / q)) * q - x) with ((IZR (Ztrunc (x / q)) - x / q) * q)
      by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq q) by lra. nra.
  - rewrite is_x at 2. rewrite !Rabs_mult. apply Rmult_le_compat_r; auto using Rabs_pos.
Qed.

Lemma cuts_lose_at_most_n_q l :
  Rabs (sum (map (fun t => cut (value t)) l) - exact_sum l) <= IZR (Z.of_nat (length l)) * q /\
  Rabs (sum (map (fun t => cut (value t)) l)) <= magnitudes l.
Proof.
  unfold exact_sum, magnitudes. induction l as [|t others [near smaller]].
  - simpl. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
  - destruct (cut_loses_less_than_q (value t)) as [t_near t_smaller].
    replace (Z.of_nat (length (t :: others))) with (1 + Z.of_nat (length others))%Z
      by (cbn [length]; lia).
    rewrite plus_IZR, Rmult_plus_distr_r, Rmult_1_l. cbn [map sum fold_right].
    fold (sum (map (fun t => cut (value t)) others)) (sum (map value others)).
    fold (sum (map (fun t => Rabs (value t)) others)).
    set (x := sum (map (fun t => cut (value t)) others)) in *.
    set (y := sum (map value others)) in *. split.
    + replace (cut (value t) + x - (value t + y)) with ((cut (value t) - value t) + (x - y))
        by ring.
      apply Rle_trans with (1 := Rabs_triang _ _). lra.
    + apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.

(** "n q <= 2^(G-5) q = (u/32) 2^E." *)
Lemma n_q_is_small : IZR (Z.of_nat (length terms)) * q <= u / 32 * two_to E.
Proof.
  set (n := Z.of_nat (length terms)).
  assert (n_size : (n <= 2 ^ Z.log2_up n)%Z) by (apply Z.log2_up_spec; unfold n; lia).
  apply IZR_le in n_size. change 2%Z with (radix_val radix2) in n_size.
  rewrite IZR_Zpower in n_size by apply Z.log2_up_nonneg.
  pose proof q_is_positive as positive.
  apply Rle_trans with (two_to (Z.log2_up n) * q); [apply Rmult_le_compat_r; lra|].
  unfold q, guard_digits, arithmetic.u. fold n.
  change (two_to (- P) / 32) with (two_to (- P) * two_to (-5)).
  rewrite <- !bpow_plus. right. f_equal. ring.
Qed.

(** "Either way |S - s| < n q <= (u/32) max(T, 2^m)", also where underflow is flushed; "a cut makes
    no term larger, so |S| <= T". *)
Theorem cut_sum_error : Rabs (S - s) <= u / 32 * Rmax T (two_to m) /\ Rabs S <= T.
Proof.
  destruct (cuts_lose_at_most_n_q terms) as [near smaller]. split; [|exact smaller].
  assert (u_positive : 0 < u) by apply bpow_gt_0.
  destruct (largest_exponent (match below_normal a with gradual => Some m | flush => None end)
              terms) as [e|] eqn:is_largest.
  - apply Rle_trans with (1 := near). apply Rle_trans with (1 := n_q_is_small).
    apply Rmult_le_compat_l; [lra|]. unfold E. rewrite is_largest.
    destruct (largest_exponent_is_reached _ _ _ is_largest) as [reached | is_least].
    + apply Rle_trans with (1 := reached). apply Rmax_l.
    + destruct (below_normal a); [discriminate|]. injection is_least as <-. apply Rmax_r.
  - assert (none : largest_exponent None terms = None).
    { destruct (below_normal a); auto. clear - is_largest. exfalso.
      induction terms as [|t others IH]; simpl in is_largest; [discriminate|].
      destruct (Req_bool (value t) 0); [now apply IH|].
      destruct (largest_exponent (Some m) others); discriminate. }
    assert (zeros : forall l, (forall t, In t l -> value t = 0) ->
              sum (map (fun t => cut (value t)) l) = 0 /\ sum (map value l) = 0).
    { induction l as [|t others IH]; intros all_zero; [simpl; lra|].
      destruct IH as [cut_zero exact_zero]; [intros; apply all_zero; now right|].
      cbn [map sum fold_right]. fold (sum (map (fun t => cut (value t)) others)).
      fold (sum (map value others)). rewrite cut_zero, exact_zero, (all_zero t) by now left.
      unfold cut, Rdiv. rewrite Rmult_0_l, Ztrunc_IZR. lra. }
    destruct (zeros terms (no_exponent_means_zero terms none)) as [cut_zero exact_zero].
    unfold cut_sum, exact_sum. rewrite cut_zero, exact_zero, Rminus_diag_eq, Rabs_R0 by reflexivity.
    apply Rmult_le_pos; [lra|]. apply Rle_trans with (2 := Rmax_r _ _). apply bpow_ge_0.
Qed.

(** Theorem 12. (Where y overflows, the lane's result is infinite and [fl] does not speak of it.) *)
Theorem fused_sum_error :
  mode a = nearest -> below_normal a = gradual ->
  Rabs (fl S - s) <= Rmax (u * Rabs S) (eta / 2) + u / 32 * Rmax T (two_to m) /\ Rabs S <= T.
Proof.
  intros is_nearest is_gradual. destruct cut_sum_error as [near smaller]. split; auto.
  replace (fl S - s) with ((fl S - S) + (S - s)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  pose proof (last_rounding S is_nearest is_gradual). lra.
Qed.

(** The table: T >= 2^m. *)
Theorem fused_bound_in_normal_range :
  mode a = nearest -> below_normal a = gradual -> two_to m <= T ->
  Rabs (fl S - s) <= 33 / 32 * u * T.
Proof.
  intros is_nearest is_gradual normal.
  destruct (fused_sum_error is_nearest is_gradual) as [error smaller].
  assert (u_positive : 0 < u) by apply bpow_gt_0.
  rewrite half_eta, (Rmax_left T) in error by exact normal.
  assert (Rmax (u * Rabs S) (u * two_to m) <= u * T) by (apply Rmax_lub; nra). lra.
Qed.

(** "While (1 + u)^d - 1 > 2 u." *)
Theorem composed_bound_in_normal_range d :
  (2 <= d)%nat -> 0 <= T -> 2 * u * T <= ((1 + u) ^ d - 1) * T.
Proof.
  intros roundings positive. apply Rmult_le_compat_r; auto.
  assert (u_positive : 0 < u) by apply bpow_gt_0.
  apply Rle_trans with ((1 + u) ^ 2 - 1); [nra|].
  apply Rplus_le_compat_r, Rle_pow; [lra|lia].
Qed.

(** [gradual], T < 2^m: (33/64) η. *)
Theorem fused_bound_below_normal_range :
  mode a = nearest -> below_normal a = gradual -> T < two_to m ->
  Rabs (fl S - s) <= 33 / 64 * eta.
Proof.
  intros is_nearest is_gradual low.
  destruct (fused_sum_error is_nearest is_gradual) as [error smaller].
  assert (u_positive : 0 < u) by apply bpow_gt_0. pose proof half_eta as half.
  rewrite (Rmax_right T) in error by lra.
  assert (Rmax (u * Rabs S) (eta / 2) <= eta / 2) by (apply Rmax_lub; nra). lra.
Qed.

(** It is below the composed bound k η/2 for two products or more, and exceeds it for one product
    by no more than η/64. *)
Theorem composed_bounds_below_normal_range k :
  ((2 <= k)%Z -> 33 / 64 * eta < IZR k * (eta / 2)) /\ 33 / 64 * eta = 1 * (eta / 2) + eta / 64.
Proof.
  pose proof (smallest_positive a). split; [|field].
  intros products. apply (IZR_le 2) in products. nra.
Qed.

(** "Where no term has a digit below q, S = s and y is the number of the format nearest to s." *)
Theorem sum_without_low_digits_is_exact :
  (forall t, In t terms -> exists n : Z, value t = IZR n * q) -> S = s /\ fl S = fl s.
Proof.
  intros on_grid. assert (same : S = s); [|now rewrite same].
  unfold cut_sum, exact_sum. f_equal. apply map_ext_in. intros t inside.
  destruct (on_grid t inside) as [n is_value]. pose proof q_is_positive.
  unfold cut. rewrite is_value. replace (IZR n * q / q) with (IZR n) by (field; lra).
  now rewrite Ztrunc_IZR.
Qed.

(** Comparisons: "the verdict is right wherever |f - g| is larger". s is f - g. *)
Theorem fused_comparison_is_right :
  u / 32 * Rmax T (two_to m) < Rabs s -> (0 < s -> 0 < S) /\ (s < 0 -> S < 0).
Proof.
  intros larger. destruct cut_sum_error as [near _]. apply Rabs_le_inv in near.
  unfold Rabs in larger. destruct Rcase_abs; lra.
Qed.

(** [flush], T < 2^m: the error is at most T. *)
Theorem fused_bound_flushed :
  mode a = nearest -> below_normal a = flush -> T < two_to m -> Rabs (fl S - s) <= T.
Proof.
  intros is_nearest is_flush low. destruct cut_sum_error as [near smaller].
  assert (u_positive : 0 < u) by apply bpow_gt_0.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
  assert (u_small : u <= 1 / 2).
  { unfold arithmetic.u. change (1 / 2) with (1 * two_to (-1)). rewrite Rmult_1_l.
    apply bpow_le. lia. }
  assert (s_size : Rabs s <= T).
  { unfold exact_sum, magnitudes. clear. induction terms as [|t others IH]; simpl.
    - rewrite Rabs_R0. lra.
    - apply Rle_trans with (1 := Rabs_triang _ _). fold (sum (map value others)).
      fold (sum (map (fun t => Rabs (value t)) others)). lra. }
  unfold arithmetic.fl. rewrite is_flush.
  destruct (Rlt_bool_spec (Rabs (rounded a S)) (two_to m)) as [tiny | normal].
  { rewrite Rminus_0_l, Rabs_Ropp. exact s_size. }
  (* rounding reaches 2^m: then S is at least 2^m / (1 + u), and the error a small part of T *)
  assert (error : Rabs (rounded a S - S) <= u * Rabs S).
  { pose proof (relative_error_N_FLX radix2 P digits (fun n => negb (Z.even n)) S) as error.
    rewrite two_u_is_one_ulp in error. unfold rounded, to_integer. rewrite is_nearest. lra. }
  rewrite (Rmax_right T) in near by lra.
  pose proof (Rabs_triang (rounded a S - S) S) as reached.
  replace (rounded a S - S + S) with (rounded a S) in reached by ring.
  replace (rounded a S - s) with ((rounded a S - S) + (S - s)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  pose proof (bpow_gt_0 radix2 m). pose proof (Rabs_pos S).
  assert (u * Rabs S <= 1 / 2 * Rabs S) by (apply Rmult_le_compat_r; lra).
  assert (u / 32 * two_to m <= 1 / 64 * two_to m) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

End FusedSums.

(** "For |g| > 2 T_f neither can fail, since |f - g| > T/3; for the rest (u/32) T <= (3/32) u T_f":
    f is a sum with the magnitudes T_f, g one term, and T = T_f + |g|. *)
Theorem one_term_against_sum f g T_f u :
  0 < u -> Rabs f <= T_f ->
  (Rabs g > 2 * T_f -> Rabs (f - g) > (T_f + Rabs g) / 3) /\
  (Rabs g <= 2 * T_f -> u / 32 * (T_f + Rabs g) <= 3 / 32 * u * T_f).
Proof.
  intros u_positive f_size. split; intros g_size; [|nra].
  pose proof (Rabs_triang_inv g f) as triangle. rewrite Rabs_minus_sym in triangle. lra.
Qed.
