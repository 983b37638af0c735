(** docs/fixed_point.md, theorem 5: the error of a square root that is rounded down to a unit. *)
From Coq Require Import ZArith Reals Lia Lra Psatz List.
From Flocq Require Import Core.
From mixcmp Require Import norms.

Open Scope R_scope.

(** "For a given e it is the nearer to 0 the larger x' is." *)
Lemma root_difference_falls p q d :
  0 <= d -> 0 <= p -> p <= q -> sqrt (q + d) - sqrt q <= sqrt (p + d) - sqrt p.
Proof.
  intros d_sign p_sign order.
  pose proof (sqrt_pos p) as root_p. pose proof (sqrt_pos q) as root_q.
  pose proof (sqrt_pos (p + d)) as root_pd. pose proof (sqrt_pos (q + d)) as root_qd.
  pose proof (sqrt_sqrt p p_sign). pose proof (sqrt_sqrt q ltac:(lra)).
  pose proof (sqrt_sqrt (p + d) ltac:(lra)). pose proof (sqrt_sqrt (q + d) ltac:(lra)).
  pose proof (sqrt_le_1 p q p_sign ltac:(lra) order).
  pose proof (sqrt_le_1 (p + d) (q + d) ltac:(lra) ltac:(lra) ltac:(lra)).
  (* (A - a)(A + a) = d = (B - b)(B + b), with A + a >= B + b *)
  apply Rnot_lt_le. intros larger.
  assert (A_positive : 0 < sqrt (q + d) - sqrt q).
  { apply Rle_lt_trans with (2 := larger). pose proof (sqrt_le_1 p (p + d)). lra. }
  assert ((sqrt (p + d) - sqrt p) * (sqrt (p + d) + sqrt p) <=
          (sqrt (p + d) - sqrt p) * (sqrt (q + d) + sqrt q)).
  { apply Rmult_le_compat_l; [|lra]. pose proof (sqrt_le_1 p (p + d)). lra. }
  assert (0 < sqrt (q + d)) by lra.
  assert ((sqrt (p + d) - sqrt p) * (sqrt (q + d) + sqrt q) <
          (sqrt (q + d) - sqrt q) * (sqrt (q + d) + sqrt q)) by (apply Rmult_lt_compat_r; lra).
  nra.
Qed.

(** How far the root may be above and below the real one, from the theorem's two cases. *)
Definition raised (m h : R) : R :=
  if Rlt_dec h 0 then 0
  else if Rle_dec h m then sqrt m - sqrt (m - h) else sqrt h.

Definition lowered (m l : R) : R := if Rle_dec l 0 then sqrt (m - l) - sqrt m else 0.

Section SquareRoot.

Variables x x' m l h v : R.
Notation e := (x' - x).
Hypothesis x_sign : 0 <= x.
Hypothesis m_sign : 0 <= m.
Hypothesis least : m <= x'.
Hypothesis enclosure : l <= e <= h.
Hypothesis unit_positive : 0 < v.

(** y' = v floor(sqrt(x') / v). *)
Notation y' := (v * IZR (Zfloor (sqrt x' / v))).

(** "Rounding down takes less than v." *)
Lemma rounding_down : sqrt x' - v < y' <= sqrt x'.
Proof.
  pose proof (Zfloor_lb (sqrt x' / v)) as lower. pose proof (Zfloor_ub (sqrt x' / v)) as upper.
  apply (Rmult_le_compat_l v) in lower; [|lra]. apply (Rmult_lt_compat_l v) in upper; auto.
  replace (v * (sqrt x' / v)) with (sqrt x') in lower, upper by (field; lra). lra.
Qed.

Lemma root_is_raised_at_most : sqrt x' - sqrt x <= raised m h.
Proof.
  unfold raised. destruct (Rlt_dec h 0) as [negative | h_sign].
  { pose proof (sqrt_le_1 x' x). lra. }
  destruct (Rle_lt_dec e 0) as [short | above].
  { pose proof (sqrt_le_1 x' x ltac:(lra) x_sign ltac:(lra)).
    destruct (Rle_dec h m); [pose proof (sqrt_le_1 (m - h) m)|pose proof (sqrt_pos h)]; lra. }
  destruct (Rle_dec h m) as [large | small].
  - pose proof (root_difference_falls (m - e) x e ltac:(lra) ltac:(lra) ltac:(lra)) as falls.
    replace (x + e) with x' in falls by ring. replace (m - e + e) with m in falls by ring.
    pose proof (sqrt_le_1 (m - h) (m - e) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
  - (* from 0, or from m - e where that is more *)
    pose proof (root_difference_falls 0 x e ltac:(lra) ltac:(lra) x_sign) as falls.
    replace (x + e) with x' in falls by ring. rewrite Rplus_0_l, sqrt_0 in falls.
    pose proof (sqrt_le_1 e h ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma root_is_lowered_at_most : sqrt x - sqrt x' <= lowered m l.
Proof.
  unfold lowered. destruct (Rle_dec l 0) as [below | positive].
  - destruct (Rle_lt_dec 0 e) as [above | short].
    + pose proof (sqrt_le_1 x x' x_sign ltac:(lra) ltac:(lra)).
      pose proof (sqrt_le_1 m (m - l)). lra.
    + pose proof (root_difference_falls m x' (- e) ltac:(lra) m_sign least) as falls.
      replace (x' + - e) with x in falls by ring.
      pose proof (sqrt_le_1 (m + - e) (m - l) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
  - pose proof (sqrt_le_1 x x' x_sign ltac:(lra) ltac:(lra)). lra.
Qed.

(** Theorem 5. *)
Theorem square_root_error : - lowered m l - v <= y' - sqrt x <= raised m h.
Proof.
  pose proof rounding_down. pose proof root_is_raised_at_most.
  pose proof root_is_lowered_at_most. lra.
Qed.

End SquareRoot.

(** "If x = |z|^2 for a vector z, p need not exceed r, nor q exceed r + sqrt(m + t) - sqrt(m)": x'
    is |z'|^2 less low bits that are worth at most t. *)
Theorem root_of_norm_error (z : vector) r t m v dropped :
  norm (errors z) <= r -> 0 <= dropped <= t -> 0 <= m -> 0 < v ->
  let x := norm (real z) ^ 2 in
  let x' := norm (computed z) ^ 2 - dropped in
  m <= x' ->
  let y' := v * IZR (Zfloor (sqrt x' / v)) in
  - (r + sqrt (m + t) - sqrt m) - v <= y' - sqrt x <= r.
Proof.
  intros norm_of_errors dropped_size m_sign unit_positive x x' least y'.
  pose proof (rounding_down x' v unit_positive) as down. fold y' in down.
  pose proof (norms_are_near z) as near. apply Rabs_le_inv in near.
  assert (root_x : sqrt x = norm (real z)).
  { unfold x. rewrite <- Rsqr_pow2. apply sqrt_Rsqr, norm_is_nonnegative. }
  assert (root_z : sqrt (x' + dropped) = norm (computed z)).
  { unfold x'.
    replace (norm (computed z) ^ 2 - dropped + dropped) with (norm (computed z) ^ 2) by ring.
    rewrite <- Rsqr_pow2. apply sqrt_Rsqr, norm_is_nonnegative. }
  pose proof (root_difference_falls m x' dropped ltac:(lra) m_sign least) as falls.
  pose proof (sqrt_le_1 (m + dropped) (m + t) ltac:(lra) ltac:(lra) ltac:(lra)).
  pose proof (sqrt_le_1 x' (x' + dropped) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.
