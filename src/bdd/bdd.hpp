// SPDX-License-Identifier: MIT
// Bdd: Boolean functions as reduced ordered binary decision diagrams with complement edges (Bryant 1986; Brace, Rudell
// and Bryant 1990).
//
// A BddSpace owns variables, nodes and memory. Several spaces may exist; each space must be used by only one thread at
// a time. Variables are added at the bottom of the order and keep their positions unless reordering is requested.
// Therefore the caller determines the order, which determines the number of nodes and the cost of operations.
//
// A Bdd is a handle of a function. Handles of equal functions are equal, and copying a handle is cheap. A handle refers
// to its space. The constants true and false do not belong to a space and can be combined with handles of every space.
// All handles and renamings of a space must be destroyed before the space.
//
// Every operation throws BddExhausted if a limit of the space is reached, an allocation fails, or the stop flag is set.
// Operations detect the stop flag within milliseconds. By convention, the function that created the space catches the
// exception and returns the result `unknown`. After the exception, all handles denote the same functions as before.
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
    std::uint64_t memory = std::uint64_t{2} << 30U;  ///< memory limit for nodes, tables and cache, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag, which another thread may set

    /// Maximum number of operation steps; unlike a deadline, this limit does not depend on the speed of the processor.
    std::uint64_t work = std::numeric_limits<std::uint64_t>::max();
    /// Counter to which the number of operation steps is periodically added.
    std::atomic<std::uint64_t>* worked = nullptr;
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
    Bdd() = default;  ///< creates the constant false
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
    /// True if both handles denote the same function.
    bool operator==(const Bdd& other) const = default;

    /// `top` returns the topmost variable on which the function depends. `low` and `high` return the cofactors for the
    /// values false and true of this variable. Requires that the function is not constant.
    std::uint32_t top() const;
    Bdd low() const;
    Bdd high() const;

    std::size_t hash() const { return std::size_t{edge_} * 0x9E3779B97F4A7C15U; }

    /// Creates the handle of a function. Only the implementation of the operations calls this constructor. A handle of
    /// a constant does not refer to `kernel`.
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

    /// Adds `count` variables at the end of the order. Returns the index of the first new variable.
    std::uint32_t add_variables(std::size_t count);
    std::size_t variables() const;
    Bdd variable(std::uint32_t index) const;

    std::uint64_t nodes() const;  ///< returns the number of nodes in use, including garbage
    std::uint64_t bytes() const;  ///< returns the memory allocated for nodes, tables and cache, in bytes

    /// Returns the number of operation steps so far: a measure of work that does not depend on the speed of the
    /// processor.
    std::uint64_t work() const;

    /// Frees unused nodes. The space collects garbage automatically when it needs memory.
    void collect_garbage();

    /// Returns the variables in their order, topmost first.
    std::vector<std::uint32_t> order() const;
    /// Makes a group of the `count` adjacent variables from the index `first` on. Reordering moves the variables of a
    /// group together.
    void keep_together(std::uint32_t first, std::size_t count);
    /// Searches for a variable order with fewer nodes. The search ends early if it would need more memory than the
    /// limit. All handles keep their functions.
    void reorder();
    /// Enables automatic reordering: before an operation, the space is reordered if more than `nodes` nodes are in use,
    /// and again whenever the number of nodes has doubled. The value 0 (the default) disables automatic reordering.
    void reorder_above(std::uint64_t nodes);

    /// Used only by the implementation.
    bdd::Kernel& kernel() const { return *kernel_; }

private:
    std::unique_ptr<bdd::Kernel> kernel_;
};

/// Returns the violated invariants of the space; empty unless there is an internal error.
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

/// A variable or its negation.
struct BddLiteral {
    std::uint32_t variable = 0;
    bool value = true;
    bool operator==(const BddLiteral&) const = default;
};

/// Returns the conjunction of the literals; the constant true if `literals` is empty.
Bdd cube(const BddSpace& space, std::span<const BddLiteral> literals);
/// Returns the conjunction of the variables, which represents a set of variables as an argument of `exists` and
/// `and_exists`.
Bdd variable_set(const BddSpace& space, std::span<const std::uint32_t> variables);

Bdd exists(const Bdd& f, const Bdd& variables);
/// Returns exists(f & g, variables) without computing f & g: the relational product.
Bdd and_exists(const Bdd& f, const Bdd& g, const Bdd& variables);
/// Returns the cofactor of f: f with the variables of the cube replaced by the values that the cube gives them.
Bdd cofactor(const Bdd& f, const Bdd& cube);
/// Returns a function that equals f for all assignments that satisfy `care`, and that has few nodes if possible
/// (Coudert and Madre 1990). Requires that `care` is not false.
Bdd simplify(const Bdd& f, const Bdd& care);

/// A simultaneous renaming of variables.
class BddRenaming {
public:
    /// Maps the first variable of each pair to the second variable of the pair. Requires that the second variables are
    /// distinct.
    explicit BddRenaming(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);
    BddRenaming(const BddRenaming&) = delete;
    BddRenaming& operator=(const BddRenaming&) = delete;
    ~BddRenaming();

    /// Returns f with renamed variables. Requires that f does not depend on the second variable of a pair, unless this
    /// variable is also the first variable of a pair.
    Bdd operator()(const Bdd& f) const;

    struct Map;  ///< used only by the implementation

private:
    std::unique_ptr<Map> map_;
};

/// Returns the variables on which f depends, in increasing order.
std::vector<std::uint32_t> support(const Bdd& f);
/// Returns the number of nodes of f without constants.
std::size_t size(const Bdd& f);
/// Returns the value of f if each variable i has the value values[i]. Requires that `values` contains a value for each
/// variable on which f depends.
bool evaluate(const Bdd& f, const std::vector<bool>& values);

/// Returns literals that make f true, in increasing order of their variables, or nullopt if f is false.
std::optional<std::vector<BddLiteral>> one_cube(const Bdd& f);
/// Enumerates disjoint cubes whose disjunction is f, until `visit` returns false. For each variable, cubes with the
/// value false are enumerated first. The number of cubes can be exponential in the size of f.
void for_each_cube(const Bdd& f, const std::function<bool(std::span<const BddLiteral>)>& visit);

/// Returns the exact number of assignments to `variables` that make f true, in decimal. Requires that `variables` is in
/// increasing order and contains every variable on which f depends.
std::string count(const Bdd& f, std::span<const std::uint32_t> variables);
/// Returns the same number as `count`, or nullopt if the number does not fit into 64 bits.
std::optional<std::uint64_t> small_count(const Bdd& f, std::span<const std::uint32_t> variables);

}  // namespace grafverif

template <>
struct std::hash<grafverif::Bdd> {
    std::size_t operator()(const grafverif::Bdd& f) const noexcept { return f.hash(); }
};
