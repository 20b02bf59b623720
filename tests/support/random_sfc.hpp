// SPDX-License-Identifier: MIT
// Generates random Sequential Function Charts as text, and executes them by the rules of IEC 61131-3, 2.6,
// independently of grafverif. Action qualifiers are evaluated from the times of activation, and not with the function
// blocks of the standard.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/random_chart.hpp"

namespace grafverif {

struct RandomSfc {
    enum class Kind : std::uint8_t { Input, Active, Time, Variable, Action };
    /// A condition on an input, a step, the time of a step in milliseconds, a variable or the state of an action.
    struct Literal {
        Kind kind = Kind::Input;
        std::size_t index = 0;
        std::int64_t least = 0;
        bool negated = false;
    };
    struct Transition {
        std::vector<std::size_t> from = {}, to = {};
        std::vector<Literal> condition = {};  ///< all literals must be true
        std::int64_t priority = 0;            ///< 0: the transition has no priority
    };
    struct Step {
        bool active = false;
        std::int64_t since = 0;   ///< the time at which the step was activated
        std::int64_t lasted = 0;  ///< the time for which the step was active before its deactivation
        std::vector<std::pair<std::size_t, std::string>> blocks = {};  ///< pairs of an action and a qualifier
    };
    /// A condition: its value, its edges in the current scan, and the time of its last rise.
    struct Stretch {
        bool on = false, rises = false, falls = false;
        std::int64_t since = 0;
        void follow(bool value, std::int64_t at);
    };
    struct Action {
        bool variable = false;
        std::string timed = {};  ///< the only qualifier of the action that has a duration
        std::int64_t duration = 0;
        Literal copied = {};  ///< the statements of the action assign the value of this literal to `m`
        bool used = false, q = false, executed = false, copy = false, stored = false;
        Stretch pulse = {}, entry = {}, exit = {}, delay = {};
        std::int64_t count = 0;
    };

    static constexpr std::size_t inputs = 3;

    std::vector<Step> steps = {};
    std::vector<Transition> transitions = {};
    std::vector<Action> actions = {};
    std::vector<std::size_t> order = {};  ///< the actions that steps use, in the order of their execution
    std::array<bool, inputs> values = {};
    std::int64_t now = 0;
    bool started = false;
    int cleared = 0;        ///< number of transitions cleared in the last scan
    bool selected = false;  ///< true if a transition had priority over another one in the last scan

    void scan(const std::vector<std::int64_t>& sampled, std::int64_t elapsed);
    std::string text() const;
    /// Returns the same chart in PLCopen XML. The transitions are in random order; their positions give the order of
    /// the text.
    std::string xml(Random& random) const;

private:
    bool is_true(const Literal& literal) const;
    bool is_active(std::size_t action, const std::string& qualifier) const;
    void evolve();
    void control(std::size_t action);
    std::string text(const Literal& literal) const;
    std::string condition(const Transition& transition) const;
    std::string statements(std::size_t action) const;
};

RandomSfc random_sfc(Random& random);

}  // namespace grafverif
