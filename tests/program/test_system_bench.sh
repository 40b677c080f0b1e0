#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tabor bench: its workload and its figures.

. "$(dirname "$0")/../support/host_checks.sh"

few=(--set quality.two_way_bandwidth=1000) # modes
quick=(--quality draft --repeat 1 "${few[@]}")

done_quietly bench frame-drum "${quick[@]}" --json
same "keys" "preset rate block quality real_time_factor idle_factor block_time_us modes contacts" \
  "$(json keys)"
same "keys of the block time" "median p99 max" "$(json block_time_us.keys)"
same "keys of the contacts" "points mean max" "$(json contacts.keys)"
same "facts" "frame-drum 48000 64 draft" \
  "$(json preset) $(json rate) $(json block) $(json quality)"
same "no wires, no points" 0 "$(json contacts.points)"
holds "only the striker touches" "$(json contacts.mean) <= 1 && $(json contacts.max) == 1"
holds "real time" "$(json real_time_factor) > 0"
holds "asleep it takes next to nothing" "$(json idle_factor) > 0 && $(json idle_factor) < 0.01"
holds "block times" "$(json block_time_us.median) > 0 && \
  $(json block_time_us.median) <= $(json block_time_us.p99) && \
  $(json block_time_us.p99) <= $(json block_time_us.max)"
# the mean block takes this long, so that the median cannot be more than twice as long
holds "they belong to it" \
  "$(json block_time_us.median) < 2 * $(json real_time_factor) * 64 / 48000 * 1e6"
modes=$(json modes)
done_quietly modes frame-drum --quality draft "${few[@]}" --json
holds "modes, copies apart" "$modes >= $(json modes.size) && $modes <= 2 * $(json modes.size)"

done_quietly bench tabor "${quick[@]}" --json
holds "its string touches" "$(json contacts.points) > 10 && $(json contacts.mean) > 0 && \
  $(json contacts.max) >= $(json contacts.mean) && \
  $(json contacts.max) <= $(json contacts.points) + 8" # and strikers do
facts="$(json contacts.mean) $(json contacts.max)"
done_quietly bench tabor "${few[@]}" --quality draft --repeat 3 --json --block 1000
same "contacts depend neither on blocks nor repeats" "$facts" \
  "$(json contacts.mean) $(json contacts.max)"
same "the block" 1000 "$(json block)"
done_quietly bench "${quick[@]}" --rate 44100 --json --set wires.count=0
same "rate and --set" "44100 0" "$(json rate) $(json contacts.points)"
same "the default preset" snare-14x5.5 "$(json preset)"
done_quietly bench frame-drum "${few[@]}" --set quality.level=draft --repeat 1 --json
same "the quality that --set says" draft "$(json quality)"
done_quietly bench frame-drum "${few[@]}" --repeat 1 --json
same "the default quality" live "$(json quality)"
done_quietly bench frame-drum --quality live --repeat 1
check "a table" grep -qE '^real-time factor +[0-9.]+$' "$out"
check "and idle" grep -qE '^idle factor +0\.[0-9]+$' "$out"
check "with the quality" grep -qE '^quality +live$' "$out"
for instructions in auto baseline; do
  done_quietly bench frame-drum "${quick[@]}" --json --instructions $instructions
  same "facts with --instructions $instructions" "frame-drum draft" "$(json preset) $(json quality)"
done
for instructions in avx2 avx512; do # what the processor lacks is refused, not replaced
  run bench frame-drum "${quick[@]}" --instructions $instructions
  if [ "$status" != 0 ]; then expect_error 2 "--instructions '$instructions': this processor"; fi
done
done_quietly show frame-drum
cp "$out" drum.ini
done_quietly bench ./drum.ini "${quick[@]}"
check "a file" grep -qE '^preset +./drum.ini$' "$out"

for block in 0 8193 1.5 -1 nan; do
  refused "--block '$block'.*allowed: 1 to 8192" bench --block $block
done
for repeat in 0 1001 1.5 x; do
  refused "--repeat '$repeat'.*allowed: 1 to 1000" bench --repeat $repeat
done
refused "--rate '1'" bench --rate 1
refused "--quality 'liev'.*did you mean 'live'" bench --quality liev
refused "--instructions 'avx3'.*allowed: auto, baseline, avx2, avx512.*did you mean 'avx2'" \
  bench --instructions avx3
refused "unknown option '--output'" bench --output x.wav
failed "missing.ini" bench missing.ini
for data in "bench frame-drum ${quick[*]}" "bench frame-drum ${quick[*]} --json"; do
  # shellcheck disable=SC2086
  "$TABOR" $data >/dev/full 2>"$err"
  status=$?
  : >"$out"
  expect_error 1 "standard output: No space left"
done

finish
