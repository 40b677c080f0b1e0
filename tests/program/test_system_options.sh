#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Every option of `tabor render` and `tabor play`, with a drum and with a kit: what one takes the other takes, but for what is
# refused here, in a line that says why.
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
export JACK_NO_START_SERVER=1 JACK_DEFAULT_SERVER=tabor-test-none-$$

# One stroke on a snare drum; the same as rows of a table; a log of each; a sound.
printf 'MThd\0\0\0\6\0\0\0\1\1\340MTrk\0\0\0\10\0\231\46\144\0\377\57\0' >song.mid
printf 'time,drum\n0,snare\n' >kit.csv
printf 'time\n0\n' >drum.csv
printf '[keys]\nf1 = quit\n' >keys.ini
printf '[note.50]\nstroke = rimshot\n' >map.ini
printf '[drum.snare]\npreset = frame-drum\nhead = 38\n' >kit.ini
cp kit.ini drum.ini
done_quietly render frame-drum --quality draft --duration 0.02 -q -o sound.wav
done_quietly play frame-drum -q --quality draft --backend file --duration 0.02 --record log.wav --log drum.log --midi-file song.mid
done_quietly play --kit ./kit.ini -q --quality draft --backend file --duration 0.02 --record log.wav --log kit.log --midi-file song.mid

# The value of an option for a drum or a kit; "-" is one without. The options of a sound from outside come with it.
value_of() {
  case $2 in
    output) echo out.wav ;; format) echo float ;; rate) echo 44100 ;; quality) echo draft ;; duration) echo 0.02 ;;
    strike) if [ "$1" = kit ]; then echo drum=snare,velocity=2; else echo velocity=2; fi ;;
    events) echo "$1.csv" ;; replay) echo "$1.log" ;; midi-file) echo song.mid ;; mask-time) echo 5 ;; kit) echo ./kit.ini ;;
    map) echo roland ;; place-cc) echo 16,18 ;; midi-map) echo map.ini ;; midi-channel) echo 10 ;; velocity-curve) echo hard ;;
    velocity-range) echo full ;; humanize) echo 0.5 ;; seed) echo 3 ;;
    set) if [ "$1" = kit ]; then echo drum.snare.batter.tension=4000; else echo batter.tension=4000; fi ;;
    jobs) echo 1 ;; mic) echo top ;; input) echo sound.wav ;; input-level) echo 1 ;; input-mic) echo top ;; gain) echo -3 ;;
    trace) echo trace.csv ;; backend) echo null ;; device) echo none ;; buffer) echo 64 ;; record) echo take.wav ;; log) echo take.log ;;
    midi-in) echo none ;; keys) echo keys.ini ;; count) echo 2 ;;
    vary) if [ "$1" = kit ]; then echo drum.snare.batter.tension=3000..4000; else echo batter.tension=3000..4000; fi ;;
    no-overwrite | strict | each | stereo | split | normalize | verbose | json | quiet | no-ui | help | version) echo - ;;
    *) return 1 ;;
  esac
}

# What makes sense for one of both alone, or needs another one, which is tried elsewhere.
expected() {
  case "$1 $2 $3" in
    *" kit midi-map" | *" kit mic") echo "has notes for its drums, and a mix of its own" ;;
    "render kit trace" | "render kit input"*) echo "has notes for its drums, and a mix of its own" ;;
    *" drum map" | *" drum place-cc") echo "needs --kit" ;;
    *" kit place-cc") echo "needs --map" ;;
    "render drum input-"*) echo "input" ;;
    "render "*" each") echo "folder" ;;
    "render "*" vary") echo "needs --count" ;;
    "render "*" count") echo "needs --vary" ;;
    "render kit replay") echo "--replay and --kit" ;;
    "render drum replay") echo "--replay and 'frame-drum'" ;;
    "play "*" device") echo "--device: only" ;;
    "play drum kit" | "render drum kit") echo "--kit and 'frame-drum'" ;;
  esac
}

# tried COMMAND WHAT OPTION ARGUMENT...
tried() {
  local command=$1 what=$2 option=$3 reason
  shift 3
  rm -f out.wav take.* trace.csv
  reason=$(expected "$command" "$what" "$option")
  "$TABOR" "$command" "$@" </dev/null >"$out" 2>"$err"
  status=$?
  if [ -z "$reason" ]; then
    same "$command --$option with a $what: $(head -n 1 "$err")" 0 "$status"
  else
    same "$command --$option with a $what is refused" "2 1" "$status $(grep -c -e "$reason" "$err")"
  fi
}

for command in render play; do
  "$TABOR" "$command" --help | sed -n 's/^ *\(-., \)\?--\([a-z-]*\).*/\2/p' | sort -u >options
  check "$command has options" [ "$(wc -l <options)" -gt 20 ]
  for what in drum kit; do
    while read -r option; do
      value=$(value_of $what "$option") || { complain "$command has the option --$option, which this test does not know"; continue; }
      arguments=()
      if [ $what = kit ]; then [ "$option" = kit ] || arguments+=(--kit ./kit.ini); else arguments+=(frame-drum); fi
      case $command in
        render) [ "$option" = output ] || arguments+=(-o out.wav) ;;
        play) [ "$option" = backend ] || arguments+=(--backend null) ;;
      esac
      if [ "$option" != quality ] && [ "$option" != replay ]; then arguments+=(--quality draft); fi
      [ "$option" = duration ] || arguments+=(--duration 0.02)
      if [ "$option" != midi-file ] && [ "$option" != replay ]; then arguments+=(--midi-file song.mid); fi
      arguments+=("--$option")
      [ "$value" = - ] || arguments+=("$value")
      tried $command $what "$option" "${arguments[@]}"
    done <options
  done
done
finish
