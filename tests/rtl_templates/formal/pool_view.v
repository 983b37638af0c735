// pool_view: the contents of a slot_pool of four slots, read from its registers. Place 0 is the
// pool's output, place k + 1 is place k of its queue. From the cycle in which `started` is 1, this
// module asserts where the queue's first lap ends.
`default_nettype none

module pool_view (
  input  wire       started,
  input  wire [2:0] write_q,
  input  wire [2:0] read_q,
  input  wire       valid_q,
  input  wire       first_lap_q,
  input  wire [7:0] words,   // the memory's words
  input  wire [1:0] m_slot,
  output reg  [4:0] holds,
  output reg  [9:0] slots
);

  wire [2:0] waiting = write_q - read_q;
  reg  [1:0] place;
  reg  [2:0] pointer;
  integer    k;

  always @* begin
    holds      = 5'd0;
    slots      = {words, m_slot};
    holds[0]   = valid_q;
    for (k = 0; k < 4; k = k + 1) begin
      place      = k - read_q[1:0];
      pointer    = read_q + {1'b0, place};
      holds[k+1] = ({1'b0, place} < waiting);
      if (first_lap_q && !pointer[2]) begin
        slots[2*(k+1) +: 2] = k;  // nothing was written there: place k stands for slot k
      end
    end
    if (started) begin
      lemma_pool_has_places: assert(waiting <= 3'd4);
      lemma_first_lap: assert(!first_lap_q || ((read_q != 3'd0) && (read_q <= 3'd4) &&
                                              ((write_q[2]) || (write_q == 3'd0))));
    end
  end

endmodule

`default_nettype wire
