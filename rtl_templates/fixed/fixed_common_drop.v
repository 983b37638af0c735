// fixed_common_drop: how many low bits COUNT integers drop in common: the least number from 0 to
// MOST with which each of them fits its narrower format. `excess` has the bits of each integer
// beyond its format, which are MOST bits and the sign, in two's complement.
// Latency: the population count of CUTS (two bits); initiation interval 1; no reset.
`default_nettype none

module fixed_common_drop #(
  parameter       COUNT     = 4,     // number of integers, 1 or more
  parameter       MOST      = 3,     // the largest drop, 1 or more
  parameter       DROP_BITS = 2,     // bits of the drop, 1 or more; 2^DROP_BITS > MOST
  parameter [1:0] CUTS      = 2'b00  // a register behind stage k if bit k is 1
) (
  input  wire                      aclk,
  input  wire [COUNT*(MOST+1)-1:0] excess,
  output wire [DROP_BITS-1:0]      drop
);

  localparam INTEGERS = (COUNT < 1) ? 1 : COUNT;  // 1 if COUNT is refused

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNT < 1) begin : g_refused_count COUNT_is_below_1 refused (); end
    if (MOST < 1) begin : g_refused_most
      MOST_is_below_1 refused ();
    end else if ((DROP_BITS < 1) || ((MOST >> DROP_BITS) != 0)) begin : g_refused_drop
      DROP_BITS_do_not_hold_MOST refused ();
    end
  endgenerate

  // Stage join: which bits differ from the sign in some integer.
  genvar k;
  generate
    for (k = 0; k < INTEGERS; k = k + 1) begin : g_integer
      wire [MOST:0]   s0_excess = excess[k*(MOST+1)+:MOST+1];
      wire [MOST-1:0] s0_used   = s0_excess[MOST-1:0] ^ {MOST{s0_excess[MOST]}};
      wire [MOST-1:0] s0_joined;

      if (k == 0) begin : g_first
        assign s0_joined = s0_used;
      end else begin : g_next
        assign s0_joined = s0_used | g_integer[k-1].s0_joined;
      end
    end
  endgenerate

  wire [MOST-1:0] s1_used;

  fp_rank #(
    .WIDTH     (MOST),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (g_integer[INTEGERS-1].s0_joined),
    .q   (s1_used)
  );

  // Stage encode: the place of the leading one, counted from 1.
  reg [DROP_BITS-1:0] s1_drop;

  integer place;

  always @* begin
    s1_drop = 0;
    for (place = 0; place < MOST; place = place + 1) begin
      if (s1_used[place]) s1_drop = place[DROP_BITS-1:0] + 1'b1;
    end
  end

  fp_rank #(
    .WIDTH     (DROP_BITS),
    .REGISTERED(CUTS[1])
  ) rank_1 (
    .aclk(aclk),
    .d   (s1_drop),
    .q   (drop)
  );

endmodule

`default_nettype wire
