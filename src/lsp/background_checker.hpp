// SPDX-License-Identifier: MIT
// BackgroundChecker: executes checks sequentially in a separate thread. For each root (a file that is parsed with its
// includes), the checks derive the models, decide the properties, and analyse the charts. If a root is parsed again,
// its pending checks are cancelled.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "lsp/diagnostic_store.hpp"

namespace grafverif::lsp {

/// A verdict in the form in which the editor displays it.
struct VerdictDetails {
    std::string word = {};  ///< text such as `holds` or `violated, as expected`
    std::string text = {};  ///< output of `check`: the assumptions and the run
};

struct Task {
    enum class What { Models, Proofs };
    std::shared_ptr<const Root> root = {};
    What what = What::Models;
    std::string only = {};  ///< name of the loop or chart to check; all if empty
};

/// The complete or partial result of a task.
struct Found {
    std::shared_ptr<const Root> root = {};
    std::string source = {};  ///< the source of the diagnostics, which replace all earlier diagnostics of this source
    std::vector<LspDiagnostic> diagnostics = {};
    std::map<std::string, VerdictDetails> verdicts = {};  ///< verdicts by key, such as `loop station/q P15`
};

class BackgroundChecker {
public:
    struct Callbacks {
        std::function<void(Found)> found = {};
        /// Called with the state of the checks; an empty text means that no check is running.
        std::function<void(std::string words)> progress = {};
    };
    /// The thread of the checker calls the functions in `callbacks`.
    BackgroundChecker(Callbacks callbacks, std::optional<std::chrono::milliseconds> response_timeout);
    ~BackgroundChecker();
    BackgroundChecker(const BackgroundChecker&) = delete;
    BackgroundChecker& operator=(const BackgroundChecker&) = delete;

    void submit(Task task);
    /// Cancels the tasks of roots for which `current` is false.
    void keep(const std::function<bool(const Root&)>& current);
    void give_up();

private:
    void work();
    template <class Work>
    void run_and_report(const Task& task, const std::string& source, const Work& work);
    void make_models(const Task& task);
    Diagnostics refused_models(const Task& task) const;
    void prove(const Task& task);
    void prove_loop(const Root& root, Id<ClosedLoop> loop, Found& outcome);
    void look_into(const Root& root, Id<Chart> chart, Found& outcome);
    Limits limits(const std::string& what);

    Callbacks callbacks_;
    std::optional<std::chrono::milliseconds> response_timeout_;
    std::mutex mutex_ = {};
    std::condition_variable wake_ = {};
    std::deque<Task> tasks_ = {};
    std::shared_ptr<const Root> at_hand_ = {};
    std::atomic<bool> stop_ = false;
    bool over_ = false;
    std::thread thread_ = {};
};

}  // namespace grafverif::lsp
