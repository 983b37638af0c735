Require Import Gappa.Gappa_library.
Section Generated_by_Gappa.
Variable _x7 : R.
Variable _x25 : R.
Notation _c := ((_x7 * _x25)%R).
Variable _e7 : R.
Notation r6 := ((_x7 - _e7)%R).
Variable _e25 : R.
Notation r8 := ((_x25 - _e25)%R).
Notation _t := ((r6 * r8)%R).
Notation r1 := ((_c - _t)%R).
Notation r12 := ((_x7 * _e25)%R).
Notation r13 := ((_x25 * _e7)%R).
Notation r11 := ((r12 + r13)%R).
Notation r14 := ((_e7 * _e25)%R).
Notation r10 := ((r11 - r14)%R).
Hypothesis a1 : r1 = r10.
Lemma b1 : r1 = r10.
 apply a1.
Qed.
Definition f1 := Float2 (-1) (9).
Definition f2 := Float2 (1) (9).
Definition i1 := makepairF f1 f2.
Notation p1 := (BND _x7 i1). (* BND(x7, [-512, 512]) *)
Definition f3 := Float2 (0) (0).
Definition i2 := makepairF f3 f3.
Notation p2 := (BND _e7 i2). (* BND(e7, [0, 0]) *)
Definition s4 := (p1 /\ p2).
Definition f4 := Float2 (1) (-10).
Definition f5 := Float2 (1) (0).
Definition i3 := makepairF f4 f5.
Notation p3 := (BND _x25 i3). (* BND(x25, [0.000976562, 1]) *)
Definition s3 := (s4 /\ p3).
Definition f6 := Float2 (-11267903353896045723150298863886578771633692269432353493673) (-214).
Definition f7 := Float2 (5804894081942703392552629357292794498193288465560486388543) (-213).
Definition i4 := makepairF f6 f7.
Notation p4 := (BND _e25 i4). (* BND(e25, [-4.27981e-07, 4.40966e-07]) *)
Definition s2 := (s3 /\ p4).
Notation p5 := (BND _c i1). (* BND(c, [-512, 512]) *)
Definition s6 := (not p5).
Definition f8 := Float2 (-5804894081942703392552629357292794498193288465560486388543) (-204).
Definition f9 := Float2 (5804894081942703392552629357292794498193288465560486388543) (-204).
Definition i5 := makepairF f8 f9.
Notation p6 := (BND r1 i5). (* BND(c - t, [-0.000225775, 0.000225775]) *)
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
Lemma l5 : s1 -> p1 (* BND(x7, [-512, 512]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj1 h1).
Qed.
Lemma l9 : s1 -> p3 (* BND(x25, [0.000976562, 1]) *).
Proof.
 intros h0.
 assert (h1 := l7 h0).
 exact (proj2 h1).
Qed.
Lemma t1 : p1 -> p3 -> p5.
Proof.
 intros h0 h1.
 refine (mul_op _x7 _x25 i1 i3 i1 h0 h1 _) ; finalize.
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
 refine (simplify (Ttree false (Tatom false (Abnd 0%nat i1)) (Tatom false (Abnd 1%nat i5))) (Tatom false (Abnd 1%nat i5)) (Abnd 0%nat i1) (List.cons _c (List.cons r1 List.nil)) h2 h1 _) ; finalize.
Qed.
Notation p7 := (BND r10 i5). (* BND(x7 * e25 + x25 * e7 - e7 * e25, [-0.000225775, 0.000225775]) *)
Notation p8 := (BND r11 i5). (* BND(x7 * e25 + x25 * e7, [-0.000225775, 0.000225775]) *)
Notation p9 := (BND r12 i5). (* BND(x7 * e25, [-0.000225775, 0.000225775]) *)
Lemma l14 : s1 -> p4 (* BND(e25, [-4.27981e-07, 4.40966e-07]) *).
Proof.
 intros h0.
 assert (h1 := l8 h0).
 exact (proj2 h1).
Qed.
Definition f10 := Float2 (-29) (-26).
Definition i6 := makepairF f10 f7.
Notation p10 := (BND _e25 i6). (* BND(e25, [-4.32134e-07, 4.40966e-07]) *)
Lemma t2 : p1 -> p10 -> p9.
Proof.
 intros h0 h1.
 refine (mul_oo _x7 _e25 i1 i6 i5 h0 h1 _) ; finalize.
Qed.
Lemma l13 : s1 -> p9 (* BND(x7 * e25, [-0.000225775, 0.000225775]) *).
Proof.
 intros h0.
 assert (h1 := l5 h0).
 assert (h2 := l14 h0).
 apply t2. exact h1. refine (subset _e25 i4 i6 h2 _) ; finalize.
Qed.
Notation p11 := (BND r13 i2). (* BND(x25 * e7, [0, 0]) *)
Lemma l16 : s1 -> p2 (* BND(e7, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l6 h0).
 exact (proj2 h1).
Qed.
Lemma t3 : p3 -> p2 -> p11.
Proof.
 intros h0 h1.
 refine (mul_pp _x25 _e7 i3 i2 i2 h0 h1 _) ; finalize.
Qed.
Lemma l15 : s1 -> p11 (* BND(x25 * e7, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l9 h0).
 assert (h2 := l16 h0).
 apply t3. exact h1. exact h2.
Qed.
Lemma t4 : p9 -> p11 -> p8.
Proof.
 intros h0 h1.
 refine (add r12 r13 i5 i2 i5 h0 h1 _) ; finalize.
Qed.
Lemma l12 : s1 -> p8 (* BND(x7 * e25 + x25 * e7, [-0.000225775, 0.000225775]) *).
Proof.
 intros h0.
 assert (h1 := l13 h0).
 assert (h2 := l15 h0).
 apply t4. exact h1. exact h2.
Qed.
Notation p12 := (BND r14 i2). (* BND(e7 * e25, [0, 0]) *)
Definition f11 := Float2 (-1) (0).
Definition i7 := makepairF f11 f5.
Notation p13 := (BND _e25 i7). (* BND(e25, [-1, 1]) *)
Lemma t5 : p2 -> p13 -> p12.
Proof.
 intros h0 h1.
 refine (mul_po _e7 _e25 i2 i7 i2 h0 h1 _) ; finalize.
Qed.
Lemma l17 : s1 -> p12 (* BND(e7 * e25, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l16 h0).
 assert (h2 := l14 h0).
 apply t5. exact h1. refine (subset _e25 i4 i7 h2 _) ; finalize.
Qed.
Lemma t6 : p8 -> p12 -> p7.
Proof.
 intros h0 h1.
 refine (sub r11 r14 i5 i2 i5 h0 h1 _) ; finalize.
Qed.
Lemma l11 : s1 -> p7 (* BND(x7 * e25 + x25 * e7 - e7 * e25, [-0.000225775, 0.000225775]) *).
Proof.
 intros h0.
 assert (h1 := l12 h0).
 assert (h2 := l17 h0).
 apply t6. exact h1. exact h2.
Qed.
Notation p14 := (REL r1 r10 i2). (* REL(c - t, x7 * e25 + x25 * e7 - e7 * e25, [0, 0]) *)
Notation p15 := (r1 = r10). (* EQL(c - t, x7 * e25 + x25 * e7 - e7 * e25) *)
Lemma t7 : p15.
Proof.
 refine (b1) ; finalize.
Qed.
Lemma l19 : s1 -> p15 (* EQL(c - t, x7 * e25 + x25 * e7 - e7 * e25) *).
Proof.
 intros h0.
 apply t7.
Qed.
Notation p16 := (REL r10 r10 i2). (* REL(x7 * e25 + x25 * e7 - e7 * e25, x7 * e25 + x25 * e7 - e7 * e25, [0, 0]) *)
Lemma t8 : p16.
Proof.
 refine (rel_refl r10 i2 _) ; finalize.
Qed.
Lemma l20 : s1 -> p16 (* REL(x7 * e25 + x25 * e7 - e7 * e25, x7 * e25 + x25 * e7 - e7 * e25, [0, 0]) *).
Proof.
 intros h0.
 apply t8.
Qed.
Lemma t9 : p15 -> p16 -> p14.
Proof.
 intros h0 h1.
 refine (rel_rewrite_1 r1 r10 r10 i2 h0 h1) ; finalize.
Qed.
Lemma l18 : s1 -> p14 (* REL(c - t, x7 * e25 + x25 * e7 - e7 * e25, [0, 0]) *).
Proof.
 intros h0.
 assert (h1 := l19 h0).
 assert (h2 := l20 h0).
 apply t9. exact h1. exact h2.
Qed.
Lemma t10 : p7 -> p14 -> p6.
Proof.
 intros h0 h1.
 refine (bnd_of_bnd_rel_o r1 r10 i5 i2 i5 h0 h1 _) ; finalize.
Qed.
Lemma l10 : s1 -> p6 (* BND(c - t, [-0.000225775, 0.000225775]) *).
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
 refine (simplify (Tatom false (Abnd 0%nat i5)) Tfalse (Abnd 0%nat i5) (List.cons r1 List.nil) h2 h1 _) ; finalize.
Qed.
End Generated_by_Gappa.
