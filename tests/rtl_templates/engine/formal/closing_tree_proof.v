// closing_tree_proof: each word of each input leaves closing_tree once, unchanged, in the order of
// its input. One closing beat leaves behind all of them, and its low bits are the sum of the
// inputs'. A closing beat that does not leave does not wait for `m_ready`. One input is watched,
// one word of it at a time. Words are {input, watched, data}. Behind its closing beat an input
// sends nothing until the merged closing beat has left. The engine keeps to that: it takes the next
// set only then.
`default_nettype none

module closing_tree_proof #(
  parameter INPUTS = 2,
  parameter LEVELS = 1,
  parameter COUNT_BITS = 2
) (
  input wire                aclk,
  input wire                aresetn_later,
  input wire [INPUTS-1:0]   s_valid,
  input wire [INPUTS-1:0]   s_last,
  input wire [INPUTS*2-1:0] s_word,
  input wire                m_ready,
  input wire                choose  // the word of the watched input is watched, if no other is
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  // The most quiet cycles: one for each closing beat that the tree swallows, and one for each
  // level.
  localparam MOST_QUIET = LEVELS + INPUTS;

  (* anyconst *) reg [2:0] watched;

  wire [INPUTS-1:0]   s_ready;
  wire [INPUTS*6-1:0] s_data;
  wire                m_valid;
  wire                m_last;
  wire [2:0]          m_input;
  wire                m_watched;
  wire [1:0]          m_word;

  reg                 started = 1'b0;
  wire                aresetn = started && aresetn_later;

  closing_tree #(
    .INPUTS    (INPUTS),
    .WIDTH     (6),
    .COUNT_BITS(COUNT_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .s_axis_tlast (s_last),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata ({m_input, m_watched, m_word}),
    .m_axis_tlast (m_last)
  );

  reg  [3:0]        total    = NONE;  // words inside, closing beats aside
  reg  [3:0]        inside   = NONE;  // words of the watched input
  reg  [3:0]        ahead    = NONE;  // words ahead of the watched word
  reg               watching = 1'b0;
  reg  [1:0]        word;
  reg  [1:0]        sum      = 2'd0;
  reg  [3:0]        quiet    = NONE;  // cycles without a beat to take although something waits
  reg  [INPUTS-1:0] closed   = {INPUTS{1'b0}};
  reg  [INPUTS-1:0] offered  = {INPUTS{1'b0}};
  reg  [INPUTS-1:0] offered_last;
  reg               held     = 1'b0;
  reg  [6:0]        held_data;

  wire [INPUTS-1:0] taken   = s_valid & s_ready;
  wire              enter   = taken[watched] && !s_last[watched];
  wire              leave   = m_valid && m_ready && !m_last && (m_input == watched);
  wire              closes  = m_valid && m_ready && m_last;
  wire              chosen  = enter && choose && !watching;
  wire              all_closed = (closed == {INPUTS{1'b1}});
  wire              stalls  = (s_valid != {INPUTS{1'b0}}) && (taken == {INPUTS{1'b0}});
  reg  [3:0]        entered;
  reg  [1:0]        more;
  integer           k;

  always @* begin
    entered = NONE;
    more    = sum;
    for (k = 0; k < INPUTS; k = k + 1) begin
      entered = entered + {3'b000, taken[k] && !s_last[k]};
      if (taken[k] && s_last[k]) begin
        more = more + s_word[2*k +: 2];
      end
    end
  end

  always @(posedge aclk) begin
    started      <= 1'b1;
    offered      <= aresetn ? s_valid & ~taken : {INPUTS{1'b0}};
    offered_last <= s_last;
    held         <= aresetn && m_valid && !m_ready;
    held_data    <= {m_last, m_input, m_watched, m_word};
    if (!aresetn) begin
      total    <= NONE;
      inside   <= NONE;
      watching <= 1'b0;
      quiet    <= NONE;
      closed   <= {INPUTS{1'b0}};
      sum      <= 2'd0;
    end else begin
      total  <= total + entered - {3'b000, m_valid && m_ready && !m_last};
      inside <= inside + {3'b000, enter} - {3'b000, leave};
      quiet  <= (((total != NONE) || all_closed || stalls) && !m_valid) ? quiet + ONE : NONE;
      closed <= closes ? {INPUTS{1'b0}} : closed | (taken & s_last);
      sum    <= closes ? 2'd0 : more;
      if (leave && m_watched) begin
        watching <= 1'b0;
      end
      if (watching && leave) begin
        ahead <= ahead - ONE;
      end
      if (chosen) begin
        watching <= 1'b1;
        word     <= s_word[2*watched +: 2];
        ahead    <= inside - {3'b000, leave};
      end
    end
  end

  genvar i;
  generate
    for (i = 0; i < INPUTS; i = i + 1) begin : g_input
      wire [2:0] name = i;

      assign s_data[6*i +: 6] = {name, chosen && (watched == name), s_word[2*i +: 2]};

      always @* begin
        if (offered[i]) begin
          assume(s_last[i] == offered_last[i]);
        end
        if (closed[i]) begin
          assume(!s_valid[i]);
        end
      end
    end
  endgenerate

  always @* begin
    assume(watched < INPUTS);
    senders_hold: assume((offered & ~s_valid) == {INPUTS{1'b0}});
    if (!aresetn) begin
      assume(s_valid == {INPUTS{1'b0}});
    end
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || m_last || (m_input != watched) || (inside != NONE));
      leaves_once_in_order: assert(!m_valid || m_last || (m_input != watched) ||
                                   (m_watched == (watching && (ahead == NONE))));
      leaves_unchanged: assert(!m_valid || m_last || (m_input != watched) || !m_watched ||
                               (m_word == word));
      watched_is_inside: assert(!watching || (ahead < inside));
      closes_when_all_have: assert(!m_valid || !m_last || all_closed);
      closes_behind_all: assert(!m_valid || !m_last || (total == NONE));
      adds_up: assert(!m_valid || !m_last || (COUNT_BITS == 0) || (m_word == sum));
      keeps_moving: assert(quiet < MOST_QUIET);
      holds_until_taken: assert(!held ||
                                (m_valid && ({m_last, m_input, m_watched, m_word} == held_data)));
      can_fill: cover((inside == LEVELS) && watching && (ahead == inside - ONE));
      can_leave: cover(leave && m_watched && (m_word == 2'd2));
      can_close_at_once: cover(closes && (sum == 2'd0) && held);
      can_close_with_a_sum: cover(closes && (sum == 2'd3) && (m_word == 2'd3));
      can_wait_for_the_last: cover(leave && m_watched && (closed == {1'b1, {(INPUTS-1){1'b0}}}));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
