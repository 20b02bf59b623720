// SPDX-License-Identifier: MIT
// Interprets runs of the observer automata that compose/observer.cpp defines. The names of locations must agree with
// the names in compose/observer.cpp.
#include "explain/violation.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafverif {

namespace {

using Kind = Sentence::Kind;
using Scope = Sentence::Scope;

/// The observer enters `location` when it checks the state after event `moment`.
struct Entry {
    std::string location = {};
    std::size_t moment = 0;
};

std::vector<Entry> entries_of(const ChartRun& run, Id<ChartRun::Instance> observer) {
    std::vector<Entry> entries;
    std::size_t checked = 0;
    for (std::size_t k = 0; k < run.moments.size(); ++k) {
        const ChartRun::Event& moment = run.moments[k];
        if (moment.kind != ChartRun::Kind::Observer) checked = k;
        if (moment.instance == observer && moment.location)
            entries.push_back({run.instances[observer].locations[*moment.location], checked});
    }
    return entries;
}

class Explanation {
public:
    Explanation(const Sentence& sentence, const std::vector<std::string>& terms, const ChartRun& run,
                std::vector<Entry> entries)
        : sentence_(sentence), run_(run), entries_(std::move(entries)) {
        for (const std::string& term : terms) terms_.push_back('`' + term + '`');
    }

    /// Returns the violation, or nothing if the observer does not fail.
    std::optional<SentenceViolation> made() {
        const std::size_t failed = last("failed"), spoilt = last("spoilt"), due = last("due");
        fails_ = failed < entries_.size();
        if (!fails_ && (due >= entries_.size() || due + 1 != entries_.size())) return {};
        bad_ = spoilt < entries_.size() ? spoilt : fails_ ? failed : due;
        add_opening();
        add_body();
        const bool closes = sentence_.scope == Scope::Before || sentence_.scope == Scope::Between;
        if (fails_ && closes && !closed_) add_closing(failed);
        made_.moment = entries_[bad_].moment;
        return std::move(made_);
    }

private:
    /// Returns the index of the last entry into a location, or the number of entries if the location was never entered.
    std::size_t last(std::string_view location) const {
        for (std::size_t k = entries_.size(); k-- > 0;)
            if (entries_[k].location == location) return k;
        return entries_.size();
    }
    /// Returns the event of an entry, or 0 (the start of the observer) if the location was never entered.
    std::size_t moment(std::size_t entry) const { return entry < entries_.size() ? entries_[entry].moment : 0; }
    std::int64_t time(std::size_t entry) const { return run_.moments[moment(entry)].after.time_ms; }
    std::string text_of(std::int64_t time) const {
        return run_.timed ? seconds_text(time) : fmt::format("step {}", time);
    }
    std::string when(std::size_t entry) const { return " at " + text_of(time(entry)); }
    std::string deadline(std::size_t from) const { return text_of(time(from) + sentence_.duration_ms); }
    /// Returns operand `number` of the scope of the sentence, such as q in `after q`.
    const std::string& bound(std::size_t number) const {
        const bool binary = sentence_.kind == Kind::Response || sentence_.kind == Kind::Precedence;
        return terms_[(binary ? 2 : 1) + number];
    }
    /// Returns the operand of the sentence that closes the scope, such as s in `between r and s`.
    const std::string& closing() const { return bound(sentence_.scope == Scope::Before ? 0 : 1); }

    void add(std::size_t entry, std::string words) { made_.steps.push_back({moment(entry), std::move(words)}); }
    void add(std::string words) { made_.steps.push_back({{}, std::move(words)}); }

    void add_closing(std::size_t entry) {
        add(entry, closing() + when(entry));
        closed_ = true;
    }

    /// Adds the explanation step for the event at which the violated scope begins.
    void add_opening() {
        if (sentence_.scope == Scope::Globally || sentence_.scope == Scope::Before) return;
        const std::size_t outside = last(sentence_.kind == Kind::Existence ? "idle" : "outside");
        opening_ = outside < entries_.size() ? outside + 1 : 0;
        add(opening_, bound(0) + when(opening_));
    }

    void add_body() {
        const std::string& p = terms_[0];
        switch (sentence_.kind) {
        case Kind::Absence: return add(bad_, p + when(bad_));
        case Kind::Universality: return add(bad_, p + " false" + when(bad_));
        case Kind::Existence:
            if (fails_) add_closing(bad_);
            return add(p + (fails_ ? " not true by then" : " never true after that"));
        case Kind::Response: return add_response();
        case Kind::Precedence: add(bad_, terms_[1] + when(bad_)); return add(p + " not true before");
        case Kind::HoldsFor: {
            const std::size_t on = last("on");
            add(on, fmt::format("{} from {}", p, text_of(time(on))));
            add("required until " + deadline(on));
            return add(bad_, "false" + when(bad_));
        }
        case Kind::HoldsAtMost:
        case Kind::Recurrence: {
            const bool holds = sentence_.kind == Kind::HoldsAtMost;
            const std::size_t from = last(holds && sentence_.scope == Scope::Globally ? "on" : "due");
            add(from, fmt::format("{}{} from {}", holds ? "" : "no ", p, text_of(time(from))));
            add("deadline " + deadline(from));
            return add(bad_, p + (holds ? " still true after the deadline" : " not true by then"));
        }
        case Kind::Since:
            if (const std::size_t after = last("after"); after < entries_.size()) {
                add(after, terms_[1] + " false from " + text_of(time(after)) + " on");
                add(fmt::format("{} allowed until {}", p, deadline(after)));
                return add(bad_, p + when(bad_));
            }
            add(bad_, p + when(bad_));
            return add(terms_[1] + " not true before");
        case Kind::Occurrences: return add_occurrences();
        }
    }

    void add_response() {
        const std::size_t due = last("due");
        add(due, terms_[0] + when(due));
        if (!fails_) return add(terms_[1] + " never true after that");
        const bool expired = sentence_.duration_ms > 0 && time(bad_) > time(due) + sentence_.duration_ms;
        if (expired) add("deadline " + deadline(due));
        else add_closing(bad_);
        add(bad_, terms_[1] + " not true by then");
    }

    /// Adds an explanation step for each event at which the operand becomes true in the scope. If there are many
    /// events, adds only the first and the last.
    void add_occurrences() {
        constexpr std::size_t most = 6;
        std::vector<std::size_t> times;
        for (std::size_t k = opening_; k < bad_; ++k)
            if (entries_[k].location.starts_with("on_")) times.push_back(k);
        if (times.size() > most) {
            add(times.front(),
                fmt::format("{} {} times from {}", terms_[0], times.size(), text_of(time(times.front()))));
            times.clear();
        }
        times.push_back(bad_);
        for (const std::size_t k : times) add(k, terms_[0] + when(k));
        add(fmt::format("more than {}", sentence_.count == 1 ? "once" : fmt::format("{} times", sentence_.count)));
    }

    const Sentence& sentence_;
    const ChartRun& run_;
    std::vector<Entry> entries_;
    std::vector<std::string> terms_ = {};  ///< operands of the sentence, each between backticks
    bool fails_ = false;                   ///< false if a required event never occurs
    bool closed_ = false;                  ///< true if the explanation includes the end of the scope

    /// Indices of the entries for the violation and for the opening of the scope.
    std::size_t bad_ = 0, opening_ = 0;
    SentenceViolation made_ = {};
};

}  // namespace

std::string SentenceViolation::words() const {
    std::string text;
    for (const Step& step : steps) text += (text.empty() ? "" : "; ") + step.words;
    return text;
}

std::optional<SentenceViolation> violation_of(const Sentence& sentence, const std::vector<std::string>& terms,
                                              const ChartRun& run) {
    for (const Id<ChartRun::Instance> id : run.instances.ids())
        if (run.instances[id].kind == ChartRun::Kind::Observer)
            return Explanation(sentence, terms, run, entries_of(run, id)).made();
    return {};
}

}  // namespace grafverif
