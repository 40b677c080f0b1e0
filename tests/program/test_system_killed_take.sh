#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A performance that is killed leaves a sound file and a log that lack its last moments only.
#
# test_system_killed_take.sh [TAKES [SEED]]

. "$(dirname "$0")/../support/host_checks.sh"
: "${TYPIST:?host_typist}"
takes=${1:-3} seed=${2:-$RANDOM}
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$ TERM=xterm
rate=48000 frame_bytes=3
allowed=1.5 # [s] of sound that may be lost
most_delay=0.9 # [s] from the last look at the screen to the kill

echo "$takes takes, seed $seed"

# random SALT: prints a number from 0 to 1, the same for the same seed.
random() { awk -v seed="$seed$1" 'BEGIN { srand(seed); rand(); print rand() }'; }
# pick SALT WORD...: prints one of the words.
pick() {
  local salt=$1
  shift
  set -- "${@:$(awk "BEGIN { print 1 + int($# * $(random "$salt")) }"):1}"
  echo "$1"
}

# samples FILE FRAMES: prints the bytes of the sound's first frames.
samples() {
  local start=24 # of an AU file
  if [[ $1 == *.wav ]]; then start=$(($(grep -abo -m 1 data "$1" | head -n 1 | cut -d: -f1) + 8)); fi
  tail -c +$((start + 1)) "$1" | head -c $(($2 * frame_bytes))
}
# tag FILE: the format tag of a WAV file; 1 is plain PCM, 65534 WAVE_FORMAT_EXTENSIBLE, which trackers refuse.
tag() {
  local at
  at=$(grep -abo -m 1 'fmt ' "$1" | head -n 1 | cut -d: -f1)
  od -An -t u2 -j $((at + 8)) -N 2 "$1" | tr -d ' '
}
frames_of() { "$INSPECT" sound "$1" | cut -d' ' -f5; }
same_samples() { cmp <(samples "$1" "$3") <(samples "$2" "$3"); }

# write_performance NUMBER: strokes, and what somebody types who kills the program after `second` seconds and `delay` more.
write_performance() {
  awk -v seed="$seed$1" 'BEGIN {
    srand(seed)
    print "time,velocity,radius,angle"
    for (t = 0; t < 8; t += 0.02 + 0.3 * rand()) {
      printf "%.6f,%.4f,%.2f%%,%.1f\n", t, 0.3 * exp(3 * rand()), 100 * rand(), 360 * rand()
    }
  }' >random.csv
  second=$(pick "$1"1 1 2 3 4)
  delay=$(awk "BEGIN { printf \"%.4f\", $most_delay * $(random "$1"2) }")
  {
    printf 'wait ? help\nraw\ntype %s\ntype %s\\r\n' "$(pick "$1"3 s n f)" \
      "$(pick "$1"4 ':set batter.tension 3100' ':set wires.tension 12' ':preset tom-12' ':gain -12')"
    printf 'wait REC 0:0%s\nsleep %s\nshow\nsignal 9\n' "$second" "$delay"
  } >script
}

# kill_take NAME NUMBER ARGUMENT...: plays and is killed. False if the machine was too slow to see the second.
kill_take() {
  local name=$1 number=$2
  shift 2
  write_performance "$number"
  "$TYPIST" script "$TABOR" play tabor --backend null --quality draft --events random.csv --record "$name" \
    --log take.log "$@" >typed
}

# check_replay NAME: the log gives the sound of the recording, as far as both go.
check_replay() {
  local part=${1%.*}.part.${1##*.} common
  recorded=$(frames_of "$part")
  run render -q --replay take.part.log -o "again-$1"
  logged=$(frames_of "again-$1")
  common=$((recorded < logged ? recorded : logged))
  same "status of the replay" 0 "$status"
  check "the replay says where the log ends" grep -q \
    "^tabor: warning: 'take.part.log' ends after $(awk "BEGIN { printf \"%.1f\", $logged / $rate }") s without its end; the sound stops there\$" "$err"
  holds "there is a sound: $common frames" "$common > 0"
  check "the replay gives the same bits, for $common frames" same_samples "$part" "again-$1" "$common"
}

# one_take NAME NUMBER ARGUMENT...: a take. False if more sound than allowed was lost.
one_take() {
  local name=$1 number=$2
  rm -f take.part* again-*
  kill_take "$@" || return 1
  same "status of a program that is killed" "status 137" "$(grep '^status' typed)"
  same "files" "$(printf '%s\n' "${name%.*}.part.${name##*.}" take.part.log | sort)" "$(printf '%s\n' take* | sort)"
  if [[ $name == *.wav ]]; then same "the tag of $name" 1 "$(tag "${name%.*}.part.wav")"; fi
  check_replay "$name"
  read -r lost_sound lost_log < <(awk "BEGIN { played = $second + $delay
    print played - $recorded / $rate, played - $logged / $rate }")
  echo "take $number, $name: killed $second s + $delay s; lost $lost_sound s of the sound, $lost_log s of the log"
  awk "BEGIN { exit !($lost_sound <= $allowed && $lost_log <= $allowed) }"
}

# ---- killed at random ----

# Without a known length the file may become an RF64.
for ((take = 1; take <= takes; take++)); do
  case $((take % 3)) in
    1) in_time 0.5 "take $take" one_take take.wav $take --duration 60 ;;
    2) in_time 0.5 "take $take" one_take take.au $take ;;
    *) in_time 0.5 "take $take" one_take take.wav $take ;;
  esac
done

# ---- who asks for a killed take's log is told where it is ----

run render -q --replay take.log
same "status" 1 "$status"
check "the log's name" grep -qx "tabor: cannot read 'take.log': No such file or directory; there is 'take.part.log', which was not completed" "$err"

# ---- what is left of a killed take stays ----

rm -f take*
for kept in take.part.wav take.part-2.wav take.part.log; do echo "left of $kept" >$kept; done
before=$(cksum take.part*)
"$TABOR" play tabor -q --backend null --quality draft --record take.wav --log take.log </dev/null >"$out" 2>"$err" &
player=$!
check "a free name is found for the sound" wait_for test -e take.part-3.wav
check "a free name is found for the log" wait_for grep -qs played take.part-2.log
kill -INT $player
wait $player
same "status after SIGINT" 130 $?
same "the tag of a take that SIGINT ended" 1 "$(tag take.wav)"
same "files" "take.log take.part-2.wav take.part.log take.part.wav take.wav" "$(echo take*)"
same "what was left stays" "$before" "$(cksum take.part*)"

# ---- names ----

# named LOG PART: the log is called PART until it is complete.
named() {
  "$TABOR" play tabor -q --backend null --quality draft --log "$1" </dev/null >"$out" 2>"$err" &
  player=$!
  check "'$1' is called '$2' while the drum plays" wait_for grep -qs played "$2"
  kill -INT $player
  wait $player
  check "'$1' has its name in the end" test -s "$1" -a ! -e "$2"
}
mkdir dotted.folder
named take take.part
named dotted.folder/take dotted.folder/take.part
named .hidden .hidden.part
named take.1.log take.1.part.log
ln -s dotted.folder/take link.log
named link.log dotted.folder/take.part
longest=$(printf 'a%.0s' {1..251}).log
done_quietly play tabor -q --backend null --quality draft --duration 0.1 --log "$longest"
check "a name without room for more" test -s "$longest"

# ---- a normal end leaves nothing else ----

rm -f take*
done_quietly play tabor -q --backend file --record take.wav --log take.log --quality draft --duration 2
same "files after a normal end" "take.log take.wav" "$(echo take*)"
same "there is no mark in the log" 0 "$(grep -c played take.log)"

finish
