// embedded_multiplier_tb: the cell of a family, here named embedded_multiplier_cell, against the
// template that it replaces, at widths around those of one multiplier. Factors are corners, powers
// of two and random numbers.
`default_nettype none

module embedded_multiplier_tb #(
  parameter WIDEST = 18  // bits of the widest factor of one multiplier
);

  reg aclk = 0;
  reg [18:0] a, b;
  integer cycle, seed = 1;
  wire [24:0] differs;

  genvar first, second;
  generate
    for (first = 0; first < 5; first = first + 1) begin : g_first
      for (second = 0; second < 5; second = second + 1) begin : g_second
        localparam A = (first == 0) ? 1 : (first == 1) ? 7 : first + WIDEST - 3;
        localparam B = (second == 0) ? 1 : (second == 1) ? 7 : second + WIDEST - 3;

        wire [32*(A+B)-1:0] expected, products;

        embedded_multiplier_modes #(.A_WIDTH(A), .B_WIDTH(B)) templates
          (.aclk(aclk), .a(a[A-1:0]), .b(b[B-1:0]), .products(expected));
        embedded_multiplier_cell_modes #(.A_WIDTH(A), .B_WIDTH(B)) cells
          (.aclk(aclk), .a(a[A-1:0]), .b(b[B-1:0]), .products(products));

        assign differs[5*first+second] = products !== expected;
      end
    end
  endgenerate

  initial begin
    for (cycle = 0; cycle < 80; cycle = cycle + 1) begin
      case (cycle % 4)
        0: begin a = $random(seed); b = $random(seed); end
        1: {a, b} = {{19{cycle[2]}}, {19{cycle[3]}}};
        2: {a, b} = {19'd1 << (cycle / 4 % 19), 19'h7ffff};
        default: {a, b} = {19'h7ffff, 19'd1 << (cycle / 4 % 19)};
      endcase
      #1 aclk = 1;
      #1 aclk = 0;
      if ((cycle >= 3) && (differs != 0)) begin
        $display("cycle %0d: the cell differs from the template", cycle);
        $finish(0);
      end
    end
    $display("all equal");
    $finish(0);
  end

endmodule

`default_nettype wire
