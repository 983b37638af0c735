// fp_unpack: the sign, biased exponent and significand of one packed operand, and its class.
// Combinational. With GRADUAL, a subnormal has exponent 1 and a leading zero. Otherwise it counts
// as a zero, `flushed` says so, and a zero's significand is arbitrary, which spares gates. Operands
// that break a promise are not detected: rtl_templates/fp/README.md.
`default_nettype none

module fp_unpack #(
  parameter       EXPONENT_BITS    = 8,   // bits of the operand's exponent, 2 or more
  parameter       PRECISION        = 24,  // digits with the leading one, 2 or more
  parameter       SPECIAL_OPERANDS = 1,   // 0 promises no NaN and no infinity
  parameter       UNDERFLOW        = 1,   // 0 promises that no operand is subnormal
  parameter       GRADUAL          = 0    // 1: subnormals, only with UNDERFLOW; 0: flushed
) (
  input  wire [EXPONENT_BITS+PRECISION-1:0] a,
  output wire                               sign,
  output wire [EXPONENT_BITS-1:0]           exponent,
  output wire [PRECISION-1:0]               significand,
  output wire                               zero,
  output wire                               infinite,
  output wire                               nan,
  output wire                               flushed
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (EXPONENT_BITS < 2) begin : g_refused_exponent EXPONENT_BITS_is_below_2 refused (); end
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if ((GRADUAL != 0) && (UNDERFLOW == 0))
      begin : g_refused_gradual GRADUAL_without_UNDERFLOW refused (); end
  endgenerate

  wire [EXPONENT_BITS-1:0] field         = a[EXPONENT_BITS+PRECISION-2:PRECISION-1];
  wire [PRECISION-2:0]     fraction      = a[PRECISION-2:0];
  wire                     field_empty   = !(|field);
  wire                     fraction_some = |fraction;

  assign sign     = a[EXPONENT_BITS+PRECISION-1];
  assign infinite = (SPECIAL_OPERANDS != 0) && (&field) && !fraction_some;
  assign nan      = (SPECIAL_OPERANDS != 0) && (&field) && fraction_some;

  generate
    if (GRADUAL != 0) begin : g_gradual
      assign exponent    = {field[EXPONENT_BITS-1:1], field[0] || field_empty};
      assign significand = {!field_empty, fraction};
      assign zero        = field_empty && !fraction_some;
      assign flushed     = 1'b0;
    end else begin : g_flush
      assign exponent    = field;
      assign significand = {1'b1, fraction};
      assign zero        = field_empty;
      assign flushed     = (UNDERFLOW != 0) && field_empty && fraction_some;
    end
  endgenerate

endmodule

`default_nettype wire
