# SPDX-License-Identifier: MIT
# grafverif_warnings: compiler options for the code of the project, including the sanitizers if they are enabled. The
# preset determines whether warnings are errors (CMAKE_COMPILE_WARNING_AS_ERROR): all presets except `run` and `package`.
add_library(grafverif_warnings INTERFACE)
target_compile_options(grafverif_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                       -Wnon-virtual-dtor -Wold-style-cast -Wswitch)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 reports false positives about overlapping copies in std::string's operator+ (GCC bug 105651)
    target_compile_options(grafverif_warnings INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ reports false positives for members of std::variant, std::optional and, with sanitizers, std::regex (GCC bug
    # 105562).
    target_compile_options(grafverif_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
if(GRAFVERIF_SANITIZE)
    add_compile_options(-fsanitize=${GRAFVERIF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${GRAFVERIF_SANITIZE})
    # clang does not define the macros with which g++ announces sanitizers.
    foreach(sanitizer address thread)
        string(TOUPPER ${sanitizer} macro)
        if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND GRAFVERIF_SANITIZE MATCHES ${sanitizer})
            add_compile_definitions(__SANITIZE_${macro}__=1)
        endif()
    endforeach()
endif()
