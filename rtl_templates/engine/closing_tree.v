// closing_tree: merges INPUTS streams into one. Each input ends with a beat with tlast. Once all
// inputs have ended, one beat with tlast leaves behind all words. Fairness and latency are those of
// stream_tree. Reset empties the tree.
`default_nettype none

module closing_tree #(
  parameter INPUTS = 8,  // streams that are merged, 1 or more
  parameter WIDTH = 8,   // bits of a word, 1 or more
  // 0 to WIDTH. Above 0, the low COUNT_BITS of the inputs' last beats are numbers, and the beat
  // that leaves has their sum.
  parameter COUNT_BITS = 0
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire [INPUTS-1:0]       s_axis_tvalid,
  output wire [INPUTS-1:0]       s_axis_tready,
  input  wire [INPUTS*WIDTH-1:0] s_axis_tdata,
  input  wire [INPUTS-1:0]       s_axis_tlast,
  output wire                    m_axis_tvalid,
  input  wire                    m_axis_tready,
  output wire [WIDTH-1:0]        m_axis_tdata,
  output wire                    m_axis_tlast
);

  function integer bits_below;  // bits that count up to values - 1
    input integer values;
    begin
      bits_below = 1;
      while ((1 << bits_below) < values) begin
        bits_below = bits_below + 1;
      end
    end
  endfunction

  localparam CLOSED_BITS = bits_below(INPUTS);
  localparam OTHERS      = INPUTS - 1;
  localparam [CLOSED_BITS-1:0] ONE = 1;

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (INPUTS < 1) begin : g_refused_inputs INPUTS_is_below_1 refused (); end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
    if ((COUNT_BITS < 0) || (COUNT_BITS > WIDTH))
      begin : g_refused_count_bits COUNT_BITS_is_not_0_to_WIDTH refused (); end
  endgenerate

  wire [INPUTS*(WIDTH+1)-1:0] words;
  wire                        word_valid;
  wire                        word_ready;
  wire                        word_last;
  wire [WIDTH-1:0]            word;

  genvar s;
  generate
    for (s = 0; s < INPUTS; s = s + 1) begin : g_input
      assign words[s*(WIDTH+1) +: WIDTH+1] = {s_axis_tlast[s], s_axis_tdata[s*WIDTH +: WIDTH]};
    end
  endgenerate

  stream_tree #(
    .INPUTS(INPUTS),
    .WIDTH (WIDTH + 1)
  ) merge (
    .aclk         (aclk),
    .aresetn      (aresetn),
    .s_axis_tvalid(s_axis_tvalid),
    .s_axis_tready(s_axis_tready),
    .s_axis_tdata (words),
    .m_axis_tvalid(word_valid),
    .m_axis_tready(word_ready),
    .m_axis_tdata ({word_last, word})
  );

  reg  [CLOSED_BITS-1:0] closed_q;  // inputs that have ended
  wire                   all_others = (closed_q == OTHERS[CLOSED_BITS-1:0]);
  wire                   swallow    = word_last && !all_others;
  wire                   ends       = word_valid && word_ready && word_last;

  always @(posedge aclk) begin
    if (!aresetn || (ends && all_others)) begin
      closed_q <= {CLOSED_BITS{1'b0}};
    end else if (ends) begin
      closed_q <= closed_q + ONE;
    end
  end

  assign word_ready    = swallow || m_axis_tready;
  assign m_axis_tvalid = word_valid && !swallow;
  assign m_axis_tlast  = word_last;

  generate
    if (COUNT_BITS == 0) begin : g_no_count
      assign m_axis_tdata = word;
    end else begin : g_count
      reg  [COUNT_BITS-1:0] count_q;
      wire [COUNT_BITS-1:0] sum = count_q + word[COUNT_BITS-1:0];
      reg  [WIDTH-1:0]      counted;

      always @(posedge aclk) begin
        if (!aresetn || (ends && all_others)) begin
          count_q <= {COUNT_BITS{1'b0}};
        end else if (ends) begin
          count_q <= sum;
        end
      end

      always @* begin
        counted = word;
        if (word_last) begin
          counted[COUNT_BITS-1:0] = sum;
        end
      end

      assign m_axis_tdata = counted;
    end
  endgenerate

endmodule

`default_nettype wire
