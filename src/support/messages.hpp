// SPDX-License-Identifier: MIT
// Texts of all diagnostics, with one function per message, so that all texts can be reviewed in one place. Messages are
// in lower case and put names in backticks. A message states the problem first and, after `; `, the remedy.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "grafverif/support/diagnostic.hpp"

namespace grafverif::messages {

// -- the command line and files ------------------------------------------------------------------------------------
Diagnostic cannot_read(std::string_view path, std::string_view why);
Diagnostic io_error(std::string_view what);
Diagnostic cannot_listen(std::uint64_t port, std::string_view why);
Diagnostic output_is_input(std::string_view output, std::string_view input);
Diagnostic output_twice(std::string_view one, std::string_view other);
Diagnostic no_closed_loop();
Diagnostic missing_folder(std::string_view output, std::string_view folder);
Diagnostic not_in_depfile(std::string_view name, std::string_view reader);
/// Warning: the checked model differs from the file, because an option disables the correction `cure` of the method.
Diagnostic ablation_active(std::string_view cure);
/// Reports that a requested external engine is not installed. `instead` contains the options that select an embedded
/// engine.
Diagnostic missing_program(std::string_view program, std::string_view instead);
Diagnostic no_such_choice(std::string_view kind, std::string_view name, std::span<const std::string> known);
Diagnostic ambiguous_choice(std::string_view kind, std::string_view option, std::span<const std::string> known);
Diagnostic beyond_32_bits(Span where, std::string_view what, std::string_view target);
Diagnostic not_expressible(Span property, std::string_view name, std::string_view target, std::string_view reason);

// -- reading ---------------------------------------------------------------------------------------------------------
// (src/support/messages_language.cpp)
Diagnostic file_too_large(Span where, std::size_t mebibytes);
Diagnostic utf16(Span where);
Diagnostic invalid_utf8(Span where, unsigned char byte);
Diagnostic read_as_latin(Span where);
Diagnostic unexpected_character(Span where, std::string_view character);
Diagnostic unterminated(Span where, std::string_view what, std::string_view end);
Diagnostic unknown_unit(Span where, std::string_view text);
Diagnostic bad_duration(Span where, std::string_view text);
Diagnostic decimal_number(Span where, std::string_view text);
Diagnostic number_too_large(Span where);
Diagnostic name_too_long(Span where, std::string_view name, std::size_t limit);
Diagnostic too_deep(Span where, std::size_t limit);
Diagnostic empty_replication(Span where, std::string_view index, std::int64_t low, std::int64_t high);
Diagnostic expansion_too_large(Span where, std::size_t limit);
/// A note that names a copy of a replicated declaration. `values` contains the values of its index variables, such as
/// `i = 3`.
Diagnostic in_copy(Span where, std::string_view values);
Diagnostic in_instance(Span where, std::string_view instance, std::string_view values);
Diagnostic other_spelling(Span where, std::string_view seen, std::string_view meant);
Diagnostic single_equals(Span where, std::string_view what, std::string_view meant);
Diagnostic missing_semicolon(Span where);
Diagnostic unexpected(Span where, std::string_view seen, std::string_view expected);
Diagnostic unexpected_end(Span where, std::string_view expected);
// (src/support/messages_names.cpp)
/// `kind` is `variable`, `step`, `component`, ...; `suggestion` is the nearest known name, or empty.
Diagnostic unknown(Span where, std::string_view kind, std::string_view name, std::string_view suggestion);
Diagnostic unknown_component(Span where, std::string_view name, std::string_view suggestion, std::string_view known);
Diagnostic unknown_location(Span where, std::string_view name, std::string_view suggestion, std::string_view component,
                            std::string_view locations);
Diagnostic duplicate_name(Span where, std::string_view kind, std::string_view name, Span first);
Diagnostic declared_in_copies(Span where, std::string_view kind, std::string_view name);
Diagnostic index_hides(Span where, std::string_view index, Span other);
Diagnostic ambiguous(Span where, std::string_view name, std::string_view one, std::string_view other);
Diagnostic step_like_variable(Span where, std::string_view name);
Diagnostic shadows_library(Span where, std::string_view name);
Diagnostic include_cycle(Span where, std::string_view path);
Diagnostic cannot_include(Span where, std::string_view path, std::string_view why);
Diagnostic not_yet(Span where, std::string_view what);

// (src/support/messages_types.cpp)
/// `written` is the duration as written in the file, such as `3s`.
Diagnostic duration_below(Span where, std::string_view op, std::string_view written);
Diagnostic type_mismatch(Span where, std::string_view user, std::string_view expected, std::string_view found);
Diagnostic missing_unit(Span where, std::string_view what);
Diagnostic division_by_zero(Span where);
Diagnostic not_constant(Span where, std::string_view what);
Diagnostic reads_parameter(Span where, std::string_view what, std::string_view parameter);
Diagnostic out_of_range(Span where, std::string_view variable, std::int64_t value, std::int64_t low, std::int64_t high);
Diagnostic unbounded_integer(Span where, std::string_view variable);
Diagnostic misplaced_type(Span where, std::string_view what);
Diagnostic misplaced_value(Span where, std::string_view kind);
Diagnostic zero_duration(Span where);
Diagnostic bad_task_cycle(Span where, std::int64_t least_ms, std::int64_t most_ms);
Diagnostic cycle_without_time(Span where, std::string_view controller);
Diagnostic bad_count(Span where, std::int64_t count, std::int64_t greatest);
Diagnostic missing_count(Span where);

// (src/support/messages_chart.cpp)
Diagnostic empty_chart(Span where, std::string_view chart);
Diagnostic no_initial_step(Span where, std::string_view chart);
Diagnostic no_activation_link(Span where, std::string_view chart);
Diagnostic unreachable_step(Span where, std::string_view step, std::size_t others);
Diagnostic missing_condition(Span where);
Diagnostic detached_transition(Span where);
Diagnostic step_twice(Span where, std::string_view step);
Diagnostic step_of_other_chart(Span where, std::string_view step, std::string_view chart);
Diagnostic not_an_output(Span where, std::string_view variable, std::string_view kind);
Diagnostic assigned_input(Span where, std::string_view variable);
Diagnostic continuous_and_stored(Span where, std::string_view output, Span other);
Diagnostic missing_event(Span where);
Diagnostic not_an_expansion(Span where, std::string_view chart);
Diagnostic owned_twice(Span where, std::string_view chart, Span first);
Diagnostic unused_expansion(Span where, std::string_view chart);
Diagnostic entry_and_exit(Span where, std::string_view chart);
Diagnostic constraint_not_on_inputs(Span where, std::string_view other);
Diagnostic misplaced_mark(Span where, std::string_view mark, std::string_view place);

// (src/support/messages_test.cpp)
/// `what` is the construct that Structured Text or C cannot compute exactly.
Diagnostic not_in_structured_text(Span where, std::string_view what);
Diagnostic not_in_c(Span where, std::string_view what);
Diagnostic cannot_run(std::string_view command);
Diagnostic nothing_to_test(Span where, std::string_view chart, std::string_view what);
Diagnostic empty_test(Span where);
Diagnostic unknown_column(Span where, std::string_view name, std::string_view chart);
Diagnostic missing_column(Span where, std::string_view kind, std::string_view name);
Diagnostic repeated_column(Span where, std::string_view name);
Diagnostic row_length(Span where, std::size_t found, std::size_t wanted);
/// `problem` describes the error in a field of a test table.
Diagnostic bad_field(Span where, std::string_view problem);
Diagnostic misplaced_wait(Span where, bool first);
Diagnostic misplaced_activation(Span where);

// (src/support/messages_component.cpp)
Diagnostic constant_cycle(Span where, std::string_view constant);
Diagnostic clock_not_conjunct(Span where);
Diagnostic clock_compared_with_clock(Span where);
Diagnostic clock_not_equal(Span where);
Diagnostic clock_reset(Span where, std::string_view clock);
Diagnostic urgent_clock_guard(Span where);
Diagnostic lower_bound_invariant(Span where);
Diagnostic invariant_without_clock(Span where);
Diagnostic assigned_constant(Span where, std::string_view name, std::string_view kind);
Diagnostic assigned_twice(Span where, std::string_view name);
Diagnostic two_initial_locations(Span where, std::string_view component, Span first);
Diagnostic empty_component(Span where, std::string_view component);
Diagnostic edge_outside_chart(Span where);

// (src/support/messages_loop.cpp)
Diagnostic missing_argument(Span where, std::string_view component, std::string_view parameter,
                            std::string_view example);
Diagnostic output_not_a_name(Span where, std::string_view parameter);
Diagnostic port_not_a_variable(Span where, std::string_view port);
Diagnostic bound_twice(Span where, std::string_view variable, std::string_view first, std::string_view second);
Diagnostic partial_in_partial(Span where, std::string_view chart);
/// The term of an input contains a name to which an instance cannot be connected. `what` describes the named element,
/// for example `a step`.
Diagnostic no_signal(Span where, std::string_view name, std::string_view what);
Diagnostic constant_without_value(Span where, std::string_view constant);
Diagnostic constant_below(Span where, std::string_view constant);
/// `kind` describes the expected value, for example `an integer`.
Diagnostic bad_setting(Span where, std::string_view constant, std::string_view value, std::string_view kind);
Diagnostic setting_out_of_range(Span where, std::string_view constant, std::string_view value, std::int64_t low,
                                std::int64_t high);
Diagnostic missing_initially(Span where, std::string_view component, std::string_view locations);
/// `loop` is the complete loop, including its closing brace.
Diagnostic undriven_input(Span where, std::string_view input, std::string_view reader, bool boolean, Span loop);
Diagnostic undriven_variable(Span where, std::string_view variable, std::string_view suggestion);
Diagnostic argument_type(Span where, std::string_view name, std::string_view found, std::string_view expected);
Diagnostic range_mismatch(Span where, std::string_view name, std::int64_t low, std::int64_t high,
                          std::int64_t wanted_low, std::int64_t wanted_high);
Diagnostic no_controller(Span where, std::string_view loop);
Diagnostic clock_in_property(Span where, std::string_view clock);
Diagnostic place_outside_property(Span where);
/// `waited` contains the durations of all time conditions in charts of the loop that observe the same term.
Diagnostic unknown_time(Span where, const std::vector<std::string>& waited);
Diagnostic ambiguous_time(Span where, std::string_view first, std::string_view second);
/// `language` is, for example, `CTL`; `what` is the error in the text at `where`.
Diagnostic bad_formula(Span where, std::string_view language, std::string_view what);
Diagnostic formula_at_stable(Span where);
Diagnostic declared_twice(Span where, std::string_view what);
/// `what` is the expected element, for example `input of a controller`.
Diagnostic constraint_reads(Span where, std::string_view name, std::string_view what);
Diagnostic observer_blocks(Span where, std::string_view observer);
Diagnostic observer_acts(Span where, std::string_view observer);
Diagnostic observer_without_start(Span where, std::string_view observer);

// -- import (src/support/messages_import.cpp) -------------------------------------------------------------------------
Diagnostic broken_xml(Span where, std::string_view why);
Diagnostic elements_too_deep(Span where, std::size_t limit);
Diagnostic declared_entities(Span where);
Diagnostic unknown_encoding(Span where, std::string_view encoding);
Diagnostic unknown_format(Span where, std::string_view root);
/// `kind` is `step`, `variable declaration`, ...
Diagnostic dangling_reference(Span where, std::string_view reference, std::string_view kind);
Diagnostic missing_part(Span where, std::string_view element, std::string_view part);
Diagnostic bad_value(Span where, std::string_view what, std::string_view value, std::string_view expected);
/// `what` is, for example, "this arc leads from a step to a step".
Diagnostic misplaced_link(Span where, std::string_view what, std::string_view hint);
Diagnostic cannot_import(Span where, std::string_view what, std::string_view hint);
Diagnostic left_out(Span where, std::string_view what);
Diagnostic renamed(Span where, std::string_view name, std::string_view now);
Diagnostic chosen_range(Span where, std::string_view variable, std::int64_t low, std::int64_t high,
                        std::string_view why);
Diagnostic without_effect(Span where, std::string_view what, std::string_view hint);
Diagnostic chosen_kind(Span where, std::string_view variable, std::string_view kind, std::string_view why);
Diagnostic mixed_actions(Span where, std::string_view output, std::string_view stored);
Diagnostic explicit_priority(Span where, std::string_view step, std::size_t branches);
Diagnostic differs_from_sfc(Span where, std::string_view what);
Diagnostic already_internal(Span where);
Diagnostic nothing_to_import(Span where, std::string_view what);
Diagnostic program_is_no_chart(Span where, std::string_view name);
// (src/support/messages_findings.cpp)
Diagnostic bad_exclusion_header(Span where);
Diagnostic bad_exclusion(Span where, std::size_t fields);
Diagnostic not_a_boolean_input(Span where, std::string_view name, std::string_view chart);
Diagnostic excludes_itself(Span where, std::string_view name);
Diagnostic unknown_finding(Span where, std::string_view code);

// -- derive ----------------------------------------------------------------------------------------------------------
Diagnostic enclosing_cycle(Span where, std::string_view chart);
Diagnostic forcing_cycle(Span where, std::string_view chart);
/// The chart forces both an expansion and the partial chart `with` that contains its macro-step, although a forcing
/// order for `with` also forces this expansion.
Diagnostic forced_beside(Span where, std::string_view expansion, std::string_view with, Span first);
Diagnostic forced_twice(Span where, std::string_view chart, Span first);
Diagnostic edge_under_time(Span where);
Diagnostic edge_of_edge(Span where);
Diagnostic edge_in_assignation(Span where, std::string_view output);
Diagnostic event_without_edge(Span where, std::string_view target);
/// Each element of `outputs` reads the next element, and the last element reads the first element.
Diagnostic output_cycle(Span where, std::span<const std::string> outputs);
Diagnostic term_too_large(Span where, std::string_view what, std::size_t limit);
Diagnostic term_too_deep(Span where, std::string_view what, std::size_t limit);
Diagnostic terms_too_large(Span where, std::string_view grafcet, std::size_t limit);
Diagnostic too_many_stored_values(Span where, std::string_view variable, std::size_t limit);

// -- plant and compose ------------------------------------------------------------------------------------------------
Diagnostic no_multiple_of_time_unit(Span where, std::int64_t milliseconds, std::int64_t unit_ms);
Diagnostic duration_too_long(Span where, std::int64_t milliseconds, std::int64_t unit_ms);
Diagnostic many_time_units(Span where, std::int64_t milliseconds, std::int64_t unit_ms);
Diagnostic no_value(Span where, std::string_view instance);
Diagnostic bad_range(Span where, std::string_view variable, std::int64_t low, std::int64_t high);
Diagnostic initial_out_of_range(Span where, std::string_view variable, std::int64_t initial, std::int64_t low,
                                std::int64_t high);
Diagnostic second_writer(Span where, std::string_view variable, std::string_view first, std::string_view second);
Diagnostic urgent_invariant(Span where, std::string_view component, std::string_view location);
Diagnostic range_skipped(Span where, std::string_view variable, std::string_view mover, std::int64_t step,
                         std::string_view detector, std::int64_t low, std::int64_t high);

// -- conform ----------------------------------------------------------------------------------------------------------
// (src/support/messages_conform.cpp)
Diagnostic excludes_every_input(Span where);
/// `cycle` contains the situations that repeat forever.
Diagnostic initial_never_stable(Span where, std::string_view inputs, std::string_view cycle);
/// `when` is the situation with the inputs, for example `{2,5} with s, not h1`.
Diagnostic action_race(Span where, std::string_view variable, std::string_view when);
Diagnostic forcing_race(Span where, std::string_view when);
Diagnostic no_value_in_location(Span where, std::string_view when);
Diagnostic out_of_range_in_location(Span where, std::string_view variable, std::int64_t value, std::string_view when);
Diagnostic too_many_locations(Span where, std::uint64_t limit);
Diagnostic too_many_pairs(Span where, std::size_t states, std::uint64_t limit);
Diagnostic too_many_nodes(std::size_t nodes, std::size_t limit);
Diagnostic too_many_states(Span where, std::uint64_t limit);
Diagnostic automaton_too_large(Span where);
/// `by_user` is true if the user stopped the run, false if the time limit was reached.
Diagnostic stopped(Span where, bool by_user);
// Messages about a run that ended early for a reason outside the model. After each of these messages, the program ends
// with exit code 3.
Diagnostic timed_out(std::uint64_t milliseconds);
Diagnostic interrupted();
Diagnostic out_of_memory(std::optional<std::uint64_t> allowed);
/// The number of input combinations, 2^`bits`, is larger than a complete tour can cover.
Diagnostic too_many_inputs(Span where, std::string_view chart, std::size_t bits, std::size_t limit);

// -- schedule and emit ------------------------------------------------------------------------------------------------
// (src/support/messages_loop.cpp)
/// `decided` is true if the contradiction is proved. If `decided` is false, the search for inputs that satisfy the
/// constraints reached the memory limit.
Diagnostic constraints_contradict(Span where, std::string_view constraint, bool decided);
Diagnostic too_wide(Span where, std::string_view variable, std::int64_t values, std::int64_t most);

}  // namespace grafverif::messages
