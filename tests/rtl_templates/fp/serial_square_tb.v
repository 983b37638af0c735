`timescale 1ns/1ns
module tb;
  parameter E=3, P=13, RE=E, RP=P, G=1, GAP=0;
  localparam C=(P+5)/6;
  localparam W=E+P;
  reg clk=0; always #5 clk=~clk;
  reg [W-1:0] a=0; reg start=0;
  wire [RE+RP-1:0] y,z; wire ex,ez;
  parameter [C+8:0] CUTS = {4'b1011,{(C+3){1'b1}},2'b11};
  integer ones,k; 
  fp_serial_square #(.EXPONENT_BITS(E),.PRECISION(P),.RESULT_EXPONENT_BITS(RE),.RESULT_PRECISION(RP),.GRADUAL(G),.CUTS(CUTS)) d(.aclk(clk),.start(start),.a(a),.y(y),.exceptional(ex));
  // reference: comb with output in order
  reg [W-1:0] fed; 
  wire [RE+RP-1:0] gz; wire ge;
  fp_square #(.EXPONENT_BITS(E),.PRECISION(P),.RESULT_EXPONENT_BITS(RE),.RESULT_PRECISION(RP),.GRADUAL(G),.EMBEDDED(0),.CUTS(0)) g(.aclk(clk),.a(fed),.y(gz),.exceptional(ge));
  reg [RE+RP:0] queue [0:63];
  integer n,lat,i,bad,cyc; reg [W:0] v; reg [63:0] rnd;
  reg [63:0] due [0:63]; integer wp,rp;
  initial begin
    ones=0; for(k=0;k<C+9;k=k+1) ones=ones+CUTS[k];
    lat=ones; bad=0; wp=0; rp=0; cyc=0; n=0;
    for (i=0; i<N; i=i+1) begin
      for (k=0;k<C+((GAP!=0)?($random&3):0);k=k+1) begin
        @(negedge clk); cyc=cyc+1;
        if (rp!=wp && due[rp%64]==cyc) begin
          if ({ex,y}!==queue[rp%64]) begin bad=bad+1; if(bad<10) $display("bad %0d got %h expected %h",rp,{ex,y},queue[rp%64]); end
          rp=rp+1; n=n+1;
        end
        start = (k==0);
        if (k==0) begin
          fed = (W<=20)? i : {$random,$random}; 
          a=fed; #1 queue[wp%64]={ge,gz}; due[wp%64]=cyc+lat; wp=wp+1;
        end else a={$random,$random};
      end
    end
    $display("E%0d P%0d RE%0d RP%0d G%0d: %0d checked %0d bad", E,P,RE,RP,G,n,bad);
    $finish;
  end
  localparam N = (W<=20)? (1<<W) : 100000;
endmodule
