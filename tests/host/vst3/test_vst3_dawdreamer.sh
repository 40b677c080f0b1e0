#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The VST3 plugin in DawDreamer: sound to the bit, automation, many instances.
#
# test_vst3_dawdreamer.sh [INSTANCES]; it gets $BUNDLE, $TABOR and $SOURCE.
. "$(dirname "$0")/../../support/host_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"
: "${BUNDLE:?the bundle}"

python=$(find_python dawdreamer,mido,numpy,pedalboard) ||
  skip "there is no dawdreamer in build/python: tools/setup --python brings it"
check "what DawDreamer hears" "$python" "$SOURCE/tests/support/dawdreamer_host.py" "$BUNDLE" "$TABOR" "$@"

finish
