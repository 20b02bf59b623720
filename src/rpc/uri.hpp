// SPDX-License-Identifier: MIT
// Converts between paths and addresses (RFC 3986, RFC 8089), by which messages refer to files.
#pragma once

#include <string>
#include <string_view>

namespace grafverif::rpc {

/// Returns the path in an address such as `file:///a%20b`. If the scheme is not `file`, returns the address itself.
std::string path_of_uri(std::string_view uri);
/// Returns the address of a path. The scheme is `file`, or `grafverif` for files that are not on the disk, such as
/// components of the library.
std::string uri_of_path(std::string_view path);

}  // namespace grafverif::rpc
