// axi_lite_reads_proof: each accepted read gets one word, the one that was found for its address,
// and each write one refusal. Nothing is answered that was not asked. An offer stays until it is
// taken, and nothing waits for ever. The answering logic behind the bus takes as long as it likes.
`default_nettype none

module axi_lite_reads_proof (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       aw_valid,
  input wire       w_valid,
  input wire       b_ready,
  input wire       ar_valid,
  input wire       ar_address,
  input wire       r_ready,
  input wire       readable,
  input wire       finishing,  // a read that is under way behind the bus ends
  input wire [1:0] word        // the word of that read
);

  localparam [1:0] NONE = 0;
  localparam MOST_QUIET = 5;

  wire        aw_ready;
  wire        w_ready;
  wire [1:0]  b_response;
  wire        b_valid;
  wire        ar_ready;
  wire [31:0] r_data;
  wire [1:0]  r_response;
  wire        r_valid;
  wire        read_start;
  wire        read_address;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;
  reg        asked   = 1'b0;  // a read is under way behind the bus
  wire       done    = asked && finishing;

  axi_lite_reads #(
    .ADDRESS_BITS(1)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axi_awaddr (1'b0),
    .s_axi_awprot (3'd0),
    .s_axi_awvalid(aw_valid),
    .s_axi_awready(aw_ready),
    .s_axi_wdata  (32'd0),
    .s_axi_wstrb  (4'd0),
    .s_axi_wvalid (w_valid),
    .s_axi_wready (w_ready),
    .s_axi_bresp  (b_response),
    .s_axi_bvalid (b_valid),
    .s_axi_bready (b_ready),
    .s_axi_araddr (ar_address),
    .s_axi_arprot (3'd0),
    .s_axi_arvalid(ar_valid),
    .s_axi_arready(ar_ready),
    .s_axi_rdata  (r_data),
    .s_axi_rresp  (r_response),
    .s_axi_rvalid (r_valid),
    .s_axi_rready (r_ready),
    .readable     (readable),
    .read_start   (read_start),
    .read_address (read_address),
    .read_done    (done),
    .read_word    ({30'd0, word})
  );

  // The reads that were taken and are not answered yet, and the word that was found.
  reg  [1:0] addresses = NONE;
  reg  [1:0] data      = NONE;
  reg  [1:0] reads     = NONE;
  reg        address;
  reg        found     = 1'b0;
  reg  [1:0] found_word;
  reg        found_address;
  reg        was_unreadable = 1'b0;
  // The channels that waited in the cycle before.
  reg        aw_waited = 1'b0;
  reg        w_waited  = 1'b0;
  reg        ar_waited = 1'b0;
  reg        ar_waited_address;
  reg        b_waited  = 1'b0;
  reg        r_waited  = 1'b0;
  reg [31:0] r_waited_data;
  reg  [2:0] quiet     = 3'd0;  // cycles in which nothing moves though everybody would
  wire       aw_taken  = aw_valid && aw_ready;
  wire       w_taken   = w_valid && w_ready;
  wire       b_leaves  = b_valid && b_ready;
  wire       ar_taken  = ar_valid && ar_ready;
  wire       r_leaves  = r_valid && r_ready;
  wire       moves     = aw_taken || b_leaves || ar_taken || r_leaves || read_start || done;
  wire       wants     = (ar_valid && readable) || (reads != NONE) || (aw_valid && w_valid);
  wire       calm      = r_ready && b_ready && (finishing || !asked);

  always @(posedge aclk) begin
    started           <= 1'b1;
    aw_waited         <= aresetn && aw_valid && !aw_ready;
    w_waited          <= aresetn && w_valid && !w_ready;
    ar_waited         <= aresetn && ar_valid && !ar_ready;
    ar_waited_address <= ar_address;
    b_waited          <= aresetn && b_valid && !b_ready;
    r_waited          <= aresetn && r_valid && !r_ready;
    r_waited_data     <= r_data;
    was_unreadable    <= !readable;
    if (!aresetn) begin
      addresses <= NONE;
      data      <= NONE;
      reads     <= NONE;
      asked     <= 1'b0;
      found     <= 1'b0;
      quiet     <= 3'd0;
    end else begin
      addresses <= addresses + {1'b0, aw_taken} - {1'b0, b_leaves};
      data      <= data + {1'b0, w_taken} - {1'b0, b_leaves};
      reads     <= reads + {1'b0, ar_taken} - {1'b0, r_leaves};
      asked     <= read_start || (asked && !finishing);
      found     <= done || (found && !r_leaves);
      quiet     <= (wants && calm && !moves) ? quiet + 3'd1 : 3'd0;
    end
    if (ar_taken) begin
      address <= ar_address;
    end
    if (done) begin
      found_word    <= word;
      found_address <= read_address;
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!aw_valid);
      assume(!w_valid);
      assume(!ar_valid);
    end else begin
      assume(!aw_waited || aw_valid);
      assume(!w_waited || w_valid);
      assume(!ar_waited || (ar_valid && (ar_address == ar_waited_address)));
    end
    if (started && aresetn) begin
      one_read_at_a_time: assert(!ar_taken || (reads == NONE));
      no_word_made_up: assert(!r_valid || (reads != NONE));
      word_was_found: assert(!r_valid || (found && (r_data == {30'd0, found_word})));
      for_its_address: assert(!r_valid || (found_address == address));
      asks_once: assert(!read_start || (!asked && !found && (reads != NONE)));
      address_stays: assert(!asked || (read_address == address));
      reads_are_okay: assert(r_response == 2'd0);
      waits_until_readable: assert(!ar_taken || !was_unreadable);
      no_answer_made_up: assert(!b_valid || ((addresses != NONE) && (data != NONE)));
      few_writes: assert((addresses < 2'd2) && (addresses == data));
      writes_are_refused: assert(b_response == 2'd2);
      word_holds: assert(!r_waited || (r_valid && (r_data == r_waited_data)));
      answer_holds: assert(!b_waited || b_valid);
      keeps_moving: assert(quiet < MOST_QUIET);
      can_read: cover(r_leaves && (r_data == 32'd2) && address);
      can_read_again: cover(ar_taken && found_word == 2'd1);
      can_wait: cover(r_waited && b_waited);
      can_refuse: cover(b_leaves);
    end
  end

endmodule

`default_nettype wire
