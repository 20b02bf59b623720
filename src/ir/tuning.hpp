// SPDX-License-Identifier: MIT
// Tuning: the verdicts on the properties of a closed loop for several values of some of its constants. The value
// combinations form a grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/named_constant.hpp"
#include "grafverif/ir/report.hpp"

namespace grafverif {

/// A constant and its values `low`, `low + step`, ..., `high`. Durations are in milliseconds.
struct TunedConstant {
    std::string name = {};
    NamedConstant::Kind kind = NamedConstant::Kind::Integer;  ///< Integer or Duration
    std::int64_t low = 0, high = 0, step = 1;
    /// The value that the option `--set` selects; without this option, the value in the model.
    std::int64_t current = 0;

    std::size_t size() const { return static_cast<std::size_t>((high - low) / step) + 1; }
    std::int64_t value(std::size_t index) const { return low + static_cast<std::int64_t>(index) * step; }
    /// Returns the index of `current`, or nullopt if `current` is not one of the values of the grid.
    std::optional<std::size_t> current_index() const {
        if (current < low || current > high || (current - low) % step != 0) return {};
        return static_cast<std::size_t>((current - low) / step);
    }
};

/// A verdict on one property at one point of the grid.
struct PointVerdict {
    Outcome outcome = Outcome::Unknown;
    std::uint32_t reason = 0;  ///< for an unknown verdict: index of the reason in Tuning::reasons
    bool operator==(const PointVerdict&) const = default;
};

struct Tuning {
    struct Row {
        std::string property = {};
        std::string text = {};  ///< text of the property in the model
        bool expected_violated = false;
        Outcome expected() const { return expected_violated ? Outcome::Violated : Outcome::Holds; }
        bool declared = true;
        Span origin = {};
        PointVerdict current = {};                ///< the verdict for the current values
        std::vector<PointVerdict> verdicts = {};  ///< verdict at each point of the grid

        /// For some points at which the property is violated: the result with the run that violates it. The property
        /// and the charts of a run are those of the model at its point.
        std::map<std::size_t, PropertyResult> runs = {};
    };

    std::string model = {};  ///< name of the closed loop
    std::vector<TunedConstant> constants = {};
    /// Settings of all checks, without constants; the time unit divides all durations of all points.
    CheckSettings settings = {};
    std::vector<Row> rows = {};
    /// Reasons for unknown verdicts; entry 0 is the reason of a point that was not checked.
    std::vector<std::string> reasons = {};
    std::size_t points = 1;       ///< number of points of the grid
    std::size_t checks = 0;       ///< number of models that were checked, including the model with the current values
    std::size_t transferred = 0;  ///< number of verdicts that were derived from the check of another model
    bool model_error = false;     ///< true if a model error occurs at some point
    std::vector<std::string> failures = {};  ///< internal errors of the checks

    /// Returns the index of the value of each constant at a point. The index of the last constant varies fastest.
    std::vector<std::size_t> indices(std::size_t point) const {
        std::vector<std::size_t> all(constants.size());
        for (std::size_t k = constants.size(); k-- > 0; point /= constants[k].size())
            all[k] = point % constants[k].size();
        return all;
    }
    std::size_t point(const std::vector<std::size_t>& indices) const {
        std::size_t made = 0;
        for (std::size_t k = 0; k < constants.size(); ++k) made = made * constants[k].size() + indices[k];
        return made;
    }
};

/// A box of the grid: the first and the last index per constant.
struct GridBox {
    std::vector<std::size_t> first = {}, last = {};
};

/// Calls `visit` with the indices of each point of a box. The index of the last constant varies fastest.
template <class Visit>
void for_each_point(const GridBox& box, const Visit& visit) {
    std::vector<std::size_t> at = box.first;
    for (;;) {
        visit(at);
        std::size_t k = at.size();
        for (; k > 0 && at[k - 1] == box.last[k - 1]; --k) at[k - 1] = box.first[k - 1];
        if (k == 0) return;
        ++at[k - 1];
    }
}

}  // namespace grafverif
