# Sets `sources` to the Verilog files of @BUILD_TOP@, in compile order, wherever this script is.
#
@PROVENANCE@

set system [file normalize [file join [file dirname [info script]] ..]]
set sources [list]
foreach name {
@SOURCES@} {
  lappend sources [file join $system $name]
}
