#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Output files: complete or not there at all, and what was there before stays until then.

. "$(dirname "$0")/../support/host_checks.sh"

short=(tabor -q --quality draft --duration 0.05)
long=(render tabor -q --quality draft --duration 3600 --rate 192000)

# no_leftovers WHAT: no temporary file is in the folder.
no_leftovers() { same "leftovers after $1" '' "$(find . -name '.tabor*')"; }

frames() { "$INSPECT" sound "$1" | cut -d ' ' -f 5; }

# ---- replacing ----

done_quietly render "${short[@]}"
same "the default output" 2400 "$(frames strike.wav)"
cp strike.wav plain.wav
echo old >target.wav
chmod 640 target.wav
ln target.wav hard.wav
done_quietly render "${short[@]}" -o target.wav
check "an old file is replaced" cmp -s target.wav plain.wav
same "its permissions stay" 640 "$(stat -c %a target.wav)"
same "by a new file, not by overwriting" old "$(cat hard.wav)"
(umask 027 && exec "$TABOR" render "${short[@]}" -o masked.wav)
same "permissions of a new file" 640 "$(stat -c %a masked.wav)"
no_leftovers replacing

echo old >target.wav
ln -s target.wav link.wav
done_quietly render "${short[@]}" -o link.wav
same "a link stays" target.wav "$(readlink link.wav)"
check "and its file is written" cmp -s target.wav plain.wav
mkdir sub
ln -s sub/new.wav dangling.wav
done_quietly render "${short[@]}" -o dangling.wav
same "a dangling link stays" sub/new.wav "$(readlink dangling.wav)"
check "and its file is created" cmp -s sub/new.wav plain.wav
done_quietly render "${short[@]}" -o "$PWD/sub/absolute.wav"
check "an absolute path" cmp -s sub/absolute.wav plain.wav
done_quietly render "${short[@]}" -o=odd.wav
check "a name with '='" cmp -s =odd.wav plain.wav
done_quietly render "${short[@]}" --output=UPPER.WAV
check "an extension in capitals" cmp -s UPPER.WAV plain.wav

# ---- what may not be written ----

failed "it is a folder" render "${short[@]}" -o sub
mkdir folder.wav
failed "it is a folder" render "${short[@]}" -o folder.wav
failed "it is a folder" render "${short[@]}" --trace sub
failed "No such file" render "${short[@]}" -o missing/a.wav
failed "No such file" render "${short[@]}" --trace missing/a.csv
failed "Not a directory" render "${short[@]}" -o plain.wav/a.wav
echo precious >protected.wav
chmod 444 protected.wav
failed "write-protected" render "${short[@]}" -o protected.wav
failed "write-protected" render "${short[@]}" --trace protected.wav
ln -s protected.wav to-protected.wav
failed "write-protected" render "${short[@]}" -o to-protected.wav
ln -s loop.wav loop.wav
failed "symbolic links" render "${short[@]}" -o loop.wav
failed "name too long|File name too long" render "${short[@]}" -o "$(printf 'x%.0s' {1..300}).wav"
failed "exists" render "${short[@]}" -n -o plain.wav
failed "exists" render "${short[@]}" -n
failed "exists" render "${short[@]}" -n -o new.wav --trace plain.wav
failed "exists" render "${short[@]}" --no-overwrite -o link.wav
done_quietly render "${short[@]}" -n -o new.wav
check "-n writes a new file" cmp -s new.wav plain.wav
if [ "$(id -u)" != 0 ]; then
  mkdir closed
  chmod 555 closed
  failed "Permission denied" render "${short[@]}" -o closed/a.wav
fi

# A file that appears while the drum plays is not overwritten either. (The trace keeps it playing for a second,
# and longer on a busy machine.)
nice -n 5 "$TABOR" render tabor -q -n --duration 10 --quality draft -o late.wav --trace late.csv 2>"$err" &
child=$!
check "rendering has begun" wait_for eval 'ls .tabor-* >/dev/null 2>&1'
echo first >late.wav
wait $child
status=$?
: >"$out"
expect_error 1 "late.wav.*exists"
same "the file that came first" first "$(cat late.wav)"
no_leftovers -n

# ---- full disks and limits ----

failed "No space left" render "${short[@]}" -o /dev/full
ln -s /dev/full full.wav
ln -s /dev/full full.flac
failed "No space left" render "${short[@]}" -o full.wav
failed "No space left" render "${short[@]}" -o full.flac
failed "No space left" render "${short[@]}" -o kept.wav --trace /dev/full
for data in "render ${short[*]} -o -" "render tabor --quality draft --duration 0.05 --json -o json.wav" presets \
  "presets --json" show "show --json" "modes tabor --quality draft" "modes tabor --json --quality draft" --help "render --help" --version; do
  # shellcheck disable=SC2086
  "$TABOR" $data >/dev/full 2>"$err"
  status=$?
  : >"$out"
  expect_error 1 "standard output: No space left"
  # shellcheck disable=SC2086
  "$TABOR" $data >&- 2>"$err"
  status=$?
  expect_error 1 "standard output: Bad file descriptor"
done
rm -f json.wav
done_quietly render "${short[@]}" -o /dev/null

# limited ARGUMENT...: the same as failed, under a limit of the size of files.
limited() {
  local before
  before=$(snapshot)
  (
    ulimit -f 8
    exec "$TABOR" "$@"
  ) >"$out" 2>"$err"
  status=$?
  expect_error 1 "File too large"
  same "folder after: $*" "$before" "$(snapshot)"
}
limited render tabor -q --quality draft --duration 1 -o new.wav
limited render tabor -q --quality draft --duration 1 -o brand-new.wav
limited render tabor -q --quality draft --duration 1 -o new.au
limited render tabor -q --quality draft --duration 1 -o new.flac --format pcm24 --gain 20
limited render tabor -q --quality draft --duration 0.01 --format pcm16 -o ok.wav --trace new.csv
limited render tabor -q --quality draft --duration 1 --format float -o /dev/null
limited render tabor -q --quality draft --duration 1 --normalize -o new.wav
limited render tabor -q --quality draft --duration 1 --split -o new.wav

# Every single write may be the one that fails, the last one of the header too.
# traced OPTION... -- ARGUMENT...: runs the program under strace.
traced() {
  ASAN_OPTIONS=detect_leaks=0 strace -f -qq -o "$private/calls" "$@" >"$out" 2>"$err"
}
if ! command -v strace >/dev/null; then
  skip_part "failing writes: needs strace"
elif traced -e trace=write true; then
  for name in plain.wav plain.flac plain.au; do
    words=("$TABOR" render "${short[@]}" -o "$name" --trace whole.csv)
    traced -e trace=write "${words[@]}"
    writes=$(wc -l <"$private/calls")
    check "$name takes some writes" test "$writes" -gt 5
    before=$(snapshot)
    for k in 1 2 3 4 5 $((writes / 2)) $((writes - 1)) "$writes"; do
      traced -e trace=write -e inject=write:error=ENOSPC:when="$k" "${words[@]}"
      status=$?
      expect_error 1 "No space left"
      same "folder after failed write $k of $writes to $name" "$before" "$(snapshot)"
    done
  done
else
  skip_part "failing writes: strace may not look into programs here"
fi

# A reader that leaves early ends the program with an error, not with a signal.
mkfifo gone.au
head -c 100 gone.au >/dev/null &
run render tabor -q --quality draft --duration 2 -o gone.au
wait
expect_error 1 "Broken pipe"
"$TABOR" render tabor -q --quality draft --duration 2 -o - 2>"$err" | head -c 100 >/dev/null
status=${PIPESTATUS[0]}
same "a stream that nobody reads any more" "141 " "$status $(cat "$err")"
for data in "render ${short[*]} -o -" presets "presets --json" show "modes tabor --quality draft" --help; do
  # shellcheck disable=SC2086
  exec 9> >(:)
  wait $! # for the reader to be gone
  "$TABOR" $data >&9 2>"$err"
  same "nobody reads: $data" "141 " "$? $(cat "$err")"
  exec 9>&-
done

# ---- pipes ----

done_quietly render "${short[@]}" -o plain.au
for name in pipe.au pipe.wav pipe.flac pipe; do
  mkfifo $name
  cat $name >received &
  done_quietly render "${short[@]}" -o $name
  wait
  check "the sound through $name" "$INSPECT" equal received plain.wav
  check "$name is still a pipe" test -p $name
done
mkfifo pipe.csv
cat pipe.csv >received &
done_quietly render "${short[@]}" -o plain.wav --trace pipe.csv
wait
same "rows through a pipe" 2401 "$(wc -l <received)"
"$TABOR" render "${short[@]}" -o - | cat >stream.au
same "a stream" "au pcm24 48000 1 2400" "$("$INSPECT" sound stream.au)"
check "its sound" "$INSPECT" equal stream.au plain.wav
"$TABOR" render "${short[@]}" -o - >redirected.au
check "redirected" cmp -s redirected.au plain.au
echo before >appended
"$TABOR" render "${short[@]}" -o /dev/stdout >>appended
tail -c +8 appended >tail.au
check "appended" cmp -s tail.au plain.au

# ---- signals ----

mics=$(mics_of tabor)
# A model that takes long is announced before it is built, and a signal ends it.
largest=(--set wires.count=40 --set quality.wire_points=400 --set shell.radius=0.6 --quality reference --rate 192000)
"$TABOR" render "${largest[@]}" -o largest.wav >"$out" 2>"$err" &
builder=$!
check "a long build is announced" wait_for grep -q "takes some [0-9]* s and .* MB of memory; wires.count costs the most" "$err"
kill -INT $builder
wait $builder
same "status of a build after SIGINT" 130 $?
check "no sound of it" test ! -e largest.wav

for name in plain.wav interrupted.wav interrupted.flac interrupted.au; do
  interrupted INT 130 1 "${long[@]}" -o $name
  interrupted TERM 143 1 "${long[@]}" -o $name
done
interrupted TERM 143 2 "${long[@]}" -o interrupted.wav --trace interrupted.csv
interrupted TERM 143 $((mics + 1)) "${long[@]}" -o interrupted.wav --split --trace interrupted.csv
interrupted INT 130 "$mics" "${long[@]}" -o interrupted.wav --split --normalize
interrupted INT 130 1 "${long[@]}" -o /dev/null --trace interrupted.csv
interrupted HUP 129 1 "${long[@]}" -o plain.wav
ulimit -c 0
interrupted QUIT 131 $((mics + 1)) "${long[@]}" -o plain.wav --split --trace interrupted.csv
"$TABOR" render "${short[@]}" -o pipe.au 2>"$err" & # nobody reads
child=$!
check "it is on its way" wait_for catches $child 15
kill -TERM $child
wait $child
same "status while it waits for a reader" 143 $?
# shellcheck disable=SC2217 # it shall not read
sleep 300 >pipe.au <pipe.au & # somebody who does not read either
holder=$!
"$TABOR" render tabor -q --quality draft --duration 60 -o pipe.au 2>"$err" &
child=$!
check "it is on its way" wait_for catches $child 2
kill -INT $child
wait $child
same "status while the pipe is full" 130 $?
kill $holder
wait $holder 2>"$err"

finish
