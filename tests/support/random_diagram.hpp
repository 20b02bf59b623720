// SPDX-License-Identifier: MIT
// Random ladder diagrams as PLCopen XML, with an evaluation of their rungs that does not use the program.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/random_chart.hpp"

namespace grafverif {

/// A contact, or contacts in series or in parallel.
struct Rungs {
    enum class Kind : std::uint8_t { Contact, Series, Parallel };
    struct Circuit {
        Kind kind = Kind::Contact;
        std::size_t variable = 0;
        bool negated = false, edge = false;
        bool before = false;  ///< the value in the last scan, for an edge
        std::vector<Circuit> parts = {};
    };
    enum class Coil : std::uint8_t { Plain, Negated, Set, Reset, Rising };
    struct Rung {
        Circuit set = {}, reset = {};  ///< `reset` only with an instance of SR before the coil
        bool latch = false;
        bool latched = false;  ///< the state of the instance
        bool before = false;   ///< the last value of a coil with an edge
        Coil coil = Coil::Plain;
        std::size_t variable = 0;
    };

    static constexpr std::size_t inputs = 3, outputs = 4;

    /// From top to bottom.
    std::vector<Rung> rungs = {};
    /// Inputs `i0`..., then outputs `q0`...
    std::vector<bool> values = std::vector<bool>(inputs + outputs);

    void scan(const std::vector<std::int64_t>& sampled);
};

Rungs random_rungs(Random& random);

/// The elements are in random order; their positions give the order of the rungs.
std::string xml_of(const Rungs& rungs, Random& random);

/// `i0`, `q3`.
std::string diagram_variable(std::size_t variable);

}  // namespace grafverif
