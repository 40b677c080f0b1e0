#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The LV2 plugin in DawDreamer: sound to the bit, automation, many instances.
#
# test_lv2_dawdreamer.sh [INSTANCES]; it gets $BUNDLE, $TABOR and $SOURCE.
. "$(dirname "$0")/../../support/host_checks.sh"
# shellcheck source=tests/support/find_python.sh
. "$SOURCE/tests/support/find_python.sh"
: "${BUNDLE:?the bundle}"

python=$(find_python dawdreamer,mido,numpy,pedalboard) ||
  skip "there is no dawdreamer in build/python: tools/setup --python brings it"
# DawDreamer looks into ~/.lv2, whatever LV2_PATH says.
mkdir -p home/.lv2
ln -s "$BUNDLE" home/.lv2/tabor.lv2
check "what DawDreamer hears" env HOME="$PWD/home" "$python" "$SOURCE/tests/support/dawdreamer_host.py" urn:tabor:drum \
  "$TABOR" "$@"

finish
