// SPDX-License-Identifier: MIT
// Mock of the module `vscode`, which exists only inside VS Code, as far as the client and vscode-languageclient use it:
// open documents, recorded providers, and classes that store their arguments. No user interface.
"use strict";
const Module = require("module");
const { EventEmitter } = require("events");

class Disposable {
    constructor(dispose) { this.dispose = dispose || (() => undefined); }
    static from(...all) { return new Disposable(() => all.forEach((one) => one.dispose())); }
}
class Position { constructor(line, character) { Object.assign(this, { line, character }); } }
class Range {
    constructor(a, b, c, d) {
        this.start = a instanceof Position ? a : new Position(a, b);
        this.end = a instanceof Position ? b : new Position(c, d);
    }
}
class Uri {
    constructor(text) {
        const url = new URL(text);
        Object.assign(this, { text, scheme: url.protocol.slice(0, -1), path: decodeURIComponent(url.pathname), fsPath: decodeURIComponent(url.pathname) });
    }
    toString() { return this.text; }
    static parse(text) { return new Uri(text); }
    static file(path) { return new Uri(`file://${path}`); }
}

class CodeActionKind {
    constructor(value) { this.value = value; }
    append(part) { return new CodeActionKind(this.value ? `${this.value}.${part}` : part); }
}
CodeActionKind.Empty = new CodeActionKind("");

const events = new EventEmitter();
const event = (name) => (listener, self) => {
    const call = (what) => listener.call(self, what);
    events.on(name, call);
    return new Disposable(() => events.off(name, call));
};

/// Returns a class that stores its arguments, and can also be used as an enumeration whose members are numbers.
function anything(name) {
    const made = { [name]: class { constructor(...given) { this.given = given; } } }[name];
    return new Proxy(made, { get: (target, key) => (key in target || typeof key === "symbol" ? target[key] : 0) });
}

/// Returns `known` with default members for all other names, chosen by the name: `onDid...` is an event, `register...`
/// a registration.
function namespace(known, seen) {
    return new Proxy(known, {
        get(target, name) {
            if (name in target || typeof name === "symbol") return target[name];
            if (/^on(Did|Will)/.test(name)) return event(name);
            if (/^register/.test(name)) return (...given) => (seen[name] = given, new Disposable(() => delete seen[name]));
            if (/^[A-Z]/.test(name)) return (target[name] = anything(name));
            return () => undefined;
        },
    });
}

exports.mock = (settings) => {
    const seen = { registered: {}, commands: {}, diagnostics: new Map(), messages: [], output: "" };
    const channel = {
        append: (text) => { seen.output += text; }, appendLine: (text) => { seen.output += `${text}\n`; },
        clear() {}, show() {}, hide() {}, dispose() {},
    };
    const collection = {
        set: (uri, list) => { seen.diagnostics.set(uri.toString(), list); events.emit("diagnostics"); },
        delete: (uri) => seen.diagnostics.delete(uri.toString()), clear: () => seen.diagnostics.clear(), dispose() {},
    };
    const say = (text) => (seen.messages.push(text), Promise.resolve(undefined));
    const vscode = namespace({
        version: "1.82.0",
        Disposable, Position, Range, Uri, CodeActionKind,
        env: { appName: "mocked", language: "en", openExternal: (uri) => (seen.opened = uri.toString(), Promise.resolve(true)) },
        extensions: namespace({ getExtension: () => undefined }, seen.registered),
        commands: {
            registerCommand: (name, run) => {
                if (name in seen.commands) throw new Error(`command '${name}' already exists`);
                seen.commands[name] = run;
                return new Disposable(() => delete seen.commands[name]);
            },
            executeCommand: (name, ...given) => Promise.resolve(seen.commands[name] && seen.commands[name](...given)),
        },
        languages: namespace({
            createDiagnosticCollection: () => collection,
            match: (selector, document) => (selector.some ? selector : [selector]).some((one) => (one.language || one) === document.languageId) ? 10 : 0,
        }, seen.registered),
        workspace: namespace({
            textDocuments: [], notebookDocuments: [], workspaceFolders: undefined,
            getConfiguration: (section) => ({ get: (name, otherwise) => settings[section ? `${section}.${name}` : name] ?? otherwise, inspect: () => undefined, has: () => false }),
            createFileSystemWatcher: () => namespace({ dispose() {} }, seen.registered),
            applyEdit: (edit) => (seen.edit = edit, Promise.resolve(true)),
        }, seen.registered),
        window: namespace({
            activeTextEditor: undefined, visibleTextEditors: [], tabGroups: namespace({ all: [] }, seen.registered),
            createOutputChannel: () => channel,
            showErrorMessage: say, showWarningMessage: say, showInformationMessage: say,
            withProgress: (_, task) => task({ report() {} }, { onCancellationRequested: event("cancel") }),
        }, seen.registered),
        EventEmitter: class { constructor() { this.events = new EventEmitter(); this.event = (f) => (this.events.on("e", f), new Disposable(() => this.events.off("e", f))); } fire(what) { this.events.emit("e", what); } dispose() {} },
        CancellationTokenSource: class { constructor() { this.token = { isCancellationRequested: false, onCancellationRequested: event("cancelled") }; } cancel() {} dispose() {} },
    }, seen.registered);
    const load = Module._load;
    Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));
    const document = (uri, text) => ({
        uri: Uri.parse(uri), languageId: "grafcet", version: 1, isDirty: false, isClosed: false, eol: 1,
        fileName: Uri.parse(uri).fsPath, getText: () => text, lineCount: text.split("\n").length,
    });
    return { vscode, seen, events, document };
};
