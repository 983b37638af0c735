// recomputation_proof: every pair that pair_recomputation takes is asked of one reference, once, with
// its own items, and its verdict leaves once if it is reported; the closing beat leaves behind all
// verdicts. The pair with one tag, chosen by the solver, is watched; REFERENCES references hold one
// pair each for as long as they like. The items' memory is any table, and holds its word until it is
// read again.
`default_nettype none

module recomputation_proof #(
  parameter REFERENCES = 2,
  parameter REPORT = 11,
  parameter EVERY_CYCLE = -1,
  parameter QUEUE_BITS = 1
) (
  input wire                    aclk,
  input wire                    aresetn_later,
  input wire                    s_valid,
  input wire                    s_last,
  input wire [1:0]              s_tag,        // j, i
  input wire [REFERENCES-1:0]   willing,      // a reference without a pair takes one
  input wire [REFERENCES-1:0]   finishing,    // a reference with a pair answers
  input wire [2*REFERENCES-1:0] verdicts,     // this
  input wire                    m_ready
);

  localparam [4:0] NONE = 0;
  localparam [4:0] ONE  = 1;
  localparam [3:0] REPORTS = REPORT[3:0];
  localparam MOST_QUIET = 12;

  (* anyconst *) reg [1:0] items;    // item i is bit i
  (* anyconst *) reg [1:0] watched;  // a tag

  wire                    s_ready;
  wire                    memory_enable;
  wire [1:0]              memory_addresses;
  reg  [1:0]              memory_q;
  wire [REFERENCES-1:0]   request_valid;
  wire [REFERENCES-1:0]   request_ready;
  wire [1:0]              request_tag;
  wire [1:0]              request_items;
  wire [REFERENCES-1:0]   answer_valid;
  wire [4*REFERENCES-1:0] answers;
  wire                    m_valid;
  wire [1:0]              m_tag;
  wire [1:0]              m_verdict;
  wire                    m_last;
  wire                    answered;

  reg                     started = 1'b0;
  wire                    aresetn = started && aresetn_later;

  pair_recomputation #(
    .REFERENCES      (REFERENCES),
    .ITEM_BITS       (1),
    .INDEX_BITS      (1),
    .REPORT          (REPORT),
    .EVERY_CYCLE     (EVERY_CYCLE),
    .OUTSTANDING_BITS(1),
    .QUEUE_BITS      (QUEUE_BITS)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_pair_tvalid   (s_valid),
    .s_pair_tready   (s_ready),
    .s_pair_tag      (s_tag),
    .s_pair_tlast    (s_last),
    .memory_enable   (memory_enable),
    .memory_addresses(memory_addresses),
    .memory_items    (memory_q),
    .m_request_tvalid(request_valid),
    .m_request_tready(request_ready),
    .m_request_tag   (request_tag),
    .m_request_items (request_items),
    .s_answer_valid  (answer_valid),
    .s_answer_tdata  (answers),
    .m_axis_tvalid   (m_valid),
    .m_axis_tready   (m_ready),
    .m_axis_tdata    ({m_tag, m_verdict}),
    .m_axis_tlast    (m_last),
    .answered        (answered)
  );

  wire take      = s_valid && s_ready;
  wire leave     = m_valid && m_ready;
  wire is_watched = (s_tag == watched);

  // References.
  reg  [REFERENCES-1:0]   busy  = {REFERENCES{1'b0}};
  reg  [2*REFERENCES-1:0] tags;
  wire [REFERENCES-1:0]   asked = request_valid & request_ready;
  wire [REFERENCES-1:0]   about_watched;

  assign request_ready = willing & ~busy;
  assign answer_valid  = busy & finishing;

  genvar r;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_reference
      assign answers[4*r +: 4] = {tags[2*r +: 2], verdicts[2*r +: 2]};
      assign about_watched[r]  = answer_valid[r] && (tags[2*r +: 2] == watched);

      always @(posedge aclk) begin
        if (!aresetn) begin
          busy[r] <= 1'b0;
        end else begin
          busy[r] <= asked[r] || (busy[r] && !finishing[r]);
        end
        if (asked[r]) begin
          tags[2*r +: 2] <= request_tag;
        end
      end
    end
  endgenerate

  // The watched pair comes once in a set; the closing beat comes last.
  reg        waits     = 1'b0;  // taken, not yet asked
  reg        computes  = 1'b0;  // asked, not yet answered
  reg        due       = 1'b0;  // answered, has to leave
  reg        seen      = 1'b0;
  reg  [1:0] verdict;
  reg  [4:0] open      = NONE;  // pairs taken and not yet answered
  reg        close_due = 1'b0;
  reg  [4:0] quiet     = NONE;  // cycles in which nothing moves though everybody would
  reg        held_request = 1'b0;
  reg  [REFERENCES+3:0] held_request_data;
  reg        held = 1'b0;
  reg  [4:0] held_data;
  integer    k;

  wire       moves = (asked != {REFERENCES{1'b0}}) || answered || (leave && m_last) ||
                     (answer_valid != {REFERENCES{1'b0}});
  wire       calm  = m_ready && (((busy & ~finishing) | (~busy & ~willing)) == {REFERENCES{1'b0}});

  always @(posedge aclk) begin
    started           <= 1'b1;
    held_request      <= aresetn && (request_valid != {REFERENCES{1'b0}}) &&
                         (asked == {REFERENCES{1'b0}});
    held_request_data <= {request_valid, request_tag, request_items};
    held              <= aresetn && m_valid && !m_ready;
    held_data         <= {m_last, m_tag, m_verdict};
    if (memory_enable) begin
      memory_q <= {items[memory_addresses[1]], items[memory_addresses[0]]};
    end
    if (!aresetn) begin
      waits     <= 1'b0;
      computes  <= 1'b0;
      due       <= 1'b0;
      seen      <= 1'b0;
      open      <= NONE;
      close_due <= 1'b0;
      quiet     <= NONE;
    end else begin
      waits     <= (take && !s_last && is_watched) ||
                   (waits && !((asked != {REFERENCES{1'b0}}) && (request_tag == watched)));
      computes  <= ((asked != {REFERENCES{1'b0}}) && (request_tag == watched)) ||
                   (computes && (about_watched == {REFERENCES{1'b0}}));
      seen      <= !(leave && m_last) && (seen || (take && !s_last && is_watched));
      open      <= open + {4'd0, take && !s_last} - {4'd0, answered};
      close_due <= (take && s_last) || (close_due && !(leave && m_last));
      quiet     <= (calm && !moves && ((open != NONE) || close_due)) ? quiet + ONE : NONE;
      if (leave && !m_last && (m_tag == watched)) begin
        due <= 1'b0;
      end
      for (k = 0; k < REFERENCES; k = k + 1) begin
        if (about_watched[k]) begin
          due     <= REPORTS[verdicts[2*k +: 2]];
          verdict <= verdicts[2*k +: 2];
        end
      end
    end
  end

  always @* begin
    once_in_a_set: assume(!s_valid || s_last || !is_watched || !seen);
    nothing_behind_the_last: assume(!s_valid || !close_due);
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      asks_one: assert((request_valid & (request_valid - 1'b1)) == {REFERENCES{1'b0}});
      asks_once: assert((request_valid == {REFERENCES{1'b0}}) || (request_tag != watched) || waits);
      with_its_items: assert((request_valid == {REFERENCES{1'b0}}) ||
                             (request_items == {items[request_tag[1]], items[request_tag[0]]}));
      told_once: assert(!m_valid || m_last || (m_tag != watched) || due);
      told_right: assert(!m_valid || m_last || (m_tag != watched) || (m_verdict == verdict));
      reported_kinds_only: assert(!m_valid || m_last || REPORTS[m_verdict]);
      closes_once: assert(!m_valid || !m_last || close_due);
      closes_behind_all: assert(!m_valid || !m_last ||
                                (!waits && !computes && !due && (open == NONE)));
      answers_what_was_taken: assert(!answered || (open != NONE));
      keeps_moving: assert(quiet < MOST_QUIET);
      request_holds: assert(!held_request ||
                            (held_request_data == {request_valid, request_tag, request_items}));
      holds_until_taken: assert(!held || (m_valid && ({m_last, m_tag, m_verdict} == held_data)));
      can_tell_from_last: cover(leave && !m_last && (m_tag == watched) && (watched == 2'd2));
      can_leave_out: cover(computes && (about_watched != {REFERENCES{1'b0}}) && (verdicts[1:0] == 2'd2)
                           && about_watched[0]);
      can_close: cover(leave && m_last && seen);
      can_wait_for_references: cover(close_due && computes && !m_ready);
      can_hold: cover(held && held_request);
    end
  end

endmodule

`default_nettype wire
