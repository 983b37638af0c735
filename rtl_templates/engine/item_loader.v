// item_loader: takes the items of one set and numbers them from 0 in the order of their arrival.
// Items beyond CAPACITY are accepted but not kept, and raise `overrun`. After the item with tlast
// nothing is accepted until `set_closed`. `set_closed` and reset forget the set.
`default_nettype none

module item_loader #(
  parameter CAPACITY = 1024,  // items of the largest set, 2 to 2^INDEX_BITS
  parameter INDEX_BITS = 10   // bits of an item's index, 1 to 30
) (
  input  wire                  aclk,
  input  wire                  aresetn,
  input  wire                  s_axis_tvalid,
  output wire                  s_axis_tready,
  input  wire                  s_axis_tlast,
  input  wire                  write_ready,  // the memory's port is free
  output wire                  kept,         // an item is taken in this cycle and belongs to the set
  output wire [INDEX_BITS-1:0] kept_index,
  output wire                  place_free,   // no item of the set is stored at kept_index
  output wire                  ended,        // the set's last item is taken in this cycle
  input  wire                  set_closed,
  output wire                  busy,
  output wire                  overrun
);

  localparam [INDEX_BITS:0] ONE  = 1;
  localparam [INDEX_BITS:0] FULL = CAPACITY[INDEX_BITS:0];

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (CAPACITY < 2) begin : g_refused_capacity CAPACITY_is_below_2 refused (); end
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (INDEX_BITS > 30) begin : g_refused_index_shift INDEX_BITS_is_above_30 refused (); end
    if (((CAPACITY - 1) >>> INDEX_BITS) > 0)
      begin : g_refused_last_item INDEX_BITS_is_too_small_for_CAPACITY refused (); end
  endgenerate

  reg  [INDEX_BITS:0] kept_q;      // items of the set so far
  reg                 complete_q;
  reg                 overrun_q;
  wire                accept = s_axis_tvalid && s_axis_tready;
  wire                full   = (kept_q == FULL);

  assign s_axis_tready = !complete_q && write_ready;
  assign kept          = accept && !full;
  assign kept_index    = kept_q[INDEX_BITS-1:0];
  assign place_free    = !full;
  assign ended         = accept && s_axis_tlast;
  assign busy          = (kept_q != {(INDEX_BITS+1){1'b0}});
  assign overrun       = overrun_q;

  always @(posedge aclk) begin
    if (!aresetn || set_closed) begin
      kept_q     <= {(INDEX_BITS+1){1'b0}};
      complete_q <= 1'b0;
      overrun_q  <= 1'b0;
    end else if (accept) begin
      complete_q <= s_axis_tlast;
      if (full) begin
        overrun_q <= 1'b1;
      end else begin
        kept_q <= kept_q + ONE;
      end
    end
  end

endmodule

`default_nettype wire
