// tree_proof: a word that enters stream_tree leaves once, unchanged, in the order of its input, and
// waits for a bounded number of other inputs' words. One input is watched, one word of it at a
// time. Words are {input, watched, data}.
`default_nettype none

module tree_proof #(
  parameter INPUTS = 4,
  parameter RADIX = 2,
  parameter LEVELS = 2,
  parameter MOST_BEFORE = 3  // words of others that leave while a word waits to be taken
) (
  input wire              aclk,
  input wire              aresetn_later,
  input wire [INPUTS-1:0] s_valid,
  input wire [INPUTS-1:0] s_word,
  input wire              m_ready,
  input wire              choose  // the word of the watched input is watched, if no other is
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;

  (* anyconst *) reg [2:0] watched;

  wire [INPUTS-1:0]   s_ready;
  wire [INPUTS*5-1:0] s_data;
  wire                m_valid;
  wire [2:0]          m_input;
  wire                m_watched;
  wire                m_word;

  reg                 started = 1'b0;
  wire                aresetn = started && aresetn_later;

  stream_tree #(
    .INPUTS(INPUTS),
    .WIDTH (5),
    .RADIX (RADIX)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata ({m_input, m_watched, m_word})
  );

  reg  [3:0]        total    = NONE;  // words inside
  reg  [3:0]        inside   = NONE;  // words inside, of the watched input
  reg  [3:0]        ahead    = NONE;  // words ahead of the watched word
  reg               watching = 1'b0;
  reg               word;
  reg  [3:0]        quiet    = NONE;  // cycles without a word to take although one is inside
  reg  [3:0]        before   = NONE;
  reg  [INPUTS-1:0] offered  = {INPUTS{1'b0}};
  reg               held     = 1'b0;
  reg  [4:0]        held_data;

  wire [INPUTS-1:0] taken   = s_valid & s_ready;
  wire              offers  = s_valid[watched];
  wire              enter   = taken[watched];
  wire              leave   = m_valid && m_ready && (m_input == watched);
  wire              chosen  = enter && choose && !watching;
  wire              others  = m_valid && m_ready && !leave;
  reg  [3:0]        entered;
  integer           k;

  always @* begin
    entered = NONE;
    for (k = 0; k < INPUTS; k = k + 1) begin
      entered = entered + {3'b000, taken[k]};
    end
  end

  always @(posedge aclk) begin
    started   <= 1'b1;
    offered   <= aresetn ? s_valid & ~taken : {INPUTS{1'b0}};
    held      <= aresetn && m_valid && !m_ready;
    held_data <= {m_input, m_watched, m_word};
    if (!aresetn) begin
      total    <= NONE;
      inside   <= NONE;
      watching <= 1'b0;
      quiet    <= NONE;
      before   <= NONE;
    end else begin
      total  <= total + entered - {3'b000, m_valid && m_ready};
      inside <= inside + {3'b000, enter} - {3'b000, leave};
      quiet  <= ((total != NONE) && !m_valid) ? quiet + ONE : NONE;
      before <= (offers && !enter) ? before + {3'b000, others} : NONE;
      if (leave && m_watched) begin
        watching <= 1'b0;
      end
      if (watching && leave) begin
        ahead <= ahead - ONE;
      end
      if (chosen) begin
        watching <= 1'b1;
        word     <= s_word[watched];
        ahead    <= inside - {3'b000, leave};
      end
    end
  end

  genvar i;
  generate
    for (i = 0; i < INPUTS; i = i + 1) begin : g_input
      wire [2:0] name = i;

      assign s_data[5*i +: 5] = {name, chosen && (watched == name), s_word[i]};
    end
  endgenerate

  always @* begin
    assume(watched < INPUTS);
    senders_hold: assume((offered & ~s_valid) == {INPUTS{1'b0}});
    if (!aresetn) begin
      assume(s_valid == {INPUTS{1'b0}});
    end
    if (started && aresetn) begin
      nothing_made_up: assert(!m_valid || (m_input != watched) || (inside != NONE));
      one_word_a_level: assert(inside <= LEVELS);
      leaves_once_in_order: assert(!m_valid || (m_input != watched) ||
                                   (m_watched == (watching && (ahead == NONE))));
      leaves_unchanged: assert(!m_valid || (m_input != watched) || !m_watched || (m_word == word));
      watched_is_inside: assert(!watching || (ahead < inside));
      takes_when_empty: assert((total != NONE) || (s_valid == {INPUTS{1'b0}}) || (taken != {INPUTS{1'b0}}));
      keeps_moving: assert(quiet < LEVELS);
      waits_for_few: assert(before <= MOST_BEFORE);
      holds_until_taken: assert(!held || (m_valid && ({m_input, m_watched, m_word} == held_data)));
      can_wait_for_as_many: cover((before == MOST_BEFORE) && enter);
      can_fill: cover((inside == LEVELS) && watching && (ahead == inside - ONE));
      can_leave: cover(leave && m_watched && m_word);
      can_leave_from_last: cover(leave && m_watched && (watched == INPUTS - 1));
      can_be_quiet: cover((quiet == LEVELS - 1) && (total != NONE));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
