  task check_counter(input integer lane, input integer which, input [COUNTER_BITS-1:0] counted,
                     input [31:0] seen);
    reg [COUNTER_BITS+31:0] wide;
    begin
      wide = {{COUNTER_BITS{1'b0}}, seen};
      if (counted !== wide[COUNTER_BITS-1:0]) begin
        case (which)
          0: $write("comparisons of lane %0d", lane);
          1: $write("recomputations of lane %0d", lane);
          default: $write("@RESULT_COUNTER@");
        endcase
        $display(": the counter is %0d in place of %0d", counted, wide[COUNTER_BITS-1:0]);
        count_failure;
      end
    end
  endtask

  task check_counters;
    integer k;
    begin
      for (k = 0; k < LANES; k = k + 1) begin
        check_counter(k, 0, comparisons[k*COUNTER_BITS +: COUNTER_BITS], compared[k]);
        check_counter(k, 1, recomputations[k*COUNTER_BITS +: COUNTER_BITS], recomputed[k]);
      end
      check_counter(0, 2, @RESULT_COUNTER@, results);
    end
  endtask
