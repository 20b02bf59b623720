#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws docs/module_dependencies.svg, the dependencies between modules, from the includes of the code.
#   docs/module_dependencies.sh >docs/module_dependencies.svg
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."
modules='support ir syntax run bdd circuit read derive plant compose schedule emit check compare conform analyse explain report draw rpc simulate pipeline page lsp mcp edit app certify'
for module in $modules; do
    grep -rhoE --include='*.?pp' '^#include "[^"]+"' "src/$module" $([ ! -d "include/grafverif/$module" ] || echo "include/grafverif/$module") |
        sed -E 's|^#include "(grafverif/)?([^/"]+)/.*|\2|' | sort -u | sed "s/^/$module /"
done | awk -v names="$modules" '
    BEGIN { count = split(names, module, " "); for (k = 1; k <= count; ++k) place[module[k]] = k }
    $2 in place { reads[place[$1], place[$2]] = 1 }
    END {
        cell = 24; left = 90; top = 76; width = left + count * cell + 30; height = top + count * cell + 12
        printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\" font-size=\"12\">\n", width, height, width, height
        printf "<title>A blue square: the module of the row includes headers of the module of the column</title>\n"
        printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", width, height
        for (row = 1; row <= count; ++row) {
            y = top + (row - 1) * cell
            printf "<text x=\"%d\" y=\"%d\" text-anchor=\"end\" fill=\"#222\">%s</text>\n", left - 8, y + 16, module[row]
            printf "<text transform=\"translate(%d %d) rotate(-50)\" fill=\"#222\">%s</text>\n", left + (row - 1) * cell + 14, top - 6, module[row]
            for (column = 1; column <= count; ++column) {
                x = left + (column - 1) * cell
                fill = row == column ? "#cbd5e0" : (row, column) in reads ? "#2b6cb0" : "#f4f4f4"
                printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\"/>\n", x, y, cell - 2, cell - 2, fill
            }
        }
        print "</svg>"
    }'
