// counter_memory_proof: a count that is read is what a counter that never wraps has counted, or had
// counted MOST_LATE cycles ago at the earliest, whenever anything steps and whenever it is reset. The
// counts have one digit more than the narrow counters need, so a step too many or too few above the
// narrow digits is MOST_LATE or more away.
`default_nettype none

module counter_memory_proof (
  input wire       aclk,
  input wire       aresetn_later,
  input wire [1:0] steps,
  input wire       start,
  input wire       index
);

  localparam MOST_LATE = 10;
  localparam MOST_WAIT = 10;

  reg        started = 1'b0;
  wire       aresetn = started && aresetn_later;
  reg        waiting = 1'b0;
  reg        held_index;
  wire       ready;
  wire       read_start = start && ready && !waiting;
  wire       read_index = waiting ? held_index : index;
  wire       read_done;
  wire [4:0] read_count;
  wire [5:0] counts;

  genvar k;
  generate
    for (k = 0; k < 2; k = k + 1) begin : g_counters
      event_counter #(
        .COUNTER_BITS(3)
      ) counter (
        .aclk   (aclk),
        .aresetn(aresetn),
        .step   (steps[k]),
        .count  (counts[3*k +: 3])
      );
    end
  endgenerate

  counter_memory #(
    .COUNTERS   (2),
    .NARROW_BITS(3),
    .WIDTH      (5),
    .INDEX_BITS (1)
  ) dut (
    .aclk      (aclk),
    .aresetn   (aresetn),
    .counts    (counts),
    .ready     (ready),
    .read_start(read_start),
    .read_index(read_index),
    .read_done (read_done),
    .read_count(read_count)
  );

  reg  [4:0] counted_0 = 5'd0;
  reg  [4:0] counted_1 = 5'd0;
  reg  [3:0] unready   = 4'd0;
  reg  [1:0] waited    = 2'd0;
  wire [4:0] late      = (held_index ? counted_1 : counted_0) - read_count;

  always @(posedge aclk) begin
    started <= 1'b1;
    if (!aresetn) begin
      counted_0 <= 5'd0;
      counted_1 <= 5'd0;
      unready   <= 4'd0;
      waiting   <= 1'b0;
    end else begin
      counted_0 <= counted_0 + {4'd0, steps[0]};
      counted_1 <= counted_1 + {4'd0, steps[1]};
      unready   <= ready ? 4'd0 : unready + 4'd1;
      waiting   <= read_start || (waiting && !read_done);
      waited    <= (waiting && !read_done) ? waited + 2'd1 : 2'd0;
    end
    if (read_start) begin
      held_index <= index;
    end
  end

  always @* begin
    if (started && aresetn) begin
      counts_all: assert(!read_done || (late <= MOST_LATE));
      answers_what_was_asked: assert(!read_done || waiting);
      answers_soon: assert(waited < 2'd2);
      ready_soon: assert(unready < MOST_WAIT);
      can_read_0: cover(read_done && !held_index && (read_count == 5'd17));
      can_read_1: cover(read_done && held_index && (read_count == 5'd9));
      can_wrap: cover(read_done && (read_count == 5'd1) && (counted_0 == 5'd2) && !held_index);
      can_be_late: cover(read_done && (late > 5'd3));
    end
  end

endmodule

`default_nettype wire
