// MULT18X18D: the part of ECP5's multiplier that our cells use, after Lattice FPGA-TN-02205, sysDSP
// Usage Guide: one clock, registers in front of the product and behind it, no reset, factors with
// or without signs.
`default_nettype none

module MULT18X18D #(
  parameter REG_INPUTA_CLK   = "NONE",
  parameter REG_INPUTB_CLK   = "NONE",
  parameter REG_PIPELINE_CLK = "NONE",
  parameter REG_OUTPUT_CLK   = "NONE"
) (
  input wire CLK0, CE0, RST0, SIGNEDA, SIGNEDB, SOURCEA, SOURCEB,
  input wire A0, A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11, A12, A13, A14, A15, A16, A17,
  input wire B0, B1, B2, B3, B4, B5, B6, B7, B8, B9, B10, B11, B12, B13, B14, B15, B16, B17,
  input wire C0, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, C15, C16, C17,
  output wire P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, P10, P11, P12, P13, P14, P15, P16, P17,
  output wire P18, P19, P20, P21, P22, P23, P24, P25, P26, P27, P28, P29, P30, P31, P32, P33,
  output wire P34, P35
);

  wire [17:0] a = {A17, A16, A15, A14, A13, A12, A11, A10, A9, A8, A7, A6, A5, A4, A3, A2, A1, A0};
  wire [17:0] b = {B17, B16, B15, B14, B13, B12, B11, B10, B9, B8, B7, B6, B5, B4, B3, B2, B1, B0};
  wire [17:0] input_a, input_b;
  wire signed [18:0] factor_a = {SIGNEDA & input_a[17], input_a};
  wire signed [18:0] factor_b = {SIGNEDB & input_b[17], input_b};
  wire [35:0] pipeline, result;
  wire [37:0] product = factor_a * factor_b;

  assign {P35, P34, P33, P32, P31, P30, P29, P28, P27, P26, P25, P24, P23, P22, P21, P20, P19, P18,
          P17, P16, P15, P14, P13, P12, P11, P10, P9, P8, P7, P6, P5, P4, P3, P2, P1, P0} = result;

  generate
    if (REG_INPUTA_CLK == "CLK0") begin : g_input_a
      reg [17:0] value;
      always @(posedge CLK0) if (CE0) value <= a;
      assign input_a = value;
    end else begin : g_no_input_a
      assign input_a = a;
    end
    if (REG_INPUTB_CLK == "CLK0") begin : g_input_b
      reg [17:0] value;
      always @(posedge CLK0) if (CE0) value <= b;
      assign input_b = value;
    end else begin : g_no_input_b
      assign input_b = b;
    end
    if (REG_PIPELINE_CLK == "CLK0") begin : g_pipeline
      reg [35:0] value;
      always @(posedge CLK0) if (CE0) value <= product[35:0];
      assign pipeline = value;
    end else begin : g_no_pipeline
      assign pipeline = product[35:0];
    end
    if (REG_OUTPUT_CLK == "CLK0") begin : g_output
      reg [35:0] value;
      always @(posedge CLK0) if (CE0) value <= pipeline;
      assign result = value;
    end else begin : g_no_output
      assign result = pipeline;
    end
  endgenerate

endmodule

`default_nettype wire
