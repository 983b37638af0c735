  task write_word(input [7:0] word);
    begin
      if ((^word === 1'bx) || (word[7:4] != 4'd0)) $write("the impossible word %h", word);
      else if (word[3]) $write("undecided");
      else begin
        case (word[1:0])
          2'd0: $write("less");
          2'd1: $write("equal");
          2'd2: $write("greater");
          default: $write("unordered");
        endcase
        if (word[2]) $write(", recomputed"); else $write(", decided by the lane");
      end
    end
  endtask

