# Runs a script for Vivado or Quartus in Tcl's own interpreter, with the vendor's commands replaced
# by ones that check their arguments, and that the files which they read exist:
#   tclsh vendor_commands.tcl SCRIPT [ARGUMENT...]
# Prints each call, with its files by their last names. A command that is none of those below, or an
# option that it does not have, is an error.

# vendor NAME VALUED FLAGS [RESULT]: a command with options that take a value, and with flags.
proc vendor {name valued flags {result ""}} {
  proc ::$name args "return \[vendor_call [list $name $valued $flags $result] \$args\]"
}

proc vendor_call {name valued flags result arguments} {
  set shown [list $name]
  for {set k 0} {$k < [llength $arguments]} {incr k} {
    set word [lindex $arguments $k]
    if {[string match -* $word]} {
      if {$word in $valued} {
        incr k
        if {$k >= [llength $arguments]} { error "$name: $word has no value" }
        lappend shown $word [file tail [lindex $arguments $k]]
      } elseif {$word in $flags} {
        lappend shown $word
      } else {
        error "$name: no option $word"
      }
    } else {
      foreach file $word { check_exists $name $file }
      lappend shown [lmap file $word { file tail $file }]
    }
  }
  puts [join $shown " "]
  return $result
}

# Checks only arguments that look like absolute paths.
proc check_exists {name file} {
  if {[file pathtype $file] eq "absolute" && ![file exists $file]} {
    error "$name: there is no $file"
  }
}

# Vivado
vendor read_verilog {-library} {-sv}
vendor read_xdc {-mode} {-unmanaged}
vendor synth_design {-top -part -mode -flatten_hierarchy -directive} {}
vendor opt_design {-directive} {}
vendor place_design {-directive} {}
vendor phys_opt_design {-directive} {}
vendor route_design {-directive} {}
vendor report_utilization {-file} {-hierarchical}
vendor report_timing_summary {-file -max_paths} {}
vendor write_checkpoint {} {-force}
vendor get_timing_paths {-max_paths -nworst} {-setup -hold} path
vendor get_property {} {} 0.25
vendor set_property {} {}
vendor get_ports {} {} ports
vendor create_clock {-name -period} {}
vendor set_input_delay {-clock -max -min} {}
vendor set_output_delay {-clock -max -min} {}
vendor create_project {-part} {-force -in_memory}
vendor add_files {-fileset} {-norecurse}
vendor current_fileset {} {} sources_1
vendor update_compile_order {-fileset} {}
vendor close_project {} {}
namespace eval ipx {}
vendor ipx::package_project {-root_dir -vendor -library -taxonomy -set_current} {-import_files -force}
vendor ipx::current_core {} {} core
vendor ipx::get_bus_interfaces {-of_objects} {}
vendor ipx::infer_bus_interface {} {}
vendor ipx::associate_bus_interfaces {-busif -clock} {}
vendor ipx::create_xgui_files {} {}
vendor ipx::update_checksums {} {}
vendor ipx::check_integrity {} {}
vendor ipx::save_core {} {}

# Quartus
foreach name {project flow device} { package provide ::quartus::$name 1.0 }
vendor project_new {-revision} {-overwrite}
vendor get_part_info {} {-family} {{Cyclone V}}
vendor set_global_assignment {-name} {}
vendor set_instance_assignment {-name -to} {}
vendor export_assignments {} {}
vendor execute_flow {} {-compile}
vendor project_close {} {}

# Tcl's own would start programs of unknown names.
proc unknown args { error "no command of Tcl, Vivado or Quartus: [lindex $args 0]" }

set script [lindex $argv 0]
set argv [lrange $argv 1 end]
if {[catch { source $script } message]} {
  puts stderr "$script: $message"
  exit 1
}
