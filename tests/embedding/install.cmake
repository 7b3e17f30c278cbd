# cmake -D BUILD=... -D SOURCE=... -D PREFIX=... -P install.cmake: installs the build, moves what was installed to PREFIX,
# and looks whether any of it remembers a place of this machine.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.before")
foreach(component runtime libraries development python)
  execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}.before" --component ${component}
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(RENAME "${PREFIX}.before" "${PREFIX}")

file(GLOB_RECURSE scripts "${PREFIX}/*.cmake")
list(LENGTH scripts count)
foreach(script IN LISTS scripts)
  file(READ "${script}" text)
  foreach(place "${BUILD}" "${SOURCE}" "${PREFIX}" /usr/)
    string(FIND "${text}" "${place}" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "${script} names ${place}")
    endif()
  endforeach()
endforeach()
if(count LESS 10)
  message(FATAL_ERROR "only ${count} scripts were installed")
endif()

execute_process(COMMAND "${PREFIX}/bin/foredraw" list COMMAND_ERROR_IS_FATAL ANY)
