# SPDX-License-Identifier: MIT
# Our presets for developers compile several sources at once (CMAKE_UNITY_BUILD), which makes a clean build about three
# times as quick; the release preset compiles each alone, so that a missing include is still found. What sources share a
# compilation never depends on other rooms: names of unnamed namespaces are unique in a room and in a test program, save
# in the sources that say grafverif_compile_alone.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 6 CACHE STRING "How many sources are compiled at once at most")

# grafverif_group_by_room(TARGET): sources of one folder are compiled together, at most a batch at once.
function(grafverif_group_by_room target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        get_filename_component(folder "${source}" DIRECTORY)
        # Whatever the tree and the preset are called: no path of this machine is in the names of units.
        string(REPLACE "${PROJECT_BINARY_DIR}/" "" folder "${folder}")
        string(REPLACE "${PROJECT_SOURCE_DIR}/" "" folder "${folder}")
        string(MAKE_C_IDENTIFIER "${folder}" room)
        math(EXPR count_${room} "${count_${room}} + 1")
        math(EXPR batch "(${count_${room}} - 1) / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
        set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${room}_${batch}")
    endforeach()
endfunction()

# grafverif_compile_alone(TARGET FILE...): sources whose local names other sources of the room use as well.
function(grafverif_compile_alone target)
    set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
