// SPDX-License-Identifier: MIT
// npm run package [-- FILE]: packs the extension as FILE (default: grafcet-VERSION.vsix). Its code, with the modules that it
// needs at run time, is one file, which esbuild writes. The package is reproducible.
"use strict";
const fs = require("fs");
const path = require("path");
const { buildSync } = require("esbuild");
const { zipSync, strToU8 } = require("fflate");

const own = __dirname;
const about = JSON.parse(fs.readFileSync(path.join(own, "package.json"), "utf8"));
const modules = path.resolve(process.env.GRAFVERIF_NODE_MODULES || path.join(own, "node_modules"));

// The URL of the repository is declared only in CMakeLists.txt; without a URL, the package names no repository.
const [, repository] = /HOMEPAGE_URL "([^"]*)"/.exec(fs.readFileSync(path.join(own, "../../CMakeLists.txt"), "utf8"));
if (repository) about.repository = { type: "git", url: `${repository}.git`, directory: "editors/vscode" };
delete about.scripts;
delete about.devDependencies;
delete about.dependencies;  // bundled

const types = { js: "application/javascript", json: "application/json", md: "text/markdown", png: "image/png", svg: "image/svg+xml",
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
      <Property Id="Microsoft.VisualStudio.Code.ExtensionKind" Value="workspace" />${repository ? `
      <Property Id="Microsoft.VisualStudio.Services.Links.Source" Value="${escaped(repository)}" />` : ""}
    </Properties>
    <License>extension/LICENSE.txt</License>
    <Icon>extension/${about.icon}</Icon>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code" />
  </Installation>
  <Dependencies />
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.Changelog" Path="extension/CHANGELOG.md" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Icons.Default" Path="extension/${about.icon}" Addressable="true" />
  </Assets>
</PackageManifest>
`;

const contentTypes = `<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">${Object.keys(types).sort()
    .map((kind) => `<Default Extension=".${kind}" ContentType="${types[kind]}"/>`).join("")}</Types>
`;

/// Returns the sorted paths of the files below `folder` whose names satisfy `wanted`.
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
function add(name, bytes, mode = 0o100644) {
    files[`extension/${name.split(path.sep).join("/")}`] = [bytes, { os: 3, attrs: mode << 16 }];
}
function put(name, file) { add(name, fs.readFileSync(file)); }

add("package.json", strToU8(`${JSON.stringify(about, null, 4)}\n`));
for (const name of ["language-configuration.json", "README.md", "CHANGELOG.md"]) put(name, path.join(own, name));
for (const folder of ["icons", "pictures", "snippets", "syntaxes"])
    for (const file of filesBelow(path.join(own, folder), () => true)) put(path.relative(own, file), file);
put("LICENSE.txt", path.join(own, "../../LICENSE"));

const bundle = buildSync({
    entryPoints: [path.join(own, "extension.js")], bundle: true, minify: true, write: false, metafile: true,
    absWorkingDir: own, nodePaths: [modules], platform: "node", target: "node18", external: ["vscode"], legalComments: "none",
});
add("extension.js", bundle.outputFiles[0].contents);
// The language client runs this script to terminate a server that does not end. It expects the script next to its code.
const script = "terminateProcess.sh";
add(script, fs.readFileSync(path.join(modules, "vscode-languageclient/lib/node", script)), 0o100755);

// Collects the licences of the modules that the bundle contains.
const lock = JSON.parse(fs.readFileSync(path.join(own, "package-lock.json"), "utf8"));
const bundled = new Set(Object.keys(bundle.metafile.inputs)
    .map((input) => /^.*?(node_modules\/(?:.*node_modules\/)?(?:@[^/]+\/)?[^/]+)\//.exec(input)?.[1]).filter(Boolean));
let notices = "The extension contains these modules.\n";
for (const name of [...bundled].sort()) {
    const folder = path.join(modules, path.relative("node_modules", name));
    const licence = filesBelow(folder, (file) => /^licen[cs]e/i.test(file)).find((file) => path.dirname(file) === folder);
    notices += `\n---- ${path.relative("node_modules", name)} ${lock.packages[name].version} ----\n\n${fs.readFileSync(licence, "utf8").trim()}\n`;
}
add("ThirdPartyNotices.txt", strToU8(notices));

const target = process.argv[2] || path.join(own, `${about.name}-${about.version}.vsix`);
fs.writeFileSync(target, zipSync(files, { level: 9, mtime: new Date(1980, 0, 1) }));
console.log(`wrote ${target}: ${Object.keys(files).length} files`);
