#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws docs/rooms.svg from the includes of the code: which room reads which. A room reads rooms above it only.
#   docs/rooms.sh >docs/rooms.svg
set -euo pipefail
export LC_ALL=C
cd "$(dirname "${BASH_SOURCE[0]}")/.."
rooms='support ir syntax run bdd circuit read derive plant compose schedule emit check conform analyse explain report simulate pipeline page app'
for room in $rooms; do
    grep -rhoE --include='*.?pp' '^#include "[^"]+"' "src/$room" $([ ! -d "include/grafverif/$room" ] || echo "include/grafverif/$room") |
        sed -E 's|^#include "(grafverif/)?([^/"]+)/.*|\2|' | sort -u | sed "s/^/$room /"
done | awk -v names="$rooms" '
    BEGIN { count = split(names, room, " "); for (k = 1; k <= count; ++k) place[room[k]] = k }
    $2 in place { reads[place[$1], place[$2]] = 1 }
    END {
        cell = 24; left = 90; top = 76; width = left + count * cell + 30; height = top + count * cell + 12
        printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\" font-size=\"12\">\n", width, height, width, height
        printf "<title>The room of a row reads headers of the room of a column where the square is blue</title>\n"
        printf "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n", width, height
        for (row = 1; row <= count; ++row) {
            y = top + (row - 1) * cell
            printf "<text x=\"%d\" y=\"%d\" text-anchor=\"end\" fill=\"#222\">%s</text>\n", left - 8, y + 16, room[row]
            printf "<text transform=\"translate(%d %d) rotate(-50)\" fill=\"#222\">%s</text>\n", left + (row - 1) * cell + 14, top - 6, room[row]
            for (column = 1; column <= count; ++column) {
                x = left + (column - 1) * cell
                fill = row == column ? "#cbd5e0" : (row, column) in reads ? "#2b6cb0" : "#f4f4f4"
                printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\"/>\n", x, y, cell - 2, cell - 2, fill
            }
        }
        print "</svg>"
    }'
