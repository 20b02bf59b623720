# SPDX-License-Identifier: MIT
# grafverif_warnings: what our own code is compiled with, and the sanitizers where asked for. Whether a warning is an
# error is the preset's choice (CMAKE_COMPILE_WARNING_AS_ERROR).
add_library(grafverif_warnings INTERFACE)
target_compile_options(grafverif_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                       -Wnon-virtual-dtor -Wold-style-cast -Wswitch)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 sees overlapping copies in std::string's operator+ where there are none (GCC bug 105651)
    target_compile_options(grafverif_warnings INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # the inside of a std::variant or std::optional, and instrumented that of std::regex (GCC bug 105562), looks uninitialised
    target_compile_options(grafverif_warnings INTERFACE -Wno-maybe-uninitialized)
endif()
if(GRAFVERIF_SANITIZE)
    add_compile_options(-fsanitize=${GRAFVERIF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${GRAFVERIF_SANITIZE})
endif()
