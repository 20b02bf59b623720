// SPDX-License-Identifier: MIT
#include "report/vcd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>
#include <vector>

namespace grafverif {

namespace {

/// A variable of the dump, and the value that was last written for it.
struct Wire {
    bool boolean = true;
    std::string code = {};
    std::int64_t value = 0;
};

/// Returns the `index`th identifier code. Codes consist of printable characters, shortest first.
std::string code(std::size_t index) {
    constexpr std::size_t first = 33, count = 94;
    std::string text;
    do {
        text += static_cast<char>(first + index % count);
        index /= count;
    } while (index-- > 0);
    return text;
}

constexpr std::array<std::pair<const char*, ChartRun::Role>, 4> scopes{{{"inputs", ChartRun::Role::Input},
                                                                        {"outputs", ChartRun::Role::Output},
                                                                        {"internals", ChartRun::Role::Internal},
                                                                        {"plant", ChartRun::Role::Plant}}};

/// Returns the values of all wires after a row of the run, in the order of the wires.
std::vector<std::int64_t> all_values(const ChartRun& run, std::size_t index) {
    const ChartRun::State& state = run.after(run.rows[index]);
    std::vector<std::int64_t> list;
    for (const auto& [name, role] : scopes)
        for (const Id<ChartRun::Signal> id : signals_of(run, role)) list.push_back(state.values[id.index]);
    const std::size_t steps = list.size();
    list.resize(steps + run.steps.size(), 0);
    for (const Id<ChartRun::Step> active : state.situation) list[steps + active.index] = 1;
    list.push_back(run.loop_from && index >= *run.loop_from ? 1 : 0);
    return list;
}

class Dump {
public:
    Dump(const ChartRun& run, std::ostream& out) : run_(run), out_(out) {}

    void print() {
        out_ << "$comment consecutive steps of an instant differ by one time unit $end\n$timescale 1us $end\n";
        for (const auto& [name, role] : scopes) scope(name, signals_of(run_, role));
        steps();
        wire("loop", true);
        out_ << "$enddefinitions $end\n";
        std::int64_t time = -1;
        for (std::size_t i = 0; i < run_.rows.size(); ++i) {
            time = std::max(time + 1, run_.after(run_.rows[i]).time_ms * 1000);
            changes(i, time);
        }
        // The final time stamp makes viewers show the last state for one millisecond.
        out_ << fmt::format("#{}\n", time + 1000);
    }

private:
    void wire(const std::string& name, bool boolean) {
        wires_.push_back({boolean, code(wires_.size()), 0});
        out_ << fmt::format("$var {} {} {} $end\n", boolean ? "wire 1" : "integer 32", wires_.back().code, name);
    }

    void scope(const char* name, const std::vector<Id<ChartRun::Signal>>& signals) {
        if (signals.empty()) return;
        out_ << "$scope module " << name << " $end\n";
        for (const Id<ChartRun::Signal> id : signals) wire(run_.signals[id].name, run_.signals[id].type.boolean);
        out_ << "$upscope $end\n";
    }

    /// Adds a wire for each step. A step of a named partial chart, such as `G2.2`, is the wire X2 in a separate module
    /// G2.
    void steps() {
        out_ << "$scope module steps $end\n";
        for (const ChartRun::Step& step : run_.steps) {
            const auto each_module = [&](const auto& print) {
                for (const std::string* name : {&step.controller, &step.name.partial})
                    if (!name->empty()) print(*name);
            };
            each_module([&](const std::string& name) { out_ << "$scope module " << name << " $end\n"; });
            wire("X" + step.name.step, true);
            each_module([&](const std::string&) { out_ << "$upscope $end\n"; });
        }
        out_ << "$upscope $end\n";
    }

    void changes(std::size_t index, std::int64_t time) {
        const std::vector<std::int64_t> now = all_values(run_, index);
        out_ << '#' << time << '\n';
        if (index == 0) out_ << "$dumpvars\n";
        for (std::size_t i = 0; i < wires_.size(); ++i) {
            Wire& wire = wires_[i];
            if (index > 0 && wire.value == now[i]) continue;
            wire.value = now[i];
            if (wire.boolean) out_ << (now[i] != 0 ? '1' : '0') << wire.code << '\n';
            else out_ << fmt::format("b{:b} {}\n", static_cast<std::uint32_t>(now[i]), wire.code);
        }
        if (index == 0) out_ << "$end\n";
    }

    const ChartRun& run_;
    std::ostream& out_;
    std::vector<Wire> wires_ = {};
};

}  // namespace

void print_vcd(const ChartRun& run, std::ostream& out) { Dump(run, out).print(); }

}  // namespace grafverif
