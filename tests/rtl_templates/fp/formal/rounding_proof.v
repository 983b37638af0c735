// rounding_proof: for every pair of operands fp_add (a sum or a difference), fp_multiply, fp_square
// and fp_compare, with gradual underflow and no cuts, give the results of integers. A finite number
// is an integer of units, of the smallest subnormal number each; so is a sum, and a product is an
// integer of units / 2^FRACTION. The result must be the nearest number of at most PRECISION digits
// (of two equally near ones the even one), or infinity if that is beyond the largest number.
`default_nettype none

module rounding_proof #(
  parameter EXPONENT_BITS = 3,
  parameter PRECISION     = 4,
  parameter OPERATION     = 0  // 0: a + b, 1: a - b, 2: a * b, 3: a * a, 4: the order of a and b
) (
  input wire                               aclk,
  input wire [EXPONENT_BITS+PRECISION-1:0] next_a,
  input wire [EXPONENT_BITS+PRECISION-1:0] next_b
);

  localparam PACKED    = EXPONENT_BITS + PRECISION;
  localparam MAGNITUDE = PACKED - 1;
  localparam FRACTION  = (1 << (EXPONENT_BITS - 1)) + PRECISION - 3;
  localparam BITS      = (1 << EXPONENT_BITS) + PRECISION - 3;  // bits of the largest number
  localparam EXACT     = 2 * BITS;
  localparam MULTIPLIES = (OPERATION == 2) || (OPERATION == 3);

  localparam [EXACT-1:0] LARGEST = ((1 << PRECISION) - 1) << (BITS - PRECISION);

  // A number's size in units. It means nothing for an infinity or a NaN.
  function [EXACT-1:0] size_of(input [PACKED-1:0] number);
    reg [EXPONENT_BITS-1:0] exponent;
    reg [EXACT-1:0]         significand;
    begin
      exponent    = number[MAGNITUDE-1-:EXPONENT_BITS];
      significand = number[PRECISION-2:0];
      size_of     = (exponent == 0) ? significand
                                    : (significand + (1 << (PRECISION - 1))) << (exponent - 1);
    end
  endfunction

  // The nearest number to exact / 2^FRACTION units, in units. Each quantum is tried: the right one
  // is the smallest that leaves PRECISION digits.
  function [EXACT:0] nearest(input [EXACT-1:0] exact);
    integer         digits;  // number of dropped digits
    reg [EXACT-1:0] kept;
    reg [EXACT-1:0] rest;
    reg [EXACT-1:0] half;
    reg             found;
    begin
      nearest = 0;
      found   = 1'b0;
      for (digits = FRACTION; digits < EXACT; digits = digits + 1) begin
        kept = exact >> digits;
        if (!found && (kept < (1 << PRECISION))) begin
          found   = 1'b1;
          rest    = exact - (kept << digits);
          half    = 1 << (digits - 1);
          if ((rest > half) || ((rest == half) && kept[0])) kept = kept + 1;
          nearest = kept << (digits - FRACTION);
        end
      end
    end
  endfunction

  function is_infinite(input [PACKED-1:0] number);
    is_infinite = (&number[MAGNITUDE-1-:EXPONENT_BITS]) && (number[PRECISION-2:0] == 0);
  endfunction

  function is_nan(input [PACKED-1:0] number);
    is_nan = (&number[MAGNITUDE-1-:EXPONENT_BITS]) && (number[PRECISION-2:0] != 0);
  endfunction

  reg [PACKED-1:0] a = 0;
  reg [PACKED-1:0] b = 0;

  always @(posedge aclk) begin
    a <= next_a;
    b <= next_b;
  end

  wire [PACKED-1:0] second = (OPERATION == 3) ? a : b;
  wire              a_sign = a[PACKED-1];
  wire              b_sign = second[PACKED-1] ^ (OPERATION == 1);
  wire [EXACT-1:0]  a_size = size_of(a);
  wire [EXACT-1:0]  b_size = size_of(second);
  wire              some_nan      = is_nan(a) || is_nan(second);
  wire              some_infinite = is_infinite(a) || is_infinite(second);

  generate
    if (OPERATION == 4) begin : g_order
      wire [1:0] verdict;

      fp_compare #(
        .EXPONENT_BITS(EXPONENT_BITS),
        .PRECISION    (PRECISION),
        .GRADUAL      (1)
      ) dut (
        .aclk   (aclk),
        .a      (a),
        .b      (b),
        .verdict(verdict)
      );

      // The size of an infinity is above all others.
      wire equal = ((a_size == b_size) && ((a_sign == b_sign) || (a_size == 0)));
      wire less  = (a_sign != b_sign) ? a_sign : a_sign ? (a_size > b_size) : (a_size < b_size);

      always @(*) begin
        assert (verdict == (some_nan ? 2'd3 : equal ? 2'd1 : less ? 2'd0 : 2'd2));
        cover (some_infinite && (verdict == 2'd1));
        cover ((a_size == 0) && (a_sign != b_sign) && (verdict == 2'd1));
      end
    end else begin : g_value
      wire [PACKED-1:0] y;
      wire              exceptional;

      if (OPERATION < 2) begin : g_sum
        fp_add #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .GRADUAL      (1),
          .SUBTRACT     (OPERATION)
        ) dut (
          .aclk       (aclk),
          .a          (a),
          .b          (b),
          .y          (y),
          .exceptional(exceptional)
        );
      end else if (OPERATION == 2) begin : g_product
        fp_multiply #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .GRADUAL      (1),
          .EMBEDDED     (0)
        ) dut (
          .aclk       (aclk),
          .a          (a),
          .b          (b),
          .y          (y),
          .exceptional(exceptional)
        );
      end else begin : g_square
        fp_square #(
          .EXPONENT_BITS(EXPONENT_BITS),
          .PRECISION    (PRECISION),
          .GRADUAL      (1),
          .EMBEDDED     (0)
        ) dut (
          .aclk       (aclk),
          .a          (a),
          .y          (y),
          .exceptional(exceptional)
        );
      end

      wire larger_a = a_size >= b_size;
      wire unlike   = a_sign != b_sign;

      wire [EXACT-1:0] sum = unlike ? (larger_a ? a_size - b_size : b_size - a_size)
                                    : a_size + b_size;
      wire [EXACT-1:0] exact = MULTIPLIES ? a_size * b_size : sum << FRACTION;
      wire [EXACT:0]   due   = nearest(exact);

      // The result is a NaN: infinity - infinity, infinity * 0.
      wire invalid = MULTIPLIES ? some_infinite && ((a_size == 0) || (b_size == 0))
                                : is_infinite(a) && is_infinite(second) && unlike;
      wire nan      = some_nan || invalid;
      wire infinite = some_infinite || (due > LARGEST);
      // A sum has the sign of its larger operand, and + if unlike operands cancel.
      wire sign = MULTIPLIES    ? a_sign ^ b_sign
                : (sum == 0)    ? a_sign && b_sign
                : is_infinite(a) ? a_sign
                : is_infinite(second) ? b_sign
                : larger_a      ? a_sign : b_sign;

      always @(*) begin
        if (nan) begin
          assert (is_nan(y));
        end else begin
          assert (y[PACKED-1] == sign);
          assert (!is_nan(y) && (is_infinite(y) == infinite));
          if (!infinite) assert (size_of(y) == due);
        end
        cover (!nan && infinite && !some_infinite);
        cover (!nan && !infinite && (due != 0) && (due < (1 << (PRECISION - 1))));
        if (OPERATION != 3) cover (invalid);
      end
    end
  endgenerate

endmodule

`default_nettype wire
