// fp_selected_sum_tb: the cell of a family, here named fp_selected_sum_cell, against the template
// that it replaces, at the fewest places, both parities and many places. Operands are random
// numbers, and numbers whose carries go through all places.
`default_nettype none

module fp_selected_sum_tb #(
  parameter WIDEST = 60
);

  reg              aclk = 0;
  reg [WIDEST-1:0] a, b, c;
  reg              select, carry;
  integer          cycle, seed = 1;
  wire [4:0]       differs;

  genvar k;
  generate
    for (k = 0; k < 5; k = k + 1) begin : g_width
      localparam WIDTH = (k < 3) ? k + 2 : WIDEST + k - 4;

      wire [2*WIDTH-1:0] expected, sums;

      fp_selected_sum_modes #(.WIDTH(WIDTH)) templates
        (.aclk(aclk), .a(a[WIDTH-1:0]), .select(select), .b(b[WIDTH-1:0]), .c(c[WIDTH-1:0]),
         .carry(carry), .sums(expected));
      fp_selected_sum_cell_modes #(.WIDTH(WIDTH)) cells
        (.aclk(aclk), .a(a[WIDTH-1:0]), .select(select), .b(b[WIDTH-1:0]), .c(c[WIDTH-1:0]),
         .carry(carry), .sums(sums));

      assign differs[k] = sums !== expected;
    end
  endgenerate

  initial begin
    for (cycle = 0; cycle < 400; cycle = cycle + 1) begin
      {select, carry} = $random(seed);
      a = {$random(seed), $random(seed)};
      b = {$random(seed), $random(seed)};
      c = {$random(seed), $random(seed)};
      if (cycle % 4 == 1) b = ~a;
      if (cycle % 4 == 2) c = ~a;
      #1 if ((cycle >= 1) && (differs != 0)) begin
        $display("cycle %0d: the cell differs from the template", cycle);
        $finish(0);
      end
      aclk = 1;
      #1 aclk = 0;
    end
    $display("all equal");
    $finish(0);
  end

endmodule

`default_nettype wire
