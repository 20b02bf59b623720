// SPDX-License-Identifier: MIT
// `init`: creates a complete project, which can be checked, built and tested without changes.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/system/watchdog.hpp"
#include "app/system/write_files.hpp"
#include "support/printable.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::app {

namespace {

namespace fs = std::filesystem;

/// A file of the new project. In `path` and `text`, NAME is a placeholder for the name of the project.
struct ProjectFile {
    std::string path = {}, use = {}, text = {};
};

const std::vector<ProjectFile>& parts() {
    static const std::vector<ProjectFile> all = {
        {"NAME.grafcet", "the closed loop and its properties: start here",
         R"(// The closed loop of NAME: the controller, its plant and the required properties.

include "NAME_controller.grafcet";
include "NAME_slide.grafcet";

closed_loop NAME {
    controller NAME_controller;

    plant Slide = NAME_slide(FORWARD = FORWARD, AT_FRONT = AT_FRONT, AT_BACK = AT_BACK);
    environment Start = push_button(OUT = START);

    property rests "the slide is not driven at rest": never X0 && FORWARD at stable;
    property arrives "a driven slide arrives at the front": X1 leads to AT_FRONT;
    property returns "a slide at the front returns": AT_FRONT leads to AT_BACK;
    property all_steps: reachable all steps;
}
)"},
        {"NAME_controller.grafcet", "the chart",
         R"(// The controller: after START, the slide moves to the front, stays there for one second and returns.

grafcet NAME_controller {
    input START, AT_FRONT, AT_BACK;
    output FORWARD;

    initial step 0;
    step 1 { FORWARD; }
    step 2 { FORWARD; }
    step 3;

    transition t0: 0 -> 1 when START && AT_BACK;
    transition t1: 1 -> 2 when AT_FRONT;
    transition t2: 2 -> 3 when 1s/X2;
    transition t3: 3 -> 0 when AT_BACK;
}
)"},
        {"NAME_slide.grafcet", "a custom component (`grafverif components` lists library components)",
         R"(// A slide: it moves to the front while it is driven; otherwise a spring returns it.
//
// Interface
//   FORWARD   input     moves it to the front
//   AT_FRONT  output    front sensor
//   AT_BACK   output    back sensor, initially true
//   TRAVEL    constant  travel time between the ends, also after a reversal; default 2s
component NAME_slide(input FORWARD; output AT_FRONT, AT_BACK = true; TRAVEL = 2s) {
    clock t;

    initial location back;
    location going invariant t <= TRAVEL;
    location front;
    location coming invariant t <= TRAVEL;

    urgent back -> going when FORWARD do t := 0, AT_BACK := false;
    timed going -> front when t == TRAVEL do AT_FRONT := true;
    urgent going -> coming when !FORWARD do t := 0;

    urgent front -> coming when !FORWARD do t := 0, AT_FRONT := false;
    timed coming -> back when t == TRAVEL do AT_BACK := true;
    urgent coming -> going when FORWARD do t := 0;
}
)"},
        {"CMakeLists.txt", "builds the models and checks the properties with CMake and ctest",
         R"(# cmake -B build && cmake --build build && ctest --test-dir build
cmake_minimum_required(VERSION 3.25)
project(NAME LANGUAGES NONE)
enable_testing()

find_package(grafverif REQUIRED COMPONENTS program)

# Models for UPPAAL and NuSMV, rebuilt when an input file changes.
grafverif_models(TARGET models CHART NAME.grafcet OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/models")

# A test per property.
grafverif_check(NAME NAME CHART NAME.grafcet)
)"},
        {".gitignore", "", "build/\n*.grafverif/\n"},
    };
    return all;
}

std::string named(std::string text, const std::string& name) {
    // In `grafverif_check(NAME NAME ...)`, the first NAME is a keyword of CMake.
    constexpr std::string_view placeholder = "NAME", of_cmake = "(NAME ";
    for (std::size_t at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder, at)) {
        const bool word = at > 0 && text.compare(at - 1, of_cmake.size(), of_cmake) == 0 && text[at + 5] == 'N';
        if (!word) text.replace(at, placeholder.size(), name);
        at += word ? placeholder.size() : name.size();
    }
    return text;
}

/// True if `name` is a valid name of a chart and a loop.
bool is_name(const std::string& name) {
    Sources sources;
    Diagnostics diagnostics;
    const auto source = sources.add({"name", "grafcet " + name + " {}\n"});
    const bool plain = std::ranges::all_of(name, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!plain || name.empty() || name.size() > 100) return false;
    parse_file(source, sources, diagnostics);
    return !diagnostics.has_errors();
}

ExitCode refused(const Streams& streams, const std::string& why) {
    streams.err << fmt::format("grafverif: error: {}\n", printable(why));
    return ExitCode::Input;
}

}  // namespace

ExitCode init(CommandContext& job, const Streams& streams) {
    const bool here = job.options.operands.empty();
    std::error_code failure;
    const std::string name = here ? fs::current_path().filename().string() : job.options.operands[0];
    if (!is_name(name))
        return refused(streams, fmt::format("`{}`{} cannot be the name of a chart (letters, digits and `_`, not a "
                                            "keyword); pass a project name: `grafverif init NAME`",
                                            name, here ? ", the name of the folder," : ""));
    std::vector<OutputFile> files;
    std::string summary = "wrote\n";
    for (const ProjectFile& part : parts()) {
        const fs::path path = (here ? fs::path() : fs::path(name)) / named(part.path, name);
        if (fs::exists(fs::symlink_status(path, failure)))
            return refused(
                streams, fmt::format("`{}` already exists, so nothing was written; remove it or choose another folder",
                                     path.string()));
        files.push_back({path, named(part.text, name)});
        summary += fmt::format("  {}\n{}", path.string(), part.use.empty() ? "" : "      " + part.use + "\n");
    }
    work_is_done();
    write_files(files);
    if (!job.options.quiet)
        job.closing =
            summary + fmt::format("try `{}grafverif check {}.grafcet`\n", here ? "" : "cd " + name + " && ", name);
    return ExitCode::Done;
}

CliCommand init_usage() {
    return {
        "init",
        "[NAME]",
        0,
        1,
        "create a project: chart, component, closed loop with properties, CMake",
        "Writes a small project into the new folder NAME: a chart, a custom component, a closed loop of both with\n"
        "properties that hold, a CMakeLists.txt with one test per property, and a .gitignore. Without NAME, the\n"
        "project is written into the current folder and has the name of this folder. Nothing is overwritten: if one\n"
        "of the files exists, nothing is written.",
        {"grafverif init press", "cd press && grafverif check press.grafcet"},
        {}};
}

}  // namespace grafverif::app
