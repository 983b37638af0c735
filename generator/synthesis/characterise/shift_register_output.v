// A techmap file for Yosys. It makes the last register of each shift register a flip-flop, whose
// output is three times as fast. The vendor's tools do so if a path begins in the shift register
// (Xilinx UG904, "Shift Register Optimization"); Yosys does not. Yosys makes chains of shift
// registers of more than 32 bits, and only the last one of a chain is split.

(* techmap_celltype = "SRL16E" *)
module shift_register_of_16 (
  input  wire CLK,
  input  wire CE,
  input  wire D,
  input  wire A0,
  input  wire A1,
  input  wire A2,
  input  wire A3,
  output wire Q
);

  parameter [15:0] INIT                 = 16'h0000;
  parameter        IS_CLK_INVERTED      = 1'b0;
  parameter        _TECHMAP_CONSTMSK_A0_ = 1'b0;
  parameter        _TECHMAP_CONSTMSK_A1_ = 1'b0;
  parameter        _TECHMAP_CONSTMSK_A2_ = 1'b0;
  parameter        _TECHMAP_CONSTMSK_A3_ = 1'b0;
  parameter        _TECHMAP_CONSTVAL_A0_ = 1'b0;
  parameter        _TECHMAP_CONSTVAL_A1_ = 1'b0;
  parameter        _TECHMAP_CONSTVAL_A2_ = 1'b0;
  parameter        _TECHMAP_CONSTVAL_A3_ = 1'b0;

  // Yosys sets bit k of _TECHMAP_CONSTMSK_ if bit k of the address is constant, and then gives the
  // constant in _TECHMAP_CONSTVAL_. The address is the number of registers in front of the one that
  // is read.
  localparam       IS_FIXED = _TECHMAP_CONSTMSK_A0_ && _TECHMAP_CONSTMSK_A1_
                              && _TECHMAP_CONSTMSK_A2_ && _TECHMAP_CONSTMSK_A3_;
  localparam [3:0] ADDRESS  = {_TECHMAP_CONSTVAL_A3_, _TECHMAP_CONSTVAL_A2_,
                               _TECHMAP_CONSTVAL_A1_, _TECHMAP_CONSTVAL_A0_};
  localparam [3:0] BEFORE   = ADDRESS - 4'd1;

  wire _TECHMAP_FAIL_ = !IS_FIXED || (ADDRESS == 0);
  wire before_last;

  SRL16E #(
    .INIT           (INIT),
    .IS_CLK_INVERTED(IS_CLK_INVERTED)
  ) shift_register (
    .CLK(CLK),
    .CE (CE),
    .D  (D),
    .A0 (BEFORE[0]),
    .A1 (BEFORE[1]),
    .A2 (BEFORE[2]),
    .A3 (BEFORE[3]),
    .Q  (before_last)
  );

  FDRE #(
    .INIT         (INIT[ADDRESS]),
    .IS_C_INVERTED(IS_CLK_INVERTED)
  ) last_register (
    .C (CLK),
    .CE(CE),
    .R (1'b0),
    .D (before_last),
    .Q (Q)
  );

endmodule

(* techmap_celltype = "SRLC32E" *)
module shift_register_of_32 (
  input  wire       CLK,
  input  wire       CE,
  input  wire       D,
  input  wire [4:0] A,
  output wire       Q,
  output wire       Q31
);

  parameter [31:0] INIT                = 32'h00000000;
  parameter        IS_CLK_INVERTED     = 1'b0;
  parameter [4:0]  _TECHMAP_CONSTMSK_A_ = 5'd0;
  parameter [4:0]  _TECHMAP_CONSTVAL_A_ = 5'd0;

  localparam       IS_FIXED = &_TECHMAP_CONSTMSK_A_;
  localparam [4:0] BEFORE   = _TECHMAP_CONSTVAL_A_ - 5'd1;

  wire _TECHMAP_FAIL_ = !IS_FIXED || (_TECHMAP_CONSTVAL_A_ == 0);
  wire before_last;

  SRLC32E #(
    .INIT           (INIT),
    .IS_CLK_INVERTED(IS_CLK_INVERTED)
  ) shift_register (
    .CLK(CLK),
    .CE (CE),
    .D  (D),
    .A  (BEFORE),
    .Q  (before_last),
    .Q31(Q31)
  );

  FDRE #(
    .INIT         (INIT[_TECHMAP_CONSTVAL_A_]),
    .IS_C_INVERTED(IS_CLK_INVERTED)
  ) last_register (
    .C (CLK),
    .CE(CE),
    .R (1'b0),
    .D (before_last),
    .Q (Q)
  );

endmodule
