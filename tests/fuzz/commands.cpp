// SPDX-License-Identifier: MIT
// Runs every command on generated charts and closed loops. The first byte selects the command; the other bytes
// determine the model.
#include <fstream>
#include <sstream>

#include "fuzz/byte_random.hpp"
#include "fuzz/every_command.hpp"
#include "fuzz/targets.hpp"
#include "read/text.hpp"
#include "support/print_model.hpp"
#include "support/random_loop.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::fuzz {

namespace {

Model model_of(Random& random) {
    if (chance(random, 70)) return random_loop(random);
    Model model;
    model.charts.add(random_chart(random));
    return model;
}

}  // namespace

std::string commands_complaint(std::string_view bytes) {
    static const app::Folder folder;
    if (bytes.empty()) return {};
    const VerbRun& run = command_runs()[static_cast<unsigned char>(bytes[0]) % command_runs().size()];
    Random random = byte_random(bytes.substr(1));
    std::ostringstream text;
    print(text, model_of(random));
    Sources sources;
    Diagnostics diagnostics;
    const auto model = read_text(sources.add({"model.grafcet", text.str()}), sources, {}, diagnostics);
    if (!model || (run.of_loop && model->loops.empty())) return {};
    return error_text(run, folder.write("model.grafcet", text.str()), *model, folder.file("written"));
}

}  // namespace grafverif::fuzz
