// SPDX-License-Identifier: MIT
// Manages the background checks of a session. A save or a command starts the checks. The editor displays the results as
// code lenses at loops and properties.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "grafverif/grafverif.hpp"
#include "lsp/session.hpp"
#include "rpc/uri.hpp"

namespace grafverif::lsp {

void Session::request_client(const std::string& id, const std::string& method, const Json& params) {
    send({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}});
}

// -- checks in the background -----------------------------------------------------------------------------------------

/// Checks every open file, and then every other file that includes an open file.
void Session::saved() {
    dirty_ = true;
    settle();
    for (const bool open : {true, false})
        for (const auto& root : board_.roots())
            if ((workspace_.find(workspace_.uri_of(root->path)) != nullptr) == open) prove(root->path, "");
}

void Session::prove(const std::string& path, const std::string& only) {
    const auto root = board_.root(path);
    if (root == nullptr || !root->reading.model) return;
    prover_->submit({root, Task::What::Proofs, only});
}

void Session::found(Found outcome) {
    if (!board_.is_current(*outcome.root)) return;
    dirty_ = true;  // stays true until the diagnostics are published
    board_.add(*outcome.root, outcome.source, std::move(outcome.diagnostics));
    Verdicts& known = verdicts_[outcome.root->path];
    if (known.number != outcome.root->number) known = {outcome.root->number, {}};
    const bool news = !outcome.verdicts.empty();
    for (auto& [key, shown] : outcome.verdicts) known.by_key[key] = std::move(shown);
    settle();
    if (news && can_.refreshes_lenses) request_client("grafverif/lenses", "workspace/codeLens/refresh", nullptr);
}

void Session::progress(const std::string& words) {
    if (!can_.shows_progress || state_ != State::Running) return;
    const auto report_progress = [&](const Json& value) {
        send({{"jsonrpc", "2.0"}, {"method", "$/progress"}, {"params", {{"token", token_}, {"value", value}}}});
    };
    if (words.empty()) {
        if (progress_state_ == ProgressState::Going) report_progress({{"kind", "end"}});
        progress_state_ = ProgressState::Nothing;
    } else if (progress_state_ == ProgressState::Nothing) {
        progress_state_ = ProgressState::Requested;
        ++token_;
        request_client("grafverif/progress/" + std::to_string(token_), "window/workDoneProgress/create",
                       {{"token", token_}});
    } else if (progress_state_ == ProgressState::Going) {
        report_progress({{"kind", "report"}, {"message", words}});
    }
}

void Session::progress_is_requested() {
    if (progress_state_ != ProgressState::Requested) return;
    progress_state_ = ProgressState::Going;
    send({{"jsonrpc", "2.0"},
          {"method", "$/progress"},
          {"params",
           {{"token", token_}, {"value", {{"kind", "begin"}, {"title", "grafverif check"}, {"cancellable", true}}}}}});
}

// -- results ----------------------------------------------------------------------------------------------------------

namespace {

/// Returns the key of the verdict on a property.
std::string key_of(const std::string& loop, const std::string& property) { return "loop " + loop + "/q " + property; }

}  // namespace

/// Returns the verdict on the property `key` if the verdict belongs to the current texts; otherwise null.
const VerdictDetails* Session::shown(const std::string& path, const std::string& key) const {
    const auto root = board_.root(path);
    const auto known = verdicts_.find(path);
    if (root == nullptr || known == verdicts_.end() || known->second.number != root->number) return nullptr;
    const auto found = known->second.by_key.find(key);
    if (found != known->second.by_key.end()) return &found->second;
    const auto part = known->second.by_key.lower_bound(key + ".");  // key of the first step of an expanded property
    return part != known->second.by_key.end() && part->first.starts_with(key + ".") ? &part->second : nullptr;
}

std::string Session::verdict_text(const Declaration& element) const {
    const VerdictDetails* const known = element.kind == DeclarationKind::Property && element.owner != nullptr
                                            ? shown(element.file->path, key_of(element.owner->name, element.name))
                                            : nullptr;
    return known == nullptr ? std::string() : "\n```text\n" + known->text + "```\n";
}

// -- code lenses ------------------------------------------------------------------------------------------------------

Json Session::lenses(const Json& params) {
    const auto file = parsed(params);
    const Names& all = names(file->path);
    const std::string uri = params.at("textDocument").at("uri").get<std::string>();
    Json found = Json::array();
    const auto add = [&](const Declaration& element, const std::string& title, const char* command, Json arguments) {
        arguments.insert(arguments.begin(), uri);
        found.push_back({{"range", json_of(file->text->range(element.where.begin, element.where.end))},
                         {"command", {{"title", title}, {"command", command}, {"arguments", std::move(arguments)}}}});
    };
    for (const Use& use : all.uses(*file)) {
        if (!use.declares) continue;
        const Declaration* const element = use.element;
        if (element->kind == DeclarationKind::Loop || element->kind == DeclarationKind::Chart) {
            add(*element, "check", "grafverif.check", Json::array({element->name}));
            if (element->kind == DeclarationKind::Chart)
                add(*element, "draw", "grafverif.draw", Json::array({element->name}));
            add(*element, "simulate", "grafverif.simulate", Json::array());
        } else if (element->kind == DeclarationKind::Property && element->owner != nullptr) {
            const std::string& loop = element->owner->name;
            const VerdictDetails* const known = shown(file->path, key_of(loop, element->name));
            if (known == nullptr) add(*element, "not checked; check now", "grafverif.check", Json::array({loop}));
            else add(*element, known->word, "grafverif.showVerdict", Json::array({loop, element->name}));
        }
    }
    return found;
}

Json Session::execute(const Json& params) {
    const auto command = params.at("command").get<std::string>();
    const Json arguments = params.value("arguments", Json::array());
    if (!arguments.is_array() || arguments.empty())
        throw RequestError{rpc::invalid_params, command + " requires the URI of a document as its first argument"};
    const OpenText* const open = workspace_.find(arguments.at(0).get<std::string>());
    if (open == nullptr) throw RequestError{request_failed, "the document is not open"};
    const std::string path = open->path;
    const auto argument = [&](std::size_t place) {
        return arguments.size() > place ? arguments[place].get<std::string>() : std::string();
    };
    settle();
    if (command == "grafverif.check") return prove(path, argument(1)), Json();
    if (command == "grafverif.showVerdict") return show_verdict(path, argument(1), argument(2));
    if (command == "grafverif.draw") return draw(path, argument(1));
    if (command == "grafverif.simulate") return simulate(path);
    throw RequestError{rpc::invalid_params, "unknown command " + command};
}

Json Session::show(const std::string& uri, bool elsewhere, const std::string& words) {
    if (!can_.shows_documents)
        send({{"jsonrpc", "2.0"}, {"method", "window/showMessage"}, {"params", {{"type", 3}, {"message", words}}}});
    else
        request_client("grafverif/show", "window/showDocument",
                       {{"uri", uri}, {"external", elsewhere}, {"takeFocus", true}});
    return {{"uri", uri}};
}

Json Session::show_verdict(const std::string& path, const std::string& loop, const std::string& property) {
    const VerdictDetails* known = shown(path, key_of(loop, property));
    if (property.empty()) {  // the command palette passes no property: the first verdict of the file is shown
        const auto all = verdicts_.find(path);
        if (all != verdicts_.end() && !all->second.by_key.empty()) known = &all->second.by_key.begin()->second;
    }
    if (known == nullptr)
        throw RequestError{
            request_failed,
            "the property has no verdict yet; save the file to check it, or wait for the end of the running check"};
    const bool kept = can_.shows_documents && surroundings_.keep;
    const std::string uri = kept ? rpc::uri_of_path(surroundings_.keep(property + ".txt", known->text)) : "";
    if (kept) show(uri, false, known->text);
    else
        send({{"jsonrpc", "2.0"},
              {"method", "window/showMessage"},
              {"params", {{"type", 3}, {"message", known->text}}}});
    return {{"verdict", known->word}, {"text", known->text}};
}

Json Session::draw(const std::string& path, const std::string& chart) {
    const auto root = board_.root(path);
    if (root == nullptr || !root->reading.model)
        throw RequestError{request_failed, "charts of a file with errors cannot be drawn; correct the errors"};
    const Model& model = *root->reading.model;
    for (const Id<Chart> id : model.charts.ids()) {
        if (!chart.empty() && model.charts[id].name != chart) continue;
        if (model.charts[id].program)
            throw RequestError{request_failed, "a PLC program cannot be drawn; select a chart"};
        if (model.charts[id].steps.size() > 5000)
            throw RequestError{request_failed,
                               "the chart has more than 5,000 steps, too many to draw here; use `grafverif draw`"};
        const std::string svg = svg_of(drawing_of(model, id));
        if (!surroundings_.keep) return {{"svg", svg}};
        const std::string drawn = surroundings_.keep(model.charts[id].name + ".svg", svg);
        Json shown = show(rpc::uri_of_path(drawn), true, "drawn: " + drawn);
        shown["svg"] = svg;
        return shown;
    }
    throw RequestError{request_failed, "unknown chart"};
}

Json Session::simulate(const std::string& path) {
    if (!surroundings_.simulator) throw RequestError{request_failed, "this server has no simulator"};
    const std::string address = surroundings_.simulator(path);
    return show(address, true, "the simulator of " + path + " is at " + address);
}

}  // namespace grafverif::lsp
