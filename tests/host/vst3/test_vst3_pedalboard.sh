#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The VST3 plugins in a host of others, pedalboard, which needs no display: parameters, sound to the bit, threads, states.
#
# It gets $BUNDLE, $TABOR, $SOURCE, and $VST3_HOST, which plays what pedalboard cannot.
. "$(dirname "$0")/../../support/host_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"
: "${BUNDLE:?the bundle}" "${VST3_HOST:?vst3_host}"

python=$(find_python mido,numpy,pedalboard) ||
  skip "there is no pedalboard in build/python: tools/setup --python brings it"
check "what pedalboard hears" "$python" "$(dirname "$0")/pedalboard_host.py" "$BUNDLE" "$TABOR"

finish
