// balanced_tree: the lane of descriptors.toml, written by hand: sixteen differences, their squares
// and a balanced tree of adders, each as wide as its numbers. Verdicts are those of a lane: 0 less,
// 1 equal, 2 greater. Latency 8 cycles, initiation interval 1, no reset.
`default_nettype none

module balanced_tree (
  input  wire         aclk,
  input  wire [127:0] di,
  input  wire [127:0] dj,
  output reg  [1:0]   verdict
);

  localparam [20:0] threshold = 21'd500;

  wire [255:0] squares;
  wire [135:0] sums_of_2;
  wire [71:0]  sums_of_4;
  wire [37:0]  sums_of_8;
  reg  [19:0]  sum_q;
  reg  [20:0]  excess_q;

  genvar k;
  generate
    for (k = 0; k < 16; k = k + 1) begin : g_squares
      wire signed [8:0] a = {di[8 * k + 7], di[8 * k +: 8]};
      wire signed [8:0] b = {dj[8 * k + 7], dj[8 * k +: 8]};
      reg  signed [8:0] difference_q;
      reg  [15:0]       square_q;
      wire [1:0]        unused;
      wire [15:0]       square;  // at most 255^2
      assign {unused, square} = difference_q * difference_q;
      always @(posedge aclk) begin
        difference_q <= a - b;
        square_q     <= square;
      end
      assign squares[16 * k +: 16] = square_q;
    end
    for (k = 0; k < 8; k = k + 1) begin : g_sums_of_2
      reg [16:0] pair_q;
      always @(posedge aclk) pair_q <= squares[32 * k +: 16] + squares[32 * k + 16 +: 16];
      assign sums_of_2[17 * k +: 17] = pair_q;
    end
    for (k = 0; k < 4; k = k + 1) begin : g_sums_of_4
      reg [17:0] four_q;
      always @(posedge aclk) four_q <= sums_of_2[34 * k +: 17] + sums_of_2[34 * k + 17 +: 17];
      assign sums_of_4[18 * k +: 18] = four_q;
    end
    for (k = 0; k < 2; k = k + 1) begin : g_sums_of_8
      reg [18:0] eight_q;
      always @(posedge aclk) eight_q <= sums_of_4[36 * k +: 18] + sums_of_4[36 * k + 18 +: 18];
      assign sums_of_8[19 * k +: 19] = eight_q;
    end
  endgenerate

  always @(posedge aclk) begin
    sum_q    <= sums_of_8[18:0] + sums_of_8[37:19];
    excess_q <= {1'b0, sum_q} - threshold;
    verdict  <= {!excess_q[20] && excess_q != 21'd0, excess_q == 21'd0};
  end

endmodule

`default_nettype wire
