// lane_answers_proof: words leave lane_answers in the order in which they entered, each after the
// last of its answers, with the verdicts of its decided lanes, the answers of its undecided ones in
// their order, and its slot. One word at a time is watched, chosen by the solver, and the words and
// answers ahead of it are counted. At most two words are inside, as a user has slots for two.
`default_nettype none

module lane_answers_proof (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       enter,
  input wire       s_slot,
  input wire [1:0] s_undecided,
  input wire [3:0] s_verdict,
  input wire       answer,
  input wire [1:0] answer_verdict,
  input wire       m_ready,
  input wire       choose  // the word that enters is watched from now on, if no other is
);

  wire       m_valid;
  wire       m_slot;
  wire [1:0] m_recomputed;
  wire [3:0] m_verdict;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;

  lane_answers #(
    .LANES    (2),
    .SLOT_BITS(1)
  ) dut (
    .aclk             (aclk),
    .aresetn          (aresetn),
    .s_word_valid     (enter),
    .s_word_slot      (s_slot),
    .s_word_undecided (s_undecided),
    .s_word_verdict   (s_verdict),
    .s_answer_valid   (answer),
    .s_answer_slot    (1'b0),
    .s_answer_verdict (answer_verdict),
    .m_axis_tvalid    (m_valid),
    .m_axis_tready    (m_ready),
    .m_axis_slot      (m_slot),
    .m_axis_recomputed(m_recomputed),
    .m_axis_verdict   (m_verdict)
  );

  reg  [1:0] inside = 2'd0;        // words inside
  reg  [2:0] asked = 3'd0;         // answers still to come for words that entered two cycles ago
  reg  [1:0] asked_late = 2'd0;    // answers due for the word that entered one cycle ago
  reg        watching = 1'b0;
  reg  [1:0] ahead = 2'd0;         // words before the watched one
  reg  [2:0] answers_ahead = 3'd0; // answers before its own
  reg        slot;
  reg  [1:0] undecided;
  reg  [1:0] left;                 // its lanes that have no answer yet
  reg  [3:0] verdict;              // its verdicts, with the answers so far
  reg        held = 1'b0;
  reg  [6:0] held_word;
  reg        answered = 1'b0;      // an answer came in the cycle before
  reg        waited = 1'b0;        // every word inside was answered, and none was offered
  reg        waited_long = 1'b0;
  reg        waited_longer = 1'b0;

  wire [1:0] asks    = {1'b0, s_undecided[0]} + {1'b0, s_undecided[1]};
  wire       leave   = m_valid && m_ready;
  wire       mine    = answer && watching && (answers_ahead == 3'd0) && (left != 2'd0);
  wire       leaves  = watching && leave && (ahead == 2'd0);
  wire       is_idle = (inside != 2'd0) && (asked == 3'd0) && (asked_late == 2'd0) && !enter &&
                       !m_valid;

  always @(posedge aclk) begin
    started       <= 1'b1;
    held          <= aresetn && m_valid && !m_ready;
    held_word     <= {m_slot, m_recomputed, m_verdict};
    answered      <= aresetn && answer;
    waited        <= aresetn && is_idle;
    waited_long   <= aresetn && waited && is_idle;
    waited_longer <= aresetn && waited_long && is_idle;
    if (!aresetn) begin
      inside        <= 2'd0;
      asked         <= 3'd0;
      asked_late    <= 2'd0;
      watching      <= 1'b0;
      answers_ahead <= 3'd0;
    end else begin
      inside     <= inside + {1'b0, enter} - {1'b0, leave};
      asked_late <= enter ? asks : 2'd0;
      asked      <= asked + {1'b0, asked_late} - {2'd0, answer};
      if (leave && (ahead != 2'd0)) begin
        ahead <= ahead - 2'd1;
      end
      if (answer && (answers_ahead != 3'd0)) begin
        answers_ahead <= answers_ahead - 3'd1;
      end
      if (mine) begin
        left    <= left[0] ? {left[1], 1'b0} : 2'b00;
        verdict <= left[0] ? {verdict[3:2], answer_verdict} : {answer_verdict, verdict[1:0]};
      end
      if (leaves) begin
        watching <= 1'b0;
      end
      if (enter && choose && !watching) begin
        watching      <= 1'b1;
        ahead         <= inside - {1'b0, leave};
        answers_ahead <= asked + {1'b0, asked_late} - {2'd0, answer};
        slot          <= s_slot;
        undecided     <= s_undecided;
        left          <= s_undecided;
        verdict       <= s_verdict;
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(!enter && !answer);
    end
    assume(!enter || ((inside < 2'd2) && (s_undecided != 2'd0)));
    assume(!answer || (asked != 3'd0));
    if (started && aresetn) begin
      no_more_than_entered: assert(!m_valid || (inside != 2'd0));
      only_when_answered: assert(!m_valid || !watching || (ahead != 2'd0) || (left == 2'd0));
      same_word: assert(!m_valid || !watching || (ahead != 2'd0) ||
                        ({m_slot, m_recomputed, m_verdict} == {slot, undecided, verdict}));
      comes_in_three_cycles: assert(!waited_longer || m_valid);
      holds_until_taken: assert(!held ||
                                (m_valid && ({m_slot, m_recomputed, m_verdict} == held_word)));
      can_answer_both: cover(leaves && (undecided == 2'd3) && (verdict == 4'b1001));
      can_wait: cover(held && (inside == 2'd2));
      can_answer_two_words_in_a_row: cover(mine && answered && (ahead == 2'd1));
    end
  end

endmodule

`default_nettype wire
