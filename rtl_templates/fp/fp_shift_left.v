// fp_shift_left: moves a value up by `amount` steps of STEP places and keeps its KEPT leading bits;
// `sticky` is the OR of the rest.
// Combinational. Ones must not be moved out at the top.
`default_nettype none

module fp_shift_left #(
  parameter WIDTH       = 27,  // bits of `value`, KEPT or more
  parameter KEPT        = 26,  // bits of `shifted`, 1 or more
  parameter AMOUNT_BITS = 5,   // bits of `amount`, 1 to 30
  parameter STEP        = 1    // places of one step, 1 or more
) (
  input  wire [WIDTH-1:0]       value,
  input  wire [AMOUNT_BITS-1:0] amount,
  output wire [KEPT-1:0]        shifted,
  output wire                   sticky
);

  // The places below the kept ones form groups of STEP from the top; the last group may be shorter.
  localparam BELOW  = WIDTH - KEPT;
  localparam GROUPS = (BELOW + STEP - 1) / STEP;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (KEPT < 1) begin : g_refused_kept KEPT_is_below_1 refused (); end
    if (KEPT > WIDTH) begin : g_refused_more_kept KEPT_is_above_WIDTH refused (); end
    if ((AMOUNT_BITS < 1) || (AMOUNT_BITS > 30))
      begin : g_refused_amount_bits AMOUNT_BITS_is_not_1_to_30 refused (); end
    if (STEP < 1) begin : g_refused_step STEP_is_below_1 refused (); end
  endgenerate

  reg [WIDTH-1:0] moving;

  integer k;

  always @* begin
    moving = value;
    for (k = AMOUNT_BITS - 1; k >= 0; k = k - 1) begin
      if (amount[k]) moving = moving << (STEP << k);
    end
  end

  assign shifted = moving[WIDTH-1:BELOW];

  // Group g stays below unless there are more than g steps, which is known without a shift.
  generate
    if (BELOW > 0) begin : g_below
      wire [GROUPS-1:0] lost;
      genvar            g;

      for (g = 0; g < GROUPS; g = g + 1) begin : g_groups
        localparam TOP    = BELOW - g * STEP;
        localparam BOTTOM = (TOP > STEP) ? TOP - STEP : 0;

        if (((g + 1) >> AMOUNT_BITS) != 0) begin : g_always
          assign lost[g] = |value[TOP-1:BOTTOM];
        end else begin : g_sometimes
          localparam [AMOUNT_BITS-1:0] GROUP = g;

          assign lost[g] = (amount <= GROUP) && (|value[TOP-1:BOTTOM]);
        end
      end

      assign sticky = |lost;
    end else begin : g_nothing_below
      assign sticky = 1'b0;
    end
  endgenerate

endmodule

`default_nettype wire
