// SPDX-License-Identifier: MIT
// Reads the chart of a PLCopen document: steps, transitions, and the lines between them.
#include "read/plcopen/network.hpp"

#include <algorithm>
#include <charconv>
#include <unordered_set>

#include "support/messages.hpp"

namespace grafverif {

namespace {

bool is_step(pugi::xml_node node) { return is(node, "step") || is(node, "macroStep"); }

// -- connections ------------------------------------------------------------------------------------------------------

/// Returns the steps upstream of a transition, or the transitions upstream of a step; follows lines through divergences
/// and convergences. `wanted` returns true for an element at which a path may end. Reports each path that ends at
/// another element.
std::vector<pugi::xml_node> upstream(PlcopenReader& reader, const PlcopenNetwork& network, pugi::xml_node start,
                                     bool (*wanted)(pugi::xml_node), std::string_view hint) {
    std::vector<pugi::xml_node> found, work = {start};
    std::unordered_set<std::size_t> seen = {start.hash_value()};
    // True if a convergence precedes the transition. CODESYS writes a convergence even if only one branch does not end
    // in a jump.
    bool joined = false;
    for (std::size_t i = 0; i < work.size(); ++i) {
        for (const pugi::xml_node& source : sources_of(reader, network, work[i])) {
            const bool over = is(source, "jumpStep");  // CODESYS also writes lines from jump steps
            if (over || !seen.insert(source.hash_value()).second) continue;
            const std::string_view kind = local_name(source.name());
            const bool on_the_way = is(start, "transition")
                                        ? kind == "selectionDivergence" || kind == "simultaneousConvergence"
                                        : kind == "simultaneousDivergence" || kind == "selectionConvergence";
            const bool joins = reader.is_codesys_program() && is(start, "transition") && kind == "selectionConvergence";
            joined = joined || joins;
            if (on_the_way || joins || kind == "connector" || kind == "continuation") work.push_back(source);
            else if (wanted(source)) found.push_back(source);
            else
                reader.diagnostics().add(messages::misplaced_link(
                    reader.xml.where(start),
                    "a `" + std::string(kind) + "` leads to this `" + std::string(local_name(start.name())) + '`',
                    hint));
        }
    }
    if (joined && found.size() > 1)
        reader.diagnostics().add(
            messages::misplaced_link(reader.xml.where(start), "several branches join before this `transition`", hint));
    return found;
}

bool is_transition(pugi::xml_node node) { return is(node, "transition"); }

struct Step {
    pugi::xml_node node = {};
    st::Name name = {};
};

// -- actions of a step ------------------------------------------------------------------------------------------------

st::Association association(PlcopenReader& reader, pugi::xml_node action) {
    st::Association made;
    made.where = reader.xml.where(action);
    made.unread = attribute(action, "indicator") || child(action, "indicator");
    if (reader.is_codesys_program() && value(action, "indicator").empty())  // CODESYS writes `indicator=""`
        made.unread = bool(child(action, "indicator"));
    // The default qualifier is N.
    if (attribute(action, "qualifier")) made.qualifier = st::capitals(value(action, "qualifier"));
    if (const std::string duration = value(action, "duration"); !duration.empty())
        made.time = reader.expression(reader.xml.text(action, "duration"));
    if (const pugi::xml_node reference = child(action, "reference")) {
        made.action = reader.name(value(reference, "name"), reader.xml.where(reference, "name"));
        if (reader.is_codesys_program()) made.path = reader.expression(reader.xml.text(reference, "name"));
        return made;
    }
    const pugi::xml_node text = child(child(action, "inline"), "ST");
    if (text) made.body = reader.statements(reader.xml.text(text));
    else
        reader.refuse(made.where, "an action that is neither a reference nor Structured Text",
                      "write it in Structured Text");
    return made;
}

/// Splits a qualifier that includes its time, such as `D T#2s`. CODESYS permits this form.
void split_qualifier(PlcopenReader& reader, st::Association& association, pugi::xml_node action) {
    const std::size_t blank = association.qualifier.find(' ');
    if (blank == std::string::npos) return;
    st::Text text = reader.xml.text(action, "qualifier");
    text.front().where.begin += static_cast<std::uint32_t>(blank);
    if (!association.time.valid()) association.time = reader.expression(text);
    association.qualifier.resize(blank);
}

/// Reads the names of the entry, active and exit action of a step in CODESYS.
void codesys_actions(PlcopenReader& reader, pugi::xml_node node, st::Step& step) {
    struct Known {
        std::string_view guid = {}, qualifier = {};
    };
    constexpr Known known[] = {{"a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", "P1"},
                               {"700a583f-b4d4-43e4-8c14-629c7cd3bec8", "N"},
                               {"a2621e18-7de3-4ea6-ae6d-89e9e0b7befd", "P0"}};
    for (const pugi::xml_node& data : children(child(node, "addData"), "data")) {
        const pugi::xml_node attributes = child(data, "attributes");
        for (const Known& one : known) {
            for (const pugi::xml_node& entry : children(attributes, "attribute")) {
                if (value(entry, "guid") != one.guid) continue;
                st::Association made;
                made.where = reader.xml.where(entry);
                made.qualifier = one.qualifier;
                const auto path = reader.expression(reader.xml.text(entry));
                if (!path.valid()) continue;
                if (reader.of_program && !reader.is_codesys_program()) {
                    reader.refuse(reader.xml.where(entry), "an entry, active or exit action outside of CODESYS",
                                  "use an action block with the qualifier P1, N or P0");
                    continue;
                }
                if (reader.of_program) {
                    (made.qualifier == "P1" ? step.entry : made.qualifier == "N" ? step.active : step.exit) = path;
                    continue;
                }
                const st::Expr& written = reader.file.exprs[path];
                if (written.op == st::Op::Name) {
                    made.action = {written.word, written.where};
                    step.actions.push_back(std::move(made));
                } else {
                    reader.refuse(written.where, "the action `" + reader.xml.content(entry) + "` of another block",
                                  "move it into the block of the chart");
                }
            }
        }
    }
}

/// Reports a negated step or action block, because PLCopen XML does not specify the meaning of this negation.
void refuse_negation(PlcopenReader& reader, pugi::xml_node element) {
    if (reader.flag(element, "negated"))
        reader.refuse(reader.xml.where(element, "negated"),
                      "a negated `" + std::string(local_name(element.name())) + '`',
                      "remove the attribute `negated`, and negate conditions instead");
}

void read_actions(PlcopenReader& reader, const PlcopenNetwork& network, const std::vector<Step>& steps,
                  st::Network& made) {
    std::unordered_map<std::size_t, std::size_t> index;
    for (std::size_t i = 0; i < steps.size(); ++i) index.emplace(steps[i].node.hash_value(), i);
    for (const pugi::xml_node& element : network.elements) {
        if (!is(element, "actionBlock")) continue;
        refuse_negation(reader, element);
        for (const pugi::xml_node& source : sources_of(reader, network, element)) {
            const auto step = index.find(source.hash_value());
            if (step == index.end()) {
                reader.diagnostics().add(messages::misplaced_link(
                    reader.xml.where(element), "this action block is not connected to a step", "connect it to a step"));
                continue;
            }
            for (const pugi::xml_node& action : children(element, "action")) {
                st::Association one = association(reader, action);
                split_qualifier(reader, one, action);
                made.steps[step->second].actions.push_back(std::move(one));
            }
        }
    }
    for (std::size_t i = 0; i < steps.size(); ++i) codesys_actions(reader, steps[i].node, made.steps[i]);
}

/// Returns the implicit variables that control the chart (such as SFCInit), as specified in the settings of the
/// enclosing element.
st::ChartFlags flags_of(PlcopenReader& reader, pugi::xml_node chart) {
    st::ChartFlags flags;
    const pugi::xml_node owner = chart.parent().parent();  // the `pou` or `action` that contains `body`
    for (const pugi::xml_node& data : children(child(owner, "addData"), "data")) {
        const pugi::xml_node settings = child(data, "SFCSettings");
        if (!settings || reader.xml.content(child(settings, "UseDefaults")) == "true") continue;
        flags.stated = true;
        for (const pugi::xml_node& flag : child(settings, "Flags").children()) {
            if (flag.type() != pugi::node_element || !reader.flag(flag, "Use")) continue;
            const std::string_view name = local_name(flag.name());
            if (name == "Init") flags.init = true;
            else if (name == "Reset") flags.reset = true;
            else if (name == "Pause") flags.pause = true;
            else flags.others = "SFC" + std::string(name);
        }
    }
    return flags;
}

/// Returns the elements with the given name, from left to right, which is the default order of priority.
std::vector<pugi::xml_node> from_left(const PlcopenNetwork& network, std::string_view name) {
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node& element : network.elements)
        if (is(element, name)) found.push_back(element);
    std::ranges::stable_sort(found, {},
                             [](pugi::xml_node node) { return attribute(child(node, "position"), "x").as_double(); });
    return found;
}

std::string documentation(PlcopenReader& reader, pugi::xml_node node) {
    const pugi::xml_node text = child(node, "documentation");
    return text ? reader.xml.content(text) : std::string();
}

}  // namespace

// -- elements ---------------------------------------------------------------------------------------------------------

pugi::xml_node PlcopenNetwork::find(const std::string& id) const {
    const auto found = by_id.find(id);
    return found == by_id.end() ? pugi::xml_node() : found->second;
}

PlcopenNetwork network_of(PlcopenReader& reader, pugi::xml_node body) {
    PlcopenNetwork network{body, {}, {}};
    for (const pugi::xml_node& element : body.children()) {
        if (element.type() != pugi::node_element || !attribute(element, "localId")) continue;
        network.elements.push_back(element);
        const auto [first, fresh] = network.by_id.emplace(value(element, "localId"), element);
        if (!fresh)
            reader.diagnostics().add(messages::duplicate_name(reader.xml.where(element, "localId"), "element",
                                                              value(element, "localId"),
                                                              reader.xml.where(first->second, "localId")));
    }
    return network;
}

bool is_connected(pugi::xml_node point) {
    return std::ranges::any_of(children(point, "connectionPointIn"),
                               [](pugi::xml_node in) { return bool(child(in, "connection")); });
}

std::vector<PlcopenLine> lines_of(PlcopenReader& reader, const PlcopenNetwork& network, pugi::xml_node point) {
    std::vector<PlcopenLine> lines;
    if (is(point, "continuation")) {  // the line begins at the connector with the same name
        for (const pugi::xml_node& element : network.elements)
            if (is(element, "connector") && value(element, "name") == value(point, "name"))
                lines.push_back({element, {}});
        return lines;
    }
    for (const pugi::xml_node& in : children(point, "connectionPointIn")) {
        for (const pugi::xml_node& connection : children(in, "connection")) {
            const pugi::xml_node source = network.find(value(connection, "refLocalId"));
            if (source) lines.push_back({source, value(connection, "formalParameter")});
            else
                reader.diagnostics().add(messages::dangling_reference(reader.xml.where(connection, "refLocalId"),
                                                                      value(connection, "refLocalId"), "element"));
        }
    }
    return lines;
}

std::vector<pugi::xml_node> sources_of(PlcopenReader& reader, const PlcopenNetwork& network, pugi::xml_node point) {
    std::vector<pugi::xml_node> sources;
    for (const PlcopenLine& line : lines_of(reader, network, point)) sources.push_back(line.source);
    return sources;
}

// -- the network ------------------------------------------------------------------------------------------------------

namespace {

st::Transition transition_of(PlcopenReader& reader, const st::Unit& unit, const PlcopenNetwork& network,
                             const std::vector<Step>& steps, pugi::xml_node element) {
    st::Transition made;
    made.where = reader.xml.where(element);
    made.comment = documentation(reader, element);
    const std::string priority = value(element, "priority");
    if (std::from_chars(priority.data(), priority.data() + priority.size(), made.priority).ec != std::errc() &&
        !priority.empty())
        reader.diagnostics().add(
            messages::bad_value(reader.xml.where(element, "priority"), "`priority`", priority, "a whole number"));
    for (const pugi::xml_node& from : upstream(reader, network, element, is_step, "put a step before the transition"))
        for (const Step& step : steps)
            if (step.node == from) made.from.push_back({step.name.word, made.where});
    made.condition = condition_of(reader, unit, network, element);
    return made;
}

}  // namespace

std::vector<st::Network> read_network(PlcopenReader& reader, const st::Unit& unit, pugi::xml_node body) {
    struct Open {
        pugi::xml_node body = {};
        st::Name macro_step = {};
    };
    std::vector<Open> open = {{body, {}}};
    std::vector<st::Network> networks;
    for (std::size_t at = 0; at < open.size(); ++at) {
        const PlcopenNetwork network = network_of(reader, open[at].body);
        st::Network made;
        made.macro_step = open[at].macro_step;
        made.where = reader.xml.where(open[at].body);
        if (reader.is_codesys_program()) made.flags = flags_of(reader, open[at].body);
        std::vector<Step> steps;
        for (const pugi::xml_node& element : network.elements) {
            if (!is_step(element)) continue;
            const st::Name name = reader.name(value(element, "name"), reader.xml.where(element, "name"));
            if (value(element, "name").empty())
                reader.diagnostics().add(messages::missing_part(reader.xml.where(element), "this step", "`name`"));
            steps.push_back({element, name});
            st::Step step;
            step.name = name;
            step.initial = reader.flag(element, "initialStep");
            refuse_negation(reader, element);
            step.comment = documentation(reader, element);
            step.where = reader.xml.where(element);
            made.steps.push_back(std::move(step));
            if (!is(element, "macroStep")) continue;
            if (const pugi::xml_node inner = child(child(element, "body"), "SFC")) open.push_back({inner, name});
            else
                reader.diagnostics().add(messages::missing_part(reader.xml.where(element), "this macro-step",
                                                                "`body` with a Sequential Function Chart"));
        }
        std::unordered_map<std::size_t, std::size_t> transitions;
        for (const pugi::xml_node& element : from_left(network, "transition")) {
            transitions.emplace(element.hash_value(), made.transitions.size());
            made.transitions.push_back(transition_of(reader, unit, network, steps, element));
        }
        for (const pugi::xml_node& element : network.elements) {
            const bool jump = is(element, "jumpStep");
            if (!jump && !is_step(element)) continue;
            const std::string_view named = jump ? "targetName" : "name";
            const st::Name target = reader.name(value(element, named), reader.xml.where(element, named));
            const bool known =
                std::ranges::any_of(steps, [&](const Step& step) { return step.name.word == target.word; });
            if (!known) {
                reader.diagnostics().add(
                    messages::dangling_reference(reader.xml.where(element, named), value(element, named), "step"));
                continue;
            }
            for (const pugi::xml_node& from :
                 upstream(reader, network, element, is_transition, "put a transition before the step"))
                made.transitions[transitions.at(from.hash_value())].to.push_back(target);
        }
        read_actions(reader, network, steps, made);
        networks.push_back(std::move(made));
    }
    return networks;
}

}  // namespace grafverif
