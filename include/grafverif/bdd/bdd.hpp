// SPDX-License-Identifier: MIT
// Bdd: Boolean functions as reduced ordered binary decision diagrams (Bryant 1986), on BuDDy, which nobody else sees.
//
// A BddSpace owns the variables and the memory; BuDDy keeps one such space per process, so a second one waits for the
// end of the first. Variable 0 is the topmost; variables are added at the bottom and never change places: who adds
// them decides their order, and the order decides the cost.
//
// A Bdd is a handle: equal functions are equal handles, copies are cheap. Handles, renamings and substitutions die
// before their space and are used in the thread that made it.
//
// Every operation may end with BddExhausted: the memory allowed is used up, or somebody asked to stop. It is the only
// exception that crosses rooms; the entry point that made the space catches it and answers `unknown`. Afterwards all
// handles still stand for the functions they stood for.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace grafverif {

struct BddLimits {
    std::uint64_t memory = std::uint64_t{2} << 30U;   ///< bytes, for nodes and caches
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;          ///< set by somebody else
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

class Bdd {
public:
    Bdd() = default;   ///< false
    Bdd(const Bdd& other);
    Bdd(Bdd&& other) noexcept : node_(std::exchange(other.node_, 0)) {}
    Bdd& operator=(const Bdd& other);
    Bdd& operator=(Bdd&& other) noexcept { std::swap(node_, other.node_); return *this; }
    ~Bdd();

    static Bdd constant(bool value);

    bool is_true() const { return node_ == 1; }
    bool is_false() const { return node_ == 0; }
    bool is_constant() const { return node_ < 2; }
    /// Whether both are the same function.
    bool operator==(const Bdd& other) const = default;

    /// The topmost variable that the function depends on, and the function where that variable is false or true. Not
    /// of a constant.
    std::uint32_t top() const;
    Bdd low() const;
    Bdd high() const;

    std::size_t hash() const { return static_cast<std::size_t>(node_); }

    /// BuDDy's number of the node; for the implementation.
    int node() const { return node_; }
    static Bdd of_node(int node);

private:
    int node_ = 0;
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

    std::uint64_t nodes() const;   ///< nodes in use
    std::uint64_t bytes() const;   ///< memory held for nodes and caches

private:
    struct Kernel;
    std::unique_ptr<Kernel> kernel_;
};

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
Bdd cube(std::span<const BddLiteral> literals);
/// The conjunction of the variables: how the quantifiers take a set of variables.
Bdd variable_set(std::span<const std::uint32_t> variables);

Bdd exists(const Bdd& f, const Bdd& variables);
Bdd forall(const Bdd& f, const Bdd& variables);
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

private:
    void* pairs_ = nullptr;
};

/// Puts functions in the places of variables, all at once.
class BddSubstitution {
public:
    explicit BddSubstitution(std::span<const std::pair<std::uint32_t, Bdd>> values);
    BddSubstitution(const BddSubstitution&) = delete;
    BddSubstitution& operator=(const BddSubstitution&) = delete;
    ~BddSubstitution();

    Bdd operator()(const Bdd& f) const;

private:
    void* pairs_ = nullptr;
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
