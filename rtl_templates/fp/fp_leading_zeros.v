// fp_leading_zeros: counts the zeros in front of the first one, by a tree of halves.
// Latency: REGISTERED; initiation interval 1; no reset. If no bit is one, `count` is all ones.
`default_nettype none

module fp_leading_zeros #(
  parameter COUNT_BITS = 5,  // 1 or more, for a value of 2^COUNT_BITS bits
  parameter REGISTERED = 0   // 1: registers behind the counts of each eight bits; 0: none
) (
  input  wire                         aclk,
  input  wire [(1 << COUNT_BITS)-1:0] value,
  output wire [COUNT_BITS-1:0]        count,
  output wire                         empty
);

  // Bits of a count in front of the registers, unless the whole count has fewer.
  localparam GROUP_BITS = 3;

  wire [COUNT_BITS-1:0] s0_count;
  wire                  s0_empty;

  // An invalid parameter instantiates a module that does not exist: elaboration fails.
  generate
    if (COUNT_BITS < 1) begin : g_refused_count_bits
      COUNT_BITS_is_below_1 refused ();
    end else if (COUNT_BITS == 1) begin : g_leaf
      assign s0_count = !value[1];
      assign s0_empty = !(|value);
    end else begin : g_halves
      localparam HALF              = 1 << (COUNT_BITS - 1);
      localparam HALVES_REGISTERED = (COUNT_BITS > GROUP_BITS) && (REGISTERED != 0);

      wire [COUNT_BITS-2:0] upper_count;
      wire [COUNT_BITS-2:0] lower_count;
      wire                  upper_empty;
      wire                  lower_empty;

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS - 1),
        .REGISTERED(HALVES_REGISTERED)
      ) upper (
        .aclk (aclk),
        .value(value[2*HALF-1:HALF]),
        .count(upper_count),
        .empty(upper_empty)
      );

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS - 1),
        .REGISTERED(HALVES_REGISTERED)
      ) lower (
        .aclk (aclk),
        .value(value[HALF-1:0]),
        .count(lower_count),
        .empty(lower_empty)
      );

      assign s0_count = {upper_empty, upper_empty ? lower_count : upper_count};
      assign s0_empty = upper_empty && lower_empty;
    end
  endgenerate

  fp_rank #(
    .WIDTH     (COUNT_BITS + 1),
    .REGISTERED((COUNT_BITS <= GROUP_BITS) && (REGISTERED != 0))
  ) rank (
    .aclk(aclk),
    .d   ({s0_count, s0_empty}),
    .q   ({count, empty})
  );

endmodule

`default_nettype wire
