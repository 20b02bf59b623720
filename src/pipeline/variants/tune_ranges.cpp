// SPDX-License-Identifier: MIT
#include "pipeline/variants/tune_ranges.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <set>

#include "pipeline/variants/tune.hpp"
#include "report/charts/tuning.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"
#include "support/printable.hpp"
#include "syntax/print/constants.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

/// A value of the option `--over`: `NAME=LOW..HIGH` or `NAME=LOW..HIGH:STEP`.
struct WrittenRange {
    std::string name = {}, low = {}, high = {}, step = {};
    std::string values() const { return low + ".." + high; }
};

std::optional<WrittenRange> split(const std::string& text) {
    const std::size_t sign = text.find('='), dots = text.find("..", sign == std::string::npos ? 0 : sign);
    if (sign == std::string::npos || dots == std::string::npos) return {};
    const std::size_t colon = text.find(':', dots);
    const bool has_step = colon != std::string::npos;
    WrittenRange written{text.substr(0, sign), text.substr(sign + 1, dots - sign - 1),
                         text.substr(dots + 2, has_step ? colon - dots - 2 : colon),
                         has_step ? text.substr(colon + 1) : ""};
    const bool complete =
        !written.name.empty() && !written.low.empty() && !written.high.empty() && has_step == !written.step.empty();
    return complete ? std::optional(written) : std::nullopt;
}

/// Reads the values of the option `--over`.
class RangeReader {
public:
    RangeReader(const std::vector<std::string>& ranges, const ClosedLoop& loop,
                const std::map<std::string, std::string>& set, Diagnostics& diagnostics)
        : ranges_(ranges), loop_(loop), set_(set), diagnostics_(diagnostics) {}

    /// Returns the constants that `--over` names. The result is empty after an error; all errors are reported.
    std::vector<TunedConstant> read() {
        const std::size_t errors = diagnostics_.errors();
        std::vector<TunedConstant> constants;
        std::set<std::string> names;
        for (const std::string& text : ranges_) {
            const auto written = split(text);
            if (!written) {
                fail({}, fmt::format("invalid value `{}` of `--over`", printable(text)),
                     "name a constant and its values, as in `--over N=1..8` or `--over FILL=1s..20s:500ms`");
                continue;
            }
            if (!names.insert(written->name).second)
                fail({}, fmt::format("`--over` names `{}` twice", printable(written->name)), "remove one");
            if (set_.contains(written->name))
                fail({}, fmt::format("`--set` and `--over` both name `{}`", printable(written->name)), "remove one");
            if (auto constant = read(*written)) constants.push_back(std::move(*constant));
        }
        if (ranges_.empty())
            fail({}, "`tune` needs the values of at least one constant",
                 "pass `--over`, as in `--over N=1..8` or `--over FILL=1s..20s:500ms`");
        if (diagnostics_.errors() == errors) check_size(constants);
        return diagnostics_.errors() == errors ? constants : std::vector<TunedConstant>{};
    }

private:
    void fail(Span where, std::string_view problem, std::string_view remedy) {
        diagnostics_.add(messages::bad_values(where, problem, remedy));
    }

    std::optional<TunedConstant> read(const WrittenRange& written) {
        std::vector<std::string> names;
        for (const NamedConstant& constant : loop_.constants) {
            if (constant.name == written.name) return read(written, constant);
            names.push_back(constant.name);
        }
        diagnostics_.add(
            messages::no_such_constant(loop_.origin, loop_.name, written.name, nearest_of(written.name, names)));
        return {};
    }

    std::optional<TunedConstant> read(const WrittenRange& written, const NamedConstant& constant) {
        const bool duration = constant.kind == NamedConstant::Kind::Duration;
        const auto wrong = [&](std::string_view problem, std::string_view remedy) {
            fail(constant.origin, problem, remedy);
            return std::nullopt;
        };
        if (constant.kind == NamedConstant::Kind::Boolean)
            return wrong(fmt::format("the constant `{}` is Boolean", constant.name),
                         "`--over` accepts only numbers and durations; run the command twice, with `--set NAME=true` "
                         "and `--set NAME=false`");
        const auto low = value_of(constant.kind, written.low), high = value_of(constant.kind, written.high);
        const auto step = written.step.empty() ? std::optional<std::int64_t>(duration ? 1000 : 1)
                                               : value_of(constant.kind, written.step);
        if (!low || !high || !step)
            return wrong(fmt::format("the constant `{}` is {} and cannot have the values `{}{}{}`", constant.name,
                                     duration ? "a duration" : "an integer", printable(written.values()),
                                     written.step.empty() ? "" : ":", printable(written.step)),
                         fmt::format("write `--over {}={}`", constant.name, duration ? "1s..20s:1s" : "1..20:1"));
        TunedConstant made{constant.name, constant.kind, *low, *high, *step, constant.value};
        if (!duration && (made.low < least_integer || made.high > greatest_integer))
            return wrong(fmt::format("the values `{}` of `{}` are outside the integer range {}..{}",
                                     printable(written.values()), constant.name, least_integer, greatest_integer),
                         "reduce the range");
        if (made.step <= 0)
            return wrong(fmt::format("the step of `{}` is {}", constant.name, made.step), "use a positive step");
        if (made.low > made.high)
            return wrong(fmt::format("the range `{}` of `{}` is empty", printable(written.values()), constant.name),
                         "write the smaller value first");
        const auto width = static_cast<std::uint64_t>(made.high) - static_cast<std::uint64_t>(made.low);
        if (const auto rest = static_cast<std::int64_t>(width % static_cast<std::uint64_t>(made.step)); rest != 0)
            return wrong(fmt::format("the step {} does not divide the range `{}` of `{}`", value_text(made, made.step),
                                     printable(written.values()), constant.name),
                         fmt::format("end the range at {}, or change the step", value_text(made, made.high - rest)));
        return made;
    }

    void check_size(const std::vector<TunedConstant>& constants) {
        double points = 1;
        for (const TunedConstant& constant : constants)
            points *= (static_cast<double>(constant.high) - static_cast<double>(constant.low)) /
                          static_cast<double>(constant.step) +
                      1;
        if (points <= static_cast<double>(most_points)) return;
        const double hours = points / 1000 / 3600;  // reading a small model takes about 1 ms
        fail(
            {},
            fmt::format("the grid has {:.0f} points, but at most {} are allowed; at one millisecond per point, reading "
                        "the models of all points would take {:.1f} hours",
                        points, most_points, hours),
            "use larger steps or smaller ranges");
    }

    const std::vector<std::string>& ranges_;
    const ClosedLoop& loop_;
    const std::map<std::string, std::string>& set_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::vector<TunedConstant> constants_over(const std::vector<std::string>& ranges, const ClosedLoop& loop,
                                          const std::map<std::string, std::string>& set, Diagnostics& diagnostics) {
    return RangeReader(ranges, loop, set, diagnostics).read();
}

}  // namespace grafverif
