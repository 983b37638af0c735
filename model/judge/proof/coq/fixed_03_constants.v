(** docs/fixed_point.md, theorem 3: constants decide, from an enclosure of the difference's
    error. *)
From Coq Require Import ZArith Reals Lia Lra Psatz.
From Flocq Require Import Core.

Open Scope R_scope.

Section Constants.

(** D' = n u is the difference as computed, e its error. *)
Variables f g u l h : R.
Variable n : Z.
Hypothesis unit_positive : 0 < u.
Notation e := (IZR n * u - (f - g)).
Hypothesis enclosure : l <= e <= h.

(** "f > g if n >= floor(h / u) + 1." *)
Theorem constant_decides_greater : (n >= Zfloor (h / u) + 1)%Z -> f > g.
Proof.
  intros reached. pose proof (Zfloor_ub (h / u)) as upper.
  assert (beyond : h / u < IZR n).
  { apply Rlt_le_trans with (1 := upper). rewrite <- plus_IZR. apply IZR_le. lia. }
  apply (Rmult_lt_compat_r u) in beyond; auto.
  unfold Rdiv in beyond. rewrite Rmult_assoc, Rinv_l in beyond by lra. lra.
Qed.

(** "f < g if n <= ceil(l / u) - 1." *)
Theorem constant_decides_less : (n <= Zceil (l / u) - 1)%Z -> f < g.
Proof.
  intros reached. pose proof (Zceil_lb (l / u)) as lower.
  assert (beyond : IZR n < l / u).
  { assert (IZR n <= IZR (Zceil (l / u)) - 1) by (rewrite <- minus_IZR; apply IZR_le; lia). lra. }
  apply (Rmult_lt_compat_r u) in beyond; auto.
  unfold Rdiv in beyond. rewrite Rmult_assoc, Rinv_l in beyond by lra. lra.
Qed.

(** "If l = h = 0, nothing was rounded, and every comparison is decided, equality included." *)
Theorem exact_difference_decides_everything :
  l = 0 -> h = 0 -> ((n > 0)%Z <-> f > g) /\ (n = 0%Z <-> f = g) /\ ((n < 0)%Z <-> f < g).
Proof.
  intros -> ->. assert (is_difference : f - g = IZR n * u) by lra.
  destruct (Z.lt_trichotomy n 0) as [negative | [zero | positive]].
  - pose proof (IZR_lt _ _ negative). assert (f - g < 0) by nra.
    repeat split; intros; solve [lia | lra].
  - subst n. assert (f - g = 0) by lra. repeat split; intros; solve [lia | lra].
  - pose proof (IZR_lt _ _ positive). assert (0 < f - g) by nra.
    repeat split; intros; solve [lia | lra].
Qed.

End Constants.
