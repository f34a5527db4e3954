# find_package(varmass) gives the target varmass::varmass
get_filename_component(varmass_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET varmass::varmass)
  add_library(varmass::varmass INTERFACE IMPORTED)
  set_target_properties(varmass::varmass PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${varmass_prefix}/include/varmass")
  if(UNIX)
    # "-lm", not "m", which would be a target of the consumer's that has this name
    set_property(TARGET varmass::varmass PROPERTY INTERFACE_LINK_LIBRARIES -lm)
  endif()
endif()
