// SPDX-License-Identifier: MIT
#include "report/charts/faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include "ir/patterns.hpp"
#include "report/json_place.hpp"
#include "report/json_trace.hpp"
#include "report/settings_text.hpp"
#include "report/table.hpp"
#include "report/terminal.hpp"
#include "support/json_text.hpp"
#include "support/printable.hpp"
#include "support/xml_text.hpp"
#include "syntax/print/constants.hpp"
#include "syntax/print/legal_names.hpp"

namespace grafverif {

namespace {

using Json = nlohmann::ordered_json;

/// For each property: maximum number of undecided combinations that are listed, and of non-monotone combinations that
/// are listed.
constexpr std::size_t most_listed_sets = 5;

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
    return text;
}

/// Returns the names of several combinations, such as `V_stuck, V_stuck + H_stuck`.
std::string names_of(const FaultAnalysis& analysis, const std::vector<FaultSet>& sets) {
    std::string text;
    for (const FaultSet& faults : sets) text += (text.empty() ? "" : ", ") + names_of(analysis, faults);
    return text;
}

void print_table(const FaultAnalysis& analysis, std::ostream& out) {
    std::size_t width = columns_of("property");
    for (const FaultAnalysis::Row& row : analysis.rows)
        if (is_shown(row)) width = std::max(width, columns_of(printable(row.property)));
    out << '\n' << padded("property", width) << "  minimal combinations of faults that lead to a violation\n";
    for (const FaultAnalysis::Row& row : analysis.rows) {
        if (!is_shown(row)) continue;
        std::string text;
        if (row.without_faults != Outcome::Holds) text = std::string(word(row.without_faults)) + " without faults";
        for (const FaultAnalysis::Cut& cut : row.minimal) {
            const std::string note = unproved(analysis, cut);
            text += (text.empty() ? "" : "; ") + names_of(analysis, cut.faults);
            if (!note.empty()) text += " (" + note + ")";
        }
        if (text.empty()) text = row.open.empty() ? "none" : "none found";
        const std::string head = padded(printable(row.property), width) + "  ";
        bool first = true;
        for (const std::string& line : wrapped(text, widest_line - std::min(width + 2, widest_line / 2)))
            out << (std::exchange(first, false) ? head : std::string(width + 2, ' ')) << line << '\n';
    }
}

void print_open(const FaultAnalysis& analysis, std::ostream& out) {
    for (const FaultAnalysis::Row& row : analysis.rows) {
        if (row.open.empty()) continue;
        out << fmt::format("\n{}: unknown for {} combination{}\n", printable(row.property), row.open.size(),
                           row.open.size() == 1 ? "" : "s");
        for (std::size_t k = 0; k < std::min(row.open.size(), most_listed_sets); ++k)
            out << fmt::format("    {}: {}\n", names_of(analysis, row.open[k].faults), printable(row.open[k].reason));
        if (row.open.size() > most_listed_sets) out << "    ...\n";
    }
}

void print_non_monotone(const FaultAnalysis& analysis, std::ostream& out) {
    for (const FaultAnalysis::Row& row : analysis.rows) {
        if (row.non_monotone.empty()) continue;
        out << fmt::format("\n{}: further faults can restore the property\n", printable(row.property));
        for (std::size_t k = 0; k < std::min(row.non_monotone.size(), most_listed_sets); ++k)
            out << fmt::format("    {} leads to a violation, {} does not\n",
                               names_of(analysis, row.non_monotone[k].violating),
                               names_of(analysis, row.non_monotone[k].holding));
        if (row.non_monotone.size() > most_listed_sets)
            out << fmt::format("    and {} further combinations\n", row.non_monotone.size() - most_listed_sets);
    }
}

/// Returns the properties that are violated if only the fault `fault` occurs.
std::vector<std::string> violated_by(const FaultAnalysis& analysis, std::size_t fault) {
    std::vector<std::string> names;
    for (const FaultAnalysis::Row& row : analysis.rows)
        if (std::ranges::find(row.minimal, FaultSet{fault}, &FaultAnalysis::Cut::faults) != row.minimal.end())
            names.push_back(row.property);
    return names;
}

/// Returns the properties that are violated by a minimal combination of the fault `fault` with other faults.
std::vector<std::string> violated_with_others(const FaultAnalysis& analysis, std::size_t fault) {
    std::vector<std::string> names;
    for (const FaultAnalysis::Row& row : analysis.rows)
        if (std::ranges::any_of(row.minimal, [&](const FaultAnalysis::Cut& cut) {
                return cut.faults.size() > 1 && std::ranges::find(cut.faults, fault) != cut.faults.end();
            }))
            names.push_back(row.property);
    return names;
}

/// True if, for every property, the verdicts without faults and on all combinations with the fault are known.
bool is_decided(const FaultAnalysis& analysis, std::size_t fault) {
    return std::ranges::none_of(analysis.rows, [&](const FaultAnalysis::Row& row) {
        return row.without_faults == Outcome::Unknown ||
               std::ranges::any_of(row.open, [&](const FaultAnalysis::Open& open) {
                   return std::ranges::find(open.faults, fault) != open.faults.end();
               });
    });
}

void print_effects(const FaultAnalysis& analysis, std::size_t index, std::ostream& out) {
    const FaultAnalysis::Fault& fault = analysis.faults[index];
    out << fmt::format("\n{}: {} behaves as {}\n", printable(fault.name), printable(fault.instance),
                       printable(fault.component));
    const FaultEffects effects = effects_of(analysis, index);
    for (const auto* const sentences : {&effects.on_properties, &effects.visible})
        for (const std::string& sentence : *sentences) {
            std::string prefix = "    ";
            for (const std::string& part : wrapped(sentence, widest_line - 8)) {
                out << prefix << part << '\n';
                prefix = "        ";
            }
        }
}

void print_run(const FaultAnalysis& analysis, const FaultAnalysis::Row& row, const FaultAnalysis::Cut& cut,
               std::ostream& out) {
    out << fmt::format("\n{}: violated with {}", printable(row.property), names_of(analysis, cut.faults));
    if (!cut.from_power_on.empty()) out << ", present from power-on: " << names_of(analysis, cut.from_power_on);
    out << '\n';
    if (!cut.result.trace) return void(out << "    " << printable(absence_of_trace(row, cut)) << '\n');
    print_trace(*cut.result.trace, out);
    const std::string_view end = end_of(cut.result.verdict);
    if (!cut.result.trace->loop_from && !end.empty()) out << "    " << end << '\n';
}

std::string quoted(const std::string& text) { return '"' + attribute_xml(text) + '"'; }

Json sets_json(const FaultAnalysis& analysis, const FaultSet& faults) {
    Json names = Json::array();
    for (const std::size_t fault : faults) names.push_back(analysis.faults[fault].name);
    return names;
}

Json sets_json(const FaultAnalysis& analysis, const std::vector<FaultSet>& sets) {
    Json list = Json::array();
    for (const FaultSet& faults : sets) list.push_back(sets_json(analysis, faults));
    return list;
}

Json truth_or_null(Outcome outcome) {
    return outcome == Outcome::Unknown ? Json(nullptr) : Json(outcome == Outcome::Holds);
}

Json seconds_or_null(const std::optional<std::int64_t>& time_ms) {
    return time_ms ? Json(static_cast<double>(*time_ms) / 1000) : Json(nullptr);
}

Json fault_json(const FaultAnalysis& analysis, std::size_t index, const Sources& sources) {
    const FaultAnalysis::Fault& fault = analysis.faults[index];
    Json made = {{"name", fault.name}, {"instance", fault.instance}, {"component", fault.component}};
    add_place(made, file_place(sources, fault.origin));
    made["violates"] = violated_by(analysis, index);
    made["newly_true"] = fault.visible.newly_true;
    made["never_true"] = fault.visible.never_true;
    const FaultAnalysis::Visible& visible = fault.visible;
    made["always_shown"] = visible.newly_true.empty() ? Json(nullptr) : truth_or_null(visible.always_shown);
    made["detected"] = truth_or_null(visible.detected);
    made["within"] = seconds_or_null(visible.within_ms);
    made["observer"] = nullptr;
    if (visible.observer)
        made["observer"] = {{"property", visible.observer->property},
                            {"declared", text_or_null(visible.observer->declared)},
                            {"in_every_run", truth_or_null(visible.observer->in_every_run)},
                            {"within", seconds_or_null(visible.observer->within_ms)}};
    made["observer_limit"] = text_or_null(visible.observer_limit);
    made["decided"] = fault.visible.decided;
    return made;
}

Json row_json(const FaultAnalysis& analysis, const FaultAnalysis::Row& row, const Sources& sources) {
    Json made = {{"name", row.property}, {"text", text_or_null(row.text)}};
    add_place(made, file_place(sources, row.origin));
    made["declared"] = row.declared;
    made["without_faults"] = word(row.without_faults);
    made["minimal"] = Json::array();
    for (const FaultAnalysis::Cut& cut : row.minimal)
        made["minimal"].push_back({{"faults", sets_json(analysis, cut.faults)},
                                   {"from_power_on", sets_json(analysis, cut.from_power_on)},
                                   {"unknown_subsets", sets_json(analysis, cut.unknown_subsets)},
                                   {"trace", cut.result.trace ? trace_json(*cut.result.trace) : Json(nullptr)}});
    made["unknown"] = Json::array();
    for (const FaultAnalysis::Open& open : row.open)
        made["unknown"].push_back(
            {{"faults", sets_json(analysis, open.faults)}, {"reason", text_or_null(open.reason)}});
    made["non_monotone"] = Json::array();
    for (const FaultAnalysis::NonMonotone& each : row.non_monotone)
        made["non_monotone"].push_back(
            {{"violating", sets_json(analysis, each.violating)}, {"holding", sets_json(analysis, each.holding)}});
    return made;
}

}  // namespace

std::string names_of(const FaultAnalysis& analysis, const FaultSet& faults) {
    std::string text;
    for (const std::size_t fault : faults) text += (text.empty() ? "" : " + ") + printable(analysis.faults[fault].name);
    return text.empty() ? "no fault" : text;
}

std::string unproved(const FaultAnalysis& analysis, const FaultAnalysis::Cut& cut) {
    if (cut.unknown_subsets.empty()) return "";
    return "minimality is unproved: " + names_of(analysis, cut.unknown_subsets) +
           (cut.unknown_subsets.size() == 1 ? " has" : " have") + " an unknown verdict";
}

std::string absence_of_trace(const FaultAnalysis::Row& row, const FaultAnalysis::Cut& cut) {
    if (is_about_existence(row.pattern)) return "no run reaches a state that satisfies the property";
    std::string text;
    for (const std::string& note : cut.result.verdict.notes) text += (text.empty() ? "" : "; ") + note;
    return text.empty() ? "no trace is given" : text;
}

namespace {

/// Returns text such as `in every run, at most 9 s after the fault`.
std::string after_fault(const std::optional<std::int64_t>& within_ms) {
    return within_ms ? "in every run, at most " + seconds_text(*within_ms) + " after the fault"
                     : "in every run with the fault";
}

std::string runs_text(const FaultAnalysis::Observer& observer) {
    return observer.in_every_run == Outcome::Holds ? after_fault(observer.within_ms) : "in some run with the fault";
}

/// Returns the end of the sentence that names the steps and outputs that become true only with the fault.
std::string detection_text(const FaultAnalysis::Visible& visible) {
    if (visible.detected == Outcome::Holds) return "; " + after_fault(visible.within_ms);
    std::string text;
    if (visible.always_shown == Outcome::Holds) text = "; in every run, if the fault is present from power-on";
    if (visible.detected == Outcome::Violated)
        text += text.empty() ? "; not in every run with the fault" : ", but not if it occurs later";
    return text;
}

}  // namespace

bool is_shown(const FaultAnalysis::Row& row) {
    return row.declared || row.without_faults != Outcome::Holds || !row.minimal.empty() || !row.open.empty();
}

FaultEffects effects_of(const FaultAnalysis& analysis, std::size_t index) {
    FaultEffects effects;
    const auto add = [](std::vector<std::string>& to, std::string_view head, const std::vector<std::string>& names,
                        std::string_view tail = "") {
        if (!names.empty()) to.push_back(std::string(head) + joined(names) + std::string(tail));
    };
    add(effects.on_properties, "leads to a violation of ", violated_by(analysis, index));
    add(effects.on_properties, "leads, together with other faults, to a violation of ",
        violated_with_others(analysis, index));
    if (effects.on_properties.empty())
        effects.on_properties.push_back(is_decided(analysis, index) ? "leads to no violation"
                                                                    : "no violation found, but verdicts are unknown");
    const FaultAnalysis::Visible& visible = analysis.faults[index].visible;
    if (!visible.decided) {
        effects.visible.push_back("visible effects: unknown");
        return effects;
    }
    add(effects.visible, "true in some state with this fault, but never without faults: ", visible.newly_true,
        detection_text(visible));
    add(effects.visible, "never true if this fault is present from power-on: ", visible.never_true);
    if (effects.visible.empty())
        effects.visible.push_back("with and without the fault, the same steps and outputs can become true");
    if (visible.observer)
        effects.visible.push_back(
            visible.observer->declared.empty()
                ? "proposed observer, violated " + runs_text(*visible.observer) + ": " + visible.observer->property
                : "declared observer, violated " + runs_text(*visible.observer) + ": " + visible.observer->declared);
    if (!visible.observer_limit.empty()) effects.visible.push_back(visible.observer_limit);
    return effects;
}

void print_faults(const FaultAnalysis& analysis, bool all_runs, std::ostream& out) {
    out << fmt::format("{}: {} faults, {} combinations of at most {}, {} checks\n{}\n", printable(analysis.model),
                       analysis.faults.size(), analysis.combinations, analysis.order, analysis.checks,
                       shared_settings({analysis.model, analysis.settings}, {}).shared);
    print_table(analysis, out);
    print_open(analysis, out);
    print_non_monotone(analysis, out);
    for (std::size_t fault = 0; fault < analysis.faults.size(); ++fault) print_effects(analysis, fault, out);
    for (const FaultAnalysis::Error& error : analysis.errors) {
        out << fmt::format("\nmodel error with {}: {} [{}]\n", names_of(analysis, error.faults),
                           printable(error.trace.message), error.trace.code);
        if (!error.trace.trace.steps.empty()) print_trace(error.trace.trace, out);
    }
    for (const FaultAnalysis::Row& row : analysis.rows)
        for (const FaultAnalysis::Cut& cut : row.minimal)
            if (all_runs || &cut == &row.minimal.front()) print_run(analysis, row, cut, out);
}

std::string faults_json(const FaultAnalysis& analysis, const Sources& sources) {
    Json object = {{"model", analysis.model},
                   {"engine", analysis.settings.engine},
                   {"mode", analysis.settings.mode},
                   {"grain", analysis.settings.grain},
                   {"time_unit", seconds_text(analysis.settings.time_unit_ms)},
                   {"order", analysis.order},
                   {"combinations", analysis.combinations},
                   {"checks", analysis.checks}};
    object["faults"] = Json::array();
    for (std::size_t fault = 0; fault < analysis.faults.size(); ++fault)
        object["faults"].push_back(fault_json(analysis, fault, sources));
    object["properties"] = Json::array();
    for (const FaultAnalysis::Row& row : analysis.rows)
        if (is_shown(row)) object["properties"].push_back(row_json(analysis, row, sources));
    object["errors"] = Json::array();
    for (const FaultAnalysis::Error& error : analysis.errors)
        object["errors"].push_back({{"faults", sets_json(analysis, error.faults)},
                                    {"code", error.trace.code},
                                    {"message", error.trace.message},
                                    {"trace", trace_json(error.trace.trace)}});
    return json_text(object);
}

namespace {

/// Returns the formula of a property's gate in the fault tree: the disjunction of its minimal combinations of faults.
/// `events` contains the names of the faults.
std::string formula_of(const FaultAnalysis::Row& row, std::span<const std::string> events) {
    if (row.minimal.empty()) return "      <constant value=\"false\"/>\n";
    const bool several = row.minimal.size() > 1;
    std::string xml = several ? "      <or>\n" : "";
    for (const FaultAnalysis::Cut& cut : row.minimal) {
        std::string text;
        for (const std::size_t fault : cut.faults) text += "<basic-event name=" + quoted(events[fault]) + "/>";
        xml += (several ? "        " : "      ") + (cut.faults.size() > 1 ? "<and>" + text + "</and>" : text) + '\n';
    }
    return xml + (several ? "      </or>\n" : "");
}

std::string comment(const std::string& text) {
    std::string xml = "    <!-- ";
    comment_xml(text, xml);
    return xml + " -->\n";
}

std::string label(const std::string& text) {
    std::string xml = "<label>";
    escape_xml(text, xml);
    return xml + "</label>";
}

/// Returns XML comments with those results for a property that its gate in the fault tree cannot express: unknown
/// verdicts, unproved minimality, and non-monotone combinations.
std::string gate_comments(const FaultAnalysis& analysis, const FaultAnalysis::Row& row) {
    std::string xml;
    if (!row.open.empty()) {
        std::vector<FaultSet> open;
        for (const FaultAnalysis::Open& each : row.open) open.push_back(each.faults);
        xml += comment("incomplete: " + row.property + " is unknown for " + names_of(analysis, open));
    }
    for (const FaultAnalysis::Cut& cut : row.minimal)
        if (const std::string note = unproved(analysis, cut); !note.empty())
            xml += comment(names_of(analysis, cut.faults) + ": " + note);
    for (const FaultAnalysis::NonMonotone& each : row.non_monotone)
        xml += comment("not monotone: " + names_of(analysis, each.violating) + " leads to a violation of " +
                       row.property + ", " + names_of(analysis, each.holding) + " does not");
    return xml;
}

}  // namespace

std::string open_psa_of(const FaultAnalysis& analysis) {
    std::vector<const FaultAnalysis::Row*> rows;
    std::vector<std::string> names{analysis.model};
    std::string omitted;
    for (const FaultAnalysis::Row& row : analysis.rows) {
        if (!is_shown(row)) continue;
        if (row.without_faults == Outcome::Holds) rows.push_back(&row);
        else
            omitted += comment("omitted: " + row.property + " is " + std::string(word(row.without_faults)) +
                               " without faults");
    }
    for (const FaultAnalysis::Row* row : rows) names.push_back(row->property);
    for (const FaultAnalysis::Fault& fault : analysis.faults) names.push_back(fault.name);
    for (std::string& name : names)
        if (name.starts_with('_')) name.insert(0, "n");
    const std::vector<std::string> legal = legal_names(Target::StructuredText, names);
    const std::span<const std::string> events = std::span(legal).subspan(1 + rows.size());
    std::string xml =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<opsa-mef>\n  <define-fault-tree name=" + quoted(legal[0]) +
        ">\n    " + label(analysis.model) + '\n' +
        comment(fmt::format("only combinations of at most {} faults", analysis.order)) + omitted;
    for (std::size_t k = 0; k < rows.size(); ++k)
        xml += gate_comments(analysis, *rows[k]) + "    <define-gate name=" + quoted(legal[1 + k]) + ">\n      " +
               label(rows[k]->property) + '\n' + formula_of(*rows[k], events) + "    </define-gate>\n";
    xml += "  </define-fault-tree>\n  <model-data>\n";
    for (std::size_t k = 0; k < analysis.faults.size(); ++k) {
        const FaultAnalysis::Fault& fault = analysis.faults[k];
        xml += "    <define-basic-event name=" + quoted(events[k]) + ">" +
               label(fault.name + ": " + fault.instance + " behaves as " + fault.component) + "</define-basic-event>\n";
    }
    return xml + "  </model-data>\n</opsa-mef>\n";
}

}  // namespace grafverif
