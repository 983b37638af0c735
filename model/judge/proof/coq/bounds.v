(** Relative bounds, as docs/error_bounds.md ("Words") defines them. *)
From Coq Require Import Reals Lra.
From mixcmp Require Import arithmetic.

Open Scope R_scope.

Record interval := { low : R; high : R }.

Definition within (b : interval) (t : R) : Prop := low b <= t <= high b.

Definition exactly_one : interval := {| low := 1; high := 1 |}.
Definition product (b b' : interval) : interval :=
  {| low := low b * low b'; high := high b * high b' |}.
Definition quotient (b b' : interval) : interval :=
  {| low := low b / high b'; high := high b / low b' |}.
Definition hull (b b' : interval) : interval :=
  {| low := Rmin (low b) (low b'); high := Rmax (high b) (high b') |}.

(** Theorem 1's interval. *)
Definition rounding_bound (a : arithmetic) : interval :=
  match mode a with
  | nearest => {| low := 1 - u a; high := 1 + u a |}
  | toward_zero => {| low := 1; high := 1 + 2 * u a |}
  end.

(** [b] is a relative bound of a node with the computed value c and the true value x. *)
Definition relative_bound (b : interval) (c x : R) : Prop :=
  0 < low b /\ exists t, within b t /\ x = c * t.

Lemma factor_is_positive b t : 0 < low b -> within b t -> 0 < t.
Proof. unfold within; lra. Qed.

Lemma hull_holds_first b b' t : within b t -> within (hull b b') t.
Proof.
  unfold within, hull; simpl; intros.
  pose proof (Rmin_l (low b) (low b')); pose proof (Rmax_l (high b) (high b')); lra.
Qed.

Lemma hull_holds_second b b' t : within b' t -> within (hull b b') t.
Proof.
  unfold within, hull; simpl; intros.
  pose proof (Rmin_r (low b) (low b')); pose proof (Rmax_r (high b) (high b')); lra.
Qed.

Lemma hull_is_positive b b' : 0 < low b -> 0 < low b' -> 0 < low (hull b b').
Proof. intros; simpl; now apply Rmin_glb_lt. Qed.

Lemma product_is_positive b b' : 0 < low b -> 0 < low b' -> 0 < low (product b b').
Proof. intros; simpl; now apply Rmult_lt_0_compat. Qed.

Lemma product_holds b b' t t' :
  0 < low b -> 0 < low b' -> within b t -> within b' t' -> within (product b b') (t * t').
Proof. unfold within, product; simpl; intros; split; apply Rmult_le_compat; lra. Qed.

Lemma quotient_is_positive b b' t' :
  0 < low b -> 0 < low b' -> within b' t' -> 0 < low (quotient b b').
Proof. unfold within; intros; simpl; apply Rdiv_lt_0_compat; lra. Qed.

Lemma quotient_holds b b' t t' :
  0 < low b -> 0 < low b' -> within b t -> within b' t' -> within (quotient b b') (t / t').
Proof.
  unfold within, quotient, Rdiv; simpl; intros.
  split; apply Rmult_le_compat; try lra;
    try (apply Rlt_le, Rinv_0_lt_compat; lra); apply Rinv_le_contravar; lra.
Qed.

(** "In particular": a relative bound keeps the sign, and zeros. *)
Lemma bound_keeps_positive b c x : relative_bound b c x -> 0 < c <-> 0 < x.
Proof.
  intros (positive & t & inside & ->).
  pose proof (factor_is_positive b t positive inside).
  split; intros; [now apply Rmult_lt_0_compat|].
  apply (Rmult_lt_reg_r t); lra.
Qed.

Lemma bound_keeps_zero b c x : relative_bound b c x -> c = 0 <-> x = 0.
Proof.
  intros (positive & t & inside & ->).
  pose proof (factor_is_positive b t positive inside).
  split; intros zero; [rewrite zero; ring|].
  apply Rmult_integral in zero; lra.
Qed.

Lemma bound_of_opposite b c x : relative_bound b c x -> relative_bound b (- c) (- x).
Proof. intros (positive & t & inside & ->); split; auto; exists t; split; auto; ring. Qed.
