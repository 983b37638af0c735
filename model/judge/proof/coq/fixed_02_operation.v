(** docs/fixed_point.md, theorem 2: the error of an operation's exact result on computed
    operands. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

Section Operation.

(** Computed x' and y', real x = x' - e and y = y' - d. *)
Variables x' y' e d : R.
Notation x := (x' - e).
Notation y := (y' - d).

Theorem error_of_sum : (x' + y') - (x + y) = e + d.
Proof. ring. Qed.

Theorem error_of_difference : (x' - y') - (x - y) = e - d.
Proof. ring. Qed.

Theorem error_of_product : x' * y' - x * y = x' * d + y' * e - e * d.
Proof. ring. Qed.

Theorem error_of_square : x' ^ 2 - x ^ 2 = e * (2 * x' - e).
Proof. ring. Qed.

Theorem error_of_negation : - x' - - x = - e.
Proof. ring. Qed.

(** e or -e where x and x' have one sign; at most abs(e) in magnitude otherwise. *)
Theorem error_of_absolute :
  (0 <= x -> 0 <= x' -> Rabs x' - Rabs x = e) /\
  (x <= 0 -> x' <= 0 -> Rabs x' - Rabs x = - e) /\
  Rabs (Rabs x' - Rabs x) <= Rabs e.
Proof.
  split; [|split].
  - intros. rewrite !Rabs_pos_eq by lra. ring.
  - intros. rewrite !Rabs_left1 by lra. ring.
  - replace e with (x' - x) at 2 by ring. apply Rabs_triang_inv2.
Qed.

(** Within the hull of e's and d's enclosures. *)
Theorem error_of_minimum l h :
  l <= e <= h -> l <= d <= h -> l <= Rmin x' y' - Rmin x y <= h.
Proof. intros. unfold Rmin. repeat destruct Rle_dec; lra. Qed.

Theorem error_of_maximum l h :
  l <= e <= h -> l <= d <= h -> l <= Rmax x' y' - Rmax x y <= h.
Proof. intros. unfold Rmax. repeat destruct Rle_dec; lra. Qed.

(** The hull of two enclosures holds both. *)
Theorem hull_of_enclosures l h l' h' :
  l <= e <= h -> l' <= d <= h' ->
  Rmin l l' <= e <= Rmax h h' /\ Rmin l l' <= d <= Rmax h h'.
Proof.
  intros. pose proof (Rmin_l l l'). pose proof (Rmin_r l l').
  pose proof (Rmax_l h h'). pose proof (Rmax_r h h'). lra.
Qed.

(** Taking x' where it is within limits changes nothing, so its error is e: the comparison is
    undecided elsewhere. *)
Theorem error_of_limit low high : low <= x' <= high -> Rmax low (Rmin x' high) - x = e.
Proof. intros. rewrite Rmin_left, Rmax_right by lra. ring. Qed.

End Operation.

(** Dropping low bits, from unit u to unit v = 2^bits u, of x' = n u: "dropped bits are worth 0 to
    v - u, in steps of u". *)
Theorem error_of_dropping_bits n u bits e :
  0 < u -> (0 <= bits)%Z ->
  let v := IZR (2 ^ bits) * u in
  exists t, 0 <= t <= v - u /\ (exists steps : Z, t = IZR steps * u) /\
    IZR (n / 2 ^ bits) * v - (IZR n * u - e) = e - t.
Proof.
  intros positive whole v.
  assert (size : (0 < 2 ^ bits)%Z) by (apply Z.pow_pos_nonneg; lia).
  pose proof (Z.div_mod n (2 ^ bits)) as parts.
  pose proof (Z.mod_pos_bound n (2 ^ bits) size) as rest.
  exists (IZR (n mod 2 ^ bits) * u).
  assert (0 <= IZR (n mod 2 ^ bits)) by (apply (IZR_le 0); lia).
  assert (IZR (n mod 2 ^ bits) <= IZR (2 ^ bits) - 1) by (rewrite <- minus_IZR; apply IZR_le; lia).
  unfold v. split; [split; nra|]. split; [now exists (n mod 2 ^ bits)%Z|].
  rewrite parts at 2 by lia. rewrite plus_IZR, mult_IZR. ring.
Qed.

(** "c^2 x^2 is computed as (c x)^2." *)
Theorem scaled_square c x : c ^ 2 * x ^ 2 = (c * x) ^ 2.
Proof. ring. Qed.
