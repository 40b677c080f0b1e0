# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by tests that show a folder to a browser, after embed_checks.sh.

server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; wait; rm -rf "$scratch"' EXIT

# serve_folder FOLDER: serves it until the test ends. $address is where.
serve_folder() {
  node "$SOURCE/web/serve.mjs" "$1" 0 >address 2>&1 & # any free port, which it prints
  server=$!
  for ((i = 0; i < 100; i++)); do
    if [ -s address ]; then break; fi
    sleep 0.1
  done
  address=$(cat address)
  [[ $address == http://127.0.0.1:* ]] || complain "the server says: $address"
}
