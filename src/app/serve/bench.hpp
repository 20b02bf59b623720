// SPDX-License-Identifier: MIT
// Bench: a file as it is now, looked at again whenever it or a file that it includes changes: what is wrong with it, its
// charts drawn, its properties decided one model after the other. Whoever wants to know asks for the newest state; a
// save takes the proofs of the state before it away.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/options.hpp"
#include "grafverif/grafverif.hpp"

namespace grafverif::app {

/// A file that was read, and what is made of it. Nobody changes it any more.
struct Workpiece {
    Reading reading = {};
    std::vector<std::optional<Network>> networks = {};  ///< per closed loop; empty: it is refused
    std::vector<bool> runs = {};                        ///< per chart: it can be simulated alone
    std::uint64_t number = 0;                           ///< of the reading
};

class Bench {
public:
    /// `changed` is called after every change, from another thread. Everything outlives the bench.
    Bench(const Options& options, std::function<void()> changed);
    ~Bench();
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    /// The state as JSON (docs/serve.md), where it is newer than `known`.
    std::optional<std::string> newer(std::uint64_t known) const;
    /// What was read last.
    std::shared_ptr<const Workpiece> workpiece() const;

private:
    class Work;
    std::unique_ptr<Work> work_;
};

}  // namespace grafverif::app
