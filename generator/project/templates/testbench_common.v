  // The next number of a xorshift generator: the same numbers in every simulator.
  function [31:0] next_random(input [31:0] number);
    reg [31:0] x;
    begin
      x = number ^ (number << 13);
      x = x ^ (x >> 17);
      next_random = x ^ (x << 5);
    end
  endfunction

  task count_failure;
    begin
      failures = failures + 1;
      if (failures >= MAX_FAILURES) stopped = 1'b1;
    end
  endtask

@IF COUNTS@
  // A counter, of a @COUNTED_UNIT@ or of all (-1), must hold what was seen on the streams, modulo its width.
  task check_counter(input [8*14-1:0] name, input integer lane, input [COUNTER_BITS-1:0] counted,
                     input [31:0] seen);
    reg [COUNTER_BITS+31:0] wide;
    begin
      wide = {{COUNTER_BITS{1'b0}}, seen};
      if (counted !== wide[COUNTER_BITS-1:0]) begin
        $write("%0s", name);
        if (lane >= 0) $write(" of @COUNTED_UNIT@ %0d", lane);
        $display(": the counter is %0d in place of %0d", counted, wide[COUNTER_BITS-1:0]);
        count_failure;
      end
    end
  endtask

@END@
  // What the arguments of the simulation say.
  task read_arguments;
    begin
      random_state = 32'd2463534242;
      if ($value$plusargs("seed=%d", random_state)) random_state = {random_state[30:0], 1'b1};
      if ($value$plusargs("waves=%s", file_name)) begin
        $dumpfile(file_name);
        $dumpvars(0, @DUT@_tb);
      end
      if (!$value$plusargs("vectors=%s", file_name)) file_name = "@DUT@_tb.hex";
      $readmemh(file_name, vectors);
      if (^vectors[VECTORS-1] === 1'bx) begin
        $display("the file of vectors cannot be read, or is not whole");
        count_failure;
        stopped = 1'b1;
      end
    end
  endtask

  // Ends a simulation that has failed.
  task stop;
    begin
`ifdef __ICARUS__
      $fatal(0);  // whose exit code does not depend on options of vvp
`else
      $stop;
`endif
      $finish;  // for simulators whose $stop goes on
    end
  endtask

