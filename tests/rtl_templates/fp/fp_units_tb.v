// fp_units_tb: the units of fp_units with the same answers, in another simulator. Reads the files
// of `fp_... write`: latencies.hex, one a slot; stimuli.hex, {exceptional, a, b} each 128 bits;
// answers.hex, one a behaviour and stimulus, {y matters, flag matters, flag, y}. Verilog-2001.
`default_nettype none

module fp_units_tb;

  parameter         EXPONENT_BITS = 4;
  parameter         PRECISION     = 4;
  parameter [127:0] SOME_CUTS     = {64{2'b01}};
  parameter         COUNT         = 1024;

  localparam BEHAVIOURS = 52;
  localparam COLUMNS    = 12;
  localparam MASKS      = 3;  // number of columns that are built
  localparam SLOTS      = BEHAVIOURS * COLUMNS;
  localparam CHECKS     = COUNT * BEHAVIOURS * MASKS;

  reg          aclk = 1'b0;
  reg  [256:0] stimuli  [0:COUNT-1];
  reg  [130:0] answers  [0:COUNT*BEHAVIOURS-1];
  reg  [31:0]  latencies[0:SLOTS-1];
  reg  [256:0] stimulus = 257'd0;
  reg  [130:0] answer;
  integer      cycle;
  integer      slot;
  integer      then_cycle;
  integer      checked = 0;
  integer      wrong   = 0;

  fp_units #(
      .EXPONENT_BITS       (EXPONENT_BITS),
      .PRECISION           (PRECISION),
      .RESULT_EXPONENT_BITS(EXPONENT_BITS),
      .RESULT_PRECISION    (PRECISION),
      .SOME_CUTS           (SOME_CUTS),
      .SLOTS               (SLOTS)
  ) dut (
      .aclk       (aclk),
      .a          (stimulus[255:128]),
      .b          (stimulus[127:0]),
      .exceptional(stimulus[256])
  );

  // Compares by `!==`, so an unknown answer is a wrong one.
  task check;
    begin
      then_cycle = cycle - latencies[slot];
      answer     = answers[then_cycle*BEHAVIOURS+slot/COLUMNS];
      checked    = checked + 1;
      if ((answer[130] && dut.y[slot] !== answer[127:0])
          || (answer[129] && dut.flag[slot] !== answer[128])) begin
        wrong = wrong + 1;
        $display("WRONG slot %0d stimulus %h: expected %h flag %b, got %h flag %b", slot,
                 stimuli[then_cycle], answer[127:0], answer[128], dut.y[slot], dut.flag[slot]);
      end
    end
  endtask

  initial begin
    $readmemh("latencies.hex", latencies);
    $readmemh("stimuli.hex", stimuli);
    $readmemh("answers.hex", answers);
    for (cycle = 0; checked < CHECKS && cycle < COUNT + 128; cycle = cycle + 1) begin
      stimulus = stimuli[cycle%COUNT];
      #1;
      for (slot = 0; slot < SLOTS; slot = slot + 1) begin
        if (slot % COLUMNS < MASKS && cycle >= latencies[slot]
            && cycle - latencies[slot] < COUNT) begin
          check;
        end
      end
      aclk = 1'b1;
      #1 aclk = 1'b0;
    end
    $display("%0d answers, %0d wrong", checked, wrong);
    if (wrong == 0 && checked == CHECKS) $display("PASS");
    $finish(0);
  end

endmodule

`default_nettype wire
