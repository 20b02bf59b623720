// SPDX-License-Identifier: MIT
// Reads the actions of an AGRAFE document, and assigns them to the steps to which they are linked.
#include <string>

#include "read/agrafe/reader.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using Kind = AgrafeEntity::Kind;

bool is_action(Kind kind) { return kind == Kind::Action; }
bool is_forceable(Kind kind) { return kind == Kind::Partial || kind == Kind::Expansion; }

/// Returns the name of the variable that an action assigns. The name is invalid after an error.
tree::Name target(AgrafeReader& reader, pugi::xml_node action) {
    const pugi::xml_node variable = child(action, "variable");
    if (!variable) {
        reader.diagnostics().add(messages::missing_part(reader.xml.where(action), "this action", "`variable`"));
        return {};
    }
    const auto found = reader.reference(variable, "variableDeclaration", "variable declaration", is_declaration);
    if (!found) return {};
    if (value(reader.index[*found].node, "variableDeclarationType") == "step") {
        reader.diagnostics().add(messages::bad_value(
            reader.xml.where(variable, "variableDeclaration"), "variable of this action",
            value(reader.index[*found].node, "name"), "an output or an internal variable, not a step variable"));
        return {};
    }
    return reader.draft.name(reader.index[*found].name, reader.xml.where(variable, "variableDeclaration"));
}

/// True if an action has a condition although the type of the action does not permit conditions. Reports this
/// condition, because ignoring it silently would change the meaning.
bool has_stray_condition(AgrafeReader& reader, pugi::xml_node action, std::string_view hint) {
    const pugi::xml_node term = child(action, "term");
    if (!term) return false;
    reader.draft.refuse(reader.xml.where(term), "the condition of an action whose type does not permit a condition",
                        hint);
    return true;
}

std::optional<tree::Action> continuous(AgrafeReader& reader, pugi::xml_node action) {
    tree::ContinuousAction made;
    made.where = reader.xml.where(action);
    made.output = target(reader, action);
    if (!made.output.valid()) return {};
    const AgrafeTime time = agrafe_time(reader, action);
    const std::string type = value(action, "continuousActionType");
    const bool conditional = type == "assignationCondition" || time.kind == AgrafeTime::Kind::Dependent;
    const pugi::xml_node term = child(action, "term");
    if (conditional && !term) {
        reader.diagnostics().add(messages::missing_part(made.where, "this action", "`term` for its condition"));
        return {};
    }
    if (conditional) made.condition = agrafe_term(reader, term);
    else has_stray_condition(reader, action, "write `continuousActionType=\"assignationCondition\"`, or remove `term`");
    const auto length = [&] { return reader.draft.duration(time.rise_ms, reader.xml.where(action, "delayTime")); };
    switch (time.kind) {
    case AgrafeTime::Kind::None: break;
    case AgrafeTime::Kind::Dependent: made.condition = timed(reader, time, made.condition, made.where); break;
    case AgrafeTime::Kind::Delayed:
        if (time.rise_ms > 0) made.delay = length();
        break;
    case AgrafeTime::Kind::Limited:
        if (time.rise_ms > 0) made.limit = length();
        break;
    }
    if (conditional && !made.condition.valid()) return {};
    return made;
}

std::optional<tree::Action> stored(AgrafeReader& reader, pugi::xml_node action) {
    tree::StoredAction made;
    made.where = reader.xml.where(action);
    made.assignment.where = made.where;
    made.assignment.target = target(reader, action);
    const pugi::xml_node assigned = child(action, "value"), term = child(action, "term");
    if (!assigned) reader.diagnostics().add(messages::missing_part(made.where, "this stored action", "`value`"));
    else made.assignment.value = agrafe_term(reader, assigned);
    const std::string type = value(action, "storedActionType");
    const std::string_view hint = "write `storedActionType=\"event\"`, or remove `term`";
    if (type.empty() || type == "activation") {
        made.when = tree::StoredWhen::Activation;
        has_stray_condition(reader, action, hint);
    } else if (type == "deactivation") {
        made.when = tree::StoredWhen::Deactivation;
        has_stray_condition(reader, action, hint);
    } else if (type == "event") {
        made.when = tree::StoredWhen::Event;
        if (term) made.event = agrafe_term(reader, term);
        else reader.diagnostics().add(messages::missing_part(made.where, "this stored action", "`term` for its event"));
        if (!made.event.valid()) return {};
    } else {
        reader.diagnostics().add(messages::bad_value(reader.xml.where(action, "storedActionType"),
                                                     "type of this action", type,
                                                     "`activation`, `deactivation` or `event`"));
        return {};
    }
    if (!made.assignment.target.valid() || !made.assignment.value.valid()) return {};
    return made;
}

std::optional<tree::Action> forcing(AgrafeReader& reader, pugi::xml_node action) {
    const auto forced = reader.reference(action, "partialGrafcet", "partial grafcet", is_forceable);
    if (!forced) return {};
    tree::ForcingOrder made;
    made.where = reader.xml.where(action);
    made.chart = reader.draft.name(reader.index[*forced].name, reader.xml.where(action, "partialGrafcet"));
    const std::string type = value(action, "forcingOrderType");
    if (type.empty() || type == "currentSituation") made.to = tree::ForcedTo::Current;
    else if (type == "emptySituation") made.to = tree::ForcedTo::Empty;
    else if (type == "initialSituation") made.to = tree::ForcedTo::Initial;
    else if (type == "explicitSituation") made.to = tree::ForcedTo::Steps;
    else
        reader.diagnostics().add(
            messages::bad_value(reader.xml.where(action, "forcingOrderType"), "type of this forcing order", type,
                                "`currentSituation`, `emptySituation`, `initialSituation` or `explicitSituation`"));
    if (made.to != tree::ForcedTo::Steps) return made;
    for (const std::size_t step : reader.references(action, "forcedSteps", "step", is_step)) {
        if (reader.index[step].partial != *forced)
            reader.diagnostics().add(
                messages::misplaced_link(reader.xml.where(action, "forcedSteps"),
                                         "this forcing order lists a step that is not in the forced partial grafcet",
                                         "list only steps of the forced partial grafcet"));
        made.steps.push_back(reader.draft.name(reader.index[step].name, reader.xml.where(action, "forcedSteps")));
    }
    if (made.steps.empty()) made.to = tree::ForcedTo::Empty;
    return made;
}

std::optional<tree::Action> action_of(AgrafeReader& reader, pugi::xml_node action) {
    const std::string_view type = local_name(attribute(action, "type").value());
    if (type == "ContinuousAction") return continuous(reader, action);
    if (type == "StoredAction") return stored(reader, action);
    if (type == "ForcingOrder") return forcing(reader, action);
    if (type.empty())
        reader.diagnostics().add(messages::missing_part(reader.xml.where(action), "this action", "`xsi:type`"));
    else
        reader.diagnostics().add(messages::bad_value(reader.xml.where(action, "type"), "type of this action", type,
                                                     "`ContinuousAction`, `StoredAction` or `ForcingOrder`"));
    return {};
}

}  // namespace

std::vector<std::vector<tree::Action>> agrafe_actions(AgrafeReader& reader) {
    std::vector<std::vector<tree::Action>> actions(reader.index.all().size());
    std::vector<bool> linked(actions.size());
    for (std::size_t i = 0; i < actions.size(); ++i) {
        if (!is_partial(reader.index[i].kind)) continue;
        const pugi::xml_node grafcet = reader.index[i].node;
        for (const pugi::xml_node& link : grafcet.children()) {
            if (!is(link, "actionLinks")) continue;
            if (!attribute(link, "actionType") || !attribute(link, "step")) {
                reader.diagnostics().add(messages::without_effect(reader.xml.where(link), "an incomplete action link",
                                                                  "link it to a step and an action, or remove it"));
                continue;
            }
            const auto step = reader.reference(link, "step", "step", is_step);
            const auto action = reader.reference(link, "actionType", "action", is_action);
            if (!step || !action) continue;
            linked[*action] = true;
            if (auto made = action_of(reader, reader.index[*action].node)) actions[*step].push_back(std::move(*made));
        }
    }
    for (std::size_t i = 0; i < actions.size(); ++i)
        if (reader.index[i].kind == Kind::Action && !linked[i])
            reader.diagnostics().add(messages::without_effect(
                reader.xml.where(reader.index[i].node), "an action without a step", "link it to a step, or remove it"));
    return actions;
}

}  // namespace grafverif
