# The clock of @BUILD_TOP@: @TARGET_MHZ@ MHz, the target that its registers were placed for.
#
@PROVENANCE@

create_clock -name aclk -period @PERIOD_NS@ [get_ports aclk]

@PORT_DELAYS@
