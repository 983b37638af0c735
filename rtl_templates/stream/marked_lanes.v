// marked_lanes: the numbers of the lanes that a word marks, one after the other, the lowest first.
// The word stays on offer until its last lane is taken, and is taken with it. Latency 1; a number
// per cycle, with a gap of one cycle after each word. A word without a marked lane stays for ever.
// LANES = 1: no registers, and each word gives number 0 at once. Reset restarts the word.
`default_nettype none

module marked_lanes #(
  parameter LANES = 4  // lanes in lock step, 1 to 64
) (
  input  wire             aclk,
  input  wire             aresetn,
  input  wire             s_word_valid,
  output wire             s_word_ready,
  input  wire [LANES-1:0] s_word_lanes,
  output wire             m_lane_valid,
  input  wire             m_lane_ready,
  output wire [5:0]       m_lane
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((LANES < 1) || (LANES > 64)) begin : g_refused_lanes LANES_is_not_1_to_64 refused (); end
  endgenerate

  generate
    if (LANES == 1) begin : g_one_lane
      wire unused_inputs = &{aclk, aresetn, s_word_lanes};

      assign s_word_ready = m_lane_ready;
      assign m_lane_valid = s_word_valid;
      assign m_lane       = 6'd0;
    end else begin : g_lanes
      localparam [LANES-1:0] ONE = 1;

      reg  [LANES-1:0] shown_q;  // lanes of the current word whose numbers are or were on m_lane
      reg              lane_valid_q;
      reg  [5:0]       lane_q;
      wire [LANES-1:0] left   = s_word_lanes & ~shown_q;
      wire [LANES-1:0] lowest = left & (~left + ONE);
      wire             room   = !lane_valid_q || m_lane_ready;
      wire             load   = s_word_valid && (|left) && room;
      reg  [5:0]       lowest_lane;
      integer          k;

      always @* begin
        lowest_lane = 6'd0;
        for (k = 0; k < LANES; k = k + 1) begin
          lowest_lane = lowest_lane | (lowest[k] ? k[5:0] : 6'd0);
        end
      end

      assign s_word_ready = lane_valid_q && m_lane_ready && !(|left);

      always @(posedge aclk) begin
        if (!aresetn) begin
          shown_q      <= {LANES{1'b0}};
          lane_valid_q <= 1'b0;
        end else begin
          if (s_word_ready) begin
            shown_q <= {LANES{1'b0}};
          end else if (load) begin
            shown_q <= shown_q | lowest;
          end
          lane_valid_q <= load || !room;
        end
      end

      always @(posedge aclk) begin
        if (load) begin
          lane_q <= lowest_lane;
        end
      end

      assign m_lane_valid = lane_valid_q;
      assign m_lane       = lane_q;
    end
  endgenerate

endmodule

`default_nettype wire
