// fp_fit: brings a fraction to another width by its leading bits; `sticky` is the OR of the rest.
// Combinational: wires, and the OR.
`default_nettype none

module fp_fit #(
  parameter FROM = 48,  // bits of `value`, 1 or more
  parameter TO   = 26   // bits of `fitted`, 1 or more
) (
  input  wire [FROM-1:0] value,
  output wire [TO-1:0]   fitted,
  output wire            sticky
);

  // Invalid parameters instantiate a module that does not exist: elaboration fails.
  generate
    if (FROM < 1) begin : g_refused_from FROM_is_below_1 refused (); end
    if (TO < 1) begin : g_refused_to TO_is_below_1 refused (); end
  endgenerate

  generate
    if (FROM > TO) begin : g_narrower
      assign fitted = value[FROM-1:FROM-TO];
      assign sticky = |value[FROM-TO-1:0];
    end else if (FROM == TO) begin : g_same
      assign fitted = value;
      assign sticky = 1'b0;
    end else begin : g_wider
      assign fitted = {value, {(TO - FROM) {1'b0}}};
      assign sticky = 1'b0;
    end
  endgenerate

endmodule

`default_nettype wire
