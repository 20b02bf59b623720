// SPDX-License-Identifier: MIT
// Generates random ladder diagrams as PLCopen XML, and evaluates their rungs independently of grafverif.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/random_chart.hpp"

namespace grafverif {

/// A contact, or several contacts in series or in parallel.
struct Rungs {
    enum class Kind : std::uint8_t { Contact, Series, Parallel };
    struct Circuit {
        Kind kind = Kind::Contact;
        std::size_t variable = 0;
        bool negated = false, edge = false;
        bool before = false;  ///< the value in the last scan, which determines edges
        std::vector<Circuit> parts = {};
    };
    enum class Coil : std::uint8_t { Plain, Negated, Set, Reset, Rising };
    struct Rung {
        Circuit set = {}, reset = {};  ///< `reset` is used only if an instance of SR precedes the coil
        bool latch = false;
        bool latched = false;  ///< the state of the SR instance
        bool before = false;   ///< the last value of a coil that detects edges
        Coil coil = Coil::Plain;
        std::size_t variable = 0;
    };

    static constexpr std::size_t inputs = 3, outputs = 4;

    /// The rungs from top to bottom.
    std::vector<Rung> rungs = {};
    /// The inputs `i0`, `i1`, ... and then the outputs `q0`, `q1`, ...
    std::vector<bool> values = std::vector<bool>(inputs + outputs);

    void scan(const std::vector<std::int64_t>& sampled);
};

Rungs random_rungs(Random& random);

/// Returns the diagram as XML. The elements are in random order; their positions give the order of the rungs.
std::string xml_of(const Rungs& rungs, Random& random);

/// Returns the name of the variable: `i0`, `q3`.
std::string diagram_variable(std::size_t variable);

}  // namespace grafverif
