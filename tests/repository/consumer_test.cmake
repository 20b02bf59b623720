# SPDX-License-Identifier: MIT
# Installs the build tree BUILD into a separate folder, builds the consumer project with the installed library, and runs
# the program.
set(work "${BUILD}/consumer-test")
file(REMOVE_RECURSE "${work}")
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${ARGN}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${work}/prefix")
run("${CMAKE_COMMAND}" -S "${SOURCE}/tests/repository/consumer" -B "${work}/build" -G Ninja
    "-DCMAKE_PREFIX_PATH=${work}/prefix" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run("${CMAKE_COMMAND}" --build "${work}/build")
run("${work}/build/consumer" "${work}/prefix/share/doc/grafverif/samples/blinker/blinker.grafcet")
if(NOT output MATCHES "blinker_loop: 3 hold")
    message(FATAL_ERROR "the consumer printed:\n${output}")
endif()
run("${work}/prefix/bin/grafverif" --version)
if(NOT output MATCHES "grafverif [0-9]")
    message(FATAL_ERROR "the installed program printed:\n${output}")
endif()
