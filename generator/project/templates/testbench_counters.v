  // Each lane's counters must hold what was seen on its streams, modulo their width.
  task check_counter(input integer lane, input integer which, input [COUNTER_BITS-1:0] counted,
                     input [31:0] seen);
    reg [COUNTER_BITS+31:0] wide;
    begin
      wide = {{COUNTER_BITS{1'b0}}, seen};
      if (counted !== wide[COUNTER_BITS-1:0]) begin
        case (which)
          0: $write("comparisons");
          1: $write("recomputations");
          default: $write("stalls");
        endcase
        $display(" of lane %0d: the counter is %0d in place of %0d",
                 lane, counted, wide[COUNTER_BITS-1:0]);
        count_failure;
      end
    end
  endtask

  task check_counters;
    integer k;
    begin
      for (k = 0; k < LANES; k = k + 1) begin
        check_counter(k, 0, comparisons[k*COUNTER_BITS +: COUNTER_BITS], accepted[k]);
        check_counter(k, 1, recomputations[k*COUNTER_BITS +: COUNTER_BITS], recomputed[k]);
        check_counter(k, 2, stalls[k*COUNTER_BITS +: COUNTER_BITS], stalled[k]);
      end
    end
  endtask

