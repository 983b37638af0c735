Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x8 : R.
Variable _x9 : R.
Notation _c := ((_x8 * _x9)%R).
Variable _e8 : R.
Notation r6 := ((_x8 - _e8)%R).
Variable _e9 : R.
Notation r8 := ((_x9 - _e9)%R).
Notation _t := ((r6 * r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r12 := ((_x8 * _e9)%R).
Notation r13 := ((_x9 * _e8)%R).
Notation r11 := ((r12 + r13)%R).
Notation r14 := ((_e8 * _e9)%R).
Notation r10 := ((r11 - r14)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (0) (0).
Definition f2 := Float2 (8191) (-12).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x8 i1). (* BND(x8, [0, 1.99976]) *)
Definition f3 := Float2 (-1) (-12).
Definition i2 := makepairF f3 f1.
Notation p2 := (BND _e8 i2). (* BND(e8, [-0.000244141, 0]) *)
Definition s4 := (p1 /\ p2).
Notation p3 := (BND _x9 i1). (* BND(x9, [0, 1.99976]) *)
Definition s3 := (s4 /\ p3).
Notation p4 := (BND _e9 i2). (* BND(e9, [-0.000244141, 0]) *)
Definition s2 := (s3 /\ p4).
Definition f4 := Float2 (67092481) (-24).
Definition i3 := makepairF f1 f4.
Notation p5 := (BND _c i3). (* BND(c, [0, 3.99902]) *)
Definition s6 := (not p5).
Definition f5 := Float2 (-16383) (-24).
Definition i4 := makepairF f5 f1.
Notation p6 := (BND r1 i4). (* BND(c - t, [-0.000976503, 0]) *)
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
Lemma l5 : s1 -> p1 (* BND(x8, [0, 1.99976]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x9, [0, 1.99976]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (mul_pp _x8 _x9 i1 i1 i3 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [0, 3.99902]) *).
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
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i3)) (Tatom false (Abnd 1%nat i4))) (Tatom false (Abnd 1%nat i4)) (Abnd 0%nat i3) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (BND r10 i4). (* BND(x8 * e9 + x9 * e8 - e8 * e9, [-0.000976503, 0]) *)
Definition f6 := Float2 (-8191) (-23).
Definition i5 := makepairF f6 f1.
Notation p8 := (BND r11 i5). (* BND(x8 * e9 + x9 * e8, [-0.000976443, 0]) *)
Definition f7 := Float2 (-8191) (-24).
Definition i6 := makepairF f7 f1.
Notation p9 := (BND r12 i6). (* BND(x8 * e9, [-0.000488222, 0]) *)
Lemma l14 : s1 -> p4 (* BND(e9, [-0.000244141, 0]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Lemma t2 : p1 -> p4 -> p9.
Proof.
 intros h0 h1.
 refine (mul_pn _x8 _e9 i1 i2 i6 h0 h1 _) ; finalize.
Qed.
Lemma l13 : s1 -> p9 (* BND(x8 * e9, [-0.000488222, 0]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l14 h0).
 apply t2. exact h1. exact h2.
Qed.
Notation p10 := (BND r13 i6). (* BND(x9 * e8, [-0.000488222, 0]) *)
Lemma l16 : s1 -> p2 (* BND(e8, [-0.000244141, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p3 -> p2 -> p10.
Proof.
 intros h0 h1.
 refine (mul_pn _x9 _e8 i1 i2 i6 h0 h1 _) ; finalize.
Qed.
Lemma l15 : s1 -> p10 (* BND(x9 * e8, [-0.000488222, 0]) *).
Proof.
 intros h0.
 assert (h1 := l9 h0).
 assert (h2 := l16 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p9 -> p10 -> p8.
Proof.
 intros h0 h1.
 refine (add r12 r13 i6 i6 i5 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(x8 * e9 + x9 * e8, [-0.000976443, 0]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l15 h0).
 apply t4. exact h1. exact h2.
Qed.
Definition f8 := Float2 (1) (-24).
Definition i7 := makepairF f1 f8.
Notation p11 := (BND r14 i7). (* BND(e8 * e9, [0, 5.96046e-08]) *)
Lemma t5 : p2 -> p4 -> p11.
Proof.
 intros h0 h1.
 refine (mul_nn _e8 _e9 i2 i2 i7 h0 h1 _) ; finalize.
Qed.
Lemma l17 : s1 -> p11 (* BND(e8 * e9, [0, 5.96046e-08]) *).
Proof.
 intros h0.
 assert (h1 := l16 h0).
 assert (h2 := l14 h0).
 apply t5. exact h1. exact h2.
Qed.
Lemma t6 : p8 -> p11 -> p7.
Proof.
 intros h0 h1.
 refine (sub r11 r14 i5 i7 i4 h0 h1 _) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* BND(x8 * e9 + x9 * e8 - e8 * e9, [-0.000976503, 0]) *).
Proof.
 intros h0.
 assert (h1 := l12 h0).
 assert (h2 := l17 h0).
 apply t6. exact h1. exact h2.
Qed.
Definition i8 := makepairF f1 f1.
Notation p12 := (REL r1 r10 i8). (* REL(c - t, x8 * e9 + x9 * e8 - e8 * e9, [0, 0]) *)
Notation p13 := (r1 = r10). (* EQL(c - t, x8 * e9 + x9 * e8 - e8 * e9) *)
Lemma t7 : p13.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l19 : s1 -> p13 (* EQL(c - t, x8 * e9 + x9 * e8 - e8 * e9) *).
Proof.
 intros h0.
 apply t7.
Qed.
Notation p14 := (REL r10 r10 i8). (* REL(x8 * e9 + x9 * e8 - e8 * e9, x8 * e9 + x9 * e8 - e8 * e9, [0, 0]) *)
Lemma t8 : p14.
Proof.
 refine (rel_refl r10 i8 _) ; finalize.
Qed.
Lemma l20 : s1 -> p14 (* REL(x8 * e9 + x9 * e8 - e8 * e9, x8 * e9 + x9 * e8 - e8 * e9, [0, 0]) *).
Proof.
 intros h0.
 apply t8.
Qed.
Lemma t9 : p13 -> p14 -> p12.
Proof.
 intros h0 h1.
 refine (rel_rewrite_1 r1 r10 r10 i8 h0 h1) ; finalize.
Qed.
Lemma l18 : s1 -> p12 (* REL(c - t, x8 * e9 + x9 * e8 - e8 * e9, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l19 h0).
 assert (h2 := l20 h0).
 apply t9. exact h1. exact h2.
Qed.
Lemma t10 : p7 -> p12 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_of_bnd_rel_n r1 r10 i4 i8 i4 h0 h1 _) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.000976503, 0]) *).
Proof.
 intros h0.
 assert (h1 := l11 h0).
 assert (h2 := l18 h0).
 apply t10. exact h1. exact h2.
Qed.
Lemma l1 : s1 -> False.
Proof.
 intros h0.
 assert (h1 := l2 h0).
 assert (h2 := l10 h0).
 refine (simplify (Tatom false (Abnd 0%nat i4)) Tfalse (Abnd 0%nat i4) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
