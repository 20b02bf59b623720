# SPDX-License-Identifier: MIT
# Settings of `cpack`, which builds packages for Debian and Ubuntu. Each package contains one component. As with
# Debian's tools, the environment variables DEBFULLNAME and DEBEMAIL, which are read when the tree is configured,
# specify the maintainer. SOURCE_DATE_EPOCH specifies the time.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME grafverif)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own summary
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/packaging/one_time.cmake")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(packager "the grafverif authors <grafverif@example.org>")
if(DEFINED ENV{DEBEMAIL})
    set(packager "$ENV{DEBEMAIL}")
    if(DEFINED ENV{DEBFULLNAME})
        set(packager "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
    endif()
endif()
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${packager}")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME grafverif)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "grafverif-doc")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "verify GRAFCET charts with their plants
grafverif verifies properties of the closed loop of a GRAFCET chart
(IEC 60848) and a plant built from library components. It has embedded
engines, replays counterexamples on the drawn chart, and writes models for
UPPAAL, NuSMV and other model checkers.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libgrafverif-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libpugixml-dev, libfmt-dev, nlohmann-json3-dev, libyaml-cpp-dev, libcadical-dev, libicu-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "grafverif-doc, cmake")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "library to verify GRAFCET charts with their plants
grafverif verifies properties of the closed loop of a GRAFCET chart
(IEC 60848) and a plant built from library components.

This package contains the static library, its headers and the files for
find_package of CMake.")

set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME grafverif-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOCUMENTATION_DESCRIPTION "documentation and samples of grafverif
grafverif verifies properties of the closed loop of a GRAFCET chart
(IEC 60848) and a plant built from library components.

This package contains the documentation, the samples, and the library of
components as text.")

set(components program library documentation)
if(TARGET grafverif_python)
    list(APPEND components python)
    math(EXPR next_minor "${GRAFVERIF_PYTHON_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-grafverif)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${GRAFVERIF_PYTHON_MINOR}~), python3 (<< 3.${next_minor})")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "grafverif-doc, python3-pandas")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
    file(COPY packaging/python/postinst packaging/python/prerm DESTINATION "${PROJECT_BINARY_DIR}/packaging/python"
         FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/packaging/python/postinst;${PROJECT_BINARY_DIR}/packaging/python/prerm")
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "verify GRAFCET charts from Python
grafverif verifies properties of the closed loop of a GRAFCET chart
(IEC 60848) and a plant built from library components.

This package contains the Python module with type annotations.")
endif()

# Each package contains its licence and its changelog. `cmake --install` does not install these files.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(READ packaging/changelog.Debian.in changelog)
string(REPLACE @VERSION@ "${PROJECT_VERSION}" changelog "${changelog}")
string(REPLACE @PACKAGER@ "${packager}" changelog "${changelog}")
string(REPLACE @DATE@ "${date}" changelog "${changelog}")
file(WRITE "${PROJECT_BINARY_DIR}/packaging/changelog.Debian" "${changelog}")
configure_file(CHANGELOG.md packaging/changelog COPYONLY)
foreach(file changelog changelog.Debian)
    execute_process(COMMAND gzip -9 -n -k -f "${PROJECT_BINARY_DIR}/packaging/${file}")
endforeach()
set(CPACK_COMPONENTS_ALL "")
foreach(component IN LISTS components)
    string(TOUPPER ${component} upper)
    install(FILES packaging/copyright "${PROJECT_BINARY_DIR}/packaging/changelog.gz" "${PROJECT_BINARY_DIR}/packaging/changelog.Debian.gz"
            DESTINATION share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
            COMPONENT debian_${component} EXCLUDE_FROM_ALL)
    set(CPACK_COMPONENT_${upper}_GROUP ${component})
    set(CPACK_COMPONENT_DEBIAN_${upper}_GROUP ${component})
    set(CPACK_COMPONENT_GROUP_${upper}_DESCRIPTION "${CPACK_COMPONENT_${upper}_DESCRIPTION}")
    list(APPEND CPACK_COMPONENTS_ALL ${component} debian_${component})
endforeach()
include(CPack)
