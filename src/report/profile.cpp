// SPDX-License-Identifier: MIT
#include "report/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "grafverif/ir/chart_run.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

constexpr double least_factor = 1.05;  // minimum state space factor of a listed component or clock
constexpr std::size_t most_lines = 12;

std::string_view kind_word(StateProfile::Kind kind) {
    switch (kind) {
    case StateProfile::Kind::Instance: return "instance";
    case StateProfile::Kind::Controller: return "controller";
    case StateProfile::Kind::Environment: break;
    }
    return "environment";
}

class ProfilePrinter {
public:
    ProfilePrinter(const StateProfile& profile, std::ostream& out) : profile_(profile), out_(out) {}

    void print() {
        const bool all = profile_.sampled == profile_.states;
        out_ << fmt::format("state space factors of {} ({}):\n",
                            all ? fmt::format("these {} states", profile_.states)
                                : fmt::format("the first {} of {} states", profile_.sampled, profile_.states),
                            "x N: without this element, the number of states would be divided by N");
        print_lines(profile_.parts, [&](const StateProfile::Component& part) {
            const bool more = part.combinations >= profile_.most_combinations;
            return fmt::format("{} {}, {}{} combinations of its variables", kind_word(part.kind), printable(part.name),
                               part.combinations, more ? " or more" : "");
        });
        print_lines(profile_.clocks, [](const StateProfile::Clock& clock) {
            return fmt::format("the clock {} of {} alone, {} values, greatest constant in comparisons: {}",
                               printable(clock.name), printable(clock.process), clock.values, clock.greatest);
        });
        if (const std::uint64_t inside = profile_.inside_cycles; inside != 0)
            out_ << fmt::format(
                "    {} % of these states are within a cycle; with grain atomic, each cycle is one step, and at most "
                "{} of these states remain\n",
                (100 * inside + profile_.sampled / 2) / profile_.sampled, profile_.sampled - inside);
        if (profile_.finest) print(*profile_.finest);
    }

private:
    template <class Element, class Words>
    void print_lines(const std::vector<Element>& elements, const Words& words) {
        const auto end = std::ranges::find_if(
            elements, [](const Element& element) { return element.factor.value() < least_factor; });
        const auto count = static_cast<std::size_t>(end - elements.begin());
        for (std::size_t i = 0; i < std::min(count, most_lines); ++i)
            out_ << fmt::format("    x {:<7.1f} {}{}\n", elements[i].factor.value(), words(elements[i]),
                                elements[i].place.empty() ? "" : " (" + printable(elements[i].place) + ")");
        if (count > most_lines) out_ << fmt::format("    and {} more with smaller factors\n", count - most_lines);
    }

    void print(const StateProfile::Finest& finest) {
        const std::string place = finest.place.empty() ? "" : " (" + printable(finest.place) + ")";
        const std::string gain =
            finest.factor.value() < least_factor
                ? ""
                : fmt::format(" (x {0:.1f}: with this unit, the number of states would be divided by {0:.1f})",
                              finest.factor.value());
        if (finest.duration_ms == 0)
            out_ << fmt::format("    the declared time unit is {}{}; the durations are multiples of {}{}\n",
                                seconds_text(finest.unit_ms), place, seconds_text(finest.coarser_ms), gain);
        else
            out_ << fmt::format("    with the duration {}{}, the time unit is {}; without this duration, it is {}{}\n",
                                seconds_text(finest.duration_ms), place, seconds_text(finest.unit_ms),
                                seconds_text(finest.coarser_ms), gain);
    }

    const StateProfile& profile_;
    std::ostream& out_;
};

}  // namespace

void name_places(StateProfile& profile, const Sources& sources) {
    for (StateProfile::Component& part : profile.parts) part.place = file_and_line(sources, part.origin);
    for (StateProfile::Clock& clock : profile.clocks) clock.place = file_and_line(sources, clock.origin);
    if (profile.finest) profile.finest->place = file_and_line(sources, profile.finest->origin);
}

void print_profile(const StateProfile& profile, std::ostream& out) { ProfilePrinter(profile, out).print(); }

Json profile_json(const StateProfile& profile) {
    Json parts = Json::array(), clocks = Json::array();
    for (const StateProfile::Component& part : profile.parts)
        parts.push_back({{"name", part.name},
                         {"kind", kind_word(part.kind)},
                         {"combinations", part.combinations},
                         {"factor", part.factor.value()},
                         {"place", text_or_null(part.place)}});
    for (const StateProfile::Clock& clock : profile.clocks)
        clocks.push_back({{"instance", clock.process},
                          {"clock", clock.name},
                          {"greatest", clock.greatest},
                          {"values", clock.values},
                          {"factor", clock.factor.value()},
                          {"place", text_or_null(clock.place)}});
    Json finest = nullptr;
    if (profile.finest)
        finest = Json{{"duration", profile.finest->duration_ms},
                      {"unit", profile.finest->unit_ms},
                      {"coarser", profile.finest->coarser_ms},
                      {"factor", profile.finest->factor.value()},
                      {"place", text_or_null(profile.finest->place)}};
    return {{"states", profile.states},  {"sampled", profile.sampled},  {"inside_cycles", profile.inside_cycles},
            {"parts", std::move(parts)}, {"clocks", std::move(clocks)}, {"finest", std::move(finest)}};
}

}  // namespace grafverif
