// SPDX-License-Identifier: MIT
// Runs the program in-process, in a separate folder for each test.
#pragma once

#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.hpp"

namespace grafverif::app {

namespace fs = std::filesystem;

inline const fs::path root = GRAFVERIF_SOURCE_DIR;
inline const std::string station = (root / "samples/testing_station/testing_station.grafcet").string();

struct Result {
    ExitCode code = ExitCode::Failure;
    std::string out = {}, err = {};
};

/// Runs the program. `input` is the simulated keyboard input.
inline Result grafverif(const std::vector<std::string>& arguments, const std::string& input = "") {
    std::istringstream in(input);
    std::ostringstream out, err;
    const ExitCode code = run(arguments, {in, out, err});
    return {code, out.str(), err.str()};
}

/// True if this process has no child processes left, including zombies.
inline bool no_child() { return ::waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD; }

/// A folder for one test, which the destructor removes.
class Folder {
public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "grafverif-test-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return file(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream in(path_ / name, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    }
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::recursive_directory_iterator(path_), fs::recursive_directory_iterator()));
    }

private:
    fs::path path_ = {};
};

/// Sets an environment variable for the lifetime of the object.
class Variable {
public:
    Variable(std::string name, const std::string& value) : name_(std::move(name)) {
        if (const char* const before = std::getenv(name_.c_str())) before_ = before;
        ::setenv(name_.c_str(), value.c_str(), 1);
    }
    ~Variable() {
        if (before_) ::setenv(name_.c_str(), before_->c_str(), 1);
        else ::unsetenv(name_.c_str());
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    std::string name_;
    std::optional<std::string> before_ = {};
};

/// Sets the PATH for the lifetime of the object.
class Path : public Variable {
public:
    explicit Path(const std::string& value) : Variable("PATH", value) {}
};

}  // namespace grafverif::app
