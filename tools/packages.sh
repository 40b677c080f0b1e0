# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the commands beside it: what the system knows of a package of Debian.

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

is_available() {
  [[ $(apt-cache policy "$1" 2>/dev/null) == *"Candidate: "[!\(]* ]]
}
