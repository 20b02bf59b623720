// SPDX-License-Identifier: MIT
#include "grafverif/report/vcd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <vector>

namespace grafverif {

namespace {

/// One variable of the dump: where its values are, and the last one written.
struct Wire {
    bool boolean = true;
    std::string code = {};
    std::int64_t value = 0;
};

/// The `index`th identifier code: printable characters, shortest first.
std::string code(std::size_t index) {
    constexpr std::size_t first = 33, count = 94;
    std::string text;
    do {
        text += static_cast<char>(first + index % count);
        index /= count;
    } while (index-- > 0);
    return text;
}

/// All values of a step in the order of the wires.
std::vector<std::int64_t> all_values(const Trace& trace, std::size_t index) {
    const Trace::State& state = trace.steps[index].after;
    std::vector<std::int64_t> list;
    for (const auto* part : {&state.inputs, &state.outputs, &state.internals, &state.plant})
        list.insert(list.end(), part->begin(), part->end());
    const std::size_t steps = list.size();
    list.resize(steps + trace.steps_of_charts.size(), 0);
    for (const std::uint32_t active : state.situation) list[steps + active] = 1;
    list.push_back(trace.loop_from && index >= *trace.loop_from ? 1 : 0);
    return list;
}

class Dump {
public:
    Dump(const Trace& trace, std::ostream& out) : trace_(trace), out_(out) {}

    void print() {
        out_ << "$comment one unit within an instant keeps the order of its steps $end\n$timescale 1us $end\n";
        scope("inputs", trace_.inputs);
        scope("outputs", trace_.outputs);
        scope("internals", trace_.internals);
        scope("plant", trace_.plant);
        steps();
        wire("loop", true);
        out_ << "$enddefinitions $end\n";
        std::int64_t time = -1;
        for (std::size_t i = 0; i < trace_.steps.size(); ++i) {
            time = std::max(time + 1, trace_.steps[i].after.time_ms * 1000);
            changes(i, time);
        }
        out_ << fmt::format("#{}\n", time + 1000);  // the last step is seen for a while
    }

private:
    void wire(const std::string& name, bool boolean) {
        wires_.push_back({boolean, code(wires_.size()), 0});
        out_ << fmt::format("$var {} {} {} $end\n", boolean ? "wire 1" : "integer 32", wires_.back().code, name);
    }

    void scope(const char* name, const std::vector<Trace::Signal>& signals) {
        if (signals.empty()) return;
        out_ << "$scope module " << name << " $end\n";
        for (const Trace::Signal& signal : signals) wire(signal.name, signal.type.boolean);
        out_ << "$upscope $end\n";
    }

    /// `G2.2` is X2 in a module G2 of its own.
    void steps() {
        out_ << "$scope module steps $end\n";
        for (const std::string& name : trace_.steps_of_charts) {
            std::size_t begin = 0;
            std::size_t depth = 0;
            for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', begin), ++depth) {
                out_ << "$scope module " << name.substr(begin, dot - begin) << " $end\n";
                begin = dot + 1;
            }
            wire("X" + name.substr(begin), true);
            for (; depth > 0; --depth) out_ << "$upscope $end\n";
        }
        out_ << "$upscope $end\n";
    }

    void changes(std::size_t index, std::int64_t time) {
        const std::vector<std::int64_t> now = all_values(trace_, index);
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

    const Trace& trace_;
    std::ostream& out_;
    std::vector<Wire> wires_ = {};
};

}  // namespace

void print_vcd(const Trace& trace, std::ostream& out) { Dump(trace, out).print(); }

}  // namespace grafverif
