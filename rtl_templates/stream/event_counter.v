// event_counter: counts the events of each cycle, a bit of `step` for each that there may be, modulo
// 2^COUNTER_BITS. COUNTER_BITS = 0 builds nothing and ties the one bit of `count` to 0. Reset clears it.
`default_nettype none

module event_counter #(
  parameter COUNTER_BITS = 32,
  parameter EVENTS = 1
) (
  input  wire                                             aclk,
  input  wire                                             aresetn,
  input  wire [EVENTS-1:0]                                step,
  output wire [(COUNTER_BITS > 0 ? COUNTER_BITS : 1)-1:0] count
);

  // Parameters that do not fit: an instance of a module that does not exist.
  generate
    if (COUNTER_BITS < 0) begin : g_refused_counter_bits
      COUNTER_BITS_is_below_0 refused ();
    end
    if ((EVENTS < 1) || (EVENTS > 64)) begin : g_refused_events
      EVENTS_is_not_1_to_64 refused ();
    end
  endgenerate

  generate
    if (COUNTER_BITS == 0) begin : g_none
      wire unused_inputs = &{aclk, aresetn, step};
      assign count = 1'b0;
    end else begin : g_count
      reg  [COUNTER_BITS-1:0] count_q;
      reg  [6:0]              events;
      wire [COUNTER_BITS+6:0] next        = {7'd0, count_q} + {{COUNTER_BITS{1'b0}}, events};
      wire                    unused_next = &next;
      integer                 k;

      always @* begin
        events = 7'd0;
        for (k = 0; k < EVENTS; k = k + 1) begin
          events = events + {6'd0, step[k]};
        end
      end

      always @(posedge aclk) begin
        if (!aresetn) begin
          count_q <= {COUNTER_BITS{1'b0}};
        end else if (|step) begin
          count_q <= next[COUNTER_BITS-1:0];
        end
      end

      assign count = count_q;
    end
  endgenerate

endmodule

`default_nettype wire
