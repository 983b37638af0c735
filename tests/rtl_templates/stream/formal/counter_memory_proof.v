// counter_memory_proof: a count that is read equals the count of a counter that never wraps, now or
// at most MOST_LATE cycles ago, whenever anything steps and whenever it is reset. The counts have
// one digit more than the narrow counters need, so a step too many or too few above the narrow
// digits is MOST_LATE or more away. The lemmas read registers of the template, and together hold by
// induction. For each place where a count may be (the stages, the memory, its output), they bound
// how far the count is behind the counter.
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
      waited    <= 2'd0;
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

  // Cycles since the reset, up to 7; the scan's token is at place `phase`.
  localparam [2:0] LONG = 7;
  reg  [2:0] age   = 3'd0;
  reg  [1:0] phase = 2'd0;

  always @(posedge aclk) begin
    if (!aresetn) begin
      age   <= 3'd0;
      phase <= 2'd0;
    end else begin
      age   <= (age == LONG) ? LONG : age + 3'd1;
      phase <= phase + 2'd1;
    end
  end

  // The template's registers that the lemmas read, and wires that only pass them on.
  (* hierconn *) wire [3:0] \dut.scan.token_q ;
  (* hierconn *) wire       \dut.scan.index_q ;
  (* hierconn *) wire       \dut.scan.at_counter_q ;
  (* hierconn *) wire       \dut.s0_valid ;
  (* hierconn *) wire       \dut.s0_index ;
  (* hierconn *) wire [2:0] \dut.s0_narrow ;
  (* hierconn *) wire       \dut.s1_valid_q ;
  (* hierconn *) wire       \dut.s1_index_q ;
  (* hierconn *) wire [2:0] \dut.s1_narrow_q ;
  (* hierconn *) wire       \dut.s1_stored_q ;
  (* hierconn *) wire [4:0] \dut.s1_count ;
  (* hierconn *) wire       \dut.s2_valid_q ;
  (* hierconn *) wire       \dut.s2_index_q ;
  (* hierconn *) wire [2:0] \dut.s2_narrow_q ;
  (* hierconn *) wire [1:0] \dut.s2_high ;
  (* hierconn *) wire       \dut.waiting_q ;
  (* hierconn *) wire [4:0] \dut.memory.words[0] ;
  (* hierconn *) wire [4:0] \dut.memory.words[1] ;

  // How far the count in each place is behind its counter's present count; narrow counts modulo 8.
  wire [4:0] s0_true     = \dut.s0_index   ? counted_1 : counted_0;
  wire [4:0] s1_true     = \dut.s1_index_q ? counted_1 : counted_0;
  wire [4:0] s2_true     = \dut.s2_index_q ? counted_1 : counted_0;
  wire [2:0] s0_behind   = s0_true[2:0] - \dut.s0_narrow ;
  wire [2:0] s1_behind   = s1_true[2:0] - \dut.s1_narrow_q ;
  wire [4:0] s2_behind   = s2_true - {\dut.s2_high , \dut.s2_narrow_q };
  wire [4:0] word_behind = s1_true - \dut.s1_count ;  // the stored count that stage 1 looks at
  wire [4:0] behind_0    = counted_0 - \dut.memory.words[0] ;
  wire [4:0] behind_1    = counted_1 - \dut.memory.words[1] ;
  wire [1:0] after_0     = phase;  // cycles since counter 0 was read
  wire [1:0] after_1     = phase - 2'd2;

  always @* begin
    if (started) begin
      lemma_token: assert((\dut.scan.token_q == (4'd1 << phase)) &&
                          (\dut.scan.index_q == phase[1]) && (\dut.scan.at_counter_q == !phase[0]));
      lemma_age: assert((age == LONG) || (age[1:0] == phase));
      lemma_counted: assert((age == LONG) || ((counted_0 <= age) && (counted_1 <= age)));
      lemma_narrow: assert(counts == {counted_1[2:0], counted_0[2:0]});
      lemma_stage_0: assert((\dut.s0_valid == (phase[0] && (age >= 3'd1))) &&
          (!\dut.s0_valid || ((\dut.s0_index == phase[1]) && (s0_behind <= 3'd1))));
      lemma_stage_1: assert((\dut.s1_valid_q == (!phase[0] && (age >= 3'd2))) &&
          (!\dut.s1_valid_q || ((\dut.s1_index_q == !phase[1]) && (s1_behind <= 3'd2))));
      lemma_stage_2: assert((\dut.s2_valid_q == (phase[0] && (age >= 3'd3))) &&
          (!\dut.s2_valid_q || ((\dut.s2_index_q == !phase[1]) && (s2_behind <= 5'd3))));
      lemma_first_round: assert((age >= 3'd5) ||
          ((!\dut.s0_valid || (\dut.s0_narrow <= s0_true)) &&
           (!\dut.s1_valid_q || (\dut.s1_narrow_q <= s1_true))));
      lemma_stored: assert(\dut.s1_stored_q == (age >= 3'd5));
      lemma_memory: assert(((age < 3'd4) || (behind_0 <= 5'd4 + after_0)) &&
                           ((age < 3'd6) || (behind_1 <= 5'd4 + after_1)));
      // A stored count is older than the narrow one it is compared with, by less than a wrap.
      lemma_compared_0: assert(!\dut.s0_valid || !\dut.s1_stored_q ||
                               ((\dut.s0_index ? behind_1 : behind_0) >= s0_behind));
      lemma_compared_1: assert(!\dut.s1_valid_q || (age < 3'd6) ||
                               ((word_behind >= s1_behind) && (word_behind <= 5'd6)));
      lemma_waits: assert((waiting == (\dut.waiting_q || read_done)) &&
          (!\dut.waiting_q || (!phase[0] && !read_done && (waited == 2'd0) && ready)));
      lemma_read: assert(!read_done || (phase[0] && (waited <= 2'd1) && ready && (late <= 5'd7)));
      lemma_unready: assert(ready ? (unready <= 4'd5) : (unready == age));
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
