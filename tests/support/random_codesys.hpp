// SPDX-License-Identifier: MIT
// Generates random charts in the CODESYS dialect of PLCopen XML, and executes them according to the phases in the
// documentation of CODESYS, independently of grafverif. Two charts are actions of one program, which executes the
// second one only while an input is true.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/random_sfc.hpp"

namespace grafverif {

struct RandomCodesys {
    struct Step {
        bool before = false, active = false, next = false;
        std::int64_t since = 0, lasted = 0;  ///< time of the last activation, and duration of the last completed
                                             ///< activity
        int entry = 0, main = 0, exit = 0;   ///< numbers of actions; 0: none
        std::vector<std::pair<std::string, std::string>> blocks = {};  ///< action or variable, and qualifier
    };
    struct Transition {
        std::vector<std::size_t> from = {}, to = {};
        std::string condition = {};  ///< name of an input or variable, or TRUE; empty: the time of a step
        bool negated = false;
        std::size_t timed = 0;  ///< the step whose time is compared
        std::int64_t least = 0;
    };
    struct Control {
        bool q = false, before = false;
        RandomSfc::Stretch pulse = {}, delay = {}, limit = {};
    };
    struct Chart {
        std::vector<Step> steps = {};
        std::vector<Transition> transitions = {};
        std::map<std::string, Control> controls = {};  ///< in alphabetical order
    };

    static constexpr int actions = 4;          ///< statements A1 to A4
    static constexpr std::int64_t delay = 15;  ///< duration of the qualifiers D and L
    std::array<Chart, 2> charts = {};
    bool uses_reset = false;
    std::map<std::string, bool> values = {};  ///< values of i0 to i2, SFCReset, v0 to v2
    std::map<std::string, bool> stored = {};
    std::int64_t now = 0, log = 0;
    int cleared = 0, ends = 0, exits = 0, resets = 0;  ///< counts of events up to now

    void scan(const std::vector<std::int64_t>& inputs, std::int64_t elapsed);
    std::string xml() const;

private:
    void execute(Chart& chart);
    void control(Chart& chart, const std::string& name, Control& control);
    bool is_true(const Chart& chart, const Transition& transition);
    void run(int action) { log = (log * 7 + action) % 1000; }
};

RandomCodesys random_codesys(Random& random);

}  // namespace grafverif
