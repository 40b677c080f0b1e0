#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/check-arm, check-web and check-windows configure what they build, whatever a build folder was told to leave
# out before. Nothing is built: cmake and the compilers stand in.
#
# test_check_builds.sh SOURCE-FOLDER
set -euo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong=0

mkdir -p "$work/tree/tests" "$work/bin" "$work"/tree/build/{arm64/root,windows-libraries/lib/pkgconfig}
cp -r "$source/tools" "$work/tree/"
cp -r "$source/tests/support" "$work/tree/tests/"
touch "$work/tree/build/arm64/root/complete" "$work/tree/build/windows-libraries/lib/pkgconfig/cairo-win32-font.pc"
for tool in aarch64-linux-gnu-gcc aarch64-linux-gnu-objdump qemu-aarch64-static pkg-config emcc em-config node \
  x86_64-w64-mingw32-gcc-posix wine Xvfb; do
  printf '#!/bin/sh\nexit 1\n' >"$work/bin/$tool"
done
# It notes how it configures, and builds nothing.
cat >"$work/bin/cmake" <<END
#!/bin/sh
case \$1 in --build) ;; *) echo "\$*" >>"$work/configured" ;; esac
END
chmod +x "$work"/bin/*

# configures TOOL OPTION FOLDER...: the tool configures the builds in these folders with this option.
configures() {
  local tool=$1 option=$2 folder
  shift 2
  rm -f "$work/configured"
  PATH=$work/bin:$PATH "$work/tree/tools/$tool" >"$work/said" 2>&1 || true # there is nothing to run
  for folder in "$@"; do
    grep -E -- "--preset $folder |/build/$folder/" "$work/configured" | grep -qe "$option" && continue
    echo "FAILED: $tool configures build/$folder without $option:"
    sed 's/^/| /' "$work/configured" "$work/said"
    wrong=$((wrong + 1))
  done
}

configures check-arm -DTABOR_BUILD_TESTS=ON release arm64
configures check-web -DTABOR_BUILD_TESTS=ON release web
configures check-windows -DTABOR_BUILD_PROGRAM=ON release windows
configures check-windows -DTABOR_BUILD_TESTS=ON windows
echo "test_check_builds: $wrong failed"
[ "$wrong" -eq 0 ]
