// SPDX-License-Identifier: MIT
// Tests the language server while memory allocations fail. Every request must be answered, and every document must have
// its diagnostics once memory is available again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <vector>

#include "app/system/watchdog.hpp"
#include "lsp/server.hpp"
#include "robustness/resource_faults.hpp"
#include "support/test_size.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::lsp {
namespace {

using rpc::framed;

using Json = nlohmann::json;

const char* const lamp = "file:///nowhere/lamp.grafcet";
const char* const press = "file:///nowhere/press.grafcet";

const std::string lamp_text =
    "grafcet lamp { input ON, OFF; output LAMP; initial step 0; step 1 { LAMP; }\n"
    "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF && !ON; }\n"
    "closed_loop room { controller lamp; environment a = free(OUT = ON); environment b = free(OUT = OFF);\n"
    "property lit: reachable LAMP; property never_lit: never LAMP; }\n";

std::string press_text(const std::string& condition) {
    std::string text = "grafcet press { input GO; output DOWN; initial step 0; step 1 { DOWN; }\n";
    for (int k = 2; k < 60; ++k) text += fmt::format("step {} {{ DOWN if GO && X{}; }}\n", k, k - 1);
    for (int k = 1; k < 60; ++k) text += fmt::format("transition t{}: {} -> {} when GO;\n", k, k - 1, k);
    return text + "transition last: 59 -> 0 when " + condition + ";\n}\n";
}

Json note(const std::string& method, const Json& params) {
    return {{"jsonrpc", "2.0"}, {"method", method}, {"params", params}};
}

Json request(int id, const std::string& method, const Json& params) {
    Json message = note(method, params);
    message["id"] = id;
    return message;
}

Json opened(const std::string& uri, const std::string& text) {
    return note("textDocument/didOpen",
                {{"textDocument", {{"uri", uri}, {"languageId", "grafcet"}, {"version", 1}, {"text", text}}}});
}

Json changed(const std::string& uri, const std::string& text) {
    return note("textDocument/didChange", {{"textDocument", {{"uri", uri}, {"version", 2}}},
                                           {"contentChanges", Json::array({{{"text", text}}})}});
}

/// Returns the messages that the client sends while memory may be refused. The messages contain
/// every kind of request, for a document with errors and for one without errors.
const std::vector<Json>& conversation() {
    static const std::vector<Json> all = [] {
        std::vector<Json> messages = {opened(lamp, lamp_text), opened(press, press_text("G"))};
        int id = 1;
        for (const char* uri : {lamp, press}) {
            const Json document = {{"uri", uri}};
            const Json position = {{"line", 1}, {"character", 14}};
            for (const char* each : {"hover", "definition", "references", "documentHighlight", "completion"})
                messages.push_back(request(
                    ++id, "textDocument/" + std::string(each),
                    {{"textDocument", document}, {"position", position}, {"context", {{"includeDeclaration", true}}}}));
            messages.push_back(request(++id, "textDocument/rename",
                                       {{"textDocument", document}, {"position", position}, {"newName", "other"}}));
            for (const char* each : {"codeLens", "documentSymbol", "foldingRange", "semanticTokens/full", "formatting"})
                messages.push_back(
                    request(++id, "textDocument/" + std::string(each),
                            {{"textDocument", document}, {"options", {{"tabSize", 4}, {"insertSpaces", true}}}}));
            const Json start = {{"line", 0}, {"character", 0}}, end = {{"line", 99}, {"character", 0}};
            messages.push_back(request(++id, "textDocument/codeAction",
                                       {{"textDocument", document}, {"range", {{"start", start}, {"end", end}}}}));
            messages.push_back(note("textDocument/didSave", {{"textDocument", document}}));
            messages.push_back(
                request(++id, "workspace/executeCommand", {{"command", "grafverif.draw"}, {"arguments", {uri}}}));
        }
        messages.push_back(changed(press, press_text("GO && H")));
        messages.push_back(request(++id, "textDocument/documentSymbol", {{"textDocument", {{"uri", press}}}}));
        return messages;
    }();
    return all;
}

/// A client that sends all messages of `conversation()`. Once memory is available again, it closes both documents,
/// opens them with other texts, and expects the diagnostics of these texts.
class Dialogue {
public:
    using Limit = std::function<void()>;
    /// `session` limits the memory of the thread that runs the session, and `receiver` that of the thread that receives
    /// messages. The receiving thread calls `over` once memory is available again.
    Dialogue(
        Limit session, Limit receiver, Limit over = [] {})
        : session_(std::move(session)), receiver_(std::move(receiver)), over_(std::move(over)) {
        parts_[0] = framed(request(1, "initialize", {{"processId", nullptr}, {"capabilities", Json::object()}}).dump());
        for (const Json& message : conversation()) {
            parts_[1] += framed(message.dump());
            if (message.contains("id")) open_.insert(message["id"].get<int>());
        }
        for (const Json& message : {note("textDocument/didClose", {{"textDocument", {{"uri", lamp}}}}),
                                    note("textDocument/didClose", {{"textDocument", {{"uri", press}}}}),
                                    opened(lamp, press_text("L")), opened(press, press_text("K"))})
            parts_[2] += framed(message.dump());
        parts_[3] = framed(request(1000, "shutdown", nullptr).dump()) + framed(note("exit", nullptr).dump());
        open_.insert({1, 1000});
    }

    std::size_t receive(std::span<char> buffer) {
        const Unlimited own;
        std::unique_lock hold(door_);
        while (part_ < parts_.size() && at_ == parts_[part_].size()) {
            EXPECT_TRUE(wake_.wait_for(hold, std::chrono::seconds(60), [&] { return is_answered(); }))
                << part_ << Json(diagnostics_);
            if (part_ == 0) receiver_();
            if (part_ == 1) {
                lift_limits();
                over_();
            }
            ++part_;
            at_ = 0;
        }
        if (part_ == parts_.size()) return 0;
        const std::size_t count = std::min({buffer.size(), parts_[part_].size() - at_, std::size_t{700}});
        std::copy_n(parts_[part_].begin() + static_cast<std::ptrdiff_t>(at_), count, buffer.begin());
        at_ += count;
        return count;
    }

    void send(std::string_view bytes) {
        bool begun = false;
        {
            const Unlimited own;
            const Json message = Json::parse(bytes.substr(bytes.find("\r\n\r\n") + 4));
            const std::lock_guard hold(door_);
            if (message.value("method", "") == "textDocument/publishDiagnostics") {
                auto& last = diagnostics_[message["params"]["uri"].get<std::string>()];
                last = message["params"]["diagnostics"];
            }
            if (!message.contains("method") && message["id"].is_number()) {
                EXPECT_EQ(open_.erase(message["id"].get<int>()), 1U) << message;
                begun = message["id"] == 1;
            } else if (!message.contains("method")) {
                ++lost_;  // there was no memory for the message or for its id
            }
        }
        wake_.notify_all();
        if (begun) session_();
    }

    /// Runs the session on this thread.
    void run() {
        ServerEnvironment surroundings;
        surroundings.keep_memory_back = [] { app::keep_memory_back(); };
        surroundings.keep = [](const std::string& name, const std::string&) { return name; };
        const Ending ending = converse([this](std::span<char> buffer) { return receive(buffer); },
                                       [this](std::string_view bytes) { send(bytes); }, surroundings);
        lift_limits();
        EXPECT_EQ(ending, Ending::Requested);
        EXPECT_LE(open_.size(), lost_) << "request " << *open_.begin() << " has no response";
    }

private:
    /// True if the server has answered all requests of the current part of the dialogue.
    bool is_answered() const {
        switch (part_) {
        case 0: return !open_.contains(1);
        case 1: return open_.size() <= 1 + lost_;
        case 2: return is_reported(lamp, "unknown-variable") && is_reported(press, "unknown-variable");
        default: return true;
        }
    }
    bool is_reported(const std::string& uri, const std::string& code) const {
        const auto found = diagnostics_.find(uri);
        return found != diagnostics_.end() &&
               std::ranges::any_of(found->second, [&](const Json& one) { return one["code"] == code; });
    }

    Limit session_, receiver_, over_;
    /// The parts of the dialogue: initialization, requests without memory, reopened documents, end.
    std::array<std::string, 4> parts_ = {};
    std::size_t part_ = 0, at_ = 0;
    std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::set<int> open_ = {};  ///< ids of requests that have no answer yet
    std::size_t lost_ = 0;
    std::map<std::string, Json> diagnostics_ = {};
};

class LspRefusals : public testing::Test {
protected:
    void SetUp() override {
        if (sanitized) GTEST_SKIP() << "sanitizers replace the allocator";
        const std::terminate_handler before = std::get_terminate();
        app::expect_memory_to_end();
        std::set_terminate(before);  // the default handler shows the stack, which is more useful here than an exit code
    }
    void TearDown() override { std::set_new_handler(nullptr); }
};

constexpr std::int64_t many = std::int64_t{1} << 40;
const Dialogue::Limit nothing = [] {};

/// Repeats the dialogue and refuses a different allocation each time, on the thread of the session or on the receiving
/// thread.
void refuse_in_turn(bool receives) {
    std::int64_t made = many;
    for (std::int64_t after = many; after > 0;
         after = after == many ? made - 1 : after - std::max<std::int64_t>(1, made / test_size(60))) {
        SCOPED_TRACE(after);
        std::optional<Refusal> refusal;
        std::int64_t left = many;
        const Dialogue::Limit refuse = [&] { refusal.emplace(after); };
        const Dialogue::Limit count = [&] { left = refusal ? refusal->left() : many; };
        Dialogue dialogue(receives ? nothing : refuse, receives ? refuse : nothing, receives ? count : nothing);
        dialogue.run();
        if (after == many) made = many - (receives ? left : refusal->left());
    }
    EXPECT_GT(made, 100);
}

TEST_F(LspRefusals, OfEachAllocationOfTheSession) { refuse_in_turn(false); }

TEST_F(LspRefusals, OfEachAllocationOfTheReceiver) { refuse_in_turn(true); }

TEST_F(LspRefusals, OfAllMemoryBeyondALimit) {
    (void)peak_of_heap();
    const std::size_t before = heap_in_use();
    {
        Dialogue dialogue(nothing, nothing);
        dialogue.run();
    }
    const std::size_t peak = peak_of_heap() - before;
    const auto runs = static_cast<std::size_t>(test_size(60));
    for (std::size_t k = 0; k < runs; ++k) {
        SCOPED_TRACE(peak / runs * k);
        Dialogue dialogue(nothing, [&] { limit_heap(peak / runs * k); });
        dialogue.run();
    }
}

TEST_F(LspRefusals, OfAThreadEndsTheServerWithAMessage) {
    for (const int count : {0, 1}) {
        app::Result result;
        {
            const FewThreads few(count);
            result = app::grafverif({"lsp"});
        }
        EXPECT_EQ(result.code, app::ExitCode::Unknown) << count;
        EXPECT_NE(result.err.find("[threads-refused]"), std::string::npos) << count << result.err;
    }
}

TEST(LspServer, JoinsItsThreadsIfAnExceptionIsThrown) {
    const std::string first =
        framed(request(1, "initialize", {{"processId", nullptr}, {"capabilities", Json::object()}}).dump());
    bool given = false;
    const Receive receive = [&](std::span<char> buffer) {
        const std::size_t count = given ? 0 : first.size();
        given = true;
        std::copy_n(first.begin(), static_cast<std::ptrdiff_t>(count), buffer.begin());
        return count;
    };
    const Send send = [](std::string_view) { throw std::logic_error("the output is closed"); };
    EXPECT_THROW(converse(receive, send, {}), std::logic_error);
}

}  // namespace
}  // namespace grafverif::lsp
