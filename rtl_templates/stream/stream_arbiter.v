// stream_arbiter: merges INPUTS streams into one, round-robin: no input waits for more than INPUTS
// - 1 packets of others. Latency 1, one word per cycle. Reset empties the output register.
//
// BEAT_BITS > 0: the words of a packet leave one after the other, however slowly they come. The
// select of the multiplexer is then a register. So the first word of a packet has latency 2 if its
// input differs from the last packet's and it was not there when that packet ended.
`default_nettype none

module stream_arbiter #(
  parameter INPUTS = 4,    // streams that are merged, 1 or more
  parameter WIDTH = 8,     // bits of a word, 1 or more
  // 1: at most one word in two cycles, and no path from m_axis_tready to s_axis_tready
  parameter HALF_RATE = 0,
  parameter BEAT_BITS = 0  // 0 to 8: a packet has 2^BEAT_BITS words
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire [INPUTS-1:0]       s_axis_tvalid,
  output wire [INPUTS-1:0]       s_axis_tready,
  input  wire [INPUTS*WIDTH-1:0] s_axis_tdata,
  output wire                    m_axis_tvalid,
  input  wire                    m_axis_tready,
  output wire [WIDTH-1:0]        m_axis_tdata
);

  function integer bits_to_count;  // the bits that count to values - 1, at least 1
    input integer values;
    begin
      bits_to_count = 1;
      while ((1 << bits_to_count) < values) begin
        bits_to_count = bits_to_count + 1;
      end
    end
  endfunction

  localparam SELECT_BITS = bits_to_count(INPUTS);
  localparam WORDS       = 1 << SELECT_BITS;
  localparam LAST_INPUT  = INPUTS - 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (INPUTS < 1) begin : g_refused_inputs INPUTS_is_below_1 refused (); end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((BEAT_BITS < 0) || (BEAT_BITS > 8))
      begin : g_refused_beat_bits BEAT_BITS_is_not_0_to_8 refused (); end
  endgenerate

  reg  [SELECT_BITS-1:0] last_q;   // the input served last, or the packet's
  reg                    m_valid_q;
  reg  [WIDTH-1:0]       m_data_q;
  reg  [SELECT_BITS-1:0] turn;     // the first valid input after that one, else the first of all
  wire [SELECT_BITS-1:0] select;   // the input whose words pass
  wire                   offered;  // that input has a word
  wire                   choose;   // `turn` is served next
  integer                i;

  wire room = !m_valid_q || (m_axis_tready && (HALF_RATE == 0));
  wire load = room && offered;

  always @* begin
    turn = last_q;
    for (i = INPUTS - 1; i >= 0; i = i - 1) begin
      if (s_axis_tvalid[i]) begin
        turn = i[SELECT_BITS-1:0];
      end
    end
    for (i = INPUTS - 1; i >= 0; i = i - 1) begin
      if (s_axis_tvalid[i] && (i[SELECT_BITS-1:0] > last_q)) begin
        turn = i[SELECT_BITS-1:0];
      end
    end
  end

  generate
    if (BEAT_BITS == 0) begin : g_words
      assign select  = turn;
      assign offered = |s_axis_tvalid;
      assign choose  = load;
    end else begin : g_packets
      localparam [BEAT_BITS-1:0] ONE = 1;

      reg [BEAT_BITS-1:0] beat_q;  // the number of the next word

      always @(posedge aclk) begin
        if (!aresetn) begin
          beat_q <= {BEAT_BITS{1'b0}};
        end else if (load) begin
          beat_q <= beat_q + ONE;
        end
      end

      // A turn ends with a packet, or when the input has no next packet.
      assign select  = last_q;
      assign offered = s_axis_tvalid[last_q];
      assign choose  = offered ? load && (&beat_q) : !(|beat_q);
    end
  endgenerate

  // Each select bit halves the list of words: four words and two select bits are one LUT6.
  reg [WORDS*WIDTH-1:0] words;
  integer               select_bit;
  integer               w;

  always @* begin
    words = {WORDS{{WIDTH{1'b0}}}};
    words[INPUTS*WIDTH-1:0] = s_axis_tdata;
    for (select_bit = 0; select_bit < SELECT_BITS; select_bit = select_bit + 1) begin
      for (w = 0; w < (WORDS >> (select_bit + 1)); w = w + 1) begin
        words[w*WIDTH +: WIDTH] = select[select_bit] ? words[(2*w+1)*WIDTH +: WIDTH]
                                                     : words[2*w*WIDTH +: WIDTH];
      end
    end
  end

  always @(posedge aclk) begin
    if (!aresetn) begin
      last_q    <= LAST_INPUT[SELECT_BITS-1:0];
      m_valid_q <= 1'b0;
    end else begin
      if (choose) begin
        last_q <= turn;
      end
      m_valid_q <= load || (m_valid_q && !m_axis_tready);
    end
  end

  always @(posedge aclk) begin
    if (load) begin
      m_data_q <= words[WIDTH-1:0];
    end
  end

  genvar input_index;
  generate
    for (input_index = 0; input_index < INPUTS; input_index = input_index + 1) begin : g_ready
      assign s_axis_tready[input_index] = room && (select == input_index);
    end
  endgenerate

  assign m_axis_tvalid = m_valid_q;
  assign m_axis_tdata  = m_data_q;

endmodule

`default_nettype wire
