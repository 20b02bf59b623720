// SPDX-License-Identifier: MIT
// Runs `grafverif-certify`, and writes certificates for its tests.
#pragma once

#include <sys/wait.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>

#include "unit/app/run_program.hpp"

namespace grafverif::app {

struct Certified {
    int code = 0;
    std::string out = {};  ///< standard output and standard error
};

inline Certified certify(const std::string& folder) {
    const std::string line = std::string(GRAFVERIF_CERTIFY) + " '" + folder + "' 2>&1";
    FILE* const pipe = ::popen(line.c_str(), "r");
    std::string text;
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    return {WEXITSTATUS(::pclose(pipe)), text};
}

/// Returns the checksum of a certificate file.
inline std::string checksum(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    return std::to_string(hash);
}

/// Writes a certificate with correct checksums; `claims` are the lines of the index after `network`.
inline std::string write_certificate(const Folder& folder, const std::string& network, const std::string& claims) {
    std::string index = "grafverif-certificate 2\nnetwork " + checksum(network) + '\n' + claims;
    index += "checksum " + checksum(index) + '\n';
    folder.write("network.txt", network);
    return fs::path(folder.write("certificate.txt", index)).parent_path().string();
}

}  // namespace grafverif::app
