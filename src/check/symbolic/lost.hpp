// SPDX-License-Identifier: MIT
// What is lost behind the point of no return of an untimed model: which transitions are never cleared in the states that can
// still be reached.
#pragma once

#include <string>

#include "check/symbolic/model.hpp"

namespace grafverif::symbolic {

/// Names them, each with what stays false of its condition where that is a step or a variable. `reached`: all states there are;
/// `from`, one of them: the point of no return. `flat`, of `system`, gains terms. Empty: there is none, or nothing is known of
/// charts.
std::string lost_words(const TransitionSystem& system, FlatSystem& flat, const StateSpace& model, const Bdd& reached,
                       const State& from);

}  // namespace grafverif::symbolic
