// item_loader_proof: item_loader keeps the first CAPACITY items of each set under the numbers 0, 1, ...,
// takes the others without keeping them and says so, and takes nothing between a set's last item and
// `set_closed`, nor while the memory is busy. It calls a place free only if no item of the set is there.
`default_nettype none

module item_loader_proof #(
  parameter CAPACITY = 3,
  parameter INDEX_BITS = 2
) (
  input wire aclk,
  input wire aresetn_later,
  input wire s_valid,
  input wire s_last,
  input wire write_ready,
  input wire close
);

  localparam [INDEX_BITS+1:0] NONE = 0;
  localparam [INDEX_BITS+1:0] ONE  = 1;
  localparam [INDEX_BITS+1:0] FULL = CAPACITY[INDEX_BITS+1:0];

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;
  wire                  s_ready;
  wire                  kept;
  wire [INDEX_BITS-1:0] kept_index;
  wire                  place_free;
  wire                  ended;
  wire                  busy;
  wire                  overrun;
  reg                   complete = 1'b0;
  wire                  set_closed = close && complete;

  item_loader #(
    .CAPACITY  (CAPACITY),
    .INDEX_BITS(INDEX_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tlast (s_last),
    .write_ready  (write_ready),
    .kept         (kept),
    .kept_index   (kept_index),
    .place_free   (place_free),
    .ended        (ended),
    .set_closed   (set_closed),
    .busy         (busy),
    .overrun      (overrun)
  );

  reg  [INDEX_BITS+1:0] taken = NONE;  // items of the set; FULL + 1 if there are more than fit
  reg                   again = 1'b0;  // a set was closed before
  wire                  take  = s_valid && s_ready;

  always @(posedge aclk) begin
    started <= 1'b1;
    again   <= aresetn && (again || set_closed);
    if (!aresetn || set_closed) begin
      taken    <= NONE;
      complete <= 1'b0;
    end else if (take) begin
      taken    <= (taken > FULL) ? taken : taken + ONE;
      complete <= s_last;
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      keeps_what_fits: assert(kept == (take && (taken < FULL)));
      numbers_in_order: assert(!kept || ({2'b00, kept_index} == taken));
      place_is_free: assert(!place_free || ({2'b00, kept_index} == taken));
      place_for_kept: assert(!kept || place_free);
      takes_when_it_can: assert(s_ready == (write_ready && !complete));
      end_told: assert(ended == (take && s_last));
      busy_with_a_set: assert(busy == (taken != NONE));
      overrun_told: assert(overrun == (taken > FULL));
      can_keep_all: cover(kept && (taken == FULL - ONE));
      can_overrun: cover(overrun && ended);
      can_load_again: cover(again && kept && (taken == NONE));
      can_refuse: cover(s_valid && !s_ready && !complete);
    end
  end

endmodule

`default_nettype wire
