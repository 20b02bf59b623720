// SPDX-License-Identifier: MIT
// Tests the language server with documents and folders that it cannot read. The server continues, and a failure becomes
// a diagnostic of its document.
#include "unit/lsp/client.hpp"

namespace grafverif::lsp {
namespace {

const std::string wrong = "grafcet b {\n    input GO;\n    initial step 0;\n    transition t: 0 -> 0 when G;\n}\n";
const char* const other = "file:///nowhere/b.grafcet";

Json document(const std::string& uri) { return {{"textDocument", {{"uri", uri}}}}; }

Json with_position(const std::string& uri) {
    Json params = document(uri);
    params["position"] = {{"line", 0}, {"character", 9}};
    return params;
}

Json command(const std::string& name, const std::string& uri) {
    return {{"command", "grafverif." + name}, {"arguments", {uri}}};
}

TEST(LspFaults, ADocumentThatCannotBeReadKeepsNoOtherFromItsDiagnostics) {
    const Folder folder;
    std::filesystem::create_symlink(folder.file("loop"), folder.file("loop"));
    std::filesystem::create_directory(folder.file("shut"));
    std::filesystem::permissions(folder.file("shut"), std::filesystem::perms::none);
    for (const std::string& uri :
         {std::string("file://"), std::string(), std::string("file:///"), folder.uri("loop"),
          folder.uri("loop/x.grafcet"), folder.uri("shut/x.grafcet"), folder.uri(""),
          "file:///" + std::string(5000, 'a') + ".grafcet", "file:///" + std::string(200, 'a') + "/%00.grafcet",
          std::string("file:///proc/self/mem"), std::string("untitled:Untitled-1"), std::string("grafverif:x")}) {
        SCOPED_TRACE(uri);
        Client client;
        client.begin(Json::object(), folder.path());
        client.open(uri, "include \"part.grafcet\";\n" + wrong);
        client.open(other, wrong);
        EXPECT_EQ(client.diagnostics(other)[0]["code"], "unknown-variable");
        client.notify("textDocument/didSave", document(uri));
        client.notify("textDocument/didSave", document(other));
        for (const char* each : {"check", "draw", "simulate", "showVerdict"})
            client.answer(client.send_request("workspace/executeCommand", command(each, uri)));
        for (const char* each : {"hover", "definition", "references", "completion", "prepareRename"})
            client.answer(client.send_request("textDocument/" + std::string(each), with_position(uri)));
        for (const char* each : {"codeLens", "documentSymbol", "semanticTokens/full", "formatting"})
            client.result("textDocument/" + std::string(each), document(uri));
        EXPECT_EQ(client.diagnostics(uri).back()["code"], "unknown-variable") << "the text of the editor is checked";
    }
    std::filesystem::permissions(folder.file("shut"), std::filesystem::perms::owner_all);
}

TEST(LspFaults, KernelFileSystemsAreIgnored) {
    for (const char* folder : {"/proc/self", "/sys"}) {
        Client client;
        client.begin(Json::object(), folder);
        client.open(address, wrong);
        EXPECT_EQ(client.diagnostics(address)[0]["code"], "unknown-variable");
        client.notify("exit", nullptr);
        EXPECT_EQ(client.ending(), Ending::Unrequested);
    }
}

}  // namespace
}  // namespace grafverif::lsp
