# SPDX-License-Identifier: MIT
include(CMakePackageConfigHelpers)

install(TARGETS grafverif EXPORT grafverifTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS grafverif_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT grafverifTargets NAMESPACE grafverif:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif)

configure_package_config_file(cmake/grafverifConfig.cmake.in "${PROJECT_BINARY_DIR}/grafverifConfig.cmake"
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/grafverifConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/grafverifConfig.cmake" "${PROJECT_BINARY_DIR}/grafverifConfigVersion.cmake"
              cmake/FindCaDiCaL.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif)
install(DIRECTORY templates samples DESTINATION ${CMAKE_INSTALL_DATADIR}/grafverif)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
