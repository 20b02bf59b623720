// SPDX-License-Identifier: MIT
// The client for VS Code, as packed, with the real vscode-languageclient and the real `grafverif lsp`; only VS Code is mocked.
// Whether the windows of VS Code look right is not seen here.
"use strict";
const assert = require("node:assert");
const path = require("node:path");
const test = require("node:test");
const { mock } = require("./mocked_vscode.js");

const settings = { "grafverif.path": process.env.GRAFVERIF_PROGRAM };
const { vscode, seen, events, document } = mock(settings);
const extension = require(path.join(process.env.GRAFVERIF_EXTENSION, "extension.js"));

const uri = "file:///nowhere/lamp.grafcet";
const slip = "grafcet lamp {\n    input BUTTON;\n    initial step 0;\n    transition t: 0 -> 0 when BUTON;\n}\n";

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
    for (const provider of ["Completion", "Hover", "Definition", "Rename", "CodeLens"])
        assert.ok(Object.keys(seen.registered).some((name) => name.startsWith(`register${provider}`)), `${provider} in ${Object.keys(seen.registered)}`);
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
