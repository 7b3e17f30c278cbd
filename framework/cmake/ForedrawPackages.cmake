# Debian packages of what is built, one for each component of ForedrawInstall.cmake: cpack -G DEB in the build folder, or
# `make packages`. With SOURCE_DATE_EPOCH in the environment the same build gives the same bytes.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME foredraw)
set(CPACK_PACKAGE_VENDOR Foredraw)
set(CPACK_PACKAGE_CONTACT "Foredraw <foredraw@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime libraries development python)
if(TARGET foredraw_import)  # where Assimp is
  list(APPEND CPACK_COMPONENTS_ALL import)
endif()
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/framework/foredraw/c"
                                                "${PROJECT_BINARY_DIR}/framework/foredraw/c/library")

set(version "${PROJECT_VERSION}")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${foredraw_package_of_${component}}")
endforeach()
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_IMPORT_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}
 The program foredraw, its presets, and the schema of its pipelines.")
set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "${PROJECT_DESCRIPTION}
 The libraries for C: scenes and pipelines, and the plain functions.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${PROJECT_DESCRIPTION}
 Headers for C and C++, static libraries, and the files for CMake and pkg-config.")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}
 The package foredraw for Python.")
set(CPACK_COMPONENT_IMPORT_DESCRIPTION "${PROJECT_DESCRIPTION}
 The process that reads FBX, COLLADA, 3DS, Blend and other scenes for the program.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "foredraw-import")
set(CPACK_DEBIAN_IMPORT_PACKAGE_ENHANCES "foredraw, libforedraw1")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_RECOMMENDS "foredraw (= ${version})")  # has the process that modules run in
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libforedraw1 (= ${version})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libglm-dev, libtbb-dev, libxxhash-dev, libfmt-dev, libhwy-dev, libgtest-dev")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libforedraw1 (= ${version}), python3 (>= 3.9), python3-numpy")
include(CPack)
