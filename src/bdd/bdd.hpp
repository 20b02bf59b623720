// SPDX-License-Identifier: MIT
// Bdd: Boolean functions as reduced ordered binary decision diagrams with complement edges (Bryant 1986; Brace, Rudell
// and Bryant 1990).
//
// A BddSpace owns variables, nodes and memory; there may be several, each used by one thread at a time. Variables are
// added at the bottom of the order and stay there unless the space is told to look for a better order: who adds them
// decides their order, and the order decides the cost.
//
// A Bdd is a handle: equal functions are equal handles, copies are cheap. A handle knows its space; constants belong to
// none, and go with every space. Handles and renamings die before the space they were used with.
//
// Every operation may end with BddExhausted: the memory allowed is used up or refused by the system, or somebody asked
// to stop, which is noticed within milliseconds. It is the only exception that crosses rooms; the entry point that made
// the space catches it and answers `unknown`. Afterwards all handles still stand for the functions they stood for.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace grafverif {

struct BddLimits {
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< bytes, for nodes, tables and cache
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< set by somebody else
    std::uint64_t work = std::numeric_limits<
        std::uint64_t>::max();  ///< steps of operations: ends as a deadline does, at the same place each time
};

class BddExhausted : public std::exception {
public:
    enum class Cause { Memory, Stopped };

    explicit BddExhausted(Cause cause) : cause_(cause) {}
    Cause cause() const { return cause_; }
    const char* what() const noexcept override;

private:
    Cause cause_ = Cause::Memory;
};

namespace bdd {
struct Kernel;
}

class Bdd {
public:
    Bdd() = default;  ///< false
    Bdd(const Bdd& other) : kernel_(other.kernel_), edge_(other.edge_) { hold(); }
    Bdd(Bdd&& other) noexcept : kernel_(std::exchange(other.kernel_, nullptr)), edge_(std::exchange(other.edge_, 0)) {}
    Bdd& operator=(const Bdd& other) {
        other.hold();
        release();
        kernel_ = other.kernel_;
        edge_ = other.edge_;
        return *this;
    }
    Bdd& operator=(Bdd&& other) noexcept {
        std::swap(kernel_, other.kernel_);
        std::swap(edge_, other.edge_);
        return *this;
    }
    ~Bdd() { release(); }

    static Bdd constant(bool value) {
        Bdd result;
        result.edge_ = value ? 1 : 0;
        return result;
    }

    bool is_true() const { return edge_ == 1; }
    bool is_false() const { return edge_ == 0; }
    bool is_constant() const { return edge_ < 2; }
    /// Whether both are the same function.
    bool operator==(const Bdd& other) const = default;

    /// The topmost variable that the function depends on, and the function where that variable is false or true. Not
    /// of a constant.
    std::uint32_t top() const;
    Bdd low() const;
    Bdd high() const;

    std::size_t hash() const { return std::size_t{edge_} * 0x9E3779B97F4A7C15U; }

    /// For the implementation: the function in its space. Of a constant the space is null.
    Bdd(bdd::Kernel& kernel, std::uint32_t edge);
    bdd::Kernel* kernel() const { return kernel_; }
    std::uint32_t edge() const { return edge_; }

private:
    void hold() const;
    void release() const;

    bdd::Kernel* kernel_ = nullptr;
    std::uint32_t edge_ = 0;
};

class BddSpace {
public:
    explicit BddSpace(const BddLimits& limits = {});
    BddSpace(const BddSpace&) = delete;
    BddSpace& operator=(const BddSpace&) = delete;
    ~BddSpace();

    /// Adds `count` variables below all others; the index of the first.
    std::uint32_t add_variables(std::size_t count);
    std::size_t variables() const;
    Bdd variable(std::uint32_t index) const;

    std::uint64_t nodes() const;  ///< nodes in use, those that nobody needs any more among them
    std::uint64_t bytes() const;  ///< memory held for nodes, tables and cache
    std::uint64_t work() const;   ///< steps of operations so far: what was done, whatever time it took

    /// Frees the nodes that nobody needs; it is done without being asked when they are in the way.
    void collect_garbage();

    /// Variables from the topmost down.
    std::vector<std::uint32_t> order() const;
    /// From now on `count` variables from `first` on change places together. They lie side by side.
    void keep_together(std::uint32_t first, std::size_t count);
    /// Looks for an order with fewer nodes, as far as the memory allows. All functions stay what they are.
    void reorder();
    /// Does so by itself before an operation, when more than `nodes` nodes are in use; after that, when they have
    /// doubled. 0, the default: never.
    void reorder_above(std::uint64_t nodes);

    /// For the implementation.
    bdd::Kernel& kernel() const { return *kernel_; }

private:
    std::unique_ptr<bdd::Kernel> kernel_;
};

/// The invariants of the space that do not hold; all do unless we are wrong.
std::vector<std::string> verify(const BddSpace& space);

Bdd operator~(const Bdd& f);
Bdd operator&(const Bdd& f, const Bdd& g);
Bdd operator|(const Bdd& f, const Bdd& g);
Bdd operator^(const Bdd& f, const Bdd& g);
inline Bdd& operator&=(Bdd& f, const Bdd& g) { return f = f & g; }
inline Bdd& operator|=(Bdd& f, const Bdd& g) { return f = f | g; }
Bdd implies(const Bdd& f, const Bdd& g);
Bdd iff(const Bdd& f, const Bdd& g);
Bdd ite(const Bdd& condition, const Bdd& then, const Bdd& otherwise);

/// A variable with a sign.
struct BddLiteral {
    std::uint32_t variable = 0;
    bool value = true;
    bool operator==(const BddLiteral&) const = default;
};

/// The conjunction of the literals; of no literal: true.
Bdd cube(const BddSpace& space, std::span<const BddLiteral> literals);
/// The conjunction of the variables: how the quantifiers take a set of variables.
Bdd variable_set(const BddSpace& space, std::span<const std::uint32_t> variables);

Bdd exists(const Bdd& f, const Bdd& variables);
/// exists(f & g, variables) without building f & g: the relational product.
Bdd and_exists(const Bdd& f, const Bdd& g, const Bdd& variables);
/// f where the literals of the cube hold; it depends on none of their variables.
Bdd cofactor(const Bdd& f, const Bdd& cube);
/// A function, small where possible, equal to f wherever `care` holds (Coudert and Madre 1990). `care` is not false.
Bdd simplify(const Bdd& f, const Bdd& care);

/// Renames variables, all at once.
class BddRenaming {
public:
    /// Each first becomes the second; no two become the same.
    explicit BddRenaming(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
    BddRenaming(const BddRenaming&) = delete;
    BddRenaming& operator=(const BddRenaming&) = delete;
    ~BddRenaming();

    /// f renamed. A variable that f depends on and that is not renamed is nobody's new name.
    Bdd operator()(const Bdd& f) const;

    struct Map;  ///< for the implementation

private:
    std::unique_ptr<Map> map_;
};

/// The variables that f depends on, increasing.
std::vector<std::uint32_t> support(const Bdd& f);
/// The number of nodes of f, constants not counted.
std::size_t size(const Bdd& f);
/// f where variable i has the value values[i]; `values` reaches all variables that f depends on.
bool evaluate(const Bdd& f, const std::vector<bool>& values);

/// Literals, in increasing order of their variables, that make f true; empty optional: f is false.
std::optional<std::vector<BddLiteral>> one_cube(const Bdd& f);
/// Disjoint cubes whose disjunction is f, false branches first, until `visit` returns false. Their number can be
/// exponential in the size of f.
void for_each_cube(const Bdd& f, const std::function<bool(std::span<const BddLiteral>)>& visit);

/// How many assignments to `variables` make f true, exactly, in decimal. `variables` are increasing and hold every
/// variable that f depends on.
std::string count(const Bdd& f, std::span<const std::uint32_t> variables);
/// The same where it fits.
std::optional<std::uint64_t> small_count(const Bdd& f, std::span<const std::uint32_t> variables);

}  // namespace grafverif

template <>
struct std::hash<grafverif::Bdd> {
    std::size_t operator()(const grafverif::Bdd& f) const noexcept { return f.hash(); }
};
