// crossbar_proof: a request reaches the reference of its lane under its lane's number, none is lost
// or doubled, its beats stay together, and an answer reaches only the lane that it names, two
// cycles later. The payload of lane i is i, and its slot bit alternates from beat to beat.
`default_nettype none

module crossbar_proof #(
  parameter LANES = 3,
  parameter REFERENCES = 2,
  parameter RADIX = 2,
  parameter BEAT_BITS = 0
) (
  input wire                      aclk,
  input wire [LANES-1:0]          s_valid,
  input wire [REFERENCES-1:0]     m_ready,
  input wire [REFERENCES-1:0]     answer_valid,
  input wire [REFERENCES*6-1:0]   answer_data
);

  reg                     aresetn = 1'b0;
  reg  [1:0]              age     = 2'd0;
  wire [LANES-1:0]        s_ready;
  wire [LANES*4-1:0]      s_data;
  wire [REFERENCES-1:0]   m_valid;
  wire [REFERENCES*7-1:0] m_data;
  wire [LANES-1:0]        lane_answer_valid;
  wire [LANES-1:0]        lane_answer_slot;
  wire [LANES*2-1:0]      lane_answer_verdict;
  wire [REFERENCES*6-1:0] answers;

  stream_crossbar #(
    .LANES       (LANES),
    .REFERENCES  (REFERENCES),
    .LANE_BITS   (3),
    .SLOT_BITS   (1),
    .PAYLOAD_BITS(3),
    .RADIX       (RADIX),
    .BEAT_BITS   (BEAT_BITS)
  ) dut (
    .aclk            (aclk),
    .aresetn         (aresetn),
    .s_request_tvalid(s_valid & {LANES{aresetn}}),
    .s_request_tready(s_ready),
    .s_request_tdata (s_data),
    .m_request_tvalid(m_valid),
    .m_request_tready(m_ready),
    .m_request_tdata (m_data),
    .s_answer_valid  (answer_valid),
    .s_answer_tdata  (answers),
    .m_answer_valid  (lane_answer_valid),
    .m_answer_slot   (lane_answer_slot),
    .m_answer_verdict(lane_answer_verdict)
  );

  assign answers = answer_data;

  always @(posedge aclk) begin
    aresetn <= 1'b1;
    if (aresetn && (age != 2'd3)) begin
      age <= age + 2'd1;
    end
  end

  genvar i;
  generate
    for (i = 0; i < LANES; i = i + 1) begin : g_lane
      localparam R = i % REFERENCES;

      reg        next_out = 1'b0;  // the slot bit of the request that must leave next
      reg        next_in  = 1'b0;
      reg  [1:0] inside   = 2'd0;
      reg        offered  = 1'b0;
      reg  [1:0] named    = 2'd0;  // answers to this lane, one and two cycles ago
      reg  [2:0] answer_1;
      reg  [2:0] answer_2;

      wire enter = aresetn && s_valid[i] && s_ready[i];
      wire leave = aresetn && m_valid[R] && m_ready[R] && (m_data[7*R+4 +: 3] == i);

      assign s_data[4*i +: 4] = {next_in, i[2:0]};

      always @(posedge aclk) begin
        next_in  <= next_in ^ enter;
        next_out <= next_out ^ leave;
        inside   <= inside + {1'b0, enter} - {1'b0, leave};
        offered  <= aresetn && s_valid[i] && !s_ready[i];
        named    <= {named[0], aresetn && answer_valid[R] && (answers[6*R+3 +: 3] == i)};
        answer_1 <= answers[6*R +: 3];
        answer_2 <= answer_1;
      end

      always @* begin
        if (offered) begin
          assume(s_valid[i]);
        end
        if (aresetn) begin
          assert(inside <= 2'd2);
          if (m_valid[R] && (m_data[7*R+4 +: 3] == i)) begin
            assert(inside != 2'd0);
            assert(m_data[7*R+3] == next_out);
            assert(m_data[7*R +: 3] == i);
          end
          assert(lane_answer_valid[i] == named[1]);
          if (named[1]) begin
            assert({lane_answer_slot[i], lane_answer_verdict[2*i +: 2]}
                                     == answer_2);
          end
          cover(lane_answer_valid[i]);
          cover(leave && next_out);
        end
      end
    end

    for (i = 0; i < REFERENCES; i = i + 1) begin : g_reference
      localparam [1:0] LAST_BEAT = (1 << BEAT_BITS) - 1;

      reg  [1:0] beat = 2'd0;  // the number of the beat that leaves next
      reg  [2:0] sender;       // the lane that sent the request's beats before it
      wire       leaves = aresetn && m_valid[i] && m_ready[i];

      always @(posedge aclk) begin
        if (leaves) begin
          beat   <= (beat == LAST_BEAT) ? 2'd0 : beat + 2'd1;
          sender <= m_data[7*i+4 +: 3];
        end
      end

      always @* begin
        if (aresetn) begin
          assert(!m_valid[i] || (beat == 2'd0)
                 || (m_data[7*i+4 +: 3] == sender));
          cover((LANES <= i) || (leaves && (beat == LAST_BEAT)));
        end
      end

      always @* begin
        if (aresetn && m_valid[i]) begin
          assert((m_data[7*i+4 +: 3] < LANES)
                                 && (m_data[7*i+4 +: 3] % REFERENCES == i));
        end
      end
    end
  endgenerate

endmodule

`default_nettype wire
