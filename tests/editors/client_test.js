// SPDX-License-Identifier: MIT
// Tests the client for VS Code, as packaged, with the real vscode-languageclient and the real `grafverif lsp`; only VS
// Code is mocked. The appearance of VS Code is not tested.
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const { spawn } = require("node:child_process");
const test = require("node:test");
const { mock } = require("./mocked_vscode.js");

const settings = { "grafverif.path": process.env.GRAFVERIF_PROGRAM };
const { vscode, seen, events, document } = mock(settings);
const extension = require(path.join(process.env.GRAFVERIF_EXTENSION, "extension.js"));

const uri = "file:///nowhere/lamp.grafcet";
const slip = "grafcet lamp {\n    input BUTTON;\n    initial step 0;\n    transition t: 0 -> 0 when BUTON;\n}\n";

const contributed = JSON.parse(fs.readFileSync(path.join(process.env.GRAFVERIF_EXTENSION, "package.json"), "utf8"))
    .contributes.commands.map((one) => one.command);

test("the package has what a marketplace shows, and its code in one file", () => {
    const inside = (name) => path.join(process.env.GRAFVERIF_EXTENSION, name);
    const about = JSON.parse(fs.readFileSync(inside("package.json"), "utf8"));
    const icon = fs.readFileSync(inside(about.icon));
    assert.deepStrictEqual([icon.toString("latin1", 1, 4), icon.readUInt32BE(16), icon.readUInt32BE(20)], ["PNG", 128, 128]);
    assert.ok(fs.readFileSync(inside("CHANGELOG.md"), "utf8").includes(`## ${about.version}`));
    const pictures = [...fs.readFileSync(inside("README.md"), "utf8").matchAll(/!\[[^\]]+\]\(([^)]+)\)/g)].map((found) => found[1]);
    assert.ok(pictures.length > 0 && pictures.every((picture) => fs.existsSync(inside(picture))), `${pictures}`);
    assert.ok(!fs.existsSync(inside("node_modules")) && about.dependencies === undefined);
    const required = [...fs.readFileSync(inside(about.main), "utf8").matchAll(/\brequire\("([^"]+)"\)/g)].map((found) => found[1]);
    const builtin = require("node:module").builtinModules;
    assert.deepStrictEqual([...new Set(required)].filter((name) => !builtin.includes(name)), ["vscode"]);
    const notices = fs.readFileSync(inside("ThirdPartyNotices.txt"), "utf8");
    for (const name of ["vscode-languageclient", "vscode-jsonrpc"]) assert.ok(notices.includes(`---- ${name} `), name);
});

// Maps each capability of the server to the resulting registration in VS Code.
const providers = {
    completionProvider: "Completion", hoverProvider: "Hover", definitionProvider: "Definition", referencesProvider: "Reference",
    documentHighlightProvider: "DocumentHighlight", renameProvider: "Rename", documentSymbolProvider: "DocumentSymbol",
    foldingRangeProvider: "FoldingRange", documentFormattingProvider: "DocumentFormatting", codeLensProvider: "CodeLens",
    codeActionProvider: "CodeActions", semanticTokensProvider: "DocumentSemanticTokens",
};

function capabilities() {
    const server = spawn(process.env.GRAFVERIF_PROGRAM, ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
    const say = (message) => {
        const text = JSON.stringify({ jsonrpc: "2.0", ...message });
        server.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
    };
    say({ id: 1, method: "initialize", params: { processId: null, rootUri: null, capabilities: {} } });
    say({ id: 2, method: "shutdown" });
    say({ method: "exit" });
    return new Promise((resolve) => {
        let said = "";
        server.stdout.on("data", (part) => { said += part; });
        server.on("close", () => resolve(JSON.parse(said.split("\r\n\r\n")[1].split("Content-Length")[0]).result.capabilities));
    });
}

function diagnostics() {
    return new Promise((resolve) => {
        const look = () => {
            const list = seen.diagnostics.get(uri);
            if (list && list.length > 0) resolve(list);
            else events.once("diagnostics", look);
        };
        look();
    });
}

test("the client starts the server, which underlines a slip in an open chart", { timeout: 20000 }, async () => {
    const opened = document(uri, slip);
    vscode.workspace.textDocuments.push(opened);
    vscode.window.activeTextEditor = { document: opened };
    const context = { subscriptions: [] };
    await extension.activate(context);
    assert.deepStrictEqual(seen.messages, []);
    const found = await diagnostics();
    assert.ok(found.some((one) => JSON.stringify(one).includes("BUTON")), JSON.stringify(found));
    assert.ok("grafverif.restart" in seen.commands);
    const can = await capabilities();
    for (const [name, provider] of Object.entries(providers)) {
        if (!can[name]) continue;
        assert.ok(Object.keys(seen.registered).some((one) => one.startsWith(`register${provider}`)), `${name}: ${Object.keys(seen.registered)}`);
    }
    for (const command of (can.executeCommandProvider || { commands: [] }).commands) {
        assert.ok(command in seen.commands, command);
        assert.ok(contributed.includes(command), `${command} has no title in the palette`);
    }
});

test("a restarted server reads the chart anew", { timeout: 20000 }, async () => {
    seen.diagnostics.clear();
    await seen.commands["grafverif.restart"]();
    assert.ok((await diagnostics()).length > 0);
    assert.deepStrictEqual(seen.messages, []);
});

test("a program that is not there is told of, with where to say it", { timeout: 20000 }, async () => {
    settings["grafverif.path"] = "/nowhere/grafverif";
    await seen.commands["grafverif.restart"]();
    assert.ok(seen.messages.some((text) => text.includes("grafverif does not start")), JSON.stringify(seen.messages));
    await extension.deactivate();
});
