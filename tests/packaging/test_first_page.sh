#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# In a fresh clone, with nothing in the home folder, every command of the README's first page does what it says.
# shellcheck source=tests/support/embed_checks.sh
. "$(dirname "$0")/../support/embed_checks.sh"

# shellcheck source=tests/support/find_python.sh
. "$(dirname "$0")/../support/find_python.sh"
if python=$(find_python numpy,matplotlib); then # the page calls whatever is python3
  mkdir bin
  ln -s "$(command -v "$python")" bin/python3
  PATH=$scratch/bin:$PATH
fi

fresh_clone "$scratch/clone"
mkdir "$scratch/home"
# What was compiled before is not compiled again (tools/build.sh), though the home folder is another one.
CCACHE_DIR=${CCACHE_DIR-$HOME/.cache/ccache}
export CCACHE_DIR
env -u DESTDIR -u LV2_PATH -u PKG_CONFIG_PATH -u XDG_CONFIG_HOME -u XDG_DATA_HOME HOME="$scratch/home" \
  bash "$SOURCE/tests/packaging/first_page.sh" "$scratch/clone"
