# Packages @IP_TOP@ as IP for Vivado's block designs, with its AXI4-Streams as
# interfaces. From any folder:
#   vivado -mode batch -source DIR/vivado/package_ip.tcl [-tclargs PART [FOLDER]]
# FOLDER/ip is then an IP repository with one core. FOLDER is @BUILD_TOP@_ip in the working folder
# if none is named.
#
@PROVENANCE@

set here [file dirname [file normalize [info script]]]
source [file join $here sources.tcl]
foreach name {
@IP_SOURCES@} {
  lappend sources [file join $system $name]
}

# Each stream and its ports.
set streams {
@STREAMS@}

set part {@PART@}
set work @BUILD_TOP@_ip
if {[llength $argv] > 0} { set part [lindex $argv 0] }
if {[llength $argv] > 1} { set work [lindex $argv 1] }
if {$part eq ""} {
  error "Vivado has no @DEVICE@: name a part with -tclargs, such as xc7a200tfbg676-2"
}

create_project -force package [file join $work project] -part $part
add_files -norecurse $sources
set_property top @IP_TOP@ [current_fileset]
update_compile_order -fileset sources_1

ipx::package_project -root_dir [file join $work ip] -vendor mixcmp -library comparison \
  -taxonomy /UserIP -import_files -force -set_current true
set core [ipx::current_core]
set_property name @IP_TOP@ $core
set_property version 1.0 $core
set_property display_name @IP_TOP@ $core
set_property description "Verdicts of a comparison in mixed precision, by mixcmp @VERSION@" $core

foreach {name ports} $streams {
  # Vivado infers most streams by the names of their ports.
  if {[llength [ipx::get_bus_interfaces $name -of_objects $core]] == 0} {
    ipx::infer_bus_interface $ports xilinx.com:interface:axis_rtl:1.0 $core
  }
  ipx::associate_bus_interfaces -busif $name -clock aclk $core
}

@IF COUNTER_BUS@
# The port on which software reads the counters; its registers are in the signature's counter_map.
if {[llength [ipx::get_bus_interfaces s_axi -of_objects $core]] == 0} {
  ipx::infer_bus_interface {@COUNTER_BUS@} xilinx.com:interface:aximm_rtl:1.0 $core
}
ipx::associate_bus_interfaces -busif s_axi -clock aclk $core

@END@
ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
close_project
puts "@IP_TOP@ is in [file normalize [file join $work ip]]"
