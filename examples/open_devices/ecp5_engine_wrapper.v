// The wrapper that `mixcmp route` puts around the engine of ecp5_engine.toml: a shift register feeds all
// inputs, a registered tree of XORs folds all outputs into one pin (docs/devices.md).
module mixcmp_wrapper_of_sphere_collision_q9_105_q8_15x1_pairwise (input wire clock, input wire serial, output wire folded);
  reg [252:0] inputs;
  always @(posedge clock) inputs <= {inputs[251:0], serial};
  wire [42:0] outputs;
  sphere_collision_q9_105_q8_15x1_pairwise wrapped (
    .\aclk (clock),
    .\aresetn (inputs[0:0]),
    .\m_axis_tdata (outputs[31:0]),
    .\m_axis_tlast (outputs[32:32]),
    .\m_axis_tready (inputs[1:1]),
    .\m_axis_tuser (outputs[40:33]),
    .\m_axis_tvalid (outputs[41:41]),
    .\s_axis_tdata (inputs[249:2]),
    .\s_axis_tlast (inputs[250:250]),
    .\s_axis_tready (outputs[42:42]),
    .\s_axis_tuser (inputs[251:251]),
    .\s_axis_tvalid (inputs[252:252])
  );
  reg [42:0] fold0;
  always @(posedge clock) fold0 <= outputs;
  reg [10:0] fold1;
  always @(posedge clock) begin
    fold1[0] <= ^fold0[3:0];
    fold1[1] <= ^fold0[7:4];
    fold1[2] <= ^fold0[11:8];
    fold1[3] <= ^fold0[15:12];
    fold1[4] <= ^fold0[19:16];
    fold1[5] <= ^fold0[23:20];
    fold1[6] <= ^fold0[27:24];
    fold1[7] <= ^fold0[31:28];
    fold1[8] <= ^fold0[35:32];
    fold1[9] <= ^fold0[39:36];
    fold1[10] <= ^fold0[42:40];
  end
  reg [2:0] fold2;
  always @(posedge clock) begin
    fold2[0] <= ^fold1[3:0];
    fold2[1] <= ^fold1[7:4];
    fold2[2] <= ^fold1[10:8];
  end
  reg [0:0] fold3;
  always @(posedge clock) begin
    fold3[0] <= ^fold2[2:0];
  end
  assign folded = fold3[0];
endmodule
