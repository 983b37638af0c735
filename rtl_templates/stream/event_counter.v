// event_counter: counts events modulo 2^COUNTER_BITS. Each bit of `step` is one event that may
// happen in a cycle. Reset clears the count.
`default_nettype none

module event_counter #(
  parameter COUNTER_BITS = 32,  // bits of the count, which wraps; 0: no counter and `count` is 1'b0
  parameter EVENTS = 1          // bits of `step`, 1 to 64; above 1 the count lags by one more cycle
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire [EVENTS-1:0]                                step,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] count
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits COUNTER_BITS_is_below_0 refused (); end
    if ((EVENTS < 1) || (EVENTS > 64))
      begin : g_refused_events EVENTS_is_not_1_to_64 refused (); end
  endgenerate

  generate
    if (COUNTER_BITS == 0) begin : g_none
      wire unused_inputs = &{aclk, aresetn, step};
      assign count = 1'b0;
    end else begin : g_count
      reg  [COUNTER_BITS-1:0] count_q;
      wire                    counts;
      wire [COUNTER_BITS-1:0] next;

      if (EVENTS == 1) begin : g_one
        wire [COUNTER_BITS-1:0] one = 1;

        assign counts = step;
        assign next   = count_q + one;
      end else begin : g_sum
        reg  [6:0]              sum;
        reg  [6:0]              sum_q;
        wire [COUNTER_BITS+6:0] whole        = {7'd0, count_q} + {{COUNTER_BITS{1'b0}}, sum_q};
        wire                    unused_whole = &whole;
        integer                 k;

        always @* begin
          sum = 7'd0;
          for (k = 0; k < EVENTS; k = k + 1) begin
            sum = sum + {6'd0, step[k]};
          end
        end

        always @(posedge aclk) begin
          if (!aresetn) begin
            sum_q <= 7'd0;
          end else begin
            sum_q <= sum;
          end
        end

        assign counts = 1'b1;
        assign next   = whole[COUNTER_BITS-1:0];
      end

      always @(posedge aclk) begin
        if (!aresetn) begin
          count_q <= {COUNTER_BITS{1'b0}};
        end else if (counts) begin
          count_q <= next;
        end
      end

      assign count = count_q;
    end
  endgenerate

endmodule

`default_nettype wire
