# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the tests of the installed library: a work folder, commands that print only when they fail, and the two
# installed trees.
#
# ctest sets: SOURCE, the source folder; CMAKE, CC and, if there is one, CXX; STATIC_BUILD and SHARED_BUILD, build
# folders of both kinds; TABOR, the program; INSPECT, host_inspect.
# shellcheck source=tests/support/skips.sh
. "$(dirname "${BASH_SOURCE[0]}")/skips.sh"

set -euo pipefail
export LC_ALL=C
: "${SOURCE:?}" "${CMAKE:?}" "${CC:?}"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

complain() {
  excuse
  echo "FAILED: $1" >&2
  exit 1
}

# quietly COMMAND...: prints its output only if it fails, which ends the test.
quietly() {
  "$@" >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; complain "$*"; }
}

# fresh_clone FOLDER: makes a clone of the source as if all its present files were committed.
fresh_clone() {
  needs git git
  needs tar tar
  git -C "$SOURCE" ls-files -z --cached --others --exclude-standard -- README.md >"$scratch/files" 2>&1 &&
    [ -s "$scratch/files" ] || skip "the source is not a git checkout"
  mkdir "$1"
  # Files that git tracks but that were removed cannot be copied.
  (cd "$SOURCE" && git ls-files -z --cached --others --exclude-standard | sort -zu |
    while IFS= read -r -d '' file; do if [ -e "$file" ]; then printf '%s\0' "$file"; fi; done |
    tar --null -T - -cf -) | tar -xf - -C "$1"
}

# committed_clone FOLDER: the same as a repository of one commit, which is the same in every folder.
committed_clone() {
  fresh_clone "$1"
  (cd "$1" && git init --quiet && git add --all &&
    GIT_AUTHOR_DATE="2026-01-01T00:00:00Z" GIT_COMMITTER_DATE="2026-01-01T00:00:00Z" \
      git -c user.name=nobody -c user.email=nobody@localhost commit --quiet --message present)
}

# install_tree BUILD-FOLDER FOLDER: installs into another folder and moves the tree to FOLDER: trees must be movable.
install_tree() {
  quietly "$CMAKE" --install "$1" --prefix "$scratch/elsewhere"
  mv "$scratch/elsewhere" "$2"
}

# use_pkg_config FOLDER: makes pkg-config find the tree in FOLDER.
use_pkg_config() {
  PKG_CONFIG_PATH=$(dirname "$(find "$1" -name tabor.pc)")
  export PKG_CONFIG_PATH
}

# library_folder FOLDER: prints the folder of the tree's library.
library_folder() { dirname "$(find "$1" -name 'libtabor.*' | head -n 1)"; }

# says_size PAGE WORDS BYTES: the page says after these words how many kB it is, to 2 %.
says_size() {
  local said
  said=$(grep -oE "$2 (some )?[0-9]+ kB" "$1" | grep -oE '[0-9]+' | head -n 1)
  awk "BEGIN { exit !(${said:-0} * 1000 >= 0.98 * $3 && ${said:-0} * 1000 <= 1.02 * $3) }" ||
    complain "${1##*/}: '$2 ${said:-no} kB', but it has $3 bytes"
}
