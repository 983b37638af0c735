// fp_split_row: fp_product_row, whose places from SPLIT up are those of the inputs `late_`, the
// factor and the digit of the cycle before. SPLIT is above the first two places; below WIDTH only of
// a square; at WIDTH or above there is no split.
// Combinational.
`default_nettype none

module fp_split_row #(
  parameter PRECISION = 24,
  parameter SQUARE    = 0,
  parameter SIGNED    = 0,
  parameter CODE      = 0,
  parameter ROW       = 0,
  parameter WIDTH     = PRECISION + 6,
  parameter SPLIT     = WIDTH
) (
  input  wire [PRECISION-1:0] a,
  input  wire [PRECISION-1:0] b,
  input  wire [2:0]           digit,
  input  wire [2:0]           previous,
  input  wire [PRECISION-1:0] late_a,
  input  wire [2:0]           late_digit,
  output wire [WIDTH-1:0]     row
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (SPLIT < 2) begin : g_refused_split
      SPLIT_is_below_2 refused ();
    end
    if ((SPLIT < WIDTH) && (SQUARE == 0)) begin : g_refused_product
      SPLIT_of_no_square refused ();
    end
  endgenerate

  wire [WIDTH-1:0] early;

  fp_product_row #(
    .PRECISION(PRECISION),
    .SQUARE   (SQUARE),
    .SIGNED   (SIGNED),
    .CODE     (CODE),
    .ROW      (ROW),
    .WIDTH    (WIDTH)
  ) early_row (
    .a       (a),
    .b       (b),
    .digit   (digit),
    .previous(previous),
    .row     (early)
  );

  generate
    if (SPLIT >= WIDTH) begin : g_whole
      wire unused_late = ^{late_a, late_digit};

      assign row = early;
    end else begin : g_split
      wire [WIDTH-1:0] late;
      wire             unused_places = ^{early[WIDTH-1:SPLIT], late[SPLIT-1:0]};

      fp_product_row #(
        .PRECISION(PRECISION),
        .SQUARE   (SQUARE),
        .SIGNED   (SIGNED),
        .CODE     (CODE),
        .ROW      (ROW),
        .WIDTH    (WIDTH)
      ) late_row (
        .a       (late_a),
        .b       (b),
        .digit   (late_digit),
        .previous(3'b000),  // what it is owed stands in the row's first places
        .row     (late)
      );

      assign row = {late[WIDTH-1:SPLIT], early[SPLIT-1:0]};
    end
  endgenerate

endmodule

`default_nettype wire
