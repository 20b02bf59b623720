#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The pictures of the documents: docs/pictures.sh GRAFVERIF (such as build/run/bin/grafverif). The samples are drawn; the player
# of the README's counterexample is photographed in Chromium.
set -euo pipefail
grafverif=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in samples/*/*.grafcet; do
    "$grafverif" draw "$file" -o "${file%.grafcet}.svg"
done
GRAFVERIF_PROGRAM=$grafverif tests/browser/run picture.py "$PWD/docs/player.png"
