Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x0 : R.
Variable _x8 : R.
Notation _c := ((_x0 * _x8)%R).
Variable _e0 : R.
Notation r6 := ((_x0 - _e0)%R).
Variable _e8 : R.
Notation r8 := ((_x8 - _e8)%R).
Notation _t := ((r6 * r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r12 := ((_x0 * _e8)%R).
Notation r13 := ((_x8 * _e0)%R).
Notation r11 := ((r12 + r13)%R).
Notation r14 := ((_e0 * _e8)%R).
Notation r10 := ((r11 - r14)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (-1) (1).
Definition f2 := Float2 (8191) (-12).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x0 i1). (* BND(x0, [-2, 1.99976]) *)
Definition f3 := Float2 (-1) (-12).
Definition f4 := Float2 (0) (0).
Definition i2 := makepairF f3 f4.
Notation p2 := (BND _e0 i2). (* BND(e0, [-0.000244141, 0]) *)
Definition s4 := (p1 /\ p2).
Definition f5 := Float2 (1) (-1).
Definition f6 := Float2 (1025) (-9).
Definition i3 := makepairF f5 f6.
Notation p3 := (BND _x8 i3). (* BND(x8, [0.5, 2.00195]) *)
Definition s3 := (s4 /\ p3).
Definition f7 := Float2 (-2612505372838174624231194626957083123272178968489234694849) (-201).
Definition f8 := Float2 (17683367464164469304418471470572639064505291349639682166197) (-202).
Definition i4 := makepairF f7 f8.
Notation p4 := (BND _e8 i4). (* BND(e8, [-0.000812883, 0.0027511]) *)
Definition s2 := (s3 /\ p4).
Definition f9 := Float2 (-1025) (-8).
Definition f10 := Float2 (8395775) (-21).
Definition i5 := makepairF f9 f10.
Notation p5 := (BND _c i5). (* BND(c, [-4.00391, 4.00342]) *)
Definition s6 := (not p5).
Definition f11 := Float2 (-78867714917361852228453974496880344767841859877668262763156161) (-213).
Definition f12 := Float2 (17683367464164469304418471470572639064505291349639682166197) (-201).
Definition i6 := makepairF f11 f12.
Notation p6 := (BND r1 i6). (* BND(c - t, [-0.00599115, 0.00550219]) *)
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
Lemma l5 : s1 -> p1 (* BND(x0, [-2, 1.99976]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x8, [0.5, 2.00195]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (mul_op _x0 _x8 i1 i3 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [-4.00391, 4.00342]) *).
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
Notation p7 := (BND r10 i6). (* BND(x0 * e8 + x8 * e0 - e0 * e8, [-0.00599115, 0.00550219]) *)
Definition f13 := Float2 (-19254175393552005384235777173401705977714498949877874396597) (-201).
Definition f14 := Float2 (144844462898971168072491699815460486577362841444898636623319627) (-214).
Definition i7 := makepairF f13 f14.
Notation p8 := (BND r11 i7). (* BND(x0 * e8 + x8 * e0, [-0.00599095, 0.00550152]) *)
Definition f15 := Float2 (-17683367464164469304418471470572639064505291349639682166197) (-201).
Definition i8 := makepairF f15 f14.
Notation p9 := (BND r12 i8). (* BND(x0 * e8, [-0.00550219, 0.00550152]) *)
Lemma l14 : s1 -> p4 (* BND(e8, [-0.000812883, 0.0027511]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Definition f16 := Float2 (-1) (-9).
Definition i9 := makepairF f16 f8.
Notation p10 := (BND _e8 i9). (* BND(e8, [-0.00195312, 0.0027511]) *)
Lemma t2 : p1 -> p10 -> p9.
Proof.
 intros h0 h1.
 refine (mul_oo _x0 _e8 i1 i9 i8 h0 h1 _) ; finalize.
Qed.
Lemma l13 : s1 -> p9 (* BND(x0 * e8, [-0.00550219, 0.00550152]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l14 h0).
 apply t2. exact h1. refine (subset _e8 i4 i9 h2 _) ; finalize.
Qed.
Definition f17 := Float2 (-1025) (-21).
Definition i10 := makepairF f17 f4.
Notation p11 := (BND r13 i10). (* BND(x8 * e0, [-0.000488758, 0]) *)
Lemma l16 : s1 -> p2 (* BND(e0, [-0.000244141, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p3 -> p2 -> p11.
Proof.
 intros h0 h1.
 refine (mul_pn _x8 _e0 i3 i2 i10 h0 h1 _) ; finalize.
Qed.
Lemma l15 : s1 -> p11 (* BND(x8 * e0, [-0.000488758, 0]) *).
Proof.
 intros h0.
 assert (h1 := l9 h0).
 assert (h2 := l16 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p9 -> p11 -> p8.
Proof.
 intros h0 h1.
 refine (add r12 r13 i8 i10 i7 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(x0 * e8 + x8 * e0, [-0.00599095, 0.00550152]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l15 h0).
 apply t4. exact h1. exact h2.
Qed.
Definition f18 := Float2 (-17683367464164469304418471470572639064505291349639682166197) (-214).
Definition f19 := Float2 (2612505372838174624231194626957083123272178968489234694849) (-213).
Definition i11 := makepairF f18 f19.
Notation p12 := (BND r14 i11). (* BND(e0 * e8, [-6.71654e-07, 1.98458e-07]) *)
Lemma t5 : p2 -> p4 -> p12.
Proof.
 intros h0 h1.
 refine (mul_no _e0 _e8 i2 i4 i11 h0 h1 _) ; finalize.
Qed.
Lemma l17 : s1 -> p12 (* BND(e0 * e8, [-6.71654e-07, 1.98458e-07]) *).
Proof.
 intros h0.
 assert (h1 := l16 h0).
 assert (h2 := l14 h0).
 apply t5. exact h1. exact h2.
Qed.
Lemma t6 : p8 -> p12 -> p7.
Proof.
 intros h0 h1.
 refine (sub r11 r14 i7 i11 i6 h0 h1 _) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* BND(x0 * e8 + x8 * e0 - e0 * e8, [-0.00599115, 0.00550219]) *).
Proof.
 intros h0.
 assert (h1 := l12 h0).
 assert (h2 := l17 h0).
 apply t6. exact h1. exact h2.
Qed.
Definition i12 := makepairF f4 f4.
Notation p13 := (REL r1 r10 i12). (* REL(c - t, x0 * e8 + x8 * e0 - e0 * e8, [0, 0]) *)
Notation p14 := (r1 = r10). (* EQL(c - t, x0 * e8 + x8 * e0 - e0 * e8) *)
Lemma t7 : p14.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l19 : s1 -> p14 (* EQL(c - t, x0 * e8 + x8 * e0 - e0 * e8) *).
Proof.
 intros h0.
 apply t7.
Qed.
Notation p15 := (REL r10 r10 i12). (* REL(x0 * e8 + x8 * e0 - e0 * e8, x0 * e8 + x8 * e0 - e0 * e8, [0, 0]) *)
Lemma t8 : p15.
Proof.
 refine (rel_refl r10 i12 _) ; finalize.
Qed.
Lemma l20 : s1 -> p15 (* REL(x0 * e8 + x8 * e0 - e0 * e8, x0 * e8 + x8 * e0 - e0 * e8, [0, 0]) *).
Proof.
 intros h0.
 apply t8.
Qed.
Lemma t9 : p14 -> p15 -> p13.
Proof.
 intros h0 h1.
 refine (rel_rewrite_1 r1 r10 r10 i12 h0 h1) ; finalize.
Qed.
Lemma l18 : s1 -> p13 (* REL(c - t, x0 * e8 + x8 * e0 - e0 * e8, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l19 h0).
 assert (h2 := l20 h0).
 apply t9. exact h1. exact h2.
Qed.
Lemma t10 : p7 -> p13 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_of_bnd_rel_o r1 r10 i6 i12 i6 h0 h1 _) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.00599115, 0.00550219]) *).
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
 refine (simplify (Tatom false (Abnd 0%nat i6)) Tfalse (Abnd 0%nat i6) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
