// SPDX-License-Identifier: MIT
#include "support/text/skeleton.hpp"

#include <unicode/uspoof.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>

namespace grafverif {

namespace {

struct Close {
    void operator()(USpoofChecker* checker) const { uspoof_close(checker); }
};

void demand(UErrorCode status) {
    if (status == U_MEMORY_ALLOCATION_ERROR) throw std::bad_alloc();
    if (U_FAILURE(status) != 0) throw std::runtime_error("ICU cannot provide its data on confusable characters");
}

}  // namespace

bool all_ascii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string skeleton(std::string_view name) {
    UErrorCode status = U_ZERO_ERROR;
    thread_local const std::unique_ptr<USpoofChecker, Close> checker(uspoof_open(&status));
    demand(status);
    const auto length = static_cast<std::int32_t>(name.size());
    std::string found(4 * name.size() + 16, '\0');
    std::int32_t size = uspoof_getSkeletonUTF8(checker.get(), 0, name.data(), length, found.data(),
                                               static_cast<std::int32_t>(found.size()), &status);
    if (status == U_BUFFER_OVERFLOW_ERROR) {
        status = U_ZERO_ERROR;
        found.resize(static_cast<std::size_t>(size));
        size = uspoof_getSkeletonUTF8(checker.get(), 0, name.data(), length, found.data(), size, &status);
    }
    demand(status);
    found.resize(static_cast<std::size_t>(size));
    return found;
}

}  // namespace grafverif
