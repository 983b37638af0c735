(** docs/error_bounds.md, theorem 9: a bound computed in few digits, each operation rounded up, is
    at least the bound of the rules; so is a constant from the ranges. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.
From mixcmp Require Import arithmetic bounds float_07_absolute_parts.

Open Scope R_scope.

Section FewDigits.

(** w digits; the exponents are the lane's, from m to M. *)
Variables w m M : Z.
Hypothesis one_digit_or_more : (0 < w)%Z.

Instance digits_positive : Prec_gt_0 w := one_digit_or_more.

(** A bound is a number, or infinite. *)
Definition bound_value : Type := option R.
Definition infinite : bound_value := None.

(** "A bound is zero, or s 2^e with 2^(w-1) <= s 2^(w-1) < 2^w whole, or infinite." *)
Definition is_bound (value : bound_value) : Prop :=
  match value with
  | None => True
  | Some x => x = 0 \/
      exists s e : Z, x = IZR s * two_to (e - (w - 1)) /\
        (2 ^ (w - 1) <= s < 2 ^ w)%Z /\ (m <= e <= M)%Z
  end.

(** Rounded up: a result below the smallest number becomes that number, one above the largest
    becomes infinite. *)
Definition rounded_up (x : R) : bound_value :=
  let y := round radix2 (FLX_exp w) Zceil x in
  if Req_bool x 0 then Some 0
  else if Rlt_bool y (two_to m) then Some (two_to m)
  else if Rle_bool (two_to (M + 1)) y then infinite
  else Some y.

(** The operations of model/lane/error/bound_graph.hpp. A value of the lane has an index; it is a
    number, or none: a NaN or an infinity. *)
Inductive bound_graph :=
| constant (q : R)
| magnitude (index : nat)
| binade (index : nat)
| reciprocal (index : nat)
| add (first second : bound_graph)
| multiply (first second : bound_graph)
| maximum (first second : bound_graph).

Definition values : Type := nat -> option R.

Definition of_two (operate : R -> R -> bound_value) (x y : bound_value) : bound_value :=
  match x, y with Some x, Some y => operate x y | _, _ => infinite end.

Definition of_value (operate : R -> bound_value) (x : option R) : bound_value :=
  match x with Some x => operate x | None => infinite end.

(** The bound as the hardware computes it. The reciprocal is that of the power of two at or below a
    magnitude, infinite for 0 and subnormal values. *)
Fixpoint computed (lane : values) (graph : bound_graph) : bound_value :=
  match graph with
  | constant q => rounded_up q
  | magnitude i => of_value (fun x => rounded_up (Rabs x)) (lane i)
  | binade i => of_value (fun x => rounded_up (power_at_or_below x)) (lane i)
  | reciprocal i =>
      of_value (fun x => if Rlt_bool (Rabs x) (two_to m) then infinite
                         else rounded_up (/ power_at_or_below x)) (lane i)
  | add x y => of_two (fun x y => rounded_up (x + y)) (computed lane x) (computed lane y)
  | multiply x y => of_two (fun x y => rounded_up (x * y)) (computed lane x) (computed lane y)
  | maximum x y => of_two (fun x y => Some (Rmax x y)) (computed lane x) (computed lane y)
  end.

(** The bound of the rules, exactly; 1 / 0 is infinite. *)
Fixpoint exact (lane : values) (graph : bound_graph) : bound_value :=
  match graph with
  | constant q => Some q
  | magnitude i => of_value (fun x => Some (Rabs x)) (lane i)
  | binade i => of_value (fun x => Some (power_at_or_below x)) (lane i)
  | reciprocal i => of_value (fun x => if Req_bool x 0 then infinite else Some (/ Rabs x)) (lane i)
  | add x y => of_two (fun x y => Some (x + y)) (exact lane x) (exact lane y)
  | multiply x y => of_two (fun x y => Some (x * y)) (exact lane x) (exact lane y)
  | maximum x y => of_two (fun x y => Some (Rmax x y)) (exact lane x) (exact lane y)
  end.

(** Constants are not negative. *)
Fixpoint constants_are_nonnegative (graph : bound_graph) : Prop :=
  match graph with
  | constant q => 0 <= q
  | magnitude _ | binade _ | reciprocal _ => True
  | add x y | multiply x y | maximum x y =>
      constants_are_nonnegative x /\ constants_are_nonnegative y
  end.

(** [value] is at least [bound]; an infinite value is at least anything. *)
Definition at_least (value bound : bound_value) : Prop :=
  match value with
  | None => True
  | Some v => match bound with Some b => 0 <= b <= v | None => False end
  end.

(** Every operation gives at least the exact result on its operands. *)
Lemma rounded_up_is_at_least x y : 0 <= x <= y -> at_least (rounded_up y) (Some x).
Proof.
  intros [positive below]. unfold rounded_up.
  assert (above : y <= round radix2 (FLX_exp w) Zceil y)
    by (apply round_UP_pt; auto with typeclass_instances).
  destruct (Req_bool_spec y 0); [simpl; lra|].
  destruct (Rlt_bool_spec (round radix2 (FLX_exp w) Zceil y) (two_to m)); [simpl; lra|].
  destruct Rle_bool; simpl; auto. lra.
Qed.

Lemma power_is_at_or_below x : 0 <= power_at_or_below x <= Rabs x.
Proof.
  unfold power_at_or_below. destruct (Req_bool_spec x 0) as [-> | nonzero].
  - rewrite Rabs_R0. lra.
  - split; [apply bpow_ge_0|now apply bpow_mag_le].
Qed.

Lemma power_is_positive x : x <> 0 -> 0 < power_at_or_below x.
Proof.
  intros nonzero. unfold power_at_or_below. rewrite Req_bool_false by auto. apply bpow_gt_0.
Qed.

(** Theorem 9: "by induction the computed bound is at least the bound of the rules". *)
Theorem computed_bound_is_at_least_exact lane graph :
  constants_are_nonnegative graph -> at_least (computed lane graph) (exact lane graph).
Proof.
  induction graph as [q | i | i | i | x IHx y IHy | x IHx y IHy | x IHx y IHy]; intros signs;
    cbn [computed exact constants_are_nonnegative] in *.
  - apply rounded_up_is_at_least. lra.
  - destruct (lane i) as [x|]; [|exact I]. cbn [of_value].
    apply rounded_up_is_at_least. split; [apply Rabs_pos|lra].
  - destruct (lane i) as [x|]; [|exact I]. cbn [of_value]. apply rounded_up_is_at_least.
    pose proof (power_is_at_or_below x). lra.
  - destruct (lane i) as [x|]; [|exact I]. cbn [of_value].
    destruct (Rlt_bool_spec (Rabs x) (two_to m)) as [small | normal]; [exact I|].
    assert (nonzero : x <> 0).
    { intros ->. rewrite Rabs_R0 in normal. pose proof (bpow_gt_0 radix2 m). lra. }
    rewrite Req_bool_false by auto. apply rounded_up_is_at_least.
    pose proof (power_is_at_or_below x). pose proof (power_is_positive x nonzero).
    split; [apply Rlt_le, Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra].
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (computed lane x), (computed lane y); try exact I. cbn [of_two].
    simpl in IHx, IHy. destruct (exact lane x), (exact lane y); try contradiction.
    apply rounded_up_is_at_least. lra.
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (computed lane x), (computed lane y); try exact I. cbn [of_two].
    simpl in IHx, IHy. destruct (exact lane x), (exact lane y); try contradiction.
    apply rounded_up_is_at_least. split; [apply Rmult_le_pos|apply Rmult_le_compat]; lra.
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (computed lane x) as [v|], (computed lane y) as [v'|]; try exact I.
    simpl in IHx, IHy. destruct (exact lane x) as [b|], (exact lane y) as [b'|]; try contradiction.
    simpl. split.
    + apply Rle_trans with (2 := Rmax_l b b'). lra.
    + apply Rmax_lub; [apply Rle_trans with (2 := Rmax_l v v')|
                       apply Rle_trans with (2 := Rmax_r v v')]; lra.
Qed.

(** What is rounded up is a bound of w digits. *)
Theorem rounded_up_is_bound x : 0 <= x -> (m <= M)%Z -> is_bound (rounded_up x).
Proof.
  intros positive exponents. unfold rounded_up.
  destruct (Req_bool_spec x 0) as [zero | nonzero]; [now left|].
  assert (whole : forall s, (0 <= s)%Z -> IZR (2 ^ s) = two_to s)
    by (intros; change 2%Z with (radix_val radix2); now rewrite IZR_Zpower).
  set (y := round radix2 (FLX_exp w) Zceil x).
  destruct (Rlt_bool_spec y (two_to m)) as [low | normal].
  { right. exists (2 ^ (w - 1))%Z, m. rewrite whole by lia. rewrite <- bpow_plus.
    split; [f_equal; ring|]. split; [split; [lia|]|lia]. apply Z.pow_lt_mono_r; lia. }
  destruct (Rle_bool_spec (two_to (M + 1)) y) as [over | inside]; [exact I|].
  right. pose proof (bpow_gt_0 radix2 m) as smallest_positive.
  assert (digits : generic_format radix2 (FLX_exp w) y)
    by (apply generic_format_round; auto with typeclass_instances).
  set (e := (mag radix2 y - 1)%Z).
  assert (size : two_to e <= y < two_to (e + 1)).
  { pose proof (bpow_mag_le radix2 y) as lower. pose proof (bpow_mag_gt radix2 y) as upper.
    rewrite Rabs_pos_eq in lower, upper by lra. unfold e. rewrite Z.sub_add.
    split; [apply lower|]; lra. }
  set (s := Ztrunc (scaled_mantissa radix2 (FLX_exp w) y)).
  assert (is_y : y = IZR s * two_to (e - (w - 1))).
  { unfold generic_format, F2R in digits. cbn [Fnum Fexp] in digits. fold s in digits.
    rewrite digits at 1. f_equal. f_equal. unfold cexp, FLX_exp, e. ring. }
  exists s, e. split; auto. split.
  - split; [apply le_IZR|apply lt_IZR]; rewrite whole by lia;
      [apply (Rmult_le_reg_r (two_to (e - (w - 1))))|apply (Rmult_lt_reg_r (two_to (e - (w - 1))))];
      try apply bpow_gt_0; rewrite <- is_y, <- bpow_plus.
    + replace (w - 1 + (e - (w - 1)))%Z with e by ring. lra.
    + replace (w + (e - (w - 1)))%Z with (e + 1)%Z by ring. lra.
  - assert (m < e + 1)%Z by (apply (lt_bpow radix2); lra).
    assert (e < M + 1)%Z by (apply (lt_bpow radix2); lra). lia.
Qed.

(** A constant bound: the largest value of each magnitude, and the smallest for reciprocals. *)
Fixpoint folded (least greatest : nat -> R) (graph : bound_graph) : bound_value :=
  match graph with
  | constant q => Some q
  | magnitude i => Some (greatest i)
  | binade i => Some (power_at_or_below (greatest i))
  | reciprocal i => if Req_bool (least i) 0 then infinite else Some (/ least i)
  | add x y => of_two (fun x y => Some (x + y)) (folded least greatest x) (folded least greatest y)
  | multiply x y =>
      of_two (fun x y => Some (x * y)) (folded least greatest x) (folded least greatest y)
  | maximum x y =>
      of_two (fun x y => Some (Rmax x y)) (folded least greatest x) (folded least greatest y)
  end.

Lemma power_at_or_below_keeps_order x y :
  Rabs x <= Rabs y -> power_at_or_below x <= power_at_or_below y.
Proof.
  intros order. unfold power_at_or_below.
  destruct (Req_bool_spec x 0) as [-> | nonzero], (Req_bool_spec y 0) as [-> | nonzero'].
  - lra.
  - apply bpow_ge_0.
  - rewrite Rabs_R0 in order. pose proof (Rabs_pos_lt x nonzero). lra.
  - apply bpow_le. pose proof (mag_le_abs radix2 x y nonzero order). lia.
Qed.

Theorem folded_bound_is_at_least_exact lane least greatest graph :
  constants_are_nonnegative graph ->
  (forall i, exists x, lane i = Some x /\ 0 <= least i <= Rabs x /\ Rabs x <= greatest i) ->
  at_least (folded least greatest graph) (exact lane graph).
Proof.
  intros signs ranges.
  induction graph as [q | i | i | i | x IHx y IHy | x IHx y IHy | x IHx y IHy];
    cbn [folded exact constants_are_nonnegative] in *.
  - simpl. lra.
  - destruct (ranges i) as (x & -> & lower & upper). simpl. pose proof (Rabs_pos x). lra.
  - destruct (ranges i) as (x & -> & lower & upper). simpl. split; [apply power_is_at_or_below|].
    apply power_at_or_below_keeps_order. pose proof (Rabs_pos x).
    rewrite (Rabs_pos_eq (greatest i)); lra.
  - destruct (ranges i) as (x & -> & lower & upper). simpl.
    destruct (Req_bool_spec (least i) 0) as [zero | nonzero]; [exact I|].
    assert (x <> 0) by (intros ->; rewrite Rabs_R0 in lower; lra).
    rewrite Req_bool_false by auto. simpl.
    split; [apply Rlt_le, Rinv_0_lt_compat; lra|apply Rinv_le_contravar; lra].
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (folded least greatest x), (folded least greatest y); try exact I.
    simpl in IHx, IHy. destruct (exact lane x), (exact lane y); try contradiction. simpl. lra.
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (folded least greatest x), (folded least greatest y); try exact I.
    simpl in IHx, IHy. destruct (exact lane x), (exact lane y); try contradiction. simpl.
    split; [apply Rmult_le_pos|apply Rmult_le_compat]; lra.
  - destruct signs as [x_signs y_signs]. specialize (IHx x_signs). specialize (IHy y_signs).
    destruct (folded least greatest x) as [v|], (folded least greatest y) as [v'|]; try exact I.
    simpl in IHx, IHy. destruct (exact lane x) as [b|], (exact lane y) as [b'|]; try contradiction.
    simpl. split.
    + apply Rle_trans with (2 := Rmax_l b b'). lra.
    + apply Rmax_lub; [apply Rle_trans with (2 := Rmax_l v v')|
                       apply Rle_trans with (2 := Rmax_r v v')]; lra.
Qed.

(** "In exact rationals, rounded up once." *)
Theorem constant_bound_is_at_least_exact lane least greatest graph q :
  constants_are_nonnegative graph ->
  (forall i, exists x, lane i = Some x /\ 0 <= least i <= Rabs x /\ Rabs x <= greatest i) ->
  folded least greatest graph = Some q ->
  at_least (rounded_up q) (exact lane graph).
Proof.
  intros signs ranges is_folded.
  pose proof (folded_bound_is_at_least_exact lane least greatest graph signs ranges) as covers.
  rewrite is_folded in covers. simpl in covers.
  destruct (exact lane graph); [|contradiction]. now apply rounded_up_is_at_least.
Qed.

End FewDigits.
