#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# help.sh SCRIPTS : every command says what it does, and refuses what it does not know, before it
# installs or builds anything.
set -u
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
complain() {
  echo "$*"
  status=1
}
cp -r "$1" "$folder/scripts"
ln -s "$(realpath "$1/../sysc")" "$(realpath "$1/../ref")" "$folder"
"$1/setup.sh" --help >/dev/null || complain "setup.sh --help: exit status $?"
printf '#!/bin/sh\nexit 99\n' >"$folder/scripts/setup.sh"
for command in bench campaign demo format linuxcnc real_parts release synth test wheel; do
  text=$("$folder/scripts/$command.sh" --help) || complain "$command.sh --help: exit status $?"
  [ -n "$text" ] || complain "$command.sh --help says nothing"
done
refused() {
  command=$1
  shift
  "$folder/scripts/$command.sh" "$@" 2>/dev/null
  [ $? = 2 ] || complain "$command.sh $* is not refused"
}
refused campaign 1e9
refused campaign 0
refused bench more
refused linuxcnc more
refused test -L everything
refused format more
refused wheel more
refused release more
exit $status
