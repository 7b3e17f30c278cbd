# Libraries of ours, and of plugins outside of this tree: <foredraw/...> lies in foredraw_include_root.
include_guard(GLOBAL)
include(GNUInstallDirs)

# How our own targets are compiled; who links them inherits none of it. No contraction and no fast-math: the same asset
# bytes from every compiler.
add_library(foredraw_flags INTERFACE)
target_compile_options(foredraw_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wno-missing-field-initializers
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # gcc 12 sees overlaps in std::string that are none

# A static library of ours: foredraw_add_library(scene SOURCES ... LINK ... REQUIRES ...) makes foredraw::scene. Packages
# are looked for here, where they are needed, and nowhere else.
#   SOURCES      its .cpp files
#   LINK         libraries that its headers show
#   PRIVATE_LINK libraries that only its .cpp files use
#   REQUIRES     packages of these libraries, with a version or without ("embree 3"): whoever links the result needs them too
#   HEADER_ONLY  packages that are compiled in, and that nobody needs afterwards
function(foredraw_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK;REQUIRES;HEADER_ONLY" ${ARGN})
  foreach(package IN LISTS ARG_REQUIRES ARG_HEADER_ONLY)
    string(REPLACE " " ";" arguments "${package}")
    find_package(${arguments} REQUIRED)
  endforeach()
  set(compiled_in foredraw_flags)
  foreach(package IN LISTS ARG_HEADER_ONLY)
    list(APPEND compiled_in ${package}::${package})
  endforeach()
  list(TRANSFORM compiled_in REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")

  add_library(foredraw_${name} STATIC ${ARG_SOURCES})
  add_library(foredraw::${name} ALIAS foredraw_${name})
  set_target_properties(foredraw_${name} PROPERTIES CXX_EXTENSIONS ON POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name}
                        FOREDRAW_REQUIRES "${ARG_REQUIRES}")
  target_compile_features(foredraw_${name} PUBLIC cxx_std_20)
  target_link_libraries(foredraw_${name} PUBLIC ${ARG_LINK}
                        PRIVATE ${ARG_PRIVATE_LINK} ${compiled_in})
  target_include_directories(foredraw_${name} PUBLIC $<BUILD_INTERFACE:${foredraw_include_root}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/foredraw>)
endfunction()
