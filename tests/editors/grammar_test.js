// SPDX-License-Identifier: MIT
// Compares the TextMate grammar with snapshots, with the table of keywords, and with the lexer of the language on every
// chart of the repository.
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const test = require("node:test");
const { execFileSync } = require("node:child_process");
const { root, grammar, tokensOf } = require("./tokens.js");

const read = (name) => fs.readFileSync(path.join(root, name), "utf8");
const words = JSON.parse(read("editors/words.json"));
const categoryOf = Object.fromEntries(Object.entries(words).flatMap(([category, list]) => list.map((word) => [word, category])));
const lines = (tokens) => tokens.map((t) => `${t.line}:${t.column} ${t.category} ${t.text}\n`).join("");

/// Returns the keywords, values, strings and comments of a text with their positions, according to grammars/grafcet.ll.
function lexed(text) {
    const pattern = /(?<=accept )[a-z-]+|\/\/[^\n]*|\/\*[^]*?\*\/|"[^"\n]*"|[0-9]+(?:\.[0-9]+)?[A-Za-z_][A-Za-z0-9_]*|[0-9]+|[A-Za-z_][A-Za-z0-9_]*/g;
    const kindOf = (word) => (/^[a-z]+-[a-z-]+$/.test(word) ? "Finding" : /^\/[/*]/.test(word) ? "Comment" : word[0] === '"' ? "String" : /^[0-9]+$/.test(word) ? "Number" : /^[0-9]/.test(word) ? "Duration" : "Word");
    return [...text.matchAll(pattern)].map((match) => {
        const before = text.slice(0, match.index);
        return { text: match[0], kind: kindOf(match[0]), line: before.split("\n").length, column: [...before.slice(before.lastIndexOf("\n") + 1)].length + 1 };
    });
}

const at = (tokens) => new Map(tokens.map((t) => [`${t.line}:${t.column}`, t]));

for (const name of ["words", "names"]) {
    test(`${name}.grafcet is coloured as its snapshot says`, async () => {
        const made = lines(tokensOf(await grammar(), read(`tests/editors/${name}.grafcet`)));
        const snapshot = path.join(__dirname, `${name}.tokens`);
        if (process.env.GRAFVERIF_UPDATE_GOLDEN) fs.writeFileSync(snapshot, made);
        assert.strictEqual(made, fs.readFileSync(snapshot, "utf8"));
    });
}

test("every word of the table is coloured by its category", async () => {
    const text = read("tests/editors/words.grafcet");
    const found = at(tokensOf(await grammar(), text));
    const missing = new Set(Object.keys(categoryOf));
    for (const word of lexed(text)) {
        const token = found.get(`${word.line}:${word.column}`);
        if (!(word.text in categoryOf)) continue;
        assert.strictEqual(token && token.category, categoryOf[word.text], `${word.text} in line ${word.line}`);
        missing.delete(word.text);
    }
    assert.deepStrictEqual([...missing], []);
});

test("charts of the repository have a colour on each reserved word, value, text and comment, and nothing invalid", async () => {
    const reserved = new Set("grafcet component closed_loop include input output internal step transition when do force and or not true false always never reachable inevitable possible".split(" "));
    const loaded = await grammar();
    const charts = execFileSync("find", ["samples", "templates", "docs", "tests/unit", "-name", "*.grafcet"], { cwd: root, encoding: "utf8" }).trim().split("\n");
    assert.ok(charts.length > 40);
    for (const chart of charts) {
        const text = read(chart);
        const tokens = tokensOf(loaded, text);
        const found = at(tokens);
        assert.deepStrictEqual(tokens.filter((t) => t.category === "Invalid"), [], chart);
        for (const word of lexed(text)) {
            const token = found.get(`${word.line}:${word.column}`);
            const where = `${chart}:${word.line}:${word.column}: ${word.text}`;
            if (word.kind === "Word" && !reserved.has(word.text)) continue;
            if (word.kind === "Word") assert.ok(token && token.category === categoryOf[word.text], where);
            else if (word.kind === "Number") assert.ok(token && ["Number", "StepName", "Label"].includes(token.category), where);
            else assert.strictEqual(token && token.category, word.kind, where);
        }
    }
});
