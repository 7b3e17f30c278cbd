# How everything of ours is compiled.

include(GNUInstallDirs)
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # what one folder finds, others may link
if(PROJECT_IS_TOP_LEVEL)  # what an engine around us decides for itself
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
  endif()
  find_program(FOREDRAW_CCACHE ccache)
  if(FOREDRAW_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${FOREDRAW_CCACHE}")
    set(CMAKE_C_COMPILER_LAUNCHER "${FOREDRAW_CCACHE}")
  endif()
endif()

# The rooms of the framework, each a library, and what each links. A room may include what it links, directly or not.
set(foredraw_rooms "")
macro(foredraw_room name)
  list(APPEND foredraw_rooms ${name})
  set(foredraw_room_links_${name} ${ARGN})
endmacro()
foredraw_room(base)
foredraw_room(platform base)
foredraw_room(scene base)
foredraw_room(analysis scene)
foredraw_room(image analysis)
foredraw_room(viewing image)
foredraw_room(overdraw viewing)
foredraw_room(gpu viewing)
foredraw_room(technique overdraw)
foredraw_room(draw_orders viewing)
foredraw_room(measuring technique draw_orders)
foredraw_room(io_text platform scene)
foredraw_room(io_image io_text analysis)
foredraw_room(io_gltf io_image viewing)
foredraw_room(io_mesh io_gltf)
foredraw_room(io_sprite io_gltf)
foredraw_room(io io_mesh io_sprite)
foredraw_room(report measuring io_text)
foredraw_room(report_page report io_image)
foredraw_room(pipeline report platform)

set(foredraw_room_needs_gpu Vulkan)  # where this package is missing, the room and what links it are left out

# FOREDRAW_FRAMEWORK names the rooms to build; they bring what they link.
if(FOREDRAW_BUILD_HOSTS OR FOREDRAW_BUILD_TESTS OR FOREDRAW_BUILD_BENCHMARKS)
  set(FOREDRAW_FRAMEWORK ${foredraw_rooms})
  foreach(room IN LISTS foredraw_rooms)
    foreach(package IN LISTS foredraw_room_needs_${room})
      find_package(${package} QUIET)
      if(NOT ${package}_FOUND)
        list(REMOVE_ITEM FOREDRAW_FRAMEWORK ${room})
        message(STATUS "Foredraw: the room '${room}' is left out, for package ${package} was not found")
      endif()
    endforeach()
  endforeach()
endif()
foreach(room IN LISTS FOREDRAW_FRAMEWORK)
  if(NOT room IN_LIST foredraw_rooms)
    list(JOIN foredraw_rooms ", " known)
    message(FATAL_ERROR "Foredraw: FOREDRAW_FRAMEWORK names '${room}', but the rooms are ${known}")
  endif()
endforeach()

# Whether `room` is built where the rooms in `wanted` are.
function(foredraw_reaches room wanted result)
  set(${result} FALSE PARENT_SCOPE)
  foreach(one IN LISTS wanted)
    set(below FALSE)
    if(NOT one STREQUAL room)
      foredraw_reaches(${room} "${foredraw_room_links_${one}}" below)
    endif()
    if(one STREQUAL room OR below)
      set(${result} TRUE PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# How our own targets are compiled; who links them inherits none of it. No contraction and no fast-math: the same asset
# bytes from every compiler.
add_library(foredraw_flags INTERFACE)
target_compile_options(foredraw_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wno-missing-field-initializers
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # gcc 12 sees overlaps in std::string that are none
if(FOREDRAW_WARNINGS_AS_ERRORS)
  target_compile_options(foredraw_flags INTERFACE -Werror)
endif()
if(FOREDRAW_SANITIZE)
  add_compile_options(-fsanitize=${FOREDRAW_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${FOREDRAW_SANITIZE})
  if(FOREDRAW_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=undefined)
  endif()
endif()

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
  target_include_directories(foredraw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/foredraw>)
endfunction()

# JSON Schemas of extensions: those in the target's folder schemas/ become the header "schemas.h", whose function schemas()
# gives each one's file name and text.
function(foredraw_add_schemas target folder)
  file(GLOB files CONFIGURE_DEPENDS "${folder}/schemas/*.json")
  if(NOT files)
    return()
  endif()
  set(rows "")
  foreach(file IN LISTS files)
    get_filename_component(name "${file}" NAME)
    file(READ "${file}" text)
    string(APPEND rows "      {\"${name}\", R\"json(${text})json\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach()
  set(generated "${CMAKE_CURRENT_BINARY_DIR}/generated/${target}")
  file(CONFIGURE OUTPUT "${generated}/schemas.h" @ONLY CONTENT
"// Generated by CMake from the folder schemas/.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

inline std::vector<std::pair<std::string, std::string>> schemas() {
  return {
@rows@  };
}

}  // namespace foredraw
")
  target_include_directories(${target} PRIVATE "${generated}")
endfunction()

# Compiles shaders in GLSL into headers in the build folder, for the target's own files: x.vert is "shaders/x_vert.h", with
# the array x_vert. Files' names have to differ within a folder of the build.
function(foredraw_add_shaders target)
  find_program(FOREDRAW_GLSLANG glslangValidator)
  if(ARGN AND NOT FOREDRAW_GLSLANG)
    message(FATAL_ERROR "Foredraw: ${target} has shaders, and glslangValidator was not found")
  endif()
  foreach(shader IN LISTS ARGN)
    get_filename_component(file "${shader}" NAME)
    string(REPLACE "." "_" name "${file}")
    set(header "${CMAKE_CURRENT_BINARY_DIR}/generated/shaders/${name}.h")
    add_custom_command(OUTPUT "${header}" DEPENDS "${shader}" VERBATIM COMMENT "Compiling the shader ${file}"
                       COMMAND "${CMAKE_COMMAND}" -E make_directory "${CMAKE_CURRENT_BINARY_DIR}/generated/shaders"
                       COMMAND "${FOREDRAW_GLSLANG}" -V --quiet --vn ${name} -o "${header}" "${shader}")
    target_sources(${target} PRIVATE "${header}")
    target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/generated")
  endforeach()
endfunction()

# A GoogleTest program and its tests, found when ctest starts: foredraw_add_test(tipsify SOURCES ... LINK ...).
function(foredraw_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE foredraw_flags foredraw_test_support ${ARG_LINK})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}." PROPERTIES TIMEOUT 600)
endfunction()
