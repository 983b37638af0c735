// pair_code: the code of one pair in a beat. Its top bit says that the pair is reported. The bits
// below are then the verdict if CODE_BITS = 3, and 0 if CODE_BITS = 2. Without the top bit, 1 means
// undecided; 0 means that the pair has not met or that its verdict is not reported.
// Combinational.
`default_nettype none

module pair_code #(
  parameter REPORT = 11,    // 0 to 15: bit v is 1 where verdict v is reported
  parameter CODE_BITS = 3,  // bits of a code: 3, or 2 if at most one verdict is reported
  parameter COUNT = 0       // 1: reported pairs are counted outside, and their code is 0
) (
  input  wire                 met,
  input  wire                 decided,
  input  wire [1:0]           verdict,
  output wire                 reported,
  output wire [CODE_BITS-1:0] code
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((REPORT >> 4) != 0) begin : g_refused_report REPORT_is_not_0_to_15 refused (); end
    if ((CODE_BITS != 3) && ((CODE_BITS != 2) || ((REPORT & (REPORT - 1)) != 0)))
    begin : g_refused_code_bits
      CODE_BITS_is_not_3_nor_2_for_one_verdict refused ();
    end
  endgenerate

  wire [3:0] reports   = REPORT[3:0];
  wire       undecided = met && !decided;
  wire       leaves    = reported && (COUNT == 0);

  assign reported = met && decided && reports[verdict];

  generate
    if (CODE_BITS == 2) begin : g_one_verdict
      assign code = {leaves, undecided};
    end else begin : g_any_verdict
      assign code = leaves ? {1'b1, verdict} : {2'b00, undecided};
    end
  endgenerate

endmodule

`default_nettype wire
