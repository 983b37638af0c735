// One lane of the fake system; see fake_system.v.
`default_nettype none

module fake_channel (
    aclk, aresetn, fault,
    s_axis_tvalid, s_axis_tready, s_axis_tdata, s_axis_tuser,
    m_axis_tvalid, m_axis_tready, m_axis_tdata, m_axis_tuser,
    comparisons, recomputations, stalls,
    request_valid, request_ready, request_tag, request_operands,
    answer_valid, answer_tag, answer_verdict
);

  parameter TAG_BITS = 12;
  parameter SLOTS = 8;  // a power of two
  parameter COUNTER_BITS = 16;
  parameter GUARD = 4;
  parameter ROUTE = 0;

  localparam [7:0] LOST = 8'd1;
  localparam [7:0] DOUBLED = 8'd2;
  localparam [7:0] MISTAGGED = 8'd3;
  localparam [7:0] VALID_DROPPED = 8'd4;
  localparam [7:0] PAYLOAD_CHANGED = 8'd5;
  localparam [7:0] WRONG_VERDICT = 8'd6;
  localparam [7:0] HUNG = 8'd7;
  localparam [7:0] STALE_AFTER_RESET = 8'd8;
  localparam [7:0] OUT_OF_ORDER = 8'd9;
  localparam [7:0] WRONG_COUNTER = 8'd10;
  localparam [7:0] WRONG_FLAG = 8'd11;
  localparam [7:0] VALID_IN_RESET = 8'd12;

  // Which comparison a defect strikes; the drained ones stay clear of it.
  localparam VICTIM = 100;

  input  wire                    aclk;
  input  wire                    aresetn;
  input  wire [7:0]              fault;
  input  wire                    s_axis_tvalid;
  output wire                    s_axis_tready;
  input  wire [31:0]             s_axis_tdata;
  input  wire [TAG_BITS-1:0]     s_axis_tuser;
  output wire                    m_axis_tvalid;
  input  wire                    m_axis_tready;
  output wire [7:0]              m_axis_tdata;
  output wire [TAG_BITS-1:0]     m_axis_tuser;
  output reg  [COUNTER_BITS-1:0] comparisons;
  output reg  [COUNTER_BITS-1:0] recomputations;
  output reg  [COUNTER_BITS-1:0] stalls;
  output wire                    request_valid;
  input  wire                    request_ready;
  output wire [TAG_BITS-1:0]     request_tag;
  output wire [31:0]             request_operands;
  input  wire                    answer_valid;
  input  wire [TAG_BITS-1:0]     answer_tag;
  input  wire [1:0]              answer_verdict;

  function integer clog2(input integer value);
    begin
      clog2 = 0;
      while ((1 << clog2) < value) clog2 = clog2 + 1;
    end
  endfunction

  localparam POINTER_BITS = clog2(SLOTS) + 1;
  localparam DIRECT_BITS = TAG_BITS + 4;
  localparam REQUEST_BITS = TAG_BITS + 32;

  // The decision: positive encodings compare as integers.
  wire [15:0] a = s_axis_tdata[15:0];
  wire [15:0] b = s_axis_tdata[31:16];
  wire [15:0] distance = (a < b) ? b - a : a - b;
  wire        decided = distance >= GUARD[15:0];
  wire [1:0]  order = (a < b) ? 2'd0 : 2'd1;
  wire [1:0]  verdict = (a > b) ? 2'd2 : order;

  reg [31:0] accepted;
  wire       victim = accepted == VICTIM;

  wire accept = s_axis_tvalid && s_axis_tready;
  wire to_request = !decided && (ROUTE == 0);
  wire lose = (fault == LOST) && victim;

  // Decided ones, or all of them.
  wire                    direct_valid;
  wire                    direct_ready;
  wire [DIRECT_BITS-1:0]  direct_data;
  wire [1:0] flags = decided ? 2'b00 : ((ROUTE == 2) ? 2'b10 : 2'b01);
  wire       wrong = (fault == WRONG_VERDICT) && victim;
  wire       flip = (fault == WRONG_FLAG) && victim;
  wire [TAG_BITS-1:0] entry_tag = ((fault == MISTAGGED) && victim) ? ~s_axis_tuser : s_axis_tuser;

  fake_fifo #(.WIDTH(DIRECT_BITS), .POINTER_BITS(POINTER_BITS)) direct (
      .aclk(aclk),
      .aresetn(aresetn || (fault == STALE_AFTER_RESET)),
      .push(accept && !to_request && !lose),
      .push_data({entry_tag, flags[1], flags[0] ^ flip, verdict ^ {wrong, 1'b0}}),
      .pop_valid(direct_valid),
      .pop_ready(direct_ready),
      .pop_data(direct_data)
  );

  fake_fifo #(.WIDTH(REQUEST_BITS), .POINTER_BITS(POINTER_BITS)) request (
      .aclk(aclk),
      .aresetn(aresetn),
      .push(accept && to_request && !lose),
      .push_data({entry_tag, s_axis_tdata}),
      .pop_valid(request_valid),
      .pop_ready(request_ready),
      .pop_data({request_tag, request_operands})
  );

  wire                slow_valid;
  wire                slow_ready;
  wire [TAG_BITS+1:0] slow_data;

  fake_fifo #(.WIDTH(TAG_BITS + 2), .POINTER_BITS(POINTER_BITS)) slow (
      .aclk(aclk),
      .aresetn(aresetn),
      .push(answer_valid),
      .push_data({answer_tag, answer_verdict}),
      .pop_valid(slow_valid),
      .pop_ready(slow_ready),
      .pop_data(slow_data)
  );

  // The output register takes recomputed ones first.
  reg                out_valid_q;
  reg [3:0]          out_data_q;
  reg [TAG_BITS-1:0] out_tag_q;
  reg [31:0]         left;
  reg                again_q;
  reg                waited_q;

  wire hang = (fault == HUNG) && (left >= VICTIM);
  // Doubled: the next one to leave stays for a second time.
  wire load = (!out_valid_q || m_axis_tready) && !hang && !(again_q && out_valid_q);
  assign slow_ready = load;
  assign direct_ready = load && !slow_valid;

  // Out of order: two neighbours change places.
  reg                   held_q;
  reg [DIRECT_BITS-1:0] held_data_q;
  wire hold_back = (fault == OUT_OF_ORDER) && (left == VICTIM) && !held_q && direct_valid;

  wire blink = (fault == VALID_DROPPED) && waited_q && (left > VICTIM);
  wire change = (fault == PAYLOAD_CHANGED) && waited_q && (left > VICTIM);
  assign m_axis_tvalid = out_valid_q && !blink;
  assign m_axis_tdata = {4'd0, out_data_q[3:2], out_data_q[1:0] ^ {change, 1'b0}};
  assign m_axis_tuser = out_tag_q;

  wire leave = m_axis_tvalid && m_axis_tready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      out_valid_q <= (fault == VALID_IN_RESET) && out_valid_q;
      left <= 0;
      accepted <= 0;
      again_q <= 1'b0;
      waited_q <= 1'b0;
      held_q <= 1'b0;
    end else begin
      waited_q <= m_axis_tvalid && !m_axis_tready;
      again_q <= (fault == DOUBLED) && (leave ? (left == VICTIM) : again_q);
      if (accept) accepted <= accepted + 1;
      if (leave) left <= left + 1;
      if (hang && leave) out_valid_q <= 1'b0;
      if (load) begin
        out_valid_q <= slow_valid || (direct_valid && !hold_back) || (held_q && !direct_valid);
        if (slow_valid) begin
          {out_tag_q, out_data_q} <= {slow_data[TAG_BITS+1:2], 2'b01, slow_data[1:0]};
        end else if (hold_back) begin
          held_q <= 1'b1;
          held_data_q <= direct_data;
        end else if (direct_valid) begin
          {out_tag_q, out_data_q} <= direct_data;
        end else if (held_q) begin
          {out_tag_q, out_data_q} <= held_data_q;
          held_q <= 1'b0;
        end
      end
    end
  end

  // Credits.
  reg [POINTER_BITS-1:0] occupied;
  assign s_axis_tready = occupied < SLOTS[POINTER_BITS-1:0];

  always @(posedge aclk) begin
    if (!aresetn) begin
      occupied <= 0;
      comparisons <= 0;
      recomputations <= 0;
      stalls <= 0;
    end else begin
      occupied <= occupied + {{POINTER_BITS-1{1'b0}}, accept && !lose}
                       - {{POINTER_BITS-1{1'b0}}, leave};
      if (accept && !((fault == WRONG_COUNTER) && victim)) comparisons <= comparisons + 1'b1;
      if (accept && !decided) recomputations <= recomputations + 1'b1;
      if (s_axis_tvalid && !s_axis_tready) stalls <= stalls + 1'b1;
    end
  end

endmodule

`default_nettype wire
