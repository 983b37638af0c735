// fixed_table: the word at an address.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
`default_nettype none

module fixed_table #(
  parameter       ADDRESS_BITS = 2,    // 1 to 10
  parameter       WIDTH        = 4,    // bits of a word, 1 or more
  // the words, that of address 0 in the lowest bits
  parameter [(WIDTH<<ADDRESS_BITS)-1:0] WORDS = 0,
  parameter [0:0] CUTS         = 1'b0  // 1: a register behind the stage
) (
  input  wire                    aclk,
  input  wire [ADDRESS_BITS-1:0] address,
  output wire [WIDTH-1:0]        y
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if ((ADDRESS_BITS < 1) || (ADDRESS_BITS > 10)) begin : g_refused_address
      ADDRESS_BITS_is_not_1_to_10 refused ();
    end
    if (WIDTH < 1) begin : g_refused_width WIDTH_is_below_1 refused (); end
  endgenerate

  // Logic shares what the words have in common; a memory would not.
  (* ram_style = "logic", rom_style = "distributed" *)
  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];

  genvar k;
  generate
    for (k = 0; k < (1 << ADDRESS_BITS); k = k + 1) begin : g_word
      initial words[k] = WORDS[k*WIDTH+:WIDTH];
    end
  endgenerate

  // Stage read.
  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (words[address]),
    .q   (y)
  );

endmodule

`default_nettype wire
