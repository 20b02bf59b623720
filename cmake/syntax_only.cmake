# SPDX-License-Identifier: MIT
# GRAFVERIF_SYNTAX_ONLY (`./dev lint`): a second compiler checks every source, with warnings as errors, without
# generating code. For each checked source it writes an empty file, so that the next run checks only changed sources.
set(CMAKE_CXX_COMPILE_OBJECT
    "<CMAKE_CXX_COMPILER> -Xclang -fsyntax-only <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>" "\"${CMAKE_COMMAND}\" -E touch <OBJECT>")
set(CMAKE_CXX_CREATE_STATIC_LIBRARY "\"${CMAKE_COMMAND}\" -E touch <TARGET>")
set(CMAKE_CXX_CREATE_SHARED_MODULE "\"${CMAKE_COMMAND}\" -E touch <TARGET>")
set(CMAKE_CXX_LINK_EXECUTABLE "\"${CMAKE_COMMAND}\" -E touch <TARGET>")
set(CMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE PRE_TEST)
