// fp_selected_sum: a + (select ? c : b) + carry, modulo 2^WIDTH, with the cut of fp_halved_sum. Its
// carry cells of ECP5 also select, which Yosys does not make them do by itself.
// Latency: CUTS; initiation interval 1; no reset.
`default_nettype none

module fp_selected_sum #(
  parameter       WIDTH = 8,    // bits of each operand, 1 or more; with CUTS 2 or more
  parameter [0:0] CUTS  = 1'b0  // 1: registers between lower and upper half
) (
  input  wire             aclk,
  input  wire [WIDTH-1:0] a,
  input  wire             select,
  input  wire [WIDTH-1:0] b,
  input  wire [WIDTH-1:0] c,
  input  wire             carry,
  output wire [WIDTH-1:0] sum
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
  endgenerate

  generate
    if (CUTS != 0) begin : g_halves
      localparam LOWER = WIDTH / 2;
      localparam UPPER = WIDTH - LOWER;

      wire [LOWER:0]   s0_lower;
      wire [UPPER-1:0] s1_a;
      wire             s1_select;
      wire [UPPER-1:0] s1_b;
      wire [UPPER-1:0] s1_c;
      wire             s1_carry;
      wire [LOWER-1:0] s1_lower;
      wire [UPPER-1:0] s1_upper;

      fp_selected_sum #(
        .WIDTH(LOWER + 1)
      ) s0_sum (
        .aclk  (aclk),
        .a     ({1'b0, a[LOWER-1:0]}),
        .select(select),
        .b     ({1'b0, b[LOWER-1:0]}),
        .c     ({1'b0, c[LOWER-1:0]}),
        .carry (carry),
        .sum   (s0_lower)
      );

      fp_rank #(
        .WIDTH(3 * UPPER + 1 + LOWER + 1)
      ) rank_0 (
        .aclk(aclk),
        .d   ({a[WIDTH-1:LOWER], select, b[WIDTH-1:LOWER], c[WIDTH-1:LOWER], s0_lower}),
        .q   ({s1_a, s1_select, s1_b, s1_c, s1_carry, s1_lower})
      );

      fp_selected_sum #(
        .WIDTH(UPPER)
      ) s1_sum (
        .aclk  (aclk),
        .a     (s1_a),
        .select(s1_select),
        .b     (s1_b),
        .c     (s1_c),
        .carry (s1_carry),
        .sum   (s1_upper)
      );

      assign sum = {s1_upper, s1_lower};
    end else begin : g_whole
      // A cell adds two places. A carry enters as a carry out of an extra last place.
      localparam CELLS = (WIDTH + 2) / 2;

      wire               unused_aclk = aclk;
      wire [2*CELLS-1:0] all_a       = {{(2 * CELLS - 1 - WIDTH) {1'b0}}, a, 1'b1};
      wire [2*CELLS-1:0] all_b       = {{(2 * CELLS - 1 - WIDTH) {1'b0}}, b, carry};
      wire [2*CELLS-1:0] all_c       = {{(2 * CELLS - 1 - WIDTH) {1'b0}}, c, carry};
      wire [2*CELLS-1:0] all_sums;
      wire [CELLS:0]     carries;
      wire               unused_bits = ^all_sums ^ carries[CELLS];
      genvar             k;

      assign carries[0] = 1'b0;

      // The table of a ^ (select ? c : b) says whether a carry passes. If it does not pass, the
      // cell's carry is the entry of that table for b = c = 0, which is a, so it depends only on a
      // and `select`.
      for (k = 0; k < CELLS; k = k + 1) begin : g_cells
        CCU2C #(
          .INIT0    (16'h569a),
          .INIT1    (16'h569a),
          .INJECT1_0("NO"),
          .INJECT1_1("NO")
        ) adder (
          .CIN (carries[k]),
          .A0  (all_a[2*k]),
          .B0  (select),
          .C0  (all_b[2*k]),
          .D0  (all_c[2*k]),
          .S0  (all_sums[2*k]),
          .A1  (all_a[2*k+1]),
          .B1  (select),
          .C1  (all_b[2*k+1]),
          .D1  (all_c[2*k+1]),
          .S1  (all_sums[2*k+1]),
          .COUT(carries[k+1])
        );
      end

      assign sum = all_sums[WIDTH:1];
    end
  endgenerate

endmodule

`default_nettype wire
