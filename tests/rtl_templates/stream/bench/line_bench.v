// line_bench: delay lines of 0, 1, 3 and 300 ranks, for data and for valid bits, a memory, and
// counters of 0, 3 and 32 bits.
`default_nettype none

module line_bench (
  input  wire        aclk,
  input  wire        aresetn,
  input  wire        step,
  input  wire [15:0] d,
  output wire [15:0] q0,
  output wire [15:0] q1,
  output wire [15:0] q3,
  output wire [15:0] q300,
  output wire        v0,
  output wire        v1,
  output wire        v3,
  output wire        v300,
  input  wire        write_enable,
  input  wire [4:0]  write_address,
  input  wire        read_enable,
  input  wire [4:0]  read_address,
  output wire [15:0] read_data,
  output wire        count0,
  output wire [2:0]  count3,
  output wire [31:0] count32
);

  delay_line #(.WIDTH(16), .LENGTH(0)) line_0 (.aclk(aclk), .d(d), .q(q0));
  delay_line #(.WIDTH(16), .LENGTH(1)) line_1 (.aclk(aclk), .d(d), .q(q1));
  delay_line #(.WIDTH(16), .LENGTH(3)) line_3 (.aclk(aclk), .d(d), .q(q3));
  delay_line #(.WIDTH(16), .LENGTH(300)) line_300 (.aclk(aclk), .d(d), .q(q300));

  valid_delay_line #(.LENGTH(0)) valid_0 (.aclk(aclk), .aresetn(aresetn), .d(step), .q(v0));
  valid_delay_line #(.LENGTH(1)) valid_1 (.aclk(aclk), .aresetn(aresetn), .d(step), .q(v1));
  valid_delay_line #(.LENGTH(3)) valid_3 (.aclk(aclk), .aresetn(aresetn), .d(step), .q(v3));
  valid_delay_line #(.LENGTH(300)) valid_300 (.aclk(aclk), .aresetn(aresetn), .d(step), .q(v300));

  event_counter #(.COUNTER_BITS(0)) counter_0 (
    .aclk(aclk), .aresetn(aresetn), .step(step), .count(count0)
  );
  event_counter #(.COUNTER_BITS(3)) counter_3 (
    .aclk(aclk), .aresetn(aresetn), .step(step), .count(count3)
  );
  event_counter #(.COUNTER_BITS(32)) counter_32 (
    .aclk(aclk), .aresetn(aresetn), .step(step), .count(count32)
  );

  dual_port_memory #(.WIDTH(16), .ADDRESS_BITS(5)) memory (
    .aclk         (aclk),
    .write_enable (write_enable),
    .write_address(write_address),
    .write_data   (d),
    .read_enable  (read_enable),
    .read_address (read_address),
    .read_data    (read_data)
  );

endmodule

`default_nettype wire
