#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# verible.sh LINT FORMAT FILE : style rules and format; `scripts/format.sh` mends the format.
set -eu
"$1" --rules_config "$(dirname "$0")/verible.rules" "$3"
"$2" --verify "$3" >/dev/null || {
  echo "$3: not formatted, run scripts/format.sh"
  exit 1
}
