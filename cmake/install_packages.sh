# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
#
# Sourced by ./run and ./test: install_packages GROUP... installs those packages of packages.txt
# that are missing. Nothing is asked, and apt is left alone when nothing is missing.

packages_file="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

# The packages of the groups, one a line.
list_packages() {
  local group
  for group in "$@"; do
    awk -v group="$group" '$1 == group { print $2 }' "$packages_file"
  done
}

is_installed() {
  [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

# What to put before a command to run it as root: nothing, sudo, or failure if there is no way.
root_prefix() {
  if [[ "$(id -u)" == 0 ]]; then
    return 0
  elif sudo -n true 2>/dev/null; then
    echo "sudo -n"
  elif [[ -t 0 ]] && command -v sudo >/dev/null; then
    echo "sudo"
  else
    return 1
  fi
}

install_packages() {
  local package prefix apt
  local -a missing=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "no apt-get here; the names in Debian of what is needed: $(list_packages "$@" | xargs)" >&2
    return 0
  fi
  for package in $(list_packages "$@"); do
    is_installed "$package" || missing+=("$package")
  done
  if [[ ${#missing[@]} == 0 ]]; then return 0; fi

  if ! prefix="$(root_prefix)"; then
    echo "missing packages, and neither root nor sudo to install them; as root, please:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    return 1
  fi
  echo "installing ${missing[*]}" >&2
  apt="$prefix env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0"
  $apt update </dev/null >&2
  $apt install --yes --no-install-recommends "${missing[@]}" </dev/null >&2
}
