// SPDX-License-Identifier: MIT
// A chart, and a document with the text that a test expects after operations.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "edit/document.hpp"

namespace grafverif::edit {

inline constexpr const char* lamp = R"(// A lamp.
grafcet lamp {
    input ON, OFF;
    output LAMP, FAN;

    initial step 0;  // dark
    // The lamp is on.
    step 1 { LAMP; }  // bright
    step 2 {
        FAN;  // cools
        LAMP if ON;
    }

    transition on: 0 -> 1 when ON;  // pressed
    transition t2: 1 -> 2 when 3s/X1;
    // Back to the beginning.
    transition off: 2 -> 0 when OFF && !ON;
}
)";

/// A document and the text that a test expects, in which parts of the text are replaced.
class Editing {
public:
    explicit Editing(std::string text) : document("/nowhere/chart.grafcet", {}, text), expected(std::move(text)) {}

    std::uint32_t at(const std::string& part) const {
        const std::size_t place = document.text().find(part);
        EXPECT_NE(place, std::string::npos) << part;
        return static_cast<std::uint32_t>(place);
    }
    Change change(OperationKind kind, const std::string& part, const std::string& text = "",
                  const std::string& target = "") {
        Operation operation{kind, at(part), {}, text};
        if (!target.empty()) operation.target = at(target);
        const std::string before = document.text();
        const std::string tried = document.perform(operation, true).obstacle;
        EXPECT_EQ(document.text(), before) << "a trial does not change the text";
        Change made = document.perform(operation);
        EXPECT_EQ(made.obstacle, tried);
        if (made.obstacle.empty()) {
            const std::string after = document.text();
            document.undo();
            EXPECT_EQ(document.text(), before);
            document.redo();
            EXPECT_EQ(document.text(), after);
        } else {
            EXPECT_EQ(document.text(), before);
        }
        return made;
    }
    /// Executes an operation, which must be possible.
    void perform(OperationKind kind, const std::string& part, const std::string& text = "",
                 const std::string& target = "") {
        const Change made = change(kind, part, text, target);
        EXPECT_EQ(made.obstacle, "") << made.diagnostics;
        selected = made.selected ? document.text().substr(*made.selected, 12) : "";
    }
    std::string obstacle(OperationKind kind, const std::string& part, const std::string& text = "",
                         const std::string& target = "") {
        return change(kind, part, text, target).obstacle;
    }
    /// Expects that `before` has been replaced by `after`.
    Editing& expect(const std::string& before, const std::string& after) {
        const std::size_t place = expected.find(before);
        EXPECT_NE(place, std::string::npos) << before;
        if (place != std::string::npos) expected.replace(place, before.size(), after);
        return *this;
    }
    ~Editing() { EXPECT_EQ(document.text(), expected); }

    Document document;
    std::string expected, selected = {};
};

}  // namespace grafverif::edit
