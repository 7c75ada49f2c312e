#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Makes the site of pages, with a demo of planner and kernel in WebAssembly. It needs no server and
# no network: open build/site/html/index.html.
#
#   scripts/site.sh     build/site/html; some 15 minutes at first, the program's included
set -euo pipefail
case ${1:-} in
  "") ;;
  -h | --help)
    sed -n '3,6s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "site: '$1' is not known: it takes no option" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
scripts/setup.sh site
if [ -z "${CURVECORE_PROGRAM:-}" ]; then
  tests=$(sed -n 's/^CURVECORE_TESTS:BOOL=//p' build/release/CMakeCache.txt 2>/dev/null) || true
  cmake --preset release --no-warn-unused-cli -DCURVECORE_TESTS="${tests:-OFF}" >/dev/null
  cmake --build --preset release -j "$(nproc)" --target curvecore
  CURVECORE_PROGRAM=build/curvecore
fi
to=build/site
python3 scripts/site/wasm.py --build $to/wasm -j "${CURVECORE_JOBS:-$(nproc)}"
$to/venv/bin/python3 scripts/site/make_docs.py --program "$CURVECORE_PROGRAM" --wasm $to/wasm \
  --build $to
NO_MKDOCS_2_WARNING=1 $to/venv/bin/mkdocs build --quiet --strict -f $to/mkdocs.yml
python3 scripts/site/check_links.py $to/html
echo "site  $PWD/$to/html/index.html"
