// stream_arbiter: merges INPUTS streams into one, round-robin: no input waits for more than
// INPUTS - 1 words of others. Latency 1, one word per cycle. Reset empties the output register.
// HALF_RATE = 1: one word in two cycles at most, and no path from m_axis_tready to s_axis_tready.
`default_nettype none

module stream_arbiter #(
  parameter INPUTS = 4,
  parameter WIDTH = 8,
  parameter HALF_RATE = 0
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

  function integer bits_to_count;  // at least 1
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

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (INPUTS < 1) begin : g_refused_inputs
      INPUTS_is_below_1 refused ();
    end
    if (WIDTH < 1) begin : g_refused_width
      WIDTH_is_below_1 refused ();
    end
  endgenerate

  reg  [SELECT_BITS-1:0] last_q;    // the input served last
  reg                    m_valid_q;
  reg  [WIDTH-1:0]       m_data_q;

  wire room = !m_valid_q || (m_axis_tready && (HALF_RATE == 0));
  wire load = room && |s_axis_tvalid;

  // The first valid input after the one served last, else the first of all.
  reg [SELECT_BITS-1:0] select;
  integer               i;

  always @* begin
    select = last_q;
    for (i = INPUTS - 1; i >= 0; i = i - 1) begin
      if (s_axis_tvalid[i]) begin
        select = i[SELECT_BITS-1:0];
      end
    end
    for (i = INPUTS - 1; i >= 0; i = i - 1) begin
      if (s_axis_tvalid[i] && (i[SELECT_BITS-1:0] > last_q)) begin
        select = i[SELECT_BITS-1:0];
      end
    end
  end

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
      if (load) begin
        last_q <= select;
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
