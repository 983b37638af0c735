// lane_answers: collects the answers of references until a word is complete. LANES = 1: a queue of
// answers. LANES > 1: a word of a group of lanes waits here, from its exit on, with the verdicts of
// its decided lanes. It leaves once each of its undecided lanes has its answer.
//
// Answers come in the order of words and, in a word, of lanes, so an answer needs no lane number.
// The first answer of a word comes 2 cycles after the word or later. One answer per cycle; a word
// leaves 2 cycles after its last answer (LANES > 1: 3). There is room for 2^SLOT_BITS words, so
// with no more inside nothing is refused. Reset forgets all.
`default_nettype none

module lane_answers #(
  parameter LANES = 4,      // lanes in lock step, 1 to 64
  parameter SLOT_BITS = 5,  // 1 to 30: 2^SLOT_BITS comparisons may be in flight
  parameter WITH_SLOT = 1   // 1: slots are kept; 0: m_axis_slot is 0
) (
  input  wire                 aclk,
  input  wire                 aresetn,
  input  wire                 s_word_valid,
  input  wire [SLOT_BITS-1:0] s_word_slot,
  input  wire [LANES-1:0]     s_word_undecided,
  input  wire [2*LANES-1:0]   s_word_verdict,
  input  wire                 s_answer_valid,
  input  wire [SLOT_BITS-1:0] s_answer_slot,
  input  wire [1:0]           s_answer_verdict,
  output wire                 m_axis_tvalid,
  input  wire                 m_axis_tready,
  output wire [SLOT_BITS-1:0] m_axis_slot,
  output wire [LANES-1:0]     m_axis_recomputed,
  output wire [2*LANES-1:0]   m_axis_verdict
);

  localparam SLOTS_KEPT = (WITH_SLOT != 0) ? SLOT_BITS : 0;
  localparam FLAGS      = (LANES == 1) ? 0 : LANES;  // one lane needs no flag: it was recomputed
  localparam WIDTH      = SLOTS_KEPT + FLAGS + 2 * LANES;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
    if (SLOT_BITS < 1) begin : g_refused_slot_bits SLOT_BITS_is_below_1 refused (); end
  endgenerate

  wire                 entry_valid;
  wire [WIDTH-1:0]     entry;
  wire [WIDTH-1:0]     head;
  wire                 unused_ready;

  stream_fifo #(
    .WIDTH     (WIDTH),
    .DEPTH_BITS(SLOT_BITS)
  ) queue (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(entry_valid),
    .s_axis_tready(unused_ready),
    .s_axis_tdata (entry),
    .m_axis_tvalid(m_axis_tvalid),
    .m_axis_tready(m_axis_tready),
    .m_axis_tdata (head)
  );

  assign m_axis_verdict = head[2*LANES-1:0];

  genvar k;
  generate
    if (LANES == 1) begin : g_one_lane
      wire unused_word = &{s_word_valid, s_word_slot, s_word_undecided, s_word_verdict};

      assign entry_valid       = s_answer_valid;
      assign entry[1:0]        = s_answer_verdict;
      assign m_axis_recomputed = 1'b1;
      if (WITH_SLOT != 0) begin : g_slot
        assign entry[WIDTH-1 -: SLOT_BITS] = s_answer_slot;
      end else begin : g_no_slot
        wire unused_slot = &s_answer_slot;
      end
    end else begin : g_group
      localparam [LANES-1:0] ONE = 1;
      localparam KEPT = SLOTS_KEPT + 3 * LANES;

      wire [KEPT-1:0]    word;
      wire [KEPT-1:0]    waiting;
      wire               unused_waiting_valid;
      wire               unused_word_ready;
      wire               unused_answer_slot = &s_answer_slot;
      wire [LANES-1:0]   undecided = waiting[2*LANES +: LANES];
      reg  [LANES-1:0]   answered_q;  // lanes of the first waiting word
      wire [LANES-1:0]   left     = undecided & ~answered_q;
      wire [LANES-1:0]   next     = left & (~left + ONE);
      wire               complete = s_answer_valid && (left == next);
      reg                complete_q;
      reg  [2*LANES-1:0] verdict_q;   // verdicts of answered lanes; in a complete word of all lanes
      reg  [LANES-1:0]   recomputed_q;

      assign word[3*LANES-1:0] = {s_word_undecided, s_word_verdict};

      stream_fifo #(
        .WIDTH     (KEPT),
        .DEPTH_BITS(SLOT_BITS)
      ) words (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_word_valid),
        .s_axis_tready(unused_word_ready),
        .s_axis_tdata (word),
        .m_axis_tvalid(unused_waiting_valid),
        .m_axis_tready(complete),
        .m_axis_tdata (waiting)
      );

      always @(posedge aclk) begin
        if (!aresetn || complete) begin
          answered_q <= {LANES{1'b0}};
        end else if (s_answer_valid) begin
          answered_q <= answered_q | next;
        end
      end

      always @(posedge aclk) begin
        complete_q <= aresetn && complete;
        if (complete) begin
          recomputed_q <= undecided;
        end
      end

      for (k = 0; k < LANES; k = k + 1) begin : g_lane
        always @(posedge aclk) begin
          if (s_answer_valid && next[k]) begin
            verdict_q[2*k +: 2] <= s_answer_verdict;
          end else if (complete && !undecided[k]) begin
            verdict_q[2*k +: 2] <= waiting[2*k +: 2];
          end
        end
      end

      assign entry_valid        = complete_q;
      assign entry[3*LANES-1:0] = {recomputed_q, verdict_q};
      assign m_axis_recomputed  = head[2*LANES +: LANES];
      if (WITH_SLOT != 0) begin : g_slot
        reg [SLOT_BITS-1:0] slot_q;

        always @(posedge aclk) begin
          if (complete) begin
            slot_q <= waiting[KEPT-1 -: SLOT_BITS];
          end
        end

        assign word[KEPT-1 -: SLOT_BITS]   = s_word_slot;
        assign entry[WIDTH-1 -: SLOT_BITS] = slot_q;
      end else begin : g_no_slot
        wire unused_slot = &s_word_slot;
      end
    end
    if (WITH_SLOT != 0) begin : g_slot
      assign m_axis_slot = head[WIDTH-1 -: SLOT_BITS];
    end else begin : g_no_slot
      assign m_axis_slot = {SLOT_BITS{1'b0}};
    end
  endgenerate

endmodule

`default_nettype wire
