// SPDX-License-Identifier: MIT
// Questions: everything an analysis asks of a chart, one by one, and what is known of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/analyse/analyse.hpp"

namespace grafverif::analysis {

/// In the place of a variable: what is about no single one.
inline constexpr std::size_t no_variable = static_cast<std::size_t>(-1);

struct Question {
    std::string_view code = {};
    std::size_t index = 0;        ///< of what it is about, in the table that its code speaks of
    std::string subject = {};
    bool decided = false;
    bool seen_in_part = false;    ///< a part has what would answer it; the chart did not confirm that it has
    std::size_t instants = 0;     ///< while it is open: in the first so many the answer did not come
    std::int64_t evolutions = 0;  ///< of a counter: in so many evolutions it stays in its range
};

class Questions {
public:
    Questions(const Chart& chart, const Equations& equations, const AnalyseOptions& options);

    /// The question where it is asked and still open, else nothing.
    Question* open(std::string_view code, std::size_t index);
    bool any_open() const;
    const std::vector<Question>& all() const { return all_; }
    /// Nothing is asked any more.
    void drop() { all_.clear(), places_.clear(); }
    /// What a part has, the chart has: no run of it breaks off or goes on for ever.
    void trust_parts();
    void decide(std::string_view code, std::size_t index = 0);

private:
    void add(std::string_view code, std::size_t index, std::string subject);

    std::vector<Question> all_ = {};
    std::map<std::pair<std::string_view, std::size_t>, std::size_t> places_ = {};
};

}  // namespace grafverif::analysis
