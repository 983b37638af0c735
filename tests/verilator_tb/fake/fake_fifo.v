// First in, first out, 2^(POINTER_BITS-1) deep; the pusher knows that there is room.
`default_nettype none

module fake_fifo (aclk, aresetn, push, push_data, pop_valid, pop_ready, pop_data);

  parameter WIDTH = 8;
  parameter POINTER_BITS = 4;

  input  wire             aclk;
  input  wire             aresetn;
  input  wire             push;
  input  wire [WIDTH-1:0] push_data;
  output wire             pop_valid;
  input  wire             pop_ready;
  output wire [WIDTH-1:0] pop_data;

  reg [WIDTH-1:0]        memory [0:(1 << (POINTER_BITS - 1)) - 1];
  reg [POINTER_BITS-1:0] head;
  reg [POINTER_BITS-1:0] tail;

  assign pop_valid = head != tail;
  assign pop_data = memory[head[POINTER_BITS-2:0]];

  initial begin
    head = 0;
    tail = 0;
  end

  always @(posedge aclk) begin
    if (push) memory[tail[POINTER_BITS-2:0]] <= push_data;
    if (!aresetn) begin
      head <= 0;
      tail <= 0;
    end else begin
      if (push) tail <= tail + 1'b1;
      if (pop_valid && pop_ready) head <= head + 1'b1;
    end
  end

endmodule

`default_nettype wire
