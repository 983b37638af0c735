// arbiter_proof: stream_arbiter takes one word at a time, passes it on once and unchanged, takes
// the words of a packet one after the other, and makes nobody wait for more than one packet of each
// other input.
`default_nettype none

module arbiter_proof #(
  parameter INPUTS = 3,
  parameter HALF_RATE = 0,
  parameter BEAT_BITS = 0
) (
  input wire                aclk,
  input wire                aresetn_later,
  input wire [INPUTS-1:0]   s_valid,
  input wire [INPUTS*2-1:0] s_data,
  input wire                m_ready
);

  localparam LAST = INPUTS - 1;

  wire [INPUTS-1:0] s_ready;
  wire              m_valid;
  wire [1:0]        m_data;

  reg               started = 1'b0;
  wire              aresetn = started && aresetn_later;
  reg               inside  = 1'b0;  // one word was taken and has not left
  reg  [1:0]        inside_word;
  reg  [INPUTS-1:0] offered = {INPUTS{1'b0}};
  reg               held    = 1'b0;
  reg  [1:0]        held_data;
  reg               loaded  = 1'b0;
  reg  [2:0]        beat    = 3'd0;  // the number of the word that is taken next
  reg  [INPUTS-1:0] owner;           // the input that gave the packet's words before it
  reg               quiet   = 1'b0;  // a word was offered and could be taken, and none was

  localparam [2:0] LAST_BEAT = (1 << BEAT_BITS) - 1;

  stream_arbiter #(
    .INPUTS   (INPUTS),
    .WIDTH    (2),
    .HALF_RATE(HALF_RATE),
    .BEAT_BITS(BEAT_BITS)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata (s_data),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data)
  );

  wire [INPUTS-1:0] taken = s_valid & s_ready;
  wire              packet_ends = |taken && (beat == LAST_BEAT);
  wire              could_take  = !m_valid || (m_ready && (HALF_RATE == 0));
  wire [INPUTS-1:0] may_give    = (beat == 3'd0) ? s_valid : s_valid & owner;
  integer           k;

  always @(posedge aclk) begin
    started <= 1'b1;
    quiet   <= aresetn && could_take && (taken == {INPUTS{1'b0}}) && |may_give;
    if (!aresetn || packet_ends) begin
      beat <= 3'd0;
    end else if (|taken) begin
      beat <= beat + 3'd1;
    end
    if (|taken) begin
      owner <= taken;
    end
    inside  <= aresetn && (|taken || (inside && !m_ready));
    offered <= aresetn ? s_valid & ~taken : {INPUTS{1'b0}};
    held    <= aresetn && m_valid && !m_ready;
    loaded  <= aresetn && |taken;
    held_data <= m_data;
    for (k = 0; k < INPUTS; k = k + 1) begin
      if (taken[k]) begin
        inside_word <= s_data[2*k +: 2];
      end
    end
  end

  always @* begin
    if (!aresetn) begin
      assume(s_valid == {INPUTS{1'b0}});
    end
    senders_hold: assume((offered & ~s_valid) == {INPUTS{1'b0}});
    if (started) begin
      one_hot: assert((taken & (taken - 1'b1)) == {INPUTS{1'b0}});
      works_when_it_can: assert(!aresetn || !(|may_give) || |taken || !could_take
                                || ((BEAT_BITS != 0) && (beat == 3'd0) && !quiet));
      packets_stay_together: assert(!aresetn || (beat == 3'd0) || !(|taken) || (taken == owner));
      passes_once: assert(m_valid == inside);
      passes_unchanged: assert(!inside || (m_data == inside_word));
      valid_holds: assert(!held || m_valid);
      data_holds: assert(!held || (m_data == held_data));
      can_run_at_full_rate: cover((loaded && |taken) || (HALF_RATE != 0));
      can_hold: cover(held);
      can_end_a_packet: cover(packet_ends && owner[LAST]);
      can_choose_another: cover(quiet || (BEAT_BITS == 0));
    end
  end

  genvar i;
  generate
    for (i = 0; i < INPUTS; i = i + 1) begin : g_input
      reg [3:0] passed_over = 4'd0;  // packets of others that ended since input i offered a word

      always @(posedge aclk) begin
        if (!aresetn || !s_valid[i] || taken[i]) begin
          passed_over <= 4'd0;
        end else if (packet_ends) begin
          passed_over <= passed_over + 4'd1;
        end
      end

      always @* begin
        if (started) begin
          assert(passed_over <= LAST);
          cover((passed_over == LAST) && taken[i]);
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
