// report_output_proof: each report leaves report_output once, in the cycle after it was taken or later,
// with its fields where docs/ports.md says, and the closing beat behind them with their number.
// COUNT = 1: only the closing beats leave. A report has two bits of each index and two flags.
`default_nettype none

module report_output_proof #(
  parameter FLAG_BITS = 0,
  parameter COUNT = 0
) (
  input wire       aclk,
  input wire       aresetn_later,
  input wire       s_valid,
  input wire       s_last,
  input wire [1:0] s_flags,
  input wire [3:0] s_kind,  // undecided, recomputed, verdict
  input wire [3:0] s_tag,   // j, i
  input wire       overrun,
  input wire       m_ready
);

  localparam HELD_FLAGS = (FLAG_BITS > 0) ? FLAG_BITS : 1;
  localparam TDATA_BITS = 8 * ((FLAG_BITS + 7) / 8) + 16;

  wire                  s_ready;
  wire                  m_valid;
  wire [TDATA_BITS-1:0] m_data;
  wire [7:0]            m_user;
  wire                  m_last;

  reg                   started = 1'b0;
  wire                  aresetn = started && aresetn_later;

  report_output #(
    .INDEX_BITS(2),
    .FLAG_BITS (FLAG_BITS),
    .COUNT     (COUNT)
  ) dut (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_valid),
    .s_axis_tready(s_ready),
    .s_axis_tdata ({s_flags[HELD_FLAGS-1:0], s_kind, s_tag}),
    .s_axis_tlast (s_last),
    .overrun      (overrun),
    .m_axis_tvalid(m_valid),
    .m_axis_tready(m_ready),
    .m_axis_tdata (m_data),
    .m_axis_tuser (m_user),
    .m_axis_tlast (m_last)
  );

  wire                  take = s_valid && s_ready;
  reg                   due  = 1'b0;  // a beat was taken that has to leave and has not left
  reg                   last;
  reg  [1:0]            flags;
  reg  [3:0]            kind;
  reg  [3:0]            tag;
  reg  [3:0]            number;
  reg                   too_many;
  reg  [3:0]            taken = 4'd0;  // reports of the set
  reg                   held  = 1'b0;
  reg  [TDATA_BITS+8:0] held_beat;

  // The fields as they have to be.
  wire [7:0]  told_flags = last ? 8'd0 : {6'd0, flags};
  wire [15:0] told_pair  = {6'd0, tag[3:2], 6'd0, tag[1:0]};
  wire [15:0] told       = last ? {12'd0, number} : told_pair;

  always @(posedge aclk) begin
    started   <= 1'b1;
    held      <= aresetn && m_valid && !m_ready;
    held_beat <= {m_last, m_user, m_data};
    due       <= aresetn && ((take && (s_last || (COUNT == 0))) || (due && !m_ready));
    if (!aresetn || (take && s_last)) begin
      taken <= 4'd0;
    end else if (take) begin
      taken <= taken + 4'd1;
    end
    if (take) begin
      last     <= s_last;
      flags    <= s_flags;
      kind     <= s_kind;
      tag      <= s_tag;
      number   <= (COUNT != 0) ? taken + s_tag : taken;
      too_many <= overrun;
    end
  end

  generate
    if (FLAG_BITS > 0) begin : g_flags
      always @* begin
        if (started && aresetn && m_valid) begin
          flags_in_place: assert(m_data[16 +: 8] == told_flags);
          can_flag: cover(!m_last && (m_data[16 +: 8] == 8'd2));
        end
      end
    end
  endgenerate

  always @* begin
    if (!aresetn) begin
      assume(!s_valid);
    end
    if (started && aresetn) begin
      each_leaves_once: assert(m_valid == due);
      never_waits_alone: assert(s_ready || m_valid);
      last_told: assert(!m_valid || (m_last == last));
      no_report_where_they_count: assert((COUNT == 0) || !m_valid || m_last);
      fields_in_place: assert(!m_valid || (m_data[15:0] == told));
      kind_told: assert(!m_valid || (m_user == (last ? {1'b1, too_many, 6'd0} : {4'd0, kind})));
      holds_until_taken: assert(!held || (m_valid && ({m_last, m_user, m_data} == held_beat)));
      can_report: cover(m_valid && m_ready && ((COUNT != 0) || !m_last) && (tag == 4'd13));
      can_close_behind_three: cover(m_valid && m_last && (number == 4'd3) && too_many);
      can_close_at_once: cover(m_valid && m_last && (number == 4'd0));
      can_hold: cover(held);
    end
  end

endmodule

`default_nettype wire
