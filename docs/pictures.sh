#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The drawings of the samples, for their pages: docs/pictures.sh GRAFVERIF (such as build/run/bin/grafverif)
set -euo pipefail
grafverif=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for file in samples/*/*.grafcet; do
    "$grafverif" draw "$file" -o "${file%.grafcet}.svg"
done
