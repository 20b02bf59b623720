// SPDX-License-Identifier: MIT
// npm run package [-- FILE]: the extension as FILE (default: grafcet-VERSION.vsix), with what it needs at run time from
// node_modules. The same sources give the same bytes.
"use strict";
const fs = require("fs");
const path = require("path");
const { zipSync, strToU8 } = require("fflate");

const own = __dirname;
const about = JSON.parse(fs.readFileSync(path.join(own, "package.json"), "utf8"));
const modules = path.resolve(process.env.GRAFVERIF_NODE_MODULES || path.join(own, "node_modules"));

const types = { js: "application/javascript", json: "application/json", md: "text/markdown", svg: "image/svg+xml",
    txt: "text/plain", sh: "application/x-sh", vsixmanifest: "text/xml" };

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

const manifest = `<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011" xmlns:d="http://schemas.microsoft.com/developer/vsx-schema-design/2011">
  <Metadata>
    <Identity Language="en-US" Id="${about.name}" Version="${about.version}" Publisher="${about.publisher}" />
    <DisplayName>${escaped(about.displayName)}</DisplayName>
    <Description xml:space="preserve">${escaped(about.description)}</Description>
    <Tags>${escaped(about.keywords.join(","))}</Tags>
    <Categories>${escaped(about.categories.join(","))}</Categories>
    <GalleryFlags>Public</GalleryFlags>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value="${escaped(about.engines.vscode)}" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionDependencies" Value="" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionPack" Value="" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionKind" Value="workspace" />
    </Properties>
    <License>extension/LICENSE.txt</License>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code" />
  </Installation>
  <Dependencies />
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true" />
  </Assets>
</PackageManifest>
`;

const contentTypes = `<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">${Object.keys(types).sort()
    .map((kind) => `<Default Extension=".${kind}" ContentType="${types[kind]}"/>`).join("")}</Types>
`;

/// The files below `folder` whose names `wanted` takes, in order.
function filesBelow(folder, wanted) {
    return fs.readdirSync(folder, { withFileTypes: true })
        .sort((a, b) => (a.name < b.name ? -1 : 1))
        .flatMap((entry) => {
            const name = path.join(folder, entry.name);
            if (entry.isDirectory()) return filesBelow(name, wanted);
            return entry.isFile() && wanted(entry.name) ? [name] : [];
        });
}

const files = { "extension.vsixmanifest": strToU8(manifest), "[Content_Types].xml": strToU8(contentTypes) };
function put(name, file) {
    const mode = name.endsWith(".sh") ? 0o100755 : 0o100644;
    files[`extension/${name.split(path.sep).join("/")}`] = [fs.readFileSync(file), { os: 3, attrs: mode << 16 }];
}

for (const name of ["package.json", "extension.js", "language-configuration.json", "README.md"]) put(name, path.join(own, name));
for (const folder of ["icons", "snippets", "syntaxes"])
    for (const file of filesBelow(path.join(own, folder), () => true)) put(path.relative(own, file), file);
put("LICENSE.txt", path.join(own, "../../LICENSE"));

// What the lock file does not call a tool of developers is needed at run time: its code and its licence.
const lock = JSON.parse(fs.readFileSync(path.join(own, "package-lock.json"), "utf8"));
const needed = (name) => Object.hasOwn(types, path.extname(name).slice(1)) || /^licen[cs]e/i.test(name);
for (const [place, module] of Object.entries(lock.packages)) {
    if (!place || module.dev) continue;
    const folder = path.join(modules, path.relative("node_modules", place));
    for (const file of filesBelow(folder, needed)) {
        const inside = path.join(place, path.relative(folder, file));
        put(path.extname(file) ? inside : `${inside}.txt`, file);  // the table of types goes by extensions
    }
}

const target = process.argv[2] || path.join(own, `${about.name}-${about.version}.vsix`);
fs.writeFileSync(target, zipSync(files, { level: 9, mtime: new Date(1980, 0, 1) }));
console.log(`wrote ${target}: ${Object.keys(files).length} files`);
