#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# In a system that has nothing but Debian's base, tools/demo installs all that it takes to do everything that the
# README's first page says, but the Python packages that the page itself names. Takes root, a network and some minutes.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"
# shellcheck source=tests/support/bare_system.sh
. "$(dirname "$0")/../support/bare_system.sh"

fresh_clone "$root/tabor"
within bash /tabor/tests/packaging/first_page.sh /tabor | tee said
grep -q '^SKIPPED: drawing' said || complain "a bare system has Python packages already"

# With the packages that the page names a trace is drawn as well.
read -ra packages <<<"$(grep -oE '`python3-[a-z]+`' "$SOURCE/README.md" | sort -u | tr -d '`' | xargs)"
[ ${#packages[@]} -gt 0 ] || complain "the page names no Python packages"
quietly within apt-get -q -y --no-install-recommends install "${packages[@]}"
drawing=$(grep -oE '^    tools/plot-trace [^#]*' "$SOURCE/README.md")
quietly within bash -c "cd /tabor && $drawing"
[ -s "$root/tabor/trace.png" ] || complain "$drawing draws nothing"
