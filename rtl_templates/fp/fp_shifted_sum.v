// fp_shifted_sum: low + high * 2^SHIFT, one carry chain as long as `high`.
// Combinational. SHIFT < LOW < HIGH + SHIFT; the sum must fit.
`default_nettype none

module fp_shifted_sum #(
  parameter LOW   = 26,
  parameter HIGH  = 26,
  parameter SHIFT = 2
) (
  input  wire [LOW-1:0]        low,
  input  wire [HIGH-1:0]       high,
  output wire [HIGH+SHIFT-1:0] sum
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (SHIFT < 1) begin : g_refused_shift
      SHIFT_is_below_1 refused ();
    end
    if (SHIFT >= LOW) begin : g_refused_low_end
      SHIFT_is_not_below_LOW refused ();
    end
    if (LOW >= HIGH + SHIFT) begin : g_refused_high_end
      LOW_is_not_below_HIGH_plus_SHIFT refused ();
    end
  endgenerate

  wire [HIGH-1:0] low_above = {{(HIGH + SHIFT - LOW) {1'b0}}, low[LOW-1:SHIFT]};

  assign sum = {low_above + high, low[SHIFT-1:0]};

endmodule

`default_nettype wire
