// SPDX-License-Identifier: MIT
// Converts models and reports to text.
#include <algorithm>
#include <sstream>

#include "compose/observe.hpp"
#include "draw/svg.hpp"
#include "emit/btor2/btor2.hpp"
#include "emit/c/c.hpp"
#include "emit/controller/code.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "emit/pins/pins.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "emit/wide.hpp"
#include "pipeline/chart_text.hpp"
#include "pipeline/models.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

template <class Write>
std::string written(Write write) {
    std::ostringstream out;
    write(out);
    return std::move(out).str();
}

/// Warns about each property that the system or the format `target` cannot express.
void report_omitted(const TransitionSystem& system, const std::vector<NotInCircuit>& left_out, std::string_view target,
                    Diagnostics& diagnostics) {
    const auto report = [&](const Property& property, const std::string& reason) {
        diagnostics.add(messages::not_expressible(property.origin, property.name, target, reason));
    };
    for (const NotInCircuit& each : left_out) report(system.properties[each.about], each.reason);
    for (const TransitionSystem::Omitted& omitted : system.omitted) report(omitted.property, omitted.reason);
}

}  // namespace

UppaalProject uppaal_project(const Network& network, Diagnostics& diagnostics) {
    const Network lowered = uppaal::lower(observed(network, watched(network)));
    if (!fits(lowered, "UPPAAL", diagnostics)) return {};
    for (const uppaal::Inexpressible& left_out : uppaal::inexpressible(lowered)) {
        const Property& property = lowered.properties[left_out.property];
        diagnostics.add(messages::not_expressible(property.origin, property.name, "UPPAAL", left_out.reason));
    }
    return {written([&](std::ostream& out) { uppaal::emit(lowered, out); }),
            written([&](std::ostream& out) { uppaal::emit_queries(lowered, out); })};
}

std::string pins_model(const Network& network) {
    return written([&](std::ostream& out) { pins::emit(observed(network, watched(network)), out); });
}

UppaalQueries uppaal_queries(const Network& network, Diagnostics& diagnostics) {
    const Network lowered = uppaal::lower(observed(network, watched(network)));
    if (!fits(lowered, "UPPAAL", diagnostics)) return {};
    const std::vector<uppaal::Inexpressible> left_out = uppaal::inexpressible(lowered);
    UppaalQueries result;
    for (const uppaal::Formula& formula : uppaal::formulas(lowered)) {
        const auto why = std::ranges::find(left_out, formula.property, &uppaal::Inexpressible::property);
        result.questions.push_back(
            {formula.property, formula.name, formula.text, why == left_out.end() ? "" : why->reason});
    }
    result.project = written([&](std::ostream& out) { uppaal::emit(lowered, out); });
    return result;
}

Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options) {
    return drawing_of(model, chart, options, Sources{});
}

std::string svg_of(const Drawing& drawing) {
    return written([&](std::ostream& out) { draw::print_svg(drawing, out); });
}

AigerModel aiger_model(const TransitionSystem& system, aiger::Form form, Diagnostics& diagnostics) {
    FlatSystem flat = flattened(system);
    const auto [circuit, left_out] = circuit_of(system, flat);
    report_omitted(system, left_out, "AIGER", diagnostics);
    const std::vector<aiger::AigerProperty> questions = aiger::queries_of(system, flat, circuit);
    aiger::AigerText model = aiger::written(circuit, questions, form, aiger::Extent::Whole);
    std::string map = aiger::map_of(system, flat, circuit, model);
    return {std::move(model.text), std::move(map)};
}

std::string btor2_model(const TransitionSystem& system, Diagnostics& diagnostics) {
    btor2::Btor2Text model = btor2::written(system);
    report_omitted(system, model.omitted, "BTOR2", diagnostics);
    return std::move(model.text);
}

std::string nusmv_model(const TransitionSystem& system, Diagnostics& diagnostics) {
    if (!fits(system, "NuSMV", diagnostics)) return {};
    const TransitionSystem narrow = nusmv::narrow(system);
    report_omitted(narrow, {}, "NuSMV", diagnostics);
    return written([&](std::ostream& out) { nusmv::emit(narrow, out); });
}

std::optional<std::string> structured_text_of(const Equations& equations, const structured_text::Options& options,
                                              Diagnostics& diagnostics) {
    if (!structured_text::expressible(equations, diagnostics)) return {};
    return written([&](std::ostream& out) { structured_text::emit(equations, options, out); });
}

std::optional<std::string> structured_text_of(const Equations& equations, ExecutionMode mode, Diagnostics& diagnostics,
                                              bool plcopen_xml, std::uint32_t max_evolutions) {
    const auto form = plcopen_xml ? structured_text::Form::PlcopenXml : structured_text::Form::Text;
    return structured_text_of(equations, {mode, max_evolutions, form}, diagnostics);
}

std::optional<CCode> c_code_of(const Equations& equations, ExecutionMode mode, std::uint32_t max_evolutions,
                               std::string_view header_name, Diagnostics& diagnostics) {
    if (!controller::expressible(equations, messages::not_in_c, diagnostics)) return {};
    const controller::Code code = controller::code_of(equations, {mode, max_evolutions}, Target::C);
    return CCode{c::header_of(code), c::source_of(code, header_name)};
}

std::string structured_text_test(const TestSequence& test, structured_text::Form form) {
    return written([&](std::ostream& out) { structured_text::emit_test(test, form, out); });
}

}  // namespace grafverif
