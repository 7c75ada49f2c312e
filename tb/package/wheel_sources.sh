#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# wheel_sources.sh ROOT: scripts/wheel.sh compiles the sources as they are, without those of an
# earlier wheel that are gone; the others keep their times, so that they are not compiled again.
set -euo pipefail
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
mkdir -p rtl hls ref sysc/python scripts .venv/bin
touch CMakeLists.txt LICENSE README.md sysc/python/pyproject.toml
touch ref/gone.hpp
touch -d "1 hour ago" ref/kept.hpp
cp "$1/scripts/wheel.sh" scripts
# Tools that compile nothing.
printf '#!/bin/sh\n' >scripts/setup.sh
printf '#!/bin/sh\ntouch ../curvecore.tar.gz ../made/one.whl\n' >.venv/bin/python3
printf '#!/bin/sh\ntouch ../one.whl\n' >.venv/bin/auditwheel
chmod +x scripts/setup.sh .venv/bin/*
scripts/wheel.sh >/dev/null
[ -e build/wheel/tree/ref/gone.hpp ]
rm ref/gone.hpp
scripts/wheel.sh >/dev/null
copy=build/wheel/tree/ref
[ ! -e $copy/gone.hpp ] || { echo "a source that is gone is compiled"; exit 1; }
[ ! $copy/kept.hpp -nt ref/kept.hpp ] || { echo "a source is compiled again"; exit 1; }
echo "the sources are those of the tree"
