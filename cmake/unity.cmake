# SPDX-License-Identifier: MIT
# Developer presets compile several sources as one unit (CMAKE_UNITY_BUILD), which makes a clean build about three times
# as fast. The release preset compiles each source separately, so that missing includes are found. Units never contain
# sources of several modules: names in unnamed namespaces are unique in a module and in a test program, except in the
# sources given to grafverif_compile_alone.
# Large units take less time in total, because headers and templates are compiled once per unit; small units take less
# time after a change of one source.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12 CACHE STRING "Maximum number of sources in a unit")

# grafverif_group_units(TARGET): compiles the sources of one module together, at most one batch per unit.
function(grafverif_group_units target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        get_filename_component(folder "${source}" DIRECTORY)
        # Paths are relative, so that the names of units do not depend on the folders of the source and build trees.
        string(REPLACE "${PROJECT_BINARY_DIR}/" "" folder "${folder}")
        string(REPLACE "${PROJECT_SOURCE_DIR}/" "" folder "${folder}")
        string(REGEX REPLACE "^(src/[^/]*)/.*" "\\1" folder "${folder}")
        string(MAKE_C_IDENTIFIER "${folder}" group)
        math(EXPR count_${group} "${count_${group}} + 1")
        math(EXPR batch "(${count_${group}} - 1) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
        set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${group}_${batch}")
    endforeach()
endfunction()

# grafverif_precompile(TARGET): parses the most frequent headers of the standard library and of fmt once per target. As
# with units, the release preset omits this, so that missing includes are found.
function(grafverif_precompile target)
    if(CMAKE_UNITY_BUILD)
        target_precompile_headers(${target} PRIVATE
            <algorithm> <array> <charconv> <chrono> <deque> <functional> <map> <memory> <numeric> <optional>
            <ranges> <set> <span> <sstream> <string> <string_view> <thread> <tuple> <unordered_map> <unordered_set>
            <utility> <variant> <vector> <fmt/format.h>)
    endif()
endfunction()

# grafverif_compile_alone(TARGET FILE...): compiles these sources separately, because other sources of the module use
# the same local names.
function(grafverif_compile_alone target)
    set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
