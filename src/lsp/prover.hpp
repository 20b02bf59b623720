// SPDX-License-Identifier: MIT
// Prover: what takes longer than reading a file, one thing after the other on a thread of its own: whether the models of
// a root can be made, what its properties come to, what `analyse` finds in its charts. What is asked about a root that
// is read again meanwhile is given up.
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

#include "lsp/board.hpp"

namespace grafverif::lsp {

/// A verdict to be shown.
struct Shown {
    std::string word = {};  ///< `holds`, `violated, as expected`
    std::string text = {};  ///< as `check` tells it: what it rests on, and the run
};

struct Task {
    enum class What { Models, Proofs };
    std::shared_ptr<const Root> root = {};
    What what = What::Models;
    std::string only = {};  ///< the loop or chart of that name; empty: all
};

/// What became of a task, or of a part of it.
struct Found {
    std::shared_ptr<const Root> root = {};
    std::string source = {};  ///< what the findings are of: those told of it before are no more
    std::vector<Told> told = {};
    std::map<std::string, Shown> verdicts = {};  ///< by key: `loop station/q P15`
};

class Prover {
public:
    struct Ears {
        std::function<void(Found)> found = {};
        std::function<void(std::string words)> progress = {};  ///< empty words: nothing is being proved any more
    };
    /// Both are called from the thread of the prover.
    Prover(Ears ears, std::optional<std::chrono::milliseconds> patience);
    ~Prover();
    Prover(const Prover&) = delete;
    Prover& operator=(const Prover&) = delete;

    void ask(Task task);
    /// Gives up what is asked about roots for which `current` does not hold.
    void keep(const std::function<bool(const Root&)>& current);
    void give_up();

private:
    void work();
    template <class Work>
    void tell(const Task& task, const std::string& source, const Work& work);
    void make_models(const Task& task);
    Diagnostics refused_models(const Task& task) const;
    void prove(const Task& task);
    void prove_loop(const Root& root, Id<ClosedLoop> loop, Found& outcome);
    void look_into(const Root& root, Id<Chart> chart, Found& outcome);
    Limits limits(const std::string& what);

    Ears ears_;
    std::optional<std::chrono::milliseconds> patience_;
    std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::deque<Task> tasks_ = {};
    std::shared_ptr<const Root> at_hand_ = {};
    std::atomic<bool> stop_ = false;
    bool over_ = false;
    std::thread thread_ = {};
};

}  // namespace grafverif::lsp
