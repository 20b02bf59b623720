# SPDX-License-Identifier: MIT
# Installs these components: the program with files for shells, manuals, editors and desktops; the library with its
# headers; the documentation with the samples. The Python module is a component that python/ defines. `cmake --install`
# installs all components; packaging/debian.cmake builds a package from each.
include(CMakePackageConfigHelpers)
set(data ${CMAKE_INSTALL_DATADIR})

install(TARGETS grafverif_program grafverif_certify RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
foreach(folder vim/vimfiles nvim/site)
    install(DIRECTORY editors/vim/ DESTINATION ${data}/${folder} COMPONENT program)
endforeach()
install(FILES packaging/mime.xml DESTINATION ${data}/mime/packages RENAME grafverif.xml COMPONENT program)
install(FILES editors/vscode/icons/grafcet.svg DESTINATION ${data}/icons/hicolor/scalable/mimetypes RENAME text-x-grafcet.svg
        COMPONENT program)
install(FILES packaging/grafverif-certify.1 DESTINATION ${data}/man/man1 COMPONENT program)
if(NOT CMAKE_CROSSCOMPILING)
    install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:grafverif_program>\"
                                          \"-DROOT=\$ENV{DESTDIR}\" \"-DPREFIX=\${CMAKE_INSTALL_PREFIX}\"
                                          -P \"${PROJECT_SOURCE_DIR}/packaging/generated_files.cmake\" COMMAND_ERROR_IS_FATAL ANY)"
            COMPONENT program)
endif()

install(TARGETS grafverif EXPORT grafverifTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(EXPORT grafverifTargets NAMESPACE grafverif:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif COMPONENT library)
configure_package_config_file(cmake/grafverifConfig.cmake.in "${PROJECT_BINARY_DIR}/grafverifConfig.cmake"
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/grafverifConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/grafverifConfig.cmake" "${PROJECT_BINARY_DIR}/grafverifConfigVersion.cmake"
              cmake/FindCaDiCaL.cmake cmake/grafverifFunctions.cmake cmake/grafverifDiscover.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/grafverif COMPONENT library)

# The folder structure is the same as in the repository, so that links between pages are valid.
install(FILES LICENSE README.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(DIRECTORY samples docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
        PATTERN "*.sh" EXCLUDE PATTERN conf.py EXCLUDE PATTERN site EXCLUDE)
install(DIRECTORY tests/unit/app/elements DESTINATION ${CMAKE_INSTALL_DOCDIR}/tests/unit/app COMPONENT documentation
        FILES_MATCHING PATTERN "*.grafcet")
install(DIRECTORY templates DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation PATTERN CMakeLists.txt EXCLUDE)

set(stripped "program:grafverif_program:${CMAKE_INSTALL_BINDIR}" "program:grafverif_certify:${CMAKE_INSTALL_BINDIR}"
             "library:grafverif:${CMAKE_INSTALL_LIBDIR}")
if(TARGET grafverif_python)
    list(APPEND stripped "python:grafverif_python:${GRAFVERIF_PYTHON_DESTINATION}/grafverif")
endif()
foreach(component_target_and_folder IN LISTS stripped)
    string(REGEX MATCH "^(.*):(.*):(.*)$" _ ${component_target_and_folder})
    install(CODE "if(CMAKE_INSTALL_DO_STRIP)
                      set(FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_MATCH_3}/$<TARGET_FILE_NAME:${CMAKE_MATCH_2}>\")
                      include(\"${PROJECT_SOURCE_DIR}/packaging/strip.cmake\")
                  endif()" COMPONENT ${CMAKE_MATCH_1})
endforeach()

include(packaging/debian.cmake)
