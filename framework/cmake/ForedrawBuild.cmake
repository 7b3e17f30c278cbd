# How everything of ours is compiled.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)  # what framework/ finds, plugins and hosts may link
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
find_program(FOREDRAW_CCACHE ccache)
if(FOREDRAW_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${FOREDRAW_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${FOREDRAW_CCACHE}")
endif()

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

# A static library of ours: foredraw_add_library(scene SOURCES ... LINK ... PRIVATE_LINK ...) makes foredraw::scene.
function(foredraw_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(foredraw_${name} STATIC ${ARG_SOURCES})
  add_library(foredraw::${name} ALIAS foredraw_${name})
  set_target_properties(foredraw_${name} PROPERTIES CXX_EXTENSIONS ON POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name})
  target_compile_features(foredraw_${name} PUBLIC cxx_std_20)
  target_link_libraries(foredraw_${name} PUBLIC ${ARG_LINK} PRIVATE foredraw_flags ${ARG_PRIVATE_LINK})
  target_include_directories(foredraw_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework>)
endfunction()

# A GoogleTest program and its tests, found when ctest starts: foredraw_add_test(tipsify SOURCES ... LINK ...).
function(foredraw_add_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE foredraw_flags foredraw_test_support ${ARG_LINK})
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}." PROPERTIES TIMEOUT 600)
endfunction()
