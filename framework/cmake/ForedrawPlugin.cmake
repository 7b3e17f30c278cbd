# A plugin is a folder. foredraw_add_plugin() in its CMakeLists.txt takes name and kind from where the folder lies.
#
#   plugins/<kinds>/<name>/   or   evaluators/<name>/
#     CMakeLists.txt          foredraw_add_plugin()   or   foredraw_add_plugin(REQUIRES "CGAL 5.5" LINK CGAL::CGAL)
#     <name>.h <name>.cpp     the technique as a plain function, and whatever else the folder holds for it
#     <name>_plugin.cpp       its card and its option table; defines Plugin <name>_plugin()
#     <name>_c.cpp            the function for C, if it has one: what foredraw/c/functions.h declares
#     <x>_product*.cpp        what it makes beside triangles and vertices, if anything: the row of a product
#     schemas/<x>.json        JSON Schemas of the product's extension
#     shaders/<x>.<stage>     GLSL, if any, which the function includes as "shaders/<x>_<stage>.h": the array <x>_<stage>
#     README.md
#   tests/plugins/<kinds>/<name>_test.cpp   or   tests/evaluators/<name>_test.cpp   (and <name>_<what>_test.cpp)
#
# It makes two static libraries. foredraw::<name> is the function, and links what LINK names and nothing else: without it
# the standard library alone, for whose sake headers of the framework that need no .cpp file may be included all the same.
# foredraw::<name>_plugin is the dress, listed for add_built_in_plugins(Registry&); it is made where the framework is
# built as far as `measuring`.

include_guard(GLOBAL)
set_property(GLOBAL PROPERTY FOREDRAW_BUILT_IN "")
set_property(GLOBAL PROPERTY FOREDRAW_FUNCTIONS_LINK "")
set_property(GLOBAL PROPERTY FOREDRAW_FOR_C "")
set_property(GLOBAL PROPERTY FOREDRAW_GPL "")
set_property(GLOBAL PROPERTY FOREDRAW_LEFT_OUT "")

macro(foredraw_add_plugin)
  _foredraw_add_plugin(${CMAKE_CURRENT_SOURCE_DIR} ${ARGV})
endmacro()

# In place of foredraw_add_plugin(), where something has to be asked for: the reason, which `foredraw list` gives.
macro(foredraw_leave_out reason)
  get_filename_component(_foredraw_name "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  string(REPLACE "_" "-" _foredraw_name "${_foredraw_name}")
  set_property(GLOBAL APPEND PROPERTY FOREDRAW_LEFT_OUT "${_foredraw_name}|${reason}")
endmacro()

function(_foredraw_add_plugin folder)
  cmake_parse_arguments(ARG "GPL" "" "REQUIRES;LINK" ${ARGN})
  get_filename_component(name "${folder}" NAME)
  string(REPLACE "_" "-" config_name "${name}")
  file(RELATIVE_PATH place "${PROJECT_SOURCE_DIR}" "${folder}")
  get_filename_component(kind_folder "${place}" DIRECTORY)

  if(FOREDRAW_PLUGINS AND NOT config_name IN_LIST FOREDRAW_PLUGINS)
    return()
  endif()
  set(packages ${ARG_REQUIRES})
  foreach(library IN LISTS ARG_LINK)
    if(library MATCHES "^foredraw::(.+)")
      list(APPEND packages ${foredraw_room_needs_${CMAKE_MATCH_1}})
    endif()
  endforeach()
  set(missing "")
  foreach(package IN LISTS packages)
    string(REPLACE " " ";" arguments "${package}")
    list(GET arguments 0 found_as)
    find_package(${arguments} QUIET)
    if(NOT ${found_as}_FOUND)
      list(APPEND missing "package ${package}")
    endif()
  endforeach()
  file(GLOB shaders CONFIGURE_DEPENDS "${folder}/shaders/*")
  if(shaders)
    find_program(FOREDRAW_GLSLANG glslangValidator)
    if(NOT FOREDRAW_GLSLANG)
      list(APPEND missing "program glslangValidator")
    endif()
  endif()
  if(missing)
    list(JOIN missing ", " missing)
    if(FOREDRAW_PLUGINS)
      message(FATAL_ERROR "Foredraw: plugin '${config_name}' needs ${missing}, which was not found; install it, or take the plugin out of FOREDRAW_PLUGINS")
    endif()
    message(STATUS "Foredraw: plugin '${config_name}' is left out, because these were not found: ${missing}")
    set_property(GLOBAL APPEND PROPERTY FOREDRAW_LEFT_OUT "${config_name}|it needs ${missing}, which was not found")
    return()
  endif()
  foreach(file ${name}.h ${name}.cpp ${name}_plugin.cpp README.md)
    if(NOT EXISTS "${folder}/${file}")
      message(FATAL_ERROR "Foredraw: plugin '${config_name}' lacks its file ${place}/${file}")
    endif()
  endforeach()

  file(GLOB sources CONFIGURE_DEPENDS "${folder}/*.cpp")
  file(GLOB dress CONFIGURE_DEPENDS "${folder}/*_plugin.cpp" "${folder}/*_product*.cpp")
  file(GLOB for_c CONFIGURE_DEPENDS "${folder}/*_c.cpp")
  list(REMOVE_ITEM sources ${dress} ${for_c})
  foredraw_add_library(${name} SOURCES ${sources} LINK ${ARG_LINK} REQUIRES ${ARG_REQUIRES})
  target_include_directories(foredraw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)  # <plugins/.../name.h>
  foredraw_add_shaders(foredraw_${name} ${shaders})
  foredraw_install_component(${name})
  foredraw_install_headers("${folder}" "${kind_folder}")
  list(FILTER ARG_LINK INCLUDE REGEX "^foredraw::")
  list(TRANSFORM ARG_LINK REPLACE "^foredraw::" "")
  set_property(GLOBAL APPEND PROPERTY FOREDRAW_FUNCTIONS_LINK ${ARG_LINK})

  foredraw_reaches(measuring "${FOREDRAW_FRAMEWORK}" dressed)
  if(dressed)
    foredraw_add_library(${name}_plugin QUICK SOURCES ${dress} LINK foredraw::measuring foredraw::${name}
                         REQUIRES fmt PRIVATE_LINK fmt::fmt)
    foredraw_add_schemas(foredraw_${name}_plugin "${folder}")
    foredraw_install_component(${name}_plugin)
  endif()
  set_property(GLOBAL APPEND PROPERTY FOREDRAW_BUILT_IN ${name})
  if(for_c)
    set_property(GLOBAL APPEND PROPERTY FOREDRAW_FOR_C "${name}|${for_c}")
  endif()
  if(ARG_GPL)
    set_property(GLOBAL APPEND PROPERTY FOREDRAW_GPL ${config_name})
  endif()

  if(NOT PROJECT_NAME STREQUAL foredraw)
    return()
  endif()
  set(test "${PROJECT_SOURCE_DIR}/tests/${kind_folder}/${name}_test.cpp")
  if(NOT EXISTS "${test}")
    message(FATAL_ERROR "Foredraw: plugin '${config_name}' lacks its test tests/${kind_folder}/${name}_test.cpp")
  endif()
  set_property(GLOBAL APPEND PROPERTY FOREDRAW_PLUGIN_TESTS "${name}|${test}")
endfunction()

# Checks that FOREDRAW_PLUGINS names plugins alone, and writes and builds add_built_in_plugins() for those that were added.
function(foredraw_finish_plugins)
  get_property(names GLOBAL PROPERTY FOREDRAW_BUILT_IN)
  list(SORT names)
  foreach(config_name IN LISTS FOREDRAW_PLUGINS)
    string(REPLACE "-" "_" name "${config_name}")
    if(NOT name IN_LIST names)
      list(JOIN names ", " known)
      string(REPLACE "_" "-" known "${known}")
      message(FATAL_ERROR "Foredraw: FOREDRAW_PLUGINS names '${config_name}', but the plugins are ${known}")
    endif()
  endforeach()
  foredraw_reaches(measuring "${FOREDRAW_FRAMEWORK}" dressed)
  if(NOT dressed)
    return()
  endif()

  _foredraw_list_plugins(built_in_plugins add_built_in_plugins "")
  foredraw_install_component(built_in_plugins)
endfunction()

# Makes foredraw::<library>, in which void <function>(Registry&) does `first` and then adds the plugins that were added here.
function(_foredraw_list_plugins library function first)
  get_property(names GLOBAL PROPERTY FOREDRAW_BUILT_IN)
  list(SORT names)
  set(declarations "")
  set(calls "${first}")
  set(targets "")
  get_property(left_out GLOBAL PROPERTY FOREDRAW_LEFT_OUT)
  foreach(entry IN LISTS left_out)
    string(REPLACE "|" "\", \"" entry "${entry}")
    string(APPEND calls "  registry.leave_out(\"${entry}\");\n")
  endforeach()
  foreach(name IN LISTS names)
    string(APPEND declarations "Plugin ${name}_plugin();\n")
    string(APPEND calls "  registry.add(${name}_plugin());\n")
    list(APPEND targets foredraw::${name}_plugin)
  endforeach()
  set(generated "${PROJECT_BINARY_DIR}/generated")
  file(CONFIGURE OUTPUT "${generated}/${library}.cpp" @ONLY CONTENT
"// Generated by CMake from the plugin folders.
#include <foredraw/technique/built_in_plugins.h>

namespace foredraw {

@declarations@
void @function@(Registry& registry) {
@calls@}

}  // namespace foredraw
")
  foredraw_add_library(${library} QUICK SOURCES "${generated}/${library}.cpp" LINK foredraw::technique ${targets} ${ARGN})
endfunction()

# Tests of the plugins that were added, a program for each kind: processors_test. Called from tests/.
function(foredraw_add_plugin_tests)
  get_property(tests GLOBAL PROPERTY FOREDRAW_PLUGIN_TESTS)
  set(kinds "")
  foreach(entry IN LISTS tests)
    string(REPLACE "|" ";" entry "${entry}")
    list(GET entry 0 name)
    list(GET entry 1 source)
    string(REPLACE "_test.cpp" "_*_test.cpp" more "${source}")
    file(GLOB more CONFIGURE_DEPENDS "${more}")
    foreach(other IN LISTS tests)  # displacement_seams_test.cpp is not one of displacement's
      string(REGEX REPLACE "[|].*" "" other "${other}")
      if(other MATCHES "^${name}_")
        list(FILTER more EXCLUDE REGEX "/${other}_([a-z0-9_]*_)?test\\.cpp$")
      endif()
    endforeach()
    string(REGEX REPLACE ".*/([a-z_]+)/[a-z0-9_]+\\.cpp$" "\\1" kind "${source}")
    string(REPLACE "clusterers" "orderers" kind "${kind}")  # which are few
    list(APPEND kinds ${kind})
    list(APPEND ${kind}_sources "${source}" ${more})
    list(APPEND ${kind}_links foredraw::${name}_plugin)
  endforeach()
  list(REMOVE_DUPLICATES kinds)
  foreach(kind IN LISTS kinds)
    foredraw_add_test(${kind}_test SOURCES ${${kind}_sources} LINK ${${kind}_links} meshoptimizer::meshoptimizer)
  endforeach()
endfunction()

function(foredraw_print_licence)
  get_property(gpl GLOBAL PROPERTY FOREDRAW_GPL)
  if(gpl)
    list(JOIN gpl ", " gpl)
    message(STATUS "Foredraw: this build falls under the GPL, version 3, because of: ${gpl}")
  else()
    message(STATUS "Foredraw: this build falls under the MIT licence (the libraries' own licences: LICENSES.md)")
  endif()
endfunction()
