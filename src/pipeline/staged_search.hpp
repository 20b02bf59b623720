// SPDX-License-Identifier: MIT
// Staged search of the timed engine: the steps by which the properties of one network are decided.
//
//   begin: A bounded search of the complete loop, and then the first round of localization.
//   refine: A round of localization and input abstraction; the bounds on states increase from round to round.
//   search_complete: A search of the complete loop for undecided properties.
//
// A caller can interleave the steps of several searches that share one time limit.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "check/inputs/inputs.hpp"
#include "check/localization/localization.hpp"
#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

/// Returns the options of the engine for a check of `loop`. `options` must outlive the result.
TimedOptions timed_options(const LoopToCheck& loop, const CheckOptions& options);

/// Results of a search in addition to the verdicts on the requested properties.
struct AdditionalResults {
    /// Verdict on an undeclared `no timelock`. If this verdict is not requested, a search for properties about single
    /// states needs fewer states, and the store contains no edges.
    bool timelock = true;
    bool profile = true;  ///< state profile of a large search
};

/// Checks a loop in the same way as `check` (pipeline/check.hpp), but does not search for the causes of violations and
/// of unreachable steps, and computes no state profile. If `timelock` is false, an undeclared `no timelock` has no
/// verdict.
Report check_without_causes(const LoopToCheck& loop, const CheckOptions& options, bool timelock = true);

/// Returns a prover that decides properties by PDR on the model that `system_of` returns for an abstraction. Copies of
/// the prover share the result that no model error is possible. Therefore all abstractions must be abstractions of the
/// same loop.
StateProver prover_by_pdr(AbstractionTranslator system_of);

class StagedSearch {
public:
    /// `observe` builds `network` from the loop: it adds the observer of the only property, or it changes nothing.
    /// Localization does not apply to an observer, which reads the complete loop. All references must outlive the
    /// search. A search of a network with an observer has no additional results.
    StagedSearch(const LoopToCheck& loop, const Observe& observe, const Network& network, const CheckOptions& options,
                 AdditionalResults additional = {});

    /// Limits the search to the bounded search of the complete loop and to one short round of input abstraction. Must
    /// be called before `begin`.
    void make_brief();

    /// Performs the first step: the bounded search and the first round of localization.
    void begin(const Deadline& deadline, LocalizationLimits limits = {}, const InputLimits& inputs = {});

    /// Performs one round of localization and of input abstraction. Returns false if no further round is possible.
    bool refine(std::uint64_t states, const Deadline& deadline);

    /// True if no property is undecided, except for the vacuity of decided properties.
    bool decides_only_vacuity();

    /// True if the search of the complete loop can decide a requested property that is still undecided.
    bool needs_whole();

    /// Performs the last step: the search of the complete loop.
    void search_complete(const Deadline& deadline);

    std::uint64_t states() { return complete_ ? complete_->found().states : result_.states; }
    /// True if the complete loop exceeds the bound of the first step.
    bool is_large();
    TimedResult result() { return complete_ ? complete_->result() : std::move(result_); }

private:
    const bool is_watched_;
    bool in_steps_, is_brief_ = false;
    const LoopToCheck& loop_;
    const Observe& observe_;
    const Network& network_;
    TimedOptions options_, abstract_ = {};
    Network expanded_ = {};
    std::optional<CellSearch> complete_ = {};
    std::optional<InputSearch> inputs_ = {};
    bool refines_inputs_ = false;  // true if `inputs_` has a search for the next round
    TimedResult result_ = {};
};

}  // namespace grafverif
