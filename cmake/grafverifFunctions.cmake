# SPDX-License-Identifier: MIT
# Functions for charts in a CMake project with Makefiles or Ninja; for examples see docs/how-to/build-systems.md.
#
#   grafverif_models(TARGET <target> CHART <file>... [NAME <name>] [LOOP <loop>] [OUTPUT_DIRECTORY <folder>]
#                    [MODELS uppaal|nusmv] [OPTIONS <option>...])
#       Adds a target that is always built. It writes NAME.xml, NAME.q and NAME.smv of each chart, and writes them again
#       if the chart, a file that the chart includes, or the program changes. Default NAME: the file name without its
#       extension. Default folder: the current binary directory. The target's property GRAFVERIF_MODELS lists the files.
#
#   grafverif_check(NAME <name> CHART <file> [PROPERTY <property>...] [LOOP <loop>] [OPTIONS <option>...] [LABELS <label>...])
#       Adds a test for each property of the chart. The tests are determined when the target <name> is built:
#       <name>.<property>, or for a file with several loops <name>.<loop>.<property>. A test checks its property on the
#       files at run time; it passes if the verdict is as expected. OPTIONS are passed to `grafverif check`, as in
#       `--grain;atomic;--timeout;5min`.
include_guard(GLOBAL)

function(_grafverif_parse call known)
    if(DEFINED arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "${call}: unknown argument `${arg_UNPARSED_ARGUMENTS}`")
    endif()
    foreach(name IN LISTS known)
        if(NOT DEFINED arg_${name})
            message(FATAL_ERROR "${call}: ${name} is missing")
        endif()
    endforeach()
    if(NOT GRAFVERIF_PROGRAM)
        message(FATAL_ERROR "${call}: the program grafverif was not found; set GRAFVERIF_PROGRAM to its path")
    endif()
endfunction()

function(grafverif_models)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;NAME;LOOP;OUTPUT_DIRECTORY;MODELS" "CHART;OPTIONS")
    _grafverif_parse(grafverif_models "TARGET;CHART")
    list(LENGTH arg_CHART charts)
    if(DEFINED arg_NAME AND charts GREATER 1)
        message(FATAL_ERROR "grafverif_models: NAME requires exactly one CHART")
    endif()
    set(folder "${CMAKE_CURRENT_BINARY_DIR}")
    if(DEFINED arg_OUTPUT_DIRECTORY)
        cmake_path(ABSOLUTE_PATH arg_OUTPUT_DIRECTORY BASE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" OUTPUT_VARIABLE folder)
    endif()
    set(endings xml q smv)
    set(options ${arg_OPTIONS})
    if(DEFINED arg_LOOP)
        list(APPEND options --loop "${arg_LOOP}")
    endif()
    if(DEFINED arg_MODELS)
        list(APPEND options --target "${arg_MODELS}")
        if(arg_MODELS STREQUAL uppaal)
            set(endings xml q)
        elseif(arg_MODELS STREQUAL nusmv)
            set(endings smv)
        endif()
    endif()
    set(all "")
    foreach(chart IN LISTS arg_CHART)
        cmake_path(ABSOLUTE_PATH chart OUTPUT_VARIABLE file)
        cmake_path(GET chart STEM LAST_ONLY name)
        if(DEFINED arg_NAME)
            set(name "${arg_NAME}")
        endif()
        set(outputs ${endings})
        list(TRANSFORM outputs PREPEND "${folder}/${name}.")
        add_custom_command(
            OUTPUT ${outputs}
            COMMAND "${GRAFVERIF_PROGRAM}" build "${file}" -o "${folder}" --name "${name}" --create-dirs
                    --depfile "${folder}/${name}.d" --depfile-format cmake ${options}
            DEPENDS "${file}" "${GRAFVERIF_PROGRAM}"
            DEPFILE "${folder}/${name}.d"
            COMMENT "Models of ${chart}"
            VERBATIM)
        list(APPEND all ${outputs})
    endforeach()
    add_custom_target(${arg_TARGET} ALL DEPENDS ${all})
    set_target_properties(${arg_TARGET} PROPERTIES GRAFVERIF_MODELS "${all}")
endfunction()

function(grafverif_check)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;CHART;LOOP" "PROPERTY;OPTIONS;LABELS")
    _grafverif_parse(grafverif_check "NAME;CHART")
    cmake_path(ABSOLUTE_PATH arg_CHART OUTPUT_VARIABLE file)
    set(script "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/grafverifDiscover.cmake")
    set(base "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}.grafverif")
    add_custom_command(
        OUTPUT "${base}.cmake"
        COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=${GRAFVERIF_PROGRAM}" "-DCHART=${file}" "-DNAME=${arg_NAME}"
                "-DPROPERTIES=${arg_PROPERTY}" "-DLOOP=${arg_LOOP}" "-DOPTIONS=${arg_OPTIONS}" "-DLABELS=${arg_LABELS}" "-DBASE=${base}"
                -P "${script}"
        DEPENDS "${file}" "${GRAFVERIF_PROGRAM}" "${script}"
        DEPFILE "${base}.d"
        COMMENT "Properties of ${arg_CHART}"
        VERBATIM)
    add_custom_target(${arg_NAME} ALL DEPENDS "${base}.cmake")
    file(CONFIGURE OUTPUT "${base}.tests.cmake" @ONLY CONTENT [==[
if(EXISTS "@base@.cmake")
    include("@base@.cmake")
else()
    add_test([=[@arg_NAME@_NOT_BUILT]=] [=[@arg_NAME@_NOT_BUILT]=])
endif()
]==])
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${base}.tests.cmake")
endfunction()
