// SPDX-License-Identifier: MIT
// The client for VS Code: it starts `grafverif lsp`. The server and vscode-languageclient provide all other functions.
"use strict";
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

/** @type {LanguageClient | undefined} */
let client;

function made() {
    const settings = vscode.workspace.getConfiguration("grafverif");
    const server = { command: settings.get("path") || "grafverif", args: ["lsp", ...(settings.get("arguments") || [])] };
    return new LanguageClient("grafverif", "grafverif", server, {
        documentSelector: [{ language: "grafcet" }, { language: "st" }],
        middleware: {
            // The command palette passes no arguments; the command then applies to the file in the active editor.
            executeCommand: (command, given, next) => {
                const editor = vscode.window.activeTextEditor;
                return next(command, given.length > 0 || !editor ? given : [editor.document.uri.toString()]);
            },
        },
    });
}

async function start() {
    client = made();
    try {
        await client.start();
    } catch (failure) {
        const reason = failure instanceof Error ? failure.message : String(failure);
        const what = `grafverif does not start: ${reason}. Install it, or set grafverif.path to its path.`;
        if ((await vscode.window.showErrorMessage(what, "Settings")) === "Settings")
            await vscode.commands.executeCommand("workbench.action.openSettings", "grafverif.path");
    }
}

async function stop() {
    const old = client;
    client = undefined;
    if (old) await old.dispose().catch(() => undefined);
}

/** @param {vscode.ExtensionContext} context */
exports.activate = async (context) => {
    const restart = async () => {
        await stop();
        await start();
    };
    context.subscriptions.push(
        vscode.commands.registerCommand("grafverif.restart", restart),
        vscode.workspace.onDidChangeConfiguration(async (change) => {
            if (change.affectsConfiguration("grafverif.path") || change.affectsConfiguration("grafverif.arguments")) await restart();
        }),
    );
    await start();
};

exports.deactivate = stop;
