Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x11 : R.
Variable _x3 : R.
Notation _c := ((_x11 - _x3)%R).
Variable _e11 : R.
Notation r6 := ((_x11 - _e11)%R).
Variable _e3 : R.
Notation r8 := ((_x3 - _e3)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e11 - _e3)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (0) (0).
Definition f2 := Float2 (225) (4).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x11 i1). (* BND(x11, [0, 3600]) *)
Definition i2 := makepairF f1 f1.
Notation p2 := (BND _e11 i2). (* BND(e11, [0, 0]) *)
Definition s4 := (p1 /\ p2).
Definition f3 := Float2 (225) (3).
Definition i3 := makepairF f3 f3.
Notation p3 := (BND _x3 i3). (* BND(x3, [1800, 1800]) *)
Definition s3 := (s4 /\ p3).
Notation p4 := (BND _e3 i2). (* BND(e3, [0, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f4 := Float2 (-225) (3).
Definition i4 := makepairF f4 f3.
Notation p5 := (BND _c i4). (* BND(c, [-1800, 1800]) *)
Definition s6 := (not p5).
Notation p6 := (BND r1 i2). (* BND(c - t, [0, 0]) *)
Definition s7 := (not p6).
Definition s5 := (s6 \/ s7).
Definition s1 := (s2 /\ s5).
Lemma l3 : s1 -> s5.
Proof.
 intros h0.
 assert (h1 := h0).
 exact (proj2 h1).
Qed.
Lemma l8 : s1 -> s2.
Proof.
 intros h0.
 assert (h1 := h0).
 exact (proj1 h1).
Qed.
Lemma l7 : s1 -> s3.
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj1 h1).
Qed.
Lemma l6 : s1 -> s4.
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj1 h1).
Qed.
Lemma l5 : s1 -> p1 (* BND(x11, [0, 3600]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x3, [1800, 1800]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x11 _x3 i1 i3 i4 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-1800, 1800]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l9 h0).
 apply t1. exact h1. exact h2.
Qed.
Lemma l2 : s1 -> s7.
Proof.
 intros h0.
 assert (h1 := l3 h0).
 assert (h2 := l4 h0).
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i4)) (Tatom false (Abnd 1%nat i2))) (Tatom false (Abnd 1%nat i2)) (Abnd 0%nat i4) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (r1 = r10). (* EQL(c - t, e11 - e3) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e11 - e3) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i2). (* BND(e11 - e3, [-0, 0]) *)
Lemma l13 : s1 -> p2 (* BND(e11, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e3, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e11 _e3 i2 i2 i2 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e11 - e3, [-0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l14 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p7 -> p8 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_rewrite r1 r10 i2 h0 h1) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l11 h0).
 assert (h2 := l12 h0).
 apply t4. exact h1. exact h2.
Qed.
Lemma l1 : s1 -> False.
Proof.
 intros h0.
 assert (h1 := l2 h0).
 assert (h2 := l10 h0).
 refine (simplify (Tatom false (Abnd 0%nat i2)) Tfalse (Abnd 0%nat i2) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
