#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# render --vary: many drums from one, each made again by --set from its row of the table.

. "$(dirname "$0")/../support/host_checks.sh"

count=10
vary=(--quality draft --duration 0.05 --vary batter.pitch=A3..D4 --vary strike.velocity=1..8
  --vary "strike.striker=stick,mallet" --vary batter.lug_count=6..10)
done_quietly render tom-12 "${vary[@]}" --count $count -o one/ -q
same "files" $((count + 1)) "$(find one -type f | wc -l)"
same "the table's columns" "file,batter.pitch,strike.velocity,strike.striker,batter.lug_count" "$(head -n 1 one/variations.csv)"
same "its rows" $count "$(tail -n +2 one/variations.csv | wc -l)"

# A value from each tenth of the range, in equal ratios; half of the words each; all whole numbers.
tail -n +2 one/variations.csv | awk -F, '{ print int(10 * log($3) / log(8)) }' | sort -n | uniq >tenths
same "tenths of the speeds" "$(seq 0 9)" "$(cat tenths)"
same "sticks" 5 "$(grep -c ,stick, one/variations.csv)"
same "lugs" "$(seq 6 10)" "$(tail -n +2 one/variations.csv | cut -d, -f5 | sort -nu)"

# Row by row, --set makes the same bytes.
while IFS=, read -r file pitch velocity striker lugs; do
  done_quietly render tom-12 -q --quality draft --duration 0.05 -o again.wav --set "batter.pitch=$pitch" \
    --set "strike.velocity=$velocity" --set "strike.striker=$striker" --set "batter.lug_count=$lugs"
  check "$file again" cmp again.wav "one/$file"
done < <(tail -n +2 one/variations.csv)

done_quietly render tom-12 "${vary[@]}" --count $count -o same/ -q -j 1
check "the same seed, on one thread" diff -r one same
done_quietly render tom-12 "${vary[@]}" --count $count -o other/ -q --seed 2
check "another seed" bash -c '! cmp -s one/variations.csv other/variations.csv'

# Presets, kits, files of strokes: the same in all.
printf 'time,velocity\n0,2\n' >soft.csv
printf 'time,velocity\n0,6\n' >hard.csv
done_quietly render tom-12 tom-10 -q --quality draft --duration 0.05 --each --events soft.csv --events hard.csv \
  --vary batter.pitch=A3..D4 --count 2 -o each/
same "of two drums, two files and two variations" "tom-10-hard-1.wav tom-10-hard-2.wav tom-10-soft-1.wav tom-10-soft-2.wav tom-12-hard-1.wav tom-12-hard-2.wav tom-12-soft-1.wav tom-12-soft-2.wav variations.csv" \
  "$(cd each && echo *)"
done_quietly render --kit standard -q --quality draft --duration 0.05 --strike drum=snare \
  --vary drum.snare.batter.pitch=A3..D4 --count 2 -o kit/
same "of a kit" "standard-1.wav standard-2.wav variations.csv" "$(cd kit && echo *)"

refused "--vary needs --count" render --vary batter.tension=1000..2000 -o no/
refused "--count needs --vary" render --count 3 -o no/
refused "--count '0': out of range; allowed: 1 to 1000" render --vary batter.tension=1000..2000 --count 0 -o no/
refused "--vary 'batter.tension': not of the form KEY=RANGE" render --vary batter.tension --count 2 -o no/
refused "--vary 'batter.tension=5': a range is LOW..HIGH" render --vary batter.tension=5 --count 2 -o no/
refused "--vary 'batter.tension=2..1': a range is LOW..HIGH" render --vary batter.tension=2..1 --count 2 -o no/
refused "unknown key 'batter.tensoin'" render --vary batter.tensoin=1000..2000 --count 2 -o no/
refused "is outside 100 to 20000 N/m" render --vary batter.tension=1..2 --count 2 -o no/
refused "several sounds need a folder" render --vary batter.tension=1000..2000 --count 2
refused "--replay and --vary" render --replay x.log --vary batter.tension=1000..2000 --count 2 -o no/
check "what is refused leaves nothing" test ! -e no

finish
