// SPDX-License-Identifier: MIT
// Tests the command `edit`: requests of the page, changes of the file by other programs, and the recovery file.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/serve/edited_file.hpp"
#include "app/serve/page_text.hpp"
#include "app/system/write_files.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

const std::string lamp =
    "grafcet lamp {\n    input ON;\n    initial step 0;\n    step 1;  // on\n    transition on: 0 -> 1 when ON;\n"
    "    transition off: 1 -> 0 when !ON;\n}\n";

/// An edited file and the requests of its page.
class Session {
public:
    explicit Session(const Folder& folder) {
        options_.operands = {folder.file("lamp.grafcet")};
        file_ = std::make_unique<EditedFile>(options_, folder.read("lamp.grafcet"));
    }

    Json state() { return Json::parse(*file_->newer(0)); }
    Json ask(const std::string& path, Json request = Json::object()) {
        request["version"] = state()["text_version"];
        return Json::parse(file_->respond(path, request.dump()));
    }
    std::string problem(const std::string& path, Json request = Json::object()) {
        return ask(path, std::move(request))["problem"];
    }
    void type(const std::string& text) { EXPECT_EQ(problem("/text", {{"text", text}}), ""); }
    Json element(const std::string& id) {
        const Json now = state();
        for (const Json& each : now["charts"][0]["elements"])
            if (each["id"] == id) return each;
        return {};
    }
    EditedFile& file() { return *file_; }
    /// Ends the session as if the page and the server were closed.
    void end() {
        file_->begin([] {}, [] {});
        file_->end();
    }

private:
    Options options_ = {};
    std::unique_ptr<EditedFile> file_ = nullptr;
};

TEST(PageText, LineEndsOutsideOfAChangeAreKept) {
    EXPECT_EQ(page_text("a\r\nb\rc\n"), "a\nb\nc\n");
    const std::string mixed = "a\r\nb\nc\re";
    for (const char* page : {"a\nb\nc\ne", "X\nb\nc\ne", "a\nb\nc\nX"}) {
        std::string expected = page;
        expected = std::string(1, page[0]) + "\r\nb\nc\r" + std::string(1, page[6]);
        EXPECT_EQ(text_of_page(page, mixed), expected);
    }
    EXPECT_EQ(text_of_page("a\nx\nb\nc\ne", mixed), "a\r\nx\r\nb\nc\re");
    EXPECT_EQ(text_of_page("ab\nc\ne", mixed), "ab\nc\re");
    EXPECT_EQ(text_of_page("", mixed), "");
    EXPECT_EQ(PagePositions("a\r\n\u00e4\U0001f600b").of(9), 5U);
}

TEST(EditedFile, StepsAreCopiedAndPasted) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    const Json copy = session.ask("/copy", {{"steps", Json::array({session.element("c0-step-1")["at"]})}});
    EXPECT_EQ(copy["problem"], "");
    EXPECT_EQ(copy["text"],
              "// steps of lamp\nstep 1;\ntransition on: 0 -> 1 when ON;\ntransition off: 1 -> 0 when !ON;\n");
    EXPECT_EQ(session.problem("/copy", {{"steps", Json::array({session.element("c0-transition-on")["at"], "x", -1})}}),
              "only steps can be copied");
    EXPECT_EQ(session.problem("/copy"), "no step is selected; select or mark the steps");
    const Json old = Json::parse(session.file().respond("/copy", R"({"version": 99, "steps": [0]})"));
    EXPECT_EQ(old["problem"], "the text has changed in the meantime; copy again");
    EXPECT_EQ(session.problem(
                  "/edit",
                  {{"operation", "paste"}, {"at", session.element("c0-transition-on")["at"]}, {"text", copy["text"]}}),
              "");
    EXPECT_NE(session.file().text().find("transition t4: 2 -> 1 when !ON;"), std::string::npos);
}

TEST(EditedFile, CompletionProposesNamesAndDoesNotChangeTheText) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    const std::size_t at = lamp.find("ON;\n    transition off");
    const Json request = {{"before", lamp.substr(0, at) + "X1 && "}, {"after", lamp.substr(at)}};
    const std::uint64_t version = session.state()["version"];
    std::vector<std::string> labels;
    const Json answer = session.ask("/completion", request);
    for (const Json& each : answer["proposals"]) labels.push_back(each["label"]);
    for (const char* label : {"ON", "X0", "X1"}) EXPECT_NE(std::ranges::find(labels, label), labels.end()) << label;
    EXPECT_EQ(session.state()["version"], version);
    EXPECT_EQ(session.file().text(), lamp);
    EXPECT_TRUE(session.ask("/completion", {{"before", std::string(1, '\0')}})["proposals"].empty());
}

TEST(EditedFile, OperationChangesTheTextAndSavingWritesTheFile) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    const Json answer = session.ask("/edit", {{"operation", "step-after"}, {"at", session.element("c0-step-1")["at"]}});
    EXPECT_EQ(answer["problem"], "");
    EXPECT_TRUE(answer["state"]["modified"]);
    EXPECT_EQ(session.element("c0-step-2")["begin"], answer["selected"]);
    EXPECT_EQ(session.element("c0-step-2")["area"].size(), 4U);
    EXPECT_EQ(folder.read("lamp.grafcet"), lamp);
    const std::string edited = session.file().text();
    EXPECT_EQ(session.problem("/save"), "");
    EXPECT_EQ(folder.read("lamp.grafcet"), edited);
    EXPECT_FALSE(session.state()["modified"]);
    EXPECT_EQ(session.problem("/undo"), "");
    EXPECT_EQ(session.file().text(), lamp);
    EXPECT_TRUE(session.state()["modified"]);
}

TEST(EditedFile, MalformedAndOldRequestsChangeNothing) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    EXPECT_EQ(Json::parse(session.file().respond("/text", "[]"))["problem"], "malformed request; send a JSON object");
    EXPECT_EQ(Json::parse(session.file().respond("/text", R"({"version": 99, "text": ""})"))["problem"],
              "the text has changed in the meantime, for example in another window");
    EXPECT_EQ(session.problem("/edit", {{"operation", "explode"}, {"at", 1}}),
              "malformed request; the operation or its element is missing");
    EXPECT_EQ(session.problem("/resolve", {{"keep", "page"}}), "the file has no other version");
    const Json trial = session.ask(
        "/edit", {{"operation", "rename"}, {"at", session.element("c0-step-1")["at"]}, {"text", "0"}, {"trial", true}});
    EXPECT_NE(trial["problem"], "");
    EXPECT_FALSE(trial.contains("state"));
    EXPECT_EQ(session.file().text(), lamp);
}

TEST(EditedFile, ChangeOfAnotherProgramIsNotOverwritten) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    session.type(lamp + "// mine\n");
    folder.write("lamp.grafcet", lamp + "// theirs\n");
    EXPECT_EQ(session.problem("/save"), "another program has changed the file; choose which version to keep");
    EXPECT_EQ(session.state()["other"], lamp + "// theirs\n");
    EXPECT_EQ(session.problem("/save"), "another program has changed the file; choose which version to keep");
    EXPECT_EQ(session.problem("/resolve", {{"keep", "both"}}), "the choice must be `page` or `file`");
    EXPECT_EQ(session.problem("/resolve", {{"keep", "file"}}), "");
    EXPECT_EQ(session.file().text(), lamp + "// theirs\n");
    EXPECT_EQ(session.problem("/undo"), "");
    EXPECT_EQ(session.file().text(), lamp + "// mine\n");
    EXPECT_EQ(session.problem("/save"), "");
    EXPECT_EQ(folder.read("lamp.grafcet"), lamp + "// mine\n");
}

TEST(EditedFile, UnsavedChangesAreRestoredWithTheConflictThatTheyCause) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    {
        Session session(folder);
        session.type(lamp + "// mine\n");
        session.end();
        EXPECT_EQ(session.file().unsaved(), folder.file(".lamp.grafcet.unsaved"));
    }
    EXPECT_EQ(folder.read("lamp.grafcet"), lamp);
    {
        Session session(folder);
        EXPECT_TRUE(session.state()["restored"]);
        EXPECT_TRUE(session.state()["other"].is_null());
        EXPECT_EQ(session.file().text(), lamp + "// mine\n");
        EXPECT_EQ(session.problem("/undo"), "");
        EXPECT_EQ(session.file().text(), lamp);
        EXPECT_EQ(session.problem("/redo"), "");
    }
    folder.write("lamp.grafcet", lamp + "// theirs\n");
    {
        Session session(folder);
        EXPECT_EQ(session.state()["other"], lamp + "// theirs\n");
        EXPECT_EQ(session.problem("/resolve", {{"keep", "page"}}), "");
        EXPECT_EQ(session.problem("/save"), "");
        EXPECT_EQ(session.file().unsaved(), "");
    }
    EXPECT_EQ(folder.entries(), 1U) << "the recovery file is removed";
    folder.write(".lamp.grafcet.unsaved", "{");
    Session session(folder);
    EXPECT_EQ(session.state()["notice"], "`.lamp.grafcet.unsaved` is damaged and was ignored");
    fs::remove(folder.file(".lamp.grafcet.unsaved"));
    fs::create_directory(folder.file(".lamp.grafcet.unsaved"));
    session.type(lamp + "// other\n");
    session.end();
    const std::string notice = session.state()["notice"];
    EXPECT_TRUE(notice.starts_with("the recovery file cannot be written, so save the file before the server ends: "));
}

TEST(EditedFile, FileThatCannotBeShownIsNotOverwritten) {
    const std::string changed =
        "the file was not saved: another program has changed the file, and the page cannot show it: ";
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    session.type(lamp + "// mine\n");
    const std::string large = lamp + "//" + std::string(largest_edited, 'x');
    folder.write("lamp.grafcet", large);
    EXPECT_EQ(session.problem("/save"), changed + "the file is larger than 4 MiB");
    EXPECT_EQ(folder.read("lamp.grafcet"), large);
    EXPECT_FALSE(session.state()["missing"]);
    folder.write("lamp.grafcet", "// \xff");
    EXPECT_EQ(session.problem("/save"), changed + "the file is not text in UTF-8");
    EXPECT_TRUE(session.state()["other"].is_null());
    EXPECT_TRUE(std::string(session.state()["notice"]).starts_with("another program has changed the file"));
    fs::remove(folder.file("lamp.grafcet"));
    fs::create_directory(folder.file("lamp.grafcet"));
    EXPECT_EQ(session.problem("/save"), changed + "the path is a folder");
    fs::remove(folder.file("lamp.grafcet"));
    EXPECT_EQ(session.problem("/save"), "") << "a deleted file is created again";
    EXPECT_EQ(folder.read("lamp.grafcet"), lamp + "// mine\n");
    EXPECT_EQ(session.state()["notice"], "");
}

TEST(EditedFile, TextThatCannotBeReadAgainIsRejected) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    EXPECT_EQ(session.problem("/text", {{"text", std::string(largest_edited + 1, ' ')}}),
              "the text is larger than 4 MiB");
    EXPECT_EQ(session.problem("/text", {{"text", std::string("a\0b", 3)}}), "the text contains the character U+0000");
    EXPECT_EQ(session.problem("/text"), "malformed request; the text is missing");
    EXPECT_EQ(session.problem("/edit", {{"operation", "action"},
                                        {"at", session.element("c0-step-1")["at"]},
                                        {"text", std::string("L /*\0*/", 8)}}),
              "malformed request; the operation or its element is missing");
    EXPECT_EQ(session.file().text(), lamp);
}

TEST(EditedFile, RecoveryFileIsPrivateAndFollowsTheText) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session session(folder);
    session.type("");
    session.end();
    const std::string recovery = folder.file(".lamp.grafcet.unsaved");
    EXPECT_EQ(fs::status(recovery).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(session.file().unsaved(), recovery) << "an empty text is also kept";
    session.type(lamp);
    session.end();
    EXPECT_EQ(folder.entries(), 1U);
    EXPECT_EQ(session.file().unsaved(), "");
}

TEST(EditedFile, RecoveryFileOfAnotherServerIsNotOverwritten) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    Session one(folder), two(folder);
    one.type(lamp + "// one\n");
    one.end();
    const std::string recovery = folder.read(".lamp.grafcet.unsaved");
    two.type(lamp + "// two\n");
    two.end();
    EXPECT_EQ(folder.read(".lamp.grafcet.unsaved"), recovery);
    EXPECT_EQ(two.file().unsaved(), "");
    EXPECT_EQ(two.file().loss(), "another program has written `.lamp.grafcet.unsaved`");
    two.type(lamp);
    two.end();
    EXPECT_EQ(folder.read(".lamp.grafcet.unsaved"), recovery);
    EXPECT_EQ(two.file().loss(), "");
}

TEST(EditedFile, LinesOfAnOperationEndAsThoseOfTheFile) {
    const Folder folder;
    folder.write("lamp.grafcet",
                 "grafcet g {\r\n    input A;\r\n    initial step 0;\r\n    transition t: 0 -> 0 when A;\r\n}\r\n");
    Session session(folder);
    EXPECT_EQ(session.problem(
                  "/edit",
                  {{"operation", "replace"}, {"at", session.element("c0-transition-t")["at"]}, {"text", "A\n&& !A"}}),
              "");
    EXPECT_NE(session.file().text().find("when A\r\n&& !A;"), std::string::npos);
}

TEST(WriteFiles, ReplacesOnlyTheExpectedContent) {
    const Folder folder;
    const std::string path = folder.write("a", "old");
    const OutputFile file{.path = path, .content = "new", .mode = 0600, .replaces = "old"};
    write_files({file});
    EXPECT_EQ(folder.read("a"), "new");
    EXPECT_THROW(write_files({file}), std::system_error);
    folder.write("a", "older");
    EXPECT_THROW(write_files({file}), std::system_error);
    EXPECT_EQ(folder.read("a"), "older");
    EXPECT_EQ(folder.entries(), 1U);
    fs::remove(path);
    write_files({file});
    EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(EditedFile, SavingIntoAMissingFolderIsReported) {
    const Folder folder;
    fs::create_directory(folder.file("sub"));
    folder.write("sub/lamp.grafcet", lamp);
    Options options;
    options.operands = {folder.file("sub/lamp.grafcet")};
    EditedFile file(options, lamp);
    fs::remove_all(folder.file("sub"));
    folder.write("sub", "a file");
    const Json state = Json::parse(*file.newer(0));
    const Json typed =
        Json::parse(file.respond("/text", Json{{"version", state["text_version"]}, {"text", "// x\n"}}.dump()));
    const std::string problem =
        Json::parse(file.respond("/save", Json{{"version", typed["state"]["text_version"]}}.dump()))["problem"];
    EXPECT_TRUE(problem.starts_with("the file was not saved: ")) << problem;
}

TEST(EditedFile, NamesThatOtherFilesUseAreNotRenamed) {
    const Folder folder;
    folder.write("lamp.grafcet", lamp);
    folder.write(
        "house.grafcet",
        "include \"lamp.grafcet\";\nclosed_loop house { controller lamp; environment A = push_button(OUT = ON);\n"
        "property P: reachable lamp.X1; }\n");
    Session session(folder);
    EXPECT_EQ(
        session.problem("/edit", {{"operation", "rename"}, {"at", session.element("c0-step-1")["at"]}, {"text", "5"}}),
        "`1` is also used in `" + folder.file("house.grafcet") + "`, which `edit` does not write");
    EXPECT_EQ(
        session.problem("/edit", {{"operation", "rename"}, {"at", session.element("c0-step-0")["at"]}, {"text", "5"}}),
        "");
}

TEST(EditCommand, RejectsFilesThatCannotBeEdited) {
    const Folder folder;
    const auto error = [&](const std::string& text) {
        const Result result = grafverif({"edit", folder.write("a.grafcet", text)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(folder.read("a.grafcet"), text);
        return result.err;
    };
    EXPECT_NE(error("<?xml version=\"1.0\"?><project/>").find("convert the file with `grafverif import`"),
              std::string::npos);
    EXPECT_NE(error("grafcet a {\xff}").find("invalid-utf8"), std::string::npos);
    EXPECT_NE(error(std::string("// a\0b", 6)).find("the file is not text in UTF-8"), std::string::npos);
    EXPECT_NE(error("//" + std::string(largest_edited, 'x')).find("larger than 4 MiB"), std::string::npos);
    EXPECT_NE(grafverif({"edit", "-"}).err.find("standard input cannot be watched"), std::string::npos);
}

}  // namespace
}  // namespace grafverif::app
