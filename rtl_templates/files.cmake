# Every hand-written module; the generator embeds them and copies the ones a system uses.
file(GLOB MIXCMP_RTL_TEMPLATES CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl_templates/bound/*.v
  ${PROJECT_SOURCE_DIR}/rtl_templates/engine/*.v
  ${PROJECT_SOURCE_DIR}/rtl_templates/fixed/*.v
  ${PROJECT_SOURCE_DIR}/rtl_templates/fp/*.v
  ${PROJECT_SOURCE_DIR}/rtl_templates/stream/*.v
  ${PROJECT_SOURCE_DIR}/rtl_templates/verdict/*.v
)

# Templates as cells of a family, for a Yosys that does not find them by itself.
file(GLOB MIXCMP_ECP5_CELLS CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl_templates/technology/ecp5/*.v
)
file(GLOB MIXCMP_ICE40_CELLS CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl_templates/technology/ice40/*.v
)
