// balanced_tree_test: counts the verdicts of balanced_tree on each pair of descriptors.hex.
`default_nettype none

module balanced_tree_test;
  localparam items   = 644;
  localparam latency = 8;

  reg          aclk = 1'b0;
  reg  [7:0]   bytes [0:16*items-1];
  reg  [127:0] di, dj;
  wire [1:0]   verdict;
  integer      i, j, k, entered, less, equal, greater;

  balanced_tree tree (.aclk(aclk), .di(di), .dj(dj), .verdict(verdict));

  // A cycle, and the verdict of the pair that entered as the first of the last eight.
  task clock;
    begin
      #1 aclk = 1'b1;
      #1 aclk = 1'b0;
      entered = entered + 1;
      if (entered >= latency) begin
        less    = less + (verdict === 2'd0);
        equal   = equal + (verdict === 2'd1);
        greater = greater + (verdict === 2'd2);
      end
    end
  endtask

  initial begin
    $readmemh("descriptors.hex", bytes);
    entered = 0;
    less    = 0;
    equal   = 0;
    greater = 0;
    for (i = 0; i < items; i = i + 1) begin
      for (j = i + 1; j < items; j = j + 1) begin
        for (k = 0; k < 16; k = k + 1) begin
          di[8*k+:8] = bytes[16*i+k];
          dj[8*k+:8] = bytes[16*j+k];
        end
        clock;
      end
    end
    for (i = 1; i < latency; i = i + 1) clock;
    $display("less %0d, equal %0d, greater %0d", less, equal, greater);
  end
endmodule

`default_nettype wire
