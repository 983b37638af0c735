(** Encodings of the numbers of a format, as docs/error_bounds.md numbers them in theorem 2, and V,
    the number encoded, by linear interpolation between neighbours. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic.

Open Scope R_scope.

Section Encodings.

Variable a : arithmetic.
Notation P := (precision a).
Notation m := (min_exponent a).

(** Encodings in a binade, 2^(P-1), and the smallest subnormal number. *)
Definition binade : Z := 2 ^ (P - 1).
Definition smallest : R := two_to (m - P + 1).

(** The number of the encoding k >= 0: above P - 1 bits of fraction stands the biased exponent. *)
Definition number (k : Z) : R :=
  let biased_exponent := (k / binade)%Z in
  let fraction := (k mod binade)%Z in
  if Z.eq_dec biased_exponent 0 then IZR fraction * smallest
  else (1 + IZR fraction / IZR binade) * two_to (m + biased_exponent - 1).

(** The number of an encoding with a sign: key(x) is such a k. *)
Definition signed_number (key : Z) : R :=
  if Z_lt_dec key 0 then - number (- key) else number key.

(** The same for real k >= 0, linear between neighbours. *)
Definition V (k : R) : R :=
  let below := Zfloor k in
  number below + (k - IZR below) * (number (below + 1) - number below).

Lemma binade_is_power : IZR binade = two_to (P - 1).
Proof.
  unfold binade. pose proof (precision_positive a) as positive. unfold Prec_gt_0 in positive.
  rewrite <- IZR_Zpower by lia. reflexivity.
Qed.

Lemma binade_positive : 0 < IZR binade.
Proof. rewrite binade_is_power. apply bpow_gt_0. Qed.

Lemma binade_positive_Z : (0 < binade)%Z.
Proof. apply lt_IZR, binade_positive. Qed.

Lemma smallest_positive : 0 < smallest.
Proof. apply bpow_gt_0. Qed.

Lemma two_binades_u : 2 * IZR binade * u a = 1.
Proof.
  rewrite binade_is_power. unfold u. change 2 with (two_to 1).
  rewrite <- !bpow_plus. replace (1 + (P - 1) + - P)%Z with 0%Z by ring. reflexivity.
Qed.

Lemma V_of_whole k : V (IZR k) = number k.
Proof. unfold V. rewrite Zfloor_IZR. ring. Qed.

(** Every normal binade, and the subnormal numbers with the first one, lie on a line through a
    multiple of a binade. *)
Definition line (i : Z) (k : R) : R := smallest * two_to i * (k - IZR i * IZR binade).

Lemma number_on_line i k :
  (0 <= i)%Z -> (0 <= k)%Z -> (i * binade <= k <= (i + 2) * binade)%Z ->
  (0 < i -> (i + 1) * binade <= k)%Z ->
  number k = line i (IZR k).
Proof.
  intros positive whole [above below] normal. pose proof binade_positive_Z as size.
  pose proof binade_positive as real_size.
  assert (parts : exists field fraction, (k = field * binade + fraction)%Z /\
                    (0 <= fraction < binade)%Z /\ (0 <= field)%Z /\
                    (k / binade = field)%Z /\ (k mod binade = fraction)%Z).
  { exists (k / binade)%Z, (k mod binade)%Z. pose proof (Z.div_mod k binade).
    pose proof (Z.mod_pos_bound k binade). pose proof (Z.div_pos k binade). lia. }
  destruct parts as (field & fraction & split & inside & field_positive & is_field & is_fraction).
  assert (unit : two_to (m + field - 1) = smallest * two_to (field - 1) * IZR binade).
  { rewrite binade_is_power. unfold smallest. rewrite <- !bpow_plus. f_equal. ring. }
  unfold number, line. rewrite is_field, is_fraction.
  replace (IZR k) with (IZR field * IZR binade + IZR fraction)
    by (rewrite split, plus_IZR, mult_IZR; reflexivity).
  destruct (Z.eq_dec field 0) as [-> | normal_field].
  - assert (i = 0)%Z as -> by nia. change (two_to 0) with 1. ring.
  - rewrite unit.
    assert (cases : (field = i \/ field = i + 1 \/ field = i + 2)%Z) by nia.
    destruct cases as [-> | [-> | ->]].
    + exfalso. assert (0 < i)%Z by lia. nia.
    + replace (i + 1 - 1)%Z with i by ring. rewrite plus_IZR. field. lra.
    + assert (fraction = 0)%Z as -> by nia.
      replace (i + 2 - 1)%Z with (i + 1)%Z by ring. rewrite bpow_plus, plus_IZR.
      change (two_to 1) with 2. field. lra.
Qed.

(** Where V is on the line of a binade: x = k - i 2^(P-1) is the significand, at most 2^P. *)
Lemma V_has_line k :
  0 <= k -> exists i, (0 <= i)%Z /\ V k = line i k /\
    0 <= k - IZR i * IZR binade <= 2 * IZR binade /\
    (0 < IZR i -> IZR binade <= k - IZR i * IZR binade) /\
    (k - IZR i * IZR binade < 2 * IZR binade).
Proof.
  intros positive. pose proof binade_positive_Z as size. pose proof binade_positive as real_size.
  pose proof (Zfloor_lb k) as lower. pose proof (Zfloor_ub k) as upper.
  assert (whole : (0 <= Zfloor k)%Z) by (apply Zfloor_lub; exact positive).
  set (floor := Zfloor k) in *.
  set (i := Z.max 0 (floor / binade - 1)).
  pose proof (Z.div_mod floor binade). pose proof (Z.mod_pos_bound floor binade).
  pose proof (Z.div_pos floor binade).
  assert (at_least_0 : (0 <= i)%Z) by lia.
  assert (inside : (i * binade <= floor /\ floor + 1 <= (i + 2) * binade)%Z) by (unfold i; nia).
  assert (normal : (0 < i -> (i + 1) * binade <= floor)%Z) by (unfold i; nia).
  exists i. split; auto.
  assert (real_inside : IZR i * IZR binade <= IZR floor /\
                        IZR floor + 1 <= (IZR i + 2) * IZR binade).
  { rewrite <- mult_IZR, <- !(plus_IZR _ 1), <- plus_IZR, <- mult_IZR.
    split; apply IZR_le; lia. }
  split; [|repeat split; try lra].
  - unfold V. fold floor.
    rewrite (number_on_line i floor), (number_on_line i (floor + 1)) by lia.
    unfold line. rewrite plus_IZR. ring.
  - intros above_0. apply lt_IZR in above_0.
    assert (IZR ((i + 1) * binade) <= IZR floor) by (apply IZR_le; auto).
    rewrite mult_IZR, plus_IZR in *. lra.
Qed.

(** n + 1 <= 2^n, and n <= 2^n - 1, in real numbers. *)
Lemma power_exceeds n : (0 <= n)%Z -> IZR n + 1 <= two_to n.
Proof.
  intros positive. pattern n. apply natlike_ind; auto.
  - simpl. lra.
  - intros k at_least IH. unfold Z.succ. rewrite bpow_plus, plus_IZR.
    change (two_to 1) with 2. assert (0 <= IZR k) by (apply (IZR_le 0); auto). lra.
Qed.

(** V is convex: no line is above it. *)
Lemma V_above_line i k : (0 <= i)%Z -> 0 <= k -> line i k <= V k.
Proof.
  intros at_least_0 positive.
  destruct (V_has_line k positive) as (e & e_positive & -> & [above below] & normal & _).
  pose proof binade_positive as size. set (B := IZR binade) in *.
  unfold line. fold B. set (x := k - IZR e * B) in *.
  rewrite !Rmult_assoc. apply Rmult_le_compat_l; [apply Rlt_le, smallest_positive|].
  destruct (Z.le_gt_cases i e) as [left | right].
  - replace (two_to e) with (two_to i * two_to (e - i)) by (rewrite <- bpow_plus; f_equal; ring).
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply bpow_ge_0|].
    replace (k - IZR i * B) with (x + IZR (e - i) * B)
      by (unfold x; rewrite minus_IZR; ring).
    destruct (Z.eq_dec e i) as [-> | other].
    { rewrite Z.sub_diag. simpl. lra. }
    pose proof (power_exceeds (e - i)) as grows.
    assert (IZR (e - i) + 1 <= two_to (e - i)) by (apply grows; lia).
    assert (0 <= IZR (e - i)) by (apply (IZR_le 0); lia).
    assert (B <= x) by (apply normal, (IZR_lt 0); lia).
    nra.
  - replace (two_to i) with (two_to e * two_to (i - e)) by (rewrite <- bpow_plus; f_equal; ring).
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply bpow_ge_0|].
    replace (k - IZR i * B) with (x - IZR (i - e) * B)
      by (unfold x; rewrite minus_IZR; ring).
    set (n := (i - e - 1)%Z). replace (i - e)%Z with (n + 1)%Z by (unfold n; ring).
    assert (IZR n + 1 <= two_to n) by (apply power_exceeds; unfold n; lia).
    assert (0 <= IZR n) by (apply (IZR_le 0); unfold n; lia).
    rewrite bpow_plus, plus_IZR. change (two_to 1) with 2.
    (* 2^(n+1) (x - (n + 1) B) <= x, since x <= 2 B and 2^(n+1) - 1 <= (n + 1) 2^n *)
    assert (x * (2 * two_to n - 1) <= 2 * B * (2 * two_to n - 1)) by nra.
    assert (2 * two_to n - 1 <= (IZR n + 1) * two_to n).
    { destruct (Z.eq_dec n 0) as [-> | other]; [simpl; lra|].
      assert (1 <= IZR n) by (apply (IZR_le 1); unfold n in *; lia). nra. }
    nra.
Qed.

Lemma V_positive k : 0 < k -> 0 < V k.
Proof.
  intros positive.
  assert (below : line 0 k <= V k) by (apply V_above_line; [lia|lra]).
  unfold line in below. simpl in below. pose proof smallest_positive. nra.
Qed.

Lemma V_zero : V 0 = 0.
Proof.
  replace 0 with (IZR 0) at 1 by reflexivity. rewrite V_of_whole.
  rewrite (number_on_line 0); pose proof binade_positive_Z; try lia.
  unfold line. simpl. ring.
Qed.

Lemma V_increases k k' : 0 <= k -> k < k' -> V k < V k'.
Proof.
  intros positive less.
  destruct (V_has_line k positive) as (i & at_least_0 & -> & _).
  apply Rlt_le_trans with (line i k'); [|apply V_above_line; auto; lra].
  unfold line. apply Rmult_lt_compat_l; [|lra].
  apply Rmult_lt_0_compat; [apply smallest_positive|apply bpow_gt_0].
Qed.

Lemma V_does_not_fall k k' : 0 <= k -> k <= k' -> V k <= V k'.
Proof.
  intros positive [less | ->]; [|lra]. now apply Rlt_le, V_increases.
Qed.

Lemma V_nonnegative k : 0 <= k -> 0 <= V k.
Proof. intros. rewrite <- V_zero. apply V_does_not_fall; lra. Qed.

Lemma number_positive k : (0 < k)%Z -> 0 < number k.
Proof. intros. rewrite <- V_of_whole. apply V_positive. now apply (IZR_lt 0). Qed.

Lemma number_zero : number 0 = 0.
Proof. rewrite <- V_of_whole. apply V_zero. Qed.

Lemma number_increases k k' : (0 <= k < k')%Z -> number k < number k'.
Proof.
  intros. rewrite <- !V_of_whole. apply V_increases; [apply (IZR_le 0)|apply IZR_lt]; lia.
Qed.

(** Every encoding is a number of the format, but for its largest exponent. *)
Lemma number_is_of_format k : (0 <= k)%Z -> of_format a (number k).
Proof.
  intros whole. assert (positive : 0 <= IZR k) by now apply (IZR_le 0).
  destruct (V_has_line (IZR k) positive) as (i & at_least_0 & on_line & [above _] & _ & below).
  rewrite <- V_of_whole, on_line.
  pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
  apply generic_format_FLT.
  exists (Float radix2 (k - i * binade) (m - P + 1 + i)).
  - unfold line, F2R, smallest. cbn [Fnum Fexp].
    rewrite minus_IZR, mult_IZR, (bpow_plus _ (m - P + 1) i). ring.
  - cbn [Fnum]. change (radix_val radix2) with 2%Z.
    replace P with (P - 1 + 1)%Z by ring. rewrite Z.pow_add_r by lia. fold binade.
    apply lt_IZR. rewrite mult_IZR, abs_IZR, minus_IZR, mult_IZR.
    rewrite Rabs_pos_eq by exact above. change (IZR (2 ^ 1)) with 2. lra.
  - cbn [Fexp]. lia.
Qed.

Lemma signed_number_opposite k : signed_number (- k) = - signed_number k.
Proof.
  unfold signed_number. destruct (Z.eq_dec k 0) as [-> | nonzero].
  - simpl. rewrite number_zero. ring.
  - destruct (Z_lt_dec (- k) 0), (Z_lt_dec k 0); try lia; [|ring].
    now rewrite Z.opp_involutive.
Qed.

Lemma signed_number_of_nonnegative k : (0 <= k)%Z -> signed_number k = number k.
Proof. intros. unfold signed_number. destruct Z_lt_dec; auto. lia. Qed.

Lemma signed_number_positive k : (0 < k)%Z -> 0 < signed_number k.
Proof. intros. rewrite signed_number_of_nonnegative by lia. now apply number_positive. Qed.

Lemma signed_number_zero : signed_number 0 = 0.
Proof. unfold signed_number. simpl. apply number_zero. Qed.

Lemma signed_number_negative k : (k < 0)%Z -> signed_number k < 0.
Proof.
  intros. assert (0 < signed_number (- k)) by (apply signed_number_positive; lia).
  rewrite signed_number_opposite in *. lra.
Qed.

(** The encodings are ordered as the numbers are. *)
Lemma signed_number_increases k k' : (k < k')%Z -> signed_number k < signed_number k'.
Proof.
  intros less. destruct (Z_lt_dec k 0) as [negative | whole].
  - destruct (Z_lt_dec k' 0) as [both | whole'].
    + assert (number (- k') < number (- k)) by (apply number_increases; lia).
      unfold signed_number. destruct Z_lt_dec, Z_lt_dec; try lia. lra.
    + pose proof (signed_number_negative k negative).
      destruct (Z.eq_dec k' 0) as [-> | nonzero]; [rewrite signed_number_zero; lra|].
      assert (0 < signed_number k') by (apply signed_number_positive; lia). lra.
  - rewrite !signed_number_of_nonnegative by lia. apply number_increases. lia.
Qed.

Lemma signed_number_is_of_format k : of_format a (signed_number k).
Proof.
  unfold signed_number. destruct Z_lt_dec.
  - apply generic_format_opp, number_is_of_format. lia.
  - apply number_is_of_format. lia.
Qed.

(** Every number of the format has a key, and only one. *)
Lemma format_has_key x : of_format a x -> exists! key, x = signed_number key.
Proof.
  intros in_format.
  assert (one : forall k k', signed_number k = signed_number k' -> k = k').
  { intros k k' same. destruct (Z.lt_trichotomy k k') as [less | [equal | greater]]; auto.
    - pose proof (signed_number_increases _ _ less). lra.
    - pose proof (signed_number_increases _ _ greater). lra. }
  assert (exists key, x = signed_number key) as [key ->].
  2: { exists key. split; auto. }
  assert (of_magnitude : forall y, of_format a y -> 0 < y -> exists key, y = signed_number key).
  { clear x in_format. intros y in_format positive.
    set (e := cexp radix2 (FLT_exp (m - P + 1) P) y).
    set (mantissa := Ztrunc (scaled_mantissa radix2 (FLT_exp (m - P + 1) P) y)).
    assert (value : y = IZR mantissa * two_to e) by exact in_format.
    assert (least : (m - P + 1 <= e)%Z) by (unfold e, cexp, FLT_exp; lia).
    pose proof (precision_positive a) as digits. unfold Prec_gt_0 in digits.
    pose proof binade_positive_Z as size.
    assert (mantissa_positive : (0 < mantissa)%Z).
    { apply lt_IZR. apply (Rmult_lt_reg_r (two_to e)); [apply bpow_gt_0|]. lra. }
    assert (mantissa_short : (mantissa < 2 * binade)%Z).
    { replace (2 * binade)%Z with (2 ^ P)%Z
        by (unfold binade; rewrite <- (Z.pow_add_r 2 1) by lia; f_equal; ring).
      apply lt_IZR. change 2%Z with (radix_val radix2). rewrite IZR_Zpower by lia.
      apply (Rmult_lt_reg_r (two_to e)); [apply bpow_gt_0|].
      rewrite <- value, <- bpow_plus. destruct (mag radix2 y) as [g bounds] eqn:is_mag.
      assert (magnitude : Rabs y < two_to g) by (apply bounds; lra).
      rewrite Rabs_pos_eq in magnitude by lra.
      apply Rlt_le_trans with (1 := magnitude). apply bpow_le.
      unfold e, cexp, FLT_exp. rewrite is_mag. simpl. lia. }
    assert (mantissa_long : (m - P + 1 < e -> binade <= mantissa)%Z).
    { intros above. apply le_IZR. rewrite binade_is_power.
      apply (Rmult_le_reg_r (two_to e)); [apply bpow_gt_0|].
      rewrite <- value, <- bpow_plus. destruct (mag radix2 y) as [g bounds] eqn:is_mag.
      assert (magnitude : two_to (g - 1) <= Rabs y) by (apply bounds; lra).
      rewrite Rabs_pos_eq in magnitude by lra.
      apply Rle_trans with (2 := magnitude). apply bpow_le.
      unfold e, cexp, FLT_exp in *. rewrite is_mag in *. simpl in *. lia. }
    set (i := (e - (m - P + 1))%Z).
    exists (mantissa + i * binade)%Z.
    rewrite signed_number_of_nonnegative by (unfold i; nia).
    rewrite (number_on_line i) by (unfold i in *; nia).
    unfold line, smallest. rewrite <- bpow_plus, plus_IZR, mult_IZR.
    replace (m - P + 1 + i)%Z with e by (unfold i; ring). rewrite value. ring. }
  destruct (Rtotal_order x 0) as [negative | [-> | positive]].
  - destruct (of_magnitude (- x)) as [key same]; [now apply generic_format_opp|lra|].
    exists (- key)%Z. rewrite signed_number_opposite. lra.
  - exists 0%Z. now rewrite signed_number_zero.
  - now apply of_magnitude.
Qed.

End Encodings.
