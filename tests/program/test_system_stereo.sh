#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Rooms, and render --stereo: the pair of microphones in a room.

. "$(dirname "$0")/../support/host_checks.sh"

short=(tom-12 -q --quality draft --duration 0.3)
seconds() { awk "BEGIN { printf \"%.2f\", $(json frames) / 48000 }"; }

# ---- the pair ----

done_quietly render "${short[@]}" --stereo -o stereo.wav
done_quietly render "${short[@]}" --mic left --mic right --set room.kind=studio --gain 12 -o same.wav
same_bytes "the pair in a studio, 12 dB louder" stereo.wav same.wav
done_quietly render "${short[@]}" --stereo --set room.kind=hall -o hall.wav
other_bytes "another room" hall.wav stereo.wav
done_quietly render "${short[@]}" --stereo --set room.level=0 -o dry.wav
done_quietly render "${short[@]}" --mic left --mic right --gain 12 -o free.wav
same_bytes "a room of level 0 is free air" dry.wav free.wav
done_quietly render "${short[@]}" --stereo --set room.kind=none -o asked.wav
same_bytes "so is none, where it is asked for" asked.wav free.wav
done_quietly render "${short[@]}" --stereo --gain 3 -o gain.wav
done_quietly render "${short[@]}" --stereo --set room.kind=studio --gain 3 -o gain-2.wav
same_bytes "a gain on top" gain.wav gain-2.wav
other_bytes "it counts" gain.wav stereo.wav
done_quietly render "${short[@]}" --stereo --split -o take.wav
same "a file for each side" "take-left.wav take-right.wav" "$(echo take-*)"

# Loud enough to be used as it is, and never too loud; 4.5 m/s is the default stroke.
for preset in $("$TABOR" presets | awk '{ print $1 }'); do
  done_quietly render "$preset" -q --quality draft --duration 0.3 --stereo --json -o level.wav
  check "the level of $preset: $(json peak)" awk "BEGIN { exit !($(json peak) > 0.03 && $(json peak) < 1) }"
done

# ---- while playing ----

done_quietly play "${short[@]}" --backend file --humanize 0 --stereo --set room.kind=hall --record played.wav
same_bytes "play has the room of render" hall.wav played.wav
done_quietly render tom-12 -q --quality draft --stereo -o whole.wav
done_quietly play tom-12 -q --quality draft --backend file --humanize 0 --stereo --record whole-played.wav
same_bytes "and ends with it" whole.wav whole-played.wav

# ---- other microphones ----

done_quietly render "${short[@]}" --set room.kind=none -o none.wav
done_quietly render "${short[@]}" -o plain.wav
same_bytes "no room changes no bit" none.wav plain.wav
done_quietly render "${short[@]}" --set room.kind=studio -o close.wav
other_bytes "one room for all microphones" close.wav plain.wav
done_quietly render "${short[@]}" --mic top --mic left --mic right --set room.kind=studio --split -o with.wav
same_bytes "whoever else is heard" close.wav with-top.wav
done_quietly render "${short[@]}" --set room.kind=studio --trace rows.csv -o traced.wav
same_bytes "frame by frame" close.wav traced.wav

# ---- its end ----

# length ROOM: of a stroke that ends by itself.
length() {
  done_quietly render tom-12 --quality draft --json --set "room.kind=$1" --set room.decay="$2" -o end.wav
  seconds
}
free=$(length none 0)
dead=$(length booth 0.1)
hall=$(length hall 8)
check "a dead room ends with its drum: $dead, $free s" awk "BEGIN { exit !($dead < $free + 0.2) }"
check "the sound ends with the room: $hall, $free s" awk "BEGIN { exit !($hall > 9 && $hall < 16) }"

# ---- what is wrong ----

refused "--stereo and --mic" render "${short[@]}" --stereo --mic top
refused "--stereo and --mic" play tom-12 --backend file --record played.wav --stereo --mic top
refused "room.kind" render "${short[@]}" --set room.kind=cave
refused "room.decay = 50 is neither 0 nor in 0.05 to 20 s" render "${short[@]}" --set room.decay=50
printf '[striker.stick]\n[mic.top]\n' >bare.ini
refused "--stereo: the drum lacks a microphone left or right" render bare.ini --stereo

finish
