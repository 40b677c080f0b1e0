#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# No script has an error or a warning that its checker finds.
#
# test_shell.sh SOURCE-FOLDER
set -euo pipefail
source=$1
# shellcheck source=tests/support/skips.sh
. "$source/tests/support/skips.sh"
checker=$source/build/python/environment/bin/shellcheck
[ -x "$checker" ] || skip "there is no shellcheck in build/python: tools/setup --python brings it"
cd "$source"
mapfile -t scripts < <({ find tests tools .ci host -type f -name '*.sh'; grep -lE '^#!/usr/bin/env bash' tools/* .ci/* 2>/dev/null; } | sort -u)
"$checker" --external-sources --severity warning "${scripts[@]}"
echo "${#scripts[@]} scripts"
[ "${#scripts[@]}" -gt 100 ]
