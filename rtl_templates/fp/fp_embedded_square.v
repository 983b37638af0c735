// fp_embedded_square: the square of a significand, by multipliers FACTOR_A by FACTOR_B wide.
// Latency: the population count of CUTS (eight bits); initiation interval 1; no reset.
//
// The significand is cut into PARTS parts. For multipliers of 24 by 17, 53 bits become p0 and p1 of
// 17 bits and p2 of 19:
//
//     a * a =   p0^2 + p1^2 << 34 + p2^2 << 68           squares, which do not overlap
//             + 2 * (p0 p1 << 17 + p0 p2 << 34 + p1 p2 << 51)
//                    place 1       place 2       place 3
//
// The products of two different parts form one chain, by rising place. The sum of the previous
// links is added to the next product, at each new place after a shift down by FACTOR_B bits. The
// device's adder behind the multiplier does that if there is one. A cut between two links delays
// the operands of all later links.
`default_nettype none

module fp_embedded_square #(
  parameter       PRECISION   = 53,  // digits of the significand, 2 or more
  parameter       FACTOR_A    = 24,  // first factor of `*`, as wide as any part or wider
  parameter       FACTOR_B    = 17,  // second factor of `*`, 1 bit or more
  // Number of parts of the significand, 2 or more. The last part has 1 to FACTOR_B + 2 bits, the
  // others have FACTOR_B.
  parameter       PARTS       = 3,
  parameter       LEADING_ONE = 1,   // 1 promises a leading one, or `product` is undefined
  // A register at cut k if bit k is 1. Cut 0 is in front of the multipliers and cut 1 behind them,
  // cuts 2 to 5 are behind the first four links. Cut 6 halves the last sum, of the squares and the
  // chain (fp_halved_sum); cut 7 is behind it.
  parameter [7:0] CUTS        = 8'b0
) (
  input  wire                   aclk,
  input  wire [PRECISION-1:0]   a,
  output wire [2*PRECISION-1:0] product
);

  function integer smaller(input integer first, input integer second);
    smaller = (first < second) ? first : second;
  endfunction

  function integer bits_of(input integer value);
    integer rest;
    begin
      bits_of = 0;
      for (rest = value; rest > 0; rest = rest >> 1) bits_of = bits_of + 1;
    end
  endfunction

  localparam SQUARE = 2 * PRECISION;

  // The bits of the last part, and by how many they exceed the narrow side of a multiplier.
  localparam LAST   = PRECISION - (PARTS - 1) * FACTOR_B;
  localparam EXCESS = (LAST > FACTOR_B) ? LAST - FACTOR_B : 0;
  localparam WIDEST = FACTOR_B + EXCESS;

  // The links that have a cut of their own.
  localparam CUT_LINKS  = 4;
  localparam LAST_PLACE = 2 * PARTS - 3;

  // Bits of the sum of a link. It is less than PARTS / 2 + 1 products: at most PARTS / 2 are of one
  // place, and the places below add less than one.
  localparam WIDTH = FACTOR_B + WIDEST + bits_of(PARTS / 2);

  // The pairs of parts i < j whose places i + j are `place`: the first i, and how many.
  function integer first_part(input integer place);
    first_part = (place < PARTS) ? 0 : place - PARTS + 1;
  endfunction

  function integer links_at(input integer place);
    links_at = (place + 1) / 2 - first_part(place);
  endfunction

  function integer links_below(input integer place);
    integer k;
    begin
      links_below = 0;
      for (k = 1; k < place; k = k + 1) links_below = links_below + links_at(k);
    end
  endfunction

  function integer part_bits(input integer part);
    part_bits = (part == PARTS - 1) ? LAST : FACTOR_B;
  endfunction

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (PRECISION < 2) begin : g_refused_precision PRECISION_is_below_2 refused (); end
    if (FACTOR_B < 1) begin : g_refused_factor_b FACTOR_B_is_below_1 refused (); end
    if ((PARTS < 2) || (LAST < 1) || (EXCESS > 2) || (WIDEST > FACTOR_A))
      begin : g_refused_parts PARTS_do_not_fit_PRECISION_and_factors refused (); end
  endgenerate

  // The product's lowest bits are those of the squares: no product of two parts has a bit there.
  localparam COPIED = FACTOR_B + 1;

  wire [SQUARE-1:0]      squares;
  wire [SQUARE-1:COPIED] twice_products;

  genvar part;
  genvar place;
  genvar link;

  generate
    for (part = 0; part < PARTS; part = part + 1) begin : g_squares
      localparam A_BITS = part_bits(part);
      localparam B_BITS = smaller(A_BITS, FACTOR_B);

      wire [A_BITS-1:0]        factor;
      wire [A_BITS+B_BITS-1:0] partial;
      wire [2*A_BITS-1:0]      joined;

      fp_ranks #(
        .WIDTH(A_BITS),
        .COUNT(CUT_LINKS - 1),
        .CUTS (CUTS[CUT_LINKS:2])
      ) operand_ranks (
        .aclk(aclk),
        .d   (a[part*FACTOR_B+:A_BITS]),
        .q   (factor)
      );

      embedded_multiplier #(
        .A_WIDTH(A_BITS),
        .B_WIDTH(B_BITS),
        .CUTS   ({1'b0, CUTS[1:0]})
      ) multiplier (
        .aclk   (aclk),
        .a      (factor),
        .b      (factor[B_BITS-1:0]),
        .product(partial)
      );

      if (B_BITS == A_BITS) begin : g_whole
        assign joined = partial;
      end else begin : g_excess
        // The one or two leading bits times the part, added to the product's upper bits.
        localparam BITS = A_BITS - B_BITS;

        wire [A_BITS-1:0]      last_factor;
        wire                   first       = (LEADING_ONE != 0) || last_factor[A_BITS-1];
        wire [A_BITS-1:0]      times_first = last_factor & {A_BITS{first}};
        wire [A_BITS+BITS-1:0] times;
        wire [A_BITS+BITS-1:0] times_leading;

        fp_rank #(
          .WIDTH     (A_BITS),
          .REGISTERED(CUTS[0])
        ) factor_rank (
          .aclk(aclk),
          .d   (factor),
          .q   (last_factor)
        );

        if (BITS == 1) begin : g_one
          assign times = {1'b0, times_first};
        end else begin : g_two
          wire [A_BITS-1:0] times_second = last_factor & {A_BITS{last_factor[A_BITS-2]}};

          assign times = {1'b0, times_first, 1'b0} + {2'b00, times_second};
        end

        fp_rank #(
          .WIDTH     (A_BITS + BITS),
          .REGISTERED(CUTS[1])
        ) leading_rank (
          .aclk(aclk),
          .d   (times),
          .q   (times_leading)
        );

        assign joined = {{BITS{1'b0}}, partial} + {times_leading, {B_BITS{1'b0}}};
      end

      fp_rank #(
        .WIDTH     (2 * A_BITS),
        .REGISTERED(CUTS[CUT_LINKS+1])
      ) square_rank (
        .aclk(aclk),
        .d   (joined),
        .q   (squares[2*part*FACTOR_B+:2*A_BITS])
      );
    end

    for (place = 1; place <= LAST_PLACE; place = place + 1) begin : g_places
      localparam LINKS = links_at(place);

      for (link = 0; link < LINKS; link = link + 1) begin : g_links
        localparam I      = first_part(place) + link;
        localparam J      = place - I;
        localparam A_BITS = part_bits(J);
        localparam BELOW  = links_below(place) + link;
        localparam DELAYS = smaller(BELOW, CUT_LINKS);

        wire [A_BITS-1:0]          a_part;
        wire [FACTOR_B-1:0]        b_part;
        wire [A_BITS+FACTOR_B-1:0] partial;
        wire [WIDTH-1:0]           term = {{(WIDTH - A_BITS - FACTOR_B) {1'b0}}, partial};
        wire [WIDTH-1:0]           joined;
        wire [WIDTH-1:0]           sum;

        if (DELAYS > 0) begin : g_delayed
          fp_ranks #(
            .WIDTH(A_BITS + FACTOR_B),
            .COUNT(DELAYS),
            .CUTS (CUTS[DELAYS+1:2])
          ) operand_ranks (
            .aclk(aclk),
            .d   ({a[J*FACTOR_B+:A_BITS], a[I*FACTOR_B+:FACTOR_B]}),
            .q   ({a_part, b_part})
          );
        end else begin : g_immediate
          assign a_part = a[J*FACTOR_B+:A_BITS];
          assign b_part = a[I*FACTOR_B+:FACTOR_B];
        end

        embedded_multiplier #(
          .A_WIDTH(A_BITS),
          .B_WIDTH(FACTOR_B),
          .CUTS   ({1'b0, CUTS[1:0]})
        ) multiplier (
          .aclk   (aclk),
          .a      (a_part),
          .b      (b_part),
          .product(partial)
        );

        if (link > 0) begin : g_same_place
          assign joined = term + g_links[link-1].sum;
        end else if (place > 1) begin : g_next_place
          assign joined = term + {{FACTOR_B{1'b0}}, g_places[place-1].total[WIDTH-1:FACTOR_B]};
        end else begin : g_first
          assign joined = term;
        end

        if (BELOW < CUT_LINKS) begin : g_cut
          fp_rank #(
            .WIDTH     (WIDTH),
            .REGISTERED(CUTS[BELOW+2])
          ) link_rank (
            .aclk(aclk),
            .d   (joined),
            .q   (sum)
          );
        end else begin : g_uncut
          assign sum = joined;
        end
      end

      wire [WIDTH-1:0] total = g_links[LINKS-1].sum;

      // Bits that later links do not change are delayed to the last cut.
      localparam LINK_CUTS = smaller(links_below(place) + LINKS, CUT_LINKS);
      localparam ABOVE     = SQUARE - place * FACTOR_B - 1;
      localparam DONE      = (place < LAST_PLACE) ? FACTOR_B : smaller(WIDTH, ABOVE);

      if (LINK_CUTS < CUT_LINKS) begin : g_early
        fp_ranks #(
          .WIDTH(DONE),
          .COUNT(CUT_LINKS - LINK_CUTS),
          .CUTS (CUTS[CUT_LINKS+1:LINK_CUTS+2])
        ) done_ranks (
          .aclk(aclk),
          .d   (total[DONE-1:0]),
          .q   (twice_products[place*FACTOR_B+1+:DONE])
        );
      end else begin : g_late
        assign twice_products[place*FACTOR_B+1+:DONE] = total[DONE-1:0];
      end

      if ((place == LAST_PLACE) && (DONE < ABOVE)) begin : g_leading_zeros
        assign twice_products[SQUARE-1-:ABOVE-DONE] = 0;
      end

      if ((place == LAST_PLACE) && (DONE < WIDTH)) begin : g_never_set
        wire unused_zeros = ^total[WIDTH-1:DONE];
      end
    end
  endgenerate

  wire [SQUARE-1:COPIED] sum;
  wire [COPIED-1:0]      copied;

  fp_rank #(
    .WIDTH     (COPIED),
    .REGISTERED(CUTS[6])
  ) copied_rank (
    .aclk(aclk),
    .d   (squares[COPIED-1:0]),
    .q   (copied)
  );

  fp_halved_sum #(
    .WIDTH(SQUARE - COPIED),
    .CUTS (CUTS[6])
  ) halved_sum (
    .aclk (aclk),
    .a    (squares[SQUARE-1:COPIED]),
    .b    (twice_products),
    .carry(1'b0),
    .sum  (sum)
  );

  fp_rank #(
    .WIDTH     (SQUARE),
    .REGISTERED(CUTS[7])
  ) product_rank (
    .aclk(aclk),
    .d   ({sum, copied}),
    .q   (product)
  );

endmodule

`default_nettype wire
