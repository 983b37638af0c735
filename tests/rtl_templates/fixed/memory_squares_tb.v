// memory_squares_tb: fixed_memory_squares against `*`, by Icarus. Every operand of up to 10 bits
// comes at one port, and others at the other port. Cases 0 to 9 have magnitudes as addresses, the
// same cases from 10 on the operands.
`default_nettype none

module memory_squares_tb;

  localparam CASES   = 20;
  localparam LATENCY = 3;

  reg              aclk = 0;
  reg  [9:0]       a, b;
  wire [CASES-1:0] differs;
  integer          cycle;

  genvar k;
  generate
    for (k = 0; k < CASES; k = k + 1) begin : g_cases
      localparam A         = k % 10 + 1;
      localparam B         = 10 - k % 10;
      localparam DROPPED_A = (A > 4) ? A - 4 : 0;
      localparam WIDTH_A   = 2 * A - DROPPED_A;

      wire [WIDTH_A-1:0]  y_a;
      wire [2*B-1:0]      y_b;
      wire signed [A-1:0] s0_a = a[A-1:0];
      wire signed [B-1:0] s0_b = b[B-1:0];
      reg  [2*A-1:0]      s1_a_q, s2_a_q, s3_a_q;
      reg  [2*B-1:0]      s1_b_q, s2_b_q, s3_b_q;

      always @(posedge aclk) begin
        s1_a_q <= s0_a * s0_a;
        s1_b_q <= s0_b * s0_b;
        s2_a_q <= s1_a_q;
        s2_b_q <= s1_b_q;
        s3_a_q <= s2_a_q;
        s3_b_q <= s2_b_q;
      end

      fixed_memory_squares #(
        .A_WIDTH       (A),
        .B_WIDTH       (B),
        .DROPPED_A     (DROPPED_A),
        .WIDTH_A       (WIDTH_A),
        .WIDTH_B       (2 * B),
        .SIGNED_ADDRESS(k / 10),
        .CUTS          (3'b111)
      ) squares (
        .aclk(aclk),
        .a   (a[A-1:0]),
        .b   (b[B-1:0]),
        .y_a (y_a),
        .y_b (y_b)
      );

      assign differs[k] = (y_a !== s3_a_q[DROPPED_A+:WIDTH_A]) || (y_b !== s3_b_q);
    end
  endgenerate

  initial begin
    for (cycle = 0; cycle < 1024 + LATENCY; cycle = cycle + 1) begin
      a = cycle;
      b = 771 * cycle;
      #1 aclk = 1;
      #1 aclk = 0;
      if ((cycle >= LATENCY) && (differs != 0)) begin
        $display("cycle %0d: squares differ, cases %b", cycle, differs);
        $finish(0);
      end
    end
    $display("all equal");
    $finish(0);
  end

endmodule

`default_nettype wire
