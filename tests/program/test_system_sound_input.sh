#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --input: a loudspeaker plays a sound to a drum.
# shellcheck source=tests/support/host_checks.sh
. "$(dirname "$0")/../support/host_checks.sh"
short=(-q --quality draft --format float)
peak() { "$INSPECT" peak "$1"; }

done_quietly render tom-12 "${short[@]}" --duration 0.2 -o tom.wav
done_quietly render tom-12 "${short[@]}" --duration 0.2 --gain -120 -o silence.wav

# ---- a snare drum answers with its wires, which shake the more the louder the sound ----

done_quietly render snare-14x5.5 "${short[@]}" --input tom.wav --mic bottom -o snare.wav
holds "it sounds" "$(peak snare.wav) > 1e-3"
done_quietly render snare-14x5.5 "${short[@]}" --input tom.wav --input-level 2 --mic bottom -o soft.wav
holds "less, if the sound is softer" "$(peak soft.wav) < 0.2 * $(peak snare.wav)"
done_quietly render snare-14x5.5 "${short[@]}" --input tom.wav --input-mic bottom --mic bottom -o below.wav
other_bytes "from below it is another sound" snare.wav below.wav

# A head without wires is linear up to its stretch.
linear=(tom-12 "${short[@]}" --set batter.stretch_stiffness=0 --set resonant.stretch_stiffness=0 --duration 0.3)
done_quietly render "${linear[@]}" --input tom.wav --input-level 10 -o ten.wav
done_quietly render "${linear[@]}" --input tom.wav --input-level 1 -o one.wav
holds "ten times as loud in, ten times out" "($(peak ten.wav) / $(peak one.wav) - 10)^2 < 1e-4"

done_quietly render snare-14x5.5 "${short[@]}" --input silence.wav --duration 0.3 -o nothing.wav
same "silence in, silence out" 0 "$(peak nothing.wav)"

# A stroke that is asked for is played besides.
done_quietly render "${linear[@]}" --strike velocity=1 -o stroke.wav
done_quietly render "${linear[@]}" --strike velocity=1 --input silence.wav -o both.wav
same_bytes "a stroke in silence" stroke.wav both.wav

# ---- louder than any recording ----

"$SYNTHESISE" loud.wav 48000 1 0.3 0 -300 100,540,0
"$SYNTHESISE" louder.wav 48000 1 0.3 0 -300 100,600,0
run render "${linear[@]}" --input loud.wav -o limited.wav
same "a sound of +540 dBFS is played" 0 "$status"
same "its limit is said" "warning: --input 'loud.wav': its peak of +540 dBFS is limited to +40 dBFS" "$(sed 's/^tabor: //' "$err")"
run render "${linear[@]}" --input louder.wav -o louder-limited.wav
same_bytes "a louder one sounds alike" limited.wav louder-limited.wav
holds "as what the limit sounds like" "$(peak limited.wav) > 1 && $(peak limited.wav) < 1e5"

# ---- refused ----

refused "--input-level and --input-mic need --input" render tom-12 --input-level 2
refused "no such microphone.*'top'" render tom-12 --input tom.wav --input-mic tpo
refused "--input-level" render tom-12 --input tom.wav --input-level 0
refused "48000 Hz.*44100 Hz.*--rate 48000" render tom-12 --input tom.wav --rate 44100
refused "would overwrite the sound" render tom-12 --input tom.wav -o tom.wav
refused "--kit and --input" render --kit standard --midi-file song.mid --input tom.wav
failed "cannot read 'none.wav'" render tom-12 --input none.wav

finish
