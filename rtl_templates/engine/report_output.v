// report_output: sends the reports of a set to a port, and then a closing beat with their number;
// see docs/ports.md for the fields. A report is {flags, undecided, recomputed, verdict, j, i}.
// Latency 1. Reset forgets the set.
`default_nettype none

module report_output #(
  parameter INDEX_BITS = 10,  // bits of an item's index, 1 or more
  parameter FLAG_BITS = 0,    // flags of a report, 0 or more; 0: tdata has no flags
  // 1: no report leaves; all are counted, and the tag of the beat with tlast is the number of pairs
  // that did not come as reports. 0: reports leave.
  parameter COUNT = 0
) (
  input  wire                                                       aclk,
  input  wire                                                       aresetn,
  input  wire                                                       s_axis_tvalid,
  output wire                                                       s_axis_tready,
  input  wire [(FLAG_BITS > 0 ? FLAG_BITS : 1)+2*INDEX_BITS+3:0]    s_axis_tdata,
  input  wire                                                       s_axis_tlast,
  input  wire                                                       overrun,
  output wire                                                       m_axis_tvalid,
  input  wire                                                       m_axis_tready,
  output wire [8*((FLAG_BITS+7)/8)+16*((INDEX_BITS+7)/8)-1:0]       m_axis_tdata,
  output wire [7:0]                                                 m_axis_tuser,
  output wire                                                       m_axis_tlast
);

  localparam TAG_BITS    = 2 * INDEX_BITS;
  localparam HELD_FLAGS  = (FLAG_BITS > 0) ? FLAG_BITS : 1;
  localparam FIELD_BITS  = 8 * ((INDEX_BITS + 7) / 8);
  localparam TDATA_BITS  = 8 * ((FLAG_BITS + 7) / 8) + 2 * FIELD_BITS;
  localparam [TAG_BITS-1:0] NONE = 0;
  localparam [TAG_BITS-1:0] ONE  = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (INDEX_BITS < 1) begin : g_refused_index_bits INDEX_BITS_is_below_1 refused (); end
    if (FLAG_BITS < 0) begin : g_refused_flag_bits FLAG_BITS_is_below_0 refused (); end
  endgenerate

  wire [HELD_FLAGS-1:0] flags;
  wire                  undecided;
  wire                  recomputed;
  wire [1:0]            verdict;
  wire [INDEX_BITS-1:0] index_i;
  wire [INDEX_BITS-1:0] index_j;

  assign {flags, undecided, recomputed, verdict, index_j, index_i} = s_axis_tdata;

  // The number of the set's reports so far, which the closing beat sends.
  reg  [TAG_BITS-1:0] count_q;
  wire [TAG_BITS-1:0] count = (COUNT != 0) ? count_q + {index_j, index_i} : count_q;
  wire                take  = s_axis_tvalid && s_axis_tready;

  always @(posedge aclk) begin
    if (!aresetn || (take && s_axis_tlast)) begin
      count_q <= NONE;
    end else if (take) begin
      count_q <= count_q + ONE;
    end
  end

  reg  [2*FIELD_BITS-1:0] fields;
  wire [TDATA_BITS-1:0]   tdata;

  always @* begin
    fields = {(2*FIELD_BITS){1'b0}};
    if (s_axis_tlast) begin
      fields[TAG_BITS-1:0] = count;
    end else begin
      fields[INDEX_BITS-1:0]           = index_i;
      fields[FIELD_BITS +: INDEX_BITS] = index_j;
    end
  end

  generate
    if (FLAG_BITS == 0) begin : g_pairs
      wire unused_flags = flags;
      assign tdata = fields;
    end else begin : g_bitmap
      reg [TDATA_BITS-2*FIELD_BITS-1:0] flag_field;

      always @* begin
        flag_field = {(TDATA_BITS-2*FIELD_BITS){1'b0}};
        if (!s_axis_tlast) begin
          flag_field[FLAG_BITS-1:0] = flags;
        end
      end

      assign tdata = {flag_field, fields};
    end
  endgenerate

  reg                  m_valid_q;
  reg                  m_last_q;
  reg [7:0]            m_user_q;
  reg [TDATA_BITS-1:0] m_data_q;
  wire                 offers = s_axis_tvalid && (s_axis_tlast || (COUNT == 0));

  assign s_axis_tready = !m_valid_q || m_axis_tready;

  always @(posedge aclk) begin
    if (!aresetn) begin
      m_valid_q <= 1'b0;
    end else if (s_axis_tready) begin
      m_valid_q <= offers;
    end
  end

  always @(posedge aclk) begin
    if (s_axis_tready) begin
      m_last_q <= s_axis_tlast;
      m_data_q <= tdata;
      m_user_q <= s_axis_tlast ? {1'b1, overrun, 6'b000000}
                               : {4'b0000, undecided, recomputed, verdict};
    end
  end

  assign m_axis_tvalid = m_valid_q;
  assign m_axis_tdata  = m_data_q;
  assign m_axis_tuser  = m_user_q;
  assign m_axis_tlast  = m_last_q;

endmodule

`default_nettype wire
