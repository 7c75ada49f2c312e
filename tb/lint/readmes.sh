#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# readmes.sh ROOT : the front page fits on two screens, and every link to a file of this tree leads
# to one.
set -u
cd "$1" || exit 1
status=0
complain() {
  echo "$*"
  status=1
}
[ "$(wc -l <README.md)" -le 150 ] || complain "README.md: more than 150 lines"
for page in *.md */README.md .github/*.md; do
  for link in $(grep -oE '\]\([^)#]+' "$page" | cut -c3- | grep -v '^https\?:'); do
    [ -e "$(dirname "$page")/$link" ] || complain "$page: no file $link"
  done
done
exit $status
