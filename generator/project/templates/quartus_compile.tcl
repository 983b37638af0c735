# Makes a project of @BUILD_TOP@ in the working folder and compiles it with Quartus: what it needs
# of a device, and its clock. quartus/run calls it:
#   quartus_sh -t DIR/quartus/compile.tcl [PART]
# All ports but the clock are virtual pins, since a package has fewer pins. The reports are
# output_files/@BUILD_TOP@.fit.rpt and output_files/@BUILD_TOP@.sta.rpt. Beside them it puts the
# system's signature @TOP@.json: mixcmp characterise SCENE --import knows by it which Verilog
# the reports are of.
#
@PROVENANCE@

package require ::quartus::project
package require ::quartus::flow
package require ::quartus::device

set here [file dirname [file normalize [info script]]]
set system [file dirname $here]
set part {@PART@}
if {[llength $argv] > 0} { set part [lindex $argv 0] }
if {$part eq ""} { error "Quartus has no @DEVICE@: name a part, such as 5CEBA4F23C7" }

project_new @BUILD_TOP@ -overwrite
set_global_assignment -name FAMILY [lindex [get_part_info -family $part] 0]
set_global_assignment -name DEVICE $part
set_global_assignment -name TOP_LEVEL_ENTITY @BUILD_TOP@
set_global_assignment -name PROJECT_OUTPUT_DIRECTORY output_files
set_global_assignment -name NUM_PARALLEL_PROCESSORS ALL
set_global_assignment -name VERILOG_INPUT_VERSION VERILOG_2001
foreach name {
@SOURCES@} {
  set_global_assignment -name VERILOG_FILE [file join $system $name]
}
set_global_assignment -name SDC_FILE [file join $here @BUILD_TOP@.sdc]
set_instance_assignment -name VIRTUAL_PIN ON -to *
set_instance_assignment -name VIRTUAL_PIN OFF -to aclk
export_assignments

execute_flow -compile
project_close
file mkdir output_files
file copy -force [file join $system @TOP@.json] output_files
