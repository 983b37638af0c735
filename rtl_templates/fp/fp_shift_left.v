// fp_shift_left: moves a value up and keeps its KEPT leading bits; `sticky` is the OR of the rest.
// Combinational. KEPT is at most WIDTH; ones must not be moved out at the top.
`default_nettype none

module fp_shift_left #(
  parameter WIDTH       = 27,
  parameter KEPT        = 26,
  parameter AMOUNT_BITS = 5
) (
  input  wire [WIDTH-1:0]       value,
  input  wire [AMOUNT_BITS-1:0] amount,
  output wire [KEPT-1:0]        shifted,
  output wire                   sticky
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (KEPT < 1) begin : g_refused_kept
      KEPT_is_below_1 refused ();
    end
    if (KEPT > WIDTH) begin : g_refused_more_kept
      KEPT_is_above_WIDTH refused ();
    end
    if ((AMOUNT_BITS < 1) || (AMOUNT_BITS > 30)) begin : g_refused_amount_bits
      AMOUNT_BITS_is_not_1_to_30 refused ();
    end
  endgenerate

  reg [WIDTH-1:0] moving;
  reg             lost;

  integer k;

  // Before the step of 2^k at most 2^(k+1) - 1 places are left to go: what lies further than that
  // below the kept bits goes into the sticky bit now and is not moved along.
  always @* begin
    moving = value;
    lost   = 1'b0;
    for (k = AMOUNT_BITS - 1; k >= 0; k = k - 1) begin
      lost   = lost || (|(moving & ({WIDTH{1'b1}} >> (KEPT + (2 << k) - 1))));
      moving = moving & ~({WIDTH{1'b1}} >> (KEPT + (2 << k) - 1));
      if (amount[k]) begin
        moving = moving << (1 << k);
      end
    end
  end

  assign shifted = moving[WIDTH-1:WIDTH-KEPT];
  assign sticky  = lost || (|(moving & ~({WIDTH{1'b1}} << (WIDTH - KEPT))));

endmodule

`default_nettype wire
