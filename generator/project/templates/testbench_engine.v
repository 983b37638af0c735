@INCLUDE testbench_common.v@
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

  // What stream s offers.
  function [BEAT_BITS-1:0] beat_of(input integer s);
    beat_of = {m_axis_tdata[s*TDATA_BITS +: TDATA_BITS], m_axis_tuser[s*TUSER_BITS +: TUSER_BITS],
               m_axis_tlast[s]};
  endfunction

  task check_held;
    integer s;
    begin
      for (s = 0; s < STREAMS; s = s + 1) begin
        if (m_axis_tvalid[s] === 1'bx || s_axis_tready === 1'bx
            || (m_axis_tvalid[s] && (^beat_of(s) === 1'bx))) begin
          $display("pass %0d, cycle %0d: x or z on a handshake or on a result", pass, cycle);
          count_failure;
        end else if (waiting[s] && (!m_axis_tvalid[s] || (beat_of(s)
                                    != waiting_beats[s*BEAT_BITS +: BEAT_BITS]))) begin
          $display("pass %0d, cycle %0d: a result changed before tready rose", pass, cycle);
          count_failure;
        end
        waiting[s] = m_axis_tvalid[s] && !m_axis_tready[s];
        waiting_beats[s*BEAT_BITS +: BEAT_BITS] = beat_of(s);
      end
      if (m_axis_tvalid !== valid_before) begin
        $display("pass %0d, cycle %0d: m_axis_tvalid follows m_axis_tready", pass, cycle);
        count_failure;
      end
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
      waiting = {STREAMS{1'b0}};
      idle_cycles = 1'b0;
      backpressure = 1'b0;
      offer_density = 9'd256;
      ready_density = 9'd256;
      read_arguments;
    end
  endtask
