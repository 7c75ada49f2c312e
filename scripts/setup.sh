#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what curvecore needs and this machine lacks, at the versions of scripts/versions.env:
# Debian packages with apt, Python packages into .venv.  Says what it does; does nothing (in a
# fraction of a second) when everything is there.  Made for Debian 12.
#
#   scripts/setup.sh [run|site]     run: what builds the program and runs a part, no more;
#                                   site: what scripts/site.sh needs besides that
set -euo pipefail
case ${1:-} in
  "" | run | site) ;;
  -h | --help)
    sed -n '3,8s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
  *)
    echo "setup: '$1' is not known: run, site, or nothing for all" >&2
    exit 2
    ;;
esac
only=${1:-}
cd "$(dirname "$0")/.."
source scripts/versions.env

say() { echo "setup: $*"; }

# 1:1.2.3+ds-4+b1 -> 1.2.3+ds: what the authors released, without Debian's epoch and revision
upstream() {
  local version=${1#*:}
  echo "${version%-*}"
}

# Prints the installed version of every package named, as name=version.
installed() {
  dpkg-query -W -f '${db:Status-Abbrev} ${Package}=${Version}\n' "$@" 2>/dev/null |
    sed -n 's/^ii *//p'
}

# Installs the packages named, as name=version.
install_debian_packages() {
  local missing=() pin name version have
  have=$(installed $(printf '%s\n' "$@" | sed 's/=.*//')) || true
  for pin in "$@"; do
    name=${pin%%=*}
    version=$(sed -n "s/^$name=//p" <<<"$have")
    if [ -z "$version" ]; then
      missing+=("$pin")
    elif [ "$(upstream "$version")" != "$(upstream "${pin#*=}")" ]; then
      say "warning: $name is $version, curvecore was measured with ${pin#*=}"
    fi
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  local root=()
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || {
      say "error: these packages are missing, and only root can install them: ${missing[*]}" >&2
      exit 1
    }
    root=(sudo)
  fi
  say "apt-get update"
  "${root[@]}" apt-get update -qq
  local wanted=()
  for pin in "${missing[@]}"; do
    name=${pin%%=*}
    if apt-cache madison "$name" | awk '{print $3}' | grep -xF "${pin#*=}" >/dev/null; then
      wanted+=("$pin")
    else
      version=$(apt-cache policy "$name" | sed -n 's/^ *Candidate: //p')
      say "warning: $pin is no longer offered, taking $version"
      wanted+=("$name")
    fi
  done
  say "apt-get install ${wanted[*]}"
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${wanted[@]}" >/dev/null
}

# Installs the Python packages named into a virtual environment.
install_python_packages() {
  local venv=$1 wanted stamp=$1/curvecore-packages
  shift
  wanted=$(printf '%s\n' "$@")
  [ -x "$venv/bin/python" ] && [ "$wanted" = "$(cat "$stamp" 2>/dev/null)" ] && return 0
  say "Python packages into $venv (the YoWASP tools in .venv are large: a minute or so)"
  [ -x "$venv/bin/python" ] || python3 -m venv "$venv"
  # --no-deps: the list is complete, and of hls4ml only the headers in it are used
  "$venv/bin/pip" install --quiet --disable-pip-version-check --no-deps -r <(echo "$wanted")
  echo "$wanted" >"$stamp"
}

[ "$(. /etc/os-release && echo "$ID-${VERSION_ID:-}")" = debian-12 ] ||
  say "warning: this is not Debian 12; going on as if it were"
if [ "$only" = run ]; then
  install_debian_packages $APT_PACKAGES_RUN
elif [ "$only" = site ]; then
  install_debian_packages $APT_PACKAGES_RUN $APT_PACKAGES_SITE
  install_python_packages build/site/venv $PIP_PACKAGES_SITE
else
  install_debian_packages $APT_PACKAGES_RUN $APT_PACKAGES_TEST
  install_python_packages .venv $PIP_PACKAGES
fi
