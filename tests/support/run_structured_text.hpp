// SPDX-License-Identifier: MIT
// PLC simulator for randomized tests. The simulator executes programs and function blocks in
// Structured Text call by call as specified in IEC 61131-3, with TON, TOF and SEL of the standard
// library. The simulator is independent of charts and equations.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "syntax/st/parse_st.hpp"

namespace grafverif {

/// Returns the textual form of the units of a PLCopen project. Throws std::runtime_error if the project is invalid.
std::string units_of_plcopen(const std::string& xml);

/// Executes program units. Throws std::runtime_error if a real compiler or PLC would report an error: unknown names,
/// division by zero, values outside 32 bits, an endless loop.
class SmallPlc {
public:
    /// `units` contains the texts of programs and function blocks; `unit` names the unit to execute.
    SmallPlc(const std::vector<std::string>& units, const std::string& unit);
    SmallPlc(const SmallPlc&) = delete;
    SmallPlc& operator=(const SmallPlc&) = delete;
    ~SmallPlc();

    void set(const std::string& variable, std::int64_t value);
    std::int64_t value(const std::string& variable) const;
    bool has(const std::string& variable) const;
    /// Executes one call, `now` milliseconds after the first.
    void call(std::int64_t now);

private:
    struct Instance;
    enum class Flow { Next, Return };

    const st::Unit* unit_named(const std::string& name) const;
    std::unique_ptr<Instance> instance(const std::string& type) const;
    void run(Instance& instance);
    Flow execute(const st::Block& block, Instance& instance);
    Flow execute(const st::Statement& statement, Instance& instance);
    Flow choose(const st::Statement& statement, Instance& instance);
    Flow repeat(const st::Statement& statement, Instance& instance);
    void call(Id<st::Expr> expression, Instance& instance);
    std::int64_t evaluate(Id<st::Expr> expression, Instance& instance) const;
    std::int64_t combine(st::Op op, std::int64_t left, std::int64_t right) const;
    std::string name(Id<st::Word> word) const { return st::capitals(file_.text(word)); }

    Sources sources_ = {};
    st::File file_ = {};
    std::unique_ptr<Instance> main_;
    std::int64_t now_ = 0;
};

}  // namespace grafverif
