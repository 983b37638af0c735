// fifo_view: the contents of a stream_fifo, read from its registers: `count` words, and word 0 of
// `contents` leaves next. Words from `count` on mean nothing. If the order matters little, `holds`
// is easier for a solver. Its bit 0 says that the output register holds a word, bit k + 1 that
// place k of the memory does. `ranks` has 4 bits for each of these places: how many words leave
// before the place's word. From the cycle in which `started` is 1, this module asserts that no more
// words are stored than there are places, and that a word is on offer if more than one is inside.
`default_nettype none

module fifo_view #(
  parameter WIDTH = 8,
  parameter DEPTH_BITS = 1  // up to 3
) (
  input  wire                                 started,
  input  wire [DEPTH_BITS:0]                  write_q,
  input  wire [DEPTH_BITS:0]                  read_q,
  input  wire                                 m_valid_q,
  input  wire [(1<<DEPTH_BITS)*WIDTH-1:0]     words,   // the memory's words
  input  wire [WIDTH-1:0]                     m_data,
  output wire [3:0]                           count,
  output reg  [((1<<DEPTH_BITS)+1)*WIDTH-1:0] contents,
  output reg  [(1<<DEPTH_BITS):0]             holds,
  output reg  [((1<<DEPTH_BITS)+1)*4-1:0]     ranks
);

  localparam DEPTH = 1 << DEPTH_BITS;

  wire [DEPTH_BITS:0]   stored = write_q - read_q;
  reg  [DEPTH_BITS-1:0] place;
  integer               k;
  integer               w;

  assign count = stored + m_valid_q;

  always @* begin
    contents = {(DEPTH+1){m_data}};
    for (k = 0; k < DEPTH; k = k + 1) begin
      place = read_q[DEPTH_BITS-1:0] + k;
      for (w = 0; w < DEPTH; w = w + 1) begin
        if (place == w) begin
          contents[(k+1)*WIDTH +: WIDTH] = words[w*WIDTH +: WIDTH];
        end
      end
    end
    if (!m_valid_q) begin
      contents = contents >> WIDTH;
    end
    holds = m_valid_q;
    ranks = 0;
    for (k = 0; k < DEPTH; k = k + 1) begin
      place              = k - read_q[DEPTH_BITS-1:0];
      holds[k+1]         = (place < stored);
      ranks[4*(k+1) +: 4] = place + m_valid_q;
    end
    if (started) begin
      lemma_memory_is_large_enough: assert(stored <= DEPTH);
      lemma_offers_the_first: assert(m_valid_q || (stored <= 1));
    end
  end

endmodule

`default_nettype wire
