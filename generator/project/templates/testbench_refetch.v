  // The memory behind each refetch stream answers a tag with the operands of its comparison. It
  // takes more tags than may be on the way, so that whoever asks has to wait as well.
  genvar r;
  generate
    for (r = 0; r < REFETCH_STREAMS; r = r + 1) begin : refetch
      reg  [31:0] queue [0:31];  // indices of comparisons
      reg  [5:0]  head;
      reg  [5:0]  tail;
      reg  [4:0]  pause;  // cycles until the next answer
      reg         busy;   // takes no tag in this cycle
      wire [5:0]  queued = tail - head;
      integer     index;

      assign m_refetch_tready[r] = (queued < 6'd32) && !busy;
      assign s_refetch_tvalid[r] = (queued != 6'd0) && (pause == 5'd0);
      assign s_refetch_tdata[r*TDATA_BITS +: TDATA_BITS]
          = s_refetch_tvalid[r] ? vectors[queue[head[4:0]]][TDATA_BITS-1:0] : {TDATA_BITS{1'b0}};

      always @(posedge aclk) begin
        if (!aresetn) begin
          head <= 6'd0;
          tail <= 6'd0;
          pause <= 5'd0;
          busy <= 1'b0;
        end else begin
          busy <= backpressure && (random_state[9:8] == 2'd0);
          if (pause != 5'd0) pause <= pause - 5'd1;
          if (s_refetch_tvalid[r] && s_refetch_tready[r]) begin
            head <= head + 6'd1;
            pause <= backpressure ? random_state[4:0] : 5'd2;
          end
          if (m_refetch_tvalid[r] && m_refetch_tready[r]) begin
            index = index_of(m_refetch_tdata[r*TAG_FIELD +: TAG_BITS]);
            if ((index < 0) || (status[(index < 0) ? 0 : index] != INSIDE)) begin
              $display("reference %0d, pass %0d, cycle %0d: a refetch of the unknown tag %h",
                       r, pass, cycle, m_refetch_tdata[r*TAG_FIELD +: TAG_BITS]);
              count_failure;
              index = 0;
            end
            queue[tail[4:0]] <= index;
            tail <= tail + 6'd1;
          end
        end
      end
    end
  endgenerate

