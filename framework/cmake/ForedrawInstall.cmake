# What `cmake --install` puts where, in components: runtime (the program, presets, the schema of pipelines), import, libraries
# (those for C), development (libraries, headers, the package for find_package) and python.
#
# Every library of ours is a component of the package foredraw with a file of its own, so that an engine gets the targets
# that it asks for and what they link, and needs no package besides theirs.

set(foredraw_package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/foredraw")
set_property(GLOBAL PROPERTY FOREDRAW_COMPONENTS "")

# Of each component, the Debian package that it becomes.
set(foredraw_package_of_runtime foredraw)
set(foredraw_package_of_libraries libforedraw1)
set(foredraw_package_of_development libforedraw-dev)
set(foredraw_package_of_python python3-foredraw)
set(foredraw_package_of_import foredraw-import)

# foredraw_install_component(scene): foredraw::scene, made by foredraw_add_library, or a shared library.
function(foredraw_install_component name)
  if(NOT FOREDRAW_INSTALL)
    return()
  endif()
  install(TARGETS foredraw_${name} EXPORT foredraw_${name}
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libraries NAMELINK_COMPONENT development)
  install(EXPORT foredraw_${name} NAMESPACE foredraw:: FILE ${name}.cmake
          DESTINATION "${foredraw_package_folder}/components" COMPONENT development)
  set_property(GLOBAL APPEND PROPERTY FOREDRAW_COMPONENTS ${name})
endfunction()

# foredraw_add_interface(runtime): foredraw::runtime, which is headers alone, and what it links.
function(foredraw_add_interface name)
  cmake_parse_arguments(ARG "" "" "LINK;REQUIRES" ${ARGN})
  foreach(package IN LISTS ARG_REQUIRES)
    find_package(${package} REQUIRED)
  endforeach()
  add_library(foredraw_${name} INTERFACE)
  add_library(foredraw::${name} ALIAS foredraw_${name})
  set_target_properties(foredraw_${name} PROPERTIES EXPORT_NAME ${name} FOREDRAW_REQUIRES "${ARG_REQUIRES}"
                        LINK_LIBRARIES "${ARG_LINK}")
  target_link_libraries(foredraw_${name} INTERFACE ${ARG_LINK})
  target_include_directories(foredraw_${name} INTERFACE $<BUILD_INTERFACE:${foredraw_include_root}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/foredraw>)
  foredraw_install_component(${name})
endfunction()

# Headers of a folder: <foredraw/...> and <plugins/...> below one folder that no other project has.
function(foredraw_install_headers folder destination)
  if(FOREDRAW_INSTALL)
    install(DIRECTORY "${folder}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/foredraw/${destination}" COMPONENT development
            FILES_MATCHING PATTERN "*.h" PATTERN private EXCLUDE)
  endif()
endfunction()

# The package itself: which components there are, which others each links, which packages it needs.
function(foredraw_install_package)
  if(NOT FOREDRAW_INSTALL)
    return()
  endif()
  get_property(components GLOBAL PROPERTY FOREDRAW_COMPONENTS)
  list(SORT components)
  set(rows "")
  foreach(name IN LISTS components)
    get_target_property(links foredraw_${name} LINK_LIBRARIES)
    list(FILTER links INCLUDE REGEX "^foredraw::")
    list(TRANSFORM links REPLACE "^foredraw::" "")
    get_target_property(requires foredraw_${name} FOREDRAW_REQUIRES)
    string(APPEND rows "set(_foredraw_${name}_links ${links})\nset(_foredraw_${name}_requires \"${requires}\")\n")
  endforeach()

  include(CMakePackageConfigHelpers)
  set(generated "${PROJECT_BINARY_DIR}/generated")
  configure_file("${PROJECT_SOURCE_DIR}/framework/cmake/foredrawConfig.cmake.in" "${generated}/foredrawConfig.cmake" @ONLY)
  write_basic_package_version_file("${generated}/foredrawConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(FILES "${generated}/foredrawConfig.cmake" "${generated}/foredrawConfigVersion.cmake"
          "${PROJECT_SOURCE_DIR}/framework/cmake/foredrawComponents.cmake"
          "${PROJECT_SOURCE_DIR}/framework/cmake/Findxxhash.cmake"
          "${PROJECT_SOURCE_DIR}/framework/cmake/ForedrawLibrary.cmake"
          "${PROJECT_SOURCE_DIR}/framework/cmake/ForedrawPlugin.cmake"
          "${PROJECT_SOURCE_DIR}/framework/cmake/ForedrawOutside.cmake"
          DESTINATION "${foredraw_package_folder}" COMPONENT development)
  foreach(test conformance/every_plugin.cpp conformance/every_plugin.h conformance/option_settings.cpp
               conformance/option_settings.h conformance/same_results.cpp conformance/same_results.h conformance/odd_scenes.cpp
               conformance/odd_scenes.h conformance/all_plugins.h conformance/answers_test.cpp
               conformance/same_bytes_test.cpp conformance/cards_test.cpp conformance/printed_pipelines_test.cpp
               support/displaced.h support/meshes.cpp support/meshes.h support/sprite_scenes.cpp support/sprite_scenes.h)
    get_filename_component(folder "${test}" DIRECTORY)
    install(FILES "${PROJECT_SOURCE_DIR}/tests/${test}" DESTINATION "${foredraw_package_folder}/tests/${folder}"
            COMPONENT development)
  endforeach()
  foredraw_install_headers("${PROJECT_SOURCE_DIR}/framework/foredraw" "")
  # Programs and modules to begin with, for whoever has the packages alone.
  set(examples "${CMAKE_INSTALL_DATAROOTDIR}/foredraw/examples")
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/tests/embedding/c/" DESTINATION "${examples}/engine" COMPONENT development)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/hosts/module/examples/" DESTINATION "${examples}/module" COMPONENT development)
  set(documented runtime libraries development python)
  if(TARGET foredraw_import)
    list(APPEND documented import)
  endif()
  foreach(component IN LISTS documented)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/LICENSES.md"
            DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${foredraw_package_of_${component}}" COMPONENT ${component})
  endforeach()
endfunction()
