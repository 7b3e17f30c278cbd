# The second half of foredrawConfig.cmake: find_dependency ends the file that it stands in where the package is missing, and
# the first half has something to put back.
include(CMakeFindDependencyMacro)
foreach(_foredraw_component IN LISTS _foredraw_wanted)
  foreach(_foredraw_package IN LISTS _foredraw_${_foredraw_component}_requires)
    string(REPLACE " " ";" _foredraw_package "${_foredraw_package}")
    find_dependency(${_foredraw_package})
  endforeach()
  include("${CMAKE_CURRENT_LIST_DIR}/components/${_foredraw_component}.cmake")
endforeach()
if(cli IN_LIST _foredraw_wanted OR conformance IN_LIST _foredraw_wanted)
  include("${CMAKE_CURRENT_LIST_DIR}/ForedrawOutside.cmake")
endif()
