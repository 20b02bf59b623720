// SPDX-License-Identifier: MIT
// Executes compiled code (program.hpp). The interpreter has no state except the current instruction, so its speed
// depends mainly on branch prediction.
#include "check/timed/program.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

std::int64_t arithmetic(Opcode op, std::int64_t left, std::int64_t right) {
    if (left == undefined || right == undefined) return undefined;
    std::int64_t result = 0;
    bool overflow = false;
    switch (op) {
    case Opcode::Add: overflow = __builtin_add_overflow(left, right, &result); break;
    case Opcode::Subtract: overflow = __builtin_sub_overflow(left, right, &result); break;
    case Opcode::Multiply: overflow = __builtin_mul_overflow(left, right, &result); break;
    case Opcode::Divide: return right == 0 ? undefined : left / right;
    case Opcode::Modulo: return right == 0 ? undefined : left % right;
    case Opcode::Negate: return -left;
    default: unreachable();
    }
    return overflow ? undefined : result;
}

/// Evaluates an instruction of code without branches (eager.cpp). The registers contain the values of all operands. The
/// result of EagerAnd and EagerOr depends on the right operand only if the left operand does not determine the result.
std::int64_t eager_value(const Instruction& at, const std::int64_t* registers) {
    const std::int64_t left = registers[at.a];
    const std::int64_t right = registers[at.b];
    if (left == undefined) return undefined;
    if (at.op == Opcode::EagerNot) return left == 0;
    if (at.op == Opcode::EagerAnd) return left == 0 ? 0 : right;
    if (at.op == Opcode::EagerOr) return left != 0 ? 1 : right;
    if (at.op == Opcode::EagerChoice) return left != 0 ? right : registers[at.c];
    if (right == undefined) return undefined;
    switch (at.op) {
    case Opcode::EagerEqual: return left == right;
    case Opcode::EagerUnequal: return left != right;
    case Opcode::EagerLess: return left < right;
    case Opcode::EagerLessEqual: return left <= right;
    default: unreachable();
    }
}

}  // namespace

void Forks::begin(std::size_t words, std::size_t below, std::size_t registers) {
    size_ = words;
    below_ = below;
    registers_ = below + registers;
    places_.clear();
    words_.clear();
    values_.clear();
}

void Forks::push(std::uint32_t place, const Word* words, const std::int64_t* registers, std::uint32_t set, Word rest) {
    places_.push_back(place);
    words_.insert(words_.end(), words, words + size_);
    values_.insert(values_.end(), registers - below_, registers - below_ + registers_);
    values_[values_.size() - registers_ + below_ - set] = static_cast<std::int64_t>(rest);
}

std::uint32_t Forks::pop(Word* words, std::int64_t* registers) {
    std::copy_n(words_.end() - static_cast<std::ptrdiff_t>(size_), size_, words);
    std::copy_n(values_.end() - static_cast<std::ptrdiff_t>(registers_), registers_, registers - below_);
    words_.resize(words_.size() - size_);
    values_.resize(values_.size() - registers_);
    const std::uint32_t place = places_.back();
    places_.pop_back();
    return place;
}

ExecutionResult run(const Program& program, std::uint32_t start, Word* words, std::int64_t* registers, Forks* forks) {
    const Instruction* const code = program.code.data();
    std::uint32_t place = start;
    for (;;) {
        const Instruction& at = code[place];
        switch (at.op) {
        case Opcode::Yes: return {End::Yes, place};
        case Opcode::No: return {End::No, place};
        case Opcode::Test: place = (words[at.word] & at.mask) == at.value ? at.yes : at.no; break;
        case Opcode::Within:
            place = ((words[at.word] & at.mask) >> at.shift) - at.value <= at.span ? at.yes : at.no;
            break;
        case Opcode::Patch:
            words[at.word] = (words[at.word] & at.mask) | at.value;
            place = at.yes;
            break;
        case Opcode::Cap: {
            const Word raw = (words[at.word] & at.mask) >> at.shift;
            if (raw > at.value) words[at.word] = (words[at.word] & ~at.mask) | (at.value << at.shift);
            place = at.yes;
            break;
        }
        case Opcode::Load:
            registers[at.to] = static_cast<std::int64_t>(((words[at.word] & at.mask) >> at.shift) + at.value);
            place = at.yes;
            break;
        case Opcode::Constant:
            registers[at.to] = static_cast<std::int64_t>(at.value);
            place = at.yes;
            break;
        case Opcode::Add:
        case Opcode::Subtract:
        case Opcode::Multiply:
        case Opcode::Divide:
        case Opcode::Modulo:
        case Opcode::Negate:
            registers[at.to] = arithmetic(at.op, registers[at.a], registers[at.b]);
            place = at.yes;
            break;
        case Opcode::Equal:
        case Opcode::Less:
        case Opcode::LessEqual: {
            const std::int64_t left = registers[at.a];
            const std::int64_t right = registers[at.b];
            if (left == undefined || right == undefined) return {End::NoValue, place};
            const bool holds = at.op == Opcode::Equal  ? left == right
                               : at.op == Opcode::Less ? left < right
                                                       : left <= right;
            place = holds ? at.yes : at.no;
            break;
        }
        case Opcode::Truth:
            if (registers[at.a] == undefined) return {End::NoValue, place};
            place = registers[at.a] != 0 ? at.yes : at.no;
            break;
        case Opcode::EagerNot:
        case Opcode::EagerAnd:
        case Opcode::EagerOr:
        case Opcode::EagerEqual:
        case Opcode::EagerUnequal:
        case Opcode::EagerLess:
        case Opcode::EagerLessEqual:
        case Opcode::EagerChoice:
            registers[at.to] = eager_value(at, registers);
            place = at.yes;
            break;
        case Opcode::Choose: {
            std::int64_t& set = *(registers - at.to);
            const Word possible = static_cast<Word>(set);
            const Word within = possible & at.value;
            if (within == 0 || within == possible) {
                place = within == 0 ? at.no : at.yes;
                break;
            }
            forks->push(at.no, words, registers, at.to, possible & ~at.value);
            set = static_cast<std::int64_t>(within);
            place = at.yes;
            break;
        }
        case Opcode::Store: {
            if (registers[at.a] == undefined) return {End::NoValue, place};
            const Word raw = static_cast<Word>(registers[at.a]) - at.value;
            if (raw > at.span) return {End::OutOfRange, place};
            words[at.word] = (words[at.word] & ~at.mask) | (raw << at.shift);
            place = at.yes;
            break;
        }
        }
    }
}

Instruction field_within(const Field& field, std::int64_t low, std::int64_t high, std::uint32_t yes, std::uint32_t no) {
    return {.mask = field.mask(),
            .value = static_cast<Word>(low),
            .span = static_cast<Word>(high - low),
            .yes = yes,
            .no = no,
            .word = field.word,
            .shift = field.shift,
            .op = Opcode::Within};
}

}  // namespace grafverif::timed
