# Synthesises, places and routes @BUILD_TOP@ out of context with Vivado: what it needs of a device,
# and its clock. From any folder:
#   vivado -mode batch -source DIR/vivado/synthesise.tcl [-tclargs PART [FOLDER]]
# It writes into FOLDER, which is @BUILD_TOP@_vivado in the working folder if none is named:
# utilisation.rpt, utilisation_by_instance.rpt, timing.rpt and the checkpoint @BUILD_TOP@.dcp. Beside
# them it puts the system's signature @TOP@.json: mixcmp characterise SCENE --import knows by
# it which Verilog the reports are of.
#
@PROVENANCE@

set here [file dirname [file normalize [info script]]]
source [file join $here sources.tcl]

set part {@PART@}
set work @BUILD_TOP@_vivado
if {[llength $argv] > 0} { set part [lindex $argv 0] }
if {[llength $argv] > 1} { set work [lindex $argv 1] }
if {$part eq ""} {
  error "Vivado has no @DEVICE@: name a part with -tclargs, such as xc7a200tfbg676-2"
}
file mkdir $work

read_verilog $sources
read_xdc [file join $here @BUILD_TOP@.xdc]
synth_design -top @BUILD_TOP@ -part $part -mode out_of_context
opt_design
place_design
phys_opt_design
route_design

report_utilization -file [file join $work utilisation.rpt]
report_utilization -hierarchical -file [file join $work utilisation_by_instance.rpt]
report_timing_summary -file [file join $work timing.rpt]
write_checkpoint -force [file join $work @BUILD_TOP@.dcp]
file copy -force [file join $system @TOP@.json] $work

set slack [get_property SLACK [get_timing_paths -setup -max_paths 1]]
puts [format "@BUILD_TOP@ on %s: slack %s ns, %.1f MHz (target @TARGET_MHZ@ MHz)" \
  $part $slack [expr {1000.0 / (@PERIOD_NS@ - $slack)}]]
