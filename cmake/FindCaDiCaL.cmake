# SPDX-License-Identifier: MIT
# CaDiCaL::CaDiCaL: the SAT solver as a library (Debian: libcadical-dev), which does not include a CMake package.
find_path(CaDiCaL_INCLUDE_DIR cadical.hpp PATH_SUFFIXES cadical)
find_library(CaDiCaL_LIBRARY cadical)
mark_as_advanced(CaDiCaL_INCLUDE_DIR CaDiCaL_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CaDiCaL
    REQUIRED_VARS CaDiCaL_LIBRARY CaDiCaL_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "install the SAT solver as a library: apt-get install libcadical-dev")
if(CaDiCaL_FOUND AND NOT TARGET CaDiCaL::CaDiCaL)
    add_library(CaDiCaL::CaDiCaL UNKNOWN IMPORTED)
    set_target_properties(CaDiCaL::CaDiCaL PROPERTIES
        IMPORTED_LOCATION "${CaDiCaL_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${CaDiCaL_INCLUDE_DIR}")
endif()
