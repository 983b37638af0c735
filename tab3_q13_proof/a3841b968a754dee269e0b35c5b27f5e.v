Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x7 : R.
Variable _x10 : R.
Notation _c := ((_x7 - _x10)%R).
Variable _e7 : R.
Notation r6 := ((_x7 - _e7)%R).
Variable _e10 : R.
Notation r8 := ((_x10 - _e10)%R).
Notation _t := ((r6 - r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r10 := ((_e7 - _e10)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (0) (0).
Definition f2 := Float2 (1) (0).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x7 i1). (* BND(x7, [0, 1]) *)
Definition f3 := Float2 (-5227404294136944544532031382538507648772102261578535145255) (-201).
Definition f4 := Float2 (1136953512210355641882864765748683126883741246989721677829) (-200).
Definition i2 := makepairF f3 f4.
Notation p2 := (BND _e7 i2). (* BND(e7, [-0.00162651, 0.000707528]) *)
Definition s4 := (p1 /\ p2).
Definition f5 := Float2 (67092481) (-24).
Definition i3 := makepairF f1 f5.
Notation p3 := (BND _x10 i3). (* BND(x10, [0, 3.99902]) *)
Definition s3 := (s4 /\ p3).
Definition f6 := Float2 (-16383) (-24).
Definition i4 := makepairF f6 f1.
Notation p4 := (BND _e10 i4). (* BND(e10, [-0.000976503, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f7 := Float2 (-67092481) (-24).
Definition i5 := makepairF f7 f2.
Notation p5 := (BND _c i5). (* BND(c, [-3.99902, 1]) *)
Definition s6 := (not p5).
Definition f8 := Float2 (2706133165085721714788164724861402836585353936910593830917) (-200).
Definition i6 := makepairF f3 f8.
Notation p6 := (BND r1 i6). (* BND(c - t, [-0.00162651, 0.00168403]) *)
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
Lemma l5 : s1 -> p1 (* BND(x7, [0, 1]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x10, [0, 3.99902]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (sub _x7 _x10 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-3.99902, 1]) *).
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
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i5)) (Tatom false (Abnd 1%nat i6))) (Tatom false (Abnd 1%nat i6)) (Abnd 0%nat i5) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (r1 = r10). (* EQL(c - t, e7 - e10) *)
Lemma t2 : p7.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* EQL(c - t, e7 - e10) *).
Proof.
 intros h0.
 apply t2.
Qed.
Notation p8 := (BND r10 i6). (* BND(e7 - e10, [-0.00162651, 0.00168403]) *)
Lemma l13 : s1 -> p2 (* BND(e7, [-0.00162651, 0.000707528]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma l14 : s1 -> p4 (* BND(e10, [-0.000976503, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p2 -> p4 -> p8.
Proof.
 intros h0 h1.
 refine (sub _e7 _e10 i2 i4 i6 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(e7 - e10, [-0.00162651, 0.00168403]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l14 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p7 -> p8 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_rewrite r1 r10 i6 h0 h1) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.00162651, 0.00168403]) *).
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
 refine (simplify (Tatom false (Abnd 0%nat i6)) Tfalse (Abnd 0%nat i6) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
