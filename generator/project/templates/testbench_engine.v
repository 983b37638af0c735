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

  // Draws the shares of cycles with an offer and with tready high anew every 64 cycles.
  task draw;
    begin
      random_state = next_random(random_state);
      if (cycle % 64 == 0) begin
        offer_density = idle_cycles ? {1'b0, random_state[7:0]} : 9'd256;
        ready_density = backpressure ? {1'b0, random_state[15:8]} : 9'd256;
        random_state = next_random(random_state);
      end
    end
  endtask

  task check_held;
    begin
      if (m_axis_tvalid === 1'bx || s_axis_tready === 1'bx
          || (m_axis_tvalid && (^{m_axis_tdata, m_axis_tuser, m_axis_tlast} === 1'bx))) begin
        $display("pass %0d, cycle %0d: x or z on a handshake or on a result", pass, cycle);
        count_failure;
      end else if (waiting && (!m_axis_tvalid || ({m_axis_tdata, m_axis_tuser, m_axis_tlast}
                                                  != waiting_beat))) begin
        $display("pass %0d, cycle %0d: a result changed before tready rose", pass, cycle);
        count_failure;
      end
      if (m_axis_tvalid !== valid_before) begin
        $display("pass %0d, cycle %0d: m_axis_tvalid follows m_axis_tready", pass, cycle);
        count_failure;
      end
      waiting = m_axis_tvalid && !m_axis_tready;
      waiting_beat = {m_axis_tdata, m_axis_tuser, m_axis_tlast};
    end
  endtask

  task fail;
    begin
      $display("FAILED: %0d failure(s)", failures);
`ifdef __ICARUS__
      $fatal(0);  // whose exit code does not depend on options of vvp
`else
      $stop;
`endif
      $finish;  // for simulators whose $stop goes on
    end
  endtask

  task start;
    begin
      aclk = 1'b1;
      pass = 0;
      cycle = 0;
      last_progress = 0;
      results = 0;
      failures = 0;
      stopped = 1'b0;
      waiting = 1'b0;
      idle_cycles = 1'b0;
      backpressure = 1'b0;
      offer_density = 9'd256;
      ready_density = 9'd256;
      random_state = 32'd2463534242;
      if ($value$plusargs("seed=%d", random_state)) random_state = {random_state[30:0], 1'b1};
      if ($value$plusargs("waves=%s", file_name)) begin
        $dumpfile(file_name);
        $dumpvars(0, @ENGINE@_tb);
      end
      if (!$value$plusargs("vectors=%s", file_name)) file_name = "@ENGINE@_tb.hex";
      $readmemh(file_name, vectors);
      if (^vectors[VECTORS-1] === 1'bx) begin
        $display("the file of vectors cannot be read, or is not whole");
        count_failure;
        stopped = 1'b1;
      end
    end
  endtask
