// fixed_table: the word at an address.
// Latency: the population count of CUTS (one bit); initiation interval 1; no reset.
`default_nettype none

module fixed_table #(
  parameter                             ADDRESS_BITS = 2,    // bits of the address, 1 to 10
  parameter                             WIDTH        = 4,    // bits of a word, 1 or more
  parameter [(WIDTH<<ADDRESS_BITS)-1:0] WORDS        = 0,    // address 0 in the lowest bits
  parameter [0:0]                       CUTS         = 1'b0  // 1: a register behind the stage
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

  // The words become logic, which is smaller than a block memory for each table (Yosys reads
  // ram_style first, Vivado rom_style, Quartus romstyle). Yosys has no distributed memory that is
  // only read, so its ram_style is "registers", which gives look-up tables.
  (* ram_style = "registers", rom_style = "distributed", romstyle = "logic" *)
  reg [WIDTH-1:0] words [0:(1<<ADDRESS_BITS)-1];

  genvar k;
  generate
    for (k = 0; k < (1 << ADDRESS_BITS); k = k + 1) begin : g_word
      initial words[k] = WORDS[k*WIDTH+:WIDTH];
    end
  endgenerate

  // Stage read.
  wire [WIDTH-1:0] s0_word = words[address];

  fp_rank #(
    .WIDTH     (WIDTH),
    .REGISTERED(CUTS[0])
  ) rank_0 (
    .aclk(aclk),
    .d   (s0_word),
    .q   (y)
  );

endmodule

`default_nettype wire
