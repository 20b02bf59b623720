// SPDX-License-Identifier: MIT
// Entry points for libFuzzer. GRAFVERIF_FUZZ_TARGET names the target of this program.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const grafverif::fuzz::Target& target : grafverif::fuzz::targets()) {
        if (target.name != GRAFVERIF_FUZZ_TARGET) continue;
        const std::string error_text = target.error_text({reinterpret_cast<const char*>(data), size});
        if (error_text.empty()) return 0;
        std::cerr << "violated guarantee: " << error_text << '\n';
        std::abort();
    }
    std::abort();  // unknown target
}
