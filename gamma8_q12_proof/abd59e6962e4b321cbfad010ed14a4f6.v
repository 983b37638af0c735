Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x0 : R.
Variable _x1 : R.
Notation _c := ((_x0 * _x1)%R).
Variable _e0 : R.
Notation r6 := ((_x0 - _e0)%R).
Variable _e1 : R.
Notation r8 := ((_x1 - _e1)%R).
Notation _t := ((r6 * r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r12 := ((_x0 * _e1)%R).
Notation r13 := ((_x1 * _e0)%R).
Notation r11 := ((r12 + r13)%R).
Notation r14 := ((_e0 * _e1)%R).
Notation r10 := ((r11 - r14)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (0) (0).
Definition f2 := Float2 (255) (0).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x0 i1). (* BND(x0, [0, 255]) *)
Definition i2 := makepairF f1 f1.
Notation p2 := (BND _e0 i2). (* BND(e0, [0, 0]) *)
Definition s4 := (p1 /\ p2).
Definition f3 := Float2 (257) (-16).
Definition i3 := makepairF f3 f3.
Notation p3 := (BND _x1 i3). (* BND(x1, [0.00392151, 0.00392151]) *)
Definition s3 := (s4 /\ p3).
Definition f4 := Float2 (-667220327295957771496812955748565121) (-143).
Definition f5 := Float2 (-1334440654591915542993625911497130241) (-144).
Definition i4 := makepairF f4 f5.
Notation p4 := (BND _e1 i4). (* BND(e1, [-5.98384e-08, -5.98384e-08]) *)
Definition s2 := (s3 /\ p4).
Definition f6 := Float2 (65535) (-16).
Definition i5 := makepairF f1 f6.
Notation p5 := (BND _c i5). (* BND(c, [0, 0.999985]) *)
Definition s6 := (not p5).
Definition f7 := Float2 (-170141183460469231731687303715884105855) (-143).
Definition i6 := makepairF f7 f1.
Notation p6 := (BND r1 i6). (* BND(c - t, [-1.52588e-05, 0]) *)
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
Lemma l5 : s1 -> p1 (* BND(x0, [0, 255]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x1, [0.00392151, 0.00392151]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Definition f8 := Float2 (1) (-8).
Definition i7 := makepairF f8 f3.
Notation p7 := (BND _x1 i7). (* BND(x1, [0.00390625, 0.00392151]) *)
Lemma t1 : p1 -> p7 -> p5.
Proof.
 intros h0 h1.
 refine (mul_pp _x0 _x1 i1 i7 i5 h0 h1 _) ; finalize.
Qed.
Lemma l4 : s1 -> p5 (* BND(c, [0, 0.999985]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l9 h0).
 apply t1. exact h1. refine (subset _x1 i3 i7 h2 _) ; finalize.
Qed.
Lemma l2 : s1 -> s7.
Proof.
 intros h0.
 assert (h1 := l3 h0).
 assert (h2 := l4 h0).
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i5)) (Tatom false (Abnd 1%nat i6))) (Tatom false (Abnd 1%nat i6)) (Abnd 0%nat i5) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p8 := (BND r10 i6). (* BND(x0 * e1 + x1 * e0 - e0 * e1, [-1.52588e-05, 0]) *)
Notation p9 := (BND r11 i6). (* BND(x0 * e1 + x1 * e0, [-1.52588e-05, 0]) *)
Notation p10 := (BND r12 i6). (* BND(x0 * e1, [-1.52588e-05, -0]) *)
Lemma l14 : s1 -> p4 (* BND(e1, [-5.98384e-08, -5.98384e-08]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Definition f9 := Float2 (-1) (-24).
Definition i8 := makepairF f4 f9.
Notation p11 := (BND _e1 i8). (* BND(e1, [-5.98384e-08, -5.96046e-08]) *)
Lemma t2 : p1 -> p11 -> p10.
Proof.
 intros h0 h1.
 refine (mul_pn _x0 _e1 i1 i8 i6 h0 h1 _) ; finalize.
Qed.
Lemma l13 : s1 -> p10 (* BND(x0 * e1, [-1.52588e-05, -0]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l14 h0).
 apply t2. exact h1. refine (subset _e1 i4 i8 h2 _) ; finalize.
Qed.
Notation p12 := (BND r13 i2). (* BND(x1 * e0, [0, 0]) *)
Lemma l16 : s1 -> p2 (* BND(e0, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Definition f10 := Float2 (1) (0).
Definition i9 := makepairF f8 f10.
Notation p13 := (BND _x1 i9). (* BND(x1, [0.00390625, 1]) *)
Lemma t3 : p13 -> p2 -> p12.
Proof.
 intros h0 h1.
 refine (mul_pp _x1 _e0 i9 i2 i2 h0 h1 _) ; finalize.
Qed.
Lemma l15 : s1 -> p12 (* BND(x1 * e0, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l9 h0).
 assert (h2 := l16 h0).
 apply t3. refine (subset _x1 i3 i9 h1 _) ; finalize. exact h2.
Qed.
Lemma t4 : p10 -> p12 -> p9.
Proof.
 intros h0 h1.
 refine (add r12 r13 i6 i2 i6 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p9 (* BND(x0 * e1 + x1 * e0, [-1.52588e-05, 0]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l15 h0).
 apply t4. exact h1. exact h2.
Qed.
Notation p14 := (BND r14 i2). (* BND(e0 * e1, [0, 0]) *)
Definition f11 := Float2 (-1) (0).
Definition i10 := makepairF f11 f9.
Notation p15 := (BND _e1 i10). (* BND(e1, [-1, -5.96046e-08]) *)
Lemma t5 : p2 -> p15 -> p14.
Proof.
 intros h0 h1.
 refine (mul_pn _e0 _e1 i2 i10 i2 h0 h1 _) ; finalize.
Qed.
Lemma l17 : s1 -> p14 (* BND(e0 * e1, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l16 h0).
 assert (h2 := l14 h0).
 apply t5. exact h1. refine (subset _e1 i4 i10 h2 _) ; finalize.
Qed.
Lemma t6 : p9 -> p14 -> p8.
Proof.
 intros h0 h1.
 refine (sub r11 r14 i6 i2 i6 h0 h1 _) ; finalize.
Qed.
Lemma l11 : s1 -> p8 (* BND(x0 * e1 + x1 * e0 - e0 * e1, [-1.52588e-05, 0]) *).
Proof.
 intros h0.
 assert (h1 := l12 h0).
 assert (h2 := l17 h0).
 apply t6. exact h1. exact h2.
Qed.
Notation p16 := (REL r1 r10 i2). (* REL(c - t, x0 * e1 + x1 * e0 - e0 * e1, [0, 0]) *)
Notation p17 := (r1 = r10). (* EQL(c - t, x0 * e1 + x1 * e0 - e0 * e1) *)
Lemma t7 : p17.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l19 : s1 -> p17 (* EQL(c - t, x0 * e1 + x1 * e0 - e0 * e1) *).
Proof.
 intros h0.
 apply t7.
Qed.
Notation p18 := (REL r10 r10 i2). (* REL(x0 * e1 + x1 * e0 - e0 * e1, x0 * e1 + x1 * e0 - e0 * e1, [0, 0]) *)
Lemma t8 : p18.
Proof.
 refine (rel_refl r10 i2 _) ; finalize.
Qed.
Lemma l20 : s1 -> p18 (* REL(x0 * e1 + x1 * e0 - e0 * e1, x0 * e1 + x1 * e0 - e0 * e1, [0, 0]) *).
Proof.
 intros h0.
 apply t8.
Qed.
Lemma t9 : p17 -> p18 -> p16.
Proof.
 intros h0 h1.
 refine (rel_rewrite_1 r1 r10 r10 i2 h0 h1) ; finalize.
Qed.
Lemma l18 : s1 -> p16 (* REL(c - t, x0 * e1 + x1 * e0 - e0 * e1, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l19 h0).
 assert (h2 := l20 h0).
 apply t9. exact h1. exact h2.
Qed.
Lemma t10 : p8 -> p16 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_of_bnd_rel_n r1 r10 i6 i2 i6 h0 h1 _) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-1.52588e-05, 0]) *).
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
