// counter_scan: shows COUNTERS free-running counters one after the other, one in every second
// cycle, in endless rounds. A count is shown LEVELS cycles after it was sampled.
// A token goes from counter to counter, and a tree of registered ORs collects the one count that
// has it. So no net but the reset reaches all counters, however many there are.
// Reset begins a round with counter 0; `valid` is low until its count arrives.
`default_nettype none

module counter_scan #(
  parameter COUNTERS = 4,   // counters that are shown, 1 or more
  parameter WIDTH = 8,      // bits of a count, 1 or more
  parameter INDEX_BITS = 2  // bits of a counter's number, 1 to 30; 2^INDEX_BITS >= COUNTERS
) (
  input  wire                      aclk,
  input  wire                      aresetn,
  input  wire [COUNTERS*WIDTH-1:0] counts,
  output wire                      valid,
  output wire [INDEX_BITS-1:0]     index,
  output wire [WIDTH-1:0]          count
);

  // A LUT of six inputs ORs one bit of three counts, each gated by its token, or one bit of six
  // words that are gated already.
  localparam LEAF_RADIX  = 3;
  localparam INNER_RADIX = 6;

  function integer words_after;  // words that are left after `levels` levels of ORs
    input integer levels;
    integer k;
    begin
      words_after = COUNTERS;
      for (k = 0; k < levels; k = k + 1) begin
        if (k == 0) begin
          words_after = (words_after + LEAF_RADIX - 1) / LEAF_RADIX;
        end else begin
          words_after = (words_after + INNER_RADIX - 1) / INNER_RADIX;
        end
      end
    end
  endfunction

  function integer levels_of_tree;
    input integer words;
    integer left;
    begin
      levels_of_tree = 1;
      left = (words + LEAF_RADIX - 1) / LEAF_RADIX;
      while (left > 1) begin
        left = (left + INNER_RADIX - 1) / INNER_RADIX;
        levels_of_tree = levels_of_tree + 1;
      end
    end
  endfunction

  localparam LEVELS = levels_of_tree(COUNTERS);
  localparam LAST   = COUNTERS - 1;
  localparam PLACES = 2 * COUNTERS;

  localparam [INDEX_BITS-1:0] ZERO = 0;
  localparam [INDEX_BITS-1:0] ONE  = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNTERS < 1) begin : g_refused_counters COUNTERS_is_below_1 refused (); end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((INDEX_BITS < 1) || (INDEX_BITS > 30)) begin : g_refused_index_bits
      INDEX_BITS_is_not_1_to_30 refused ();
    end else if (((COUNTERS - 1) >>> INDEX_BITS) > 0) begin : g_refused_last_index
      INDEX_BITS_is_too_small_for_COUNTERS refused ();
    end
  endgenerate

  // The token moves on by one place in each cycle; every second place belongs to a counter.
  reg  [PLACES-1:0]     token_q;
  reg  [INDEX_BITS-1:0] index_q;
  reg                   at_counter_q;
  wire [PLACES:0]       moved       = {token_q, token_q[PLACES-1]};
  wire [PLACES-1:0]     first_place = 1;

  always @(posedge aclk) begin
    if (!aresetn) begin
      token_q      <= first_place;
      index_q      <= ZERO;
      at_counter_q <= 1'b1;
    end else begin
      token_q      <= moved[PLACES-1:0];
      at_counter_q <= !at_counter_q;
      if (!at_counter_q) begin
        index_q <= (index_q == LAST[INDEX_BITS-1:0]) ? ZERO : index_q + ONE;
      end
    end
  end

  wire unused_moved = moved[PLACES];

  valid_delay_line #(
    .LENGTH(LEVELS)
  ) valid_beside_tree (
    .aclk   (aclk),
    .aresetn(aresetn),
    .d      (at_counter_q),
    .q      (valid)
  );

  delay_line #(
    .WIDTH (INDEX_BITS),
    .LENGTH(LEVELS)
  ) index_beside_tree (
    .aclk(aclk),
    .d   (index_q),
    .q   (index)
  );

  // The words of a level stand side by side. At most one of them is not zero.
  genvar level;
  genvar node;
  generate
    for (level = 0; level < LEVELS; level = level + 1) begin : g_level
      localparam WORDS = words_after(level);
      localparam NODES = words_after(level + 1);
      localparam RADIX = (level == 0) ? LEAF_RADIX : INNER_RADIX;

      wire [WORDS*WIDTH-1:0] words;
      wire [NODES*WIDTH-1:0] joined;

      if (level == 0) begin : g_leaves
        for (node = 0; node < COUNTERS; node = node + 1) begin : g_gate
          wire [WIDTH-1:0] gate = {WIDTH{token_q[2*node]}};

          assign words[node*WIDTH +: WIDTH] = counts[node*WIDTH +: WIDTH] & gate;
        end
      end else begin : g_inner
        assign words = g_level[level-1].joined;
      end

      for (node = 0; node < NODES; node = node + 1) begin : g_node
        localparam FIRST  = node * RADIX;
        localparam FAN_IN = (WORDS - FIRST < RADIX) ? WORDS - FIRST : RADIX;

        integer         k;
        reg [WIDTH-1:0] any;
        reg [WIDTH-1:0] any_q;

        always @* begin
          any = {WIDTH{1'b0}};
          for (k = 0; k < FAN_IN; k = k + 1) begin
            any = any | words[(FIRST+k)*WIDTH +: WIDTH];
          end
        end

        always @(posedge aclk) begin
          any_q <= any;
        end

        assign joined[node*WIDTH +: WIDTH] = any_q;
      end
    end
  endgenerate

  assign count = g_level[LEVELS-1].joined;

endmodule

`default_nettype wire
