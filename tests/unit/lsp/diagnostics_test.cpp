// SPDX-License-Identifier: MIT
// Tests diagnostics while a text is edited, and their quick fixes.
#include "unit/lsp/client.hpp"

namespace grafverif::lsp {
namespace {

std::vector<std::string> codes(const Json& diagnostics) {
    std::vector<std::string> found;
    for (const Json& each : diagnostics) found.push_back(each.value("code", ""));
    return found;
}
using Codes = std::vector<std::string>;

Json at(int line, int character) { return {{"line", line}, {"character", character}}; }

TEST(LspText, CountsUnitsOfUtf16) {
    const Text text("a\u00E9\U0001F600b\r\nx\ry\n");
    EXPECT_EQ(text.lines(), 4U);
    EXPECT_EQ(text.position(7), (Position{0, 4}));
    EXPECT_EQ(text.offset({0, 4}), 7U);
    EXPECT_EQ(text.offset({0, 3}), 3U);  // a column inside a character denotes the beginning of the character
    EXPECT_EQ(text.offset({0, 99}), 8U);
    EXPECT_EQ(text.offset({1, 0}), 10U);
    EXPECT_EQ(text.position(12), (Position{2, 0}));
    EXPECT_EQ(text.offset({99, 0}), 14U);
    for (std::uint32_t byte : {0U, 1U, 3U, 7U, 10U, 12U, 14U}) EXPECT_EQ(text.offset(text.position(byte)), byte);
}

TEST(LspText, CountsEquallyInLongLines) {
    const std::string some = "ab\u00E9\U0001F600\r";
    std::string line;
    while (line.size() < 5000) line += some.substr(0, some.size() - 1);
    for (const std::string& text :
         {line, line + "\r\n" + line, line + "\n\n" + line + "\r" + line, line + "\xE2\x82\n" + line}) {
        const Text long_lines(text);
        Position expected;
        for (std::size_t at = 0; at < text.size();) {
            const auto byte = static_cast<unsigned char>(text[at]);
            EXPECT_EQ(long_lines.position(at), expected);
            if (byte != '\n' || at == 0 || text[at - 1] != '\r') {
                EXPECT_EQ(long_lines.offset(expected), at);
            }
            const bool ends = byte == '\n' || (byte == '\r' && (at + 1 == text.size() || text[at + 1] != '\n'));
            ++at;
            while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
            if (ends) expected = {expected.line + 1, 0};
            else expected.character += byte >= 0xF0 ? 2 : 1;
        }
        EXPECT_EQ(long_lines.lines(), expected.line + 1);
        EXPECT_EQ(long_lines.offset({expected.line, expected.character + 9}), text.size());
    }
}

TEST(LspText, IsChangedInPlaces) {
    EXPECT_EQ(changed(Text("one\ntwo\n"), {Range{{1, 0}, {1, 3}}, "drei"}), "one\ndrei\n");
    EXPECT_EQ(changed(Text("one"), {Range{{5, 0}, {9, 9}}, "!"}), "one!");
    EXPECT_EQ(changed(Text("one"), {Range{{0, 2}, {0, 1}}, "-"}), "on-e");  // a reversed range is empty
    EXPECT_EQ(changed(Text("one"), {{}, "two"}), "two");
}

TEST(LspText, NamesFilesByAddress) {
    const std::string path = "/a b/\u00E9%#.grafcet";
    EXPECT_EQ(rpc::uri_of_path(path), "file:///a%20b/%C3%A9%25%23.grafcet");
    EXPECT_EQ(rpc::path_of_uri(rpc::uri_of_path(path)), path);
    EXPECT_EQ(rpc::path_of_uri("file://localhost/a%2"), "/a%2");
    EXPECT_EQ(rpc::path_of_uri("untitled:Untitled-1"), "untitled:Untitled-1");
    EXPECT_EQ(rpc::uri_of_path("untitled:Untitled-1"), "untitled:Untitled-1");
}

TEST(LspDiagnostics, FollowEdits) {
    Client client;
    client.begin();
    client.open(address,
                "grafcet a {\n    input START;\n    initial step 0;\n    transition t: 0 -> 0 when STRAT;\n}\n");
    Json diagnostics = client.diagnostics(address, 1);
    ASSERT_EQ(codes(diagnostics), Codes{"unknown-variable"});
    EXPECT_EQ(diagnostics[0]["range"], (Json{{"start", at(3, 30)}, {"end", at(3, 35)}}));
    EXPECT_EQ(diagnostics[0]["severity"], 1);
    EXPECT_EQ(diagnostics[0]["message"], "unknown variable `STRAT`; did you mean `START`?");

    client.notify(
        "textDocument/didChange",
        {{"textDocument", {{"uri", address}, {"version", 2}}},
         {"contentChanges", Json::array({{{"range", {{"start", at(3, 32)}, {"end", at(3, 34)}}}, {"text", "A"}},
                                         {{"range", {{"start", at(3, 33)}, {"end", at(3, 33)}}}, {"text", "R"}}})}});
    EXPECT_EQ(client.diagnostics(address, 2), Json::array());
    client.notify("textDocument/didClose", {{"textDocument", {{"uri", address}}}});
}

TEST(LspDiagnostics, NameTheOtherPlace) {
    Client client;
    client.begin();
    client.open(address, "grafcet a {\n    input A;\n    input A;\n    initial step 0;\n}\n");
    const Json diagnostics = client.diagnostics(address);
    ASSERT_EQ(codes(diagnostics), Codes{"duplicate-name"});
    const Json related = diagnostics[0]["relatedInformation"];
    ASSERT_EQ(related.size(), 1U);
    EXPECT_EQ(related[0]["message"], "the first declaration is here");
    EXPECT_EQ(related[0]["location"]["uri"], address);
    EXPECT_EQ(related[0]["location"]["range"]["start"], at(1, 10));
}

TEST(LspDiagnostics, AreFixedByTheHint) {
    Client client;
    client.begin();
    const std::string text =
        "grafcet a {\n    input START\n    initial step 0;\n    transition t: 0 -> 0 when X1;\n}\n";
    client.open(address, text);
    const auto actions = [&](int line) {
        return client.result("textDocument/codeAction", {{"textDocument", {{"uri", address}}},
                                                         {"range", {{"start", at(line, 0)}, {"end", at(line, 40)}}},
                                                         {"context", {{"diagnostics", Json::array()}}}});
    };
    Json found = actions(1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0]["title"], "write `;`");
    EXPECT_EQ(found[0]["kind"], "quickfix");
    EXPECT_EQ(found[0]["diagnostics"][0]["code"], "missing-semicolon");
    const Json edit = found[0]["edit"]["changes"][address];
    ASSERT_EQ(edit.size(), 1U);
    EXPECT_EQ(edit[0], (Json{{"range", {{"start", at(1, 15)}, {"end", at(1, 15)}}}, {"newText", ";"}}));
    EXPECT_EQ(actions(0), Json::array());

    client.retype(address, 2, changed(Text(text), {Range{{1, 15}, {1, 15}}, ";"}));
    found = actions(3);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0]["title"], "write `X0`");
}

TEST(LspDiagnostics, IncludeAllFilesThatIncludeAnOpenDocument) {
    const Folder folder;
    folder.write("part.grafcet", "component lever(output OUT) {\n    initial location off;\n}\n");
    folder.write("main.grafcet",
                 "include \"part.grafcet\";\ngrafcet g {\n    input A;\n    initial step 0;\n    transition t: 0 -> 0 "
                 "when A;\n}\n"
                 "closed_loop l {\n    controller g;\n    plant Lever = lever(OUT = A);\n}\n");
    folder.write("other.grafcet", "grafcet unrelated {\n    nonsense\n}\n");
    Client client;
    client.begin(Json::object(), folder.path());
    client.open(folder.uri("part.grafcet"), "component lever(output NEW) {\n    initial location off;\n}\n");
    const Json diagnostics = client.diagnostics(folder.uri("main.grafcet"));
    EXPECT_EQ(codes(diagnostics), Codes{"unknown-parameter"});
    EXPECT_EQ(client.diagnostics(folder.uri("part.grafcet")), Json::array());

    client.retype(folder.uri("part.grafcet"), 2, "component lever(output OUT) {\n    initial location off;\n}\n");
    EXPECT_EQ(client.diagnostics(folder.uri("main.grafcet")), Json::array());

    // The server reads files on disk again when they change. The text of the open document does not change.
    folder.write("part.grafcet", "nonsense");
    folder.write("main.grafcet", "include \"part.grafcet\";\ngrafcet g {\n}\n");
    EXPECT_EQ(codes(client.diagnostics(folder.uri("main.grafcet"))), Codes{"empty-chart"});
}

TEST(LspDiagnostics, SurviveTruncatedAndDamagedTexts) {
    Client client;
    client.begin();
    const std::string whole =
        "grafcet a {\n    input START, B;\n    initial step 0 { X; }\n    step 1;\n"
        "    transition t: 0 -> 1 when START && (B || X1) do N := 1;\n}\nclosed_loop l {\n    controller a;\n"
        "    plant P = valve(ON = B);\n    property p \"t\": never B && !B;\n}\n";
    client.open(address, "");
    int version = 1;
    for (std::size_t length = 0; length <= whole.size(); length += 3)
        client.retype(address, ++version, whole.substr(0, length));
    for (std::size_t at = 0; at < whole.size(); at += 5) {
        std::string damaged = whole;
        damaged.erase(at, 4);
        client.retype(address, ++version, damaged);
    }
    // Repeated diagnostics are not sent again, so the last text is recognized by its diagnostics.
    client.retype(address, ++version, "grafcet a {\n    initial step 0;\n    transition last: 0 -> 99 when true;\n}\n");
    EXPECT_EQ(client.diagnostics(address, version).size(), 1U);
}

}  // namespace
}  // namespace grafverif::lsp
