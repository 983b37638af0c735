// step_thresholds: fixed_step_threshold at small widths, only for the tests.
// Slot k has COUNT = 1 + k / LASTS integers of KEPT + LAST bits and a sign, LAST = 1 + k % LASTS.
// Its mask of cuts is k modulo 8. The threshold of its step s is 101 (8 k + s) modulo 2^WIDTH: no
// two slots or steps have the same.
`default_nettype none

module step_thresholds #(
    parameter COUNTS = 3,
    parameter LASTS  = 7,
    parameter KEPT   = 1,
    parameter WIDTH  = 12
) (
    input wire                             aclk,
    input wire [COUNTS*(KEPT+LASTS+1)-1:0] integers  // in two's complement
);

  // The answers, which the test reads by hierarchical name, zero-extended.
  wire [63:0] thresholds[0:COUNTS*LASTS-1]  /* verilator public_flat_rd */;

  genvar slot, k;

  generate
    for (slot = 0; slot < COUNTS * LASTS; slot = slot + 1) begin : g_slot
      localparam       COUNT = 1 + slot / LASTS;
      localparam       LAST  = 1 + slot % LASTS;
      localparam [2:0] CUTS  = slot;

      wire [COUNT*(LAST+1)-1:0] leading;
      wire [WIDTH-1:0]          threshold;

      for (k = 0; k < COUNT; k = k + 1) begin : g_leading
        assign leading[k*(LAST+1)+:LAST+1] = integers[k*(KEPT+LASTS+1)+KEPT+:LAST+1];
      end

      fixed_step_threshold #(
          .COUNT      (COUNT),
          .LAST       (LAST),
          .WIDTH      (WIDTH),
          .THRESHOLD_0(101 * (8 * slot + 0)),
          .THRESHOLD_1(101 * (8 * slot + 1)),
          .THRESHOLD_2(101 * (8 * slot + 2)),
          .THRESHOLD_3(101 * (8 * slot + 3)),
          .THRESHOLD_4(101 * (8 * slot + 4)),
          .THRESHOLD_5(101 * (8 * slot + 5)),
          .THRESHOLD_6(101 * (8 * slot + 6)),
          .THRESHOLD_7(101 * (8 * slot + 7)),
          .CUTS       (CUTS)
      ) unit (
          .aclk     (aclk),
          .leading  (leading),
          .threshold(threshold)
      );

      assign thresholds[slot] = {{(64 - WIDTH) {1'b0}}, threshold};
    end
  endgenerate

endmodule

`default_nettype wire
