// fp_leading_zeros: how many zeros precede the first one, as a tree of halves.
// Combinational. For an empty value `count` is all ones.
`default_nettype none

module fp_leading_zeros #(
  parameter COUNT_BITS = 5  // of a value 2^COUNT_BITS wide
) (
  input  wire [(1 << COUNT_BITS)-1:0] value,
  output wire [COUNT_BITS-1:0]        count,
  output wire                         empty
);

  // A parameter that does not fit: an instance of a module that does not exist.
  generate
    if (COUNT_BITS < 1) begin : g_refused_count_bits
      COUNT_BITS_is_below_1 refused ();
    end else if (COUNT_BITS == 1) begin : g_leaf
      assign count = !value[1];
      assign empty = !(|value);
    end else begin : g_halves
      localparam HALF = 1 << (COUNT_BITS - 1);

      wire [COUNT_BITS-2:0] upper_count;
      wire [COUNT_BITS-2:0] lower_count;
      wire                  upper_empty;
      wire                  lower_empty;

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS - 1)
      ) upper (
        .value(value[2*HALF-1:HALF]),
        .count(upper_count),
        .empty(upper_empty)
      );

      fp_leading_zeros #(
        .COUNT_BITS(COUNT_BITS - 1)
      ) lower (
        .value(value[HALF-1:0]),
        .count(lower_count),
        .empty(lower_empty)
      );

      assign count = {upper_empty, upper_empty ? lower_count : upper_count};
      assign empty = upper_empty && lower_empty;
    end
  endgenerate

endmodule

`default_nettype wire
