// SPDX-License-Identifier: MIT
// Executes compiled code. The only state of the loop is the instruction, so its speed depends on branch prediction
// alone.
#include "check/timed/program.hpp"

#include "support/overloaded.hpp"

namespace grafverif::timed {

namespace {

std::int64_t arithmetic(Do op, std::int64_t left, std::int64_t right) {
    if (left == undefined || right == undefined) return undefined;
    std::int64_t result = 0;
    bool overflow = false;
    switch (op) {
    case Do::Add: overflow = __builtin_add_overflow(left, right, &result); break;
    case Do::Subtract: overflow = __builtin_sub_overflow(left, right, &result); break;
    case Do::Multiply: overflow = __builtin_mul_overflow(left, right, &result); break;
    case Do::Divide: return right == 0 ? undefined : left / right;
    case Do::Modulo: return right == 0 ? undefined : left % right;
    case Do::Negate: return -left;
    default: unreachable();
    }
    return overflow ? undefined : result;
}

/// The operators of `eager` code; And and Or evaluate the right operand only if the left one does not decide.
std::int64_t eager_value(const Instruction& at, const std::int64_t* registers) {
    const std::int64_t left = registers[at.a];
    const std::int64_t right = registers[at.b];
    if (left == undefined) return undefined;
    if (at.op == Do::EagerNot) return left == 0;
    if (at.op == Do::EagerAnd) return left == 0 ? 0 : right;
    if (at.op == Do::EagerOr) return left != 0 ? 1 : right;
    if (at.op == Do::EagerChoice) return left != 0 ? right : registers[at.c];
    if (right == undefined) return undefined;
    switch (at.op) {
    case Do::EagerEqual: return left == right;
    case Do::EagerUnequal: return left != right;
    case Do::EagerLess: return left < right;
    case Do::EagerLessEqual: return left <= right;
    default: unreachable();
    }
}

}  // namespace

Ran run(const Program& program, std::uint32_t start, Word* words, std::int64_t* registers) {
    const Instruction* const code = program.code.data();
    std::uint32_t place = start;
    for (;;) {
        const Instruction& at = code[place];
        switch (at.op) {
        case Do::Yes: return {End::Yes, place};
        case Do::No: return {End::No, place};
        case Do::Test: place = (words[at.word] & at.mask) == at.value ? at.yes : at.no; break;
        case Do::Within: place = ((words[at.word] & at.mask) >> at.shift) - at.value <= at.span ? at.yes : at.no; break;
        case Do::Patch:
            words[at.word] = (words[at.word] & at.mask) | at.value;
            place = at.yes;
            break;
        case Do::Cap: {
            const Word raw = (words[at.word] & at.mask) >> at.shift;
            if (raw > at.value) words[at.word] = (words[at.word] & ~at.mask) | (at.value << at.shift);
            place = at.yes;
            break;
        }
        case Do::Load:
            registers[at.to] = static_cast<std::int64_t>(((words[at.word] & at.mask) >> at.shift) + at.value);
            place = at.yes;
            break;
        case Do::Constant:
            registers[at.to] = static_cast<std::int64_t>(at.value);
            place = at.yes;
            break;
        case Do::Add:
        case Do::Subtract:
        case Do::Multiply:
        case Do::Divide:
        case Do::Modulo:
        case Do::Negate:
            registers[at.to] = arithmetic(at.op, registers[at.a], registers[at.b]);
            place = at.yes;
            break;
        case Do::Equal:
        case Do::Less:
        case Do::LessEqual: {
            const std::int64_t left = registers[at.a];
            const std::int64_t right = registers[at.b];
            if (left == undefined || right == undefined) return {End::NoValue, place};
            const bool holds = at.op == Do::Equal ? left == right : at.op == Do::Less ? left < right : left <= right;
            place = holds ? at.yes : at.no;
            break;
        }
        case Do::Truth:
            if (registers[at.a] == undefined) return {End::NoValue, place};
            place = registers[at.a] != 0 ? at.yes : at.no;
            break;
        case Do::EagerNot:
        case Do::EagerAnd:
        case Do::EagerOr:
        case Do::EagerEqual:
        case Do::EagerUnequal:
        case Do::EagerLess:
        case Do::EagerLessEqual:
        case Do::EagerChoice:
            registers[at.to] = eager_value(at, registers);
            place = at.yes;
            break;
        case Do::Choose: {
            std::int64_t& set = *(registers - at.to);
            const Word possible = static_cast<Word>(set);
            const Word within = possible & at.value;
            if (within == 0 || within == possible) {
                place = within == 0 ? at.no : at.yes;
                break;
            }
            const auto split = static_cast<std::uint64_t>((*(registers - Choices::depth))++);
            const auto path = static_cast<Word>(*(registers - Choices::path - split / 64));
            const bool other = (path >> split % 64 & 1U) != 0;
            set = static_cast<std::int64_t>(other ? possible & ~at.value : within);
            place = other ? at.no : at.yes;
            break;
        }
        case Do::Store: {
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
            .op = Do::Within};
}

}  // namespace grafverif::timed
