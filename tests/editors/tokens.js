// SPDX-License-Identifier: MIT
// tokens.js FILE...: prints the highlighting of each file by the TextMate grammar, with the engine of VS Code. A line
// is `LINE:COLUMN CATEGORY TEXT`; names and punctuation are omitted. tokens.vim prints the same for Vim's syntax.
"use strict";
const fs = require("fs");
const path = require("path");
const textmate = require("vscode-textmate");
const oniguruma = require("vscode-oniguruma");

const root = path.resolve(__dirname, "../..");
const grammarFile = path.join(root, "editors/vscode/syntaxes/grafcet.tmLanguage.json");

// The first prefix in this list that matches a scope determines its category.
const categories = [
    ["comment", "Comment"], ["string", "String"], ["invalid", "Invalid"],
    ["storage.type", "Declaration"], ["storage.modifier", "Modifier"], ["keyword.control", "Control"],
    ["keyword.operator.word", "Logic"], ["keyword.operator", "Operator"], ["keyword.other.pattern", "Pattern"],
    ["support.function.edge", "Edge"], ["support.type", "Type"], ["support.constant.finding", "Finding"],
    ["constant.language", "Constant"], ["constant.numeric.duration", "Duration"], ["constant.numeric", "Number"],
    ["entity.name.type", "TypeName"], ["entity.name.class.step", "StepName"], ["entity.name.function", "Label"],
    ["variable.language.step", "StepVariable"], ["punctuation", ""], ["source", ""],
];

function categoryOf(scopes) {
    const scope = scopes[scopes.length - 1];
    const found = categories.find(([prefix]) => scope === prefix || scope.startsWith(prefix + "."));
    if (!found) throw new Error(`no category for the scope ${scope}`);
    return found[1];
}

async function grammar() {
    await oniguruma.loadWASM(fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")));
    const registry = new textmate.Registry({
        onigLib: Promise.resolve({
            createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
            createOnigString: (text) => new oniguruma.OnigString(text),
        }),
        loadGrammar: async () => textmate.parseRawGrammar(fs.readFileSync(grammarFile, "utf8"), grammarFile),
    });
    return registry.loadGrammar("source.grafcet");
}

/// Returns the sections of one category in a line; white space ends a section except in comments and strings.
function runs(line, colours) {
    const characters = [...line];
    const found = [];
    for (let k = 0; k < characters.length; ++k) {
        const spans = colours[k] === "Comment" || colours[k] === "String";
        const category = /\s/.test(characters[k]) && !spans ? "" : colours[k];
        const last = found[found.length - 1];
        if (last && last.end === k && last.category === category) last.end = k + 1;
        else found.push({ begin: k, end: k + 1, category });
    }
    return found.filter((run) => run.category)
        .map((run) => ({ column: run.begin + 1, category: run.category, text: characters.slice(run.begin, run.end).join("") }));
}

function tokensOf(loaded, text) {
    const tokens = [];
    let stack = textmate.INITIAL;
    text.replace(/\n$/, "").split("\n").forEach((line, number) => {
        const { tokens: parts, ruleStack } = loaded.tokenizeLine(line, stack);
        stack = ruleStack;
        const colours = [];
        for (const part of parts)
            for (const _ of [...line.slice(part.startIndex, part.endIndex)]) colours.push(categoryOf(part.scopes));
        for (const run of runs(line, colours)) tokens.push({ line: number + 1, ...run });
    });
    return tokens;
}

module.exports = { root, grammar, tokensOf };

if (require.main === module) {
    grammar().then((loaded) => {
        for (const file of process.argv.slice(2)) {
            console.log(`== ${file}`);
            for (const t of tokensOf(loaded, fs.readFileSync(file, "utf8"))) console.log(`${t.line}:${t.column} ${t.category} ${t.text}`);
        }
    });
}
