  // A stream of the system is a group's. In this test bench every lane has handshakes and a tag of
  // its own; lanes of a group have equal ones.
  wire [GROUPS-1:0]          group_s_axis_tvalid;
  wire [GROUPS-1:0]          group_s_axis_tready;
  wire [GROUPS*TAG_BITS-1:0] group_s_axis_tuser;
  wire [GROUPS-1:0]          group_m_axis_tvalid;
  wire [GROUPS-1:0]          group_m_axis_tready;
  wire [GROUPS*TAG_BITS-1:0] group_m_axis_tuser;

  genvar g;
  genvar n;
  generate
    for (g = 0; g < GROUPS; g = g + 1) begin : group
      localparam FIRST = g * LANES_PER_GROUP;  // its first lane

      assign group_s_axis_tvalid[g] = s_axis_tvalid[FIRST];
      assign group_s_axis_tuser[g*TAG_BITS +: TAG_BITS] = s_axis_tuser[FIRST*TAG_BITS +: TAG_BITS];
      assign group_m_axis_tready[g] = m_axis_tready[FIRST];
      for (n = FIRST; n < FIRST + LANES_PER_GROUP; n = n + 1) begin : lanes
        assign s_axis_tready[n] = group_s_axis_tready[g];
        assign m_axis_tvalid[n] = group_m_axis_tvalid[g];
        assign m_axis_tuser[n*TAG_BITS +: TAG_BITS] = group_m_axis_tuser[g*TAG_BITS +: TAG_BITS];
      end
    end
  endgenerate

  // Whether no other word inside has a tag of the word that begins with comparison `first`.
  function tags_are_free(input integer first);
    tags_are_free = (first + LANES_PER_GROUP - 1) / COMPARISONS_PER_TAG
                    - oldest / COMPARISONS_PER_TAG < TAG_LIMIT;
  endfunction

  // Drives a lane as the first one of its group has been driven in this cycle.
  task drive_with(input integer lane, input integer first);
    begin
      if (offering[first] && !offering[lane]) begin
        offering[lane] = 1'b1;
        s_axis_tdata[lane*TDATA_BITS +: TDATA_BITS] = vectors[next_offer[lane]][TDATA_BITS-1:0];
      end
      s_axis_tvalid[lane] = s_axis_tvalid[first];
      m_axis_tready[lane] = m_axis_tready[first];
    end
  endtask

@IF COUNTS@
  // The sum over the lanes of a group.
  function [31:0] recomputed_in_group(input integer index);
    integer k;
    begin
      recomputed_in_group = 32'd0;
      for (k = 0; k < LANES_PER_GROUP; k = k + 1) begin
        recomputed_in_group = recomputed_in_group + recomputed[index*LANES_PER_GROUP + k];
      end
    end
  endfunction

@END@
