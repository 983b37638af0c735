// operand_memory: a memory of full rows and one of full candidates. The references of an arg-min
// engine ask it for the operands of undecided pairs. A request is the pair's tag {index of its own
// candidate, index of the best, place of the row}. The answer is that candidate, the best one and
// the row, in the order of a reference's requests. All references together get one answer per
// cycle. Each has a register for its answer, which comes 2 cycles after the request at the
// earliest, and one more for each level of the tree of arbiters if there are several references.
// Rows may be written at any time, in places that no request names; candidates only while there is
// no request. Reset forgets the requests.
`default_nettype none

module operand_memory #(
  parameter REFERENCES = 1,       // number of references, 1 or more
  parameter CANDIDATE_BITS = 32,  // bits of a candidate, 1 or more
  parameter ROW_BITS = 32,        // bits of a row, 1 or more
  parameter INDEX_BITS = 2,       // bits of a candidate's index, 1 to 30
  parameter PLACE_BITS = 6        // bits of a row's place, 1 to 30; there are 2^PLACE_BITS rows
) (
  input  wire                                           aclk,
  input  wire                                           aresetn,
  input  wire                                           row_write,
  input  wire [PLACE_BITS-1:0]                          row_place,
  input  wire [ROW_BITS-1:0]                            row,
  input  wire                                           candidate_write,
  input  wire [INDEX_BITS-1:0]                          candidate_index,
  input  wire [CANDIDATE_BITS-1:0]                      candidate,
  input  wire [REFERENCES-1:0]                          s_ask_tvalid,
  output wire [REFERENCES-1:0]                          s_ask_tready,
  input  wire [REFERENCES*(2*INDEX_BITS+PLACE_BITS)-1:0] s_ask_tdata,
  output wire [REFERENCES-1:0]                          m_answer_tvalid,
  input  wire [REFERENCES-1:0]                          m_answer_tready,
  output wire [REFERENCES*(2*CANDIDATE_BITS+ROW_BITS)-1:0] m_answer_tdata  // {own, best, row}
);

  localparam ASK_BITS    = 2 * INDEX_BITS + PLACE_BITS;
  localparam ANSWER_BITS = 2 * CANDIDATE_BITS + ROW_BITS;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (REFERENCES < 1) begin : g_refused_references REFERENCES_is_below_1 refused (); end
  endgenerate

  // All requests as one stream; each carries one bit per reference, which says who asks.
  wire [REFERENCES*(REFERENCES+ASK_BITS)-1:0] asks;
  wire                                        ask_valid;
  wire [REFERENCES-1:0]                       asker;
  wire [INDEX_BITS-1:0]                       own;
  wire [INDEX_BITS-1:0]                       best;
  wire [PLACE_BITS-1:0]                       place;
  wire                                        read;

  genvar r;
  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_ask
      localparam [REFERENCES-1:0] ASKER = 1 << r;

      assign asks[r*(REFERENCES+ASK_BITS) +: REFERENCES+ASK_BITS] =
          {ASKER, s_ask_tdata[r*ASK_BITS +: ASK_BITS]};
    end
  endgenerate

  generate
    if (REFERENCES == 1) begin : g_one
      assign ask_valid                 = s_ask_tvalid;
      assign s_ask_tready              = read;
      assign {asker, own, best, place} = asks;
    end else begin : g_several
      stream_tree #(
        .INPUTS(REFERENCES),
        .WIDTH (REFERENCES + ASK_BITS)
      ) merge (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(s_ask_tvalid),
        .s_axis_tready(s_ask_tready),
        .s_axis_tdata (asks),
        .m_axis_tvalid(ask_valid),
        .m_axis_tready(read),
        .m_axis_tdata ({asker, own, best, place})
      );
    end
  endgenerate

  // The words that were read wait in the memories' outputs until the asker's register has room.
  reg                    waits_q;
  reg  [REFERENCES-1:0]  asker_q;
  wire [REFERENCES-1:0]  room;
  wire                   leaves  = waits_q && ((asker_q & room) != {REFERENCES{1'b0}});
  wire                   reading = ask_valid && read;
  wire [ANSWER_BITS-1:0] answer;

  assign read = !waits_q || leaves;

  always @(posedge aclk) begin
    if (!aresetn) begin
      waits_q <= 1'b0;
    end else if (read) begin
      waits_q <= ask_valid;
    end
  end

  always @(posedge aclk) begin
    if (reading) begin
      asker_q <= asker;
    end
  end

  dual_port_memory #(
    .WIDTH       (ROW_BITS),
    .ADDRESS_BITS(PLACE_BITS)
  ) rows (
    .aclk         (aclk),
    .write_enable (row_write),
    .write_address(row_place),
    .write_data   (row),
    .read_enable  (reading),
    .read_address (place),
    .read_data    (answer[ROW_BITS-1:0])
  );

  item_memory #(
    .WIDTH       (CANDIDATE_BITS),
    .ADDRESS_BITS(INDEX_BITS)
  ) candidates (
    .aclk        (aclk),
    .i_enable    (candidate_write || reading),
    .i_write     (candidate_write),
    .i_address   (candidate_write ? candidate_index : best),
    .i_write_data(candidate),
    .i_read_data (answer[ROW_BITS +: CANDIDATE_BITS]),
    .j_enable    (reading),
    .j_address   (own),
    .j_read_data (answer[ROW_BITS+CANDIDATE_BITS +: CANDIDATE_BITS])
  );

  generate
    for (r = 0; r < REFERENCES; r = r + 1) begin : g_answer
      stream_arbiter #(
        .INPUTS(1),
        .WIDTH (ANSWER_BITS)
      ) out (
        .aclk         (aclk),
        .aresetn      (aresetn),
        .s_axis_tvalid(waits_q && asker_q[r]),
        .s_axis_tready(room[r]),
        .s_axis_tdata (answer),
        .m_axis_tvalid(m_answer_tvalid[r]),
        .m_axis_tready(m_answer_tready[r]),
        .m_axis_tdata (m_answer_tdata[r*ANSWER_BITS +: ANSWER_BITS])
      );
    end
  endgenerate

endmodule

`default_nettype wire
