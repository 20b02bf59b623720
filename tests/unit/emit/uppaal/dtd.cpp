// SPDX-License-Identifier: MIT
#include "unit/emit/uppaal/dtd.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace grafverif::test {

bool has_xmllint() { return std::system("xmllint --version > /dev/null 2>&1") == 0; }

bool is_valid(const std::string& xml) {
    const auto file = std::filesystem::temp_directory_path() / ("grafverif_dtd_" + std::to_string(::getpid()) + ".xml");
    std::ofstream(file) << xml;
    const std::string catalog = GRAFVERIF_SOURCE_DIR "/tests/support/uppaal_dtd/catalog.xml";
    const std::string command =
        "XML_CATALOG_FILES='" + catalog + "' xmllint --noout --nonet --valid " + file.string() + " 2>&1";
    const int status = std::system(command.c_str());
    std::filesystem::remove(file);
    return status == 0;
}

}  // namespace grafverif::test
