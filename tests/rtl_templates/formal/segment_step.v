// segment_step: the effect of one word on a pair_segment with LANES lanes, by definition. From the
// state {gone, base, held, count} before the word, it computes the state behind the word, whether
// and as which word the word goes on, and the beat that it causes. Lane l answers a pair of words
// with 3 bits of `answers`. Combinational.
`default_nettype none

module segment_step #(
  parameter LANES = 2,
  parameter REPORT = 11,
  parameter CODE_BITS = 3,
  parameter COUNT = 0,
  parameter TIERED = 0
) (
  input  wire [11:0]                answers,    // {decided, verdict} of each pair of words
  input  wire [6:0]                 word,       // {close, first, stays, meets, index, word}
  input  wire [LANES+6:0]           before,
  output wire [LANES+6:0]           after,
  output wire                       stays,      // the word stays in a lane
  output wire [6:0]                 goes_as,
  output wire                       tells,      // a beat leaves that is not the closing one
  output reg  [LANES*CODE_BITS-1:0] codes,
  output wire [2:0]                 tier,       // {first, stays, word}, as a tier reads them
  output reg  [3:0]                 reported    // number of reported pairs
);

  localparam [3:0] NONE = 0;
  localparam [3:0] ONE  = 1;
  localparam [3:0] ALL  = LANES;
  localparam [3:0] REPORTS = REPORT[3:0];

  wire             close   = word[6];
  wire             first   = word[5];
  wire             gone    = before[LANES+6];
  wire [1:0]       base    = first ? word[2:1] : before[LANES+5:LANES+4];
  wire [LANES-1:0] held    = before[LANES+3:4];
  wire [3:0]       count   = first ? NONE : before[3:0];
  reg  [LANES-1:0] holds;  // lanes that hold a word behind this one
  reg  [2:0]       answer;
  integer          l;

  assign stays   = word[4] && !close && (count != ALL);
  assign goes_as = {close, first || !gone, word[4:0]};
  assign tier    = (TIERED != 0) ? {first, stays, word[0]} : 3'd0;
  assign tells   = !close && ((codes != {LANES*CODE_BITS{1'b0}}) ||
                              ((TIERED != 0) && (first || stays)));
  assign after   = {!stays, base, holds, stays ? count + ONE : count};

  always @* begin
    codes    = {LANES*CODE_BITS{1'b0}};
    reported = NONE;
    holds    = held;
    for (l = 0; l < LANES; l = l + 1) begin
      answer = answers[3*{word[0], held[l]} +: 3];
      if ((l < count) && word[3] && !close) begin
        if (!answer[2]) begin
          codes[l*CODE_BITS] = 1'b1;
        end else if (REPORTS[answer[1:0]]) begin
          reported = reported + ONE;
          if (COUNT == 0) begin
            codes[l*CODE_BITS + CODE_BITS - 1] = 1'b1;
            if (CODE_BITS == 3) begin
              codes[l*CODE_BITS +: 2] = answer[1:0];
            end
          end
        end
      end
      if (stays && (l == count)) begin
        holds[l] = word[0];
      end
    end
  end

endmodule

`default_nettype wire
