// SPDX-License-Identifier: MIT
#include "rpc/uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace grafverif::rpc {

std::string path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file://";
    if (!uri.starts_with(scheme)) return std::string(uri);
    uri.remove_prefix(scheme.size());
    uri.remove_prefix(std::min(uri.find('/'), uri.size()));  // skips the host, which is the local machine
    std::string path;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        unsigned byte = 0;
        const bool coded =
            uri[at] == '%' && at + 2 < uri.size() &&
            std::from_chars(uri.data() + at + 1, uri.data() + at + 3, byte, 16).ptr == uri.data() + at + 3;
        path += coded ? static_cast<char>(byte) : uri[at];
        if (coded) at += 2;
    }
    return path;
}

std::string uri_of_path(std::string_view path) {
    if (!path.starts_with('/') && path.find(':') != std::string_view::npos) return std::string(path);
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string uri = path.starts_with('/') ? "file://" : "grafverif:";
    for (const char byte : path) {
        if (plain.find(byte) != std::string_view::npos) uri += byte;
        else uri += fmt::format("%{:02X}", static_cast<unsigned char>(byte));
    }
    return uri;
}

}  // namespace grafverif::rpc
