Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x4 : R.
Variable _x6 : R.
Notation _c := ((_x4 - _x6)%R).
Variable _e4 : R.
Notation r6 := ((_x4 - _e4)%R).
Variable _e6 : R.
Notation r8 := ((_x6 - _e6)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e4 - _e6)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (0) (0).
Definition f2 := Float2 (1) (9).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x4 i1). (* BND(x4, [0, 512]) *)
Definition i2 := makepairF f1 f1.
Notation p2 := (BND _e4 i2). (* BND(e4, [0, 0]) *)
Definition s4 := (p1 /\ p2).
Notation p3 := (BND _x6 i1). (* BND(x6, [0, 512]) *)
Definition s3 := (s4 /\ p3).
Notation p4 := (BND _e6 i2). (* BND(e6, [0, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f3 := Float2 (-1) (9).
Definition i3 := makepairF f3 f2.
Notation p5 := (BND _c i3). (* BND(c, [-512, 512]) *)
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
Lemma l5 : s1 -> p1 (* BND(x4, [0, 512]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x6, [0, 512]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x4 _x6 i1 i1 i3 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-512, 512]) *).
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
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i3)) (Tatom false (Abnd 1%nat i2))) (Tatom false (Abnd 1%nat i2)) (Abnd 0%nat i3) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (r1 = r10). (* EQL(c - t, e4 - e6) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e4 - e6) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i2). (* BND(e4 - e6, [-0, 0]) *)
Lemma l13 : s1 -> p2 (* BND(e4, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e6, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e4 _e6 i2 i2 i2 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e4 - e6, [-0, 0]) *).
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
