// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <array>

namespace grafverif::fuzz {

std::span<const Target> targets() {
    static constexpr std::array all{
        Target{"text", text_complaint},
        Target{"agrafe", import_complaint},
        Target{"plcopen", import_complaint},
        Target{"sfc", import_complaint},
        Target{"structured_text", structured_text_complaint},
        Target{"program", program_complaint},
        Target{"test_table", test_table_complaint},
        Target{"exclusions", exclusions_complaint},
        Target{"scan", scan_complaint},
        Target{"plc", plc_complaint},
        Target{"monitor", monitor_complaint},
        Target{"simulate", simulate_complaint},
        Target{"nusmv", nusmv_complaint},
        Target{"verifyta", verifyta_complaint},
        Target{"mcp", mcp_complaint},
        Target{"commands", commands_complaint},
    };
    return all;
}

}  // namespace grafverif::fuzz
