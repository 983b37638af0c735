// operand_memory_proof: whatever stalls, each request of a reference is answered once, in the order
// of its requests, with the row and the candidates that were written last at the places it names;
// an offer stays until it is taken, and everything keeps moving. One row place and one candidate,
// chosen by the solver for good, are watched; the words at the others are anything. Reference 0 or
// 1, chosen in the same way, is watched; up to two requests of it are inside.
`default_nettype none

module operand_memory_proof #(
  parameter REFERENCES = 2
) (
  input wire                    aclk,
  input wire                    aresetn_later,
  input wire                    row_write,
  input wire                    row_place,
  input wire                    row,
  input wire                    candidate_write,
  input wire                    candidate_index,
  input wire                    candidate,
  input wire [REFERENCES-1:0]   asks,
  input wire [3*REFERENCES-1:0] ask_tags,
  input wire [REFERENCES-1:0]   m_ready,
  input wire                    any_place,      // read only in the first cycle
  input wire                    any_index,
  input wire [REFERENCES-1:0]   any_reference
);

  localparam MOST_QUIET = 4;

  reg  started = 1'b0;
  wire aresetn = started && aresetn_later;

  // The solver's choices: registers that keep their first value.
  reg                  place;
  reg                  index;
  reg [REFERENCES-1:0] watched;
  reg                  known_row_valid       = 1'b0;
  reg                  known_candidate_valid = 1'b0;
  reg                  known_row;
  reg                  known_candidate;

  wire [REFERENCES-1:0]   s_ready;
  wire [REFERENCES-1:0]   m_valid;
  wire [3*REFERENCES-1:0] m_data;
  wire [REFERENCES-1:0]   accepts = asks & s_ready;
  wire [REFERENCES-1:0]   leaves  = m_valid & m_ready;

  operand_memory #(
    .REFERENCES    (REFERENCES),
    .CANDIDATE_BITS(1),
    .ROW_BITS      (1),
    .INDEX_BITS    (1),
    .PLACE_BITS    (1)
  ) dut (
    .aclk           (aclk),
    .aresetn        (aresetn),
    .row_write      (row_write),
    .row_place      (row_place),
    .row            (row),
    .candidate_write(candidate_write),
    .candidate_index(candidate_index),
    .candidate      (candidate),
    .s_ask_tvalid   (asks),
    .s_ask_tready   (s_ready),
    .s_ask_tdata    (ask_tags),
    .m_answer_tvalid(m_valid),
    .m_answer_tready(m_ready),
    .m_answer_tdata (m_data)
  );

  // The watched reference: its offers and its answers. Tags are {own, best, place}.
  reg        ask;
  reg  [2:0] tag;
  reg        ready;
  reg        answered;
  reg  [2:0] answer;       // {own, best, row}
  integer    r;

  always @* begin
    ask      = 1'b0;
    tag      = 3'b000;
    ready    = 1'b0;
    answered = 1'b0;
    answer   = 3'b000;
    for (r = 0; r < REFERENCES; r = r + 1) begin
      if (watched[r]) begin
        ask      = accepts[r];
        tag      = ask_tags[3*r +: 3];
        ready    = m_ready[r];
        answered = m_valid[r];
        answer   = m_data[3*r +: 3];
      end
    end
  end

  // The watched reference's requests inside; the first one has waited longest.
  reg  [1:0]  inside = 2'd0;
  reg  [2:0]  first;
  reg  [2:0]  second;
  reg  [2:0]  third;
  wire        leaving = answered && ready;
  wire [1:0]  left    = inside - {1'b0, leaving};
  reg  [2:0]  quiet   = 3'd0;
  reg  [3:0]  others  = 4'd0;   // the requests inside of all references
  integer     k;
  reg  [3:0]  entered;
  reg  [3:0]  gone;

  always @* begin
    entered = 4'd0;
    gone    = 4'd0;
    for (k = 0; k < REFERENCES; k = k + 1) begin
      entered = entered + {3'b000, accepts[k]};
      gone    = gone + {3'b000, leaves[k]};
    end
  end

  always @(posedge aclk) begin
    started <= 1'b1;
    if (!started) begin
      place   <= any_place;
      index   <= any_index;
      watched <= any_reference;
    end
    if (!aresetn) begin
      inside <= 2'd0;
      others <= 4'd0;
      quiet  <= 3'd0;
    end else begin
      inside <= left + {1'b0, ask};
      others <= others + entered - gone;
      quiet  <= ((others != 4'd0) && (gone == 4'd0) && (&m_ready)) ? quiet + 3'd1 : 3'd0;
    end
    if (leaving) begin
      first  <= second;
      second <= third;
    end
    if (ask) begin
      case (left)
        2'd0: first <= tag;
        2'd1: second <= tag;
        default: third <= tag;
      endcase
    end
    if (started && row_write && (row_place == place)) begin
      known_row       <= row;
      known_row_valid <= 1'b1;
    end
    if (started && candidate_write && (candidate_index == index)) begin
      known_candidate       <= candidate;
      known_candidate_valid <= 1'b1;
    end
  end

  reg                    held = 1'b0;
  reg [REFERENCES-1:0]   held_valid;
  reg [3*REFERENCES-1:0] held_data;

  always @(posedge aclk) begin
    held       <= aresetn;
    held_valid <= m_valid & ~m_ready;
    held_data  <= m_data;
  end

  reg     kept;  // an offer that was not taken has stayed
  integer h;

  always @* begin
    kept = 1'b1;
    for (h = 0; h < REFERENCES; h = h + 1) begin
      kept = kept && (!held_valid[h] ||
                      (m_valid[h] && (m_data[3*h +: 3] == held_data[3*h +: 3])));
    end
    if (!aresetn) begin
      assume(asks == {REFERENCES{1'b0}});
    end
    // Places that a request names are not written; candidates come while nobody asks.
    assume(!candidate_write || ((others == 4'd0) && (asks == {REFERENCES{1'b0}})));
    assume(!row_write || (row_place != place) || ((inside == 2'd0) && !ask));
    if (!started) begin
      assume((any_reference != {REFERENCES{1'b0}}) &&
             ((any_reference & (any_reference - 1'b1)) == {REFERENCES{1'b0}}));
    end
    if (started && aresetn) begin
      few_inside: assert(inside <= 2'd3);
      nothing_made_up: assert(!answered || (inside != 2'd0));
      the_row: assert(!answered || !known_row_valid || (first[0] != place) ||
                      (answer[0] == known_row));
      the_best: assert(!answered || !known_candidate_valid || (first[1] != index) ||
                       (answer[1] == known_candidate));
      the_own: assert(!answered || !known_candidate_valid || (first[2] != index) ||
                      (answer[2] == known_candidate));
      keeps_moving: assert(quiet < MOST_QUIET);
      holds_still: assert(!held || kept);
      can_answer_many: cover(leaving && (inside == ((REFERENCES == 1) ? 2'd2 : 2'd3)) && (first[0] == place) && known_row_valid);
      can_answer_own: cover(leaving && (first[2:1] == {index, !index}) && known_candidate_valid);
    end
  end

endmodule

`default_nettype wire
